// Shape definitions (what a user asks for) and handles (what is on a body).
#include "bind/shapes.hpp"
#include "bind/traits.hpp"
#include "shapes/rounded.hpp"

namespace evil::bind {
namespace {

constexpr float kMinEdge = 1e-4f; // metres, MIN_SIZE of world/shapes.py

Affine placed_at(nb::handle offset, double angle, const char* owner) {
    Vec2 p = to_vec2(offset, owner, "offset");
    return affine(Pose{p, rotation(angle)});
}

Affine rows_of(const ShapeHandle& h) { return definition_to_body(row(h), h.world->bodies.rows[row(h).body].scale); }

nb::tuple to_tuple(std::span<const Vec2> points) {
    nb::list list;
    for (Vec2 p : points) list.append(from_vec2(p));
    return nb::tuple(list);
}

nb::tuple holes_of(const Rings& rings) {
    nb::list list;
    for (std::size_t i = 1; i < rings.count(); ++i) list.append(to_tuple(rings.ring(i)));
    return nb::tuple(list);
}

constexpr const char* kOutline =
    "In the body's frame: ('circle', centre, radius), ('polygon', corners, holes), ('rounded', corners of its core, "
    "radius, its holes), ('capsule', ends, radius), ('segment', ends), ('chain', points, loop) or ('particle', "
    "centre).";

Anything outline(const ShapeHandle& h) {
    const Shape& shape = row(h);
    Affine m = rows_of(h);
    if (shape.kind == ShapeKind::circle)
        return nb::borrow<Anything>(
            nb::make_tuple("circle", from_vec2({m.tx, m.ty}), shape.radius * length({m.a, m.b})));
    if (shape.kind == ShapeKind::particle)
        return nb::borrow<Anything>(nb::make_tuple("particle", from_vec2({m.tx, m.ty})));
    std::vector<Vec2> points;
    for (Vec2 p : h.world->shapes.corners[h.ref.slot]) points.push_back(apply(m, p));
    Rings rings(points, h.world->shapes.holes[h.ref.slot]);
    nb::tuple corners = to_tuple(rings.ring(0));
    float radius = shape.radius * length({m.a, m.b});
    if (shape.kind == ShapeKind::chain) return nb::borrow<Anything>(nb::make_tuple("chain", corners, shape.closed));
    bool line = shape.kind == ShapeKind::line;
    if (line && radius > 0.0f) return nb::borrow<Anything>(nb::make_tuple("capsule", corners, radius));
    if (line) return nb::borrow<Anything>(nb::make_tuple("segment", corners));
    if (radius > 0.0f) return nb::borrow<Anything>(nb::make_tuple("rounded", corners, radius, holes_of(rings)));
    return nb::borrow<Anything>(nb::make_tuple("polygon", corners, holes_of(rings)));
}

template <float Material::* Field>
void bind_material(nb::class_<ShapeHandle>& c, const char* name, float most, const char* doc) {
    def_value(
        c, name, kNumber, [](const ShapeHandle& h) { return row(h).material.*Field; },
        [name, most](const ShapeHandle& h, nb::handle value) {
            float number = in_range(value, "Shape", name, 0.0f, most);
            Shape& shape = row(h);
            shape.material.*Field = number;
            ++h.world->shapes.material_changes;
            wake(*h.world, shape.body);
        },
        doc);
}

// Points far enough apart to give each edge a direction.
void refuse_bad_path(std::span<const Vec2> points, bool closed, const char* owner) {
    std::string who = std::string(owner) + ": ";
    std::size_t n = points.size(), fewest = closed ? 3 : 2;
    if (n < fewest)
        raise(ErrorKind::shape, who + "needs " + std::to_string(fewest) + " points or more; got " + std::to_string(n));
    if (n > kMaxCorners)
        raise(ErrorKind::shape, who + std::to_string(n) + " points are too many; at most " +
                                    std::to_string(kMaxCorners) + " are allowed");
    for (std::size_t i = 0; i < n; ++i)
        if (!(std::abs(points[i].x) <= kMaxCoordinate && std::abs(points[i].y) <= kMaxCoordinate))
            raise(ErrorKind::shape, who + "point " + std::to_string(i) +
                                        " must be finite and at most 100000 metres from the origin each way");
    for (std::size_t i = closed ? 0 : 1; i < n; ++i) {
        std::size_t before = i > 0 ? i - 1 : n - 1;
        if (length(points[i] - points[before]) < kMinEdge)
            raise(ErrorKind::shape, who + "points " + std::to_string(before) + " and " + std::to_string(i) +
                                        " are nearer than 0.0001 metres; leave one out" +
                                        (closed ? " (loop=True joins the last to the first)" : ""));
    }
}

NewShape polygon_spec(nb::handle corners, const char* owner, float rounding, nb::handle holes) {
    NewShape s;
    s.shape.kind = ShapeKind::polygon;
    s.rings = to_rings(corners, holes, owner, "corners");
    turn_rings(s.rings.corners, s.rings.holes);
    if (rounding > 0.0f) {
        OwnedRings core = inset(s.rings, rounding);
        if (core.corners.empty()) {
            std::string most = nb::cast<std::string>(nb::str("{:.4g}").attr("format")(largest_inset(s.rings)));
            raise(ErrorKind::shape,
                  std::string(owner) + ": rounding is too large for these corners; at most about " + most + " fits");
        }
        s.rings = std::move(core);
        s.shape.radius = rounding;
    }
    s.parts = split_convex(s.rings);
    return s;
}

NewShape line_spec(nb::handle a, nb::handle b, float radius, const char* owner) {
    NewShape s;
    s.shape.kind = ShapeKind::line;
    s.shape.radius = radius;
    s.rings.corners = {to_vec2(a, owner, "a"), to_vec2(b, owner, "b")};
    refuse_bad_path(s.rings.corners, false, owner);
    return s;
}

NewShape chain_spec(nb::handle points, bool loop, const char* owner) {
    NewShape s;
    s.shape.kind = ShapeKind::chain;
    s.shape.closed = loop;
    s.rings.corners = to_corners(points, owner, "points");
    refuse_bad_path(s.rings.corners, loop, owner);
    return s;
}

double area_of(const NewShape& s) {
    if (s.shape.kind == ShapeKind::circle) return circle_mass(s.shape.radius, 1.0f).mass;
    if (s.shape.kind == ShapeKind::particle || s.shape.kind == ShapeKind::chain) return 0.0;
    return rounded_mass(s.rings, s.shape.radius, 1.0f).mass;
}

void bind_definition(nb::module_& module) {
    nb::class_<NewShape> c(module, "ShapeSpec",
                           "A shape as the core takes it: checked, counter-clockwise, split into convex parts.");
    c.def_static("circle", [](float radius) {
        NewShape s;
        s.shape.kind = ShapeKind::circle;
        s.shape.radius = radius;
        return s;
    });
    c.def_static("particle", [](float mass) {
        NewShape s;
        s.shape.kind = ShapeKind::particle;
        s.shape.mass = mass;
        return s;
    });
    c.def_static("polygon", &polygon_spec, nb::arg("corners"), nb::arg("owner"), nb::arg("rounding") = 0.0f,
                 nb::arg("holes") = nb::make_tuple());
    c.def_static("line", &line_spec, nb::arg("a").none(), nb::arg("b").none(), nb::arg("radius"), nb::arg("owner"));
    c.def_static("chain", &chain_spec);
    using Points = nb::typed<nb::tuple, PyVec2, nb::ellipsis>;
    using Holes = nb::typed<nb::tuple, Points, nb::ellipsis>;
    c.def_prop_ro("corners", [](const NewShape& s) { return nb::borrow<Points>(to_tuple(Rings(s.rings).ring(0))); });
    c.def_prop_ro("holes", [](const NewShape& s) { return nb::borrow<Holes>(holes_of(s.rings)); });
    c.def_prop_ro("parts", [](const NewShape& s) { // as the collider has them, skins left out
        nb::list parts;
        for (const Part& part : s.parts) {
            std::vector<Vec2> points;
            for (std::uint32_t corner : part) points.push_back(s.rings.corners[corner]);
            parts.append(to_tuple(points));
        }
        return nb::borrow<Holes>(nb::tuple(parts));
    });
    c.def_prop_ro("drawn", [](const NewShape& s) { // its outline, and its holes'
        OwnedRings rings = drawn_outline(s.shape, s.rings);
        return nb::borrow<nb::typed<nb::tuple, Points, Holes>>(
            nb::make_tuple(to_tuple(Rings(rings).ring(0)), holes_of(rings)));
    });
    c.def_prop_ro("area", &area_of);
}

} // namespace

// A spec with the material, place and angle of this one use.
NewShape used(const NewShape& spec, nb::handle offset, double angle, float density, float friction, float restitution) {
    NewShape s = spec;
    s.shape.local = placed_at(offset, angle, "Shape");
    s.shape.material = {density, friction, restitution};
    return s;
}

void register_shape(nb::module_& module) {
    bind_definition(module);
    nb::class_<ShapeHandle> c(module, "Shape", "Reference to a shape on a body.");
    c.def(
        "__init__",
        [](ShapeHandle* self, std::shared_ptr<World> world, std::uint32_t slot, std::uint32_t generation) {
            ShapeHandle h{std::move(world), {slot, generation}, 0, 0, false, {}};
            if (alive(h)) {
                h.born = h.world->shapes.rows[slot].born;
                h.tag = h.world->bodies.tags[h.world->shapes.rows[slot].body];
            }
            new (self) ShapeHandle(std::move(h));
        },
        nb::arg("world"), nb::arg("slot"), nb::arg("generation"));
    bind_identity(c);
    bind_traits(c);
    bind_material<&Material::friction>(c, "friction", 1e6f, "Friction coefficient; a pair mixes its two as sqrt(a b).");
    bind_material<&Material::restitution>(c, "restitution", 1.0f, "0: no bounce, 1: full; a pair takes the larger.");
    def_value(
        c, "density", kNumber, [](const ShapeHandle& h) { return row(h).material.density; },
        [](const ShapeHandle& h, nb::handle value) {
            float density = in_range(value, "Shape", "density", 0.0f, 1e9f);
            require_alive(h);
            MassProblem problem = set_density(*h.world, h.ref.slot, density);
            if (problem != MassProblem::none) raise_mass(problem, "Shape.density");
        },
        "Relative to water, 1.0: kilograms a square metre.");
    c.def_prop_ro(
        "mass",
        [](const ShapeHandle& h) {
            return moments(h.world->shapes, (row(h), h.ref.slot), h.world->bodies.rows[row(h).body].scale).mass;
        },
        "Kilograms that its density and area make; the body's mass unless that was set.");
    c.def_prop_ro("_body_slot", [](const ShapeHandle& h) { return row(h).body; });
    c.def_prop_ro("outline", outline, kOutline);
    c.def_prop_ro("_matrix", [](const ShapeHandle& h) { return from_affine(row(h).local); });
    c.def(
        "_apply_matrix",
        [](const ShapeHandle& h, nb::handle matrix) {
            Affine m = to_affine(matrix, "Shape.apply_matrix");
            require_alive(h);
            MatrixProblem problem = apply_to_shape(*h.world, h.ref.slot, m);
            if (problem != MatrixProblem::none) raise_matrix(problem, "Shape.apply_matrix");
        },
        nb::arg("matrix").none());
    c.def("_destroy", [](const ShapeHandle& h) {
        require_alive(h);
        destroy_shape(*h.world, h.ref.slot);
    });
}

} // namespace evil::bind
