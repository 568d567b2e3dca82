"""Tower: a whole game. Build up to the moon: space, a click or a tap lets go of what the crane holds."""

import math

import evilengine as evil

GOODS = {"crate": (1.5, 1.0), "trunk": (1.9, 0.9), "parcel": (1.2, 1.1)}  # metres
SEA, LAND = -6.6, -2.9  # heights
NIGHT, DUSK, ROSE, GOLD = "#0d0c26", "#34306a", "#d8647c", "#ffbd74"

game = evil.Game("Tower", size=(480, 720), view_height=14.4)
dice = game.random
backdrop = []  # what is far away: (drawing, x, y, how much of the camera's climb it goes along with)

for height, low, high in ((-5.0, GOLD, ROSE), (3.0, ROSE, DUSK), (11.0, DUSK, NIGHT), (19.0, NIGHT, NIGHT)):
    sky = game.draw(evil.Rectangle(50, 8.1), colours=[low, low, high, high], layer=-9)
    backdrop.append((sky, 0.0, height, 0.8))
for _ in range(270):
    star = game.draw(evil.Circle(dice.choice((0.02, 0.03, 0.05))), colour=(1, 1, 0.9, dice.random()), layer=-8)
    backdrop.append((star, dice.uniform(-14, 14), dice.triangular(3, 23, 20), 0.8))
backdrop.append((game.sprite("tower/moon.png", height=3.6, layer=-8), 2.4, 10.5, 0.8))
for x, y in ((-3.2, 0.6), (3.4, 3.1), (-1.5, 7), (2, 13), (-3, 17)):
    cloud = game.sprite("tower/cloud.png", height=dice.uniform(0.9, 1.4), colour="#ffe3ea78", layer=-7)
    backdrop.append((cloud, x, y, 0.6))
for x, y, colour, follows in ((0.4, -4.9, "#a3527a", 0.7), (-0.7, -5.9, "#623c72", 0.5)):
    for side in (-11.3, 0, 11.3):
        backdrop.append((game.sprite("tower/hills.png", height=2.6, colour=colour, layer=-6), x + side, y, follows))
game.draw(evil.Rectangle(50, 4), at=(0, SEA - 1.4), colours=["#1d1a40"] * 2 + ["#4b3b7c"] * 2, layer=-5)

island = game.add(evil.Rectangle(3.6, 0.5), at=(0, LAND - 0.25), kind="static", friction=0.9, visible=False)
game.sprite("tower/island.png", body=island, height=2.2, at=(0, -0.61))
rope = game.draw(evil.Rectangle(0.06, 8), colour="#2b2030", layer=2)
hook = game.sprite("tower/hook.png", height=0.64, layer=3)
hearts = [game.sprite("tower/heart.png", height=0.5, layer=9) for _ in range(3)]
score = game.text("", at=(0, 20), size=46, anchor="top")
title = game.text("T O W E R\nspace, click or tap lets go", at=(0, 24), size=22, anchor="bottom", colour="#ffe9c9")
words = game.text("", at=(0, 240), size=24, anchor="top", colour="#ffe9c9")


class Tower:
    """One round, from the first crate to the last heart. Nobody there? Then it plays by itself until someone is."""

    def __init__(self, somebody, best=0):
        self.somebody, self.best = somebody, best
        self.points, self.hearts, self.row, self.things = 0, 3, 0, []
        self.time = self.swing = self.climbed = self.shake = self.over_for = 0.0
        words.text, title.visible = "", not somebody
        self.load()
        self.update(0)

    def load(self):
        kind = dice.choice(list(GOODS))
        self.falling, self.shape = None, evil.Rectangle(*GOODS[kind])
        self.held = game.draw(self.shape, texture=f"tower/{kind}.png", layer=1)
        self.aim = dice.uniform(-0.25, 0.25)  # how far off it lets go when it plays by itself

    def let_go(self):
        if self.held.alive and self.hearts:
            at, push = self.crane - (0, 0.3 + self.shape.height / 2), (0.4 * math.cos(self.swing), 0)
            feel = {"friction": 0.9, "angular_damping": 0.3}
            self.falling = game.add(self.shape, at=at, velocity=push, texture=self.held.texture, **feel)
            self.falling.on_collide(self.land)
            self.things.append(self.falling)
            self.held.destroy()

    def land(self, contact):
        if self.falling in (contact.a, contact.b):
            off = abs(self.falling.position.x - contact.other(self.falling).position.x)
            self.row = self.row + 1 if off < 0.15 else 0
            self.points, self.shake = self.points + 1 + self.row, 0.05
            name, pitch = ("chime", 1.06 ** min(self.row, 12)) if self.row else ("thud", dice.uniform(0.9, 1.1))
            game.audio.play(f"tower/{name}.ogg", pitch=pitch)
            puff(contact.point, *((20, "gold", 4) if self.row else (6, "#e8d8c8", 2)))
            words.text = f"Perfect x {self.row}!" if self.row > 1 else "Perfect!" * self.row
            self.load()

    def drown(self, thing):
        game.audio.play("tower/splash.ogg")
        puff((thing.position.x, SEA + 0.4), 20, "#b9b4ea", 5)
        self.things.remove(thing)
        thing.destroy()
        self.hearts, self.row, self.shake = max(0, self.hearts - 1), 0, 0.25
        self.best = max(self.best, self.points)
        if not self.hearts:
            words.text = f"{self.points} points, best {self.best}\ntap to build again"
        if thing is self.falling:
            self.load()

    def update(self, dt):
        self.time, self.over_for = self.time + dt, self.over_for + (0 if self.hearts else dt)
        self.swing += (1.5 + 0.02 * self.points) * dt
        for thing in [each for each in self.things if each.position.y < SEA]:
            self.drown(thing)
        standing = [each.position for each in self.things if each is not self.falling]
        top = max((at.y for at in standing), default=LAND)
        self.climbed += (max(0.0, top + 1.6) - self.climbed) * 2 * dt
        self.crane = evil.Vec2(2.9 * math.sin(self.swing), self.climbed + 4.2)
        if not self.somebody:
            lands_at = self.crane.x + 0.35 * math.cos(self.swing)
            if abs(lands_at - (standing[-1].x if standing else 0) - self.aim) < 0.08:
                self.let_go()
        if self.over_for > 2 and not self.somebody:
            begin(False)


def puff(at, count, colour, fast):
    for _ in range(count):
        way = evil.Vec2(1, 0).turned(dice.uniform(0, math.pi)) * dice.uniform(0.3, 1) * fast
        speck = game.add(evil.Particle(), at=at, velocity=way, colour=colour, layer=5)
        game.timer.after(dice.uniform(0.2, 0.7), speck.destroy)


def begin(somebody):
    global tower
    for thing in (*tower.things, tower.held):
        if thing.alive:
            thing.destroy()
    tower = Tower(somebody, tower.best)


@game.on_key_press
def act(key):
    if not tower.somebody or tower.over_for > 0.7 or key == "r":
        begin(True)
    elif key in ("space", "enter", "down"):
        tower.let_go()


@game.on_draw
def arrange():
    game.camera.position = (tower.shake * math.sin(70 * tower.time), tower.climbed)
    tower.shake *= 0.9
    for drawing, x, y, follows in backdrop:
        drawing.place((x, y + follows * tower.climbed))
    rope.place(tower.crane + (0, 4.2))
    hook.place(tower.crane)
    if tower.held.alive:
        tower.held.place(tower.crane - (0, 0.3 + tower.shape.height / 2))
    for count, heart in enumerate(hearts):
        heart.visible = count < tower.hearts
        heart.place(game.camera.to_world((30 + 34 * count, 36)))
    score.text = tower.points


tower = Tower(somebody=False)
game.audio.music("tower/music.ogg", volume=0.6)
game.on_touch(lambda touch: touch.phase == "began" and act("space"))
game.on_update(lambda dt: tower.update(dt))
game.run()
