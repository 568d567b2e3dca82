"""Lanterns: two lamps on chains that swing over crates, moonlight through a window, and shadows that follow."""

import math

import evilengine as evil

game = evil.Game("Lanterns", size=(960, 540))
world = game.world
wood = {"colour": "#a97c50", "lit": True, "touchable": True, "friction": 0.7}
stone = {"kind": "static", "colour": "#8d8a86", "lit": True, "outline": False}

for row in range(12):
    for column in range(-7, 8):
        at = (1.4 * column + 0.7 * (row % 2), row - 5.5)
        shade = "#7d6f66" if (3 * row + 5 * column) % 4 else "#86786c"
        game.draw(evil.Rectangle(1.37, 0.97), at=at, colour=shade, lit=True, layer=-1, outline=False)
game.add(evil.Rectangle(20, 1), at=(0, -4.9), **stone)
ceiling = game.add(evil.Rectangle(20, 0.6), at=(0, 5.2), **stone)
for low, high in ((-5, 0.6), (2.6, 5)):
    game.add(evil.Rectangle(0.7, high - low), at=(-9.4, (low + high) / 2), **stone)
game.add(evil.Rectangle(0.7, 10), at=(9.4, 0), **stone)
for x, y, side in (
    (-3, -3.9, 1),
    (-1.8, -3.9, 1),
    (-2.5, -2.9, 0.9),
    (3.4, -3.8, 1.2),
    (5.6, -4, 0.8),
    (5.5, -3.2, 0.7),
):
    game.add(evil.Rectangle(side, side), at=(x, y), **wood)
game.add(evil.Circle(0.55), at=(1.2, -3.8), **(wood | {"colour": "#9a4b3c"}))
game.add(evil.Rectangle(3.2, 0.2), at=(-6.4, -1), **stone)
game.add(evil.Circle(0.35), at=(-6.6, -0.5), **(wood | {"colour": "#5b7f8f"}))


def hang(x, length, **looks):
    """A lantern on a rod from the ceiling; the light comes out of it."""
    lantern = game.add(evil.Circle(0.16), at=(x, 4.9 - length), colour="#fff2cf", density=4, touchable=True)
    rod = game.add(evil.Rectangle(0.04, length), at=(x, 4.9 - length / 2), colour="#332c28", sensor=True, layer=-1)
    world.add_joint(evil.joints.Hinge(rod, ceiling, at=(x, 4.9)))
    world.add_joint(evil.joints.Weld(lantern, rod, at=lantern.position))
    game.add_light(body=lantern, radius=11, size=0.16, intensity=2.2, **looks)
    return lantern


left = hang(-1.2, 2.6, temperature=3300)
right = hang(4.3, 3.4, temperature=2700)
left.velocity, right.velocity = (3.5, 0), (-2, 0)

game.ambient = "#1b2036"
game.add_light(direction=(math.cos(-0.42), math.sin(-0.42)), colour="#8fb0ff", intensity=0.55, size=0.03)  # the moon
game.text("drag the lanterns and the crates", at=(30, 20), colour="#c9b898")
game.run()
