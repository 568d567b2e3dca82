#include "mixer/limiter.hpp"
#include <algorithm>
#include <cmath>

namespace evil::mixer {

Limiter::Limiter() : sum_(std::uint64_t{kUnity} << kLog2) { released_.fill(kUnity); }

Limiter::Gain Limiter::asked(float peak) noexcept {
    if (!(peak > kCeiling)) return kUnity;
    return static_cast<Gain>(kCeiling / peak * static_cast<float>(kUnity));
}

// The least of the last kLookAhead gains, this one included (a queue that is kept rising: Lemire 2006).
Limiter::Gain Limiter::least(Gain gain) noexcept {
    constexpr std::uint32_t kMask = kLookAhead - 1;
    if (first_ != end_ && frame_ - queue_[first_ & kMask].frame >= kLookAhead) ++first_;
    while (first_ != end_ && queue_[(end_ - 1) & kMask].gain >= gain) --end_;
    if (gain < kUnity) queue_[end_++ & kMask] = {frame_, gain};
    return first_ == end_ ? kUnity : queue_[first_ & kMask].gain;
}

void Limiter::process(const float* left, const float* right, int count, float* out) noexcept {
    for (int i = 0; i < count; ++i, ++frame_, out += 2) {
        const Gain target = least(asked(std::max(std::fabs(left[i]), std::fabs(right[i]))));
        now_ = target <= now_ ? target : now_ + std::max<Gain>((target - now_) >> kRelease, 1);
        Gain& oldest = released_[frame_ % kLookAhead];
        sum_ += std::uint64_t{now_} - oldest;
        oldest = now_;
        const float gain = static_cast<float>(sum_ >> kLog2) * (1.0f / static_cast<float>(kUnity));

        delay_[frame_ % kLookAhead] = {left[i], right[i]};
        const std::array<float, 2>& late = delay_[(frame_ + 1) % kLookAhead];
        out[0] = late[0] * gain, out[1] = late[1] * gain;
    }
}

} // namespace evil::mixer
