#include "draw/debug.hpp"
#include "draw/scene.hpp"
#include "shapes/rounded.hpp"
#include "solver/islands.hpp"

namespace evil::draw {
namespace {

// All in logical points.
constexpr float kOutline = 1.5f;
constexpr float kThin = 1.0f; // bounds, which lie over outlines
constexpr float kCentre = 2.1f;
constexpr float kVelocity = 0.1f; // seconds: the arrow ends where the body would be by then

// Islands are told apart by these; which is whose follows from a body of it, so it seldom changes.
constexpr Rgba8 kIslandInks[] = {0xff7fe08a, 0xff6fb8ff, 0xffffb26f, 0xffe58fff,
                                 0xff6ff0f0, 0xfff0e26f, 0xff9f8fff, 0xffb0f06f};
constexpr Rgba8 kRgbHalves = 0x007f7f7f; // of a colour, once it is shifted right

Rgba8 dimmed(Rgba8 colour) { return (colour & 0xff000000u) | ((colour >> 1) & kRgbHalves); }

Rgba8 ink_of_island(std::uint32_t root) {
    return kIslandInks[(root * 2654435761u) >> 29]; // Fibonacci hashing (Knuth, TAOCP 3, 6.4): neighbours differ
}

struct IslandBox {
    Bounds bounds;
    std::uint32_t bodies = 0;
};

struct IslandView { // by body slot: the root of its island. Empty: nobody asked
    std::vector<std::uint32_t> root;
    std::vector<IslandBox> boxes; // by root
};

Rgba8 ink_of_state(const DebugFrame& f, const Body& body) {
    if (body.kind == BodyKind::fixed) return f.ink(Ink::still);
    if (body.kind == BodyKind::kinematic) return f.ink(Ink::kinematic);
    return f.ink(body.awake ? Ink::awake : Ink::asleep);
}

Rgba8 ink_of_body(const DebugFrame& f, std::uint32_t slot, const IslandView& islands) {
    const Body& body = f.world.bodies.rows[slot];
    if (islands.root.empty() || body.kind != BodyKind::dynamic) return ink_of_state(f, body);
    const Rgba8 colour = ink_of_island(islands.root[slot]);
    return body.awake ? colour : dimmed(colour);
}

bool is_finite(const Affine& m) {
    return evil::is_finite({m.a, m.b}) && evil::is_finite({m.c, m.d}) && evil::is_finite({m.tx, m.ty});
}

void outline_shape(const DebugFrame& f, std::uint32_t slot, const Affine& body_to_pixel, Rgba8 colour) {
    const Shape& shape = f.world.shapes.rows[slot];
    const Vec2 scale = f.world.bodies.rows[shape.body].scale;
    const Affine to_pixel = compose(body_to_pixel, definition_to_body(shape, scale));
    const float width = f.points(kOutline);
    if (!is_finite(to_pixel)) return;
    if (shape.kind == ShapeKind::particle) {
        disc(f.overlay, {to_pixel.tx, to_pixel.ty}, 2.0f * width, colour);
        return;
    }
    DrawList& list = f.overlay.list;
    if (shape.kind == ShapeKind::circle) {
        const std::uint32_t mesh = add_circle(list, Vertex{}, shape.radius);
        list.instances.push_back({to_pixel, {}, mesh, kNoTexture, colour, width});
        line(f.overlay, {to_pixel.tx, to_pixel.ty}, apply(to_pixel, {shape.radius, 0}), width,
             colour); // shows how it turns
        return;
    }
    if (shape.kind == ShapeKind::chain || (shape.kind == ShapeKind::line && !(shape.radius > 0.0f))) {
        const std::vector<Vec2>& points = f.world.shapes.corners[slot]; // a line has no inside to go round
        for (std::size_t i = 0; i + 1 < points.size() + (shape.closed ? 1 : 0); ++i)
            line(f.overlay, apply(to_pixel, points[i]), apply(to_pixel, points[(i + 1) % points.size()]), width,
                 colour);
        return;
    }
    const OwnedRings rings = drawn_outline(shape, rings_of(f.world.shapes, slot));
    Mesh mesh; // an outline needs no triangles
    mesh.first_vertex = static_cast<std::uint32_t>(list.vertices.size());
    mesh.vertex_count = static_cast<std::uint32_t>(rings.corners.size());
    mesh.first_index = static_cast<std::uint32_t>(list.indices.size());
    mesh.first_hole = static_cast<std::uint32_t>(list.holes.size());
    mesh.hole_count = static_cast<std::uint32_t>(rings.holes.size());
    for (const Vec2 corner : rings.corners) list.vertices.push_back({corner, {}, ~0u});
    list.holes.insert(list.holes.end(), rings.holes.begin(), rings.holes.end());
    list.meshes.push_back(mesh);
    list.instances.push_back(
        {to_pixel, {}, static_cast<std::uint32_t>(list.meshes.size() - 1), kNoTexture, colour, width});
}

void outline_box(const DebugFrame& f, const Bounds& box, Rgba8 colour) {
    const Vec2 corners[] = {box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
    for (std::size_t i = 0; i < 4; ++i)
        line(f.overlay, f.pixel(corners[i]), f.pixel(corners[(i + 1) % 4]), f.points(kThin), colour);
}

template <class Visit> void for_bounds_of(const DebugFrame& f, std::uint32_t body, Visit&& visit) {
    const Shapes& shapes = f.world.shapes;
    const Pose pose = f.pose(body);
    for (std::uint32_t s = f.world.bodies.rows[body].first_shape; s != kNone; s = shapes.rows[s].next)
        for (std::uint32_t p = shapes.rows[s].first_piece; p != kNone; p = shapes.pieces[p].next)
            visit(bounds_of(shapes, shapes.pieces[p], pose));
}

IslandView islands_of(const DebugFrame& f) {
    IslandView view;
    const World& w = f.world;
    find_islands(view.root, w.bodies, w.contacts, w.joints, w.forces);
    view.boxes.resize(view.root.size());
    for (std::uint32_t slot = 0; slot < view.root.size(); ++slot) {
        if (!w.bodies.slots.taken(slot) || w.bodies.rows[slot].kind != BodyKind::dynamic) continue;
        IslandBox& box = view.boxes[view.root[slot]];
        bool empty = box.bodies++ == 0;
        for_bounds_of(f, slot, [&](const Bounds& b) {
            box.bounds = empty ? b : Bounds{min(box.bounds.low, b.low), max(box.bounds.high, b.high)};
            empty = false;
        });
    }
    return view;
}

void draw_islands(const DebugFrame& f, const IslandView& islands, DebugCount& count) {
    for (std::uint32_t root = 0; root < islands.boxes.size(); ++root) {
        const IslandBox& box = islands.boxes[root];
        if (box.bodies > 0) ++count.islands;
        if (box.bodies > 1) outline_box(f, box.bounds, dimmed(ink_of_island(root))); // one alone says it by its colour
    }
}

void draw_body(const DebugFrame& f, std::uint32_t slot, const IslandView& islands) {
    const Body& body = f.world.bodies.rows[slot];
    const Pose pose = f.pose(slot);
    const Rgba8 colour = ink_of_body(f, slot, islands);
    if (f.shows(Part::bounds))
        for_bounds_of(f, slot, [&](const Bounds& box) { outline_box(f, box, f.ink(Ink::bound)); });
    if (f.shows(Part::shapes))
        for (std::uint32_t s = body.first_shape; s != kNone; s = f.world.shapes.rows[s].next)
            outline_shape(f, s, compose(f.view, affine(pose)),
                          f.world.shapes.rows[s].traits.sensor ? f.ink(Ink::sensor) : colour);
    if (body.kind != BodyKind::dynamic) return;
    const Vec2 centre = transform(pose, body.local_centre);
    if (f.shows(Part::centres)) disc(f.overlay, f.pixel(centre), f.points(kCentre), f.ink(Ink::centre));
    if (f.shows(Part::velocities))
        arrow(f.overlay, f.pixel(centre), f.pixel(centre + kVelocity * body.velocity), f.points(kOutline),
              f.ink(Ink::velocity));
}

void draw_area(const DebugFrame& f, const Area& area, const Affine& to_pixel) {
    const float width = f.points(kOutline);
    if (area.radius > 0.0f) {
        const std::uint32_t mesh = add_circle(f.overlay.list, Vertex{}, area.radius);
        const Affine placed = compose(to_pixel, affine(Pose{area.centre, {}}));
        if (is_finite(placed))
            f.overlay.list.instances.push_back({placed, {}, mesh, kNoTexture, f.ink(Ink::medium), width});
    }
    for (const std::vector<Vec2>& part : area.parts)
        for (std::size_t i = 0; i < part.size(); ++i)
            line(f.overlay, apply(to_pixel, part[i]), apply(to_pixel, part[i + 1 < part.size() ? i + 1 : 0]), width,
                 f.ink(Ink::medium));
}

void draw_media(const DebugFrame& f) {
    const Forces& forces = f.world.forces;
    for (std::uint32_t slot = 0; slot < forces.slots.size(); ++slot) {
        if (!forces.slots.taken(slot) || forces.rows[slot].kind != ForceKind::medium) continue;
        const std::uint32_t carrier = forces.rows[slot].target;
        draw_area(f, forces.areas[slot], carrier == kNone ? f.view : compose(f.view, affine(f.pose(carrier))));
    }
}

void draw_bodies(const DebugFrame& f, DebugCount& count) {
    const Bodies& bodies = f.world.bodies;
    const IslandView islands = f.shows(Part::islands) ? islands_of(f) : IslandView{};
    draw_islands(f, islands, count); // under the outlines, which may lie on the box
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        if (!bodies.slots.taken(slot)) continue;
        draw_body(f, slot, islands);
        ++count.bodies;
        if (bodies.rows[slot].kind == BodyKind::dynamic && !bodies.rows[slot].awake) ++count.asleep;
    }
}

} // namespace

Pose DebugFrame::pose(std::uint32_t body) const { return between(world.previous[body], world.present[body], alpha); }

DebugCount draw_debug(const DebugFrame& f) {
    DebugCount count;
    if (f.shows(Part::shapes)) draw_media(f);
    draw_bodies(f, count);
    const Joints& joints = f.world.joints;
    for (std::uint32_t slot = 0; slot < joints.slots.size(); ++slot) {
        if (!joints.slots.taken(slot)) continue;
        if (f.shows(Part::joints)) draw_joint(f, joints.rows[slot]);
        ++count.joints;
    }
    for (const Contact& contact : f.world.contacts.rows) {
        if (!contact.touching || contact.sensor()) continue;
        draw_contact(f, contact);
        ++count.contacts;
    }
    return count;
}

} // namespace evil::draw
