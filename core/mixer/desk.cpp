#include "mixer/desk.hpp"
#include <algorithm>
#include <cassert>
#include <cmath>

namespace evil::mixer {
namespace {

constexpr double kLowestSpeed = 1.0 / 1024; // slower, a sound would last for hours

} // namespace

Desk::Desk(InstructionSet set) : mixer_(std::make_unique<Mixer>(set)) {}

// To 32.32 fixed point, with the kernels ready that it needs, and those on the way to it from any lower speed.
std::int64_t Desk::fixed_speed(double speed) {
    const double clamped = std::clamp(speed, kLowestSpeed, kHighestSpeed);
    const auto fixed = static_cast<std::int64_t>(std::floor(clamped * 4294967296.0 + 0.5));
    for (int number = kernel_for(fixed); number >= 0; --number) {
        auto& kernel = mixer_->kernels[static_cast<std::size_t>(number)];
        if (!kernel) kernel = std::make_unique<const Kernel>(make_kernel(number));
    }
    return fixed;
}

void Desk::send(Command command) {
    latest_ = command.when = std::max(command.when, latest_);
    if (!held_back_.empty() || !mixer_->orders.push(command)) held_back_.push_back(command);
}

std::optional<VoiceRef> Desk::start(const Sound& sound, std::uint64_t when) {
    assert((sound.sample == nullptr) != (sound.stream == nullptr));
    tidy();
    const auto free = std::ranges::find(slots_, false, &Slot::taken);
    if (free == slots_.end()) return std::nullopt;
    free->taken = true;
    free->sample = sound.sample, free->stream = sound.stream;
    if (++free->serial == 0) ++free->serial;
    ++in_use_;

    Command c;
    c.when = when, c.order = Order::start, c.group = static_cast<std::uint8_t>(sound.group);
    c.squared = sound.squared, c.frames = sound.fade_in, c.gains = sound.gains;
    c.voice = {static_cast<std::uint32_t>(free - slots_.begin()), free->serial};
    c.speed = fixed_speed(sound.speed);
    c.sample = sound.sample.get(), c.stream = sound.stream.get();
    c.position = sound.position, c.loop_begin = sound.loop_begin, c.loop_end = sound.loop_end;
    send(c);
    return c.voice;
}

void Desk::gains(VoiceRef voice, const Gains& gains, std::int32_t frames, std::uint64_t when) {
    Command c;
    c.when = when, c.order = Order::gains, c.voice = voice, c.gains = gains, c.frames = frames;
    send(c);
}

void Desk::speed(VoiceRef voice, double speed, std::int32_t frames, std::uint64_t when) {
    Command c;
    c.when = when, c.order = Order::speed, c.voice = voice, c.speed = fixed_speed(speed), c.frames = frames;
    send(c);
}

void Desk::stop(VoiceRef voice, std::int32_t frames, bool squared, std::uint64_t when) {
    Command c;
    c.when = when, c.order = Order::stop, c.voice = voice, c.frames = frames, c.squared = squared;
    send(c);
}

void Desk::group_gain(int group, float gain, std::int32_t frames, std::uint64_t when) {
    Command c;
    c.when = when, c.order = Order::group_gain, c.group = static_cast<std::uint8_t>(group), c.frames = frames;
    c.gains[0] = gain;
    send(c);
}

void Desk::group_pause(int group, bool paused, std::uint64_t when) {
    Command c;
    c.when = when, c.order = Order::group_pause, c.group = static_cast<std::uint8_t>(group), c.paused = paused;
    send(c);
}

void Desk::tidy() {
    while (!held_back_.empty() && mixer_->orders.push(held_back_.front())) held_back_.pop_front();
    for (const VoiceRef* voice = mixer_->ended.front(); voice; voice = mixer_->ended.front()) {
        Slot& slot = slots_[voice->slot];
        slot.taken = false;
        slot.sample.reset(), slot.stream.reset();
        --in_use_;
        mixer_->ended.pop();
    }
}

void Desk::render(float* out, std::uint32_t frames) {
    while (frames > 0) {
        tidy();
        std::uint64_t count = frames;
        if (!held_back_.empty())
            count = std::min(count, held_back_.front().when - std::min(held_back_.front().when, mixer_->clock()));
        mixer_->mix(out, static_cast<std::uint32_t>(count)); // none, where the ring is full of what is due: it obeys
        out += 2 * count;
        frames -= static_cast<std::uint32_t>(count);
    }
    tidy();
}

bool Desk::playing(VoiceRef voice) const {
    const Slot& slot = slots_[voice.slot];
    return slot.taken && slot.serial == voice.serial;
}

} // namespace evil::mixer
