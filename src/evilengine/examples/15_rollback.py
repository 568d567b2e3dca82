"""Two players over a slow line, and nobody waits: what comes late is put where it belongs, and the world repeats it.

Blue is pushed by the arrow keys. Red plays far away, and what it does arrives a fifth of a second late: the game
guesses that red goes on as before, and when it learns better, goes back to that step and repeats what came since.
"""

import math
from collections import deque

import evilengine as evil

LATE, DT = 12, 1 / 60  # steps that a message is on its way; seconds of a step

game = evil.Game("Rollback", size=(960, 540), gravity=(0, 0))
game.add_background("#10141f")
world = game.world
for at, size in (((0, 5), (19, 0.5)), ((0, -5), (19, 0.5)), ((9.25, 0), (0.5, 10)), ((-9.25, 0), (0.5, 10))):
    game.add(evil.Rectangle(*size), at=at, kind="static", colour="#2b3a55", restitution=0.9)
puck = {"restitution": 0.9, "friction": 0.1, "damping": 0.6}
blue = game.add(evil.Circle(0.7), at=(-5, 0), colour="#4cc9f0", **puck)
red = game.add(evil.Circle(0.7), at=(5, 0), colour="#f72585", **puck)
for i in range(7):
    game.add(evil.Circle(0.35), at=(1.2 * math.cos(i * 0.9), 1.2 * math.sin(i * 0.9)), colour="#f8f9fa", **puck)
report = game.text("arrow keys push blue", at=(44, 44), colour="#8899bb")

past: dict[int, bytes] = {}  # the world before each of the last steps, as bytes
Push = tuple[float, float]
moves: dict[int, list[Push]] = {-1: [(0, 0), (0, 0)]}  # how blue and red push in each of them, as far as we know
line: deque[tuple[int, Push]] = deque()  # when a message from red comes, and what red did LATE steps before


def prepare(step):
    past[step] = world.snapshot()
    for body, (x, y) in zip((blue, red), moves[step], strict=True):
        body.apply_force((18 * x, 18 * y))


@game.on_update
def play(dt):
    now = max(moves) + 1
    line.append((now + LATE, (-math.cos(now // 50 * 2.4), math.sin(now // 50 * 2.4))))  # red, far away
    while line[0][0] <= now:
        wrong, push = line[0][0] - LATE, line.popleft()[1]
        if moves[wrong][1] == push:
            continue  # as we guessed
        world.restore(past[wrong])
        for step in range(wrong, now):
            moves[step][1] = push
            prepare(step)
            world.step(DT)
        report.text = f"step {now}: went back {now - wrong} steps and lived them again"
    moves[now] = [(game.axis("left", "right"), game.axis("down", "up")), moves[now - 1][1]]
    prepare(now)  # the game makes this step itself
    past.pop(now - 2 * LATE, None), moves.pop(now - 2 * LATE, None)


game.run()
