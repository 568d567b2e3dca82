"""What acts in a saved game beside the world: callbacks of joints, and the keys that steer a character."""

from __future__ import annotations

import pytest

import evilengine as evil
from evilengine.game import Game, saving

SNAPPED: list[str] = []


def snapped(broken: evil.joints.BrokenJoint) -> None:
    SNAPPED.append(f"{broken.a.tag}-{broken.b.tag} at {broken.a._world.steps}")


def hung() -> Game:
    """A lamp on a rope that breaks when it becomes heavy."""
    game = Game("Hung", size=(320, 180), headless=True)
    hook = game.add(evil.Circle(0.1), at=(0, 3), kind="static", tag="hook")
    lamp = game.add(evil.Circle(0.3), at=(0, 1), tag="lamp", mass=1)
    rope = game.world.add_joint(evil.joints.Rope(hook, lamp, breaking_force=30))
    rope.on_break(snapped)
    return game


def overload(game: Game) -> None:
    lamp = game.world.find("lamp")
    assert lamp is not None
    lamp.mass = 20
    for _ in range(10):
        game.step()


def test_what_happens_when_a_joint_breaks_is_saved() -> None:
    game = hung()
    for _ in range(20):
        game.step()
    data = saving.to_bytes(game)
    overload(game)
    first = SNAPPED.copy()
    assert len(first) == 1
    empty = Game("Hung", size=(320, 180), headless=True)
    for each in (game, empty):  # taken back, and in a game that never had it
        SNAPPED.clear()
        saving.from_bytes(each, data, "hung")
        assert saving.to_bytes(each) == data
        overload(each)
        assert first == SNAPPED


def test_a_callback_of_a_joint_that_is_not_saved_is_gone_after_a_resume() -> None:
    game = hung()
    data = saving.to_bytes(game)
    (rope,) = game.world.joints
    SNAPPED.clear()
    rope.on_break(lambda broken: SNAPPED.append("late"))
    saving.from_bytes(game, data, "hung")
    overload(game)
    assert len(SNAPPED) == 1
    assert "late" not in SNAPPED


def test_a_joint_s_callback_without_a_name_is_an_error_that_says_which() -> None:
    game = hung()
    next(iter(game.world.joints)).on_break(lambda broken: None)
    with pytest.raises(evil.SaveError, match="on_break of <Rope 0>"):
        saving.to_bytes(game)


def walk(**keys: str | tuple[str, ...]) -> Game:
    game = Game("Walk", size=(320, 180), headless=True)
    game.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    hero = game.add_character(at=(0, 1), tag="hero", colour="orange")
    game.drive(hero, **keys)
    return game


def place_after_keys(game: Game) -> tuple[float, float]:
    game.device.key("right", down=True)
    game.device.key("z", down=True)
    for _ in range(25):
        game.step()
    return tuple(game.world.characters[0].position)


def test_who_is_steered_and_by_which_keys_is_saved() -> None:
    game = walk(jump="z")
    for _ in range(30):
        game.step()
    data = saving.to_bytes(game)
    empty = Game("Walk", size=(320, 180), headless=True)
    saving.from_bytes(empty, data, "walk")
    assert saving.to_bytes(empty) == data
    place = place_after_keys(empty)
    assert place[0] > 0.5, "it walked"
    assert place[1] > 1.5, "it jumped"
    assert place_after_keys(game) == place
    saving.from_bytes(game, data, "walk")
    game.drive(None)
    assert saving.to_bytes(game) != data


def test_nobody_is_steered_after_a_resume_to_when_nobody_was() -> None:
    game = walk()
    game.drive(None)
    data = saving.to_bytes(game)
    game.drive(game.world.characters[0])
    saving.from_bytes(game, data, "walk")
    assert saving.to_bytes(game) == data
    assert place_after_keys(game)[0] == 0


@pytest.mark.parametrize(
    "driver", [{"body": 7}, {"body": 99, "keys": {}}, {"body": 1, "keys": {"left": "nonsense"}}, 3]
)
def test_keys_that_make_no_sense_are_refused_and_the_game_is_as_it_was(driver: object) -> None:
    game = walk()
    data = saving.to_bytes(game)
    sections = saving.SAVED_GAME.read(data, "walk")
    state = saving.json.loads(sections["game"])
    state["driver"] = driver
    damaged = saving.SAVED_GAME.write({**sections, "game": saving.json.dumps(state).encode()})
    with pytest.raises(evil.SaveError):
        saving.from_bytes(game, damaged, "walk")
    assert saving.to_bytes(game) == data
