#pragma once
// The mixer: what happens in the audio thread. It takes orders from a ring, mixes voices into groups and groups into the
// master, and limits the sum. It never locks, never allocates, never waits, and knows no clock but the frames it mixed:
// the same orders at the same frames give the same samples, whatever the blocks and the instruction set.
//
//     orders -> voices -> groups -> master -> limiter -> sound card, file
//               ended voices -> back to the desk (desk.hpp)
#include "math/cpu.hpp"
#include "mixer/command.hpp"
#include "mixer/limiter.hpp"
#include "mixer/ring.hpp"
#include "mixer/voice.hpp"
#include <atomic>

namespace evil::mixer {

inline constexpr std::int32_t kPauseFrames = 240; // 5 ms in which a group falls silent or comes back

// How punctual the audio thread is, in ticks of the clock that was lent to it.
struct Punctuality {
    std::atomic<std::uint64_t> blocks{0}, longest_gap{0}, longest_mix{0};
};

class Mixer {
public:
    explicit Mixer(InstructionSet set = best_instruction_set());

    // The audio thread: the next `frames` frames, interleaved. Should two threads ever call at once, one gets silence.
    void mix(float* out, std::uint32_t frames) noexcept;

    // The same, noting how punctual it was called if it has a clock to watch.
    void mix_watched(float* out, std::uint32_t frames) noexcept;

    // Frames mixed so far.
    std::uint64_t clock() const noexcept { return clock_.load(std::memory_order_acquire); }

    // Both ends of the rings, and the kernels that the orders need.
    Ring<Command> orders{1024};
    Ring<VoiceRef> ended{kVoices};
    Kernels kernels;

    // A clock that the callback may read, such as SDL_GetPerformanceCounter; null: it is not watched.
    using Clock = std::uint64_t (*)();
    std::atomic<Clock> watch{nullptr};
    Punctuality punctuality;

private:
    struct Group {
        Ramp gain{1.0f, 1.0f};
        Fade gate; // shut while paused
        bool used = false;
        std::array<float, kChunk> left{}, right{};
        bool frozen() const { return !gate.moving() && gate.place.target <= 0.0f; }
    };

    void obey(const Command& command) noexcept;
    int take_orders(int count) noexcept;
    void mix_chunk(int count, float* out) noexcept;
    void mix_voices(int count) noexcept;
    void add_group(Group& group, int count, float* left, float* right) noexcept;
    Voice* find(VoiceRef ref) noexcept;

    InstructionSet set_;
    std::array<Voice, kVoices> voices_;
    std::array<std::uint32_t, kVoices> playing_{}; // slots in the order they were started in: the order of the sum
    int playing_count_ = 0;
    std::array<Group, kGroups> groups_;
    Scratch scratch_;
    Limiter limiter_;
    std::atomic<std::uint64_t> clock_{0};
    std::atomic_flag busy_ = ATOMIC_FLAG_INIT;
    std::uint64_t last_call_ = 0; // by the clock of `watch`
};

} // namespace evil::mixer

// What a sound card calls, SDL's way: `mixer` is a Mixer, `bytes` holds whole frames of two floats. Handed over by address.
extern "C" void evil_mixer_callback(void* mixer, std::uint8_t* stream, int bytes);
