"""What happens in Python round a step of the core: behaviours and forces before it, events after it."""

from __future__ import annotations

import threading
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.checks import number
from evilengine.values.errors import ArgumentError
from evilengine.values.vec2 import to_vec2
from evilengine.world.character import tell_characters
from evilengine.world.contacts import ContactList
from evilengine.world.forces import PYTHON
from evilengine.world.joints.joint import joints_that_broke
from evilengine.world.sensors import VisitList

if TYPE_CHECKING:
    from evilengine.world.body import Body
    from evilengine.world.world import World


class StepInProgress:
    """A world's step as a whole, callbacks and all: there is one at a time."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._thread = 0

    def __enter__(self) -> None:
        if not self._lock.acquire(blocking=False):
            if self._thread == threading.get_ident():
                where = "inside a callback of this world's step; the step goes on by itself"
            else:
                where = "while another thread is in the middle of this world's step; let one thread do the stepping"
            raise ArgumentError(f"World.step: called {where}")
        self._thread = threading.get_ident()

    def __exit__(self, *error: object) -> None:
        self._thread = 0
        self._lock.release()


def update(world: World, dt: float) -> None:
    """Call the bodies' on_update, in the order in which they first had one."""
    world._updated = [body for body in world._updated if body.alive]
    for body in tuple(world._updated):
        if body.alive:
            body._callbacks["on_update"].run(dt)


def move_followers(world: World, dt: float) -> None:
    """Give each body that follows a motion the velocity that takes it there within the step (SPEC P5)."""
    for slot, (body, motion) in tuple(world._motions.items()):
        goal: Any = motion(world.time + dt) if follows(body) else None
        if not follows(body):  # also where the motion itself destroyed it
            world._motions.pop(slot, None)
            continue
        angle = body.angle
        if isinstance(goal, (tuple, list)) and len(goal) == 2 and hasattr(goal[0], "__len__"):  # a point, and an angle
            goal, angle = goal[0], number(goal[1], "Body.follow", "motion's angle")
        there = to_vec2(goal, "Body.follow", "motion's point")
        # the centre of mass moves, the origin shall arrive: turn the arm between them along
        arm = body.centre - body.position
        spin = (angle - body.angle) / dt
        body.velocity = (there + arm.turned(angle - body.angle) - body.centre) / dt
        body.angular_velocity = spin


def follows(body: Body) -> bool:
    """Can it follow a motion still?"""
    return body.alive and body.kind == "kinematic"


def ask_forces(world: World, dt: float) -> None:
    """Let the forces that are written in Python push."""
    for force in world.forces:
        if force._kind == PYTHON and force.alive:
            force.apply(force.bodies, dt)


CONTACTS = (("on_collide", "begun"), ("on_hit", "hit"), ("on_separate", "ended"))
VISITS = (("on_enter", "entered"), ("on_leave", "left"))
SLEEP = (("on_sleep", "slept"), ("on_wake", "woke"))


def tell_events(world: World) -> None:
    """Tell the bodies what happened to them, kind by kind, each in the order in which they were created."""
    heard, core = world._heard, world._core
    broken = joints_that_broke(world)
    for name, rows in CONTACTS:
        if name in heard:
            tell_contacts(world, name, getattr(core, rows))
    for name, rows in VISITS:
        if name in heard:
            tell_visits(world, name, getattr(core, rows))
    for name, bodies in SLEEP:
        if name in heard:
            for body in world.events._bodies(getattr(core, bodies)):
                if body.alive and name in body._callbacks:
                    body._callbacks[name].run()
    for each in broken:
        each.joint._broken.run(each)
    tell_characters(world)


def tell_contacts(world: World, name: str, rows: _core.Touches) -> None:
    """Tell both bodies of each contact, the older first."""
    contacts = ContactList(world, rows)
    for place in range(len(rows)):
        a, _, b, *_ = rows.row(place)
        if not (listens(world, name, a) or listens(world, name, b)):
            continue
        contact = contacts[place]
        for body in (contact.a, contact.b):
            if body.alive and name in body._callbacks:
                body._callbacks[name].run(contact)


def tell_visits(world: World, name: str, rows: _core.Touches) -> None:
    """Tell the body that has the sensor."""
    visits = VisitList(world, rows)
    for place in range(len(rows)):
        if not listens(world, name, rows.row(place)[0]):
            continue
        visit = visits[place]
        if visit.sensor.alive and name in visit.sensor._callbacks:
            visit.sensor._callbacks[name].run(visit)


def listens(world: World, name: str, slot: int) -> bool:
    """Does the body in this slot want to be told?"""
    return slot in world._handles and name in world._handles[slot]._callbacks
