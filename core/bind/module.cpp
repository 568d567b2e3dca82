// The Python extension module: one register function for each subject.
#include "bind/module.hpp"
#include "bind/convert.hpp"

NB_MODULE(_core, module) {
    module.doc() = "EvilEngine's C++ core. Use evilengine, its public face.";
    // A script that ends with a ball in a global variable has leaked nothing that matters; say so only to developers.
#ifdef NDEBUG
    nb::set_leak_warnings(false);
#endif
    evil::bind::load_python_types();
    evil::bind::register_threads();
    evil::bind::register_views(module);
    evil::bind::register_shape(module);
    evil::bind::register_world(module);
    evil::bind::register_body(module);
    evil::bind::register_force(module);
    evil::bind::register_joint(module);
    evil::bind::register_character(module);
    evil::bind::register_math(module);
    evil::bind::register_mat4(module);
    evil::bind::register_shapes(module);
    evil::bind::register_draw_list(module);
    evil::bind::register_raster(module);
    evil::bind::register_gpu(module);
    evil::bind::register_scene(module);
    evil::bind::register_particles(module);
    evil::bind::register_light(module);
    evil::bind::register_liquid(module);
    evil::bind::register_mixer(module);
    evil::bind::register_collider(module);
    evil::bind::register_smoke(module);
    evil::bind::register_water(module);
}
