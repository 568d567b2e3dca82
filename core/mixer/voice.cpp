#include "mixer/voice.hpp"
#include <algorithm>
#include <cstring>

namespace evil::mixer {
namespace {

constexpr std::int64_t kOne = 1ll << 32;
constexpr std::int32_t kKernelChange = 64;   // frames in which one kernel blends into the next
constexpr std::int64_t kSupplyLow = 2048;    // source frames left in a stream when it begins to fade away...
constexpr std::int64_t kSupplyEnough = 4096; // ... and when it comes back
constexpr std::int32_t kSupplyFade = 480;    // shorter than kSupplyLow at double speed

std::int64_t whole(std::uint64_t position) { return static_cast<std::int64_t>(position >> 32); }
std::uint64_t fixed(std::uint64_t frames) { return frames << 32; }
std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Where the voice has nothing more to say: past the tail, when the kernel has left it too.
std::uint64_t end_of(const Voice& v, int half) {
    if (v.stream) return v.stream->finished() ? fixed(v.stream->written() + static_cast<std::uint64_t>(half)) : ~0ull;
    return v.loop_end ? ~0ull : fixed(std::uint64_t{v.sample->frames()} + kTail + static_cast<std::uint64_t>(half));
}

void move(Voice& v) {
    v.position += static_cast<std::uint64_t>(v.speed);
    if (v.speed_left > 0) {
        v.speed += v.speed_step;
        if (--v.speed_left == 0) v.speed = v.speed_target;
    }
}

// How the next frames lie in the source.
struct Places {
    int count = 0;         // frames until the voice ends, or all
    std::int64_t base = 0; // whole position of the first
    std::int64_t span = 0; // from there to that of the last
    bool straight = true;  // each at a whole frame, one after the other
};

// Fill scratch.first_tap (relative to the first frame's own place) and scratch.fraction, and move the voice on.
Places places(Voice& v, Scratch& scratch, int count, std::uint64_t end) {
    Places p;
    p.base = whole(v.position);
    std::uint64_t last = v.position;
    for (; p.count < count && v.position < end; ++p.count) {
        last = v.position;
        scratch.first_tap[index(p.count)] = static_cast<std::int32_t>(whole(last) - p.base);
        scratch.fraction[index(p.count)] = static_cast<std::uint32_t>(last);
        p.straight = p.straight && static_cast<std::uint32_t>(last) == 0 && v.speed == kOne;
        move(v);
    }
    p.span = whole(last) - p.base;
    return p;
}

// Source frames [first, first + count) of a loop, unrolled.
void unroll(const Voice& v, const float* plane, std::int64_t first, int count, float* out) {
    const std::int64_t length = v.loop_end - v.loop_begin;
    for (int done = 0; done < count;) {
        std::int64_t at = first + done;
        if (at >= v.loop_end) at = v.loop_begin + (at - v.loop_begin) % length;
        int run = static_cast<int>(std::min<std::int64_t>(count - done, v.loop_end - at));
        std::copy_n(plane + at, run, out + done);
        done += run;
    }
}

// Source frames [first, first + count) of a channel: where they lie if they lie there in one piece, else copied together.
const float* window(const Voice& v, int channel, std::int64_t first, int count, Scratch& scratch) {
    if (v.stream) {
        v.stream->read(channel, first, count, scratch.window.data());
        return scratch.window.data();
    }
    const float* plane = v.sample->plane(channel);
    if (v.loop_end == 0 || first + count <= v.loop_end) return plane + first;
    unroll(v, plane, first, count, scratch.window.data());
    return scratch.window.data();
}

// One channel at the places, into `out`.
void render(const Voice& v, const Kernels& kernels, int channel, const Places& p, Scratch& scratch, float* out,
            InstructionSet set) {
    const Kernel& kernel = *kernels[index(v.kernel)];
    const Kernel& old = *kernels[index(v.old_kernel)];
    const bool changing = v.change.left() > 0;
    const int before = changing ? std::max(kernel.before(), old.before()) : kernel.before();
    const int span = static_cast<int>(p.span) + 2 * before + 2;
    const float* source = window(v, channel, p.base - before, span, scratch);
    if (p.straight && !changing && v.kernel == 0) {
        std::copy_n(source + before, p.count, out); // what the kernel would give: its row for whole places is 0 0 1 0 0
        return;
    }
    resample(kernel, source + before - kernel.before(), scratch.first_tap.data(), scratch.fraction.data(), p.count, out,
             set);
    if (!changing) return;
    const int mixed = std::min(p.count, v.change.left());
    resample(old, source + before - old.before(), scratch.first_tap.data(), scratch.fraction.data(), mixed,
             scratch.other.data(), set);
    EVIL_PICK(set, blend)(out, scratch.other.data(), mixed, v.change.line()); // from 1, all of the old, to 0
}

// Multiply by a fade: the frames on the way by the curve, those after it by where it leads.
void apply(const Fade& fade, float* row, int count, InstructionSet set) {
    const int moving = std::min(count, fade.place.left());
    if (moving > 0) EVIL_PICK(set, apply_curve)(row, moving, fade.place.line(), fade.squared);
    if (fade.place.target <= 0.0f) std::fill(row + moving, row + count, 0.0f);
}

void add(const Ramp& gain, const float* row, int count, float* to, InstructionSet set) {
    const int moving = std::min(count, gain.left());
    if (moving > 0) EVIL_PICK(set, add_scaled)(row, moving, gain.line(), to);
    if (moving < count && gain.target != 0.0f)
        EVIL_PICK(set, add_scaled)(row + moving, count - moving, Line{gain.target, 0.0f, 0}, to + moving);
}

// Fade a stream out before it runs dry, and in when there is enough again. False while nothing can be played.
bool supplied(Voice& v) {
    if (v.stream->finished()) {
        if (v.supply.place.target < 1.0f) v.supply.go_to(1.0f, kSupplyFade, true);
        return true;
    }
    const std::int64_t left = static_cast<std::int64_t>(v.stream->written()) - whole(v.position);
    if (left < kSupplyLow && v.supply.place.target > 0.0f) v.supply.go_to(0.0f, kSupplyFade, true);
    if (left >= kSupplyEnough && v.supply.place.target < 1.0f) v.supply.go_to(1.0f, kSupplyFade, true);
    return v.supply.moving() || v.supply.place.target > 0.0f;
}

// Move to the kernel that a speed needs; the one there was blends into it.
void use_kernel_for(Voice& v, std::int64_t speed) {
    const int needed = kernel_for(speed);
    if (needed == v.kernel) return;
    v.old_kernel = v.kernel, v.kernel = needed;
    v.change = Ramp{1.0f, 0.0f, 0, kKernelChange};
}

// Frames in which speed and kernel stay as they are. False when the voice has ended.
bool play_piece(Voice& v, const Kernels& kernels, Scratch& scratch, int count, float* left, float* right,
                InstructionSet set) {
    const int half = kernels[index(v.kernel)]->taps / 2;
    const Places p = places(v, scratch, count, end_of(v, half));
    const bool stereo = (v.sample ? v.sample->channels() : v.stream->channels()) == 2;
    for (int channel = 0; channel < (stereo ? 2 : 1) && p.count > 0; ++channel) {
        float* row = scratch.row.data();
        render(v, kernels, channel, p, scratch, row, set);
        if (v.stream) apply(v.supply, row, p.count, set);
        apply(v.fade, row, p.count, set);
        add(v.gains[index(2 * channel)], row, p.count, left, set);
        add(v.gains[index(2 * channel + 1)], row, p.count, right, set);
    }
    for (Ramp& gain : v.gains) gain.advance(p.count);
    v.fade.place.advance(p.count);
    v.supply.place.advance(p.count);
    v.change.advance(p.count);
    return p.count == count;
}

} // namespace

void start(Voice& v, const Command& c) {
    v = Voice{};
    v.serial = c.voice.serial;
    v.group = c.group;
    v.sample = c.sample, v.stream = c.stream;
    v.position = fixed(c.position);
    v.loop_begin = c.loop_begin, v.loop_end = c.loop_end;
    v.speed = v.speed_target = c.speed;
    v.kernel = v.old_kernel = kernel_for(c.speed);
    for (std::size_t i = 0; i < 4; ++i) v.gains[i].from = v.gains[i].target = c.gains[i];
    v.fade.place = Ramp{0.0f, 0.0f};
    v.fade.go_to(1.0f, c.frames, c.squared);
}

void set_gains(Voice& v, const Command& c) {
    for (std::size_t i = 0; i < 4; ++i) v.gains[i].go_to(c.gains[i], c.frames);
}

void set_speed(Voice& v, const Command& c) {
    v.speed_target = c.speed;
    v.speed_left = std::clamp(c.frames, 1, kLongestRamp);
    v.speed_step = (c.speed - v.speed) / v.speed_left;
    use_kernel_for(v, std::max(v.speed, c.speed)); // on the way, what the faster of the two needs
}

void stop(Voice& v, const Command& c) {
    if (v.ending && v.fade.place.left() <= c.frames) return; // it ends sooner as it is
    v.fade.go_to(0.0f, std::max(c.frames, 1), c.squared);
    v.ending = true;
}

bool play(Voice& v, const Kernels& kernels, Scratch& scratch, int count, float* left, float* right,
          InstructionSet set) noexcept {
    if (v.stream && !supplied(v)) return !v.ending; // it waits, and nobody would hear it fade
    if (v.ending) count = std::min(count, v.fade.place.left());
    for (int done = 0; done < count;) {
        const bool speeding = v.speed_left > 0;
        const int piece = speeding ? std::min(count - done, v.speed_left) : count - done;
        if (!play_piece(v, kernels, scratch, piece, left + done, right + done, set)) return false;
        if (speeding && v.speed_left == 0) use_kernel_for(v, v.speed);
        done += piece;
    }
    if (v.loop_end) // far enough behind the end, a round less looks the same from here on
        while (v.position >= fixed(std::uint64_t{v.loop_end} + kMargin)) v.position -= fixed(v.loop_end - v.loop_begin);
    if (v.stream) v.stream->release(static_cast<std::uint64_t>(std::max<std::int64_t>(0, whole(v.position) - kMargin)));
    return !(v.ending && v.fade.place.left() == 0);
}

} // namespace evil::mixer
