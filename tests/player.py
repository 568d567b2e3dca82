"""A player whose hands follow a script, for tests of saved and recorded games, and a level with everything in it."""

from __future__ import annotations

import hashlib
from pathlib import Path

import evilengine as evil
from evilengine.game import Game, saving

EXAMPLES = Path(evil.__file__).parent / "examples"
LEVELS = sorted(path.name for path in EXAMPLES.glob("*.evil"))

RICH = """
evil 1;
view 16 9;
tilt on;
seed 7;
let score 0;
let hits 0;
new walls 15 8;
new circle ball 0.4 at 0 2 physicsOn touchable tag "ball" restitution 0.6;
new rectangle crate 1 1 at 3 -2 physicsOn touchable tag "crate" colour "orange";
new rectangle gone 1 1 at -5 -2;
new circle anchor 0.1 at -3 3;
new circle bob 0.3 at -3 1 physicsOn;
new spring tie from bob to anchor stiffness 30 length 1;
draw circle star 0.2 at 6 3 colour "gold" layer 2;
text board "score {score}, hits {hits}" at 20 20;
text plain "hello" at 20 60 size 12;
destroy gone;
every 0.4 times 30 as n {
    new circle drop random(0.1, 0.3) at random(-6, 6) 3.5 physicsOn tag "drop";
    set score (score + n);
    after 0.7 { set drop colour "red"; impulse drop 0 random(0, 1); }
    on collide drop "ball" { set hits (hits + 1); destroy this; }
    if (n % 3 == 0) { on key "k" { set star colour "red"; set ball at random(-6, 6) 2; } }
}
on collide "drop" "crate" { set this tag "stuck"; set score (score + 10); }
on separate "ball" { set hits (hits + 1); }
on touch "crate" { impulse this 0 3; }
on touch { set score (score + 1); }
on key "space" { impulse ball random(-1, 1) 4; }
on shake { gravity 0 -5; }
after 3 { destroy bob; set plain colour "red"; destroy tie; }
"""


def level_game(path):
    game = Game("Saved", size=(320, 180), headless=True, folder=path.parent)
    game.load(path)
    return game


def play(game, start, end):
    """What a player does, by the number of the step; whoever resumes goes on with it."""
    for step in range(start, end):
        if step % 9 == 0:
            game.device.tap("space")
        if step % 31 == 0:
            game.device.tap("k")
        if step % 17 == 0:
            game.device.key("left", down=step % 34 == 0)
        if step % 60 == 10:
            game.device.touch(1, "began", at=(160 + step % 50, 60))
        elif step % 60 == 40:
            game.device.touch(1, "ended")
        elif 10 < step % 60 < 40:
            game.device.touch(1, "moved", at=(100 + step % 60, 90 - step % 20))
        game.step()


def state(game):
    """All that can be seen of a game; the random numbers to come, and when events happen, are in it too."""
    events = [(event.time, repr(event)) for event in game.timer.events]
    return game.world.snapshot(), game.capture().tobytes(), game.random.getstate(), events, game.inputs, len(game.scene)


def resumed(data, game):
    saving.from_bytes(game, data, "test.evs")
    return game


def let_go(game):
    """Who resumes holds nothing, so who never stopped lets go as well."""
    game.device.focus(False)
    game.device.focus(True)
    return game


def digest(game):
    return hashlib.sha256(b"".join(state(game)[:2])).hexdigest()
