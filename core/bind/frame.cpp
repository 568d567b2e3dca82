// _core.Scene, continued: what of a scene becomes a frame, and what is put between and over its drawings.
#include "bind/scene.hpp"
#include "bind/visit.hpp"
#include "draw/debug.hpp"
#include "draw/debug_fluids.hpp"
#include <array>
#include <cstring>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace evil::bind {
namespace {

using namespace draw;

constexpr std::uint32_t kMostLists = 64;

std::shared_ptr<DrawList> collect_frame(SceneBox& box, const World& world, const Matrix6& view, double alpha,
                                        float points) {
    const float part = part_of_step(alpha);
    const double now = static_cast<double>(world.steps) + static_cast<double>(part) - 1.0;
    collect(box.scene, world.poses(), world.shapes, to_affine(view), part, now, points, *box.list);
    box.overlay.emplace(begin_overlay(*box.list));
    return box.list;
}

// What follows fills that list; there may be one for each view of the scene.
void aim(SceneBox& box, std::uint32_t number) {
    if (number >= kMostLists) raise(ErrorKind::argument, "Scene.aim: there are not so many lists");
    while (box.lists.size() <= number) box.lists.push_back(std::make_shared<DrawList>());
    box.list = box.lists[number];
    box.overlay.reset();
}

// A frame of nothing, for what lies over several views.
std::shared_ptr<DrawList> begin_empty(SceneBox& box) {
    clear(*box.list);
    box.overlay.emplace(begin_overlay(*box.list));
    return box.list;
}

using Counts = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

Counts debug_frame(SceneBox& box, const World& world, const Matrix6& view, double alpha, float points,
                   const decltype(DebugLook::inks)& inks, const decltype(DebugLook::parts)& parts) {
    const Affine to_pixel = to_affine(view);
    const DebugLook look{inks, parts, points};
    const DebugCount count = draw_debug({overlay_of(box), world, to_pixel, part_of_step(alpha), look});
    return {count.bodies, count.asleep, count.contacts, count.joints, count.islands};
}

std::tuple<std::uint32_t, std::uint32_t, float, float>
debug_fluids(SceneBox& box, const World& world, const Matrix6& view, const std::tuple<float, float>& screen,
             float points, const decltype(FluidFrame::inks)& inks, const decltype(FluidFrame::parts)& parts) {
    const Affine to_pixel = to_affine(view);
    const Vec2 size{std::get<0>(screen), std::get<1>(screen)};
    const FluidScale scale = draw_fluids({overlay_of(box), world, to_pixel, size, points, parts, inks});
    return {scale.fluids, scale.particles, scale.speed, scale.divergence};
}

void add_glyphs(SceneBox& box, nb::bytes boxes, float x, float y, std::uint32_t texture, Rgba8 colour) {
    static_assert(sizeof(Glyph) == 8 * sizeof(float));
    if (boxes.size() % sizeof(Glyph) != 0)
        raise(ErrorKind::argument, "Scene.glyphs: boxes must hold eight float32 for each glyph");
    box.glyphs.resize(boxes.size() / sizeof(Glyph));
    std::memcpy(box.glyphs.data(), boxes.c_str(), boxes.size());
    glyphs(overlay_of(box), box.glyphs, {x, y}, texture, colour);
}

void set_layers(SceneBox& box, const std::vector<std::tuple<std::int32_t, Matrix6, Rgba8, bool>>& layers,
                const std::optional<std::tuple<float, float, float>>& perspective) {
    box.scene.perspective = {};
    if (perspective) {
        const auto [x, y, per_metre] = *perspective;
        box.scene.perspective = {true, {x, y}, per_metre};
    }
    box.scene.looks.clear();
    for (const auto& [layer, matrix, tint, visible] : layers)
        box.scene.looks.push_back({layer, to_affine(matrix), tint, visible});
}

void add_post(SceneBox& box, float bloom, float threshold, float saturation, float vignette, float grain,
              std::uint32_t seed, float exposure, float contrast, bool filmic,
              const std::tuple<float, float, float>& tint) {
    Post& post = box.list->interludes.post;
    const Grading grading{exposure, contrast, filmic, {std::get<0>(tint), std::get<1>(tint), std::get<2>(tint)}};
    if (!(post.grading == grading) || !post.graded) grade(post, grading);
    post.bloom = bloom, post.threshold = threshold, post.saturation = saturation;
    post.vignette = vignette, post.grain = grain, post.seed = seed;
    Interlude interlude;
    interlude.before = static_cast<std::uint32_t>(box.list->instances.size());
    interlude.kind = InterludeKind::post;
    box.list->interludes.rows.push_back(interlude);
}

} // namespace

void register_frame(nb::class_<SceneBox>& scene) {
    const auto world = nb::arg("world"), view = nb::arg("view"), alpha = nb::arg("alpha"), points = nb::arg("points");
    scene
        .def("set_layers", &set_layers, nb::arg("layers"), nb::arg("perspective") = nb::none(),
             "How layers are seen that are not seen as the world is: (layer, matrix, tint, visible), by layer. "
             "In perspective, the picture's middle and one over the distance of the eye in metres.")
        .def(
            "fog",
            [](SceneBox& box, std::int32_t layer, Rgba8 top, Rgba8 bottom, float width, float height, bool lit) {
                add_fog(*box.list, layer, top, bottom, {width, height}, lit);
            },
            nb::arg("layer"), nb::arg("top"), nb::arg("bottom"), nb::arg("width"), nb::arg("height"), nb::arg("lit"))
        .def(
            "shafts",
            [](SceneBox& box, std::int32_t layer, float x, float y, Rgba8 colour, float strength, float reach,
               float threshold) { add_shafts(*box.list, layer, {{x, y}, colour, strength, reach, threshold}); },
            nb::arg("layer"), nb::arg("x"), nb::arg("y"), nb::arg("colour"), nb::arg("strength"), nb::arg("reach"),
            nb::arg("threshold"))
        .def(
            "blur", [](SceneBox& box, std::int32_t layer, float radius) { add_blur(*box.list, layer, radius); },
            nb::arg("layer"), nb::arg("radius"))
        .def("post", &add_post, nb::kw_only(), nb::arg("bloom"), nb::arg("threshold"), nb::arg("saturation"),
             nb::arg("vignette"), nb::arg("grain"), nb::arg("seed"), nb::arg("exposure"), nb::arg("contrast"),
             nb::arg("filmic"), nb::arg("tint"), "What is done to all that the frame has so far.")
        .def("collect", &collect_frame, world, view, alpha, points,
             "The frame at alpha (0..1) between the last two steps; good until the next one.")
        .def("aim", &aim, nb::arg("number"), "What follows fills the list of that number, from 0 on.")
        .def("empty", &begin_empty, "A frame without drawings, for what lies over several views.")
        .def("debug", &debug_frame, world, view, alpha, points, nb::arg("inks"), nb::arg("parts"),
             "Put the debug view on top of the collected frame; the numbers of bodies, sleepers, contacts, joints, "
             "islands.")
        .def(
            "debug_fluids", &debug_fluids, world, view, nb::arg("screen"), points, nb::arg("inks"), nb::arg("parts"),
            "Put the debug view of fluids on top; how many there are, and of water's particles, the m/s of the longest "
            "arrows, and the 1/s of full colours.")
        .def(
            "arrow",
            [](SceneBox& box, float x1, float y1, float x2, float y2, float width, Rgba8 colour) {
                arrow(overlay_of(box), {x1, y1}, {x2, y2}, width, colour);
            },
            nb::arg("x1"), nb::arg("y1"), nb::arg("x2"), nb::arg("y2"), nb::arg("width"), nb::arg("colour"))
        .def(
            "disc",
            [](SceneBox& box, float x, float y, float radius, Rgba8 colour) {
                disc(overlay_of(box), {x, y}, radius, colour);
            },
            nb::arg("x"), nb::arg("y"), nb::arg("radius"), nb::arg("colour"))
        .def(
            "box",
            [](SceneBox& box, float left, float top, float right, float bottom, Rgba8 colour) {
                draw::box(overlay_of(box), {left, top}, {right, bottom}, colour);
            },
            nb::arg("left"), nb::arg("top"), nb::arg("right"), nb::arg("bottom"), nb::arg("colour"))
        .def("glyphs", &add_glyphs, nb::arg("boxes"), nb::arg("x"), nb::arg("y"), nb::arg("texture"), nb::arg("colour"),
             "A row of textured boxes on top: eight float32 each, left top right bottom in pixels and in the texture.");
}

} // namespace evil::bind
