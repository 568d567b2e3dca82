#pragma once
// What the handles of fluids have in common.
#include "bind/handle.hpp"
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

} // namespace evil::bind
