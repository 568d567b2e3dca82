"""Campfire: a fire under the night sky that lights the clearing; stir it by hand, and roll logs into its draught."""

import math

import evilengine as evil

game = evil.Game("Campfire", size=(960, 640))
game.camera.view_height = 8
game.camera.position = (0, 3.5)
game.scene.background = "#05070f"
game.ambient, game.post.bloom, game.post.vignette = "#3c4668", 0.3, 0.3
bark = {"colour": "#8a5a32", "lit": True, "touchable": True, "friction": 0.8}

night = ["#2b2440", "#2b2440", "#070a18", "#070a18"]
game.draw(evil.Polygon([(-8, 0), (8, 0), (8, 8), (-8, 8)]), colours=night, layer=-5, outline=False)
for _ in range(60):
    star = evil.Circle(game.random.uniform(0.008, 0.022))
    at = (game.random.uniform(-6.5, 6.5), game.random.uniform(2.5, 7.6))
    game.draw(star, at=at, colour=(0.8, 0.85, 1, game.random.uniform(0.2, 0.9)), layer=-5, outline=False)
for colour, low, rough, lit, layer in (("#171d3c", 1.9, 0.7, False, -4), ("#3b4a34", 0.7, 0.25, True, -3)):
    ridge = [(0.5 * k, low + rough * math.sin(1.1 * k + low) * math.sin(2.3 * k)) for k in range(16, -17, -1)]
    game.draw(evil.Polygon([(-8, -0.1), (8, -0.1), *ridge]), colour=colour, lit=lit, layer=layer, outline=False)
for x, height, shade in ((-5.4, 5.4, "#4a7350"), (-3.9, 3.8, "#5f9163"), (3.6, 4.1, "#5f9163"), (5.2, 5.8, "#4a7350")):
    for part in range(3):
        low, wide = -0.05 + part * height / 4, 1.3 - 0.3 * part
        corners = [(x - wide, low), (x + wide, low), (x, low + height / 2)]
        game.draw(evil.Polygon(corners), colour=shade, lit=True, layer=-2, outline=False)
game.add(evil.Rectangle(16, 1), at=(0, -0.5), kind="static", colour="#7d6248", lit=True)
for x, radius in ((-1.05, 0.24), (-0.7, 0.17), (0.72, 0.19), (1.1, 0.25)):
    game.add(evil.Circle(radius), at=(x, radius - 0.06), kind="static", colour="#a9aab4", lit=True)
for x, angle in ((-0.22, 0.5), (0.22, -0.5)):
    game.add(evil.Capsule((-0.42, 0), (0.42, 0), 0.09), at=(x, 0.28), angle=angle, kind="static", **bark)
game.add(evil.Capsule((-0.5, 0), (0.5, 0), 0.13), at=(2.7, 0.2), **bark)
game.add(evil.Capsule((-0.4, 0), (0.4, 0), 0.12), at=(-2.8, 0.2), **bark)
leaves = [game.add(evil.Rectangle(0.13, 0.06), at=(0.5 * k - 1.6, 4 + 0.4 * (k % 3)), density=0.03, colour="#8a6a30",
                   lit=True, category=2) for k in range(6)]  # fmt: skip

smoke = game.add_smoke(
    (-4, 0, 4, 8), cells=192, open_sides="top left right", buoyancy=0.75, vorticity=8, cooling=1.3, fade=0.2,
    burning=2.2, heat=2.2, soot=0.35, colour="#8d8985", opacity=1.1, glow=6, light_radius=15, layer=1,
)  # fmt: skip
flames = smoke.add_source(evil.Rectangle(0.7, 0.15), at=(0, 0.5), fuel=5, temperature=0.8)


@game.on_update
def draught(_dt):
    """A wind that comes and goes, and the player's hand."""
    smoke.wind = (game.random.uniform(-1.2, 1.2), 0)
    flames.fuel = game.random.uniform(2, 8)
    for lamp in game.lights:
        lamp.mask = 1  # leaves throw no shadows
    for touch in game.touches:
        smoke.stir(touch.at, radius=0.6, velocity=(0, 2))


game.text("Campfire: stir the fire, roll the logs", at=(16, 12), size=18, colour="#c8b090")
game.run()
