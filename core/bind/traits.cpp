// How bodies and shapes deal with those they meet: filters, sensors, one-way platforms, belts.
#include "bind/traits.hpp"

namespace evil::bind {
namespace {

constexpr float kMaxSurfaceSpeed = 1e4f; // m/s

long long to_whole(nb::handle value, const char* owner, const char* name, long long least, long long most,
                   const char* what) {
    std::string asked = std::string(owner) + ": " + name + "=" + nb::cast<std::string>(nb::repr(value));
    if (!PyLong_Check(value.ptr()) || PyBool_Check(value.ptr()))
        raise(ErrorKind::argument_type, asked + " must be a whole number: " + what);
    int beyond = 0;
    long long number = PyLong_AsLongLongAndOverflow(value.ptr(), &beyond);
    if (beyond != 0 || number < least || number > most)
        raise(ErrorKind::argument,
              asked + " must be from " + std::to_string(least) + " to " + std::to_string(most) + ": " + what);
    return number;
}

Vec2 to_side(nb::handle value, const char* owner) {
    if (value.is_none() || value.is(Py_False)) return {};
    if (value.is(Py_True)) return {0, 1};
    Vec2 side = normalised(to_vec2(value, owner, "one_way"));
    if (side == Vec2{})
        raise(ErrorKind::argument, std::string(owner) + ": one_way=" + nb::cast<std::string>(nb::repr(value)) +
                                       " must be a direction such as (0, 1), True for above, or None");
    return side;
}

// Each trait: its name, the value it takes from Python, and that value from one thing to another.
template <auto Value> void copy(const Traits& from, Traits& to) { to.*Value = from.*Value; }
struct Trait {
    const char* name;
    void (*copy)(const Traits& from, Traits& to);
    void (*set)(Traits& traits, nb::handle value, const char* owner);
};

constexpr Trait kCategory{
    "category", copy<&Traits::category>, [](Traits& t, nb::handle value, const char* owner) {
        t.category = static_cast<std::uint32_t>(
            to_whole(value, owner, "category", 1, 0xffffffffll, "each bit is a category, such as 1, 2, 4 or 1 << 3"));
    }};
constexpr Trait kMask{"mask", copy<&Traits::mask>, [](Traits& t, nb::handle value, const char* owner) {
                          t.mask = static_cast<std::uint32_t>(to_whole(
                              value, owner, "mask", 0, 0xffffffffll, "the bits of the categories it meets, as 2 | 4"));
                      }};
constexpr Trait kGroup{"group", copy<&Traits::group>, [](Traits& t, nb::handle value, const char* owner) {
                           t.group = static_cast<std::int32_t>(
                               to_whole(value, owner, "group", -0x80000000ll, 0x7fffffffll,
                                        "0 for none, positive to meet always, negative never"));
                       }};
constexpr Trait kSensor{"sensor", copy<&Traits::sensor>, [](Traits& t, nb::handle value, const char* owner) {
                            t.sensor = to_bool(value, owner, "sensor");
                        }};
constexpr Trait kOneWay{"one_way", copy<&Traits::one_way>,
                        [](Traits& t, nb::handle value, const char* owner) { t.one_way = to_side(value, owner); }};
constexpr Trait kSurfaceSpeed{
    "surface_speed", copy<&Traits::surface_speed>, [](Traits& t, nb::handle value, const char* owner) {
        t.surface_speed = in_range(value, owner, "surface_speed", -kMaxSurfaceSpeed, kMaxSurfaceSpeed);
    }};
constexpr const Trait* kTraits[] = {&kCategory, &kMask, &kGroup, &kSensor, &kOneWay, &kSurfaceSpeed};

const Traits& traits_of(const BodyHandle& h) {
    require_alive(h);
    return h.world->bodies.traits[h.ref.slot];
}
const Traits& traits_of(const ShapeHandle& h) { return row(h).traits; }

void change(const BodyHandle& h, const Trait& trait, nb::handle value) {
    Traits own = traits_of(h);
    trait.set(own, value, "Body"); // refuses before anything has changed
    World& world = *h.world;
    std::uint32_t first = row(h).first_shape; // reading the value may have run Python, which may have destroyed it
    world.bodies.traits[h.ref.slot] = own;
    for (std::uint32_t s = first; s != kNone; s = world.shapes.rows[s].next) {
        Traits traits = world.shapes.rows[s].traits;
        trait.copy(own, traits);
        set_traits(world, s, traits);
    }
}

void change(const ShapeHandle& h, const Trait& trait, nb::handle value) {
    Traits traits = traits_of(h);
    trait.set(traits, value, "Shape");
    require_alive(h);
    set_traits(*h.world, h.ref.slot, traits);
}

template <class H, class Get>
void bind_trait(nb::class_<H>& c, const Trait& trait, const char* type, Get get, const char* doc) {
    def_value(
        c, trait.name, type, [get](const H& h) { return get(traits_of(h)); },
        [&trait](const H& h, nb::handle value) { change(h, trait, value); }, doc);
}

template <class H> void bind_all(nb::class_<H>& c) {
    bind_trait(
        c, kCategory, "int", [](const Traits& t) { return t.category; },
        "What it is, as bits of a number: 1 at first. See `mask`.");
    bind_trait(
        c, kMask, "int", [](const Traits& t) { return t.mask; },
        "What it meets, as bits: two meet if the category of each has a bit of the other's mask. evil.ALL at first.");
    bind_trait(
        c, kGroup, "int", [](const Traits& t) { return t.group; },
        "Two in the same group, not 0, meet whatever the masks say if it is positive, and never if it is negative.");
    bind_trait(
        c, kSensor, kSwitch, [](const Traits& t) { return t.sensor; },
        "A sensor sees what overlaps it (`world.sensors`, `body.on_enter`), and neither pushes nor is pushed.");
    bind_trait(
        c, kOneWay, "evilengine.values.vec2.Point | bool | None",
        [](const Traits& t) -> std::optional<PyVec2> {
            if (t.one_way == Vec2{}) return {};
            return from_vec2(t.one_way);
        },
        "The side from which it is solid, in the body's frame: what comes from there stands, what comes from elsewhere "
        "passes through. True means (0, 1), above; None, at first, solid from everywhere.");
    bind_trait(
        c, kSurfaceSpeed, kNumber, [](const Traits& t) { return t.surface_speed; },
        "Metres a second at which its surface runs round it, clockwise: on top to the right. Friction hands it on.");
}

} // namespace

Traits to_traits(nb::dict words, const char* owner, Traits traits) {
    for (auto [name, value] : words)
        for (const Trait* trait : kTraits)
            if (!value.is_none() && nb::cast<std::string>(name) == trait->name) trait->set(traits, value, owner);
    return traits;
}

void bind_traits(nb::class_<BodyHandle>& c) { bind_all(c); }

void bind_traits(nb::class_<ShapeHandle>& c) {
    bind_all(c);
    c.def("_set_traits", [](const ShapeHandle& h, Words words) { // of a shape just added
        Traits traits = to_traits(words, "Body.add_shape", traits_of(h));
        require_alive(h);
        set_traits(*h.world, h.ref.slot, traits);
    });
}

} // namespace evil::bind
