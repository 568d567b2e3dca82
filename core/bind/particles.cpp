// _core.Emitter: one emitter and its particles; evilengine.scene.particles is the face and has checked every number.
#include "particles/particles.hpp"
#include "bind/convert.hpp"
#include "bind/scene.hpp"
#include "world.hpp"
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

namespace evil::bind {
namespace {

using particles::Emitter;

using Pair = std::tuple<float, float>;

Vec2 to_vec(const Pair& pair) { return {std::get<0>(pair), std::get<1>(pair)}; }
particles::Range to_range(const Pair& pair) { return {std::get<0>(pair), std::get<1>(pair)}; }

void define(Emitter& emitter, std::optional<std::tuple<std::uint32_t, std::uint32_t>> body, Pair at, float direction,
            float cone, float rate, Pair half, float radius, Pair life, Pair speed, Pair spin, float varies,
            float gravity_scale, float drag, Pair wind, bool collides, bool dies, float bounce, float friction,
            std::uint32_t mask, std::uint32_t most) {
    particles::Definition& d = emitter.definition;
    d.body = body ? BodyRef{std::get<0>(*body), std::get<1>(*body)} : BodyRef{};
    d.at = to_vec(at), d.direction = direction, d.cone = cone, d.rate = rate;
    d.half = to_vec(half), d.radius = radius;
    d.life = to_range(life), d.speed = to_range(speed), d.spin = to_range(spin);
    d.varies = varies, d.gravity_scale = gravity_scale, d.drag = drag, d.wind = to_vec(wind);
    d.collides = collides, d.dies = dies, d.bounce = bounce, d.friction = friction, d.mask = mask, d.most = most;
}

using Knots = std::array<float, particles::kKnots>;

void show(Emitter& emitter, const Knots& size, const Knots& pace,
          const std::array<draw::Rgba8, particles::kKnots>& colour, bool soft, std::uint32_t blend, bool lit,
          float stretch, std::uint32_t texture, std::int32_t layer) {
    if (blend >= draw::kBlends) raise(ErrorKind::argument, "Emitter.show: no such blend");
    emitter.curves = {size, pace, colour};
    emitter.look = {soft ? draw::SpeckForm::soft : draw::SpeckForm::disc,
                    static_cast<draw::Blend>(blend),
                    lit,
                    stretch,
                    texture,
                    layer};
}

void collect(const Emitter& emitter, SceneBox& box, const Matrix6& view, double alpha, float dt, Pair screen) {
    const auto& looks = box.scene.looks;
    const auto own = std::ranges::find(looks, emitter.look.layer, &draw::LayerLook::layer);
    particles::collect(emitter, to_affine(view), part_of_step(alpha), dt, to_vec(screen), overlay_of(box).square,
                       own == looks.end() ? 0xffffffffu : own->tint, *box.list);
}

nb::bytes snapshot(const Emitter& emitter) {
    const std::vector<std::uint8_t> bytes = particles::snapshot(emitter.state);
    return nb::bytes(bytes.data(), bytes.size());
}

void restore(Emitter& emitter, nb::bytes data) {
    const std::span bytes(reinterpret_cast<const std::uint8_t*>(data.c_str()), data.size());
    if (!particles::restore(emitter.state, bytes, emitter.definition.most))
        raise(ErrorKind::snapshot, "these bytes are no particles of this emitter");
}

std::vector<std::tuple<float, float>> rows(const Emitter& emitter, particles::Column x, particles::Column y) {
    const auto& columns = emitter.state.columns;
    std::vector<std::tuple<float, float>> result;
    for (std::uint32_t i = 0; i < emitter.state.count; ++i) result.emplace_back(columns[x][i], columns[y][i]);
    return result;
}

} // namespace

void register_particles(nb::module_& module) {
    nb::class_<Emitter>(module, "Emitter", "Particles; evilengine.scene.particles is the face.")
        .def(nb::init<>())
        .def(
            "seed", [](Emitter& emitter, std::uint64_t seed) { emitter.state.random = seed; }, nb::arg("seed"))
        .def("define", &define, nb::kw_only(), nb::arg("body").none(), nb::arg("at"), nb::arg("direction"),
             nb::arg("cone"), nb::arg("rate"), nb::arg("half"), nb::arg("radius"), nb::arg("life"), nb::arg("speed"),
             nb::arg("spin"), nb::arg("varies"), nb::arg("gravity_scale"), nb::arg("drag"), nb::arg("wind"),
             nb::arg("collides"), nb::arg("dies"), nb::arg("bounce"), nb::arg("friction"), nb::arg("mask"),
             nb::arg("most"))
        .def("show", &show, nb::kw_only(), nb::arg("size"), nb::arg("pace"), nb::arg("colour"), nb::arg("soft"),
             nb::arg("blend"), nb::arg("lit"), nb::arg("stretch"), nb::arg("texture"), nb::arg("layer"))
        .def_rw("running", &Emitter::running)
        .def_prop_ro("count", [](const Emitter& emitter) { return emitter.state.count; })
        .def("clear", [](Emitter& emitter) { emitter.state.count = 0; })
        .def("step", &particles::step, nb::arg("world"), nb::arg("dt"))
        .def("burst", &particles::burst, nb::arg("world"), nb::arg("count"))
        .def("collect", &collect, nb::arg("scene"), nb::arg("view"), nb::arg("alpha"), nb::arg("dt"), nb::arg("screen"),
             "Put them into the frame that the scene collected; emitters in the order of layers.")
        .def("positions", [](const Emitter& e) { return rows(e, particles::kX, particles::kY); })
        .def("velocities", [](const Emitter& e) { return rows(e, particles::kVx, particles::kVy); })
        .def("snapshot", &snapshot)
        .def("restore", &restore, nb::arg("data"));
    module.attr("KNOTS") = particles::kKnots;
}

} // namespace evil::bind
