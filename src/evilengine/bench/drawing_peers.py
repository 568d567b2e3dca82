"""Who draws the crowd of `evil bench draw` beside us, each in the way that its own documentation has."""

from __future__ import annotations

import importlib
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from evilengine.bench.crowd import SIDE, SIZE, Sprite
from evilengine.values.tick import STEP


class Pygame:
    """pygame-ce: `Surface.fblits` on the processor. It turns nothing: turned pictures would be made one by one."""

    name = "pygame-ce"
    turns = False

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
        self._pygame: Any = importlib.import_module("pygame")
        self._target = self._pygame.Surface(SIZE)
        self._picture = self._pygame.image.load(str(file))
        self._places = [[each.x, each.y, each.vx, each.vy] for each in sprites]

    def prepare(self) -> None: ...

    def step(self) -> None:
        for place in self._places:
            place[0] += place[2] * STEP
            place[1] += place[3] * STEP
        self._target.fill((28, 33, 48))
        self._target.fblits([(self._picture, (place[0], place[1])) for place in self._places])


class Arcade:
    """arcade: a SpriteList, without a window."""

    name = "arcade"
    turns = True

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        os.environ["ARCADE_HEADLESS"] = "True"
        arcade: Any = importlib.import_module("arcade")
        self._window = arcade.open_window(*SIZE, "bench")
        self._list = arcade.SpriteList()
        texture = arcade.load_texture(str(file))
        for each in sprites:
            sprite = arcade.Sprite(texture, center_x=each.x, center_y=each.y)
            sprite.change_x, sprite.change_y, sprite.change_angle = each.vx * STEP, each.vy * STEP, each.spin
            self._list.append(sprite)

    def prepare(self) -> None:
        self._window.switch_to()
        self._window.ctx.screen.use(force=True)

    def step(self) -> None:
        self._list.update()
        self._window.clear()
        self._list.draw()
        self._window.ctx.finish()


class Pyglet:
    """pyglet: a Batch of sprites, without a window."""

    name = "pyglet"
    turns = True

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        pyglet: Any = importlib.import_module("pyglet")
        pyglet.options["headless"] = True
        self._gl: Any = importlib.import_module("pyglet.gl")
        self._window = importlib.import_module("pyglet.window").Window(*SIZE)
        image = importlib.import_module("pyglet.image").load(str(file))
        graphics = importlib.import_module("pyglet.graphics")
        sprite: Any = importlib.import_module("pyglet.sprite").Sprite
        self._batch = graphics.Batch()
        self._sprites = [(sprite(image, each.x, each.y, batch=self._batch), each) for each in sprites]

    def prepare(self) -> None:
        self._window.switch_to()

    def step(self) -> None:
        for sprite, each in self._sprites:
            turned = sprite.rotation + each.spin
            sprite.update(x=sprite.x + each.vx * STEP, y=sprite.y + each.vy * STEP, rotation=turned)
        self._window.clear()
        self._batch.draw()
        self._gl.glFinish()


class Pyxel:
    """pyxel: `blt` on the processor, in sixteen colours, of which one is clear; what it turns has hard edges."""

    name = "pyxel"
    turns = False
    _picture: Any

    def __init__(self, sprites: Sequence[Sprite], file: Path) -> None:
        os.environ.setdefault("SDL_AUDIODRIVER", "dummy")
        self._pyxel: Any = importlib.import_module("pyxel")
        if not hasattr(Pyxel, "_picture"):  # it begins once a process
            self._pyxel.init(*SIZE, headless=True)
            Pyxel._picture = self._pyxel.Image(SIDE, SIDE)
            Pyxel._picture.load(0, 0, str(file))
        self._places = [[each.x, each.y, each.vx, each.vy] for each in sprites]

    def prepare(self) -> None: ...

    def step(self) -> None:
        for place in self._places:
            place[0] += place[2] * STEP
            place[1] += place[3] * STEP
        self._pyxel.cls(1)
        picture, blt = self._picture, self._pyxel.blt
        for place in self._places:
            blt(place[0], place[1], picture, 0, 0, SIDE, SIDE, 0)
        self._pyxel.flip()


PEERS: dict[str, Any] = {each.name: each for each in (Pygame, Pyxel, Arcade, Pyglet)}
"""Who draws the same beside us: `pip install 'evilengine[bench-draw]'` brings them."""
