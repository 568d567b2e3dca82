"""Soft things: blobs and a block of jelly, bodies on springs, that land, give, and can be dragged about."""

import evilengine as evil

game = evil.Game("Jelly", size=(960, 540))
game.add_background("#1b1b2f")
world = game.world
wall = {"kind": "static", "colour": "#2a2a4a", "friction": 0.8}

game.add(evil.Rectangle(20, 0.6), at=(0, -5), **wall)
for side in (-1, 1):
    game.add(evil.Rectangle(0.6, 12), at=(side * 9.5, 0), **wall)
    game.add(evil.Rectangle(5, 0.3), at=(side * 5, -1.2), angle=-0.35 * side, **wall)

soft = []
for at, radius, colour in (((-5, 3), 1.1, "#e94560"), ((5.2, 2.5), 0.9, "#53d8fb"), ((0.5, 4), 1.3, "#a2d729")):
    soft.append(
        evil.soft.blob(world, at, radius=radius, frequency=3, add=game.add, density=0.5, colour=colour, touchable=True)
    )
soft.append(
    evil.soft.jelly(
        world, (0, -2.6), width=3, height=2, columns=7, rows=5, frequency=8, add=game.add, density=0.5,
        colour="#f9c80e", touchable=True,
    )
)  # fmt: skip

skins = [[game.draw(evil.Rectangle(1, 0.1), colour="#ffffff60", layer=1) for _ in each.outline] for each in soft]


@game.on_draw
def stretch_skins():
    for each, skin in zip(soft, skins, strict=True):
        for thread, a, b in zip(skin, each.outline, (*each.outline[1:], each.outline[0]), strict=True):
            span = b.position - a.position
            turned = evil.Mat4.translation(*(a.position + span / 2)) @ evil.Mat4.rotation(span.angle)
            thread.matrix = turned @ evil.Mat4.scale(span.length, 1)


game.text("drag them", at=(30, 20), colour="#8888aa")
game.run()
