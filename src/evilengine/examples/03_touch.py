"""Tilt and touch: turn gravity with the arrow keys, drag the planks, tap a balloon to burst it."""

import evilengine as evil

game = evil.Game("Tilt and touch", size=(960, 540), tilt=True)

for x, y, width, height in ((0, -5.2, 20, 0.8), (0, 5.2, 20, 0.8), (-9.4, 0, 0.8, 12), (9.4, 0, 0.8, 12)):
    game.add(evil.Rectangle(width, height), at=(x, y), kind="static", colour="midnightblue")
for row in range(4):
    game.add(evil.Rectangle(2.5, 0.4), at=(-4 + row, row - 4), colour="peru", touchable=True)

burst = 0
score = game.text("burst: 0", at=(40, 40))


def blow_up():
    balloon = game.add(
        evil.Circle(game.random.uniform(0.4, 0.7)),
        at=(game.random.uniform(-7, 7), -3),
        gravity_scale=-0.2,
        density=0.1,
        damping=0.5,
        colour=game.random.choice(("crimson", "orange", "deeppink")),
        touchable=True,
        tag="balloon",
    )

    @balloon.on_touch
    def pop(touch):
        global burst
        burst += 1
        score.text = f"burst: {burst}"
        balloon.destroy()


for _ in range(8):
    blow_up()
game.timer.every(3, blow_up)


@game.on_shake
def shake():
    for body in game.world.bodies:
        body.apply_impulse((0, 3 * body.mass))


game.run()
