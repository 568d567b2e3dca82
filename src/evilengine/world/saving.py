"""What a snapshot keeps of forces written in Python, and their objects after a restore."""

from __future__ import annotations

import functools
import json
import sys
from typing import TYPE_CHECKING, Any

from evilengine import _core
from evilengine.values.errors import SnapshotError
from evilengine.world import forces as kinds
from evilengine.world.forces import Force
from evilengine.world.joints import KINDS, Joint
from evilengine.world.media import Medium

if TYPE_CHECKING:
    from evilengine.world.world import World

BUILT_IN: dict[int, type[Force]] = {
    kind._kind: kind for kind in (kinds.Gravity, kinds.ConstantForce, kinds.Spring, kinds.Drag, Medium, kinds.Pull)
}


def note_python_forces(world: World) -> None:
    """Give the core what it shall save of each force written in Python."""
    for force in world.forces:
        if force._kind == kinds.PYTHON:
            force._handle().note = force._note()


def become(world: World, saved: _core.Saved) -> None:
    """Become what was read, whose notes were checked."""
    areas = {force: force._handle().area for force in world.forces if isinstance(force, Medium)}
    bodies, shapes = world._core.restore(saved)
    world._forces = forces_now(world)
    for medium, area in areas.items():
        if medium.alive and medium._handle().area != area:
            medium._read_back(world, medium._handle())
    world._joints = joints_now(world)
    world._broken_joints = ()
    for slot in bodies:
        world._handles.pop(slot, None)
    for slot in shapes:
        world._shape_handles.pop(slot, None)
        world._definitions.pop(slot, None)
    world._motions = {slot: pair for slot, pair in world._motions.items() if pair[0].alive}


def forces_now(world: World) -> dict[int, Force]:
    """An object for each force of the core: the one that was there, or a new one."""
    forces = {}
    for slot in world._core.force_slots():
        handle = _core.Force(world._core, slot, world._core.force_generation(slot))
        old = world._forces.get(slot)
        kept = old if old is not None and old._ref == handle else None
        if handle.kind == kinds.PYTHON:
            forces[slot] = python_force(world, handle, kept)
        else:
            forces[slot] = kept or BUILT_IN[handle.kind]._adopt(world, handle)
    return forces


def joints_now(world: World) -> dict[int, Joint]:
    """An object for each joint of the core: the one that was there, or a new one."""
    joints = {}
    for slot in _core.joint_slots(world._core):
        handle = _core.Joint(world._core, slot, _core.joint_generation(world._core, slot))
        old = world._joints.get(slot)
        kept = old if old is not None and old._fields == handle else None
        joints[slot] = kept or KINDS[handle.kind]._adopt(world, handle)
    return joints


def python_force(world: World, handle: _core.Force, kept: Force | None) -> Force:
    """The object of a Python force after a restore, with the attributes that were saved."""
    module, name, state = parts_of(handle.note)
    force = kept
    if force is None:
        kind = next((type(f) for f in world._forces.values() if names_of(type(f)) == (module, name)), None)
        kind = kind or python_kind(module, name)
        force = kind.__new__(kind)
        force._bind(world, handle)
    force._restore_note(state)
    return force


def python_kind(module: str, name: str) -> type[Force]:
    """The class of a Python force, found by name, or SnapshotError.

    Only among modules that the program has imported itself: bytes from a stranger must not make it import others.
    """
    kind = _kind_called(module, name)
    if kind is None:
        raise SnapshotError(
            f"World.restore: the force {module}.{name} of this snapshot cannot be found;"
            " define it at the top of a module and import that module first"
        )
    return kind


def parts_of(note: str) -> tuple[str, str, dict[str, Any]]:
    """Module, class and attributes out of a force's note."""
    try:
        module, name, state = json.loads(note)
    except ValueError:
        module = name = state = None
    if not (isinstance(module, str) and isinstance(name, str) and isinstance(state, dict)):
        raise SnapshotError("World.restore: this snapshot holds a force that makes no sense; the world is as it was")
    return module, name, state


def _kind_called(module: str, name: str) -> type[Force] | None:
    try:
        kind = functools.reduce(getattr, name.split("."), sys.modules[module])
    except (KeyError, AttributeError):
        return None
    return kind if isinstance(kind, type) and issubclass(kind, Force) else None


def names_of(kind: type[Force]) -> tuple[str, str]:
    """How a class is found again: its module and its name there."""
    return kind.__module__, kind.__qualname__


def check_notes(world: World, notes: list[str]) -> None:
    """Refuse a snapshot whose Python forces could not come back, before anything has changed."""
    here = {names_of(type(force)) for force in world.forces}
    for note in notes:
        module, name, _ = parts_of(note)
        if (module, name) not in here:
            python_kind(module, name)


def check_python_forces(world: World) -> None:
    """Refuse forces written in Python whose class could not be found again by name. Raises SnapshotError."""
    for force in world.forces:
        if force._kind == kinds.PYTHON and _kind_called(*names_of(type(force))) is not type(force):
            raise SnapshotError(f"{force!r} cannot be saved: define {type(force).__qualname__} at the top of a module")
