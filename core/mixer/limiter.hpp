#pragma once
// A look-ahead limiter: however many sounds play at once, the mix stays within what a sound card can say, without the
// crackle of cutting it off.
//
// Each frame asks for a gain that brings it under the ceiling. The gain used is the mean, over the look-ahead, of the least
// gain asked for in the look-ahead, so it starts to fall before a peak, smoothly, and is low enough when the peak comes out
// of the delay. Gains are whole numbers, whose running sum is exact: nothing drifts, and every machine agrees.
//
//     asked      ----------\___/-----------        peak
//     least      ----\_________/-----------        over the look-ahead behind
//     released   ----\_________,.--''              back up slowly
//     mean       ----..\_______,.--''              smooth on the way down
#include <array>
#include <cstdint>

namespace evil::mixer {

inline constexpr int kLookAhead = 128;          // frames, 2.7 ms: shorter distorts bass, longer is felt as delay
inline constexpr int kLatency = kLookAhead - 1; // frames by which the output is late
inline constexpr float kCeiling = 0.98f;        // -0.2 dB: room for what a card's own filters add between samples

class Limiter {
public:
    Limiter();

    // Limit `count` frames, and write them kLatency frames late, interleaved.
    void process(const float* left, const float* right, int count, float* out) noexcept;

private:
    using Gain = std::uint32_t; // kUnity is 1
    static constexpr int kLog2 = 7;
    static_assert(1 << kLog2 == kLookAhead);
    static constexpr Gain kUnity = 1u << 30;
    static constexpr int kRelease = 12; // the gain comes back by 1/4096 a frame of what is missing: 85 ms

    static Gain asked(float peak) noexcept;
    Gain least(Gain gain) noexcept;

    struct Asked {
        std::uint32_t frame;
        Gain gain;
    };
    std::array<std::array<float, 2>, kLookAhead> delay_{};
    std::array<Gain, kLookAhead> released_;
    std::array<Asked, kLookAhead> queue_{}; // gains below unity in the look-ahead, rising: the first is the least
    std::uint32_t first_ = 0, end_ = 0;     // of the queue
    std::uint32_t frame_ = 0;
    Gain now_ = kUnity;
    std::uint64_t sum_;
};

} // namespace evil::mixer
