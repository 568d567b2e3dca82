"""Ropes: links on hinges. A lamp hangs on one, a ball swings on another, and a third lies over a beam."""

import evilengine as evil

game = evil.Game("Ropes", size=(960, 540))
game.add_background("#10141f")
world = game.world

game.add(evil.Rectangle(20, 0.6), at=(0, -4.9), kind="static", colour="#2d3250")
for side in (-1, 1):
    game.add(evil.Rectangle(0.6, 12), at=(side * 9.8, 0), kind="static", colour="#2d3250")
beam = game.add(evil.Rectangle(14, 0.4), at=(0, 4.6), kind="static", colour="#424769")
rail = game.add(evil.Circle(0.5), at=(5.5, 1), kind="static", colour="#424769")


def hang(start, end, pieces, thing, colour):
    """A rope from the beam at `start`, with a thing tied to its end."""
    rope = evil.soft.rope(world, start, end, pieces=pieces, thickness=0.12, add=game.add, colour=colour, touchable=True)
    world.add_joint(evil.joints.Hinge(beam, rope.first, at=start))
    world.add_joint(evil.joints.Hinge(rope.last, thing, at=end))
    return rope


lamp = game.add(evil.Rectangle(1, 0.6), at=(-5, 0.2), mass=1, colour="#f9b17a", touchable=True)
hang((-5, 4.4), (-5, 0.5), 14, lamp, "#8d8aa6")

ball = game.add(evil.Circle(0.5), at=(3.5, 4.4), mass=20, colour="#d1495b", touchable=True)
hang((-1, 4.4), (3.5, 4.4), 16, ball, "#a6a2c2")

loose = evil.soft.rope(
    world, (2.9, 1.8), (8.1, 1.8), pieces=20, thickness=0.14, add=game.add, colour="#7fb685", touchable=True, friction=1
)

for row in range(4):
    for place in range(3):
        game.add(
            evil.Rectangle(0.7, 0.7), at=(-2.9 + 0.72 * place, -4.25 + 0.7 * row), colour="#676f9d", touchable=True
        )

game.text("drag anything", at=(30, 20), colour="#676f9d")
game.run()
