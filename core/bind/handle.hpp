#pragma once
// What the handles of Python have in common: a world that they keep alive, a reference into it, and what they were.
#include "bind/visit.hpp"
#include <memory>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/vector.h>

namespace evil::bind {

template <class Tag> struct Handle {
    std::shared_ptr<World> world;
    Ref<Tag> ref;
    std::uint64_t born = 0, died = 0;
    bool buried = false; // died is known
    std::string tag;
};
using BodyHandle = Handle<BodyTag>;
using ShapeHandle = Handle<ShapeTag>;
using ForceHandle = Handle<ForceTag>;
using JointHandle = Handle<JointTag>;

template <class Tag> Door* door_of(const Handle<Tag>& h) { return h.world ? &h.world->door : nullptr; }

inline const Slots& slots_of(const BodyHandle& h) { return h.world->bodies.slots; }
inline const Slots& slots_of(const ShapeHandle& h) { return h.world->shapes.slots; }
inline const Slots& slots_of(const ForceHandle& h) { return h.world->forces.slots; }
inline const Slots& slots_of(const JointHandle& h) { return h.world->joints.slots; }
inline const char* word_of(const BodyHandle&) { return "Body"; }
inline const char* word_of(const ShapeHandle&) { return "Shape"; }
inline const char* word_of(const ForceHandle&) { return "Force"; }
inline const char* word_of(const JointHandle&) { return "Joint"; }

template <class H> bool alive(const H& h) { return h.world && slots_of(h).alive(h.ref); }

template <class H> [[noreturn]] void raise_stale(const H& h) {
    std::string word = word_of(h), lower = word;
    lower[0] = static_cast<char>(lower[0] + ('a' - 'A'));
    std::string text = "this " + word + " (";
    if (!h.tag.empty()) text += "tag \"" + h.tag + "\", ";
    text += "added at step " + std::to_string(h.born) + ") ";
    text += h.buried ? "was destroyed at step " + std::to_string(h.died)
                     : "is gone: the world was restored to a snapshot without it";
    raise(ErrorKind::stale_reference, text + "; keep no reference past destroy(), or ask " + lower + ".alive first");
}

template <class H> void require_alive(const H& h) {
    if (!alive(h)) raise_stale(h);
}
inline Body& row(const BodyHandle& h) {
    require_alive(h);
    return h.world->bodies.rows[h.ref.slot];
}
inline Shape& row(const ShapeHandle& h) {
    require_alive(h);
    return h.world->shapes.rows[h.ref.slot];
}
inline Force& row(const ForceHandle& h) {
    require_alive(h);
    return h.world->forces.rows[h.ref.slot];
}
inline Joint& row(const JointHandle& h) {
    require_alive(h);
    return h.world->joints.rows[h.ref.slot];
}

// A number in [least, most].
inline float in_range(nb::handle value, const char* owner, const char* argument, float least, float most) {
    float number = to_float(value, owner, argument);
    if (number < least || number > most) {
        char allowed[64];
        std::snprintf(allowed, sizeof allowed, "from %g to %g", double(least), double(most));
        raise(ErrorKind::argument, std::string(owner) + ": " + argument + "=" + nb::cast<std::string>(nb::repr(value)) +
                                       " must be " + allowed);
    }
    return number;
}

[[noreturn]] void raise_mass(MassProblem problem, const char* owner);
[[noreturn]] void raise_matrix(MatrixProblem problem, const char* owner);
Affine to_affine(nb::handle matrix, const char* owner); // from 16 floats, column-major, that move only x and y
using Floats = nb::typed<nb::tuple, float, nb::ellipsis>;
using Anything = nb::typed<nb::tuple, nb::any, nb::ellipsis>;
Floats from_affine(const Affine& m); // the same 16 floats

// The handle's own words: equality, hash, alive, and the slot and generation that make it what it is.
template <class H> void bind_identity(nb::class_<H>& c) {
    c.def_prop_ro("alive", [](const H& h) { return alive(h); }, "False once it was destroyed, or restored away.");
    c.def_prop_ro("slot", [](const H& h) { return h.ref.slot; }, "Row of this object in the world's arrays.");
    c.def_prop_ro(
        "generation", [](const H& h) { return h.ref.generation; }, "How often that row has been taken and freed.");
    c.def(
        "__eq__",
        [](const H& h, nb::handle other) {
            if (!nb::isinstance<H>(other) || !nb::inst_ready(other)) return false;
            const H& o =
                *nb::inst_ptr<H>(other); // without going into its world, where another thread may wait for ours
            return o.world == h.world && o.ref == h.ref;
        },
        nb::arg("other").none(), nb::sig("def __eq__(self, other: object, /) -> bool"));
    c.def("__hash__", [](const H& h) {
        auto where = reinterpret_cast<std::uintptr_t>(h.world.get());
        return static_cast<Py_hash_t>((std::uint64_t{h.ref.slot} << 32 ^ h.ref.generation ^ (where >> 4)) &
                                      0x3fffffffffffffffu);
    });
    c.def("_bury", [](H& h, std::uint64_t step) { h.died = step, h.buried = true; });
}

} // namespace evil::bind
