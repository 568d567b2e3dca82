"""Hero: walk, jump, climb and push your way to the flag. Arrows and space; tab changes who you are."""

import math
from itertools import pairwise

import evilengine as evil

SKY, HAZE, SUN, FAR, NEAR, EARTH, GRASS = "#27264d", "#f2a65a", "#ffe3a8", "#8a5a7c", "#5a3f6e", "#2a2038", "#7fb069"
game = evil.Game("Hero", size=(960, 540), view_height=9)
game.draw(evil.Rectangle(90, 26), colours=[HAZE, HAZE, SKY, SKY], at=(0, 9), layer=-9)
for x, y, size, colour in ((3, 4, 1.7, SUN), (-16, -3, 8, FAR), (13, -4, 9, FAR), (-7, -7, 8, NEAR), (6, -8, 9, NEAR)):
    game.draw(evil.Circle(size), at=(x, y), colour=colour, layer=-8)


def ground(*corners):  # with grass along its top
    game.add(evil.Polygon([*corners, (corners[-1][0], -12), (corners[0][0], -12)]), kind="static", colour=EARTH)
    for here, there in pairwise(corners):
        game.draw(evil.Capsule(here, there, 0.12), at=(0, -0.12), colour=GRASS, layer=2)


def plank(width, at, kind="static", **options):
    return game.add(evil.Rectangle(width, 0.3, rounding=0.1), at=at, kind=kind, colour="#a8703f", **options)


ground((-26, 6), (-25, 0), (-14, 0), (-10, 1.8), (-8, 1.8), (-6, 0), (1, 0))  # hills, and a yard with crates
ground((5, 0), (6, 0), (6, 0.3), (6.5, 0.3), (6.5, 0.6), (7, 0.6), (7, 0.9), (11, 0.9))  # stairs
ground((15, 0.9), (25, 0.9), (26, 7))
for at in ((-3.5, 0.5), (-2.4, 0.5), (-3, 1.5)):
    game.add(evil.Rectangle(1, 1), at=at, colour="#a8703f", outline=True)
plank(2.2, (3, 0), "kinematic").follow(lambda time: (3 - 0.7 * math.cos(time), -0.15 + 0.1 * math.sin(3 * time)))
plank(2, (13, 1), "kinematic").follow(lambda time: (13, 2.2 - 1.5 * math.cos(0.8 * time)))
plank(2.2, (8.2, 2.9), one_way=True)
plank(5, (18.5, 1.05), surface_speed=-3)
plank(2, (24.5, 4.95))
for rung in range(11):
    game.draw(evil.Rectangle(0.8, 0.08), at=(23, 1.1 + 0.4 * rung), colour="#d9b779", layer=-1)
game.draw(evil.Triangle((24.8, 5.1), (24.8, 6.8), (25.7, 6.3)), colour="#e4572e")

fox = game.add_character(at=(-18, 1), colour="#f26430", air_jumps=1, speed=6, ladders=[(22.6, 0.9, 23.4, 5.1)])
bear = game.add_character(evil.Circle(0.6), at=(-20, 1), colour="#8a6a57", push_force=150, ladders=fox.ladders)
eyes = [game.draw(evil.Circle(0.1), body=who.body, colour="white", layer=3) for who in (fox, bear)]
heroes, game.camera.position = [bear, fox], (-17, 2)
game.text("arrows walk and climb, space jumps, tab changes who you are", at=(0, 14), size=16, anchor="top")


@game.on_update
def look(dt):
    if "tab" in game.inputs.pressed or not game.world.steps:
        heroes.reverse()
        game.drive(heroes[0])
    hero, camera = heroes[0], game.camera
    if hero.position.y < -9:  # it fell
        hero.position = (-18, 2)
    aim = camera.position + (hero.position + (0.3 * hero.velocity.x, 1.2) - camera.position) * (3 * dt)
    camera.position = (min(max(aim.x, -18), 18), min(max(aim.y, 1), 5))
    for who, eye in zip((fox, bear), eyes, strict=True):  # they look where they go
        eye.place((0.2 * math.tanh(who.velocity.x), 0.4 if who is fox else 0.2))


game.run()
