#pragma once
// The desk: the game's side of the mixer. It finds free voices, keeps alive what they play, makes the kernels they need,
// and holds orders back while the ring is full. One thread uses it; the mixer may run in another.
#include "mixer/mixer.hpp"
#include <deque>
#include <memory>
#include <optional>

namespace evil::mixer {

// What to play, and how it begins. Speed is in source frames a mixed frame: 1 plays a 48 kHz sound as it is.
struct Sound {
    std::shared_ptr<const Sample> sample;
    std::shared_ptr<Stream> stream; // one of the two
    double speed = 1.0;
    Gains gains{1.0f, 0.0f, 0.0f, 1.0f};
    int group = 1;
    std::uint32_t position = 0, loop_begin = 0, loop_end = 0; // source frames; loop_end 0: once
    std::int32_t fade_in = 0;                                 // frames
    bool squared = true;                                      // the curve of the fade: ramp.hpp
};

class Desk {
public:
    explicit Desk(InstructionSet set = best_instruction_set());

    Mixer& mixer() { return *mixer_; }

    // Orders take effect at frame `when` of the mix, in the order they are given; in the past means at once.
    // Nothing when all voices are busy.
    std::optional<VoiceRef> start(const Sound& sound, std::uint64_t when = 0);
    void gains(VoiceRef voice, const Gains& gains, std::int32_t frames, std::uint64_t when = 0);
    void speed(VoiceRef voice, double speed, std::int32_t frames, std::uint64_t when = 0);
    void stop(VoiceRef voice, std::int32_t frames, bool squared, std::uint64_t when = 0);
    void group_gain(int group, float gain, std::int32_t frames, std::uint64_t when = 0);
    void group_pause(int group, bool paused, std::uint64_t when = 0);

    // Send on what was held back, and let go of what voices no longer play. Call it now and then, as once a frame.
    void tidy();
    // Mix in this thread: every order at its frame, however many there are.
    void render(float* out, std::uint32_t frames);

    bool playing(VoiceRef voice) const; // as far as tidy() has heard
    int voices_in_use() const { return in_use_; }

private:
    struct Slot {
        std::uint32_t serial = 0; // of its latest sound
        bool taken = false;
        std::shared_ptr<const Sample> sample;
        std::shared_ptr<Stream> stream;
    };

    std::int64_t fixed_speed(double speed);
    void send(Command command);

    std::unique_ptr<Mixer> mixer_;
    std::array<Slot, kVoices> slots_;
    std::deque<Command> held_back_;
    std::uint64_t latest_ = 0; // when of the last order: the ring is obeyed first to last
    int in_use_ = 0;
};

} // namespace evil::mixer
