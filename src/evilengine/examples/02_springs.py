"""Forces: a chain of boxes on springs, swung by a wind that turns every two seconds."""

from itertools import pairwise

import evilengine as evil

game = evil.Game("Springs", size=(960, 540))

hook = game.add(evil.Circle(0.2), at=(0, 4), kind="static", colour="silver")
chain = [hook]
threads = []
for link in range(6):
    box = game.add(
        evil.Rectangle(0.6, 0.6), at=(link * 0.9 + 0.9, 4), colour=(1, 0.3 + link * 0.1, 0.2), touchable=True
    )
    box.add_force(evil.Spring(to=chain[-1], stiffness=60, rest_length=0.9, damping=2))
    chain.append(box)
    threads.append(game.draw(evil.Rectangle(1, 0.06), colour="slategray", layer=-1))

wind = 3.0


class Wind(evil.Force):
    """Pushes each body alike; asked once a step."""

    def apply(self, bodies, dt):
        for body in bodies:
            body.apply_force((wind, 0))


def turn():
    global wind
    wind = -wind


@game.on_draw
def stretch_threads():
    for thread, (a, b) in zip(threads, pairwise(chain), strict=True):
        span = b.position - a.position
        middle = a.position + span / 2
        turned = evil.Mat4.translation(*middle) @ evil.Mat4.rotation(span.angle)
        thread.matrix = turned @ evil.Mat4.scale(span.length, 1)


game.world.add_force(Wind(), chain[1:])
game.world.add_force(evil.Drag(0.1), chain[1:])
game.timer.every(2, turn)
game.text("drag the boxes", at=(30, 20))
game.run()
