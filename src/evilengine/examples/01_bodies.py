"""Bodies and callbacks: balls rain down a stair and turn white where they land."""

import evilengine as evil

COLOURS = ("tomato", "gold", "mediumseagreen", "cornflowerblue", "orchid")

game = evil.Game("Bodies", size=(960, 540))

for step in range(6):
    game.add(evil.Rectangle(3, 0.4), at=(step * 2 - 7, 2 - step), angle=-0.12, kind="static", colour="slategray")
for x in (-9.5, 9.5):
    game.add(evil.Rectangle(0.4, 11), at=(x, 0), kind="static", colour="slategray")
floor = game.add(evil.Rectangle(20, 0.6), at=(0, -5.1), kind="static", colour="darkslategray")
score = game.text("landed: 0", at=(30, 20))
landed = 0


def drop():
    ball = game.add(
        evil.Circle(game.random.uniform(0.15, 0.4)),
        at=(game.random.uniform(-8, -6), 6),
        restitution=0.6,
        colour=game.random.choice(COLOURS),
        tag="ball",
    )
    game.timer.after(12, ball.destroy)


@floor.on_collide
def land(contact):
    global landed
    ball = contact.other(floor)
    if ball.tag == "ball":
        landed += 1
        score.text = f"landed: {landed}"
        ball.tag = "landed"
        ball.drawings[0].colour = "white"


game.timer.every(0.3, drop)
game.run()
