"""Audio: everything that a game lets be heard (SPEC S1-S3)."""

from __future__ import annotations

import math
from array import array
from collections.abc import Callable, Iterable
from pathlib import Path

from evilengine import _core
from evilengine.audio.groups import LOUDEST, MASTER, Group, Groups
from evilengine.audio.hearing import Gains, Listener
from evilengine.audio.outputs import RATE, Output
from evilengine.audio.sound import CLICK, LONGEST_FADE, Placed, Sound
from evilengine.audio.sources import Music, Sounds
from evilengine.values.checks import known_keywords, number
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point

NO_GAINS: Gains = (0.0, 0.0, 0.0, 0.0)


class Audio:
    """Plays sounds and music, in groups with a volume each: `game.audio`.

    Files are wav, ogg, mp3 or flac, of any rate and number of channels, found by name in the game's folder. A sound is
    decoded once, music while it plays. What is told takes effect at once, and nothing clicks. Without a sound card the
    game is silent and otherwise the same.

    >>> import evilengine as evil
    >>> game = evil.Game(headless=True)
    >>> game.audio.play("thud.ogg")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    evilengine.values.errors.AssetError: sound 'thud.ogg': there is no such file in ...
    >>> game.audio.groups["music"].volume = 0.3; game.audio.volume = 0.8
    """

    def __init__(self, *folders: Path, output: Output | None = None, clock: Callable[[], int] = lambda: 0) -> None:
        self.output = output or Output()
        self.groups = Groups(self._group_changed)
        self.listener = Listener()
        self._sounds = Sounds(*folders)
        self._clock = clock
        self._last_step = self._offset = 0
        self._paused = False
        self._tempo = 1.0
        self._playing: list[Sound] = []
        self._streams: dict[Sound, Music] = {}
        self._music: Sound | None = None

    # What a game calls ------------------------------------------------------------------------------------------------

    @known_keywords
    def play(
        self,
        name: str | Path,
        *,
        at: Point | Placed | None = None,
        volume: float = 1.0,
        pitch: float = 1.0,
        pan: float = 0.0,
        loop: bool = False,
        group: str = "effects",
        start: float = 0.0,
        fade: float = 0.0,
    ) -> Sound:
        """Play a sound file.

        `at` is where in the world it is: a point, or a body that it goes along with. It is loudest within 5 metres of
        the middle of the screen. `volume` 1 is as recorded, at most 8; `pitch` 2 is an octave up and twice as fast;
        `pan` is -1 (left) to 1 (right); `start` and `fade` are seconds. Raises AssetError where the file cannot be
        played. 256 sounds are heard at once; beyond that, further ones play unheard.

        >>> import evilengine as evil
        >>> game = evil.Game(headless=True)
        >>> game.audio.add("tick", [0.5, -0.5, 0.25, -0.25])
        >>> game.audio.play("tick", at=(3, 0), pitch=0.5)
        <Sound 'tick', at 0.00 s>
        """
        loaded = self._sounds.load(name)
        sample = loaded.sample
        sound = Sound(
            self, loaded.name, group=self.groups[group], length=loaded.seconds, rate=sample.rate,
            channels=sample.channels, loop=bool(loop), volume=volume, pitch=pitch, pan=pan, at=at, start=start,
        )  # fmt: skip
        frame = _frame(sound, start)
        self._begin(sound, sample=sample, position=frame, fade=_frames(fade, "Audio.play", "fade"))
        self._playing.append(sound)
        return sound

    @known_keywords
    def music(
        self,
        name: str | Path | None,
        *,
        fade: float = 1.0,
        volume: float = 1.0,
        loop: bool = True,
        start: float = 0.0,
        group: str = "music",
    ) -> Sound | None:
        """Play music, decoded while it plays, again from its start when it is over.

        It cross-fades with what was playing, in `fade` seconds; what is asked for while it plays already plays on.
        None ends the music.
        """
        frames = _frames(fade, "Audio.music", "fade")
        old = self._music if self._music is not None and self._music.alive else None
        if name is None:
            self._leave(old, frames)
            return None
        if old is not None and old.name == str(name) and old.looping == loop and old.group == group:
            old.volume = volume
            return old
        file = self._sounds.open(name)
        sound = Sound(
            self, str(name), group=self.groups[group], length=file.seconds, rate=file.rate, channels=file.channels,
            loop=bool(loop), volume=volume, pitch=1.0, pan=0.0, at=None, start=start,
        )  # fmt: skip
        _frame(sound, start)
        self.output.open()
        if self._mixer is not None:
            self._streams[sound] = Music(file, loop=bool(loop), skip=start)
        self._leave(old, frames)
        self._begin(sound, fade=frames, squared=old is None)
        self._playing.append(sound)
        self._music = sound
        return sound

    def load(self, *names: str | Path) -> None:
        """Decode sounds before they are played, so that nothing is waited for then."""
        for name in names:
            self._sounds.load(name)

    @known_keywords
    def add(self, name: str, samples: Iterable[float], *, channels: int = 1, rate: float = RATE) -> None:
        """Keep a sound that is made of numbers, -1 to 1, to be played by this name: for what no file has.

        Two channels take turns: left, right, left, right. `rate` is in frames a second, at most 192000.
        """
        if not isinstance(name, str) or not name:
            raise ArgumentTypeError(f"Audio.add: name={name!r} must be a word")
        try:
            numbers = array("f", samples)
        except (TypeError, OverflowError):
            raise ArgumentTypeError("Audio.add: samples must be numbers") from None
        number(rate, "Audio.add", "rate", least=1.0, most=192000.0)
        if channels not in (1, 2) or not numbers or len(numbers) % channels:
            raise ArgumentError(
                f"Audio.add: {len(numbers)} samples are no whole frames of channels={channels!r} (1, 2)"
            )
        self._sounds.add(name, numbers, channels=channels, rate=rate)

    @property
    def volume(self) -> float:
        """Of everything; the same as audio.groups["master"].volume."""
        return self.groups[MASTER].volume

    @volume.setter
    def volume(self, value: float) -> None:
        self.groups[MASTER].volume = number(value, "Audio", "volume", least=0.0, most=LOUDEST)

    @property
    def sounds(self) -> tuple[Sound, ...]:
        """Every sound that is alive, in the order they were started in."""
        return tuple(sound for sound in self._playing if sound.alive)

    def stop(self, *, fade: float = 0.0) -> None:
        """End every sound, and the music."""
        for sound in self.sounds:
            sound.stop(fade=fade)

    # What the game does -----------------------------------------------------------------------------------------------

    def update(self, listener: Listener, *, paused: bool = False, tempo: float = 1.0) -> None:
        """After each step and frame: hear from where the camera is, follow bodies, decode ahead.

        `tempo` is how fast the game's time goes; what pauses with the game follows it, where it is heard as it goes.
        """
        self.listener = listener
        if tempo != self._tempo and self.output.live:
            self._tempo = tempo
            for sound in self.sounds:
                sound._send_speed()
        if paused != self._paused:
            self._paused = paused
            for group in self.groups.values():
                self._send(group)
        self._playing = [sound for sound in self._playing if sound.alive]
        for sound in self._playing:
            sound._aim(listener)
        self.output.update(self._step(), self._fill)

    def close(self) -> None:
        """Fall silent, and finish the file if there is one."""
        self.output.close()
        self._streams.clear()

    # Inside -----------------------------------------------------------------------------------------------------------

    @property
    def _mixer(self) -> _core.Mixer | None:
        return self.output.mixer

    def _step(self) -> int:
        """Steps of the game, which never run backward here though a restored world's do."""
        step = self._clock()
        if step < self._last_step:
            self._offset += self._last_step - step
        self._last_step = step
        return step + self._offset

    def _when(self) -> int:
        return self.output.when(self._step())

    def _begin(
        self, sound: Sound, *, sample: _core.Sample | None = None, position: int = 0, fade: int, squared: bool = True
    ) -> None:
        """Give the sound a voice, if there is somebody to play it."""
        fresh = self._mixer is None
        self.output.open()
        if fresh and self._mixer is not None:
            for group in self.groups.values():
                self._send(group, ramp=0)
        sound._sent = sound._gains(self.listener)
        if self._mixer is not None:
            music = self._streams.get(sound)
            sound._voice = self._mixer.start(
                sample=sample,
                stream=music.stream if music else None,
                speed=sound._speed(),
                gains=sound._sent,
                group=sound._group._index,
                position=position,
                loop=(0, sample.frames) if sample and sound.looping else None,
                fade=fade,
                squared=squared,
                when=self._when(),
            )

    def _leave(self, music: Sound | None, frames: int) -> None:
        """End the music, along the curve that keeps the power of a cross-fade."""
        if music is not None:
            music._end("was followed by other music", max(frames, CLICK), squared=False)

    def _jump(self, sound: Sound, seconds: float) -> None:
        """Let another voice play on from there, while the one there was fades."""
        if self._mixer is None or not sound._voice:
            return
        old, when = sound._voice, self._when()
        sample = None
        if sound in self._streams:
            self._streams[sound] = Music(self._sounds.open(sound.name), loop=sound.looping, skip=seconds)
        else:
            sample = self._sounds.load(sound.name).sample
        self._mixer.stop(old, CLICK, True, when)
        self._begin(sound, sample=sample, position=_frame(sound, seconds) if sample else 0, fade=CLICK)

    def _group_changed(self, group: Group) -> None:
        group._note_pause(self._step())
        self._send(group)

    def _send(self, group: Group, ramp: int | None = None) -> None:
        if self._mixer is None:
            return
        frozen = group.paused or (self._paused and group.pauses)
        if ramp is None:
            group._send(self._mixer, frozen=frozen, when=self._when())
        else:
            group._send(self._mixer, frozen=frozen, when=self._when(), ramp=ramp)

    def _fill(self, frames: int) -> None:
        """Keep the streams ahead of what is heard, and drop those that are over."""
        mixer = self._mixer
        if mixer is None:
            return
        mixer.tidy()
        self._streams = {s: music for s, music in self._streams.items() if s._voice and mixer.playing(s._voice)}
        for music in self._streams.values():
            music.fill(frames)


def _frames(seconds: object, owner: str, argument: str) -> int:
    return round(number(seconds, owner, argument, least=0.0, most=LONGEST_FADE) * RATE)


def _frame(sound: Sound, seconds: float) -> int:
    """The frame of the recording at so many seconds."""
    frame = math.floor(seconds * sound._rate)
    if frame >= sound.length * sound._rate - 0.5:
        raise ArgumentError(f"Sound {sound.name!r}: start={seconds!r} is past its end at {sound.length:.3f} s")
    return frame
