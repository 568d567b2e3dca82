#pragma once
// The fluids of a world: what it knows of them. What one is, is in headers of its own, which few include.
#include "refs.hpp"
#include <memory>
#include <vector>

namespace evil {

struct World;
using SmokeRef = Ref<struct SmokeTag>;
using SourceRef = Ref<struct SourceTag>;
using WaterRef = Ref<struct WaterTag>;
using StreamRef = Ref<struct StreamTag>;

namespace fluid {
struct Smoke;
struct Source;
struct Water;
struct Stream;
} // namespace fluid

struct Fluids { // State: rows by slot
    Fluids();
    ~Fluids();
    Slots smoke_slots, source_slots, water_slots, stream_slots;
    std::vector<std::unique_ptr<fluid::Smoke>> smokes;
    std::vector<fluid::Source> sources; // of all of them
    std::vector<std::unique_ptr<fluid::Water>> waters;
    std::vector<fluid::Stream> streams; // into and out of them
    std::uint64_t next_serial = 0;
    bool any() const { return smoke_slots.count() > 0 || water_slots.count() > 0; }
};

// One step of all of them: bodies are in their way, push and are pushed, before the solver moves the bodies.
void step_fluids(World& world, float dt);

void drop_sources_of(World& world, std::uint32_t body); // a body goes, and what it carried, streams too

// For whoever saves: what was written from outside, which may be anything, is numbers again.
void settle_fluids(World& world);

} // namespace evil
