#pragma once
// Any instance of a draw list as quads.
#include "gpu/batches.hpp"

namespace evil::gpu {

struct Context { // of one frame
    Frame& frame;
    const Shapes& shapes;
    Scratch& scratch;
    const draw::DrawList& list;
    const Pictures& pictures;
    Bounds target;
};

// The picture of that id, if it is still held.
std::uint32_t held(const Context& context, std::uint32_t texture);

// Adds its quads to the frame's last batch, or begins a batch for them.
void put_instance(Context& context, const draw::Instance& instance);

} // namespace evil::gpu
