# SPDX-License-Identifier: Apache-2.0
"""Avoiders: one decision, many at once, snapshots, and what there is to say of each algorithm."""

import copy
import json
import subprocess

import numpy as np
import pytest

import fairway as fw


def head_on(time=0.0):
    return fw.Situation(
        time=time,
        period=0.1,
        own=fw.Ownship(id=0, position=[0, 0, 5], velocity=[0.5, 0, 0]),
        goal=fw.Goal(position=[50, 0, 5], cruise_speed=0.5),
        limits=fw.Limits(max_speed=0.5),
        tracks=[fw.Track(id=1, position=[10, 0.5, 5], velocity=[-0.5, 0, 0])],
    )


def test_every_algorithm_decides_and_says_what_it_is():
    for info in fw.algorithms():
        assert info.name and info.title and info.source
        command = fw.Avoider(info.name).decide(head_on())
        assert np.linalg.norm(command.velocity) <= 0.5 + 1e-12, info.name
        for parameter in info.parameters:
            assert parameter.meaning, f"{info.name}.{parameter.name}"
    assert {"orca3d", "apf", "stop_and_wait", "rrt_star"} <= {info.name for info in fw.algorithms()}


def test_the_decision_is_that_of_the_command_to_the_bit(fairway_command):
    line = {
        "time": 0, "period": 0.1,
        "own": {"id": 0, "position": [0, 0, 5], "velocity": [0.5, 0, 0], "yaw": 0, "radius": 1},
        "goal": {"position": [50, 0, 5]}, "limits": {"max_speed": 0.5},
        "tracks": [{"id": 1, "position": [10, 0.5, 5], "velocity": [-0.5, 0, 0], "radius": 1}],
    }  # fmt: skip
    answered = subprocess.run(
        [fairway_command, "decide", "--algorithm", "orca3d", "--set", "time_horizon_s=10"],
        input=json.dumps(line) + "\n", capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    expected = json.loads(answered.splitlines()[0])
    command = fw.Avoider("orca3d", time_horizon_s=10).decide(head_on())
    assert command.velocity.tolist() == expected["velocity"]
    assert command.mode.name == expected["mode"]


def test_what_the_vehicle_can_do_is_shown_to_a_method_that_has_to_turn_it():
    situation = fw.Situation(
        period=0.1,
        own=fw.Ownship(id=0, position=[0, 0, 0], velocity=[1, 0, 0], radius=1),
        goal=fw.Goal(position=[50, 0, 0], cruise_speed=1),
        limits=fw.Limits(max_speed=1, sway=False),
        tracks=[fw.Track(id=1, position=[12, 0.5, 0], velocity=[-1, 0, 0], radius=1)],
    )
    avoider = fw.Avoider("direct+trackable")
    blind = avoider.decide(situation)
    assert "no envelope is given" in blind.note
    can = fw.Envelope(
        ahead=1.5, acceleration=0.5, deceleration=0.5, surge_lag=1, turn_acceleration=0.5, turn_lag=0.5,
        turn_rates=[0.3, 0.3, 0.3, 0.3],
    )
    assert can.turn_rates == (0.3, 0.3, 0.3, 0.3) and can.replace() == can
    told = avoider.decide(situation.replace(envelope=can))
    assert told.mode == fw.Mode.avoid and abs(told.turn_rate) > 0.05
    with pytest.raises(fw.InputError, match="turn_rates: expected 4 of them"):
        can.replace(turn_rates=[0.3])
    with pytest.raises(fw.InputError, match="deceleration"):
        can.replace(deceleration=0)


def test_a_copy_is_a_snapshot():
    avoider = fw.Avoider("avoa", seed=5)
    snapshot = copy.copy(avoider)
    first = [avoider.decide(head_on(0.1 * i)) for i in range(20)]
    again = [snapshot.decide(head_on(0.1 * i)) for i in range(20)]
    assert first == again
    assert copy.deepcopy(snapshot).name == "avoa"


def test_a_wrapper_takes_the_parameters_of_both():
    info = fw.algorithm("apf+stop_and_wait")
    names = [parameter.name for parameter in info.parameters]
    assert "crit_dist_m" in names and len(names) == len(set(names))
    fw.Avoider("apf+stop_and_wait", crit_dist_m=8)


def test_nonsense_is_answered_with_a_standstill():
    command = fw.Avoider("orca3d").decide(head_on().replace(period=0))
    assert command.mode == fw.Mode.infeasible and command.velocity.tolist() == [0, 0, 0]
    assert command.note == "the period is not a positive number"


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: fw.Avoider("orca3"), "did you mean orca3d?"),
        (lambda: fw.Avoider("orca3d", time_horizon=3), "time_horizon: unknown parameter of orca3d; did you mean time_horizon_s?"),
        (lambda: fw.Avoider("orca3d", time_horizon_s="long"), 'time_horizon_s: is "long"; expected'),
        (lambda: fw.Avoider("orca3d", seed=-1), "seed: expected a whole number that fits, got -1"),
        (lambda: fw.algorithm("orca3d+orca2d"), "wraps nothing"),
    ],
)
def test_a_mistake_names_the_nearest(make, message):
    with pytest.raises(fw.InputError) as raised:
        make()
    assert message in str(raised.value)


def random_batch(count, neighbours, seed=1):
    rng = np.random.default_rng(seed)
    return dict(
        position=rng.uniform(-10, 10, (count, 3)),
        velocity=rng.uniform(-0.5, 0.5, (count, 3)),
        goal=rng.uniform(-50, 50, (count, 3)),
        yaw=rng.uniform(-3, 3, count),
        radius=rng.uniform(0.5, 1, count),
        track_position=rng.uniform(-20, 20, (count, neighbours, 3)),
        track_velocity=rng.uniform(-0.5, 0.5, (count, neighbours, 3)),
        track_radius=rng.uniform(0.5, 1, (count, neighbours)),
        limits=fw.Limits(max_speed=0.5),
        period=0.1,
    )


def test_a_batch_decides_as_one_by_one_on_any_number_of_threads():
    batch = random_batch(600, 7)
    batch["track_position"][::3, 5:] = np.nan  # those see five
    obstacles = [fw.Obstacle.sphere([5, 5, 0], 1), fw.Obstacle.prism([(0, 0), (2, 0), (2, 2)])]
    avoider = fw.Avoider("orca2d")
    alone = avoider.decide_batch(jobs=1, obstacles=obstacles, **batch)
    shared = avoider.decide_batch(jobs=3, obstacles=obstacles, **batch)
    assert np.array_equal(alone.velocity, shared.velocity) and np.array_equal(alone.mode, shared.mode)
    assert len(alone) == 600
    for i in range(0, 600, 37):
        tracks = [
            fw.Track(id=k + 1, position=p, velocity=batch["track_velocity"][i, k], radius=batch["track_radius"][i, k])
            for k, p in enumerate(batch["track_position"][i])
            if not np.isnan(p[0])
        ]
        own = fw.Ownship(
            position=batch["position"][i], velocity=batch["velocity"][i], yaw=batch["yaw"][i], radius=batch["radius"][i]
        )
        one = fw.Avoider("orca2d").decide(
            fw.Situation(
                own=own, goal=fw.Goal(batch["goal"][i], 0.5), period=0.1, limits=batch["limits"],
                tracks=tracks, obstacles=obstacles,
            )  # fmt: skip
        )
        assert one.velocity.tolist() == alone.velocity[i].tolist(), i
        assert int(one.mode) == alone.mode[i]


@pytest.mark.parametrize("name", ["avoa_improved", "vo", "teb", "orca2d"])
def test_a_batch_has_the_headings_and_turn_rates_of_one_by_one_and_nan_where_there_is_none(name):
    goals = np.array([[-30.0, 1, 0], [30, 0, 0], [0, 30, 0]])
    shared = dict(period=0.2, limits=fw.Limits(max_speed=0.5, max_turn_rate=0.1))
    batch = fw.Avoider(name).decide_batch(
        position=np.zeros((3, 3)), velocity=np.zeros((3, 3)), goal=goals, track_position=np.full((3, 1, 3), [-6, 0, 0]), **shared
    )
    for i, goal in enumerate(goals):
        one = fw.Avoider(name).decide(
            fw.Situation(
                own=fw.Ownship(position=[0, 0, 0]), goal=fw.Goal(goal, 0.5), tracks=[fw.Track(id=1, position=[-6, 0, 0])],
                **shared,
            )  # fmt: skip
        )
        for said, column in ((one.heading, batch.heading), (one.turn_rate, batch.turn_rate)):
            assert column.shape == (3,)
            assert np.isnan(column[i]) if said is None else column[i] == said, i
    says = [not np.isnan(column).all() for column in (batch.heading, batch.turn_rate)]
    assert says == {"vo": [True, False], "orca2d": [False, False]}.get(name, [False, True])


def test_a_number_stands_for_every_row_of_numbers():
    batch = random_batch(20, 4)
    one = fw.Avoider("orca3d").decide_batch(**{**batch, "yaw": 0.5, "radius": 2, "track_radius": 1.5})
    rows = fw.Avoider("orca3d").decide_batch(
        **{**batch, "yaw": np.full(20, 0.5), "radius": np.full(20, 2), "track_radius": np.full((20, 4), 1.5)}
    )
    assert np.array_equal(one.velocity, rows.velocity)


def test_more_jobs_than_the_machine_has_threads_end_well():
    batch = random_batch(600, 2)
    many = fw.Avoider("orca3d").decide_batch(jobs=2**31 - 1, **batch)
    assert np.array_equal(many.velocity, fw.Avoider("orca3d").decide_batch(**batch).velocity)


def test_a_batch_leaves_the_avoider_as_it_was():
    avoider, other = fw.Avoider("avoa", seed=3), fw.Avoider("avoa", seed=3)
    avoider.decide_batch(**random_batch(10, 3))
    assert avoider.decide(head_on()) == other.decide(head_on())


@pytest.mark.parametrize(
    "changes, message",
    [
        ({"goal": [[1, 2, 3]]}, "goal: expected 4 x 3 numbers"),
        ({"position": [1, 2, 3]}, "position: expected rows of 3 numbers"),
        ({"goal": 3.0}, "goal: expected 4 x 3 numbers, got 3.0"),
        ({"velocity": 0}, "velocity: expected 4 x 3 numbers, got 0"),
        ({"track_velocity": 1.0}, "track_velocity: expected 4 x 3 x 3 numbers, got 1.0"),
        ({"track_radius": np.ones((4, 2))}, "track_radius: expected 4 x 3 numbers"),
        ({"track_positions": 1}, "there is no argument track_positions; did you mean track_position?"),
        ({"jobs": -1}, "jobs: expected 0 (all cores) or more, got -1"),
        ({"limits": fw.Limits()}, "cruise_speed is missing, and limits give no max_speed instead"),
    ],
)
def test_a_batch_says_which_array_does_not_fit(changes, message):
    with pytest.raises(fw.InputError) as raised:
        fw.Avoider("orca3d").decide_batch(**{**random_batch(4, 3), **changes})
    assert message in str(raised.value)
