"""Smoke lamp: incense curls round a lamp that swings through it, and lights it from within. Drag the lamp."""

import math

import evilengine as evil

game = evil.Game("Smoke lamp", size=(960, 640))
game.camera.view_height = 7
game.camera.position = (0, 3.1)
game.scene.background = "#0a0810"
game.ambient = 0.12
brass = {"colour": "#b98a46", "lit": True}

game.draw(evil.Rectangle(12, 8), at=(0, 3.3), colour="#5a4658", lit=True, layer=-2, outline=False)
for x in (-4.2, -1.4, 1.4, 4.2):
    game.draw(evil.Rectangle(0.25, 8), at=(x, 3.3), colour="#6e5568", lit=True, layer=-1, outline=False)
game.add(evil.Rectangle(14, 0.6), at=(0, -0.3), kind="static", colour="#4c3a30", lit=True)
beam = game.add(evil.Rectangle(14, 0.4), at=(0, 6.6), kind="static", colour="#4c3a30", lit=True)
for x in (-1.7, 1.7):
    game.add(evil.Polygon([(-0.4, 0), (0.4, 0), (0.25, 0.35), (-0.25, 0.35)]), at=(x, 0), kind="static", **brass)

lamp = game.add(evil.Circle(0.28), at=(2.4, 3.2), colour="#ffe9b8", density=3, touchable=True, damping=0.98)
game.draw(evil.Rectangle(0.04, 4), body=lamp, at=(-1.2, 1.6), angle=math.atan2(2.4, 3.2), colour="#2c2226", layer=-1)
game.world.add_joint(evil.joints.Hinge(beam, lamp, at=(0, 6.4)))
game.add_light(body=lamp, at=(0, 0), colour="#ffc070", radius=7, intensity=1.5, size=0.15)
lamp.velocity = (-2.5, 0)
ball = game.add(evil.Circle(0.3), at=(-3.4, 0.4), colour="#7a4c5c", lit=True, touchable=True, density=0.4)

smoke = game.add_smoke(
    (-5.4, 0, 5.4, 6.4), cells=192, open_sides="left right", buoyancy=0.25, vorticity=2, cooling=0.5, fade=0.05,
    quality="high", ramp=["#c8c4d800", "#c8c4d880", "#e2dff0e0"], opacity=2.2, glow=0, layer=1,
)  # fmt: skip
smoke.add_source(at=(-1.7, 0.45), radius=0.1, rate=14, temperature=1.2)
smoke.add_source(at=(1.7, 0.45), radius=0.1, rate=14, temperature=1.2, colour="#8fb6d8")

game.text("Smoke lamp: drag the lamp through the smoke", at=(16, 12), size=18, colour="#c8b8c8")
game.run()
