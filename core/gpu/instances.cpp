#include "gpu/instances.hpp"
#include <algorithm>
#include <cmath>

namespace evil::gpu {

std::uint32_t held(const Context& context, std::uint32_t texture) {
    const std::vector<bool>& all = context.pictures.held;
    return texture < all.size() && all[texture] ? texture : draw::kNoTexture;
}

namespace {

// Beyond this a float no longer holds a position to 1/256 pixel: edges are then cut to the picture in double.
constexpr double kFar = 32768.0;
constexpr double kNowhere = 1e15; // pixels; beyond, not even a double knows where in a pixel it is
// Edges of a mesh that every pixel of its quad may go through, whatever their number ...
constexpr std::uint32_t kFewEdges = 16;
// ... and how often an edge may be gone through for one thing, before its quad is divided into cells with few edges each.
constexpr double kMostLooks = 1 << 19;
constexpr int kCell = 32;      // pixels
constexpr double kRound = 3.0; // pixels: the shader bends a circle's edge to second order, well enough down to here
constexpr double kSagitta = 1.0 / 32; // pixels between arc and chord, as in raster/outline.cpp

struct Extent { // in pixels
    double left, top, right, bottom;
};

bool is_empty(const Bounds& box) { return box.left >= box.right || box.top >= box.bottom; }

// The whole pixels that the box touches within the target; empty if there are none or it is nowhere.
Bounds touched(const Extent& box, const Bounds& target) {
    if (!(box.left < target.right && box.right > target.left && box.top < target.bottom && box.bottom > target.top))
        return {};
    return {static_cast<int>(std::floor(std::max<double>(box.left, target.left))),
            static_cast<int>(std::floor(std::max<double>(box.top, target.top))),
            static_cast<int>(std::ceil(std::min<double>(box.right, target.right))),
            static_cast<int>(std::ceil(std::min<double>(box.bottom, target.bottom)))};
}

Extent extent_of(const Affine& m, const Rect& rect) {
    const double x = 0.5 * (double{rect.left} + rect.right), y = 0.5 * (double{rect.low} + rect.high);
    const double w = 0.5 * (double{rect.right} - rect.left), h = 0.5 * (double{rect.high} - rect.low);
    const double cx = double{m.a} * x + double{m.c} * y + double{m.tx};
    const double cy = double{m.b} * x + double{m.d} * y + double{m.ty};
    const double rx = std::fabs(double{m.a}) * w + std::fabs(double{m.c}) * h;
    const double ry = std::fabs(double{m.b}) * w + std::fabs(double{m.d}) * h;
    return {cx - rx, cy - ry, cx + rx, cy + ry};
}

bool is_far(const Extent& box) { return !(std::max({-box.left, -box.top, box.right, box.bottom}) < kFar); }

double turn_of(const Affine& m) { return double{m.a} * m.d - double{m.b} * m.c; }

// How far the matrix stretches the two directions that it keeps at right angles: its singular values.
struct Stretch {
    double most, least;
};
Stretch stretch_of(const Affine& m) {
    const double sum = 0.5 * std::hypot(double{m.a} + m.d, double{m.b} - m.c);
    const double difference = 0.5 * std::hypot(double{m.a} - m.d, double{m.b} + m.c);
    return {sum + difference, std::fabs(sum - difference)};
}

// ---- what a quad is painted with ----

bool goes_beyond(const Quad& quad, double u, double v) { // a picture's edge, seen from a corner's own coordinates
    const double x = quad.ux * u + quad.uy * v + quad.uc, y = quad.vx * u + quad.vy * v + quad.vc;
    return !(x > -0.001 && x < 1.001 && y > -0.001 && y < 1.001);
}

bool repeats(const Context& context, const draw::Mesh& mesh, const Affine& to_texture) {
    Quad coordinates;
    coordinates.ux = to_texture.a, coordinates.uy = to_texture.c, coordinates.uc = to_texture.tx;
    coordinates.vx = to_texture.b, coordinates.vy = to_texture.d, coordinates.vc = to_texture.ty;
    if (mesh.kind == draw::MeshKind::circle) {
        const double x = 0.5 * std::hypot(to_texture.a, to_texture.c), y = 0.5 * std::hypot(to_texture.b, to_texture.d);
        const Vec2 middle = apply(to_texture, {0.5f, 0.5f});
        coordinates = {};
        coordinates.ux = coordinates.vy = 1.0f;
        return goes_beyond(coordinates, middle.x - x, middle.y - y) ||
               goes_beyond(coordinates, middle.x + x, middle.y + y);
    }
    for (std::uint32_t i = 0; i < mesh.vertex_count; ++i) {
        const Vec2 uv = context.list.vertices[mesh.first_vertex + i].uv;
        if (goes_beyond(coordinates, uv.x, uv.y)) return true;
    }
    return false;
}

// What all quads of an instance share.
struct Look {
    Quad quad;
    std::uint32_t flags = 0, facets = 0;
    std::uint32_t texture = draw::kNoTexture, normals = draw::kNoTexture, glows = draw::kNoTexture;
    draw::Blend blend = draw::Blend::over; // as in Batch
};

// With facets the shader finds the mesh's texture coordinates itself.
Look look_of(const Context& context, const draw::Instance& instance, const Shape& shape) {
    const draw::Mesh& mesh = context.list.meshes[instance.mesh];
    const Affine &m = instance.to_pixel, &t = instance.to_texture;
    Look look;
    Quad& quad = look.quad;
    quad.a = m.a, quad.b = m.b, quad.c = m.c, quad.d = m.d, quad.tx = m.tx, quad.ty = m.ty;
    quad.tint = instance.tint;
    quad.first_facet = shape.first_facet;
    look.facets = shape.facets;
    if (mesh.coloured_corners && shape.facets > 0) look.flags |= kColoured;
    if (instance.lit && context.list.light.on) look.flags |= kLit;
    if (instance.blend == draw::Blend::add)
        look.flags |= kAdds;
    else
        look.blend = instance.blend;
    quad.surface = static_cast<std::uint32_t>(std::lround(instance.glow * kGlowSteps)) << 8;
    look.texture = held(context, instance.texture);
    if (instance.lit && context.list.light.directed) look.normals = held(context, instance.normals);
    if (instance.glow > 0.0f) look.glows = held(context, instance.glows);
    if (look.texture != draw::kNoTexture) look.flags |= kTextured;
    if (look.texture == draw::kNoTexture && look.normals == draw::kNoTexture && look.glows == draw::kNoTexture)
        return look;
    if (repeats(context, mesh, t)) look.flags |= kRepeat;
    if (mesh.inside > 0) look.flags |= kFine;
    if (shape.facets > 0) {
        quad.ux = t.a, quad.uy = t.c, quad.uc = t.tx, quad.vx = t.b, quad.vy = t.d, quad.vc = t.ty;
        return look;
    }
    auto mix = [&](float x, float y, float at, float& px, float& py, float& p) {
        px = static_cast<float>(x * shape.u.dx + y * shape.v.dx);
        py = static_cast<float>(x * shape.u.dy + y * shape.v.dy);
        p = static_cast<float>(x * shape.u.at + y * shape.v.at + at);
    };
    mix(t.a, t.c, t.tx, quad.ux, quad.uy, quad.uc);
    mix(t.b, t.d, t.ty, quad.vx, quad.vy, quad.vc);
    return look;
}

// ---- quads and runs of them ----

Batch& begin_batch(Frame& frame, draw::Blend blend) {
    Batch next;
    next.first = static_cast<std::uint32_t>(frame.quads.size());
    next.blend = blend;
    return frame.batches.emplace_back(next);
}

// The unit of the texture in a batch, which takes it up; kUnits if it has no room for it.
std::uint32_t unit_of(Batch& batch, std::uint32_t texture) {
    const auto used = batch.textures.begin() + batch.units;
    const auto found = std::find(batch.textures.begin(), used, texture);
    if (found != used) return static_cast<std::uint32_t>(found - batch.textures.begin());
    if (batch.units == kUnits) return kUnits;
    batch.textures[batch.units] = texture;
    return batch.units++;
}

// Whether a batch has room for all pictures of a look; then the quad knows their units.
bool take_up(Batch& batch, const Look& look, Quad& quad) {
    constexpr std::uint32_t kNo = draw::kNoTexture;
    const std::uint32_t unit = look.texture == kNo ? 0 : unit_of(batch, look.texture);
    const std::uint32_t normals = look.normals == kNo ? 0 : 1 + unit_of(batch, look.normals);
    const std::uint32_t glows = look.glows == kNo ? 0 : 1 + unit_of(batch, look.glows);
    quad.how |= unit << 12;
    quad.surface |= normals | glows << 4;
    return unit < kUnits && normals <= kUnits && glows <= kUnits;
}

void put(Context& context, const Look& look, Cover cover) {
    Frame& frame = context.frame;
    Quad quad = look.quad;
    quad.how = to_how(cover, look.flags, look.facets);
    const Batch* last = frame.batches.empty() ? nullptr : &frame.batches.back();
    if (!last || last->interlude || last->sprites || last->blend != look.blend) begin_batch(frame, look.blend);
    Quad placed = quad;
    if (!take_up(frame.batches.back(), look, placed)) {
        placed = quad;
        take_up(begin_batch(frame, look.blend), look, placed);
    }
    frame.quads.push_back(placed);
    Batch& batch = frame.batches.back();
    ++batch.count;
    batch.facets |= look.facets > 0;
    batch.surfaces |= placed.surface != 0;
}

void set_pixel_box(Look& look, const Bounds& box) {
    look.quad.box = {static_cast<float>(box.left), static_cast<float>(box.top), static_cast<float>(box.right),
                     static_cast<float>(box.bottom)};
    look.flags |= kPixelBox;
}

void put_pixels(Context& context, Look look, const Bounds& box, std::span<const Edge> edges) {
    set_pixel_box(look, box);
    if (covers(edges, box)) return put(context, look, Cover::all);
    Frame& frame = context.frame;
    look.quad.first_edge = static_cast<std::uint32_t>(context.shapes.texels.size() + frame.edges.size());
    look.quad.edges = static_cast<std::uint32_t>(edges.size());
    for (const Edge& e : edges)
        frame.edges.push_back(
            {static_cast<float>(e.x0), static_cast<float>(e.y0), static_cast<float>(e.x1), static_cast<float>(e.y1)});
    put(context, look, Cover::pixel_edges);
}

// Cells of the picture, each with the edges that matter to it. Whole cells beside each other become one quad.
void put_cells(Context& context, const Look& look, const Bounds& box) {
    Scratch& scratch = context.scratch;
    for (int top = box.top; top < box.bottom; top += kCell) {
        const Bounds row{box.left, top, box.right, std::min(top + kCell, box.bottom)};
        cut(scratch.visible, row, scratch.row, scratch.cut);
        int whole_from = box.left;
        auto put_whole = [&](int to) {
            const double x = whole_from;
            const Edge left_side{x, static_cast<double>(row.top), x, static_cast<double>(row.bottom)};
            if (whole_from < to) put_pixels(context, look, {whole_from, row.top, to, row.bottom}, {&left_side, 1});
        };
        for (int left = box.left; left < box.right; left += kCell) {
            const Bounds cell{left, row.top, std::min(left + kCell, box.right), row.bottom};
            cut(scratch.row, cell, scratch.cell, scratch.cut);
            if (covers(scratch.cell, cell)) continue;
            put_whole(left);
            whole_from = cell.right;
            if (!scratch.cell.empty()) put_pixels(context, look, cell, scratch.cell);
        }
        put_whole(box.right);
    }
}

// ---- ways to draw an instance ----

// By loops in pixels: strokes, and fills that are too large or too intricate for the other ways.
void put_loops(Context& context, const Look& look) {
    Scratch& scratch = context.scratch;
    Extent box{1e300, 1e300, -1e300, -1e300};
    std::size_t first = 0;
    scratch.edges.clear();
    for (const std::size_t end : scratch.loops.ends) {
        for (std::size_t i = first; i < end; ++i) {
            const raster::Point a = scratch.loops.points[i], b = scratch.loops.points[i + 1 == end ? first : i + 1];
            if (!(std::fabs(a.x) < kNowhere && std::fabs(a.y) < kNowhere)) return;
            box = {std::min(box.left, a.x), std::min(box.top, a.y), std::max(box.right, a.x),
                   std::max(box.bottom, a.y)};
            scratch.edges.push_back({a.x, a.y, b.x, b.y});
        }
        first = end;
    }
    const Bounds seen = touched(box, context.target);
    if (is_empty(seen)) return;
    cut(scratch.edges, seen, scratch.visible, scratch.cut);
    const std::size_t count = scratch.visible.size();
    if (count == 0) return;
    const double looks = static_cast<double>(count) * (seen.right - seen.left) * (seen.bottom - seen.top);
    if (count <= kFewEdges || looks <= kMostLooks)
        put_pixels(context, look, seen, scratch.visible);
    else
        put_cells(context, look, seen);
}

void put_outline(Context& context, const Look& look, const draw::Instance& instance) {
    const draw::Mesh& mesh = context.list.meshes[instance.mesh];
    raster::clear(context.scratch.loops);
    raster::add_mesh(context.scratch.loops, context.list, mesh, instance.to_pixel, instance.outline);
    put_loops(context, look);
}

void put_polygon(Context& context, Look look, const draw::Instance& instance, const Shape& shape) {
    const Affine& m = instance.to_pixel;
    const Extent box = extent_of(m, shape.bounds);
    const Bounds seen = touched(box, context.target);
    if (is_empty(seen)) return;
    const double looks = static_cast<double>(shape.edges) * (seen.right - seen.left) * (seen.bottom - seen.top);
    if (is_far(box) || (shape.edges > kFewEdges && looks > kMostLooks)) return put_outline(context, look, instance);
    Quad& quad = look.quad;
    quad.first_edge = shape.first_edge;
    quad.edges = shape.edges;
    quad.inner = shape.inner;
    quad.box = shape.bounds;
    // The quad follows the mesh unless its sides are too short or too nearly parallel to be moved out by a pixel.
    const double x = std::hypot(m.a, m.b), y = std::hypot(m.c, m.d), area = std::fabs(turn_of(m));
    if (!(area > 0.25 * x * y) || !(x > 1e-6 && y > 1e-6)) {
        set_pixel_box(look, seen);
        quad.inner = {};
    }
    put(context, look, Cover::edges);
}

// A polygon's stroke, as long as it is two plain loops for each of its rings. The shader knows that far inside there is nothing of it.
void put_stroke(Context& context, Look look, const draw::Instance& instance, const Shape& shape) {
    const draw::Mesh& mesh = context.list.meshes[instance.mesh];
    const Affine& m = instance.to_pixel;
    Scratch& scratch = context.scratch;
    raster::clear(scratch.loops);
    const double half = 0.5 * instance.outline;
    bool plain = true;
    draw::each_ring(context.list, mesh, [&](std::span<const draw::Vertex> ring) {
        scratch.path.clear();
        for (const auto& [at, uv, colour] : ring)
            scratch.path.push_back({double{m.a} * at.x + double{m.c} * at.y + double{m.tx},
                                    double{m.b} * at.x + double{m.d} * at.y + double{m.ty}});
        plain = plain && add_plain_stroke(scratch.loops, scratch.path, half, scratch.other);
    });
    if (!plain) return put_outline(context, look, instance);
    if (const double area = std::fabs(turn_of(m)); area > 0) {
        const double x = half * (std::fabs(m.d) + std::fabs(m.c)) / area;
        const double y = half * (std::fabs(m.b) + std::fabs(m.a)) / area;
        look.quad.inner = {static_cast<float>(shape.inner.left + x), static_cast<float>(shape.inner.low + y),
                           static_cast<float>(shape.inner.right - x), static_cast<float>(shape.inner.high - y)};
        look.flags |= kHollow;
    }
    put_loops(context, look);
}

// The polygon that stands for a circle of that many pixels' radius; null if none has enough edges.
const Circle* circle_for(const Shapes& shapes, double radius) {
    const double wanted = kPi * std::sqrt(radius / (2.0 * kSagitta));
    for (const Circle& circle : shapes.circles)
        if (circle.edges >= wanted) return &circle;
    return nullptr;
}

draw::Rgba8 multiplied(draw::Rgba8 a, draw::Rgba8 b) {
    draw::Rgba8 result = 0;
    for (int shift = 0; shift < 32; shift += 8)
        result |= ((a >> shift & 255u) * (b >> shift & 255u) + 127u) / 255u << shift;
    return result;
}

// A circle becomes the unit circle: its centre and radius go into the matrix.
void put_circle(Context& context, Look look, const draw::Instance& instance, const Shape& shape) {
    const draw::Mesh& mesh = context.list.meshes[instance.mesh];
    const draw::Vertex& centre = context.list.vertices[mesh.first_vertex];
    const Affine m = compose(instance.to_pixel, {mesh.radius, 0, 0, mesh.radius, centre.at.x, centre.at.y});
    Quad& quad = look.quad;
    quad.a = m.a, quad.b = m.b, quad.c = m.c, quad.d = m.d, quad.tx = m.tx, quad.ty = m.ty;
    quad.tint = multiplied(quad.tint, centre.colour);
    quad.box = shape.bounds;
    const Stretch stretch = stretch_of(m);
    const double half = 0.5 * std::max(instance.outline, 0.0f), reach = stretch.most + half;
    const Extent box{m.tx - reach, m.ty - reach, m.tx + reach, m.ty + reach};
    const Bounds seen = touched(box, context.target);
    if (is_empty(seen)) return;
    if (is_far(box)) return put_outline(context, look, instance);
    if (half > 0) {
        const bool even = stretch.most - stretch.least <= 1e-5 * stretch.most;
        const double hole = stretch.most - half;
        if (!even || !(reach >= kRound) || (hole > 0 && hole < kRound)) return put_outline(context, look, instance);
        quad.inner.left = static_cast<float>(half);
        return put(context, look, Cover::ring);
    }
    const double roundness = stretch.least * stretch.least / stretch.most; // the smallest radius of the ellipse's curve
    if (roundness >= kRound) return put(context, look, Cover::disc);
    const Circle* polygon = circle_for(context.shapes, stretch.most);
    if (!polygon) return put_outline(context, look, instance);
    quad.first_edge = polygon->first_edge;
    quad.edges = polygon->edges;
    set_pixel_box(look, seen);
    put(context, look, Cover::edges);
}

} // namespace

void put_instance(Context& context, const draw::Instance& instance) {
    if (instance.mesh >= context.list.meshes.size()) return;
    const Shape& shape = context.shapes.shapes[instance.mesh];
    if (shape.edges == 0 || instance.tint >> 24 == 0 || std::isnan(instance.outline)) return;
    const Look look = look_of(context, instance, shape);
    if (context.list.meshes[instance.mesh].kind == draw::MeshKind::circle)
        put_circle(context, look, instance, shape);
    else if (instance.outline > 0.0f)
        put_stroke(context, look, instance, shape);
    else
        put_polygon(context, look, instance, shape);
}

} // namespace evil::gpu
