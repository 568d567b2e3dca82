#include "mixer/sound.hpp"
#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

namespace evil::mixer {
namespace {

// A number that can be mixed: finite, not absurdly loud, and not so small that processors take the slow way with it.
float clean(float v) {
    if (!(std::fabs(v) >= 1e-20f)) return 0.0f; // NaN too
    return std::clamp(v, -kLoudest, kLoudest);
}

// After the last frame the sound goes on in half a cosine's bow to zero, so that none ends in a click.
void add_tail(float* end, float last) {
    for (std::uint32_t i = 0; i < kTail; ++i) {
        float left = 1.0f - static_cast<float>(i + 1) / static_cast<float>(kTail);
        end[i] = last * left * left * (3.0f - 2.0f * left); // smoothstep: level at both ends
    }
}

} // namespace

Sample::Sample(std::span<const float> interleaved, int channels, double rate)
    : channels_(channels), rate_(rate),
      frames_(static_cast<std::uint32_t>(interleaved.size() / static_cast<std::size_t>(channels))) {
    assert(channels == 1 || channels == 2);
    assert(frames_ >= 1 && frames_ <= kMostFrames);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) {
        planes_[c].assign(frames_ + 2 * std::size_t{kMargin}, 0.0f);
        float* to = planes_[c].data() + kMargin;
        for (std::size_t i = 0; i < frames_; ++i)
            to[i] = clean(interleaved[i * static_cast<std::size_t>(channels) + c]);
        add_tail(to + frames_, to[frames_ - 1]);
    }
}

Stream::Stream(int channels, double rate, std::uint32_t least_capacity)
    : channels_(channels), rate_(rate), capacity_(std::bit_ceil(least_capacity)) {
    assert(channels == 1 || channels == 2);
    for (std::size_t c = 0; c < static_cast<std::size_t>(channels); ++c) planes_[c].assign(capacity_, 0.0f);
}

std::uint32_t Stream::room() const noexcept {
    std::uint64_t used = written_.load(std::memory_order_relaxed) - released_.load(std::memory_order_acquire);
    return capacity_ - static_cast<std::uint32_t>(used);
}

void Stream::write(std::span<const float> interleaved) noexcept {
    std::size_t channels = static_cast<std::size_t>(channels_), count = interleaved.size() / channels;
    assert(count <= room());
    std::uint64_t start = written_.load(std::memory_order_relaxed);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t c = 0; c < channels; ++c)
            planes_[c][(start + i) & (capacity_ - 1)] = clean(interleaved[i * channels + c]);
    written_.store(start + count, std::memory_order_release);
}

void Stream::read(int channel, std::int64_t first, int count, float* out) const noexcept {
    const std::vector<float>& plane = planes_[static_cast<std::size_t>(channel)];
    std::int64_t end = static_cast<std::int64_t>(written());
    for (int i = 0; i < count; ++i) {
        std::int64_t at = first + i;
        out[i] = at >= 0 && at < end ? plane[static_cast<std::uint64_t>(at) & (capacity_ - 1)] : 0.0f;
    }
}

void Stream::release(std::uint64_t before) noexcept {
    std::uint64_t limit = std::min(before, written());
    if (limit > released_.load(std::memory_order_relaxed)) released_.store(limit, std::memory_order_release);
}

} // namespace evil::mixer
