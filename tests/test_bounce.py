"""Bounces come as high as restitution says (SPEC C4)."""

import pytest

import evilengine as evil


@pytest.mark.parametrize("bounce", [0.3, 0.5, 0.8, 1.0])
@pytest.mark.parametrize("height", [1.0, 2.5, 5.03])
def test_a_ball_comes_back_to_the_height_that_restitution_says(bounce, height):
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    ball = world.add(evil.Circle(0.5), at=(0, 0.5 + height), restitution=bounce)
    while not world.contacts.begun:
        world.step()
    top = 0.0
    while ball.velocity.y > 0:
        top = max(top, ball.position.y - 0.5)
        world.step()
    assert top == pytest.approx(bounce**2 * height, rel=0.02)


def test_a_ball_that_loses_nothing_bounces_for_a_minute():
    world = evil.World()
    world.add(evil.Rectangle(40, 1), at=(0, -0.5), kind="static")
    ball = world.add(evil.Circle(0.5), at=(0, 3), restitution=1)
    tops, rising = [], False
    for _ in range(3600):
        world.step()
        if rising and ball.velocity.y <= 0:
            tops.append(ball.position.y)
        rising = ball.velocity.y > 0
    assert len(tops) > 30
    assert min(tops) > 2.7
    assert max(tops) < 3.1
