"""What a saved game keeps of what is heard: which sounds play, how far they are, and the groups."""

from __future__ import annotations

from collections.abc import Callable, Container
from typing import Any

from evilengine.audio.audio import Audio
from evilengine.audio.groups import LOUDEST, MOST_GROUPS
from evilengine.audio.sound import Sound
from evilengine.values.checks import number
from evilengine.values.vec2 import Vec2, to_vec2

Reference = list[Any] | None


def state_of(audio: Audio, reference: Callable[[object], Reference]) -> dict[str, Any]:
    """The groups and every sound; `reference` names the body that a sound goes along with."""
    return {
        "groups": [[group.name, group.volume, group.paused, group.pauses] for group in audio.groups.values()],
        "sounds": [_row(audio, sound, reference) for sound in audio.sounds],
    }


def _row(audio: Audio, sound: Sound, reference: Callable[[object], Reference]) -> dict[str, Any]:
    at = sound._at
    return {
        "name": sound.name, "group": sound.group, "loop": sound.looping, "volume": sound.volume, "pitch": sound.pitch,
        "pan": sound.pan, "at": ["point", *at] if isinstance(at, Vec2) else reference(at), "start": sound.position,
        "music": sound is audio._music, "streamed": sound in audio._streams or sound is audio._music,
    }  # fmt: skip


def read(audio: Audio, state: dict[str, Any], bodies: Container[int]) -> Callable[[Callable[[int], Any]], None]:
    """Read what `state_of` gave, and return what puts it in place, given what finds a body by its slot.

    Raises AssetError for sounds that are not to be had. Music that was fading away when the game was saved stays away.
    """
    groups = [
        (str(name), number(volume, "group", "volume", least=0.0, most=LOUDEST), bool(paused), bool(pauses))
        for name, volume, paused, pauses in state["groups"]
    ]
    if len({*audio.groups, *(name for name, *_ in groups)}) > MOST_GROUPS or not all(name for name, *_ in groups):
        raise ValueError("groups that cannot be")
    rows: list[tuple[dict[str, Any], Reference]] = []
    for row in state["sounds"]:
        if row["streamed"] and not row["music"]:
            continue
        length = audio._sounds.open(row["name"]).seconds if row["music"] else audio._sounds.load(row["name"]).seconds
        if row["group"] not in {*audio.groups, *(name for name, *_ in groups)}:
            raise ValueError("a sound of no group")
        start = number(row["start"], "sound", "start", least=0.0)
        if start >= length - 0.01:  # it was over before anybody could hear it
            continue
        options = {
            "volume": number(row["volume"], "sound", "volume", least=0.0, most=LOUDEST),
            "loop": bool(row["loop"]), "group": row["group"], "start": start,
        }  # fmt: skip
        at: Reference = None
        if not row["music"]:
            options["pitch"] = number(row["pitch"], "sound", "pitch", least=0.0625, most=4.0)
            options["pan"] = number(row["pan"], "sound", "pan", least=-1.0, most=1.0)
            at = _checked(row["at"], bodies)
        rows.append(({"name": str(row["name"]), **options}, at))

    def put(body: Callable[[int], Any]) -> None:
        audio.stop()
        for name, volume, paused, pauses in groups:
            group = audio.groups[name] if name in audio.groups else audio.groups.add(name, pauses=pauses)
            group.volume, group.paused = volume, paused
        for options, at in rows:
            if "pitch" not in options:
                audio.music(options.pop("name"), fade=0.0, **options)
            elif at is None:
                audio.play(options.pop("name"), **options)
            else:
                audio.play(options.pop("name"), at=body(at[1]) if at[0] == "body" else Vec2(*at[1:]), **options)

    return put


def _checked(at: Any, bodies: Container[int]) -> Reference:
    match at:
        case None:
            return None
        case ["body", slot] if slot in bodies:
            return ["body", slot]
        case ["point", x, y]:
            return ["point", *to_vec2((x, y), "sound", "at")]
        case _:
            raise ValueError("a sound that is nowhere")
