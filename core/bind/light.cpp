// _core.Lights: the lights of a scene by slot and generation, and the light map they become. evilengine.scene.lights is
// its face; it composes the words of errors, so here they are short.
#include "bind/bytes.hpp"
#include "bind/scene.hpp"
#include "bind/visit.hpp"
#include "draw/debug_lights.hpp"
#include "draw/draw_list.hpp"
#include "draw/lit_specks.hpp"
#include "light/lighting.hpp"
#include <algorithm>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>
#include <optional>

namespace evil::bind {
namespace {

using light::Light;

struct LightsBox { // what Python holds
    light::Lights lights;
    light::Scratch scratch;
    light::Casters casters; // of the debug view
    Threads threads;
};

using Reference = std::tuple<std::uint32_t, std::uint32_t>; // slot, generation
using Pair = std::tuple<float, float>;

Light& light_at(LightsBox& box, std::uint32_t slot, std::uint32_t generation) {
    if (!box.lights.slots.alive(light::LightRef{slot, generation}))
        raise(ErrorKind::stale_reference, "this Light was destroyed; ask light.alive first");
    return box.lights.rows[slot];
}

// A property of a light: its getter, and its setter with set_ before the name.
template <auto member, class Class> void field(Class& c, const char* name) {
    using Value = std::remove_cvref_t<decltype(std::declval<Light>().*member)>;
    const auto slot = nb::arg("slot"), generation = nb::arg("generation");
    c.def(
        name, [](LightsBox& box, std::uint32_t s, std::uint32_t g) { return light_at(box, s, g).*member; }, slot,
        generation);
    c.def(("set_" + std::string(name)).c_str(),
          [](LightsBox& box, std::uint32_t s, std::uint32_t g, Value value) { light_at(box, s, g).*member = value; },
          slot, generation, nb::arg("value"));
}

light::Slide to_slide(nb::handle pixels, long width, long height, const char* who) {
    const Bytes bytes(pixels, false, who, "pixels");
    check_picture(bytes, width, height, who);
    return light::make_slide(bytes.data(), static_cast<int>(width), static_cast<int>(height));
}

std::uint32_t add_slide(LightsBox& box, nb::handle pixels, long width, long height) {
    box.lights.slides.push_back(to_slide(pixels, width, height, "Lights.add_slide"));
    return static_cast<std::uint32_t>(box.lights.slides.size() - 1);
}

void change_slide(LightsBox& box, std::uint32_t slide, nb::handle pixels, long width, long height) {
    if (slide >= box.lights.slides.size()) raise(ErrorKind::argument, "Lights.change_slide: there is no such slide");
    box.lights.slides[slide] = to_slide(pixels, width, height, "Lights.change_slide");
}

bool collect(LightsBox& box, const SceneBox& scene, World& world, const Matrix6& view, double alpha, int width,
             int height, const light::Rgb& ambient, float strength, float depth, int step, light::Quality quality,
             float bounce, bool shadows, const std::vector<std::tuple<std::uint32_t, float>>& smokes) {
    draw::DrawList& list = *scene.list;
    bool needed = draw::has_lit_specks(list), directed = false;
    for (const draw::Instance& one : list.instances)
        needed |= one.lit, directed |= one.lit && one.normals != draw::kNoTexture;
    for (std::uint32_t i = 0; i < list.interludes.liquid_count; ++i) needed |= list.interludes.liquids[i].lit;
    light::remove_orphans(box.lights, world.bodies.slots);
    light::Look look;
    look.ambient = ambient;
    look.strength = strength;
    look.depth = depth;
    look.step = step;
    look.quality = quality;
    look.bounce = bounce;
    look.on = needed, look.directed = directed, look.shadows = shadows;
    std::vector<light::Smoky> smoky;
    for (const auto& [slot, shadow] : smokes)
        if (slot < world.fluids.smoke_slots.size()) smoky.push_back({slot, shadow});
    look.smokes = smoky;
    if (needed && quality == light::Quality::high) find_colours(box.scratch.bounce, scene.scene, list, world);
    light::compute(list.light, box.scratch, box.lights, look, world, to_affine(view), part_of_step(alpha), width,
                   height, box.threads);
    draw::light_specks(list);
    return needed;
}

// How many lights are on; inks of lamps, full shadows and half shadows.
int debug(LightsBox& box, const SceneBox& scene, const World& world, const Matrix6& view, double alpha, float points,
          const std::array<draw::Rgba8, 3>& inks) {
    const Affine to_pixel = to_affine(view);
    return draw::draw_lights(
        {overlay_of(scene), world, to_pixel, part_of_step(alpha), points, {inks[0], inks[1], inks[2]}}, box.lights,
        box.casters);
}

// For a restore: `slots` rising, each with its serial and its body's slot; `same` for lights that are there already.
std::vector<Reference> restore(LightsBox& box, const World& world, const std::vector<std::uint32_t>& slots,
                               const std::vector<std::uint64_t>& serials, const std::vector<std::uint32_t>& bodies,
                               std::uint64_t next_serial) {
    std::vector<bool> taken, same;
    std::vector<Light> rows;
    for (std::size_t i = 0; i < slots.size(); ++i) {
        const std::uint32_t slot = slots[i];
        taken.resize(slot + 1, false), same.resize(slot + 1, false), rows.resize(slot + 1);
        Light& row = rows[slot];
        row.serial = serials[i];
        if (bodies[i] != kNone) row.body = {bodies[i], world.bodies.slots.generation(bodies[i])};
        taken[slot] = true;
        same[slot] = box.lights.slots.taken(slot) && box.lights.rows[slot].serial == row.serial &&
                     box.lights.rows[slot].body == row.body;
    }
    box.lights.slots.restore(taken, same);
    rows.resize(box.lights.slots.size());
    box.lights.rows = std::move(rows);
    box.lights.next_serial = next_serial;
    std::vector<Reference> references;
    for (const std::uint32_t slot : slots) references.emplace_back(slot, box.lights.slots.generation(slot));
    return references;
}

std::uint16_t to_half(std::uint32_t factor) { // of 13 bits, 4096 for one: a float of 16 bits, rounded down
    if (factor == 0) return 0;
    int exponent = 12;
    while (!(factor >> 12)) factor <<= 1, --exponent;
    return static_cast<std::uint16_t>((exponent + 3) << 10 | (factor >> 2 & 1023));
}

// A plane of the light map for a graphics card: rows of r, g, b, 1 as floats of 16 bits.
nb::bytes halves(const std::vector<light::Factors>& texels) {
    std::vector<std::uint16_t> values;
    values.reserve(4 * texels.size());
    for (const light::Factors f : texels) {
        for (int place = 2; place >= 0; --place)
            values.push_back(
                to_half(static_cast<std::uint32_t>(f >> place * light::kFactorApart & light::kFactorMask)));
        values.push_back(0x3c00);
    }
    return nb::bytes(values.data(), values.size() * sizeof(std::uint16_t));
}

} // namespace

void register_light(nb::module_& module) {
    const auto slot = nb::arg("slot"), generation = nb::arg("generation");
    nb::enum_<light::Reach>(module, "Reach", "Where a light shines to.")
        .value("round", light::Reach::round)
        .value("cone", light::Reach::cone)
        .value("parallel", light::Reach::parallel);
    nb::enum_<light::Quality>(module, "Quality", "How light is worked out.")
        .value("low", light::Quality::low)
        .value("medium", light::Quality::medium)
        .value("high", light::Quality::high);
    nb::class_<LightsBox> c(module, "Lights", "Lights by slot and generation; evilengine.scene.lights is the face.");
    c.def(nb::init<>());
    c.def_prop_rw(
        "threads", [](const LightsBox& box) { return box.threads.count(); },
        [](LightsBox& box, int count) { box.threads.set_count(count); },
        "How many threads may work out a frame's light. The bits are the same with any number.");
    c.def("__len__", [](const LightsBox& box) { return box.lights.slots.count(); });
    c.def(
        "add",
        [](LightsBox& box, std::optional<Reference> body) {
            Light light;
            if (body) light.body = {std::get<0>(*body), std::get<1>(*body)};
            const light::LightRef ref = add(box.lights, light);
            return Reference{ref.slot, ref.generation};
        },
        nb::arg("body") = nb::none(), "A new light, on a body's slot and generation or by itself.");
    c.def(
        "remove",
        [](LightsBox& box, std::uint32_t s, std::uint32_t g) {
            light_at(box, s, g);
            box.lights.slots.release(s);
        },
        slot, generation);
    c.def(
        "alive",
        [](const LightsBox& box, std::uint32_t s, std::uint32_t g) {
            return box.lights.slots.alive(light::LightRef{s, g});
        },
        slot, generation);
    c.def(
        "slots",
        [](const LightsBox& box) {
            std::vector<std::uint32_t> taken;
            for (std::uint32_t s = 0; s < box.lights.slots.size(); ++s)
                if (box.lights.slots.taken(s)) taken.push_back(s);
            return taken;
        },
        "The slots that hold a light, rising.");
    c.def("generation", [](const LightsBox& box, std::uint32_t s) { return box.lights.slots.generation(s); }, slot);
    c.def_prop_ro("next_serial", [](const LightsBox& box) { return box.lights.next_serial; });
    c.def(
        "serial", [](LightsBox& box, std::uint32_t s, std::uint32_t g) { return light_at(box, s, g).serial; }, slot,
        generation);
    c.def(
        "body",
        [](LightsBox& box, std::uint32_t s, std::uint32_t g) -> std::optional<Reference> {
            const BodyRef body = light_at(box, s, g).body;
            if (body.slot == kNone) return std::nullopt;
            return Reference{body.slot, body.generation};
        },
        slot, generation);
    c.def(
        "at",
        [](LightsBox& box, std::uint32_t s, std::uint32_t g) {
            const Vec2 at = light_at(box, s, g).at;
            return Pair{at.x, at.y};
        },
        slot, generation);
    c.def(
        "set_at",
        [](LightsBox& box, std::uint32_t s, std::uint32_t g, Pair at) {
            light_at(box, s, g).at = {std::get<0>(at), std::get<1>(at)};
        },
        slot, generation, nb::arg("value"));
    field<&Light::reach>(c, "reach");
    field<&Light::angle>(c, "angle");
    field<&Light::cone>(c, "cone");
    field<&Light::edge>(c, "edge");
    field<&Light::radius>(c, "radius");
    field<&Light::size>(c, "size");
    field<&Light::falloff>(c, "falloff");
    field<&Light::intensity>(c, "intensity");
    field<&Light::colour>(c, "colour");
    field<&Light::temperature>(c, "temperature");
    field<&Light::tint>(c, "tint");
    field<&Light::mask>(c, "mask");
    field<&Light::on>(c, "on");
    field<&Light::shadows>(c, "shadows");
    field<&Light::slide>(c, "slide");
    field<&Light::still>(c, "still");
    c.def("add_slide", &add_slide, nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
          "A picture of straight r, g, b, a that lights may shine through; its number.");
    c.def("change_slide", &change_slide, nb::arg("slide"), nb::arg("pixels"), nb::arg("width"), nb::arg("height"),
          "Another picture in its place.");
    c.def("restore", &restore, nb::arg("world"), nb::arg("slots"), nb::arg("serials"), nb::arg("bodies"),
          nb::arg("next_serial"), "Become lights in these slots, as new ones are; their references.");
    c.def("collect", &collect, nb::arg("scene"), nb::arg("world"), nb::arg("view"), nb::arg("alpha"), nb::arg("width"),
          nb::arg("height"), nb::arg("ambient"), nb::arg("strength"), nb::arg("depth"), nb::arg("step"),
          nb::arg("quality"), nb::arg("bounce"), nb::arg("shadows"), nb::arg("smokes"),
          "Put the frame's light into the list that the scene collected; whether anything in it is lit.");
    c.def("debug", &debug, nb::arg("scene"), nb::arg("world"), nb::arg("view"), nb::arg("alpha"), nb::arg("points"),
          nb::arg("inks"),
          "Put lights and the edges of shadows on top of the collected frame; how many lights are on.");
    module.def(
        "light_map",
        [](const draw::DrawList& list)
            -> std::optional<std::tuple<int, int, float, float, float, std::vector<nb::bytes>>> {
            const light::LightMap& map = list.light;
            if (!map.on) return std::nullopt;
            std::vector<nb::bytes> planes{halves(map.texels)};
            if (map.directed) planes.push_back(halves(map.across)), planes.push_back(halves(map.down));
            return std::tuple(map.width, map.height, map.step, map.first.x, map.first.y, std::move(planes));
        },
        nb::arg("list"),
        "Width, height, pixels a texel, where in the picture the first one's middle lies, and planes of texels, r, g, "
        "b, 1 as floats of 16 bits: the light, and where something has normals its ways across and down; None where "
        "nothing is lit.");
}

} // namespace evil::bind
