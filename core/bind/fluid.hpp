#pragma once
// What the handles of fluids have in common.
#include "bind/handle.hpp"
#include "fluid/water/water.hpp"

namespace evil::bind {

using SmokeHandle = Handle<SmokeTag>;
using SourceHandle = Handle<SourceTag>;
using WaterHandle = Handle<WaterTag>;
inline const Slots& slots_of(const SmokeHandle& h) { return h.world->fluids.smoke_slots; }
inline const Slots& slots_of(const SourceHandle& h) { return h.world->fluids.source_slots; }
inline const Slots& slots_of(const WaterHandle& h) { return h.world->fluids.water_slots; }
inline const char* word_of(const SmokeHandle&) { return "Smoke"; }
inline const char* word_of(const SourceHandle&) { return "Source"; }
inline const char* word_of(const WaterHandle&) { return "Water"; }

inline fluid::Smoke& row(const SmokeHandle& h) {
    require_alive(h);
    return *h.world->fluids.smokes[h.ref.slot];
}
inline fluid::Water& row(const WaterHandle& h) {
    require_alive(h);
    return *h.world->fluids.waters[h.ref.slot];
}
inline fluid::Source& row(const SourceHandle& h) {
    require_alive(h);
    return h.world->fluids.sources[h.ref.slot];
}

} // namespace evil::bind
