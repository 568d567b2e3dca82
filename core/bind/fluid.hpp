#pragma once
// What the handles of fluids have in common.
#include "bind/handle.hpp"
#include "fluid/smoke.hpp"

namespace evil::bind {

using SmokeHandle = Handle<SmokeTag>;
using SourceHandle = Handle<SourceTag>;
inline const Slots& slots_of(const SmokeHandle& h) { return h.world->fluids.smoke_slots; }
inline const Slots& slots_of(const SourceHandle& h) { return h.world->fluids.source_slots; }
inline const char* word_of(const SmokeHandle&) { return "Smoke"; }
inline const char* word_of(const SourceHandle&) { return "Source"; }

inline fluid::Smoke& row(const SmokeHandle& h) {
    require_alive(h);
    return *h.world->fluids.smokes[h.ref.slot];
}
inline fluid::Source& row(const SourceHandle& h) {
    require_alive(h);
    return h.world->fluids.sources[h.ref.slot];
}

} // namespace evil::bind
