"""Pool: a spout turns a wheel, crates of three woods float high and low, a duck bobs. Drag them, or stir the water."""

import math

import evilengine as evil

WIDE, HIGH, FLOW, FULL = 1.1, 0.8, 0.7, 35.5  # metres of a crate; m2 a second; m2
game = evil.Game("Pool", size=(960, 640))
game.camera.view_height = 8
plain, wood = {"outline": False}, {"colour": "#a8743f", "layer": -1, "outline": False}
toy = {"touchable": True, "outline": False}

game.draw(evil.Rectangle(14, 8.4), colours=["#e3f2e6"] * 2 + ["#5fa8d3"] * 2, layer=-6, **plain)
for x, y, radius, shade in ((4.4, 3, 0.6, "#fff3c4"), (-4, -1.4, 3.4, "#a9cf8f"), (3.4, -2.2, 4, "#94c281")):
    game.draw(evil.Circle(radius), at=(x, y), colour=shade, layer=-5, **plain)
game.draw(evil.Rectangle(11.4, 4.2), at=(0, -1.65), colour="#d3e8e2", layer=-4, **plain)
for row in range(7):
    for column in range(-10, 11):
        at, dark = (0.56 * column + 0.28 * (row % 2), 0.5 * row - 3.2), (3 * row + 5 * column) % 4 == 0
        game.draw(evil.Rectangle(0.53, 0.47), at=at, colour="#8fc4c9" if dark else "#a8d3d4", layer=-3, **plain)
for x, y, wide, high in ((0, -3.9, 14, 1), (-6, -0.4, 1, 7.2), (6, -1.6, 1, 5), (-5.1, 2.95, 1.7, 0.34)):
    game.add(evil.Rectangle(wide, high, rounding=0.06), at=(x, y), kind="static", colour="#8c8175", **plain)
post = game.add(evil.Rectangle(0.3, 4.6), at=(-3.2, -1), sensor=True, kind="static", colour="#6e5338", layer=-2)
wheel = game.add(evil.Circle(0.2), at=(-3.2, 1.4), density=0.6, **wood)
for k in range(8):
    for shape, at in ((evil.Rectangle(1, 0.09), (0.65, 0)), (evil.Rectangle(0.09, 0.34), (1.15, 0.16))):
        offset = evil.Vec2(*at).turned(k * math.pi / 4)
        game.draw(wheel.add_shape(shape, offset=offset, angle=k * math.pi / 4), **wood)
game.world.add_joint(evil.joints.Hinge(post, wheel, at=wheel.position, motor_speed=0, max_torque=0.6))  # it rubs

for x, density, shade in ((-0.9, 0.25, "#e8c48b"), (0.8, 0.5, "#b9783f"), (2.5, 0.8, "#70432a")):
    crate = game.add(evil.Rectangle(WIDE, HIGH), at=(x, 0), density=density, colour=shade, tag="crate", **toy)
    for side in (-0.28, 0, 0.28):
        game.draw(evil.Rectangle(0.2, HIGH - 0.2), body=crate, at=(side, 0), colour="#00000024", **plain)

duck = game.add(evil.Capsule((-0.22, 0), (0.24, 0), 0.26), at=(4.2, 0.2), density=0.25, colour="#ffce3a", **toy)
duck.add_shape(evil.Rectangle(0.4, 0.08), offset=(0, -0.2), density=3)  # what keeps it upright
beak, tail = [(0.46, 0.42), (0.46, 0.3), (0.68, 0.33)], [(-0.62, 0.3), (-0.38, -0.1), (-0.2, 0.2)]
wing = [(-0.3, 0.1), (0.12, 0.1), (-0.06, -0.14)]
for points, shade in ((tail, "#ffce3a"), (beak, "#f08a24"), (wing, "#eeac18")):
    game.draw(evil.Polygon(points), body=duck, colour=shade, **plain)
for at, radius, shade in (((0.32, 0.36), 0.19, "#ffce3a"), ((0.38, 0.42), 0.035, "#222222")):
    game.draw(evil.Circle(radius), body=duck, at=at, colour=shade, **plain)

pool = game.add_water((-5.5, -3.4, 5.5, 4), particle_size=0.08, colour="#2f8fc0", clarity=5)
pool.fill((-5.5, -3.4, 5.5, -0.1))
spout = pool.pour((-4.12, 2.9), FLOW, (0.5, -2.4))
outlet = pool.drain((-5.5, -3.4, -5, -2.9), rate=2 * FLOW)


@game.on_update
def flow(_dt):
    """What is too much drains off, and the player's hand moves the water."""
    outlet.running = pool.volume > FULL
    for touch in game.touches:
        pool.stir(touch.at, radius=0.7, velocity=touch.delta * 60)


game.text("Pool: drag the crates, stir the water", at=(16, 12), size=18, colour="#1d4a5c")
game.run()
