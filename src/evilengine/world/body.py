"""Body and Shape: handles of what is in a world (SPEC A5, A6)."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import TYPE_CHECKING, TypeVar

from evilengine import _core
from evilengine.math import Mat4
from evilengine.values.callbacks import Callbacks
from evilengine.values.checks import known_keywords, number, one_of
from evilengine.values.errors import ArgumentError, ArgumentTypeError
from evilengine.values.vec2 import Point, Vec2, to_vec2
from evilengine.world.shapes import ShapeDefinition, to_shape
from evilengine.world.traits import Side, given

if TYPE_CHECKING:
    from evilengine.world.forces import Force
    from evilengine.world.joints import Joint
    from evilengine.world.world import World

KINDS = ("static", "kinematic", "dynamic")  # in the order of BodyKind in core/bodies.hpp
AnyForce = TypeVar("AnyForce", bound="Force")
Motion = Callable[[float], Point | tuple[Point, float]]


class Body(_core.Body):
    """A rigid body of a world: the handle that `world.add` gives.

    It is a reference: equal to every other reference to the same body, usable as a dictionary key, and after
    `destroy()`, or after a restore to a time without it, any use raises StaleReferenceError. Ask `alive` first.

    >>> import evilengine as evil
    >>> ball = evil.World().add(evil.Circle(0.5), at=(0, 5), tag="ball")
    >>> ball.position, ball.kind, ball.tag
    (Vec2(0.0, 5.0), 'dynamic', 'ball')
    >>> ball.destroy(); ball.alive
    False
    """

    _callbacks: Mapping[str, Callbacks[...]] = MappingProxyType({})  # most bodies never have any

    def __init__(self, world: World, slot: int, generation: int) -> None:
        _core.Body.__init__(self, world._core, slot, generation)
        self._world = world

    @property
    def world(self) -> World:
        """The world that it is, or was, in."""
        return self._world

    @property
    def kind(self) -> str:
        """'dynamic': moved by forces and contacts; 'kinematic': by its own velocity alone; 'static': not at all."""
        return KINDS[self._kind]

    @kind.setter
    def kind(self, value: str) -> None:
        self._kind = KINDS.index(one_of(value, "Body", "kind", KINDS))

    @property
    def tag(self) -> str | None:
        """A name of your choice, for finding it again: `world.find(tag)`. Saved with the world."""
        return self._tag or None

    @tag.setter
    def tag(self, value: str | None) -> None:
        self._tag = to_tag(value, "Body")

    @property
    def matrix(self) -> Mat4:
        """Body to world: position, rotation and scale, 16 floats column by column (SPEC P4)."""
        return Mat4(self._matrix)

    @known_keywords
    def apply_matrix(self, matrix: Mat4) -> None:
        """Apply a 4x4 matrix after the body's own: move, turn and scale it in one go.

        Raises ShapeError, and changes nothing, when the result would be flat, sheared, or squeeze a Circle.

        >>> import evilengine as evil
        >>> box = evil.World().add(evil.Rectangle(1, 1), at=(1, 0))
        >>> box.apply_matrix(evil.Mat4.translation(0, 2)); box.position
        Vec2(1.0, 2.0)
        """
        self._apply_matrix(matrix)

    # -- shapes --

    @property
    def shapes(self) -> tuple[Shape, ...]:
        """Its shapes, in the order they were added."""
        return tuple(self._world._shape(slot) for slot in self._shape_slots())

    @known_keywords
    def add_shape(
        self,
        shape: ShapeDefinition,
        *,
        offset: Point = (0.0, 0.0),
        angle: float = 0.0,
        density: float | None = None,
        friction: float | None = None,
        restitution: float | None = None,
        category: int | None = None,
        mask: int | None = None,
        group: int | None = None,
        sensor: bool | None = None,
        one_way: Side = None,
        surface_speed: float | None = None,
    ) -> Shape:
        """Add one more shape, `offset` and turned by `angle` in the body's frame. Mass and centre follow.

        What is not given is as the body's own: density, friction, restitution, and from `category` to `surface_speed`
        how it deals with what it meets. `one_way=False` makes it solid from everywhere on a body that is not. Raises
        ShapeError when the mass would be out of range; the body is then as before.

        >>> import evilengine as evil
        >>> hammer = evil.World().add(evil.Rectangle(0.2, 2))
        >>> head = hammer.add_shape(evil.Rectangle(1, 0.4), offset=(0, 1))
        >>> len(hammer.shapes)
        2
        """
        me = "Body.add_shape"
        words = {"category": category, "mask": mask, "group": group, "sensor": sensor, "one_way": one_way}
        traits = given(**words, surface_speed=surface_speed)
        if traits:
            _core.check_traits(traits, me)
        spec = to_shape(shape, me)._spec
        own_density, own_friction, own_restitution = self._world._core.material(self._require())
        used = _core.use(
            spec,
            to_vec2(offset, "Body.add_shape", "offset"),
            number(angle, "Body.add_shape", "angle"),
            own_density if density is None else number(density, "Body.add_shape", "density", least=0.0, most=1e9),
            own_friction if friction is None else number(friction, "Body.add_shape", "friction", least=0.0, most=1e6),
            own_restitution
            if restitution is None
            else number(restitution, "Body.add_shape", "restitution", least=0.0, most=1.0),
        )
        slot = self._world._core.add_shape(self, used)
        self._world._definitions[slot] = shape
        made = self._world._shape(slot)
        if traits:
            made._set_traits(traits)
        return made

    # -- forces --

    @known_keywords
    def add_force(self, force: AnyForce) -> AnyForce:
        """Let `force` act on this body; returns it. One that is in this world already is shared.

        >>> import evilengine as evil
        >>> world = evil.World(gravity=(0, 0))
        >>> ball = world.add(evil.Circle(0.5), mass=1)
        >>> spring = ball.add_force(evil.Spring(to=(0, 8), stiffness=20, rest_length=1))
        >>> spring.alive, spring.bodies == (ball,)
        (True, True)
        """
        return self._world.add_force(force, [self])

    @property
    def forces(self) -> tuple[Force, ...]:
        """The forces that were added to it, in the order they came into the world."""
        slot = self._require()
        return tuple(f for f in self._world.forces if slot in f._handle().body_slots)

    @property
    def joints(self) -> tuple[Joint, ...]:
        """The joints that tie it to others, in creation order."""
        slot = self._require()
        return tuple(self._world._joints[joint] for joint in _core.joint_slots_of(self._world._core, slot))

    # -- behaviours and events --

    @property
    def on_update(self) -> Callbacks[[float]]:
        """Decorator: call a function with dt before each step (SPEC P5)."""
        return self._callback("on_update", "dt")

    @property
    def on_collide(self) -> Callbacks[...]:
        """Decorator: call a function with the Contact when this body begins to touch another."""
        return self._callback("on_collide", "contact")

    @property
    def on_separate(self) -> Callbacks[...]:
        """Decorator: call a function with the Contact when this body ceases to touch another (or a lost one)."""
        return self._callback("on_separate", "contact")

    @property
    def on_hit(self) -> Callbacks[...]:
        """Decorator: call a function with the Contact when this body hits another faster than `world.hit_speed`."""
        return self._callback("on_hit", "contact")

    @property
    def on_enter(self) -> Callbacks[...]:
        """Decorator: call a function with the Visit when something enters a sensor of this body."""
        return self._callback("on_enter", "visit")

    @property
    def on_leave(self) -> Callbacks[...]:
        """Decorator: call a function with the Visit when something leaves a sensor of this body, or is lost in it."""
        return self._callback("on_leave", "visit")

    @property
    def visitors(self) -> tuple[Body, ...]:
        """The bodies that this body's sensors saw in the last step, in creation order."""
        self._require()
        bodies = dict.fromkeys(visit.visitor for visit in self._world.sensors.inside if visit.sensor == self)
        return tuple(bodies)

    @property
    def on_sleep(self) -> Callbacks[[]]:
        """Decorator: call a function, without arguments, when this body falls asleep."""
        return self._callback("on_sleep")

    @property
    def on_wake(self) -> Callbacks[[]]:
        """Decorator: call a function, without arguments, when this body wakes."""
        return self._callback("on_wake")

    @property
    def on_touch(self) -> Callbacks[...]:
        """Decorator: call a function with each Touch on this body; it replaces the finger's pull."""
        return self._callback("on_touch", "touch")

    def _callback(self, name: str, *arguments: str) -> Callbacks[...]:
        self._require()
        if name not in self._callbacks:
            self._callbacks = {**self._callbacks, name: Callbacks(f"Body.{name}", *arguments)}
            self._world._heard.add(name)
            if name == "on_update":
                self._world._updated.append(self)
        return self._callbacks[name]

    @known_keywords
    def follow(self, motion: Motion | None) -> None:
        """Let a kinematic body follow a given motion: `motion(time)` gives where it shall be at that simulated time.

        It returns a point, or (point, angle). The body gets the velocity that takes it there within the step, so it
        carries and pushes what it touches. None ends it, and the body stops.

        >>> import evilengine as evil
        >>> world = evil.World()
        >>> lift = world.add(evil.Rectangle(2, 0.2), kind="kinematic")
        >>> lift.follow(lambda time: (0, time))
        >>> world.step(0.5); round(lift.position.y, 5)
        0.5
        """
        if self.kind != "kinematic":
            raise ArgumentError(f"Body.follow: the body is {self.kind}; only a kinematic body can follow a motion")
        if motion is not None and not callable(motion):
            raise ArgumentTypeError(f"Body.follow: motion={motion!r} must be a function of the time, or None")
        self._world._motions.pop(self.slot, None)
        if motion is None:
            self.velocity, self.angular_velocity = Vec2(0.0, 0.0), 0.0
        else:
            self._world._motions[self.slot] = (self, motion)

    # -- its end --

    def destroy(self) -> None:
        """Take the body out of its world, with its shapes. Safe at any time, also in a callback.

        Any later use of this handle, and of its shapes', raises StaleReferenceError.
        """
        self._require()
        self._world._destroy_body(self)

    def _require(self) -> int:
        """Its slot, if it is alive."""
        _ = self._kind  # raises StaleReferenceError
        return self.slot

    def __repr__(self) -> str:
        if not self.alive:
            return f"<{type(self).__name__} {self.slot}, destroyed>"
        tag = f" {self._tag!r}" if self._tag else ""
        return f"<{type(self).__name__} {self.slot}{tag}, {self.kind}, at ({self.position.x:g}, {self.position.y:g})>"


class Shape(_core.Shape):
    """A shape on a body: the handle that `body.add_shape` gives, and one of `body.shapes`."""

    def __init__(self, world: World, slot: int, generation: int, definition: ShapeDefinition | None = None) -> None:
        super().__init__(world._core, slot, generation)
        self._world = world
        self._definition = definition

    @property
    def body(self) -> Body:
        """The body that it is on."""
        return self._world._body(self._body_slot)

    @property
    def definition(self) -> ShapeDefinition | None:
        """The Circle, Rectangle, ... that it was made from; None if it came from a snapshot of another process."""
        _ = self._body_slot  # raises StaleReferenceError
        return self._definition

    @property
    def matrix(self) -> Mat4:
        """Shape to body (SPEC P4)."""
        return Mat4(self._matrix)

    @known_keywords
    def apply_matrix(self, matrix: Mat4) -> None:
        """Apply a 4x4 matrix after the shape's own: move, turn, scale or shear it on its body. Mass follows.

        Raises ShapeError, and changes nothing, when the result would be flat or squeeze a Circle.
        """
        self._apply_matrix(matrix)

    def destroy(self) -> None:
        """Take the shape off its body."""
        self._world._destroy_shape(self)

    def __repr__(self) -> str:
        what = self._definition if self._definition is not None else "from a snapshot"
        return f"<Shape {self.slot}, {what}{'' if self.alive else ', destroyed'}>"


def to_tag(value: object, owner: str) -> str:
    """A tag as the core keeps it, "" for none."""
    if value is None:
        return ""
    if not isinstance(value, str) or len(value) > 1000:
        raise ArgumentTypeError(f"{owner}: tag={value!r} must be a string of at most 1000 letters, or None")
    return value
