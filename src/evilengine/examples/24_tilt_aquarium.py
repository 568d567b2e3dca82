"""Tilt aquarium: turn the tank with the arrow keys or the phone. Fish come to your finger; toys can be dragged."""

import math

import evilengine as evil

X, Y, LEVEL = 5.2, 3.3, 0.7  # half the tank, and how high the water stands in it
game = evil.Game("Tilt aquarium", size=(960, 640), tilt=True)
game.camera.view_height = 8
plain, toy = {"outline": False}, {"outline": False, "touchable": True, "friction": 0.4}

game.draw(evil.Rectangle(12, 8), colours=["#2b7ea8"] * 2 + ["#c4ebee"] * 2, layer=-5, **plain)
for x, tall, shade in ((-4.5, 3, "#2f8f6b"), (-3.9, 1.9, "#3faa7c"), (3.3, 2.4, "#2f8f6b"), (4.5, 3.4, "#3faa7c")):
    weed = [(0.12 * math.sin(0.8 * k) + 0.17 - 0.012 * k, tall * k / 12) for k in range(13)]
    weed += [(x - 0.34 + 0.024 * k, y) for k, (x, y) in reversed(list(enumerate(weed)))]
    game.draw(evil.Polygon(weed), at=(x, -Y), colour=shade, layer=-4, **plain)
for x, radius in ((-2.4, 0.6), (-1.5, 0.35), (0.9, 0.3), (4.2, 0.7)):
    game.add(evil.Circle(radius), at=(x, -Y), kind="static", colour="#8b8396", layer=1, **plain)
for x, y in ((-X - 0.5, 0), (X + 0.5, 0), (0, -Y - 0.5), (0, Y + 0.5)):
    wall = evil.Rectangle(1 if x else 2 * X + 2, 1 if y else 2 * Y + 2)
    game.add(wall, at=(x, y), kind="static", friction=0, colour="#3b4152", layer=2, **plain)
tank = game.add_water((-X, -Y, X, Y), ramp=["#a8e6f020", "#6cc4e048", "#2a86b880"], clarity=3)
tank.fill((-X, -Y, X, LEVEL))
oil = tank.add_liquid(density=0.6, colour="#f0a83c", viscosity=0.02)
tank.fill((-X, LEVEL, X, LEVEL + 0.8), liquid=oil)

ball = game.add(evil.Circle(0.42), at=(-3, 2.2), density=0.15, restitution=0.5, colour="#e5484d", **toy)
chest = game.add(evil.Rectangle(0.8, 0.5, rounding=0.08), at=(1.9, -2.6), density=2.5, colour="#8a5a2b", **toy)
hull = evil.Polygon([(-0.8, 0.25), (-0.5, -0.25), (0.5, -0.25), (0.8, 0.25)])
boat = game.add(hull, at=(2.4, 2), density=0.2, colour="#c9553d", **toy)
boat.add_shape(evil.Rectangle(0.7, 0.1), offset=(0, -0.2), density=2.5)  # what keeps it upright
for x, y, shade in ((0.02, 0.65, "#f4efe2"), (-0.02, -0.1, "#7b5a3c")):
    game.draw(evil.Polygon([(x, 0.3), (x, 1.3), (x + y, 0.4)]), body=boat, colour=shade, **plain)

shoal = []
for x, shade, fin in ((-2.5, "#ff8a3c", "#ffe8d2"), (0.5, "#ffd23f", "#f08a24"), (2.8, "#6f6ff0", "#d5d8ff")):
    body, tail = evil.Capsule((-0.22, 0), (0.16, 0), 0.21), [(-0.36, 0), (-0.72, 0.24), (-0.62, 0), (-0.72, -0.24)]
    fish = game.add(body, at=(x, -1), density=0.95, colour=shade, layer=1, **plain)
    game.draw(evil.Polygon(tail), body=fish, colour=fin, layer=1, **plain)
    game.draw(evil.Rectangle(0.09, 0.38), body=fish, colour=fin, layer=1, **plain)
    game.draw(evil.Circle(0.05), body=fish, at=(0.24, 0.03), colour="#222222", layer=1, **plain)
    shoal.append(fish)


@game.on_update
def swim(_dt):
    """Each fish turns to a finger, or to a place of its own that wanders, and swims there as long as it is in water."""
    for number, fish in enumerate(shoal):
        t, ahead = 0.4 * game.world.time + 2.1 * number, evil.Vec2(1, 0).turned(fish.angle)
        goal = game.touches[0].at if game.touches else evil.Vec2(4 * math.sin(t), math.sin(1.7 * t) - 0.8)
        if any(tank.is_in([fish.position + 0.7 * ahead, fish.position - 0.7 * ahead])):
            turn = math.remainder((goal - fish.position).angle - fish.angle, math.tau)
            fish.apply_torque(fish.inertia * (40 * turn - 9 * fish.angular_velocity))
            fish.apply_force(fish.mass * (6 * ahead - 3 * fish.velocity))
    for touch in game.touches:
        tank.stir(touch.at, radius=0.6, velocity=touch.delta * 60)


game.text("Tilt aquarium: arrow keys tilt it, fish come to your finger", at=(16, 10), size=18, colour="#c9d3e4")
game.run()
