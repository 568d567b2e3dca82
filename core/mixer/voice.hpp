#pragma once
// One sound that is being played.
#include "mixer/command.hpp"
#include "mixer/ramp.hpp"
#include "mixer/resampler.hpp"

namespace evil::mixer {

inline constexpr int kChunk = 128; // frames mixed at once: what fits the first-level cache with all its rows
inline constexpr int kLongestWindow = kChunk * 8 + kMostTaps + 8; // source frames behind a chunk at the highest speed

// Rows that voices work in; nothing in them outlives a chunk.
struct Scratch {
    std::array<std::int32_t, kChunk> first_tap{};
    std::array<std::uint32_t, kChunk> fraction{};
    std::array<float, kLongestWindow> window{};
    std::array<float, kChunk> row{}, other{};
};

struct Voice {
    std::uint32_t serial = 0; // 0: free
    std::uint8_t group = 0;
    const Sample* sample = nullptr;
    Stream* stream = nullptr;
    std::uint64_t position = 0; // source frames, 32.32 fixed point; goes on counting through loops
    std::uint32_t loop_begin = 0, loop_end = 0;

    std::int64_t speed = 0, speed_step = 0, speed_target = 0; // source frames a mixed frame
    std::int32_t speed_left = 0;
    int kernel = 0, old_kernel = 0; // the old one fades away over the frames of `change`
    Ramp change;

    std::array<Ramp, 4> gains;
    Fade fade;
    bool ending = false; // the voice is free when the fade is over
    Fade supply;         // of a stream that ran dry: it fades out before the end of what there is, and in again
};

// Take up what the command says; `now` nothing is heard of it yet.
void start(Voice& voice, const Command& command);
void set_gains(Voice& voice, const Command& command);
void set_speed(Voice& voice, const Command& command);
void stop(Voice& voice, const Command& command);

// Add the next `count` frames (at most kChunk) to left and right, and move on. False when the voice has ended.
bool play(Voice& voice, const Kernels& kernels, Scratch& scratch, int count, float* left, float* right,
          InstructionSet set) noexcept;

} // namespace evil::mixer
