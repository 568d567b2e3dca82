"""The mixer, heard by measuring: spectra, steps between samples, powers, exact frames."""

from __future__ import annotations

import ctypes
import threading
import time

import numpy as np
import pytest

from evilengine import _core
from evilengine._core import MIX_LATENCY, Mixer, Sample, Stream
from evilengine.values.errors import ArgumentError

RATE = 48000
LEFT = (1.0, 0.0, 0.0, 0.0)  # gains: a sound with one channel on the left only, as it is
BOTH = (1.0, 1.0, 0.0, 0.0)


def sine(hertz: float, seconds: float = 1.0, rate: float = RATE, size: float = 0.5) -> np.ndarray:
    return (size * np.sin(2 * np.pi * hertz * np.arange(int(seconds * rate)) / rate)).astype(np.float32)


def sample(data: np.ndarray, rate: float = RATE) -> Sample:
    return Sample(np.ascontiguousarray(data, np.float32), channels=1 if data.ndim == 1 else data.shape[1], rate=rate)


def heard(mixer: Mixer, frames: int) -> np.ndarray:
    """The next frames without the limiter's delay, as (frames, 2); only for the first call on a mixer."""
    data = np.frombuffer(mixer.render(frames + MIX_LATENCY), np.float32).reshape(-1, 2)
    return data[MIX_LATENCY:].astype(np.float64)


def decibels(ratio: float) -> float:
    return 20 * float(np.log10(max(ratio, 1e-12)))


def rest_of_a_sine(signal: np.ndarray, hertz: float) -> tuple[float, float]:
    """Amplitude of the sine in the signal, and the largest value of what is not that sine."""
    at = 2 * np.pi * hertz * np.arange(len(signal)) / RATE
    basis = np.stack([np.sin(at), np.cos(at)], axis=1)
    fit, *_ = np.linalg.lstsq(basis, signal, rcond=None)
    return float(np.hypot(*fit)), float(np.abs(signal - basis @ fit).max())


def bend(signal: np.ndarray) -> float:
    """The largest second difference: a click bends a signal far more than its own frequencies do."""
    return float(np.abs(np.diff(signal, 2, axis=0)).max())


# Resampling -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("rate", "hertz"), [(44100, 997), (44100, 15000), (22050, 997), (8000, 997), (96000, 15000)])
def test_a_resampled_sine_is_that_sine_within_a_thirty_thousandth(rate: int, hertz: float) -> None:
    mixer = Mixer()
    mixer.start(sample=sample(sine(hertz, 1.2, rate), rate), speed=rate / RATE, gains=LEFT)
    amplitude, rest = rest_of_a_sine(heard(mixer, RATE)[2000:40000, 0], hertz)
    print(f"{hertz} Hz of {rate}: distortion {decibels(rest / amplitude):.1f} dB")
    assert amplitude == pytest.approx(0.5, rel=2e-3)
    assert decibels(rest / amplitude) < -88


@pytest.mark.parametrize("pitch", [1.3, 1.5, 2.0, 3.0, 3.9])
def test_what_is_played_too_fast_to_be_heard_does_not_come_back_as_another_tone(pitch: float) -> None:
    hertz = 30000 / pitch  # 30 kHz when it is played: beyond the 24 that there can be, it would alias to 18
    mixer = Mixer()
    mixer.start(sample=sample(sine(hertz, 5.0)), speed=pitch, gains=LEFT)
    alias = np.abs(heard(mixer, RATE)[2000:40000, 0]).max() / 0.5
    print(f"30 kHz at pitch {pitch}: alias {decibels(alias):.1f} dB")
    assert decibels(alias) < -85


def test_a_low_sound_has_no_images_of_itself_above(tmp_path: object) -> None:
    mixer = Mixer()
    mixer.start(sample=sample(sine(3000, 2.0, 11025), 11025), speed=11025 / RATE, gains=LEFT)
    signal = heard(mixer, RATE)[4000:36768, 0]
    spectrum = np.abs(np.fft.rfft(signal * np.blackman(len(signal))))
    hertz = np.fft.rfftfreq(len(signal), 1 / RATE)
    image = spectrum[hertz > 5000].max() / spectrum.max()
    assert decibels(image) < -85


def test_a_constant_stays_constant_at_any_speed() -> None:
    mixer = Mixer()
    mixer.start(sample=sample(np.full(200_000, 0.25)), speed=0.9137, gains=LEFT)
    assert np.abs(heard(mixer, 40000)[500:, 0] - 0.25).max() < 1e-6


def test_a_sound_at_its_own_speed_comes_out_bit_for_bit() -> None:
    noise = np.random.default_rng(1).uniform(-0.7, 0.7, 5000).astype(np.float32)
    mixer = Mixer()
    mixer.start(sample=sample(noise), gains=LEFT)
    assert (heard(mixer, 5000)[:, 0] == noise).all()


def test_a_slide_of_pitch_bends_the_sound_nowhere() -> None:
    mixer = Mixer()
    voice = mixer.start(sample=sample(sine(500, 10.0)), gains=LEFT)
    mixer.speed(voice, 4.0, 20000, when=5000)  # through every kernel up to an octave twice
    mixer.speed(voice, 0.5, 10000, when=30000)
    signal = heard(mixer, 48000)[:, 0]
    assert bend(signal[100:]) <= 1.02 * 0.5 * (2 * np.pi * 2000 / RATE) ** 2
    assert rest_of_a_sine(signal[42000:47000], 250)[1] < 1e-4  # and ends where it was told to


def test_the_kernel_of_a_fast_sound_is_given_up_when_it_is_slow_again() -> None:
    mixer = Mixer()
    voice = mixer.start(sample=sample(sine(15000, 4.0)), speed=2.0, gains=LEFT)
    mixer.speed(voice, 1.0, 100, when=1000)
    assert rest_of_a_sine(heard(mixer, 12000)[2000:, 0], 15000)[0] == pytest.approx(0.5, rel=1e-3)


# When and for how long ------------------------------------------------------------------------------------------------


def test_orders_take_effect_at_exactly_their_frame() -> None:
    mixer = Mixer()
    mixer.start(sample=sample(np.full(100, 0.5)), gains=LEFT, when=1234)
    mixer.start(sample=sample(np.full(100, 0.25)), gains=(0.0, 1.0, 0.0, 0.0), when=1235)
    signal = heard(mixer, 4000)
    assert np.flatnonzero(signal[:, 0])[0] == 1234
    assert np.flatnonzero(signal[:, 1])[0] == 1235
    assert mixer.clock == 4000 + MIX_LATENCY


def test_the_size_of_the_blocks_makes_no_difference() -> None:
    def play(blocks: list[int]) -> bytes:
        mixer = Mixer()
        stereo = np.random.default_rng(2).uniform(-1, 1, (9000, 2)).astype(np.float32)
        first = mixer.start(sample=sample(stereo), speed=1.37, loop=(100, 8000), fade=700)
        second = mixer.start(sample=sample(sine(440, 3)), gains=BOTH, group=2, when=333)
        mixer.speed(second, 2.6, 901, when=2000)
        mixer.gains(first, (0.1, 0.2, 0.3, 0.4), 555, when=2500)
        mixer.group_gain(2, 2.5, 1111, when=3000)
        mixer.group_pause(2, True, when=7000)
        mixer.group_pause(2, False, when=9001)
        mixer.stop(first, 1234, when=15000)
        return b"".join(mixer.render(block) for block in blocks)

    once = play([24000])
    assert play([1] * 100 + [23900]) == once
    assert play([800] * 30) == once
    assert play([7, 480, 513, 3000, 20000]) == once


@pytest.mark.parametrize("instructions", _core.instruction_sets())
def test_every_instruction_set_gives_the_same_bits(instructions: str) -> None:
    def play(name: str) -> bytes:
        mixer = Mixer(instructions=name)
        noise = np.random.default_rng(3).uniform(-1, 1, (20001, 2)).astype(np.float32)
        for i in range(12):
            voice = mixer.start(sample=sample(noise, 44100), speed=0.3 + 0.61 * i, group=1 + i % 3, fade=100 * i)
            mixer.gains(voice, (0.3, 0.1, 0.05 * i, 0.4), 1000 + i, when=50 * i)
            mixer.stop(voice, 1000, i % 2 == 0, when=6000 + 11 * i)
        return mixer.render(9999)

    assert play(instructions) == play("")


def test_a_loop_goes_round_without_a_seam() -> None:
    wave = sine(480, 1.0)[:4800]  # 48 whole periods
    mixer = Mixer()
    mixer.start(sample=sample(wave, 44100), speed=0.91875, gains=LEFT, loop=(0, 4800))
    signal = heard(mixer, 48000)[1000:, 0]
    amplitude, rest = rest_of_a_sine(signal, 480 * 0.91875)
    assert decibels(rest / amplitude) < -88


def test_a_loop_of_a_single_frame_is_that_frame_for_ever() -> None:
    mixer = Mixer()
    mixer.start(sample=sample(np.full(10, 0.5)), speed=7.9, gains=LEFT, loop=(4, 5))
    assert np.abs(heard(mixer, 5000)[500:, 0] - 0.5).max() < 1e-6


def test_a_sound_ends_and_its_voice_is_free_again() -> None:
    mixer = Mixer()
    voice = mixer.start(sample=sample(np.full(100, 0.5)), gains=LEFT)
    assert mixer.playing(voice)
    mixer.render(1000)
    assert not mixer.playing(voice)
    assert mixer.voices_in_use == 0
    mixer.gains(voice, BOTH, 10)  # for a sound that is gone: nothing happens
    mixer.stop(voice, 10)
    assert not np.frombuffer(mixer.render(1000), np.float32).any()


def test_there_are_256_voices_and_the_next_gets_none() -> None:
    mixer = Mixer()
    tick = sample(sine(100, 0.01))
    voices = [mixer.start(sample=tick) for _ in range(256)]
    assert len(set(voices)) == 256
    assert mixer.start(sample=tick) == 0
    mixer.render(1000)
    again = mixer.start(sample=tick)
    assert again != 0
    assert again not in voices


# Clicks ---------------------------------------------------------------------------------------------------------------

LOUD_AND_LOW = sine(100, 3.0, size=0.9)
ITS_OWN_BEND = 0.9 * (2 * np.pi * 100 / RATE) ** 2


def quiet_enough(signal: np.ndarray) -> bool:
    """No more bend than 5 ms of half a cosine make: 0.0002 at full size, 74 dB below a click."""
    return bend(signal) < ITS_OWN_BEND + 3e-4


def test_stopping_in_full_swing_does_not_click() -> None:
    mixer = Mixer()
    voice = mixer.start(sample=sample(LOUD_AND_LOW), gains=LEFT)
    mixer.stop(voice, 240, when=12120)  # at the top of a wave
    signal = heard(mixer, 14000)[:, 0]
    assert quiet_enough(signal)
    assert not signal[12400:].any()


def test_starting_in_the_middle_with_a_fade_does_not_click() -> None:
    mixer = Mixer()
    mixer.start(sample=sample(LOUD_AND_LOW), gains=LEFT, position=12120, fade=240)
    assert quiet_enough(np.concatenate([np.zeros(9), heard(mixer, 4000)[:, 0]]))


def test_a_sound_that_ends_in_full_swing_does_not_click() -> None:
    mixer = Mixer()
    mixer.start(sample=sample(LOUD_AND_LOW[:12120]), gains=LEFT)
    assert bend(heard(mixer, 14000)[:, 0]) < 2e-2  # a click would be 0.9


def test_jumping_by_crossing_over_to_another_voice_does_not_click() -> None:
    mixer = Mixer()
    data = sample(LOUD_AND_LOW)
    voice = mixer.start(sample=data, gains=LEFT)
    mixer.stop(voice, 240, when=10000)
    mixer.start(sample=data, gains=LEFT, position=24360, fade=240, when=10000)  # a wave's top to a wave's bottom
    assert quiet_enough(heard(mixer, 14000)[:, 0])


def test_a_jump_of_volume_is_a_ramp() -> None:
    mixer = Mixer()
    voice = mixer.start(sample=sample(np.full(48000, 0.9)), gains=LEFT)
    mixer.gains(voice, (0.0, 0.0, 0.0, 0.0), 800, when=5000)
    mixer.gains(voice, LEFT, 800, when=5400)  # half way, back again
    signal = heard(mixer, 10000)[:, 0]
    assert np.abs(np.diff(signal[100:])).max() < 0.9 / 800 * 1.01
    assert signal[5400] == pytest.approx(0.45, abs=2e-3)
    assert signal[6200] == pytest.approx(0.9)


def test_a_group_that_pauses_does_not_click_and_goes_on_where_it_stood() -> None:
    mixer = Mixer()
    ramp = np.linspace(0.0, 0.9, 48000)
    mixer.start(sample=sample(ramp), gains=LEFT, group=3)
    mixer.group_pause(3, True, when=10000)
    mixer.group_pause(3, False, when=20000)
    signal = heard(mixer, 40000)[:, 0]
    assert bend(signal[10:]) < 1e-4
    assert not signal[10240:20000].any()
    assert signal[20240] == pytest.approx(ramp[10480], abs=1e-6)  # 240 frames shutting, 240 opening


def test_a_cross_fade_keeps_its_power() -> None:
    random = np.random.default_rng(4)
    mixer = Mixer()
    old = mixer.start(sample=sample(random.normal(0, 0.1, 480_000)), gains=LEFT, group=1)
    mixer.stop(old, 96000, False, when=96000)
    mixer.start(
        sample=sample(random.normal(0, 0.1, 480_000)), gains=LEFT, group=2, fade=96000, squared=False, when=96000
    )
    signal = heard(mixer, 288_000)[:, 0]
    power = (signal**2).reshape(-1, 24000).mean(axis=1)
    assert np.abs(10 * np.log10(power / 0.01)).max() < 0.15  # dB; noise of that length wavers by 0.04


def test_the_curve_of_a_cross_fade_has_constant_power_at_every_frame() -> None:
    def curve(*, rising: bool) -> np.ndarray:
        mixer = Mixer()
        voice = mixer.start(sample=sample(np.full(48000, 0.5)), gains=LEFT, fade=20000 if rising else 0, squared=False)
        if not rising:
            mixer.stop(voice, 20000, False)
        return heard(mixer, 20000)[:, 0] / 0.5

    assert np.abs(curve(rising=True) ** 2 + curve(rising=False) ** 2 - 1.0).max() < 2e-5


# The limiter ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("voices", [1, 8, 100])
def test_however_many_play_the_mix_stays_below_one(voices: int) -> None:
    random = np.random.default_rng(5)
    mixer = Mixer()
    for i in range(voices):
        noise = random.uniform(-1, 1, 9600) * (random.random(9600) < 0.02 * (i + 1))
        mixer.start(sample=sample(noise), gains=(7.0, 5.0, 0.0, 0.0), speed=0.7, when=37 * i)
    assert np.abs(heard(mixer, 20000)).max() <= 0.9801


def test_a_peak_is_turned_down_before_it_comes_and_not_cut_off() -> None:
    mixer = Mixer()
    tone = sine(100, 1.0, size=0.4)
    mixer.start(sample=sample(tone), gains=LEFT)
    spike = np.zeros(48000)
    spike[24000] = 3.0
    mixer.start(sample=sample(spike), gains=LEFT)
    signal = heard(mixer, 48000)[:, 0]
    assert np.abs(signal).max() <= 0.9801
    assert np.abs(np.diff(np.delete(signal[20000:28000], 4000))).max() < 0.02  # the tone under it goes on smoothly
    assert signal[24000] > 0.9
    assert np.abs(signal[:23000] - tone[:23000]).max() == 0.0  # what is not too loud is not touched


def test_what_is_no_number_or_far_too_loud_in_a_file_harms_nothing() -> None:
    mixer = Mixer()
    bad = np.array([np.nan, np.inf, -np.inf, 1e30, -1e30, 1e-40, 0.5] * 100, np.float32)
    mixer.start(sample=sample(bad), speed=0.77, gains=LEFT)
    signal = heard(mixer, 3000)
    assert np.isfinite(signal).all()
    assert np.abs(signal).max() <= 0.9801


# Streams, and what the game may do ------------------------------------------------------------------------------------


def test_a_stream_sounds_like_the_sample_it_is_written_from() -> None:
    data = np.random.default_rng(6).uniform(-0.5, 0.5, (60000, 2)).astype(np.float32)
    whole, piecewise = Mixer(), Mixer()
    whole.start(sample=sample(data, 44100), speed=0.91875)
    stream = Stream(channels=2, rate=44100, capacity=16384)
    written = stream.room
    stream.write(data[:written])
    piecewise.start(stream=stream, speed=0.91875)
    out = []
    for _ in range(60):
        out.append(piecewise.render(1000))
        more = data[written : written + stream.room]
        stream.write(more)
        written += len(more)
        if written == len(data):
            stream.finish()
    assert np.array_equal(np.frombuffer(b"".join(out), np.float32), np.frombuffer(whole.render(60000), np.float32))


def test_a_stream_that_runs_dry_fades_out_waits_and_comes_back() -> None:
    tone = LOUD_AND_LOW
    stream = Stream(channels=1, rate=RATE, capacity=65536)
    stream.write(tone[:20000])
    mixer = Mixer()
    voice = mixer.start(stream=stream, gains=LEFT)
    first = heard(mixer, 30000)[:, 0]
    stream.write(tone[20000:60000])
    second = np.frombuffer(mixer.render(20000), np.float32).reshape(-1, 2)[:, 0]
    assert quiet_enough(np.concatenate([first, second]))
    assert not first[20000:].any()
    assert np.abs(second).max() > 0.8
    assert mixer.playing(voice)


def test_many_more_orders_than_the_ring_holds_are_all_obeyed_in_time() -> None:
    mixer = Mixer()
    voice = mixer.start(sample=sample(np.full(48000, 0.5)), gains=(0.0, 0.0, 0.0, 0.0))
    for frame in range(5000):
        mixer.gains(voice, ((frame % 2) * 1.0, 0.0, 0.0, 0.0), 0, when=frame)
    signal = heard(mixer, 5000)[:, 0]
    assert (signal == np.arange(5000) % 2 * 0.5).all()


def test_orders_from_a_busy_thread_all_arrive() -> None:
    """One thread commands as fast as it can while another, without the GIL, mixes: every sound begins and ends."""
    mixer = Mixer()
    tick = sample(sine(1000, 0.002))
    callback = ctypes.CFUNCTYPE(None, ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int)(Mixer.callback)
    heard_size, done = [0.0], threading.Event()

    def listen() -> None:
        block = np.zeros((64, 2), np.float32)
        after = 0
        while after < 10:  # blocks once there is nothing more to come
            callback(mixer.address, block.ctypes.data, block.nbytes)
            heard_size[0] += float(np.abs(block).sum())
            after += done.is_set() and not block.any()

    listener = threading.Thread(target=listen)
    listener.start()
    started = 0
    deadline = time.perf_counter() + 20.0
    while started < 3000 and time.perf_counter() < deadline:
        voice = mixer.start(sample=tick, gains=(0.001, 0.001, 0.0, 0.0))
        if voice:
            started += 1
            mixer.gains(voice, (0.001, 0.001, 0.0, 0.0), 5)
            mixer.speed(voice, 1.0, 5)
        else:
            time.sleep(0.0005)
    while mixer.voices_in_use and time.perf_counter() < deadline:
        mixer.tidy()
        time.sleep(0.001)
    done.set()
    listener.join(timeout=20.0)
    assert started == 3000
    assert mixer.voices_in_use == 0
    assert heard_size[0] > 0.0


@pytest.mark.parametrize(
    "wrong",
    [
        {"speed": 0.0}, {"speed": float("nan")}, {"speed": 8.5}, {"group": 16}, {"group": -1}, {"position": 100},
        {"loop": (5, 5)}, {"loop": (0, 101)}, {"gains": (float("nan"), 0.0, 0.0, 0.0)}, {"fade": -1},
        {"fade": 2**23 + 1},
    ],
)  # fmt: skip
def test_what_cannot_be_mixed_is_refused(wrong: dict[str, object]) -> None:
    mixer = Mixer()
    with pytest.raises(ArgumentError):
        mixer.start(**{"sample": sample(np.zeros(100)), **wrong})  # type: ignore[arg-type]
    assert mixer.voices_in_use == 0


def test_voices_that_were_never_given_are_refused() -> None:
    mixer = Mixer()
    for voice in (0, 5, 2**16 + 256, 2**63):
        with pytest.raises(ArgumentError, match="voice"):
            mixer.stop(voice, 10)


def test_samples_that_are_none_are_refused() -> None:
    for data, channels, rate in ((b"", 1, 48000), (b"123", 1, 48000), (bytes(12), 2, 48000), (bytes(8), 3, 48000)):
        with pytest.raises(ArgumentError):
            Sample(data, channels=channels, rate=rate)
    for rate in (0.0, -1.0, float("nan"), 1e9):
        with pytest.raises(ArgumentError):
            Sample(bytes(8), channels=1, rate=rate)
    stream = Stream(channels=2, rate=48000, capacity=8192)
    with pytest.raises(ArgumentError, match="room"):
        stream.write(bytes(8 * 9000))


def test_the_core_says_its_rate() -> None:
    assert (_core.MIX_RATE, _core.MIX_LATENCY) == (RATE, 127)
