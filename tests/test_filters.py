"""Who meets whom: categories, masks and groups, of bodies and of shapes, changed at any time."""

from __future__ import annotations

import itertools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import evilengine as evil

PLAYER, ENEMY, WALL = 1, 2, 4


@pytest.fixture
def world():
    return evil.World()


def ground(world, **words):
    return world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static", **words)


def run(world, seconds):
    for _ in range(round(seconds * 60)):
        world.step()


def meet(s, t):
    """The rule, in words of its own."""
    (category_s, mask_s, group_s), (category_t, mask_t, group_t) = s, t
    if group_s == group_t != 0:
        return group_s > 0
    return bool(mask_s & category_t) and bool(mask_t & category_s)


def test_what_the_mask_does_not_name_is_passed_through(world):
    ground(world, category=WALL)
    ghost = world.add(evil.Circle(0.5), at=(0, 2), mask=evil.ALL & ~WALL)
    ball = world.add(evil.Circle(0.5), at=(2, 2))
    run(world, 1)
    assert ghost.position.y < -1
    assert ball.position.y == pytest.approx(0.5, abs=0.02)


numbers = st.tuples(st.integers(1, 15), st.integers(0, 15), st.integers(-2, 2))


@settings(max_examples=60, deadline=None)
@given(st.lists(numbers, min_size=2, max_size=5))
def test_pairs_meet_by_the_rule(traits):
    world = evil.World(gravity=(0, 0))
    balls = [
        world.add(evil.Circle(1), at=(i / 10, 0), category=category, mask=mask, group=group)
        for i, (category, mask, group) in enumerate(traits)
    ]
    world.step()
    found = {(contact.a, contact.b) for contact in world.contacts.active}
    wanted = {
        (balls[i], balls[j]) for i, j in itertools.combinations(range(len(balls)), 2) if meet(traits[i], traits[j])
    }
    assert found == wanted


def test_a_change_of_the_mask_opens_the_floor_at_once_and_wakes_who_slept_on_it(world):
    floor = ground(world, category=WALL)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    run(world, 2)
    assert not box.awake
    floor.mask = 0
    assert box.awake
    world.step()
    assert [contact.b for contact in world.contacts.ended] == [box]
    run(world, 1)
    assert box.position.y < -2


def test_a_change_that_changes_nothing_for_a_pair_tells_nothing(world):
    floor = ground(world)
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    run(world, 1)
    box.group = 3
    floor.category = 5
    box.mask = 1
    world.step()
    assert (len(world.contacts.begun), len(world.contacts.ended), len(world.contacts.active)) == (0, 0, 1)


def test_a_shape_may_have_its_own_and_else_has_its_bodys(world):
    ground(world, category=WALL)
    body = world.add(evil.Rectangle(1, 1), at=(0, 3), mask=PLAYER | WALL, category=ENEMY)
    wing = body.add_shape(evil.Rectangle(3, 0.2), offset=(0, -2), mask=0)
    tail = body.add_shape(evil.Circle(0.1))
    assert (wing.mask, wing.category) == (0, ENEMY)
    assert (tail.mask, tail.category) == (PLAYER | WALL, ENEMY)
    run(world, 3)
    assert body.position.y > 0.4
    body.mask = 0
    assert (wing.mask, tail.mask, body.mask, body.category) == (0, 0, 0, ENEMY)
    run(world, 1)
    assert body.position.y < -2


def test_setting_one_trait_of_a_body_leaves_the_others_of_its_shapes(world):
    body = world.add(evil.Rectangle(1, 1))
    zone = body.add_shape(evil.Circle(3), sensor=True)
    body.category = ENEMY
    assert zone.sensor
    assert zone.category == ENEMY
    assert not body.sensor


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ({"category": 0}, r"category=0 must be from 1 to 4294967295"),
        ({"category": 1.5}, r"category=1.5 must be a whole number"),
        ({"category": True}, r"category=True must be a whole number"),
        ({"mask": -1}, r"mask=-1 must be from 0"),
        ({"mask": "wall"}, r"mask='wall' must be a whole number"),
        ({"mask": 2**70}, r"mask=\d+ must be from 0"),
        ({"group": 2**31}, r"group=2147483648 must be from"),
        ({"sensor": 1}, r"sensor=1"),
        ({"one_way": (0, 0)}, r"one_way=\(0, 0\) must be a direction"),
        ({"one_way": "up"}, r"one_way"),
        ({"surface_speed": float("nan")}, r"surface_speed"),
        ({"surface_speed": 1e5}, r"surface_speed=100000.0 must be from -10000 to 10000"),
    ],
)
def test_what_is_no_trait_is_refused_by_name_and_nothing_has_changed(world, words, message):
    body = world.add(evil.Circle(1))
    before = world.snapshot()
    with pytest.raises(evil.Error, match=message):
        world.add(evil.Circle(1), **words)
    with pytest.raises(evil.Error, match=message):
        body.add_shape(evil.Circle(1), **words)
    for owner in (body, body.shapes[0]):
        ((name, value),) = words.items()
        with pytest.raises(evil.Error, match=message):
            setattr(owner, name, value)
    assert world.snapshot() == before


def test_filters_are_in_a_snapshot(world):
    ground(world, category=WALL)
    ghost = world.add(evil.Circle(0.5), at=(0, 1), mask=2, group=-7)
    twin = evil.World.of(world.snapshot())
    run(world, 1)
    run(twin, 1)
    assert twin.snapshot() == world.snapshot()
    other = next(body for body in twin.bodies if body.slot == ghost.slot)
    assert (other.mask, other.group, other.shapes[0].mask) == (2, -7, 2)
    assert other.add_shape(evil.Circle(0.1)).mask == 2
