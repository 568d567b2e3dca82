"""What a step tells: contacts begun, ended and hit, bodies that fell asleep or woke, in the order of creation."""

from __future__ import annotations

import gc

import numpy as np
import pytest

import evilengine as evil


@pytest.fixture
def world():
    return evil.World()


def ground(world, width=40):
    return world.add(evil.Rectangle(width, 1), at=(0, -0.5), kind="static")


def until(world, done, steps=600):
    for _ in range(steps):
        if done():
            return
        world.step()
    raise AssertionError("it did not come to pass")


def order_of(contact):
    return (contact.a.slot, contact.b.slot)  # slots rise with creation where nothing was destroyed


def test_events_come_in_the_order_of_creation(world):
    balls = [world.add(evil.Circle(0.4), at=(x, 1.0 - x / 1000)) for x in (3, -5, 1, 7, -2)]
    floor = ground(world)
    until(world, lambda: world.contacts.begun)
    begun = list(world.contacts.begun)
    while len(begun) < len(balls):
        world.step()
        begun.extend(world.contacts.begun)
    assert all(contact.b is floor for contact in begun)
    active = list(world.contacts.active)
    assert [contact.a for contact in active] == balls
    for ball in balls:
        ball.velocity = (0, 5)
    ended = []
    while len(ended) < len(balls):
        world.step()
        assert [order_of(c) for c in world.contacts.ended] == sorted(order_of(c) for c in world.contacts.ended)
        ended.extend(world.contacts.ended)
    assert {contact.a for contact in ended} == set(balls)


def test_an_ended_contact_says_where_they_touched_last(world):
    floor = ground(world)
    ball = world.add(evil.Circle(0.5), at=(3, 0.5))
    world.step()
    ball.velocity = (0, 50)
    until(world, lambda: world.contacts.ended)
    (contact,) = world.contacts.ended
    assert (contact.a, contact.b) == (floor, ball)
    assert contact.point == pytest.approx((3, 0), abs=0.05)
    assert contact.normal == pytest.approx((0, 1))
    assert (contact.depth, contact.impulse, contact.speed) == (0, 0, 0)


def test_the_pieces_of_a_concave_shape_are_one_contact(world):
    comb = [
        (-3, -1),
        (3, -1),
        (3, 0),
        (2, 0),
        (2, -0.5),
        (1, -0.5),
        (1, 0),
        (-1, 0),
        (-1, -0.5),
        (-2, -0.5),
        (-2, 0),
        (-3, 0),
    ]
    floor = world.add(evil.Polygon(comb), kind="static")
    plank = world.add(evil.Rectangle(6, 0.5), at=(0, 0.4))
    begun = ended = 0
    for _ in range(120):
        world.step()
        begun += len(world.contacts.begun)
        ended += len(world.contacts.ended)
    assert (begun, ended) == (1, 0)
    (contact,) = world.contacts.active
    assert (contact.a, contact.b) == (floor, plank)
    assert contact.impulse == pytest.approx(plank.mass * 9.81 / 60, rel=0.02)
    plank.destroy()
    world.step()
    assert len(world.contacts.ended) == 1
    assert len(world.contacts.active) == 0


def test_a_hit_tells_how_fast(world):
    ground(world)
    ball = world.add(evil.Circle(0.5), at=(0, 5.5))
    hits = []
    ball.on_hit(hits.append)
    for _ in range(180):
        world.step()
    (hit,) = hits
    assert hit.speed == pytest.approx((2 * 9.81 * 5) ** 0.5, rel=0.05)
    assert hit.point == pytest.approx((0, 0), abs=0.2)


def test_slower_than_the_hit_speed_is_no_hit(world):
    ground(world)
    world.add(evil.Circle(0.5), at=(0, 1.0))
    world.hit_speed = 5
    for _ in range(60):
        world.step()
        assert not world.contacts.hit
    with pytest.raises(evil.ArgumentError, match="hit_speed=-1 must be"):
        world.hit_speed = -1


def test_every_bounce_is_a_hit(world):
    world.gravity = (0, 0)
    for x in (-3, 3):
        world.add(evil.Rectangle(1, 4), at=(x, 0), kind="static", restitution=1)
    world.add(evil.Circle(0.5), velocity=(8, 0), restitution=1)
    hits = []
    for _ in range(240):
        world.step()
        hits += [contact.speed for contact in world.contacts.hit]
    assert len(hits) == 4 * 8 // 4
    assert hits == pytest.approx([8] * len(hits), rel=1e-3)


def test_bodies_that_fall_asleep_and_wake_are_told_once(world):
    ground(world)
    boxes = [world.add(evil.Rectangle(1, 1), at=(3 * x, 0.5)) for x in range(4)]
    told = []
    for number, box in enumerate(boxes):
        box.on_sleep(lambda number=number: told.append(("slept", number)))
        box.on_wake(lambda number=number: told.append(("woke", number)))
    until(world, lambda: not any(box.awake for box in boxes))
    assert world.events.slept == tuple(boxes)
    assert told == [("slept", 0), ("slept", 1), ("slept", 2), ("slept", 3)]
    world.step()
    assert world.events.slept == ()
    boxes[2].apply_impulse((0, 3))
    assert world.events.woke == ()
    world.step()
    assert world.events.woke == (boxes[2],)
    assert told[4:] == [("woke", 2)]


def test_a_body_put_to_sleep_and_woken_between_steps_is_not_told(world):
    box = world.add(evil.Rectangle(1, 1))
    world.gravity = (0, 0)
    world.step()
    box.awake = False
    box.awake = True
    world.step()
    assert (world.events.slept, world.events.woke) == ((), ())


def test_events_as_columns(world):
    ground(world)
    boxes = [world.add(evil.Rectangle(1, 1), at=(2 * x, 0.49)) for x in range(5)]
    world.step()
    contacts = world.contacts.active
    bodies, normals = np.asarray(contacts.bodies), np.asarray(contacts.normals)
    assert bodies.dtype == np.uint32
    assert bodies.tolist() == [[0, box.slot] for box in boxes]
    assert normals.dtype == np.float32
    assert normals.tolist() == [[0, 1]] * 5
    assert np.asarray(contacts.points).tolist() == [list(contact.point) for contact in contacts]
    for name in ("depths", "impulses", "speeds"):
        column = np.asarray(getattr(contacts, name))
        assert column.shape == (5,)
        assert column.tolist() == [getattr(contact, name[:-1]) for contact in contacts]
    assert np.asarray(contacts.shapes).tolist() == [[c.shape_a.slot, c.shape_b.slot] for c in contacts]
    with pytest.raises((ValueError, BufferError)):
        np.asarray(contacts.depths)[0] = 1


def test_columns_of_nothing_have_no_rows(world):
    world.step()
    assert np.asarray(world.contacts.begun.bodies).shape == (0, 2)
    assert np.asarray(world.contacts.hit.speeds).shape == (0,)


def test_a_list_of_contacts_stays_while_the_world_goes_on(world):
    ground(world)
    ball = world.add(evil.Circle(0.5), at=(0, 0.5))
    world.step()
    begun = world.contacts.begun
    ball.velocity = (0, 20)
    for _ in range(10):
        world.step()
    (contact,) = begun
    assert begun[-1] == contact == begun[0]
    assert begun[:1] == (contact,)
    assert begun == [contact]
    assert contact.b is ball
    with pytest.raises(IndexError):
        _ = begun[1]


def test_what_is_destroyed_before_a_snapshot_ends_after_it(world):
    ground(world)
    ball = world.add(evil.Circle(0.5), at=(0, 0.5))
    world.step()
    ball.destroy()
    data = world.snapshot()
    twin = evil.World.of(data)
    for one in (world, twin):
        one.step()
        assert [(c.a.slot, c.b.slot, c.b.alive) for c in one.contacts.ended] == [(0, 1, False)]
    assert world.snapshot() == twin.snapshot()


def test_hits_and_sleep_go_on_as_if_never_stopped_after_a_restore():
    def scene():
        world = evil.World()
        world.hit_speed = 0.5
        ground(world)
        for x in range(6):
            world.add(evil.Rectangle(0.9, 0.9), at=(x % 3 - 1, 1 + 1.2 * (x // 3)), restitution=0.4)
        return world

    def told(world):
        world.step()
        lists = (world.contacts.begun, world.contacts.ended, world.contacts.hit)
        return [[(order_of(c), c.speed, c.point) for c in one] for one in lists] + [
            [body.slot for body in one] for one in (world.events.slept, world.events.woke)
        ]

    world = scene()
    for step in range(200):
        twin = evil.World.of(world.snapshot())
        assert told(twin) == told(world), step


def test_whatever_a_callback_destroys_the_others_are_told(world):
    floor = ground(world)
    first, second = (world.add(evil.Circle(0.4), at=(x, 1)) for x in (-1, 1))
    told = []
    first.on_collide(lambda contact: second.destroy())
    floor.on_collide(lambda contact: told.append((contact.b.slot, contact.b.alive)))
    until(world, lambda: told)
    assert told == [(first.slot if first.alive else 1, True), (2, False)]


def test_columns_outlive_their_list_and_the_world_that_goes_on():
    world = evil.World()
    world.add(evil.Rectangle(40, 1), kind="static")
    boxes = world.add_many(evil.Rectangle(1, 1), [(3 * i, 1) for i in range(4)])
    world.step()
    points, bodies, depths = (getattr(world.contacts.begun, name) for name in ("points", "bodies", "depths"))
    before = points.tolist()
    for box in boxes:
        box.destroy()
    world.step()
    gc.collect()
    assert points.tolist() == before
    assert bodies.tolist() == [[0, 1 + i] for i in range(4)]
    assert (depths.shape, depths.format, depths.readonly) == ((4,), "f", True)
    assert world.contacts.begun.points.shape == (0, 2)
