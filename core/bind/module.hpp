#pragma once
#include <cmath>
#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>
#include <string>

namespace nb = nanobind;

namespace evil::bind {

void register_threads();
void register_world(nb::module_& module);
void register_body(nb::module_& module);
void register_shape(nb::module_& module);
void register_force(nb::module_& module);
void register_character(nb::module_& module);
void register_joint(nb::module_& module);
void register_views(nb::module_& module);
void register_math(nb::module_& module);
void register_mat4(nb::module_& module);
void register_shapes(nb::module_& module);
void register_draw_list(nb::module_& module);
void register_raster(nb::module_& module);
void register_gpu(nb::module_& module);
void register_scene(nb::module_& module);
void register_particles(nb::module_& module);
void register_light(nb::module_& module);
void register_liquid(nb::module_& module);
void register_mixer(nb::module_& module);
void register_collider(nb::module_& module);
void register_water(nb::module_& module);
void register_smoke(nb::module_& module);

} // namespace evil::bind
