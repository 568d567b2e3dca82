"""Nightwood: a wood at night, in fog. Arrows walk, space jumps; the lamp swings as you go, and fireflies wander."""

import math

import evilengine as evil

game = evil.Game("Nightwood", size=(960, 540), view_height=11)
dice = game.random
game.add_background("#0f1722")
for size, colour in ((6.5, "#a8c4e816"), (4.2, "#a8c4e824"), (2.4, "#b8d0f038"), (1.1, "#e8f0fa")):  # the moon
    game.draw(evil.Circle(size), at=(5.5, 3.6), colour=colour, layer=-6)


def tree(x, width, **looks):
    lean = dice.uniform(-0.6, 0.6)
    game.draw(evil.Polygon([(x - width, -6), (x + width, -6), (x + 0.4 * width + lean, 7), (x + lean, 7)]), **looks)
    for branch in range(5):
        y, reach = -1.2 + 1.6 * branch + dice.uniform(-0.4, 0.4), dice.choice((-1, 1)) * dice.uniform(1.2, 2.8)
        x0, rise, half = x + lean * (y + 6) / 13, 0.2 * abs(reach), 0.55 * reach
        bend = [(x0 + half, y + rise), (x0 + reach, y + dice.uniform(1.5, 3) * rise), (x0 + half, y + rise + 0.12)]
        game.draw(evil.Polygon([(x0, y - 0.3 * width), *bend, (x0, y + 0.45 * width)]), **looks)


for layer, parallax, trees, width in ((-5, 0.15, 13, 0.2), (-4, 0.3, 9, 0.35), (-3, 0.5, 6, 0.5)):
    for number in range(trees):
        tree(-13 + 26 * (number + 0.8 * dice.random()) / trees, width, layer=layer, colour="#0a1018")
    game.layers[layer].parallax, game.layers[layer].fog = parallax, ["#4a658080", "#2a3e5430"]
game.layers[-6].parallax, game.layers[-4].blur, game.layers[-3].blur, game.layers[-3].fog_lit = 0.1, 1, 2, True
game.layers[-3].shafts.colour, game.layers[-3].shafts.threshold = "#b8cdf0", 0.22
for x in (-7.2, -1.6, 3.4, 8.3):
    tree(x, 0.55, layer=-1, colour="#3f3730", lit=True)
hills = [(-14, -3.6), (-9, -4.3), (-5, -4.1), (-1, -4.6), (3, -4.4), (6, -3.9), (10, -4.2), (14, -3.4)]
earth = game.add(evil.Polygon([*hills, (14, -8), (-14, -8)]), kind="static", colour="#4a5240", lit=True)
for x, y, half in ((1, 1.6, 1.6), (-5, 2.4, 1.1)):  # boughs that hang and swing
    bough = game.add(evil.Capsule((-half, 0), (half, 0), 0.12), at=(x, y), velocity=(1.5, 0), colour="#332", lit=True)
    bough.draw(evil.Polygon([(-half, 0), (0, 4.95), (half, 0), (0.03, 5), (-0.03, 5)]), colour="#12100e")
    game.world.add_joint(evil.joints.Hinge(bough, earth, at=(x, y + 5)))
game.drive(hero := game.add_character(evil.Capsule((0, -0.45), (0, 0.45), 0.28), at=(-6, -2.5), colour="#07090c"))
for x in (-0.09, 0.09):  # eyes
    game.draw(evil.Circle(0.042), body=hero.body, at=(x, 0.48), colour="#e8f4ff", layer=1)
lamp = game.add(evil.Circle(0.13), at=(-5.4, -2.7), colour="#fff0c4", sensor=True, density=2)
game.world.add_joint(evil.joints.Rope(hero.body, lamp, length=0.55))
game.add_light(body=lamp, radius=9, size=0.2, temperature=2600, intensity=3.2)
flies = [game.add_light(at=(0, 0), radius=2.2, colour="#d8ff7a", intensity=0.9, shadows=False) for _ in range(6)]
dot = {"life": 0.5, "speed": 0.05, "cone": 6.28, "size": [0.16, 0], "colour": "#e6ff9c", "blend": "add", "layer": 3}
glows = [game.add_particles(rate=40, gravity_scale=0, **dot) for _ in flies]
mist = {"area": (26, 2), "size": [2, 5], "colour": ["#7d94a800", "#7d94a828", "#7d94a800"], "layer": 2, "speed": 0}
game.add_particles(at=(0, -3.6), rate=5, life=9, gravity_scale=0, drag=1, wind=(0.3, 0), **mist)
game.ambient, game.post.bloom, game.post.vignette, game.post.grain = "#1c2836", 0.5, 0.5, 0.03


@game.on_update
def wander(dt):
    for n, (light, glow) in enumerate(zip(flies, glows, strict=True)):
        time = game.world.steps * (0.0022 + 0.0005 * n) + 2.4 * n
        light.at = glow.at = (7 * math.sin(time) + 2 * math.sin(2.7 * time), -1.6 + 1.4 * math.cos(1.9 * time + n))
    game.camera.position, game.layers[-3].shafts.at = (0.25 * hero.position.x, 0), (5.5 + 0.1 * hero.position.x, 3.6)


game.run()
