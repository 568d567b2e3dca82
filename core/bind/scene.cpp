// _core.Scene: the drawings of a scene by slot and generation, and the DrawList they become. evilengine.scene is its face;
// it composes the words of errors about drawings, so here they are short.
#include "draw/scene.hpp"
#include "bind/scene.hpp"
#include "bind/shapes.hpp"
#include "bind/visit.hpp"
#include "draw/debug.hpp"
#include "draw/saving.hpp"
#include "shapes/rounded.hpp"
#include <algorithm>
#include <array>
#include <cstring>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>
#include <optional>

namespace evil::bind {
namespace {

using namespace draw;

constexpr const char* kOwner = "Scene.add";

using Reference = std::tuple<std::uint32_t, std::uint32_t>; // slot, generation
using MaybeReference = std::optional<Reference>;

[[noreturn]] void raise_count(const char* argument, std::size_t given, std::size_t corners) {
    raise(ErrorKind::argument, std::string(kOwner) + ": " + argument + " holds " + std::to_string(given) +
                                   ", but the shape has " + std::to_string(corners) + " corners; give one for each");
}

std::vector<Vec2> to_texture_points(nb::handle values) {
    std::vector<Vec2> points = to_corners(values, kOwner, "texture_points");
    for (const Vec2 p : points)
        if (!is_finite(p)) raise(ErrorKind::argument, std::string(kOwner) + ": texture_points must be finite");
    return points;
}

// Corners that make a polygon, or evil.ShapeError.
std::vector<Vec2> to_polygon(nb::handle corners) {
    std::vector<Vec2> points = to_corners(corners, kOwner, "shape");
    refuse_bad_polygon(points, kOwner, "shape");
    if (signed_area(points) < 0.0)
        raise(ErrorKind::shape,
              std::string(kOwner) + ": shape must run counter-clockwise; evil.Polygon turns it round");
    return points;
}

// A polygon's corners with its bounding box spread over the texture, or with the coordinates and colours given.
std::vector<Vertex> to_vertices(std::span<const Vec2> points, nb::handle texture_points, nb::handle colours) {
    Vec2 low = points[0], high = points[0];
    for (const Vec2 p : points) low = min(low, p), high = max(high, p);
    const Vec2 size = high - low;

    std::vector<Vertex> result;
    for (const Vec2 p : points) result.push_back({p, {(p.x - low.x) / size.x, (high.y - p.y) / size.y}, 0xffffffffu});
    if (!texture_points.is_none()) {
        const std::vector<Vec2> given = to_texture_points(texture_points);
        if (given.size() != result.size()) raise_count("texture_points", given.size(), result.size());
        for (std::size_t i = 0; i < given.size(); ++i) result[i].uv = given[i];
    }
    if (!colours.is_none()) {
        const nb::sequence given = nb::cast<nb::sequence>(colours);
        if (nb::len(given) != result.size()) raise_count("colours", nb::len(given), result.size());
        for (std::size_t i = 0; i < result.size(); ++i) result[i].colour = nb::cast<Rgba8>(given[i]);
    }
    return result;
}

Reference add_drawing(SceneBox& box, std::uint32_t mesh, BodyRef body, ShapeRef shape = {}) {
    Drawing drawing;
    drawing.body = body;
    drawing.shape = shape;
    drawing.mesh = mesh;
    const DrawingRef ref = add(box.scene, drawing);
    return {ref.slot, ref.generation};
}

BodyRef to_body(MaybeReference body) { return body ? BodyRef{std::get<0>(*body), std::get<1>(*body)} : BodyRef{}; }

std::uint32_t mesh_of(SceneBox& box, const Shape& shape, const Rings& rings, float speck, nb::handle texture_points,
                      nb::handle colours) {
    Meshes& meshes = box.scene.meshes;
    const OwnedRings drawn = drawn_outline(shape, rings);
    if (!drawn.corners.empty())
        return meshes.take_polygon(to_vertices(drawn.corners, texture_points, colours), drawn.holes);
    return meshes.take_circle(shape.kind == ShapeKind::circle ? shape.radius : speck);
}

// A drawing of a shape as the world has it, which follows the shape's matrix. A particle is shown as a disc.
Reference add_shape(SceneBox& box, const World& world, std::uint32_t slot, float speck, nb::object texture_points,
                    nb::object colours) {
    if (!world.shapes.slots.taken(slot)) raise(ErrorKind::stale_reference, "this Shape was destroyed");
    const Shape& shape = world.shapes.rows[slot];
    const std::uint32_t mesh = mesh_of(box, shape, rings_of(world.shapes, slot), speck, texture_points, colours);
    return add_drawing(box, mesh, {shape.body, world.bodies.slots.generation(shape.body)},
                       {slot, world.shapes.slots.generation(slot)});
}

// A rectangle of nine parts: borders in metres, left low right high, and how much of the picture each takes (0..1).
std::uint32_t sliced_mesh(SceneBox& box, float width, float height, const std::array<float, 4>& border,
                          const std::array<float, 4>& part) {
    const float x[] = {-0.5f * width, -0.5f * width + border[0], 0.5f * width - border[2], 0.5f * width};
    const float y[] = {-0.5f * height, -0.5f * height + border[1], 0.5f * height - border[3], 0.5f * height};
    const float u[] = {0, part[0], 1 - part[2], 1}, v[] = {1, 1 - part[1], part[3], 0};
    constexpr int kPlaces[kSliced][2] = {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {2, 3},
                                         {1, 3}, {0, 3}, {0, 2}, {0, 1}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
    Vertex corners[kSliced];
    for (std::size_t k = 0; k < kSliced; ++k) {
        const auto [i, j] = kPlaces[k];
        corners[k] = {{x[i], y[j]}, {u[i], v[j]}, 0xffffffffu};
    }
    return box.scene.meshes.take_sliced(corners);
}

std::uint32_t add_clip(SceneBox& box, std::vector<std::uint32_t> textures, double steps, std::uint32_t course) {
    if (textures.empty() || !(steps > 0.0) || course > static_cast<std::uint32_t>(Course::back))
        raise(ErrorKind::argument, "Scene.add_clip: needs textures, steps above 0 and a course of 0, 1 or 2");
    box.scene.clips.push_back({std::move(textures), steps, static_cast<Course>(course)});
    return static_cast<std::uint32_t>(box.scene.clips.size() - 1);
}

// The clip that a drawing shows, the step at which it began, the number of the frame that is shown now, and whether it is
// over; nothing for a drawing without a clip.
std::optional<std::tuple<std::uint32_t, std::int64_t, std::size_t, bool>>
playing(SceneBox& box, const World& world, std::uint32_t slot, std::uint32_t generation) {
    const Playing& shown = drawing_at(box, slot, generation).playing;
    if (shown.clip == kNone) return std::nullopt;
    const Clip& clip = box.scene.clips[shown.clip];
    const double age = static_cast<double>(world.steps) - static_cast<double>(shown.began);
    return std::tuple(shown.clip, shown.began, frame_at(clip, age), is_over(clip, age));
}

// A getter and a setter of one member, both by slot and generation.
template <auto member> auto get() {
    return [](SceneBox& box, std::uint32_t slot, std::uint32_t generation) {
        return drawing_at(box, slot, generation).*member;
    };
}
template <auto member> auto set() {
    using Value = std::remove_cvref_t<decltype(std::declval<Drawing>().*member)>;
    return [](SceneBox& box, std::uint32_t slot, std::uint32_t generation, Value value) {
        drawing_at(box, slot, generation).*member = value;
    };
}
template <auto member> auto get_matrix() {
    return [](SceneBox& box, std::uint32_t slot, std::uint32_t generation) {
        const Affine& m = drawing_at(box, slot, generation).*member;
        return std::tuple(m.a, m.b, m.c, m.d, m.tx, m.ty);
    };
}
template <auto member> auto set_matrix() {
    return [](SceneBox& box, std::uint32_t slot, std::uint32_t generation, const Matrix6& matrix) {
        drawing_at(box, slot, generation).*member = to_affine(matrix);
    };
}

// Bytes, the texture ids that they count 1, 2, ..., and the clips that they count 0, 1, ...
std::tuple<nb::bytes, std::vector<std::uint32_t>, std::vector<std::uint32_t>> snapshot_scene(const SceneBox& box,
                                                                                             const World& world) {
    SceneBytes saved = draw::snapshot(box.scene, world);
    return {nb::bytes(saved.bytes.data(), saved.bytes.size()), std::move(saved.textures), std::move(saved.clips)};
}

struct ReadScene { // on its way from bytes to a restore; the world has a Saved, and nanobind tells types by their names
    std::shared_ptr<const SavedScene> scene;
};

ReadScene read_bytes(nb::bytes data) {
    ReadScene saved{read_scene({reinterpret_cast<const std::uint8_t*>(data.c_str()), data.size()})};
    if (!saved.scene) raise(ErrorKind::snapshot, "these bytes are no scene");
    return saved;
}

// Slot of each drawing, and of the body and the shape that it is on; kNone for nothing.
std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> places(const ReadScene& saved) {
    std::vector<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> rows;
    std::vector<std::size_t> order(saved.scene->slots.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::ranges::sort(order, {}, [&](std::size_t i) { return saved.scene->drawings[i].serial; });
    for (const std::size_t i : order)
        rows.emplace_back(saved.scene->slots[i], saved.scene->drawings[i].body.slot,
                          saved.scene->drawings[i].shape.slot);
    return rows;
}

void restore_scene(SceneBox& box, const ReadScene& saved, const World& world,
                   const std::vector<std::uint32_t>& textures, const std::vector<std::uint32_t>& clips) {
    const bool known = std::ranges::all_of(clips, [&](std::uint32_t clip) { return clip < box.scene.clips.size(); });
    if (!known || textures.size() != saved.scene->textures || clips.size() != saved.scene->clips ||
        !draw::restore(box.scene, *saved.scene, world, textures, clips))
        raise(ErrorKind::snapshot, "this scene is of another world");
}

} // namespace

void register_scene(nb::module_& module) {
    const auto slot = nb::arg("slot"), generation = nb::arg("generation"), value = nb::arg("value");
    const auto world = nb::arg("world");
    nb::class_<ReadScene>(module, "SavedScene", "A scene that was read and found whole.")
        .def("__init__", [](ReadScene* self, nb::bytes data) { new (self) ReadScene{read_bytes(data)}; })
        .def_prop_ro("textures", [](const ReadScene& saved) { return saved.scene->textures; })
        .def_prop_ro("clips", [](const ReadScene& saved) { return saved.scene->clips; })
        .def_prop_ro("places", &places, "(slot, body's slot, shape's slot) of each drawing, in the order of creation.");
    nb::class_<SceneBox> c(module, "Scene", "Drawings by slot and generation; evilengine.scene is the face.");
    bind_surfaces(c);
    register_frame(c);
    c.def(nb::init<>())
        .def("__len__", [](const SceneBox& box) { return box.scene.slots.count(); })
        .def("snapshot", &snapshot_scene, world)
        .def("restore", &restore_scene, nb::arg("saved"), world, nb::arg("textures"), nb::arg("clips"))
        .def(
            "generation", [](const SceneBox& box, std::uint32_t s) { return box.scene.slots.generation(s); }, slot)
        .def_prop_ro("mesh_count", [](const SceneBox& box) { return box.scene.meshes.count(); })
        .def(
            "add_definition",
            [](SceneBox& box, const NewShape& spec, float speck, MaybeReference body, nb::object texture_points,
               nb::object colours) {
                const std::uint32_t mesh = mesh_of(box, spec.shape, spec.rings, speck, texture_points, colours);
                return add_drawing(box, mesh, to_body(body));
            },
            nb::arg("spec"), nb::arg("speck"), nb::arg("body") = nb::none(), nb::arg("texture_points") = nb::none(),
            nb::arg("colours") = nb::none())
        .def(
            "add_polygon",
            [](SceneBox& box, nb::handle corners, MaybeReference body, nb::object texture_points, nb::object colours) {
                const std::vector<Vertex> vertices = to_vertices(to_polygon(corners), texture_points, colours);
                return add_drawing(box, box.scene.meshes.take_polygon(vertices), to_body(body));
            },
            nb::arg("corners"), nb::arg("body") = nb::none(), nb::arg("texture_points") = nb::none(),
            nb::arg("colours") = nb::none())
        .def(
            "add_circle",
            [](SceneBox& box, float radius, MaybeReference body) {
                return add_drawing(box, box.scene.meshes.take_circle(radius), to_body(body));
            },
            nb::arg("radius"), nb::arg("body") = nb::none())
        .def("add_shape", &add_shape, world, nb::arg("shape_slot"), nb::arg("speck"),
             nb::arg("texture_points") = nb::none(), nb::arg("colours") = nb::none())
        .def(
            "remove",
            [](SceneBox& box, std::uint32_t s, std::uint32_t g) {
                drawing_at(box, s, g);
                remove(box.scene, {s, g});
            },
            slot, generation)
        .def(
            "alive",
            [](const SceneBox& box, std::uint32_t s, std::uint32_t g) {
                return box.scene.slots.alive(DrawingRef{s, g});
            },
            slot, generation)
        .def(
            "add_sliced",
            [](SceneBox& box, float width, float height, const std::array<float, 4>& border,
               const std::array<float, 4>& part, MaybeReference body, MaybeReference shape) {
                const ShapeRef on = shape ? ShapeRef{std::get<0>(*shape), std::get<1>(*shape)} : ShapeRef{};
                return add_drawing(box, sliced_mesh(box, width, height, border, part), to_body(body), on);
            },
            nb::arg("width"), nb::arg("height"), nb::arg("border"), nb::arg("part"), nb::arg("body") = nb::none(),
            nb::arg("shape") = nb::none(),
            "A rectangle whose picture keeps its four borders: left, low, right, high, in metres and as parts of it.")
        .def(
            "extent",
            [](SceneBox& box, std::uint32_t s, std::uint32_t g) {
                const Meshes& meshes = box.scene.meshes;
                const Mesh& mesh = meshes.meshes()[drawing_at(box, s, g).mesh];
                if (mesh.kind == MeshKind::circle) return std::tuple(2 * mesh.radius, 2 * mesh.radius);
                Vec2 low = meshes.vertices()[mesh.first_vertex].at, high = low;
                for (std::uint32_t i = 1; i < mesh.vertex_count; ++i) {
                    const Vec2 at = meshes.vertices()[mesh.first_vertex + i].at;
                    low = min(low, at), high = max(high, at);
                }
                return std::tuple(high.x - low.x, high.y - low.y);
            },
            slot, generation, "Width and height of its shape, before its matrix.")
        .def("add_clip", &add_clip, nb::arg("textures"), nb::arg("steps"), nb::arg("course"),
             "Frames to be shown for so many steps each; course 0 again and again, 1 once, 2 there and back.")
        .def(
            "clear_clips", [](SceneBox& box) { box.scene.clips.clear(); },
            "Forget the clips; there must be no drawing that shows one.")
        .def("playing", &playing, world, slot, generation)
        .def(
            "play",
            [](SceneBox& box, std::uint32_t s, std::uint32_t g, std::optional<std::uint32_t> clip, std::int64_t began) {
                if (clip && *clip >= box.scene.clips.size()) raise(ErrorKind::argument, "Scene.play: no such clip");
                drawing_at(box, s, g).playing = {clip.value_or(kNone), began};
            },
            slot, generation, nb::arg("clip").none(), nb::arg("began"))
        .def("flip_x", get<&Drawing::flip_x>(), slot, generation)
        .def("set_flip_x", set<&Drawing::flip_x>(), slot, generation, value)
        .def("flip_y", get<&Drawing::flip_y>(), slot, generation)
        .def("set_flip_y", set<&Drawing::flip_y>(), slot, generation, value)
        .def(
            "blend",
            [](SceneBox& box, std::uint32_t s, std::uint32_t g) {
                return static_cast<int>(drawing_at(box, s, g).blend);
            },
            slot, generation)
        .def(
            "set_blend",
            [](SceneBox& box, std::uint32_t s, std::uint32_t g, std::uint32_t blend) {
                if (blend >= kBlends) raise(ErrorKind::argument, "Scene.set_blend: no such blend");
                drawing_at(box, s, g).blend = static_cast<Blend>(blend);
            },
            slot, generation, value)
        .def("tint", get<&Drawing::tint>(), slot, generation)
        .def("set_tint", set<&Drawing::tint>(), slot, generation, value)
        .def("edge", get<&Drawing::edge>(), slot, generation)
        .def("set_edge", set<&Drawing::edge>(), slot, generation, value)
        .def("edge_width", get<&Drawing::edge_width>(), slot, generation)
        .def("set_edge_width", set<&Drawing::edge_width>(), slot, generation, value)
        .def("texture", get<&Drawing::texture>(), slot, generation)
        .def("set_texture", set<&Drawing::texture>(), slot, generation, value)
        .def("layer", get<&Drawing::layer>(), slot, generation)
        .def(
            "set_layer",
            [](SceneBox& box, std::uint32_t s, std::uint32_t g, std::int32_t layer) {
                drawing_at(box, s, g);
                set_layer(box.scene, {s, g}, layer);
            },
            slot, generation, value)
        .def("visible", get<&Drawing::visible>(), slot, generation)
        .def("set_visible", set<&Drawing::visible>(), slot, generation, value)
        .def("lit", get<&Drawing::lit>(), slot, generation)
        .def("set_lit", set<&Drawing::lit>(), slot, generation, value)
        .def("behind", get<&Drawing::behind>(), slot, generation)
        .def("set_behind", set<&Drawing::behind>(), slot, generation, value)
        .def("depth", get<&Drawing::depth>(), slot, generation)
        .def("set_depth", set<&Drawing::depth>(), slot, generation, value)
        .def("matrix", get_matrix<&Drawing::local>(), slot, generation)
        .def("set_matrix", set_matrix<&Drawing::local>(), slot, generation, value)
        .def("texture_matrix", get_matrix<&Drawing::texture_matrix>(), slot, generation)
        .def("set_texture_matrix", set_matrix<&Drawing::texture_matrix>(), slot, generation, value);
}

} // namespace evil::bind
