#include "draw/debug.hpp"
#include "draw/scene.hpp"
#include "shapes/rounded.hpp"

namespace evil::draw {
namespace {

// All in logical points.
constexpr float kOutline = 1.5f;
constexpr float kArrow = 2.0f;
constexpr float kNormal = 22.0f; // length of a contact's arrow: seen well, and shorter than a crate of a metre
constexpr float kDot = 3.0f;
constexpr float kVelocity = 0.1f; // seconds: the arrow ends where the body would be by then

Rgba8 colour_of(const Body& body, const DebugColours& colours) {
    if (body.kind == BodyKind::fixed) return colours.still;
    if (body.kind == BodyKind::kinematic) return colours.kinematic;
    return body.awake ? colours.awake : colours.asleep;
}

bool is_finite(const Affine& m) {
    return evil::is_finite({m.a, m.b}) && evil::is_finite({m.c, m.d}) && evil::is_finite({m.tx, m.ty});
}

void outline_shape(const Overlay& overlay, const World& world, std::uint32_t slot, const Affine& body_to_pixel,
                   Rgba8 colour, float width) {
    const Shape& shape = world.shapes.rows[slot];
    const Vec2 scale = world.bodies.rows[shape.body].scale;
    const Affine to_pixel = compose(body_to_pixel, definition_to_body(shape, scale));
    if (!is_finite(to_pixel)) return;
    if (shape.kind == ShapeKind::particle) {
        disc(overlay, {to_pixel.tx, to_pixel.ty}, 2.0f * width, colour);
        return;
    }
    DrawList& list = overlay.list;
    if (shape.kind == ShapeKind::circle) {
        const std::uint32_t mesh = add_circle(list, Vertex{}, shape.radius);
        list.instances.push_back({to_pixel, {}, mesh, kNoTexture, colour, width});
        line(overlay, {to_pixel.tx, to_pixel.ty}, apply(to_pixel, {shape.radius, 0}), width,
             colour); // shows how it turns
        return;
    }
    const std::vector<Vec2> corners = drawn_outline(shape, world.shapes.corners[slot]);
    Mesh mesh; // an outline needs no triangles
    mesh.first_vertex = static_cast<std::uint32_t>(list.vertices.size());
    mesh.vertex_count = static_cast<std::uint32_t>(corners.size());
    mesh.first_index = static_cast<std::uint32_t>(list.indices.size());
    for (const Vec2 corner : corners) list.vertices.push_back({corner, {}, ~0u});
    list.meshes.push_back(mesh);
    list.instances.push_back(
        {to_pixel, {}, static_cast<std::uint32_t>(list.meshes.size() - 1), kNoTexture, colour, width});
}

void draw_body(const Overlay& overlay, const World& world, std::uint32_t slot, const Affine& view, float alpha,
               const DebugLook& look) {
    const Body& body = world.bodies.rows[slot];
    const Pose pose = between(world.previous[slot], world.present[slot], alpha);
    const Affine to_pixel = compose(view, affine(pose));
    const Rgba8 colour = colour_of(body, look.colours);
    for (std::uint32_t s = body.first_shape; s != kNone; s = world.shapes.rows[s].next) {
        const bool sensor = world.shapes.rows[s].traits.sensor;
        outline_shape(overlay, world, s, to_pixel, sensor ? look.colours.sensor : colour, kOutline * look.points);
    }
    if (body.kind != BodyKind::dynamic) return;
    const Vec2 centre = transform(pose, body.local_centre);
    disc(overlay, apply(view, centre), 0.7f * kDot * look.points, look.colours.centre);
    if (look.velocities)
        arrow(overlay, apply(view, centre), apply(view, centre + kVelocity * body.velocity), kOutline * look.points,
              look.colours.velocity);
}

void draw_area(const Overlay& overlay, const Area& area, const Affine& view, const DebugLook& look) {
    const float width = kOutline * look.points;
    if (area.radius > 0.0f) {
        const std::uint32_t mesh = add_circle(overlay.list, Vertex{}, area.radius);
        const Affine to_pixel = compose(view, affine(Pose{area.centre, {}}));
        if (is_finite(to_pixel))
            overlay.list.instances.push_back({to_pixel, {}, mesh, kNoTexture, look.colours.medium, width});
    }
    for (const std::vector<Vec2>& part : area.parts)
        for (std::size_t i = 0; i < part.size(); ++i)
            line(overlay, apply(view, part[i]), apply(view, part[i + 1 < part.size() ? i + 1 : 0]), width,
                 look.colours.medium);
}

void draw_media(const Overlay& overlay, const World& world, const Affine& view, float alpha, const DebugLook& look) {
    for (std::uint32_t slot = 0; slot < world.forces.slots.size(); ++slot) {
        if (!world.forces.slots.taken(slot) || world.forces.rows[slot].kind != ForceKind::medium) continue;
        const std::uint32_t carrier = world.forces.rows[slot].target;
        Affine to_pixel = view;
        if (carrier != kNone)
            to_pixel = compose(view, affine(between(world.previous[carrier], world.present[carrier], alpha)));
        draw_area(overlay, world.forces.areas[slot], to_pixel, look);
    }
}

void draw_contact(const Overlay& overlay, const World& world, const Contact& contact, const Affine& view,
                  const DebugLook& look) {
    const Vec2 centre = world.bodies.rows[contact.body_a].centre;
    const Vec2 direction = normalised(apply_linear(view, contact.normal));
    for (int i = 0; i < contact.count; ++i) {
        const Vec2 at = apply(view, centre + contact.points[i].anchor_a);
        arrow(overlay, at, at + (kNormal * look.points) * direction, kArrow * look.points, look.colours.contact);
        disc(overlay, at, kDot * look.points, look.colours.contact);
    }
}

} // namespace

DebugCount draw_debug(const Overlay& overlay, const World& world, const Affine& view, float alpha,
                      const DebugLook& look) {
    DebugCount count;
    draw_media(overlay, world, view, alpha, look);
    for (std::uint32_t slot = 0; slot < world.bodies.slots.size(); ++slot) {
        if (!world.bodies.slots.taken(slot)) continue;
        draw_body(overlay, world, slot, view, alpha, look);
        ++count.bodies;
        const Body& body = world.bodies.rows[slot];
        if (body.kind == BodyKind::dynamic && !body.awake) ++count.asleep;
    }
    for (const Contact& contact : world.contacts.rows) {
        if (!contact.touching || contact.sensor) continue;
        draw_contact(overlay, world, contact, view, look);
        ++count.contacts;
    }
    return count;
}

} // namespace evil::draw
