#include "raster/paint.hpp"
#include <algorithm>
#include <cmath>

namespace evil::raster {
namespace {

using Corner = PaintCorner;

// Straight colours a and b multiplied: r, g, b, a in 0..255 times alpha.
void multiply_colours(draw::Rgba8 a, draw::Rgba8 b, double channel[4]) {
    const double alpha = static_cast<double>(a >> 24) * static_cast<double>(b >> 24) / (255.0 * 255.0);
    for (int c = 0; c < 3; ++c)
        channel[c] =
            static_cast<double>(a >> (8 * c) & 255u) * static_cast<double>(b >> (8 * c) & 255u) / 255.0 * alpha;
    channel[3] = 255.0 * alpha;
}

Pixel to_pixel(const double channel[4]) {
    Pixel pixel = 0;
    for (int c = 0; c < 4; ++c) pixel |= static_cast<Pixel>(channel[c] + 0.5) << (8 * c);
    return pixel;
}

Corner corner_at(const draw::Instance& instance, Vec2 at, Vec2 uv, draw::Rgba8 colour) {
    const Affine &m = instance.to_pixel, &t = instance.to_texture;
    Corner corner{double{m.a} * at.x + double{m.c} * at.y + double{m.tx},
                  double{m.b} * at.x + double{m.d} * at.y + double{m.ty},
                  double{t.a} * uv.x + double{t.c} * uv.y + double{t.tx},
                  double{t.b} * uv.x + double{t.d} * uv.y + double{t.ty},
                  {}};
    multiply_colours(colour, instance.tint, corner.channel);
    return corner;
}

double doubled_area(const Corner& a, const Corner& b, const Corner& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double value(const Plane& plane, double x, double y) { return plane.at + plane.dx * x + plane.dy * y; }

// A piece from a triangle, or nothing if the triangle is too thin to tell directions apart.
bool make_piece(Piece& piece, const Corner& a, const Corner& b, const Corner& c) {
    const double area = doubled_area(a, b, c);
    if (!(std::fabs(area) > 1e-9) || !(std::fabs(area) < 1e30)) return false;
    const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y;
    auto plane = [&](double at_a, double at_b, double at_c) {
        const double fb = at_b - at_a, fc = at_c - at_a;
        const double dx = (fb * cy - fc * by) / area, dy = (fc * bx - fb * cx) / area;
        return Plane{at_a - dx * a.x - dy * a.y, dx, dy};
    };
    const Corner* corners[3] = {&a, &b, &c};
    for (int i = 0; i < 3; ++i) piece.x[i] = corners[i]->x, piece.y[i] = corners[i]->y;
    piece.u = plane(a.u, b.u, c.u);
    piece.v = plane(a.v, b.v, c.v);
    for (int i = 0; i < 4; ++i) {
        piece.channel[i] = plane(a.channel[i], b.channel[i], c.channel[i]);
        piece.least[i] = std::min({a.channel[i], b.channel[i], c.channel[i]});
        piece.most[i] = std::max({a.channel[i], b.channel[i], c.channel[i]});
    }
    return true;
}

// Whether the piece's planes give every corner what it carries: then they serve for the whole mesh.
bool fits(const Piece& piece, std::span<const Corner> corners) {
    for (const Corner& corner : corners) {
        if (std::fabs(value(piece.u, corner.x, corner.y) - corner.u) > 1e-4) return false;
        if (std::fabs(value(piece.v, corner.x, corner.y) - corner.v) > 1e-4) return false;
        for (int i = 0; i < 4; ++i)
            if (std::fabs(value(piece.channel[i], corner.x, corner.y) - corner.channel[i]) > 0.5) return false;
    }
    return true;
}

// The smaller copy whose texels are about as large as pixels, so that none is left out; `fine`: as large as they are the
// way they are squeezed less.
const Picture* level_for(const Texture& texture, const Piece& piece, bool fine) {
    const double w = texture.levels[0].width, h = texture.levels[0].height;
    const double across = (piece.u.dx * w) * (piece.u.dx * w) + (piece.v.dx * h) * (piece.v.dx * h);
    const double down = (piece.u.dy * w) * (piece.u.dy * w) + (piece.v.dy * h) * (piece.v.dy * h);
    double texels_squared = fine ? std::min(across, down) : std::max(across, down); // in one pixel
    std::size_t level = 0;
    while (texels_squared > 1.5 * 1.5 && level + 1 < texture.levels.size()) texels_squared *= 0.25, ++level;
    return &texture.levels[level];
}

bool is_any(const Pictures& pictures) { return pictures.colours || pictures.normals || pictures.glows; }

void pick_levels(Piece& piece, const Pictures& pictures, bool fine) {
    if (pictures.colours) piece.picture = level_for(*pictures.colours, piece, fine);
    if (pictures.normals) piece.normals = level_for(*pictures.normals, piece, fine);
    if (pictures.glows) piece.glows = level_for(*pictures.glows, piece, fine);
}

bool outside_picture(double u, double v) { return !(u > -0.001 && u < 1.001 && v > -0.001 && v < 1.001); }

void use_first_corner(Paint& paint, const Corner& corner, const Pictures& pictures) { // nothing to interpolate over
    Piece piece;
    piece.u.at = corner.u, piece.v.at = corner.v;
    for (int i = 0; i < 4; ++i) piece.channel[i].at = piece.least[i] = piece.most[i] = corner.channel[i];
    pick_levels(piece, pictures, false);
    paint.pieces.push_back(piece);
}

void prepare_circle(Paint& paint, const draw::Vertex& centre, const draw::Mesh& mesh, const draw::Instance& instance,
                    const Pictures& pictures) {
    const float r = mesh.radius;
    auto corner = [&](float x, float y) {
        return corner_at(instance, {centre.at.x + x * r, centre.at.y + y * r}, {0.5f + 0.5f * x, 0.5f - 0.5f * y},
                         centre.colour);
    };
    const Corner a = corner(0, 0), b = corner(1, 0), c = corner(0, 1);
    paint.flat = to_pixel(a.channel);
    paint.coloured = false;
    if (!is_any(pictures)) return;
    auto reach = [](double p, double q) { return std::sqrt(p * p + q * q); };
    const double du = reach(b.u - a.u, c.u - a.u), dv = reach(b.v - a.v, c.v - a.v);
    paint.repeat = outside_picture(a.u - du, a.v - dv) || outside_picture(a.u + du, a.v + dv);
    Piece piece;
    if (!make_piece(piece, a, b, c)) return use_first_corner(paint, a, pictures);
    pick_levels(piece, pictures, false);
    paint.pieces.push_back(piece);
}

// The triangle of the mesh with the largest area: its planes are the most exact.
bool largest_piece(Piece& piece, std::span<const Corner> corners, std::span<const std::uint32_t> triangles) {
    double largest = 0;
    bool found = false;
    auto offer = [&](const Corner& a, const Corner& b, const Corner& c) {
        const double area = std::fabs(doubled_area(a, b, c));
        if (area > largest && make_piece(piece, a, b, c)) largest = area, found = true;
    };
    for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
        offer(corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]);
    if (triangles.empty())
        for (std::size_t i = 1; i + 1 < corners.size(); ++i) offer(corners[0], corners[i], corners[i + 1]);
    return found;
}

void prepare_polygon(Paint& paint, std::span<const draw::Vertex> vertices, std::span<const std::uint32_t> triangles,
                     const draw::Instance& instance, const Pictures& pictures, bool sliced) {
    std::vector<Corner>& corners = paint.corners;
    corners.clear();
    for (const draw::Vertex& vertex : vertices)
        corners.push_back(corner_at(instance, vertex.at, vertex.uv, vertex.colour));
    if (is_any(pictures))
        paint.repeat = std::ranges::any_of(corners, [](const Corner& c) { return outside_picture(c.u, c.v); });
    Piece piece;
    if (!largest_piece(piece, corners, triangles)) return use_first_corner(paint, corners[0], pictures);
    if (fits(piece, corners)) {
        for (const Corner& corner : corners)
            for (int i = 0; i < 4; ++i) {
                piece.least[i] = std::min(piece.least[i], corner.channel[i]);
                piece.most[i] = std::max(piece.most[i], corner.channel[i]);
            }
        paint.pieces.push_back(piece);
    } else {
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3)
            if (make_piece(piece, corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]))
                paint.pieces.push_back(piece);
        if (paint.pieces.empty()) paint.pieces.push_back(piece);
    }
    for (Piece& each : paint.pieces) pick_levels(each, pictures, sliced);
}

// Where the piece lies in the row whose middle is y: the stretch of its inside there. A triangle that only reaches into the
// row without crossing its middle counts from its nearest height.
bool stretch_in_row(const Piece& piece, double y, double& first, double& last) {
    const double top = std::min({piece.y[0], piece.y[1], piece.y[2]});
    const double bottom = std::max({piece.y[0], piece.y[1], piece.y[2]});
    if (bottom < y - 0.5 || top > y + 0.5) return false;
    y = std::clamp(y, top, bottom);
    first = 1e300, last = -1e300;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const double y0 = piece.y[i], y1 = piece.y[j];
        if ((y0 < y && y1 < y) || (y0 > y && y1 > y)) continue;
        const double t = y0 == y1 ? 0.0 : (y - y0) / (y1 - y0);
        const double x = piece.x[i] + t * (piece.x[j] - piece.x[i]);
        const double other = y0 == y1 ? piece.x[j] : x;
        first = std::min({first, x, other}), last = std::max({last, x, other});
    }
    return first <= last;
}

bool crosses(const Piece& piece, double y) {
    return std::min({piece.y[0], piece.y[1], piece.y[2]}) <= y && y <= std::max({piece.y[0], piece.y[1], piece.y[2]});
}

// Which piece colours which pixels of the row: each its own stretch, and the gaps between are shared by the neighbours.
// One that only reaches into the row colours what no other does.
void find_runs(Paint& paint, int y) {
    const double middle = y + 0.5;
    paint.runs.clear();
    for (const Piece& piece : paint.pieces) {
        Paint::Run run{0, 0, &piece};
        if (crosses(piece, middle) && stretch_in_row(piece, middle, run.first, run.last)) paint.runs.push_back(run);
    }
    const std::size_t crossing = paint.runs.size();
    for (const Piece& piece : paint.pieces) {
        Paint::Run run{0, 0, &piece};
        if (crosses(piece, middle) || !stretch_in_row(piece, middle, run.first, run.last)) continue;
        const double x = 0.5 * (run.first + run.last);
        const auto holds = [x](const Paint::Run& other) { return other.first <= x && x <= other.last; };
        if (std::ranges::none_of(std::span(paint.runs).first(crossing), holds)) paint.runs.push_back(run);
    }
    if (paint.runs.empty()) paint.runs.push_back({0, 0, &paint.pieces[0]});
    std::ranges::stable_sort(paint.runs, {}, [](const Paint::Run& run) { return run.first + run.last; });
    for (std::size_t i = 0; i + 1 < paint.runs.size(); ++i)
        paint.runs[i].last = 0.5 * (paint.runs[i].last + paint.runs[i + 1].first);
    paint.runs.back().last = 1e300;
}

double bounded(double number, double limit) { // NaN becomes 0
    return number > limit ? limit : number > -limit ? number : number <= -limit ? -limit : 0.0;
}

// A position in a picture of 2^32 to the whole; whole pictures drop out.
std::uint32_t to_phase(double position) {
    if (!(std::fabs(position) < 1e15)) return 0;
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>((position - std::floor(position)) * 4294967296.0));
}

std::uint32_t to_texels(double position) { // 16.16
    return static_cast<std::uint32_t>(
        static_cast<std::int32_t>(std::floor(bounded(position, 30000.0) * 65536.0 + 0.5)));
}

void sample_run(Set set, const Piece& piece, const Picture& picture, bool repeat, double x, double y, int count,
                Pixel* out) {
    Walk walk;
    walk.texels = picture.texels.data();
    walk.width = picture.width, walk.height = picture.height;
    walk.repeat = repeat;
    // Texel centres lie at .5; and 1/512 texel more, so that steps of 1/256 are rounded, not cut.
    constexpr double kShift = 1.0 / 512 - 0.5;
    const double w = picture.width, h = picture.height, u = value(piece.u, x, y), v = value(piece.v, x, y);
    if (repeat) {
        walk.u = to_phase(u + kShift / w), walk.v = to_phase(v + kShift / h);
        walk.du = to_phase(piece.u.dx), walk.dv = to_phase(piece.v.dx);
    } else {
        walk.u = to_texels(u * w + kShift), walk.v = to_texels(v * h + kShift);
        walk.du = to_texels(piece.u.dx * w), walk.dv = to_texels(piece.v.dx * h);
    }
    sample(set, out, count, walk);
}

void ramp_run(Set set, const Piece& piece, double x, double y, int count, Pixel* out) {
    constexpr double kOne = 65536.0, kLimit = 1 << 29; // twice the limit, start and all steps, stays within 32 bits
    Ramp colours;
    for (int c = 0; c < 4; ++c) {
        const double start = bounded(value(piece.channel[c], x, y) * kOne, kLimit);
        const double step = bounded(piece.channel[c].dx * kOne, kLimit / (count + 8));
        colours.start[c] = static_cast<std::int32_t>(std::floor(start + 0.5));
        colours.step[c] = static_cast<std::int32_t>(std::floor(step + 0.5));
        colours.least[c] = static_cast<std::int32_t>(piece.least[c] * kOne);
        colours.most[c] = static_cast<std::int32_t>(piece.most[c] * kOne);
    }
    ramp(set, out, count, colours);
}

void paint_run(Paint& paint, Set set, const Piece& piece, int y, int left, int right, Pixel* out) {
    const int count = right - left;
    const double x = left + 0.5, middle = y + 0.5;
    if (paint.textured) sample_run(set, piece, *piece.picture, paint.repeat, x, middle, count, out);
    if (paint.coloured) {
        const std::size_t room = static_cast<std::size_t>(count) + 8;
        if (paint.colours.size() < room) paint.colours.resize(room);
        ramp_run(set, piece, x, middle, count, paint.textured ? paint.colours.data() : out);
        if (paint.textured) modulate(set, out, paint.colours.data(), count);
    } else if (paint.flat != 0xffffffffu) {
        modulate_flat(set, out, count, paint.flat);
    }
}

// The share of each piece in a row: f(piece, from, to).
template <class F> void each_run(Paint& paint, int y, int left, int right, F&& f) {
    if (paint.pieces.size() == 1) return f(paint.pieces[0], left, right);
    find_runs(paint, y);
    int at = left;
    for (const Paint::Run& run : paint.runs) {
        // The last pixel whose centre lies before the run's end.
        const int end = static_cast<int>(std::clamp(std::ceil(run.last - 0.5), double(at), double(right)));
        if (end > at) f(*run.piece, at, end);
        at = end;
    }
}

// From normals as the picture has them, x along u and y against v, to pixels: however it is turned, mirrored or stretched.
Turn turn_of(const Piece& piece) {
    const auto unit = [](const Plane& plane, double sign, float& x, float& y) {
        const double size = std::sqrt(plane.dx * plane.dx + plane.dy * plane.dy), by = size > 0.0 ? sign / size : 0.0;
        x = static_cast<float>(plane.dx * by), y = static_cast<float>(plane.dy * by);
    };
    Turn turn;
    unit(piece.u, 1.0, turn.xx, turn.xy);
    unit(piece.v, -1.0, turn.yx, turn.yy);
    return turn;
}

} // namespace

void prepare(Paint& paint, const draw::DrawList& list, const draw::Mesh& mesh, const draw::Instance& instance,
             Pictures pictures) {
    for (const Texture** each : {&pictures.colours, &pictures.normals, &pictures.glows})
        if (*each && (*each)->levels.empty()) *each = nullptr;
    paint.pieces.clear();
    paint.textured = pictures.colours != nullptr;
    paint.bumpy = pictures.normals != nullptr, paint.glowing = pictures.glows != nullptr;
    paint.repeat = false;
    paint.coloured = mesh.coloured_corners;
    paint.flat = paint.tint = premultiply(instance.tint);
    if (is_flat(paint) && !is_any(pictures)) return;
    const std::span<const draw::Vertex> vertices{list.vertices.data() + mesh.first_vertex,
                                                 mesh.vertex_count + mesh.inside};
    if (mesh.kind == draw::MeshKind::circle) {
        prepare_circle(paint, vertices[0], mesh, instance, pictures);
    } else {
        const std::span<const std::uint32_t> triangles{list.indices.data() + mesh.first_index, mesh.index_count};
        prepare_polygon(paint, vertices, triangles, instance, pictures, mesh.inside > 0);
    }
}

void paint_row(Paint& paint, Set set, int y, int left, int right, Pixel* out) {
    each_run(paint, y, left, right, [&](const Piece& piece, int from, int to) {
        paint_run(paint, set, piece, y, from, to, out + (from - left));
    });
}

void paint_glow(Paint& paint, Set set, int y, int left, int right, Pixel* out) {
    each_run(paint, y, left, right, [&](const Piece& piece, int from, int to) {
        sample_run(set, piece, *piece.glows, paint.repeat, from + 0.5, y + 0.5, to - from, out + (from - left));
    });
    modulate_flat(set, out, right - left, paint.tint);
}

void bend_light(Paint& paint, Set set, int y, int left, int right, const Light& light, std::uint32_t* out) {
    const std::size_t room = static_cast<std::size_t>(right - left) + 8;
    if (paint.colours.size() < room) paint.colours.resize(room);
    each_run(paint, y, left, right, [&](const Piece& piece, int from, int to) {
        const int at = from - left, count = to - from;
        sample_run(set, piece, *piece.normals, paint.repeat, from + 0.5, y + 0.5, count, paint.colours.data());
        bend(set, out + at, light.factors + at, {light.across + at, light.down + at}, paint.colours.data(), count,
             turn_of(piece));
    });
}

} // namespace evil::raster
