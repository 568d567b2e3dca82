"""Drawings: handles that say so when what they meant is gone, and leave nothing behind."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Iterator

import pytest
from stage import BLACK, BLUE, GREEN, RED, SQUARE, Stage

import evilengine as evil
from evilengine.scene import Drawing, DrawnBody
from evilengine.values.errors import StaleReferenceError


@pytest.fixture
def stage() -> Stage:
    return Stage()


def uses(drawing: Drawing) -> Iterator[object]:
    """Each way to use a drawing, one at a time."""
    for name in ("colour", "texture", "texture_matrix", "matrix", "layer", "visible", "lit", "outline", "body"):
        yield lambda name=name: getattr(drawing, name)
    one = evil.Mat4.identity()
    values = {"colour": "red", "texture": None, "layer": 1, "visible": True, "lit": True, "outline": True}
    for name, value in (values | {"matrix": one, "texture_matrix": one}).items():
        yield lambda name=name, value=value: setattr(drawing, name, value)
    yield drawing.destroy
    yield lambda: drawing.place((0, 0))


def test_every_use_of_a_destroyed_drawing_says_what_it_was(stage: Stage) -> None:
    drawing = stage.add(tag="crate").draw(colour="red")
    drawing.destroy()
    assert not drawing.alive
    stage.scene.add(SQUARE, colour="blue")  # takes the same slot
    for use in uses(drawing):
        with pytest.raises(StaleReferenceError, match="this Drawing \\(Rectangle on body 'crate'\\) was destroyed"):
            use()  # type: ignore[operator]
    assert stage.at(0, 0) == BLUE
    assert "destroyed" in repr(drawing)


@pytest.mark.parametrize("look_first", [True, False])
def test_drawings_go_with_their_body(stage: Stage, look_first: bool) -> None:
    body = stage.add()
    drawings = [body.draw(colour="red"), body.draw(evil.Circle(0.2), colour="blue")]
    body.destroy()
    if look_first:
        assert stage.at(0, 0) == BLACK
        assert len(stage.scene) == 0
    fresh = stage.add()  # in the same slot of the world
    fresh.draw(colour="lime")
    for drawing in drawings:
        assert not drawing.alive
        with pytest.raises(StaleReferenceError, match=r"this Drawing .* went with its body"):
            drawing.colour = "red"  # type: ignore[assignment]
    assert stage.at(0, 0) == GREEN
    assert len(stage.scene) == 1


def test_drawings_go_with_their_shape(stage: Stage) -> None:
    body = stage.add()
    body.draw(colour="red")
    extra = body.add_shape(evil.Rectangle(0.5, 0.5), offset=(1, 0))
    assert len(body.drawings) == 2
    assert stage.at(1, 0) == RED
    extra.destroy()
    assert len(body.drawings) == 1
    assert (stage.at(0, 0), stage.at(1, 0)) == (RED, BLACK)


def test_a_restored_world_does_not_bring_stale_drawings_back(stage: Stage) -> None:
    body = stage.add()
    drawing = body.draw(colour="red")
    data = stage.world.snapshot()
    stage.world.restore(data)
    assert drawing.alive
    assert stage.at(0, 0) == RED
    body.destroy()
    stage.world.restore(data)
    assert not drawing.alive
    assert stage.at(0, 0) == BLACK
    again = next(iter(stage.world.bodies))
    assert isinstance(again, DrawnBody)
    again.draw(colour="blue")
    assert stage.at(0, 0) == BLUE


def test_shapes_that_came_out_of_a_snapshot_can_be_drawn(stage: Stage) -> None:
    stage.add([evil.Rectangle(0.4, 0.4), evil.Circle(0.1), evil.Particle()], at=(1, 0))
    other = Stage()
    other.world.restore(stage.world.snapshot())
    (body,) = other.world.bodies
    assert isinstance(body, DrawnBody)
    assert body.shapes[0].definition is None
    body.draw(colour="red")
    assert len(body.drawings) == 3
    assert other.at(1.15, 0.15) == RED
    with pytest.raises(evil.ArgumentError, match="has none"):
        other.scene.add(body.shapes[1], colours=["red"])


def test_drawings_compare_and_hash_by_what_they_refer_to(stage: Stage) -> None:
    one, other = stage.scene.add(SQUARE), stage.scene.add(SQUARE)
    assert one == one
    assert one != other
    assert one != (one._slot, one._generation)
    assert len({one, other, one}) == 2
    one.destroy()
    again = stage.scene.add(SQUARE)
    assert again != one
    assert Stage().scene.add(SQUARE) != again


def test_a_bodys_drawings_are_a_list_of_those_alive_in_the_order_they_were_made(stage: Stage) -> None:
    body = stage.add()
    assert body.drawings == []
    first, second = body.draw(colour="red"), body.draw(evil.Circle(0.2), at=(0, 0.3), colour="blue")
    third = stage.scene.add(SQUARE, body=body)
    assert body.drawings == [first, second, third]
    assert second.body is body
    second.destroy()
    assert body.drawings == [first, third]
    body.drawings.clear()  # a list of its own
    assert body.drawings == [first, third]


def test_a_body_of_several_shapes_is_drawn_whole_and_in_one_colour(stage: Stage) -> None:
    body = stage.add([evil.Rectangle(1, 0.2), evil.Rectangle(0.2, 1)])
    body.draw()
    assert len({drawing.colour for drawing in body.drawings}) == 1
    assert len(body.drawings) == 2
    assert stage.at(0.4, 0) == stage.at(0, 0.4) != BLACK


def test_meshes_are_shared_and_let_go(stage: Stage) -> None:
    core = stage.scene._core
    drawings = [stage.scene.add(shape) for shape in (SQUARE, evil.Rectangle(1, 1), evil.Circle(1), evil.Circle(1)) * 5]
    assert core.mesh_count == 2
    for drawing in drawings:
        drawing.destroy()
    assert (core.mesh_count, len(stage.scene)) == (0, 0)


def test_thousands_of_shapes_that_come_and_go_leave_nothing_behind(stage: Stage) -> None:
    keep = stage.scene.add(evil.Rectangle(0.5, 0.5), at=(1, 0), colour="red")
    for count in range(3000):  # each of its own size: enough to make the store of meshes tidy up
        stage.scene.add(evil.Rectangle(0.1, 0.1 + count / 1e4), colour="blue").destroy()
    content = stage.scene.collect(stage.camera).content
    assert (stage.scene._core.mesh_count, len(stage.scene), content.instance_count) == (1, 1, 1)
    assert content.vertex_count < 10_000
    assert keep.alive
    assert (stage.at(1, 0), stage.at(0, 0)) == (RED, BLACK)


def test_a_scene_and_its_world_are_collected_when_nobody_holds_them() -> None:
    stage = Stage()
    stage.add().draw()
    stage.show()
    gone = weakref.ref(stage.world), weakref.ref(stage.scene)
    del stage
    gc.collect()
    assert [one() for one in gone] == [None, None]
