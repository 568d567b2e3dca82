// _core.Mixer, _core.Sample and _core.Stream: evilengine.audio is their face. Everything is checked here, so that the audio
// thread need not be.
#include "bind/bytes.hpp"
#include "mixer/desk.hpp"
#include <cstring>
#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/tuple.h>

namespace evil::bind {
namespace {

using namespace evil::mixer;

constexpr double kHighestRate = 384000.0;
constexpr std::uint32_t kMostRendered = 1u << 24; // frames a call, 128 MB
constexpr float kMostGain = 64.0f;

[[noreturn]] void refuse(const char* owner, const std::string& what) {
    raise(ErrorKind::argument, std::string(owner) + ": " + what);
}

void check_format(const char* owner, int channels, double rate) {
    if (channels != 1 && channels != 2) refuse(owner, "channels=" + std::to_string(channels) + " must be 1 or 2");
    if (!(rate >= 1.0 && rate <= kHighestRate)) refuse(owner, "rate must be from 1 to 384000 frames a second");
}

// Floats of 32 bits that some Python object holds.
std::span<const float> floats_in(const Bytes& bytes, int channels, const char* owner) {
    const std::size_t frame = sizeof(float) * static_cast<std::size_t>(channels);
    if (bytes.size() % frame != 0 || reinterpret_cast<std::uintptr_t>(bytes.data()) % alignof(float) != 0)
        refuse(owner, "data must be whole frames of 32-bit floats");
    return {reinterpret_cast<const float*>(bytes.data()), bytes.size() / sizeof(float)};
}

std::shared_ptr<Sample> make_sample(nb::handle data, int channels, double rate) {
    check_format("Sample", channels, rate);
    Bytes bytes(data, false, "Sample", "data");
    std::span<const float> floats = floats_in(bytes, channels, "Sample");
    const std::size_t frames = floats.size() / static_cast<std::size_t>(channels);
    if (frames < 1 || frames > kMostFrames) refuse("Sample", "data must hold 1 to 2**27 frames");
    return std::make_shared<Sample>(floats, channels, rate);
}

std::shared_ptr<Stream> make_stream(int channels, double rate, std::uint32_t capacity) {
    check_format("Stream", channels, rate);
    if (capacity < 8192 || capacity > kMostFrames) refuse("Stream", "capacity must be 8192 to 2**27 frames");
    return std::make_shared<Stream>(channels, rate, capacity);
}

void write_stream(Stream& stream, nb::handle data) {
    Bytes bytes(data, false, "Stream.write", "data");
    std::span<const float> floats = floats_in(bytes, stream.channels(), "Stream.write");
    if (floats.size() / static_cast<std::size_t>(stream.channels()) > stream.room())
        refuse("Stream.write", "there is room for " + std::to_string(stream.room()) + " frames only");
    stream.write(floats);
}

InstructionSet to_set(const std::string& instructions) {
    if (instructions.empty()) return best_instruction_set();
    for (InstructionSet set : runnable_instruction_sets())
        if (instructions == name(set)) return set;
    refuse("Mixer", "instructions='" + instructions + "' cannot run here");
}

// A voice as one number: its serial above its slot. 0 is none.
std::uint64_t to_number(VoiceRef ref) { return std::uint64_t{ref.serial} << 16 | ref.slot; }
VoiceRef to_voice(std::uint64_t number) {
    VoiceRef ref{static_cast<std::uint32_t>(number & 0xffff), static_cast<std::uint32_t>(number >> 16)};
    if (ref.slot >= kVoices || ref.serial == 0 || number >> 48 != 0)
        refuse("Mixer", "voice=" + std::to_string(number) + " is not one that start() gave");
    return ref;
}

Gains checked(const Gains& gains) {
    for (float each : gains)
        if (!(std::fabs(each) <= kMostGain)) refuse("Mixer", "gains must be finite and at most 64");
    return gains;
}
int checked_group(int group) {
    if (group < 0 || group >= kGroups) refuse("Mixer", "group=" + std::to_string(group) + " must be 0 to 15");
    return group;
}
double checked_speed(double speed) {
    if (!(speed > 0.0 && speed <= kHighestSpeed)) refuse("Mixer", "speed must be more than 0 and at most 8");
    return speed;
}
std::int32_t checked_ramp(std::int64_t frames) {
    if (frames < 0 || frames > kLongestRamp) refuse("Mixer", "a ramp must take 0 to 2**23 frames");
    return static_cast<std::int32_t>(frames);
}

using Loop = std::tuple<std::uint32_t, std::uint32_t>;

void check_places(const Sound& sound) {
    if (sound.stream) {
        if (sound.position != 0 || sound.loop_end != 0) refuse("Mixer.start", "a Stream has no position and no loop");
        return;
    }
    const std::uint32_t frames = sound.sample->frames();
    if (sound.loop_end != 0 && !(sound.loop_begin < sound.loop_end && sound.loop_end <= frames))
        refuse("Mixer.start", "loop must be a begin and a later end within the sample's " + std::to_string(frames));
    if (sound.position >= (sound.loop_end ? sound.loop_end : frames))
        refuse("Mixer.start", "position=" + std::to_string(sound.position) + " is past the end");
}

std::uint64_t start(Desk& desk, std::shared_ptr<Sample> sample, std::shared_ptr<Stream> stream, double speed,
                    const Gains& gains, int group, std::uint32_t position, std::optional<Loop> loop, std::int64_t fade,
                    bool squared, std::uint64_t when) {
    Sound sound;
    if ((sample == nullptr) == (stream == nullptr)) refuse("Mixer.start", "give a Sample or a Stream");
    sound.sample = std::move(sample), sound.stream = std::move(stream);
    sound.speed = checked_speed(speed), sound.gains = checked(gains), sound.group = checked_group(group);
    sound.position = position;
    if (loop) std::tie(sound.loop_begin, sound.loop_end) = *loop;
    if (loop && sound.loop_end == 0) refuse("Mixer.start", "loop must be a begin and a later end");
    sound.fade_in = checked_ramp(fade), sound.squared = squared;
    check_places(sound);
    std::optional<VoiceRef> voice = desk.start(sound, when);
    return voice ? to_number(*voice) : 0;
}

nb::bytes rendered(Desk& desk, std::uint32_t frames, bool whole_numbers) {
    if (frames > kMostRendered) refuse("Mixer.render", "at most 2**24 frames a call");
    std::vector<float> mix(std::size_t{frames} * 2);
    desk.render(mix.data(), frames);
    if (!whole_numbers) return nb::bytes(reinterpret_cast<const char*>(mix.data()), mix.size() * sizeof(float));
    std::vector<char> bytes;
    bytes.reserve(mix.size() * 2);
    for (float each : mix) { // the limiter holds it within -1..1
        auto number = static_cast<std::uint16_t>(static_cast<std::int32_t>(std::floor(each * 32767.0f + 0.5f)));
        bytes.push_back(static_cast<char>(number & 0xff)), bytes.push_back(static_cast<char>(number >> 8));
    }
    return nb::bytes(bytes.data(), bytes.size());
}

template <class T> std::uintptr_t address_of(T* pointer) { return reinterpret_cast<std::uintptr_t>(pointer); }

void bind_sounds(nb::module_& module) {
    nb::class_<Sample>(module, "Sample", "A sound in memory: 32-bit floats, one or two channels, any rate.")
        .def(nb::new_(&make_sample), nb::arg("data"), nb::kw_only(), nb::arg("channels"), nb::arg("rate"))
        .def_prop_ro("channels", &Sample::channels)
        .def_prop_ro("rate", &Sample::rate)
        .def_prop_ro("frames", &Sample::frames);
    nb::class_<Stream>(module, "Stream", "A sound that is written while it plays.")
        .def(nb::new_(&make_stream), nb::kw_only(), nb::arg("channels"), nb::arg("rate"), nb::arg("capacity"))
        .def_prop_ro("channels", &Stream::channels)
        .def_prop_ro("rate", &Stream::rate)
        .def_prop_ro("room", &Stream::room, "Frames that can be written now.")
        .def_prop_ro("written", &Stream::written, "Frames written so far.")
        .def("write", &write_stream, nb::arg("data"), "Add whole frames of 32-bit floats, at most `room` of them.")
        .def("finish", &Stream::finish, "Say that no more will come.");
}

} // namespace

void register_mixer(nb::module_& module) {
    bind_sounds(module);
    module.attr("MIX_RATE") = kRate;
    module.attr("MIX_LATENCY") = kLatency;
    nb::class_<Desk>(module, "Mixer", "Voices into groups into one mix of 48 kHz stereo; see core/mixer/desk.hpp.")
        .def(
            "__init__", [](Desk* desk, const std::string& set) { new (desk) Desk(to_set(set)); }, nb::kw_only(),
            nb::arg("instructions") = "", "`instructions` forces one instruction set.")
        .def("start", &start, nb::kw_only(), nb::arg("sample") = nb::none(), nb::arg("stream") = nb::none(),
             nb::arg("speed") = 1.0, nb::arg("gains") = Gains{1.0f, 0.0f, 0.0f, 1.0f}, nb::arg("group") = 1,
             nb::arg("position") = 0, nb::arg("loop") = nb::none(), nb::arg("fade") = 0, nb::arg("squared") = true,
             nb::arg("when") = 0, "Play at frame `when` of the mix; the voice as a number, or 0 when all are busy.")
        .def(
            "gains",
            [](Desk& desk, std::uint64_t voice, const Gains& gains, std::int64_t frames, std::uint64_t when) {
                desk.gains(to_voice(voice), checked(gains), checked_ramp(frames), when);
            },
            nb::arg("voice"), nb::arg("gains"), nb::arg("frames"), nb::arg("when") = 0,
            "Left to left, left to right, right to left, right to right; a source with one channel uses the first two.")
        .def(
            "speed",
            [](Desk& desk, std::uint64_t voice, double speed, std::int64_t frames, std::uint64_t when) {
                desk.speed(to_voice(voice), checked_speed(speed), checked_ramp(frames), when);
            },
            nb::arg("voice"), nb::arg("speed"), nb::arg("frames"), nb::arg("when") = 0, "Source frames a mixed frame.")
        .def(
            "stop",
            [](Desk& desk, std::uint64_t voice, std::int64_t frames, bool squared, std::uint64_t when) {
                desk.stop(to_voice(voice), checked_ramp(frames), squared, when);
            },
            nb::arg("voice"), nb::arg("frames"), nb::arg("squared") = true, nb::arg("when") = 0,
            "Fade out and end; along a quarter sine, which keeps the power of a cross-fade, or its square.")
        .def(
            "group_gain",
            [](Desk& desk, int group, float gain, std::int64_t frames, std::uint64_t when) {
                desk.group_gain(checked_group(group), checked({gain})[0], checked_ramp(frames), when);
            },
            nb::arg("group"), nb::arg("gain"), nb::arg("frames"), nb::arg("when") = 0, "Group 0 is the master.")
        .def(
            "group_pause",
            [](Desk& desk, int group, bool paused, std::uint64_t when) {
                desk.group_pause(checked_group(group), paused, when);
            },
            nb::arg("group"), nb::arg("paused"), nb::arg("when") = 0, "Voices of a paused group stand still.")
        .def("tidy", &Desk::tidy, "Hear which voices have ended, and let go of what they played.")
        .def(
            "playing", [](const Desk& desk, std::uint64_t voice) { return desk.playing(to_voice(voice)); },
            nb::arg("voice"), "False once tidy() has heard that it ended.")
        .def_prop_ro("voices_in_use", &Desk::voices_in_use)
        .def_prop_ro(
            "clock", [](Desk& desk) { return desk.mixer().clock(); }, "Frames mixed so far.")
        .def(
            "render", [](Desk& desk, std::uint32_t frames) { return rendered(desk, frames, false); }, nb::arg("frames"),
            "The next frames, left and right as 32-bit floats, MIX_LATENCY frames late.")
        .def(
            "render_pcm", [](Desk& desk, std::uint32_t frames) { return rendered(desk, frames, true); },
            nb::arg("frames"), "The next frames as 16-bit whole numbers, little end first.")
        .def_prop_ro(
            "address", [](Desk& desk) { return address_of(&desk.mixer()); },
            "What to hand to the callback; valid as long as this object lives.")
        .def_prop_ro_static(
            "callback", [](nb::handle) { return address_of(&evil_mixer_callback); },
            "Address of void (*)(void *mixer, uint8_t *stream, int bytes), for a sound card to call.")
        .def(
            "watch",
            [](Desk& desk, std::uintptr_t clock) { desk.mixer().watch = reinterpret_cast<Mixer::Clock>(clock); },
            nb::arg("clock"), "Measure the callback by the uint64_t (*)(void) at this address; 0 stops it.")
        .def_prop_ro(
            "punctuality",
            [](Desk& desk) {
                const Punctuality& p = desk.mixer().punctuality;
                return std::tuple(p.blocks.load(), p.longest_gap.load(), p.longest_mix.load());
            },
            "Blocks mixed, longest time from one call to the next, longest time of a call: in ticks of that clock.");
}

} // namespace evil::bind
