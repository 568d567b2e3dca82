"""What a saved game keeps of a scene, and the scene that comes of it."""

from __future__ import annotations

from collections.abc import Callable, Container
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.scene.animated import Clip
from evilengine.scene.camera import Camera
from evilengine.scene.camera_work import Followed, read_work
from evilengine.scene.drawing import Drawing
from evilengine.scene.layers import Layers
from evilengine.scene.particles import EmittersState
from evilengine.scene.post import Post
from evilengine.scene.saving_lights import SavedLights, lights_state
from evilengine.scene.text import Text
from evilengine.values.colour import Colour
from evilengine.values.sheet import Animation, Normals, Sheet

if TYPE_CHECKING:
    from evilengine.scene.scene import Scene


def state_of(scene: Scene) -> tuple[bytes, dict[str, Any]]:
    """Every drawing as bytes, and the rest: names of images, background, texts."""
    drawings, textures, clips = scene._core.snapshot(scene.world._core)
    texts = [
        [
            *(text._serial, [[letters, colour and list(colour)] for letters, colour in text._pieces], list(text.at)),
            *(text.size, list(text.colour), text.anchor, bool(text.visible), text.font, text.width, text.align),
        ]
        for text in scene._texts
        if text.alive
    ]
    rest = {
        "textures": [_plain(scene._texture_names[texture]) for texture in textures],
        "clips": [[clip.sheet.plain(), *clip[1:]] for clip in (scene._clips[number] for number in clips)],
        "background": list(scene.background),
        "from_palette": scene._from_palette,
        "texts": texts,
        "texts_made": scene._texts_made,
        "backgrounds": scene.backgrounds,
        "emitters_made": scene._emitters_made,
        "layers": scene.layers.state(),
        "post": scene.post.state(),
        "lights": lights_state(scene.lights),
        "gases": scene.gases.state(),
        "waters": scene.waters.state(),
    }
    return drawings, rest


class SceneState:
    """A scene that was read, and what it would become; nothing has changed before `put`.

    Raises AssetError for images that are not to be had, and ValueError, TypeError or KeyError for what is no scene.
    """

    def __init__(self, scene: Scene, drawings: bytes, rest: dict[str, Any]) -> None:
        self._scene = scene
        self._drawings = _core.SavedScene(drawings)
        self.places = self._drawings.places
        """(slot, slot of the body, slot of the shape) of each drawing, in the order of creation."""
        self._by_slot = {slot: (body, shape) for slot, body, shape in self.places}
        self._gases = scene.gases.read(rest.get("gases", []))
        self._waters = scene.waters.read(rest.get("waters", []))
        self._textures = [self._gases.texture(row) or _texture(scene, row) for row in rest["textures"]]
        if len(self._textures) != self._drawings.textures:
            raise ValueError("an image for each texture")
        self._clips = [scene._clip_number(_clip(row)) for row in rest["clips"]]
        if len(self._clips) != self._drawings.clips:
            raise ValueError("a clip for each number")
        self._background = Colour(*rest["background"])
        self._from_palette = int(rest["from_palette"])
        self._texts_made = int(rest["texts_made"])
        self._backgrounds = int(rest.get("backgrounds", 0))
        self._emitters_made = int(rest.get("emitters_made", 0))
        self._layers = scene.layers.read(rest.get("layers", Layers().state()))
        self._post = scene.post.read(rest.get("post", Post().state()))
        self._lights = SavedLights(scene.lights, rest.get("lights"))
        self._texts = {int(row[0]): _text(row) for row in rest["texts"]}

    @property
    def slots(self) -> set[int]:
        """The slots in which there will be drawings."""
        return set(self._by_slot)

    @property
    def lit_by(self) -> list[int]:
        """The slots of the bodies that lights are on, NO_SLOT for each that is on none."""
        return self._lights.bodies

    @property
    def light_slots(self) -> set[int]:
        """The slots in which there will be lights."""
        return set(self._lights.slots)

    @property
    def texts(self) -> set[int]:
        """The serial numbers of the texts that there will be."""
        return set(self._texts)

    def put(self) -> None:
        """Become what was saved. The world must have been restored, and be one in which `places` is true.

        Handles of drawings and texts that are the same before and after stay good.
        """
        scene = self._scene
        scene._core.restore(self._drawings, scene.world._core, self._textures, self._clips)
        scene.background = self._background
        scene._from_palette = self._from_palette
        scene.backgrounds = self._backgrounds
        scene._emitters_made = self._emitters_made
        scene.layers.become(self._layers)
        scene.post.become(self._post)
        self._lights.put()
        self._gases.put()
        scene.waters.put(self._waters)
        self._put_drawings()
        self._put_texts()

    def drawing(self, slot: int) -> Drawing:
        """The drawing in a slot, after `put`."""
        return self._scene._drawing(slot, *self._by_slot[slot])

    def text(self, serial: int) -> Text:
        """The text of that number, after `put`."""
        return next(text for text in self._scene._texts if text._serial == serial)

    def _put_drawings(self) -> None:
        scene = self._scene
        scene._restores += 1
        scene._restored = {}
        generation = scene.world._core.body_generation
        for slot, body, shape in self.places:
            if body != _core.NO_SLOT:
                scene._restored.setdefault((body, generation(body)), []).append((slot, body, shape))

    def _put_texts(self) -> None:
        scene, texts = self._scene, []
        known = {text._serial: text for text in scene._texts if text.alive}
        for serial, saved in self._texts.items():
            text = known.pop(serial, saved)
            for part in ("at", "size", "colour", "anchor", "visible", "font", "width", "align"):
                setattr(text, part, getattr(saved, part))
            text._pieces = saved._pieces
            texts.append(text)
        for text in known.values():
            text.destroy()
        scene._texts, scene._texts_made = texts, self._texts_made


def emitters_state(scene: Scene) -> tuple[list[dict[str, Any]], list[bytes]]:
    """What each emitter was told, and its particles as bytes."""
    particles = [emitter._core.snapshot() for emitter in scene._emitters]
    rows = [emitter._state() for emitter in scene._emitters]
    return [{**row, "bytes": len(data)} for row, data in zip(rows, particles, strict=True)], particles


def read_emitters(scene: Scene, rows: list[dict[str, Any]], data: bytes, bodies: set[int]) -> EmittersState:
    """Read what `emitters_state` gave; the particles one after the other."""
    particles, at = [], 0
    for row in rows:
        particles.append(data[at : at + int(row["bytes"])])
        at += int(row["bytes"])
    return EmittersState(scene, rows, particles, bodies)


def camera_state(camera: Camera) -> dict[str, Any]:
    """What a saved game keeps of a camera; the size of the screen is the device's."""
    return {
        "position": list(camera.position), "zoom": camera.zoom, "angle": camera.angle,
        "fit": None if camera._fit is None else list(camera._fit), "work": camera._work_state(),
    }  # fmt: skip


def read_camera(
    camera: Camera, state: dict[str, Any], bodies: Container[int]
) -> Callable[[Callable[[int], Followed]], None]:
    """Read what `camera_state` gave, and return what puts it in place, given who finds bodies by their slots."""
    read = Camera(position=state["position"], zoom=state["zoom"], angle=state["angle"])
    if state["fit"] is not None:
        width, height = state["fit"]
        if width:
            read.fit(width, height)
        else:
            read.view_height = height

    work = read_work(state["work"], bodies)

    def put(body: Callable[[int], Followed]) -> None:
        camera._fit = read._fit
        camera.position, camera.zoom, camera.angle = read.position, read.zoom, read.angle
        work(camera, body)

    return put


def _plain(what: str | Normals) -> str | list[str]:
    return what if isinstance(what, str) else ["normals", str(what.of)]


def _texture(scene: Scene, row: str | list[str]) -> int:
    if isinstance(row, str):
        return scene.texture_id(row, "Scene.restore")
    kind, name = row
    if kind != "normals":
        raise ValueError(f"{kind!r} is no kind of image")
    return scene.texture_id(name, "Scene.restore", "normal_map")


def _clip(row: list[Any]) -> Clip:
    plain, name, frames, fps, course = row
    sheet = Sheet.of_plain(plain)
    Animation(frames, fps=fps, course=course)  # raises for what it cannot be
    if max(frames) >= len(sheet):
        raise ValueError("a frame that the sheet does not have")
    return Clip(sheet, None if name is None else str(name), tuple(frames), float(fps), course)


def _text(row: list[Any]) -> Text:
    serial, pieces, at, size, colour, anchor, visible, font, width, align = row
    text = [(str(letters), None if own is None else Colour(*own)) for letters, own in pieces]
    shown = Text(text, at, size, Colour(*colour), anchor, bool(visible), serial=int(serial))
    shown.font, shown.width, shown.align = font, width, align
    return shown
