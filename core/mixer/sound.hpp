#pragma once
// What voices play: a Sample, which lies in memory whole, or a Stream, which somebody keeps filling.
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace evil::mixer {

inline constexpr std::uint32_t kRate = 48000; // frames a second of the mix: what sound cards run at by themselves
inline constexpr double kHighestSpeed = 8.0;  // source frames a mixed frame; the resampler has kernels up to there
inline constexpr int kMostTaps = 264;         // source frames that one mixed frame is made of at that speed
inline constexpr std::uint32_t kTail = 64;    // frames in which a sound that does not end in silence is led there
inline constexpr std::uint32_t kMargin = 512; // frames round a sample that may be read: the tail, then zeros
inline constexpr std::uint32_t kMostFrames = 1u << 27;
inline constexpr float kLoudest = 16.0f; // samples of float files beyond this are cut: +24 dB
static_assert(kMargin > kTail + 2 * kMostTaps / 2 + kHighestSpeed);

// One or two channels at their own rate. Finite: what is not a number becomes silence.
class Sample {
public:
    // `interleaved` holds whole frames, at least one and at most kMostFrames; channels is 1 or 2.
    Sample(std::span<const float> interleaved, int channels, double rate);

    int channels() const { return channels_; }
    double rate() const { return rate_; }
    std::uint32_t frames() const { return frames_; }
    const float* plane(int channel) const { return planes_[static_cast<std::size_t>(channel)].data() + kMargin; }

private:
    int channels_;
    double rate_;
    std::uint32_t frames_;
    std::array<std::vector<float>, 2> planes_; // kMargin frames before and after what is heard
};

// A ring of frames between who decodes and who mixes. Frames are counted from the start of the stream.
class Stream {
public:
    Stream(int channels, double rate, std::uint32_t least_capacity);

    int channels() const { return channels_; }
    double rate() const { return rate_; }

    // For the thread that decodes. How many frames fit; write as many as that at most; say that no more will come.
    std::uint32_t room() const noexcept;
    void write(std::span<const float> interleaved) noexcept;
    void finish() noexcept { finished_.store(true, std::memory_order_release); }

    // For the thread that mixes. What is before the start or not written yet reads as zero.
    std::uint64_t written() const noexcept { return written_.load(std::memory_order_acquire); }
    bool finished() const noexcept { return finished_.load(std::memory_order_acquire); }
    void read(int channel, std::int64_t first, int count, float* out) const noexcept;
    void release(std::uint64_t before) noexcept; // frames before this will not be read again

private:
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
    int channels_;
    double rate_;
    std::uint32_t capacity_;
    std::array<std::vector<float>, 2> planes_;
    alignas(64) std::atomic<std::uint64_t> written_{0};
    std::atomic<bool> finished_{false};
    alignas(64) std::atomic<std::uint64_t> released_{0};
};

} // namespace evil::mixer
