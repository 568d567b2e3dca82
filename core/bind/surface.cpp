// What a drawing's surface does with light: the part of _core.Scene that evilengine.scene.surface is the face of.
#include "bind/scene.hpp"
#include "bind/visit.hpp"
#include <nanobind/stl/tuple.h>

namespace evil::bind {

void bind_surfaces(nb::class_<SceneBox>& c) {
    const auto slot = nb::arg("slot"), generation = nb::arg("generation");
    c.def(
        "glow", [](SceneBox& box, std::uint32_t s, std::uint32_t g) { return drawing_at(box, s, g).glow; }, slot,
        generation, "How strongly it shines by itself; below 0: as its picture says.");
    c.def(
        "set_glow",
        [](SceneBox& box, std::uint32_t s, std::uint32_t g, float glow) { drawing_at(box, s, g).glow = glow; }, slot,
        generation, nb::arg("value"));
    c.def(
        "surface",
        [](SceneBox& box, std::uint32_t s, std::uint32_t g) {
            const draw::Surface& surface = drawing_at(box, s, g).surface;
            return std::tuple(surface.normals, surface.glows);
        },
        slot, generation, "Its pictures of normals and of what glows; 0: those of the picture that it shows.");
    c.def(
        "set_surface",
        [](SceneBox& box, std::uint32_t s, std::uint32_t g, std::uint32_t normals, std::uint32_t glows) {
            drawing_at(box, s, g).surface = {normals, glows};
        },
        slot, generation, nb::arg("normals"), nb::arg("glows"));
    c.def(
        "set_surface_of",
        [](SceneBox& box, std::uint32_t texture, std::uint32_t normals, std::uint32_t glows) {
            if (texture >= box.scene.surfaces.size()) box.scene.surfaces.resize(texture + 1);
            box.scene.surfaces[texture] = {normals, glows};
        },
        nb::arg("texture"), nb::arg("normals"), nb::arg("glows"), "What goes with a picture wherever it is shown.");
}

} // namespace evil::bind
