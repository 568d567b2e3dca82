"""The world: adding, stepping, asking, references."""

import math
import random

import pytest

import evilengine as evil


@pytest.fixture
def world():
    return evil.World()


def ground(world, **options):
    return world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static", **options)


def run(world, seconds, dt=1 / 60):
    for _ in range(round(seconds / dt)):
        world.step(dt)


def test_a_ball_falls_and_comes_to_rest_on_the_ground(world):
    ground(world)
    ball = world.add(evil.Circle(0.5), at=(0, 5))
    run(world, 4)
    assert ball.position.y == pytest.approx(0.5, abs=0.01)
    assert not ball.awake


def test_ten_boxes_stand_still_for_a_minute(world):
    world.sleep = False
    ground(world)
    boxes = [world.add(evil.Rectangle(1, 1), at=(0, 0.5 + i)) for i in range(10)]
    run(world, 3)
    settled = [box.position for box in boxes]
    run(world, 57)
    drift = max((box.position - before).length for box, before in zip(boxes, settled, strict=True))
    assert drift < 0.02
    assert max(abs(box.angle) for box in boxes) < 0.02


def test_equal_circles_swap_velocities_in_an_elastic_collision():
    world = evil.World(gravity=(0, 0))
    a = world.add(evil.Circle(0.5), at=(-2, 0), velocity=(3, 0), restitution=1, friction=0)
    b = world.add(evil.Circle(0.5), at=(2, 0), restitution=1, friction=0)
    run(world, 2)
    assert a.velocity == pytest.approx((0, 0), abs=1e-4)
    assert b.velocity == pytest.approx((3, 0), abs=1e-4)


def test_an_inelastic_collision_keeps_momentum_and_stops_the_approach():
    world = evil.World(gravity=(0, 0))
    a = world.add(evil.Circle(0.5), at=(-2, 0), velocity=(3, 0), mass=1)
    b = world.add(evil.Circle(0.5), at=(2, 0), mass=2)
    run(world, 2)
    assert a.velocity.x == pytest.approx(1, abs=0.02)
    assert b.velocity.x == pytest.approx(1, abs=0.02)
    assert a.velocity.x * 1 + b.velocity.x * 2 == pytest.approx(3, abs=1e-4)


@pytest.mark.parametrize("restitution", [0.3, 0.5, 0.8, 1.0])
def test_a_bounce_keeps_the_share_of_speed_that_restitution_says(restitution):
    world = evil.World(gravity=(0, 0))
    world.add(evil.Rectangle(10, 1), at=(0, -0.5), kind="static")
    ball = world.add(evil.Circle(0.5), at=(0, 2), velocity=(0, -5), restitution=restitution)
    run(world, 1)
    assert ball.velocity.y == pytest.approx(5 * restitution, rel=1e-3)


@pytest.mark.parametrize(("friction", "slides"), [(0.4, True), (0.55, True), (0.65, False), (0.8, False)])
def test_a_box_on_a_slope_holds_below_its_friction_angle_and_slides_above(friction, slides):
    slope = math.atan(0.6)
    world = evil.World()
    world.add(evil.Rectangle(40, 1), kind="static", angle=-slope, friction=friction)
    start = evil.Vec2(0, 1).turned(-slope)
    box = world.add(evil.Rectangle(1, 1), at=start, angle=-slope, friction=friction)
    run(world, 1)
    expected = 0.5 * 9.81 * (math.sin(slope) - friction * math.cos(slope)) if slides else 0
    assert (box.position - start).length == pytest.approx(expected, abs=0.02)


@pytest.mark.parametrize("substeps", [1, 4, 16])
def test_free_fall_nears_the_exact_parabola_as_substeps_shrink(substeps):
    world = evil.World(gravity=(0, -10))
    ball = world.add(evil.Circle(0.5), velocity=(2, 3))
    for _ in range(60):
        world.step(1 / 60, substeps=substeps)
    assert ball.velocity.y == pytest.approx(3 - 10, abs=1e-3)
    assert ball.position.x == pytest.approx(2, abs=1e-3)
    assert ball.position.y == pytest.approx(3 - 5, abs=10 / 60 / substeps * 0.51)


@pytest.mark.parametrize("dt", [1 / 30, 1 / 60, 1 / 240])
def test_damping_keeps_its_fraction_of_velocity_a_second_at_any_step(dt):
    world = evil.World(gravity=(0, 0))
    ball = world.add(evil.Circle(0.5), velocity=(8, 0), damping=0.25, angular_velocity=4, angular_damping=0.5)
    run(world, 1, dt)
    assert ball.velocity.x == pytest.approx(2, rel=1e-3)
    assert ball.angular_velocity == pytest.approx(2, rel=1e-3)


def test_mass_and_inertia_follow_the_formulas(world):
    disc = world.add(evil.Circle(0.5), density=2)
    assert disc.mass == pytest.approx(2 * math.pi * 0.25)
    assert disc.inertia == pytest.approx(disc.mass * 0.25 / 2)
    box = world.add(evil.Rectangle(2, 1), mass=6)
    assert box.mass == 6
    assert box.inertia == pytest.approx(6 * (4 + 1) / 12)
    assert world.add(evil.Circle(1), kind="static").mass == math.inf


def test_an_impulse_off_centre_pushes_and_turns_as_the_formulas_say():
    world = evil.World(gravity=(0, 0))
    box = world.add(evil.Rectangle(2, 1), mass=6)
    box.apply_impulse((0, 3), at=(1, 0))
    assert box.velocity == pytest.approx((0, 0.5))
    assert box.angular_velocity == pytest.approx(3 / box.inertia)


def test_a_force_acts_for_one_step_and_is_cleared(world):
    world.gravity = (0, 0)
    ball = world.add(evil.Particle(mass=2))
    ball.apply_force((4, 0))
    assert ball.force == (4, 0)
    world.step(0.5)
    assert ball.velocity.x == pytest.approx(1)
    assert ball.force == (0, 0)
    world.step(0.5)
    assert ball.velocity.x == pytest.approx(1)


def test_acceleration_is_force_over_mass(world):
    world.gravity = (0, -10)
    ball = world.add(evil.Particle(mass=2))
    ball.apply_force((4, 0))
    world.step()
    assert ball.acceleration == pytest.approx((2, -10))


def test_matrices_of_body_and_shape_compose_and_follow(world):
    box = world.add(evil.Rectangle(2, 1), at=(3, 0))
    box.apply_matrix(evil.Mat4.translation(1, 2) @ evil.Mat4.rotation(math.pi / 2))
    assert box.position == pytest.approx((1, 5), abs=1e-5)
    assert box.angle == pytest.approx(math.pi / 2)
    assert box.matrix @ (1, 0) == pytest.approx((1, 6), abs=1e-5)
    box.shapes[0].apply_matrix(evil.Mat4.scale(2, 3))
    assert box.mass == pytest.approx(12)
    with pytest.raises(evil.ShapeError, match="squeeze"):
        world.add(evil.Circle(1)).shapes[0].apply_matrix(evil.Mat4.scale(1, 2))
    with pytest.raises(evil.ShapeError, match="flat"):
        box.apply_matrix(evil.Mat4.scale(0, 1))


def test_a_rectangle_turned_and_then_stretched_on_its_body_becomes_a_parallelogram(world):
    box = world.add(evil.Rectangle(1, 1))
    box.shapes[0].apply_matrix(evil.Mat4.scale(2, 1) @ evil.Mat4.rotation(math.pi / 4))
    assert box.mass == pytest.approx(2)
    assert world.bodies_at((1.3, 0)) == (box,)
    assert world.bodies_at((0, 0.8)) == ()


def test_a_lone_shape_off_the_origin_moves_the_centre_of_mass_not_the_position(world):
    body = world.add(evil.Polygon([(1, 0), (2, 0), (2, 1), (1, 1)]), at=(5, 5))
    assert body.position == (5, 5)
    assert body.centre == pytest.approx((6.5, 5.5))


def test_a_second_shape_moves_the_centre_and_its_destruction_moves_it_back(world):
    body = world.add(evil.Rectangle(1, 1))
    second = body.add_shape(evil.Rectangle(1, 1), offset=(2, 0))
    assert body.centre == pytest.approx((1, 0))
    assert body.mass == pytest.approx(2)
    second.destroy()
    assert body.centre == pytest.approx((0, 0))
    with pytest.raises(evil.StaleReferenceError, match="this Shape"):
        second.friction  # noqa: B018


def test_a_concave_polygon_collides_in_its_notch(world):
    world.add(evil.Polygon([(-3, 0), (3, 0), (3, 4), (2, 4), (2, 1), (-2, 1), (-2, 4), (-3, 4)]), kind="static")
    ball = world.add(evil.Circle(0.5), at=(0, 3))
    run(world, 3)
    assert ball.position == pytest.approx((0, 1.5), abs=0.02)


@pytest.mark.parametrize("speed", [20, 100, 400, 1000, 5000])
@pytest.mark.parametrize(
    "shape", [evil.Circle(0.1), evil.Rectangle(0.3, 0.1), evil.Triangle((0, 0), (0.2, 0), (0, 0.2))]
)
@pytest.mark.parametrize("angle", [0, 0.7])
def test_a_fast_body_does_not_pass_a_thin_wall(speed, shape, angle):
    world = evil.World(gravity=(0, 0))
    wall = world.add(evil.Rectangle(0.01, 40), at=(5, 0), kind="static", angle=angle)
    bullet = world.add(shape, velocity=(speed, speed / 7), angular_velocity=20)
    for _ in range(120):
        world.step()
        assert wall.to_local(bullet.centre).x < 0


def test_contacts_begin_once_and_end_once(world):
    floor = ground(world)
    ball = world.add(evil.Circle(0.5), at=(0, 2), tag="ball")
    begun, ended = [], []
    ball.on_collide(begun.append)
    ball.on_separate(ended.append)
    run(world, 3)
    assert len(begun) == 1
    contact = begun[0]
    assert (contact.a, contact.b) == (floor, ball)
    assert contact.other(ball) is floor
    assert contact.normal == pytest.approx((0, 1))
    assert contact.point.y == pytest.approx(0, abs=0.1)
    assert contact.speed > 3
    assert contact.impulse > 0
    assert ended == []
    ball.apply_impulse((0, 20))
    run(world, 0.2)
    assert len(ended) == 1


def test_the_normal_points_from_the_older_body_to_the_younger(world):
    box = world.add(evil.Rectangle(1, 1), at=(0, 0.5))
    floor = ground(world)
    run(world, 0.5)
    (contact,) = world.contacts.active
    assert (contact.a, contact.b) == (box, floor)
    assert contact.normal == pytest.approx((0, -1), abs=1e-5)


def test_a_body_that_is_destroyed_separates_from_what_it_touched(world):
    floor = ground(world)
    ball = world.add(evil.Circle(0.5), at=(0, 0.5))
    run(world, 1)
    others = []
    floor.on_separate(lambda contact: others.append(contact.other(floor)))
    ball.destroy()
    world.step()
    assert others == [ball]
    assert not others[0].alive


def test_destroying_either_body_inside_a_collision_callback_is_safe(world):
    ground(world)
    balls = [world.add(evil.Circle(0.3), at=(x, 1 + x / 10)) for x in range(-5, 6)]
    for ball in balls:
        ball.on_collide(lambda contact: [b.destroy() for b in (contact.a, contact.b) if b.kind == "dynamic"])
    run(world, 2)
    assert len(world.bodies) == 1


def test_a_stale_reference_says_what_it_was(world):
    ball = world.add(evil.Circle(0.5), tag="crate")
    run(world, 0.5)
    ball.destroy()
    with pytest.raises(
        evil.StaleReferenceError, match=r'this Body \(tag "crate", added at step 0\) was destroyed at step 30'
    ):
        ball.position  # noqa: B018
    with pytest.raises(evil.StaleReferenceError):
        ball.destroy()
    assert not ball.alive


def test_a_stale_reference_never_becomes_another_body_also_after_a_restore(world):
    before = world.snapshot()
    first = world.add(evil.Circle(0.5))
    world.restore(before)
    assert not first.alive
    second = world.add(evil.Circle(0.5))
    assert second.slot == first.slot
    assert second != first
    with pytest.raises(evil.StaleReferenceError, match="restored"):
        first.position  # noqa: B018


def test_a_reference_that_was_never_destroyed_survives_a_restore(world):
    ball = world.add(evil.Circle(0.5), at=(0, 3))
    data = world.snapshot()
    run(world, 1)
    world.restore(data)
    assert ball.position == (0, 3)
    assert ball == next(iter(world.bodies))


def test_handles_are_hashable_and_compare_by_what_they_refer_to(world):
    a, b = world.add(evil.Circle(1)), world.add(evil.Circle(1))
    assert len({a, b, *world.bodies}) == 2
    assert a != b
    assert a != a.shapes[0]


def test_the_wrong_kind_of_handle_is_a_type_error_that_says_what_was_expected(world):
    ball = world.add(evil.Circle(1))
    with pytest.raises(evil.ArgumentTypeError, match="must be a Body"):
        world.add_force(evil.Gravity((0, 1)), ball.shapes)
    with pytest.raises(TypeError, match="must be a shape such as"):
        world.add(ball)


def test_rays_hit_the_nearest_shape_and_ignore_the_one_they_start_in(world):
    near = world.add(evil.Circle(1), at=(5, 0), kind="static")
    world.add(evil.Rectangle(1, 4), at=(9, 0), kind="static")
    hit = world.ray_cast((0, 0), (20, 0))
    assert hit.body is near
    assert hit.point == pytest.approx((4, 0))
    assert hit.fraction == pytest.approx(0.2)
    assert world.ray_cast((5, 0), (7, 0)) is None
    assert world.ray_cast((0, 3), (20, 3)) is None


def test_points_and_areas_find_their_bodies(world):
    box = world.add(evil.Rectangle(2, 2), at=(3, 0), angle=math.pi / 4)
    assert world.bodies_at((4.3, 0)) == (box,)
    assert world.bodies_at((3.9, 0.9)) == ()
    assert world.overlapping(evil.Circle(0.2), at=(4.5, 0)) == (box,)
    assert world.overlapping(evil.Circle(0.2), at=(4.7, 0)) == ()
    assert world.overlapping(evil.Rectangle(8, 0.1)) == (box,)


def test_arrays_are_views_that_follow_the_world_and_outlive_growth(world):
    numpy = pytest.importorskip("numpy")
    ball = world.add(evil.Circle(1), at=(1, 2))
    positions = numpy.asarray(world.bodies.positions)
    assert positions.dtype == numpy.float32
    assert positions[ball.slot].tolist() == [1, 2]
    world.step()
    assert positions[ball.slot, 1] < 2
    for _ in range(200):
        world.add(evil.Circle(0.1))
    assert positions[ball.slot, 0] == 1
    assert world.bodies.positions[ball.slot] == ball.position
    assert numpy.asarray(world.bodies.matrices).shape == (201, 16)
    with pytest.raises(ValueError, match="read-only"):
        positions[0] = 0


BAD = [
    (lambda w: w.add(evil.Circle(-1)), "radius=-1"),
    (lambda w: w.add(evil.Circle(math.nan)), "radius=nan"),
    (lambda w: w.add(evil.Rectangle(1, math.inf)), "height=inf"),
    (lambda w: w.add(evil.Polygon([(0, 0), (1, 0)])), "corners"),
    (lambda w: w.add(evil.Polygon([(0, 0), (1, 0), (2, 0)])), "Polygon"),
    (lambda w: w.add(evil.Polygon([(0, 0), (1, 1), (1, 0), (0, 1)])), "cross"),
    (lambda w: w.add(evil.Circle(1), at=(math.nan, 0)), "at="),
    (lambda w: w.add(evil.Circle(1), at=3), "at=3"),
    (lambda w: w.add(evil.Circle(1), kind="dinamic"), "did you mean 'dynamic'"),
    (lambda w: w.add(evil.Circle(1), restituton=1), "did you mean 'restitution'"),
    (lambda w: w.add(evil.Circle(1), restitution=1.5), "restitution=1.5"),
    (lambda w: w.add(evil.Circle(1), damping=-0.1), "damping"),
    (lambda w: w.add(evil.Circle(1), density=0), "density="),
    (lambda w: w.add(evil.Circle(1), mass=-3), "mass=-3"),
    (lambda w: w.add(evil.Circle(1), velocity=(1e9, 0)), "velocity"),
    (lambda w: w.add([]), "shape"),
    (lambda w: w.add(evil.Circle), "make one"),
    (lambda w: w.step(0), "dt=0"),
    (lambda w: w.step(-1), "dt=-1"),
    (lambda w: w.step(math.nan), "dt=nan"),
    (lambda w: w.step(1 / 60, substeps=0), "substeps=0"),
    (lambda w: w.restore(b""), "no snapshot"),
    (lambda w: w.restore(b"hello"), "no snapshot"),
    (lambda w: w.restore(w.snapshot()[:-1]), "cut short|damaged"),
    (lambda w: evil.Spring(to=(0, 0), stiffness=-1), "stiffness=-1"),
    (lambda w: evil.Medium((0, 0, -1, 1)), "left < right"),
    (lambda w: w.ray_cast((0, 0), (math.nan, 0)), "end="),
    (lambda w: setattr(w, "gravity", (0, math.inf)), "gravity="),
]


@pytest.mark.parametrize(("wrong", "words"), BAD, ids=[words for _, words in BAD])
def test_bad_input_is_refused_clearly_and_leaves_the_world_as_it_was(world, wrong, words):
    ground(world)
    world.add(evil.Circle(1), at=(0, 3))
    run(world, 0.2)
    before = world.snapshot()
    with pytest.raises(evil.Error, match=words):
        wrong(world)
    assert world.snapshot() == before


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("scale", [0.01, 1, 1000])
def test_every_overlap_is_found_among_sizes_from_grains_to_hills(seed, scale):
    rng = random.Random(seed)
    world = evil.World(gravity=(0, 0))
    bodies = []
    for _ in range(120):
        radius = scale * 10 ** rng.uniform(-1, 1.5)
        at = (scale * rng.uniform(-60, 60), scale * rng.uniform(-60, 60))
        bodies.append((world.add(evil.Circle(radius), at=at), radius))
    expected = {
        (a, b)
        for i, (a, radius) in enumerate(bodies)
        for b, other in bodies[i + 1 :]
        if (b.position - a.position).length < (radius + other) * 0.9999
    }
    world.step(1e-6, substeps=1)
    found = {(contact.a, contact.b) for contact in world.contacts.active}
    assert expected <= found
    assert len(expected) > 50
    for a, b in found - expected:
        assert (b.position - a.position).length < a.shapes[0].definition.radius + b.shapes[0].definition.radius + 0.01
