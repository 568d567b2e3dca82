#pragma once
// Pictures that are shown one after the other: the frames of an animation, by the world's steps.
#include "refs.hpp"
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace evil::draw {

enum class Course : std::uint8_t { loop, once, back }; // again and again; stay at the last; there and back again

struct Clip {
    std::vector<std::uint32_t> textures; // at least one
    double steps = 5.0;                  // of the world, that each is shown
    Course course = Course::loop;
};

struct Playing { // what a drawing shows; no clip: its own texture
    std::uint32_t clip = kNone;
    std::int64_t began = 0; // step of the world
};

// The number of the frame that is shown `age` steps after the first one came.
inline std::size_t frame_at(const Clip& clip, double age) {
    const auto count = static_cast<std::int64_t>(clip.textures.size());
    const auto passed = static_cast<std::int64_t>(std::clamp(std::floor(age / clip.steps), 0.0, 1e15));
    if (clip.course == Course::once) return static_cast<std::size_t>(std::min(passed, count - 1));
    if (clip.course == Course::loop || count < 2) return static_cast<std::size_t>(passed % count);
    const std::int64_t round = 2 * count - 2, at = passed % round;
    return static_cast<std::size_t>(at < count ? at : round - at);
}

inline bool is_over(const Clip& clip, double age) {
    return clip.course == Course::once && age >= clip.steps * static_cast<double>(clip.textures.size());
}

} // namespace evil::draw
