"""What a saved game keeps of the functions on bodies and joints, by the names that lead back to them."""

from __future__ import annotations

from collections.abc import Callable, Container
from typing import TYPE_CHECKING, Any

from evilengine.world.character import EVENTS as CHARACTERS
from evilengine.world.character import Character

if TYPE_CHECKING:
    from evilengine.world.world import World

Named = Callable[[Callable[..., Any], str], Any]
Found = Callable[[Any, int | None], Callable[..., Any]]
"""A function by what `Named` called it and the slot of the body that it is on, if it is on one."""


def state_of(world: World, name_of: Named) -> dict[str, Any]:
    """Callbacks of bodies and joints, in their order, and motions. `name_of(function, where)` names the functions."""
    rows = []
    for slot, body in sorted(world._handles.items()):
        events = {
            event: [name_of(function, f"{event} of {body!r}") for function in callbacks._functions]
            for event, callbacks in sorted(body._callbacks.items())
            if callbacks
        }
        if events and body.alive:
            rows.append([slot, events])
    motions = [
        [slot, name_of(motion, f"the motion that {body!r} follows")]
        for slot, (body, motion) in world._motions.items()
        if body.alive
    ]
    joints = [
        [slot, [name_of(function, f"on_break of {joint!r}") for function in joint._broken._functions]]
        for slot, joint in sorted(world._joints.items())
        if joint._broken and joint.alive
    ]
    return {
        "callbacks": rows,
        "joints": joints,
        "updated": [body.slot for body in world._updated if body.alive and body._callbacks["on_update"]],
        "motions": motions,
    }


EVENTS = (
    *("on_collide", "on_separate", "on_hit", "on_enter", "on_leave", "on_sleep", "on_wake", "on_touch", "on_update"),
    *CHARACTERS,
)


def read(
    world: World, state: dict[str, Any], find: Found, bodies: Container[int], joints: Container[int]
) -> Callable[[], None]:
    """Read what `state_of` gave, and return what puts it in place once the world is restored."""
    rows = [(slot, {str(event): names for event, names in events.items()}) for slot, events in state["callbacks"]]
    motions = [(slot, find(name, slot)) for slot, name in state["motions"]]
    updated = list(state["updated"])
    if not all(slot in bodies for slot in (*(slot for slot, _ in rows), *(slot for slot, _ in motions), *updated)):
        raise ValueError("functions on bodies that are not there")
    if not all(event in EVENTS for _, events in rows for event in events):
        raise ValueError("functions for events that do not exist")
    breaking = [(slot, [find(name, None) for name in names]) for slot, names in state.get("joints", [])]
    if not all(slot in joints for slot, _ in breaking):
        raise ValueError("functions on joints that are not there")
    functions = [
        (slot, event, [find(name, slot) for name in names]) for slot, events in rows for event, names in events.items()
    ]

    def put() -> None:
        for body in world._handles.values():
            for callbacks in body._callbacks.values():
                callbacks._functions.clear()
        world._updated = [body for body in world._updated if body.alive]
        for slot, event, found in functions:
            body = world._body(slot)
            owner = Character(body) if event in CHARACTERS else body
            getattr(owner, event)._functions.extend(found)
        order = {slot: place for place, slot in enumerate(updated)}
        world._updated.sort(key=lambda body: order.get(body.slot, len(order)))
        for joint in world._joints.values():
            joint._broken._functions.clear()
        for slot, found in breaking:
            world._joints[slot]._broken._functions.extend(found)
        world._motions = {slot: (world._body(slot), motion) for slot, motion in motions}

    return put
