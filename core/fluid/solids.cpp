#include "fluid/solids.hpp"
#include "world.hpp"
#include <algorithm>
#include <cmath>

namespace evil::fluid {
namespace {

constexpr float kFar = 1e30f;  // cells: no solid near
constexpr int kTile = 16;      // cells of a tile of the pressure's
constexpr float kThin = 0.75f; // cells: half of a wall that nothing seeps through, at any angle

Patch joined(const Patch& a, const Patch& b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    return {std::min(a.left, b.left), std::min(a.low, b.low), std::max(a.right, b.right), std::max(a.high, b.high)};
}
Patch common(const Patch& a, const Patch& b) {
    return {std::max(a.left, b.left), std::max(a.low, b.low), std::min(a.right, b.right), std::min(a.high, b.high)};
}

// The corners of cells within a box given in cells, and a cell round it.
Patch nodes_round(const Grid& g, Vec2 low, Vec2 high) {
    auto whole = [](float at, int most) {
        return static_cast<int>(std::clamp(at, -2.0f, static_cast<float>(most + 2)));
    };
    const Patch all{0, 0, g.nx + 1, g.ny + 1};
    return common(all, {whole(std::floor(low.x) - 1.0f, g.nx), whole(std::floor(low.y) - 1.0f, g.ny),
                        whole(std::ceil(high.x) + 2.0f, g.nx), whole(std::ceil(high.y) + 2.0f, g.ny)});
}

// Half of how wide a convex piece is where it is narrowest: seen along one of its edges.
float half_width(std::span<const Vec2> corners) {
    float least = corners.size() < 2 ? 0.0f : kFar;
    for (std::size_t i = 0; i < corners.size() && least > 0.0f; ++i) {
        const Vec2 p = corners[i], d = corners[i + 1 < corners.size() ? i + 1 : 0] - p;
        float most = 0.0f;
        for (Vec2 corner : corners) most = std::max(most, std::abs(cross(d, corner - p)));
        const float long_side = length(d);
        if (long_side > 0.0f) least = std::min(least, 0.5f * most / long_side);
    }
    return least;
}

void set_outline(Outline& o, std::span<const Vec2> corners, float radius) {
    const std::size_t n = std::min<std::size_t>(corners.size(), kMostEdges);
    o.edges = static_cast<int>(n == 2 ? 1 : n); // a segment is one edge there
    o.radius = radius;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 p = corners[i], d = corners[i + 1 < n ? i + 1 : 0] - p;
        const float square = length_squared(d);
        o.x[i] = p.x, o.y[i] = p.y, o.dx[i] = d.x, o.dy[i] = d.y;
        o.per_length[i] = square > 0.0f ? 1.0f / square : 0.0f;
    }
}

} // namespace

bool is_small(const Body& body, float cell) {
    return body.kind == BodyKind::dynamic && body.mass > 0.0f && body.inertia < 0.36f * body.mass * cell * cell;
}

void Solids::lay_out(const Grid& grid, const std::array<bool, 4>& open, bool with_small) {
    open_ = open, with_small_ = with_small;
    for (Field* field : {&distance_, &owner_, &across_, &up_, &gas_, &room_}) field->lay_out(grid);
    pieces_.clear(), pieces_before_.clear();
    fresh_ = true;
}

// All pieces that reach into the grid, in the order of their slots.
void Solids::look(const World& world, const Grid& g) {
    pieces_.swap(pieces_before_);
    corners_.swap(corners_before_);
    pieces_.clear(), corners_.clear();
    const Shapes& shapes = world.shapes;
    const float per_metre = 1.0f / g.h;
    for (std::uint32_t slot = 0; slot < shapes.piece_slots.size(); ++slot) {
        if (!shapes.piece_slots.taken(slot) || shapes.pieces[slot].sensor) continue;
        const Piece& piece = shapes.pieces[slot];
        if (!with_small_ && is_small(world.bodies.rows[piece.body], g.h)) continue;
        const Pose& pose = world.bodies.rows[piece.body].pose;
        const Vec2 middle = per_metre * (transform(pose, piece.centre) - g.low);
        const float reach = per_metre * piece.reach + 2.0f;
        if (!(middle.x + reach > 0.0f && middle.y + reach > 0.0f && middle.x - reach < static_cast<float>(g.nx) &&
              middle.y - reach < static_cast<float>(g.ny)))
            continue;
        Seen seen;
        seen.piece = slot, seen.body = piece.body, seen.kind = world.bodies.rows[piece.body].kind;
        seen.first = static_cast<std::uint32_t>(corners_.size()), seen.radius = per_metre * piece.radius;
        if (piece.count == 0) corners_.push_back(middle);
        for (Vec2 corner : points_of(shapes, piece)) corners_.push_back(per_metre * (transform(pose, corner) - g.low));
        seen.count = static_cast<std::uint32_t>(corners_.size()) - seen.first;
        const std::span<const Vec2> corners(&corners_[seen.first], seen.count);
        const float narrow = half_width(corners) + seen.radius, wide = per_metre * piece.reach;
        if (wide > 2.0f * kThin) seen.radius += std::max(kThin - narrow, 0.0f);
        Vec2 low = corners_[seen.first], high = low;
        for (std::size_t k = seen.first; k < corners_.size(); ++k)
            low = min(low, corners_[k]), high = max(high, corners_[k]);
        const Vec2 skin{seen.radius, seen.radius};
        seen.patch = nodes_round(g, low - skin, high + skin);
        if (!seen.patch.empty())
            pieces_.push_back(seen);
        else
            corners_.resize(seen.first);
    }
}

bool Solids::same(std::size_t now, std::size_t before) const {
    const Seen &a = pieces_[now], &b = pieces_before_[before];
    if (a.body != b.body || a.kind != b.kind || a.count != b.count || a.radius != b.radius) return false;
    return std::equal(&corners_[a.first], &corners_[a.first] + a.count, &corners_before_[b.first]);
}

std::span<const Patch> Solids::redraw(const World& world, const Grid& grid, InstructionSet set) {
    look(world, grid);
    changed_.clear();
    std::size_t before = 0;
    for (std::size_t now = 0; now < pieces_.size() || before < pieces_before_.size();) { // both rise by slot
        const std::uint32_t a = now < pieces_.size() ? pieces_[now].piece : kNone;
        const std::uint32_t b = before < pieces_before_.size() ? pieces_before_[before].piece : kNone;
        if (a == b) {
            if (!same(now, before)) changed_.push_back(joined(pieces_[now].patch, pieces_before_[before].patch));
            ++now, ++before;
        } else if (a < b) {
            changed_.push_back(pieces_[now++].patch);
        } else {
            changed_.push_back(pieces_before_[before++].patch);
        }
    }
    if (fresh_) changed_.assign(1, {0, 0, grid.nx + 1, grid.ny + 1});
    fresh_ = false;
    for (const Patch& patch : changed_) draw(grid, patch, set);
    return changed_;
}

bool Solids::update(const World& world, const Grid& grid, Pressure& pressure, InstructionSet set) {
    faces_.clear();
    for (const Patch& patch : redraw(world, grid, set))
        faces_.push_back({std::max(patch.left - 1, 0), std::max(patch.low - 1, 0), patch.right, patch.high});
    if (changed_.empty()) return false;
    pressure.set_faces(grid, across_, up_, faces_);
    find_gas(grid);
    pockets_.find({grid, open_, across_, up_, gas_}, pressure.finest());
    find_walls(world, grid, pressure);
    return true;
}

void Solids::draw(const Grid& g, const Patch& patch, InstructionSet set) {
    for (int j = patch.low; j < patch.high; ++j) {
        std::fill_n(distance_.data() + g.at(patch.left, j), patch.right - patch.left, kFar);
        std::fill_n(owner_.data() + g.at(patch.left, j), patch.right - patch.left, 0.0f);
    }
    for (const Seen& seen : pieces_) {
        const Patch part = common(seen.patch, patch);
        if (part.empty()) continue;
        set_outline(outline_, {&corners_[seen.first], seen.count}, seen.radius);
        for (int j = part.low; j < part.high; ++j) EVIL_PICK(set, draw_outline)
        (outline_, j, part.left, part.right, static_cast<float>(seen.body + 1), distance_.data() + g.at(0, j),
         owner_.data() + g.at(0, j));
    }
    const int left = std::max(patch.left - 1, 0), low = std::max(patch.low - 1, 0);
    const int right = std::min(patch.right, g.nx + 1), high = std::min(patch.high, g.ny + 1);
    for (int j = low; j < high; ++j) {
        EVIL_PICK(set, open_faces)
        (distance_.data() + g.at(0, j), distance_.data() + g.at(0, std::min(j + 1, g.ny)), left, right,
         across_.data() + g.at(0, j), up_.data() + g.at(0, j));
        if (j == g.ny) std::fill_n(across_.data() + g.at(left, j), right - left, 0.0f); // no cell there
        if (right == g.nx + 1) up_[g.at(g.nx, j)] = 0.0f;
        if (left == 0 && !open_[0]) across_[g.at(0, j)] = 0.0f;
        if (right == g.nx + 1 && !open_[1]) across_[g.at(g.nx, j)] = 0.0f;
    }
    if (low == 0 && !open_[2]) std::fill_n(up_.data() + g.at(left, 0), right - left, 0.0f);
    if (high == g.ny + 1 && !open_[3]) std::fill_n(up_.data() + g.at(left, g.ny), right - left, 0.0f);
}

// Cells whose corners lie in a patch.
Patch Solids::cells_of(const Grid& g, const Patch& patch) {
    return {std::max(patch.left - 1, 0), std::max(patch.low - 1, 0), std::min(patch.right, g.nx),
            std::min(patch.high, g.ny)};
}

// Which cells hold gas, where something has changed.
void Solids::find_gas(const Grid& g) {
    for (const Patch& patch : changed_) {
        const Patch cells = cells_of(g, patch);
        for (int j = cells.low; j < cells.high; ++j)
            for (std::ptrdiff_t at = g.at(cells.left, j); at < g.at(cells.right, j); ++at) {
                const std::ptrdiff_t above = at + g.stride;
                gas_[at] = is_open(at, g.stride) ? 1.0f : 0.0f;
                const float middle = distance_[at] + distance_[at + 1] + (distance_[above] + distance_[above + 1]);
                room_[at] = middle > 0.0f ? gas_[at] : 0.0f;
            }
    }
}

// Where bodies that move cover faces, and where gas lies on them: only near these, row by row.
void Solids::find_walls(const World& world, const Grid& g, const Pressure& pressure) {
    const Level& fine = pressure.finest();
    const std::vector<Body>& bodies = world.bodies.rows;
    near_.assign(static_cast<std::size_t>(fine.tiles * g.ny), 0);
    for (const Seen& seen : pieces_) {
        if (!moves(bodies[seen.body])) continue;
        const Patch cells = cells_of(g, seen.patch);
        if (cells.empty()) continue;
        const int first = cells.left / kTile, count = (cells.right - 1) / kTile - first + 1;
        for (int j = cells.low; j < cells.high; ++j) std::fill_n(near_.begin() + j * fine.tiles + first, count, 1);
    }
    walls_across_.clear(), walls_up_.clear(), shores_.clear();
    for (int j = 0; j < g.ny; ++j)
        for (int t = 0; t < fine.tiles; ++t) {
            const auto tile = static_cast<std::size_t>(j * fine.tiles + t);
            if (near_[tile] == 0 || (fine.plain[0][tile] && fine.plain[1][tile])) continue;
            for (int i = kTile * t; i < std::min(kTile * (t + 1), g.nx); ++i) look_at(bodies, g, i, j);
        }
}

// Of two corners of cells, the one that is deeper in a body: which is it?
std::uint32_t Solids::deeper(std::ptrdiff_t a, std::ptrdiff_t b) const {
    const float owner = distance_[a] < distance_[b] ? owner_[a] : owner_[b];
    return owner > 0.0f ? static_cast<std::uint32_t>(owner) - 1 : kNone;
}

void Solids::look_at(const std::vector<Body>& bodies, const Grid& g, int i, int j) {
    const std::ptrdiff_t at = g.at(i, j), above = g.at(i, j + 1);
    const Vec2 corner = g.low + g.h * Vec2{static_cast<float>(i), static_cast<float>(j)};
    auto add = [&](std::vector<Wall>& walls, float open, std::uint32_t body, Vec2 middle) {
        if (body != kNone && moves(bodies[body])) walls.push_back({at, 1.0f - open, corner + middle, body});
    };
    if (across_[at] < 1.0f && i > 0) add(walls_across_, across_[at], deeper(at, above), {0.0f, 0.5f * g.h});
    if (up_[at] < 1.0f && j > 0) add(walls_up_, up_[at], deeper(at, at + 1), {0.5f * g.h, 0.0f});
    if (gas_[at] == 0.0f) return;
    // the box's own sides are no body's: there its outline ends, and is closed
    const Vec2 area = g.h * Vec2{(i > 0 ? across_[at] : 1.0f) - (i + 1 < g.nx ? across_[at + 1] : 1.0f),
                                 (j > 0 ? up_[at] : 1.0f) - (j + 1 < g.ny ? up_[above] : 1.0f)};
    const std::uint32_t low = deeper(at, at + 1), high = deeper(above, above + 1);
    const float near_low = std::min(distance_[at], distance_[at + 1]);
    const std::uint32_t body = near_low < std::min(distance_[above], distance_[above + 1]) ? low : high;
    if (body == kNone || area == Vec2{} || !moves(bodies[body])) return;
    shores_.push_back({i, j, area, body});
}

} // namespace evil::fluid
