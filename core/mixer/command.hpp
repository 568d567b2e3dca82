#pragma once
// What the game tells the mixer, and hears back.
#include "mixer/sound.hpp"
#include <array>
#include <cstdint>

namespace evil::mixer {

inline constexpr int kVoices = 256; // sounds at once
inline constexpr int kGroups = 16;  // number 0 is the master, which the others go through

// A voice and which of its sounds is meant: commands for one that has ended do nothing.
struct VoiceRef {
    std::uint32_t slot = 0, serial = 0; // serial 0: none
    friend bool operator==(VoiceRef, VoiceRef) = default;
};

// Amplitudes from the source's left and right to the mix's: left to left, left to right, right to left, right to right.
// A source with one channel uses the first two.
using Gains = std::array<float, 4>;

enum class Order : std::uint8_t { start, gains, speed, stop, group_gain, group_pause };

struct Command {
    std::uint64_t when = 0; // frame of the mix; in the past: as soon as possible
    Order order = Order::start;
    std::uint8_t group = 0;
    bool squared = true;     // start, stop: the curve to fade along
    bool paused = false;     // group_pause
    std::int32_t frames = 0; // how long it takes to get there
    VoiceRef voice;
    Gains gains{};          // start, gains; the first alone: group_gain
    std::int64_t speed = 0; // start, speed: source frames a mixed frame, 32.32 fixed point
    const Sample* sample = nullptr;
    Stream* stream = nullptr;                                 // start: one of the two
    std::uint32_t position = 0, loop_begin = 0, loop_end = 0; // source frames; loop_end 0: it plays once
};

} // namespace evil::mixer
