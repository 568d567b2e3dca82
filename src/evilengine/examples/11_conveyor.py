"""A factory: belts, ledges solid from above, a draught, a lake that floats things, and a sensor that counts."""

import evilengine as evil

game = evil.Game("Conveyor", size=(960, 540))
game.add_background("#10141f")
score = game.text("in the lake: 0", at=(20, 20), size=22, colour="#ffd166")

for left, y, speed in ((-8, 3, 2.5), (-5, 0.6, -2)):  # one above the other, against each other
    belt = evil.Rectangle(7, 0.4)
    game.add(belt, at=(left + 3.5, y), kind="static", surface_speed=speed, friction=0.8, colour="#4d908e")
for y in (-1.2, 1.2):  # balls are blown up through these and stay
    game.add(evil.Rectangle(3, 0.15), at=(6.5, y), kind="static", one_way=True, colour="#f9c74f")
for x, y, width, height in ((0, -5.2, 20, 0.4), (4, -4, 0.4, 2), (-9, 0, 0.4, 10), (9, 0, 0.4, 10)):
    game.add(evil.Rectangle(width, height), at=(x, y), kind="static", colour="#2d3142")

draught = game.world.add_force(evil.Medium((4.6, -5, 8.4, 0.9), velocity=(0, 7), linear=0.3))
lake = game.world.add_force(evil.Medium((-9, -5, 4, -3.2), density=1, linear=2))
game.draw(evil.Rectangle(3.8, 5.9), at=(6.5, -2.05), colour="#ffffff14", layer=-1)
game.draw(evil.Rectangle(13, 1.8), at=(-2.5, -4.1), colour="#277da1", layer=-1)
surface = game.world.add(evil.Rectangle(13, 0.2), at=(-2.5, -3.3), kind="static", sensor=True)


@surface.on_enter
def count(visit):
    score.text = f"in the lake: {len(surface.visitors)}"


@surface.on_leave
def uncount(visit):
    score.text = f"in the lake: {len(surface.visitors)}"


def drop():
    if len(game.world.bodies) < 60:
        wood = evil.Rectangle(0.9, game.random.uniform(0.3, 0.7))
        game.add(wood, at=(-7, 5), density=0.4, colour="#f3722c", touchable=True)
        game.add(
            evil.Circle(0.3),
            at=(6.5 + game.random.uniform(-1.2, 1.2), -4),
            density=0.3,
            colour="#90be6d",
            touchable=True,
        )


game.timer.every(1.2, drop)

if __name__ == "__main__":
    game.run()
