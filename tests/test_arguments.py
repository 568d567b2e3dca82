"""The public door: what is handed to the engine is taken in every sensible form, or refused by an error of ours."""

from __future__ import annotations

import copy
import inspect
import math
import pickle
from collections.abc import Callable, Iterator
from typing import Any

import numpy
import pytest

import evilengine as evil


class Enormous(int):
    """A whole number that no float holds, with a short name."""

    def __repr__(self) -> str:
        return "10**400"


HUGE = Enormous(10**400)


def doors(body: evil.Body) -> dict[str, Callable[[Any], object]]:
    """Every place that takes one number."""
    world = body.world
    return {
        "radius": evil.Circle,
        "width": lambda v: evil.Rectangle(v, 1),
        "mass of a particle": evil.Particle,
        "dt": world.step,
        "density": lambda v: world.add(evil.Circle(1), density=v),
        "stiffness": lambda v: evil.Spring((0, 0), stiffness=v),
        "torque": body.apply_torque,
        "angular impulse": body.apply_angular_impulse,
        "angle": lambda v: setattr(body, "angle", v),
        "angular_velocity": lambda v: setattr(body, "angular_velocity", v),
        "mass": lambda v: setattr(body, "mass", v),
        "damping": lambda v: setattr(body, "damping", v),
        "friction": lambda v: setattr(body, "friction", v),
        "friction of a shape": lambda v: setattr(body.shapes[0], "friction", v),
        "density of a shape": lambda v: setattr(body.shapes[0], "density", v),
    }


def point_doors(body: evil.Body) -> dict[str, Callable[[Any], object]]:
    """Every place that takes one point."""
    world = body.world
    return {
        "at": lambda v: world.add(evil.Circle(1), at=v),
        "gravity": lambda v: setattr(world, "gravity", v),
        "position": lambda v: setattr(body, "position", v),
        "velocity": lambda v: setattr(body, "velocity", v),
        "scale": lambda v: setattr(body, "scale", v),
        "force": body.apply_force,
        "impulse": body.apply_impulse,
        "point of attack": lambda v: body.apply_force((0, 0), at=v),
        "velocity_at": body.velocity_at,
        "to_world": body.to_world,
        "start of a ray": lambda v: world.ray_cast(v, (1, 1)),
        "bodies_at": world.bodies_at,
        "acceleration": evil.Gravity,
        "end of a spring": evil.Spring,
        "corner": lambda v: evil.Polygon([(0, 0), v, (0, 1)]),
        "corner of a triangle": lambda v: evil.Triangle((0, 0), v, (0, 1)),
    }


NO_NUMBERS = [None, "1", "one", b"1", 1j, [], (1,), True, False, numpy.array([1.0, 2.0]), ...]
NO_POINTS = ["12", b"12", bytearray(b"12"), 5, None, (1,), (1, 2, 3), ("1", "2"), (None, None), {1: 2, 3: 4}, {1, 2}]


@pytest.fixture
def body() -> evil.Body:
    return evil.World().add(evil.Rectangle(1, 1))


@pytest.mark.parametrize("value", NO_NUMBERS, ids=repr)
def test_what_is_no_number_is_refused_by_name(body: evil.Body, value: object) -> None:
    before = body.world.checksum()
    for name, door in doors(body).items():
        with pytest.raises(evil.ArgumentTypeError, match="must be a number") as refused:
            door(value)
        assert repr(value) in str(refused.value), name
        assert body.world.checksum() == before, name


@pytest.mark.parametrize("value", [math.nan, math.inf, -math.inf, HUGE, -HUGE, numpy.float32("nan")], ids=repr)
def test_what_is_no_finite_number_is_refused_by_name(body: evil.Body, value: float) -> None:
    before = body.world.checksum()
    for name, door in doors(body).items():
        with pytest.raises(evil.ArgumentError, match="finite"):
            door(value)
        assert body.world.checksum() == before, name
    for name, door in point_doors(body).items():
        for point in ((value, 0.5), (0.5, value)):
            with pytest.raises(evil.ArgumentError, match="finite"):
                door(point)
        assert body.world.checksum() == before, name


@pytest.mark.parametrize("value", NO_POINTS, ids=repr)
def test_what_is_no_point_is_refused_by_name(body: evil.Body, value: object) -> None:
    before = body.world.checksum()
    for name, door in point_doors(body).items():
        if name == "point of attack" and value is None:
            continue  # there, None is the centre of mass
        with pytest.raises(evil.ArgumentTypeError, match="pair of numbers"):
            door(value)
        assert body.world.checksum() == before, name


@pytest.mark.parametrize(
    "value", [1, 1.0, numpy.float32(1), numpy.float64(1), numpy.int64(1), numpy.array(1.0)], ids=repr
)
def test_numbers_of_any_make_are_taken(body: evil.Body, value: Any) -> None:
    for door in doors(body).values():
        door(value)
    assert body.angle == 1.0


@pytest.mark.parametrize("kind", [tuple, list, numpy.array, lambda pair: evil.Vec2(*pair)])
def test_points_of_any_make_are_taken(body: evil.Body, kind: Callable[[list[float]], Any]) -> None:
    for door in point_doors(body).values():
        door(kind([1.5, 0.25]))
    body.position = numpy.array([1.5, 0.25], dtype=numpy.float32)
    assert body.position == (1.5, 0.25)


@pytest.mark.parametrize("word", ["bullet", "touchable", "awake"])
@pytest.mark.parametrize("value", [None, 1, "yes", []], ids=repr)
def test_a_switch_is_true_or_false(body: evil.Body, word: str, value: object) -> None:
    with pytest.raises(evil.ArgumentTypeError, match=f"{word}=.* must be True or False"):
        setattr(body, word, value)


def test_a_handle_compares_with_anything(body: evil.Body) -> None:
    spring = body.add_force(evil.Spring((0, 8)))
    drawing = evil.Game(headless=True).add(evil.Circle(1)).drawings[0]
    for handle in (body, body.shapes[0], spring, drawing):
        assert handle == handle
        for other in (None, 0, "body", object(), (0, 0)):
            assert handle != other
            assert (handle == other) is False
            assert other != handle


def test_numbers_in_strings_make_no_vector() -> None:
    for x, y in (("1", 2), (1, "2"), (None, 0)):
        with pytest.raises(evil.ArgumentTypeError, match="must be numbers"):
            evil.Vec2(x, y)  # type: ignore[arg-type]
    with pytest.raises(evil.ArgumentError, match="too large"):
        evil.Vec2(HUGE, 0)


SHAPES = [
    evil.Circle(0.3),
    evil.Rectangle(3, 1),
    evil.Triangle((0, 0), (1, 0), (0, 1.1)),
    evil.Polygon([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)]),
    evil.Particle(2),
]


@pytest.mark.parametrize("shape", SHAPES, ids=repr)
def test_a_shape_is_copied_and_pickled_like_any_value(shape: evil.Circle) -> None:
    for twin in (copy.copy(shape), copy.deepcopy(shape), pickle.loads(pickle.dumps(shape))):
        assert twin == shape
        assert hash(twin) == hash(shape)
        assert evil.World().add(twin).mass == evil.World().add(shape).mass


def test_a_world_says_how_it_is_copied() -> None:
    world = evil.World()
    for make in (copy.copy, copy.deepcopy, pickle.dumps):
        with pytest.raises(TypeError, match=r"snapshot\(\)"):
            make(world)


def test_a_force_that_does_nothing_is_refused_when_it_is_added() -> None:
    world = evil.World()
    with pytest.raises(evil.ArgumentTypeError, match="write apply"):
        world.add_force(evil.Force())
    assert world.forces == ()
    world.step()


@pytest.mark.parametrize(
    "wrong", [{"colour": "bleu"}, {"texture": "no.png"}, {"layer": "up"}, {"colours": ["red"]}], ids=repr
)
def test_looks_that_cannot_be_leave_the_world_as_it_was(wrong: dict[str, Any]) -> None:
    game = evil.Game(headless=True)
    game.add(evil.Circle(1))
    before = game.world.snapshot()
    with pytest.raises(evil.Error):
        game.add(evil.Rectangle(1, 1), **wrong)
    assert game.world.snapshot() == before
    assert len(game.scene) == 1
    assert game.add(evil.Rectangle(1, 1)).drawings[0].alive


@pytest.mark.parametrize("name", [3, None, b"level.evil"], ids=repr)
def test_what_is_no_file_name_is_refused(name: Any) -> None:
    with pytest.raises(evil.ArgumentTypeError, match="name of a file"):
        evil.Game(headless=True).load(name)


# -- unknown keywords ------------------------------------------------------------------------------------------------


def public_calls() -> Iterator[tuple[str, Callable[..., object]]]:
    """Every public method of every public object that takes arguments, bound to a live one."""
    game = evil.Game(headless=True)
    body = game.add(evil.Rectangle(1, 1))
    force = body.add_force(evil.Drag(1))
    objects = [
        game, game.world, game.camera, game.timer, game.device, game.scene, game.capture(), game.text("hello"),
        body, body.shapes[0], force, body.drawings[0], evil.Vec2(1, 2), evil.Mat4.identity(),
    ]  # fmt: skip
    for thing in objects:
        for name in dir(type(thing)):
            if name.startswith("_") or isinstance(inspect.getattr_static(type(thing), name), property):
                continue
            call = getattr(thing, name)
            if callable(call) and not hasattr(tuple, name):
                yield f"{type(thing).__name__}.{name}", call
    for name in evil.__all__:
        if isinstance(made := getattr(evil, name), type) and not issubclass(made, Exception):
            yield name, made


NOT_FOR_PEOPLE = {
    *(
        "Body",
        "Character",
        "Shape",
        "Force",
        "Contact",
        "RayHit",
        "Visit",
        "Image",
        "Smoke",
        "Water",
        "Source",
        "Stream",
        "Liquid",
    ),  # the engine makes these
    "Game.sprite",  # looks for its image first
    *(
        "Camera.matrix",
        "Scene.collect",
        "Scene.collect_world",
        "Scene.collect_screen",
        "Scene.texture_id",
        "Text.draw",
        "HeadlessDevice.show",
        "Drag.apply",
    ),
    *("Vec2", "Vec2.cross", "Vec2.dot", "Vec2.turned"),  # too often called to look twice
}
FIRST = {
    "Game.add": evil.Circle(1), "Game.draw": evil.Circle(1), "DrawnBody.add_shape": evil.Circle(1),
    "Game.text": "hello", "Game.add_smoke": (0, 0, 1, 1), "Game.add_water": (0, 0, 1, 1),
}  # fmt: skip
"""What must be there before any keyword is looked at."""


def takes_arguments(call: Callable[..., object]) -> bool:
    try:
        return bool(inspect.signature(call).parameters)
    except ValueError:  # of the core
        return True


def test_an_unknown_keyword_is_an_error_of_ours_that_names_it() -> None:
    wrong = []
    for name, call in public_calls():
        if name in NOT_FOR_PEOPLE or not takes_arguments(call):
            continue
        try:
            call(*([FIRST[name]] if name in FIRST else []), no_such_word=3)
            wrong.append(f"{name} takes it")
        except evil.ArgumentTypeError as problem:
            if "no_such_word=3" not in str(problem):
                wrong.append(f"{name}: {problem}")
        except Exception as problem:
            wrong.append(f"{name}: {type(problem).__name__}: {problem}"[:120])
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize(
    ("call", "name"),
    [
        (lambda game: game.world.ray_cast((0, 0), (1, 0), kinds="static"), "World.ray_cast"),
        (lambda game: game.world.character_of(bdy=1), "World.character_of"),
        (lambda game: game.go("menu", sound="keep"), "Game.go"),
        (lambda game: game.axis(low="left"), "Game.axis"),
        (lambda game: game.load(file="1.evil"), "Game.load"),
    ],
)
def test_an_unknown_word_is_answered_by_the_name_that_was_called(call: Callable[[Any], object], name: str) -> None:
    with pytest.raises(evil.ArgumentTypeError, match=rf"^{name}\(\) got an unknown argument"):
        call(evil.Game(headless=True))


def test_a_missing_argument_is_asked_for_by_the_name_that_was_called() -> None:
    with pytest.raises(TypeError, match=r"^World\.bodies_at\(\) missing"):
        evil.World().bodies_at()  # type: ignore[call-arg]
    with pytest.raises(TypeError, match=r"^Game\.sprite\(\) missing"):
        evil.Game(headless=True).sprite()  # type: ignore[call-arg]


def test_nothing_at_all_is_refused_by_an_error_of_ours() -> None:
    world = evil.World()
    box, hero = world.add(evil.Rectangle(1, 1)), world.add_character(at=(5, 0))
    for door, argument in (
        (lambda: evil.Capsule(None, (1, 0), 0.2), "Capsule: a=None"),  # type: ignore[arg-type]
        (lambda: evil.Segment((0, 0), None), "Segment: b=None"),  # type: ignore[arg-type]
        (lambda: box.apply_matrix(None), "Body.apply_matrix: matrix"),  # type: ignore[arg-type]
        (lambda: box.shapes[0].apply_matrix(None), "Shape.apply_matrix: matrix"),  # type: ignore[arg-type]
        (lambda: world.add_character(ladders=None), "World.add_character: ladders=None"),
        (lambda: setattr(hero, "ladders", 3), "Character: ladders=3"),
    ):
        with pytest.raises(evil.ArgumentTypeError, match=argument):
            door()


@pytest.mark.parametrize(
    "what", ["post", "layers", "lights", "light", "emitter", "drawing", "text", "camera", "debug_view"]
)
def test_a_property_that_there_is_not_cannot_be_set(what: str) -> None:
    game = evil.Game(headless=True, renderer="soft")
    made = {
        "light": lambda: game.add_light(at=(0, 0)),
        "emitter": lambda: game.add_particles(rate=1),
        "drawing": lambda: game.draw(evil.Circle(1)),
        "text": lambda: game.text("x"),
    }
    owner = made[what]() if what in made else getattr(game, what)
    with pytest.raises(AttributeError, match="colur"):
        owner.colur = "red"
