"""Scenes: a title, a round of catching stars, and an end in slow motion."""

import evilengine as evil

game = evil.Game("Stars", size=(640, 480))
best = 0


@game.scenes
def title():
    game.add_background("midnightblue")
    game.text("S T A R S", at=(0, -40), anchor="centre", size=52, colour="gold")
    game.text(f"space or a tap begins      best {best}", at=(0, 40), anchor="centre")
    game.timer.every(0.15, lambda: drop(0.15))
    game.on_key_press(lambda key: key == "space" and game.go("catch"))
    game.on_touch(lambda touch: touch.phase == "began" and game.go("catch"))


@game.scenes
def catch(seconds=15):
    game.add_background("#10122e")
    basket = game.add(evil.Rectangle(1.6, 0.3), at=(0, -4.2), kind="kinematic", colour="peru")
    points = game.text(0, at=(0, 16), anchor="top", size=34)

    @game.on_update
    def steer(dt):
        wanted = 9 * game.axis("left", "right")
        for finger in game.touches:
            wanted = max(-9, min(9, 12 * (finger.at.x - basket.position.x)))
        basket.velocity = (wanted if abs(basket.position.x + wanted * dt) < 5.6 else 0, 0)

    @basket.on_collide
    def caught(contact):
        contact.other(basket).destroy()
        points.text = int(points.text) + 1

    game.timer.every(0.4, lambda: drop(0.25))
    game.timer.after(seconds, lambda: setattr(game, "speed", 0.2))
    game.timer.after(seconds + 0.4, lambda: game.go("end", int(points.text)))


@game.scenes
def end(points):
    global best
    best = max(best, points)
    game.text(f"{points} stars, best {best}\nspace or a tap", at=(0, 0), anchor="centre", size=34)
    game.on_key_press(lambda key: key == "space" and game.go("catch"))
    game.on_touch(lambda touch: touch.phase == "began" and game.go("title"))


def drop(size):
    star = game.add(evil.Circle(size), at=(game.random.uniform(-5.5, 5.5), 5.5), colour="gold", damping=0.6)
    game.timer.after(2.5, lambda: star.destroy() if star.alive else None)


game.go("title")
game.run()
