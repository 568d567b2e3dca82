#include "mixer/mixer.hpp"
#include <algorithm>

namespace evil::mixer {

Mixer::Mixer(InstructionSet set) : set_(set) {}

Voice* Mixer::find(VoiceRef ref) noexcept {
    Voice& voice = voices_[ref.slot];
    return voice.serial == ref.serial ? &voice : nullptr;
}

void Mixer::obey(const Command& c) noexcept {
    switch (c.order) {
    case Order::start:
        mixer::start(voices_[c.voice.slot], c);
        playing_[static_cast<std::size_t>(playing_count_++)] = c.voice.slot;
        return;
    case Order::group_gain:
        groups_[c.group].gain.go_to(c.gains[0], c.frames);
        return;
    case Order::group_pause:
        groups_[c.group].gate.go_to(c.paused ? 0.0f : 1.0f, kPauseFrames, true);
        return;
    case Order::gains:
    case Order::speed:
    case Order::stop:
        break;
    }
    Voice* voice = find(c.voice);
    if (!voice) return;
    if (c.order == Order::gains) set_gains(*voice, c);
    if (c.order == Order::speed) set_speed(*voice, c);
    if (c.order == Order::stop) {
        mixer::stop(*voice, c);
        if (groups_[voice->group].frozen() || groups_[0].frozen()) voice->fade.place.done = voice->fade.place.length;
    }
}

// Obey what is due, and say how many of the next `count` frames there are until the next order.
int Mixer::take_orders(int count) noexcept {
    const std::uint64_t now = clock_.load(std::memory_order_relaxed);
    for (const Command* next = orders.front(); next; next = orders.front()) {
        if (next->when > now)
            return static_cast<int>(std::min<std::uint64_t>(static_cast<std::uint64_t>(count), next->when - now));
        obey(*next);
        orders.pop();
    }
    return count;
}

void Mixer::mix_voices(int count) noexcept {
    int kept = 0;
    for (int i = 0; i < playing_count_; ++i) {
        const std::uint32_t slot = playing_[static_cast<std::size_t>(i)];
        Voice& voice = voices_[slot];
        Group& group = groups_[voice.group];
        bool going = !(voice.ending && !voice.fade.moving());
        if (going && !group.frozen() && !groups_[0].frozen()) {
            if (!group.used) group.left.fill(0.0f), group.right.fill(0.0f), group.used = true;
            going = play(voice, kernels, scratch_, count, group.left.data(), group.right.data(), set_);
        }
        if (going) {
            playing_[static_cast<std::size_t>(kept++)] = slot;
        } else {
            ended.push({slot, voice.serial}); // there is room: a slot is not used again before the desk has heard this
            voice.serial = 0;
        }
    }
    playing_count_ = kept;
}

// Gate, gain, and on to where it is heard; a group that nobody used only moves on.
void Mixer::add_group(Group& group, int count, float* left, float* right) noexcept {
    const int turning = std::min(count, group.gain.left());
    for (float* row : {group.left.data(), group.right.data()}) {
        if (!group.used) break;
        float* to = row == group.left.data() ? left : right;
        if (group.gate.moving()) EVIL_PICK(set_, apply_curve)(row, count, group.gate.place.line(), group.gate.squared);
        if (turning > 0) EVIL_PICK(set_, add_scaled)(row, turning, group.gain.line(), to);
        if (turning < count)
            EVIL_PICK(set_, add_scaled)(row + turning, count - turning, Line{group.gain.target, 0.0f, 0}, to + turning);
    }
    group.gain.advance(count);
    group.gate.place.advance(count);
    group.used = false;
}

void Mixer::mix_chunk(int count, float* out) noexcept {
    Group& master = groups_[0];
    mix_voices(count);
    if (!master.used) master.left.fill(0.0f), master.right.fill(0.0f);
    master.used = true;
    for (std::size_t i = 1; i < groups_.size(); ++i)
        add_group(groups_[i], count, master.left.data(), master.right.data());

    std::array<float, kChunk> left{}, right{};
    if (!master.frozen()) add_group(master, count, left.data(), right.data());
    master.used = false;
    limiter_.process(left.data(), right.data(), count, out);
}

void Mixer::mix(float* out, std::uint32_t frames) noexcept {
    if (busy_.test_and_set(std::memory_order_acquire)) {
        std::fill_n(out, std::size_t{frames} * 2, 0.0f);
        return;
    }
    for (;;) {
        int count = take_orders(static_cast<int>(std::min<std::uint32_t>(frames, kChunk)));
        if (frames == 0) break;            // asked for nothing, it obeys all the same
        for (const Group& group : groups_) // a gate opens or shuts between chunks, where voices stop or go on
            if (group.gate.moving()) count = std::min(count, group.gate.place.left());
        mix_chunk(count, out);
        out += 2 * count;
        frames -= static_cast<std::uint32_t>(count);
        clock_.store(clock_.load(std::memory_order_relaxed) + static_cast<std::uint64_t>(count),
                     std::memory_order_release);
    }
    busy_.clear(std::memory_order_release);
}

void Mixer::mix_watched(float* out, std::uint32_t frames) noexcept {
    const Clock ticks = watch.load(std::memory_order_acquire);
    if (!ticks) {
        mix(out, frames);
        return;
    }
    const std::uint64_t begin = ticks();
    mix(out, frames);
    auto raise = [](std::atomic<std::uint64_t>& most, std::uint64_t value) {
        if (value > most.load(std::memory_order_relaxed)) most.store(value, std::memory_order_relaxed);
    };
    if (last_call_ != 0) raise(punctuality.longest_gap, begin - last_call_);
    raise(punctuality.longest_mix, ticks() - begin);
    last_call_ = begin;
    punctuality.blocks.fetch_add(1, std::memory_order_relaxed);
}

} // namespace evil::mixer

extern "C" void evil_mixer_callback(void* mixer, std::uint8_t* stream, int bytes) {
    const auto frames = static_cast<std::uint32_t>(bytes) / std::uint32_t{2 * sizeof(float)};
    static_cast<evil::mixer::Mixer*>(mixer)->mix_watched(reinterpret_cast<float*>(stream), frames);
}
