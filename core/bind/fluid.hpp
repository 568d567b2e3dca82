#pragma once
// What the handles of fluids have in common.
#include "bind/handle.hpp"
#include "bind/values.hpp"
#include "fluid/smoke.hpp"
#include "fluid/water/water.hpp"
#include <nanobind/stl/tuple.h>

namespace evil::bind {

using SmokeHandle = Handle<SmokeTag>;
using SourceHandle = Handle<SourceTag>;
using WaterHandle = Handle<WaterTag>;
using StreamHandle = Handle<StreamTag>;
inline const Slots& slots_of(const SmokeHandle& h) { return h.world->fluids.smoke_slots; }
inline const Slots& slots_of(const SourceHandle& h) { return h.world->fluids.source_slots; }
inline const Slots& slots_of(const WaterHandle& h) { return h.world->fluids.water_slots; }
inline const Slots& slots_of(const StreamHandle& h) { return h.world->fluids.stream_slots; }
inline const char* word_of(const SmokeHandle&) { return "Smoke"; }
inline const char* word_of(const SourceHandle&) { return "Source"; }
inline const char* word_of(const WaterHandle&) { return "Water"; }
inline const char* word_of(const StreamHandle&) { return "Stream"; }

inline fluid::Smoke& row(const SmokeHandle& h) {
    require_alive(h);
    return *h.world->fluids.smokes[h.ref.slot];
}
inline fluid::Water& row(const WaterHandle& h) {
    require_alive(h);
    return *h.world->fluids.waters[h.ref.slot];
}
inline fluid::Stream& row(const StreamHandle& h) {
    require_alive(h);
    return h.world->fluids.streams[h.ref.slot];
}
inline fluid::Source& row(const SourceHandle& h) {
    require_alive(h);
    return h.world->fluids.sources[h.ref.slot];
}

using Three = std::tuple<float, float, float>;
inline fluid::Colour to_colour(const Three& c) { return {std::get<0>(c), std::get<1>(c), std::get<2>(c)}; }
inline Three from_colour(const fluid::Colour& c) { return {c.r, c.g, c.b}; }

Area area_of(const NewShape& spec, nb::handle at, double angle); // in bind/force.cpp

// What is in use of a table, by its slots.
inline std::vector<std::uint32_t> taken_slots(const Slots& slots) {
    std::vector<std::uint32_t> list;
    for (std::uint32_t i = 0; i < slots.size(); ++i)
        if (slots.taken(i)) list.push_back(i);
    return list;
}

template <class H> void bind_handle(nb::class_<H>& c) {
    c.def("__init__", [](H* self, std::shared_ptr<World> world, std::uint32_t slot) {
        new (self) H;
        self->world = std::move(world);
        self->ref = {slot, slots_of(*self).size() > slot ? slots_of(*self).generation(slot) : 0u};
        self->born = row(*self).born;
    });
    bind_identity(c);
}

// Those of a table's rows that belong to something in a slot.
template <class Row>
std::vector<std::uint32_t> slots_of_owner(const Slots& slots, const std::vector<Row>& rows, std::uint32_t Row::* owner,
                                          std::uint32_t slot) {
    std::vector<std::uint32_t> list = taken_slots(slots);
    std::erase_if(list, [&](std::uint32_t i) { return rows[i].*owner != slot; });
    return list;
}

// A velocity that gas and liquid may have.
inline Vec2 to_flow(nb::handle value, const char* owner, const char* name) {
    const Vec2 wanted = to_vec2(value, owner, name);
    if (length(wanted) > 1e4f)
        raise(ErrorKind::argument, std::string(owner) + ": " + name + " must be at most 1e4 m/s");
    return wanted;
}

template <class H> void bind_destroy(nb::class_<H>& c, void (*destroy)(World&, std::uint32_t)) {
    c.def("_destroy", [destroy](H& h) {
        require_alive(h);
        h.died = h.world->steps, h.buried = true;
        destroy(*h.world, h.ref.slot);
    });
}

// What sources and streams have in common.
template <class H> void bind_flow(nb::class_<H>& c, const char* owner, const char* running) {
    def_value(
        c, "running", kSwitch, [](const H& h) { return row(h).running; },
        [owner](const H& h, nb::handle value) {
            const bool wanted = to_bool(value, owner, "running");
            row(h).running = wanted;
        },
        running);
    c.def_prop_ro("_body", [](const H& h) { return row(h).body; });
}

} // namespace evil::bind
