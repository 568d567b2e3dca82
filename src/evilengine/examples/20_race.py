"""Race: two players, one screen. Left runs with a and d and jumps with w, right with the arrows; first to the flag."""

import math

import evilengine as evil

NIGHT, DUSK, HILL, WOOD = "#0b1026", "#3a3358", "#1b1f3d", "#11142b"
EARTH, MOSS, PLANK = "#40374f", "#6fa87a", "#a8703f"
game = evil.Game("Race", size=(960, 540), view_height=8)
game.draw(evil.Rectangle(120, 30), colours=[DUSK, DUSK, NIGHT, NIGHT], at=(0, 8), layer=-9)
game.draw(evil.Circle(1.1), at=(6, 7), colour="#fdf3d0", layer=-9)
for layer, parallax, colour, size in ((-7, 0.3, HILL, 5), (-6, 0.6, WOOD, 3)):
    game.layers[layer].parallax = parallax
    for x in range(-40, 41, 5):
        game.draw(evil.Circle(size + math.sin(x * size)), at=(x, math.cos(3 * x) - 4.5), colour=colour, layer=layer)
game.draw(evil.Rectangle(120, 14), colours=["#c8b0ff60", "#c8b0ff60", "#c8b0ff00", "#c8b0ff00"], layer=-5, lit=True)
game.layers[-7].fog, game.layers[-6].fog = "#5a4f7a28", "#5a4f7a18"
for left, right, top in ((-28, -12, 0), (-9, -4, 0.8), (-4, 3, 0), (8, 12, 1.2), (16, 28, 0)):
    game.add(evil.Rectangle(right - left, 6), at=((left + right) / 2, top - 3), kind="static", colour=EARTH, lit=True)
    game.draw(evil.Capsule((left, top), (right, top), 0.1), at=(0, -0.1), colour=MOSS, layer=1, lit=True)


def plank(at, period, way):
    board = game.add(evil.Rectangle(2.4, 0.3, rounding=0.1), at=at, kind="kinematic", colour=PLANK, lit=True)
    board.follow(lambda time: (at[0] + way[0] * math.sin(time / period), at[1] + way[1] * math.sin(time / period)))


plank((5.5, 0.2), 1.0, (1.4, 0))
plank((14, 1.4), 0.8, (0, 1.2))
for number, place in enumerate((-21, -20, -1.5, -0.6, 0.3, 18, 19)):
    game.add(evil.Rectangle(0.7, 0.7), at=(place, 1 + number % 2), colour=PLANK, outline=True, lit=True)
for at, base in ((-24, 0), (-15, 0), (-6, 0.8), (1.5, 0), (10, 1.2), (22, 0)):
    game.draw(evil.Rectangle(0.1, 2.6), at=(at, base + 1.3), colour="#15131f", layer=-1)
    game.draw(evil.Circle(0.16), at=(at, base + 2.7), colour="#fff0c8", layer=-1)
    game.add_light(at=(at, base + 2.7), colour="#ffce8a", radius=7, intensity=1.4)
game.draw(evil.Triangle((25, 1.4), (25, 2.6), (26.2, 2)), colour="#e4572e")
game.ambient, game.post.bloom, game.post.vignette = "#3d4468", 0.5, 0.3
players = [game.add_character(at=at, colour=c, lit=True) for at, c in (((-26, 1), "#ff9d5c"), ((-25, 1), "#6ec6ff"))]
keys = (("a", "d", "w"), ("left", "right", "up"))
game.split(*players)
for view, area in zip(game.views, ((0, 0, 0.497, 1), (0.503, 0, 1, 1)), strict=True):
    view.area, view.camera.bounds = area, (-28, -2.5, 28, 9)
game.add_view((0.3, 0.86, 0.7, 0.98), view_height=7, position=(0, 1.5)).camera.fit(56, 7)  # a map of all of it
says = game.text("a d w - run and jump - arrows", at=(0, 14), size=16, anchor="bottom")


@game.on_update
def run(dt):
    for name, hero, (left, right, jump) in zip(("orange", "blue"), players, keys, strict=True):
        hero.move(game.axis(left, right))
        if jump in game.inputs.pressed:
            hero.jump()
        if hero.position.y < -6:  # it fell
            hero.position = (max(x for x in (-26, -6, 0, 10) if x < hero.position.x + 4), 3)
        if hero.position.x > 25 and "wins" not in says.text:
            says.text = f"{name} wins"


game.run()
