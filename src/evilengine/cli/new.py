"""Make a folder with a small game that runs, to start one's own from.

evil new my_game                  then: evil play my_game/game.py
"""

from __future__ import annotations

import argparse
from pathlib import Path

from evilengine.values.errors import SaveError

GAME = '''"""{title}: push the ball with the arrow keys; every box that it hits hard lights up."""

from pathlib import Path

import evilengine as evil

game = evil.Game("{title}", size=(960, 540))
game.load(Path(__file__).with_name("level.evil"))

ball = game.add(evil.Circle(0.5), at=(0, 0), colour="tomato", touchable=True)
hits = 0
score = game.text("hits: 0", at=(20, 20))


@game.on_update
def push(dt):
    ball.apply_force((12 * game.axis("left", "right"), 20 * game.axis("down", "up")))


@ball.on_collide
def hit(contact):
    global hits
    other = contact.other(ball)
    if other.tag == "box" and contact.speed > 1:
        hits += 1
        score.text = f"hits: {{hits}}"
        other.drawings[0].colour = "gold"


game.run()
'''

LEVEL = """# {title}: the room and what stands in it. `evil play level.evil` shows it alone.
evil 1;
gravity 0 -9.81;
view 16.6 9.6;
new walls 16 9;
{boxes}
"""

README = """# {title}

Play it: `evil play game.py` (or `python game.py`). While it runs: F1 shows the debug view, P pauses, R starts again.

- `game.py`: the game, Python.
- `level.evil`: its level. `evil check level.evil` says what is wrong with it.

`evil examples` lists larger games to look into.
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", help="the folder to make; its last part is the game's name")


def run(args: argparse.Namespace) -> int:
    folder = make(Path(args.name))
    print(f"made {folder}; now: evil play {folder / 'game.py'}")
    return 0


def make(folder: Path) -> Path:
    """Write the small game into `folder`, which must not exist. Raises SaveError, and then nothing is left behind."""
    title = folder.name.replace("_", " ").replace("-", " ").strip().capitalize()
    if not title or not title.isprintable() or set(title) & set("\\\"'{}<>:|?*#;"):
        raise SaveError(f"NAME={str(folder)!r} must name a folder: letters, digits, - and _")
    boxes = "\n".join(
        f'new rectangle 1 1 {x:g} {y:g} physicsOn colour "{colour}" tag "box";'
        for x, y, colour in ((4, -4, "#7a8ca8"), (4, -3, "#8fa1bb"), (4, -2, "#a4b6ce"), (-5, -4, "#8fa1bb"))
    )
    files = {
        "game.py": GAME.format(title=title),
        "level.evil": LEVEL.format(title=title, boxes=boxes),
        "README.md": README.format(title=title),
    }
    try:
        folder.mkdir(parents=True)
        for name, text in files.items():
            (folder / name).write_text(text, encoding="utf-8")
    except FileExistsError:
        raise SaveError(f"{folder} exists already; choose another name") from None
    except OSError as error:
        raise SaveError(f"{folder} cannot be made: {error.strerror}") from None
    return folder
