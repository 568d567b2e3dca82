#pragma once
// Numbers that go somewhere over a count of frames. What they are at a frame follows from how far the ramp has come, never
// from how the mix was cut into blocks.
#include "mixer/kernels_wide.hpp"
#include <algorithm>
#include <cstdint>

namespace evil::mixer {

inline constexpr std::int32_t kLongestRamp = 1 << 23; // frames, three minutes; a float still counts them exactly

// A straight way from one value to another.
struct Ramp {
    float from = 0.0f, target = 0.0f;
    std::int32_t done = 0, length = 0;

    float step() const { return (target - from) / static_cast<float>(length); }
    float now() const { return left() == 0 ? target : from + step() * static_cast<float>(done); }
    std::int32_t left() const { return length - done; }
    Line line() const { return left() == 0 ? Line{target, 0.0f, 0} : Line{from, step(), done}; }

    void go_to(float value, std::int32_t frames) {
        from = now(), target = value, done = 0, length = std::clamp(frames, 0, kLongestRamp);
    }
    void advance(int count) { done = std::min(length, done + count); }
};

// A place on the fading curve of kernels_wide.hpp: 0 is silence, 1 is all of the sound.
struct Fade {
    Ramp place{1.0f, 1.0f};
    bool squared = true;

    bool moving() const { return place.left() > 0; }
    void go_to(float value, std::int32_t frames, bool square) {
        float now = place.now();
        if (now <= 0.0f || now >= 1.0f) squared = square; // half way on one curve it cannot change to the other: a jump
        place.go_to(value, frames);
    }
};

} // namespace evil::mixer
