"""A bridge of planks on hinges that break: it carries boxes, and not the ball that comes after them."""

import evilengine as evil

PLANKS, LONG = 14, 0.9

game = evil.Game("Bridge", size=(960, 540))
game.add_background("#bcd4de")
left, right = (game.add(evil.Rectangle(5, 6), at=(side * 8.8, -3), kind="static", colour="#5c6b5c") for side in (-1, 1))
game.add(evil.Rectangle(26, 1), at=(0, -5.4), kind="static", colour="#4a7c8c")

bodies = [left]
for i in range(PLANKS):
    at = ((i + 0.5 - PLANKS / 2) * LONG, 0)
    bodies.append(game.add(evil.Rectangle(LONG, 0.2), at=at, density=0.6, colour="#a47148", touchable=True))
bodies.append(right)

for i in range(PLANKS + 1):
    hinge = game.world.add_joint(
        evil.joints.Hinge(bodies[i], bodies[i + 1], at=((i - PLANKS / 2) * LONG, 0), breaking_force=900)
    )

    @hinge.on_break
    def crack(broken):
        for end in (broken.a, broken.b):
            if end.kind == "dynamic":
                end.drawings[0].colour = "#6f1d1b"
        counter.text = f"broken: {PLANKS + 1 - len(game.world.joints)}"


counter = game.text("broken: 0", at=(30, 20), colour="#33413a")


def drop_box():
    game.add(
        evil.Rectangle(0.6, 0.6), at=(game.random.uniform(-4, 4), 5), density=0.3, colour="#dda15e", touchable=True
    )


def drop_ball():
    game.add(evil.Circle(0.9), at=(0, 6), mass=60, velocity=(0, -4), colour="#3d405b", touchable=True)


for second in (0.2, 0.5, 0.8, 1.1):
    game.timer.after(second, drop_box)
game.timer.after(2.2, drop_ball)
game.run()
