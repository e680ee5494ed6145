# SPDX-License-Identifier: Apache-2.0
"""Environments: what Gymnasium's checker would look at, and that they are the run which the command makes."""

import math

import numpy as np
import pytest

import fairway
from fairway import _core
from fairway.gym import HAS_GYMNASIUM, FleetEnv, FleetVectorEnv

from conftest import ROOT
from episodes import CROSSING, CUBE, OBSTACLES, SWAP, follow, same, straight


# ---- what gymnasium.utils.env_checker looks at

@pytest.mark.parametrize("file, learner", [(CROSSING, "north_bound"), (CROSSING, None), (SWAP, None),
                                           (OBSTACLES, None), (CUBE, ["robot2", "robot0"])])
def test_spaces_contain_what_is_shown_and_the_types_are_gymnasiums(file, learner):
    env = FleetEnv(file, learner=learner)
    env.action_space.seed(3)
    observation, info = env.reset(seed=1)
    assert env.observation_space.contains(observation) and isinstance(info, dict)
    for _ in range(50):
        action = env.action_space.sample()
        assert env.action_space.contains(action)
        observation, reward, terminated, truncated, info = env.step(action)
        assert env.observation_space.contains(observation) and observation.dtype == np.float32
        assert type(reward) is float and type(terminated) is bool and type(truncated) is bool
        assert isinstance(info, dict) and all(isinstance(key, str) for key in info)
    assert env.observation_space.shape == ((len(env.observation_names),) if isinstance(learner, str)
                                           else (len(env.learners), len(env.observation_names)))
    env.close()


def test_what_is_returned_belongs_to_the_caller():
    env = FleetEnv(CROSSING)
    first, info = env.reset(seed=1)
    kept, kept_info = first.copy(), {key: np.copy(value) for key, value in info.items()}
    for _ in range(3):
        env.step(straight(env))
    same(first, kept)
    same({key: np.asarray(value) for key, value in info.items()}, kept_info)


def test_reset_by_seed_gives_the_same_episode_and_other_seeds_others():
    env = FleetEnv(CUBE)
    one, again, other = env.reset(seed=5), env.reset(seed=5), env.reset(seed=6)
    same(one, again)
    assert one[1]["seed"] == 5 and not np.array_equal(one[0], other[0])
    second = env.reset()
    assert second[1]["seed"] not in (5, 6)
    env.reset(seed=6)
    same(env.reset(), second)
    assert env.np_random is not None


def test_without_any_seed_the_first_episode_is_the_scenarios_own():
    same(FleetEnv(CUBE).reset(), FleetEnv(CUBE).reset(seed=fairway.Scenario.load(CUBE).seed))


def test_the_end_of_an_episode_is_either_terminated_or_truncated_and_then_reset_is_needed():
    env = FleetEnv(CROSSING, overrides={"duration_s": 2})
    with pytest.raises(RuntimeError, match="reset"):
        env.step(np.zeros((2, 3)))
    shown = follow(env, straight)
    assert shown[-1][2:4] == (False, True) and "measures" in shown[-1][4]
    assert shown[-1][4]["time_s"] == pytest.approx(2.0)
    with pytest.raises(RuntimeError, match="reset"):
        env.step(np.zeros((2, 3)))
    env.reset()
    env.step(np.zeros((2, 3)))


def test_arrival_terminates():
    shown = follow(FleetEnv(CROSSING, learner="north_bound", reward={"nearness": 0}), straight)
    _, reward, terminated, truncated, info = shown[-1]
    assert terminated and not truncated and info["arrived"] and not info["collided"]
    assert reward > 9.0
    assert sum(step[1] for step in shown[1:]) == pytest.approx(10.0 + 59.0, abs=3.0)


def test_a_collision_terminates_unless_told_otherwise():
    shown = follow(FleetEnv(CROSSING), straight)
    _, reward, terminated, truncated, info = shown[-1]
    assert terminated and not truncated and info["collided"].all() and reward < -90.0
    assert (info["separation_m"] <= 3.0).all()
    env = FleetEnv(CROSSING, end_on_collision=False)
    shown = follow(env, straight)
    assert shown[-1][2] and shown[-1][4]["arrived"].all() and shown[-1][4]["collided"].all()
    assert env.measures()["pair_collision_count"] == 1


def test_who_never_arrives_is_truncated_when_stuck():
    env = FleetEnv(CROSSING, learner="north_bound", overrides={"exam.time_coefficient_ratio": 0.1})
    shown = follow(env, lambda env: np.zeros(3))
    assert shown[-1][3] and shown[-1][4]["stuck"] and shown[-1][4]["time_s"] < 20.0


# ---- what is seen and asked

def test_an_observation_is_what_its_names_say():
    env = FleetEnv(CROSSING)
    observation, _ = env.reset(seed=1)
    for _ in range(200):
        observation, *_ = env.step(straight(env))
    names = {name: i for i, name in enumerate(env.observation_names)}
    for row in range(2):
        situation = env.situation(row)
        own, track = situation.own, situation.tracks[0]
        seen = dict(zip(env.observation_names, observation[row]))
        assert len(seen) == len(names) == 12 + 9
        expected = {"velocity_north_mps": own.velocity[0], "velocity_east_mps": own.velocity[1],
                    "sin_yaw_ratio": np.sin(own.yaw), "cos_yaw_ratio": np.cos(own.yaw),
                    "yaw_rate_radps": own.yaw_rate, "goal_north_m": situation.goal.position[0] - own.position[0],
                    "cruise_speed_mps": situation.goal.cruise_speed, "depth_m": own.position[2],
                    "radius_m": own.radius, "track0_present_ratio": 1.0,
                    "track0_position_east_m": track.position[1] - own.position[1],
                    "track0_velocity_north_mps": track.velocity[0], "track0_radius_m": track.radius,
                    "track0_age_s": track.age}
        for name, value in expected.items():
            assert seen[name] == np.float32(value), name


def test_the_nearest_obstacles_are_seen_nearest_first():
    env = FleetEnv(OBSTACLES, obstacles=2)
    observation, _ = env.reset(seed=1)
    situation = env.situation(0)
    nearest = sorted((obstacle.nearest_point(situation.own.position) for obstacle in situation.obstacles),
                     key=lambda found: found[1])[:2]
    assert len(situation.obstacles) > 2
    for seen, (point, _) in zip(observation[0, -8:].reshape(2, 4), nearest):
        assert seen == pytest.approx([1.0, *(point - situation.own.position)], rel=1e-6)


def test_places_without_a_neighbour_are_zero():
    observation, _ = FleetEnv(CROSSING, tracks=3, obstacles=1).reset(seed=1)
    assert observation.shape == (2, 12 + 27 + 4)
    assert observation[0, 12] == 1.0 and not observation[:, 21:].any()


def test_headings_axes_turn_what_is_seen_and_what_is_asked():
    ned, turned = FleetEnv(CROSSING), FleetEnv(CROSSING, axes="heading")
    seen, seen_turned = ned.reset(seed=1)[0], turned.reset(seed=1)[0]
    assert turned.observation_names[:2] == ["velocity_ahead_mps", "velocity_starboard_mps"]
    assert seen[1, 6:8] == pytest.approx([0.0, 60.0], abs=1e-4)
    assert seen_turned[1, 6:8] == pytest.approx([60.0, 0.0], abs=1e-4)
    for _ in range(100):
        seen, *_ = ned.step([[1, 0, 0], [0, 1, 0]])
        sin, cos = seen_turned[:, 3], seen_turned[:, 4]
        asked = np.array([[1, 0], [0, 1]])
        ahead = np.stack([cos * asked[:, 0] + sin * asked[:, 1], cos * asked[:, 1] - sin * asked[:, 0], 0 * sin], 1)
        seen_turned, *_ = turned.step(ahead)
    assert seen_turned[:, 10] == pytest.approx(seen[:, 10], abs=1e-3)
    assert np.linalg.norm(seen_turned[:, 6:9] - 0, axis=1) == pytest.approx(np.linalg.norm(seen[:, 6:9], axis=1), abs=1e-3)


def test_actions_are_parts_of_the_greatest_speed_clipped_and_held_to_the_limits():
    env = FleetEnv(CROSSING, learner="north_bound")
    env.reset(seed=1)
    for _ in range(400):
        observation, *_ = env.step([9.0, 0.0, 0.0])
    assert observation[0] == pytest.approx(0.5, abs=0.01)
    for _ in range(400):
        observation, *_ = env.step([0.5, 0.0, 0.0])
    assert observation[0] == pytest.approx(0.25, abs=0.01)
    metres = FleetEnv(CROSSING, learner="north_bound", actions="mps")
    assert metres.action_space.high == pytest.approx([0.5, 0.5, 0.5])


@pytest.mark.parametrize("action, words", [([np.nan, 0, 0], "NaN"), ([np.inf, 0, 0], "infinity"), ([0, 0], "shape"),
                                           ([[0, 0, 0]], "shape")])
def test_an_action_that_makes_no_sense_is_a_value_error(action, words):
    env = FleetEnv(CROSSING, learner="north_bound")
    env.reset(seed=1)
    with pytest.raises(ValueError, match=words):
        env.step(action)
    env.step([0, 0, 0])


@pytest.mark.parametrize("options, words", [
    ({"learner": "north_bond"}, "did you mean north_bound?"), ({"learner": ["north_bound"] * 2}, "named twice"),
    ({"reward": {"progres": 1}}, "did you mean progress?"), ({"reward": {"time": "dear"}}, "expected a number"),
    ({"reward": {"progress": math.nan}}, "reward.progress: expected a number that is finite, got nan"),
    ({"axes": "enu"}, "axes"), ({"actions": "knots"}, "actions"), ({"tracks": -2}, "tracks"),
    ({"obstacles": 17}, "at most 16"), ({"action_repeat": 0}, "at least 1"), ({"render_mode": "human"}, "rgb_array"),
    ({"overrides": {"duration": 3}}, "did you mean duration_s?")])
def test_what_cannot_be_is_refused_in_one_line_with_what_can(options, words):
    with pytest.raises(fairway.InputError) as refused:
        FleetEnv(CROSSING, **options)
    assert words in str(refused.value) and "\n" not in str(refused.value)


def test_a_command_that_is_not_finite_is_refused_as_an_action_is():
    environments = _core.FleetEnvironments(CROSSING, reward={"progress": np.float32(2)})
    environments.reset()
    commands = environments.advised_commands()
    for wrong in ({"velocity": [math.nan, 0, 0]}, {"heading": math.inf}):
        with pytest.raises(ValueError, match="command 0 holds NaN or an infinity"):
            environments.step_commands([commands[0].replace(**wrong), *commands[1:]])
    environments.step_commands(commands)


def test_rewards_are_what_their_weights_say():
    off = dict(progress=0, arrival=0, collision=0, nearness=0, time=0)
    expected = {"progress": (59.0, 0.2), "arrival": (1.0, 0.0), "time": (0.0, 0.0)}
    for name, (value, margin) in expected.items():
        env = FleetEnv(CROSSING, learner="north_bound", reward={**off, name: 1.0})
        shown = follow(env, straight)
        total = sum(step[1] for step in shown[1:])
        if name == "time":
            value = shown[-1][4]["time_s"]
        assert total == pytest.approx(value, abs=margin + 1e-6), name
    env = FleetEnv(CROSSING, reward={**off, "collision": -7.0})
    assert sum(step[1] for step in follow(env, straight)[1:]) == -14.0
    env = FleetEnv(CROSSING, reward={**off, "nearness": -1.0, "near_m": 10.0}, end_on_collision=False)
    shown = follow(env, straight)
    near = [step[4] for step in shown[1:] if step[4]["separation_m"].min() < 10.0]
    by_hand = -2 * 0.05 * sum(min(1.0, max(0.0, 1 - (info["separation_m"][0] - 3) / 7)) for info in near)
    assert sum(step[1] for step in shown[1:]) == pytest.approx(by_hand, rel=0.05) and by_hand < -10.0


# ---- the run that the command makes

@pytest.mark.parametrize("file", ["crossing", "swap_8", "cube20_4", "cube20_4_apf_saw", "static_obstacles",
                                  "acoustic_pair", "transport_pair", "random_crossing"])
def test_with_the_commands_of_their_own_avoiders_it_is_the_ordinary_run_to_the_bit(file):
    scenario = fairway.Scenario.load(ROOT / "scenarios" / f"{file}.yaml", seed=3)
    run = fairway.run(scenario)
    env = FleetEnv(scenario, end_on_collision=False)
    env.reset(seed=3)
    over = False
    while not over:
        _, _, terminated, truncated, info = env.step_commands(env.advised_commands())
        over = terminated or truncated
    for quantity, value in run.fleet.items():
        assert info["measures"][quantity] == value, quantity
    for index, vehicle in enumerate(run.vehicles):
        for quantity, value in vehicle.items():
            if quantity != "name":
                assert info["measures"][quantity][index] == value, (index, quantity)


def test_an_avoider_made_in_python_and_shown_the_situations_makes_the_ordinary_run_too():
    run = fairway.run(CROSSING)
    env = FleetEnv(CROSSING)
    env.reset(seed=1)
    avoiders = [fairway.Avoider("orca3d", time_horizon_s=20) for _ in env.learners]
    over = False
    while not over:
        commands = [avoider.decide(env.situation(i)) if env.situation(i) else fairway.Command(mode="hold")
                    for i, avoider in enumerate(avoiders)]
        _, _, terminated, truncated, info = env.step_commands(commands)
        over = terminated or truncated
    assert info["measures"]["min_separation_m"] == run.fleet["min_separation_m"]
    assert list(info["measures"]["energy_j"]) == [vehicle["energy_j"] for vehicle in run.vehicles]


def test_advice_as_actions_avoids_too():
    env = FleetEnv(CROSSING, learner="north_bound")
    shown = follow(env, lambda env: env.advice())
    assert shown[-1][2] and shown[-1][4]["arrived"] and env.measures()["pair_collision_count"] == 0
    metres = FleetEnv(CROSSING, actions="mps")
    same(follow(metres, lambda env: env.advice())[-1][4]["measures"]["energy_j"],
         np.array([vehicle["energy_j"] for vehicle in fairway.run(CROSSING).vehicles]))


def test_others_may_have_algorithms_of_python_whose_exceptions_surface():
    class Mine:
        def decide(self, situation):
            if situation.time > 3.0:
                raise LookupError("lost")
            return situation.preferred_velocity

    scenario = fairway.Scenario.load(CROSSING).with_algorithm("mine")
    env = FleetEnv(scenario, learner="north_bound", algorithms={"mine": Mine})
    with pytest.raises(LookupError, match="lost"):
        follow(env, straight)
    with pytest.raises(RuntimeError, match="reset"):
        env.step(np.zeros(3))
    env.reset(seed=1)
    env.step(np.zeros(3))
    many = FleetVectorEnv(scenario, 3, "north_bound", algorithms={"mine": Mine}, threads=2)
    many.reset(seed=1)
    with pytest.raises(LookupError, match="lost"):
        for _ in range(100):
            many.step(np.zeros((3, 3)))
    many.reset(seed=1)
    many.step(np.zeros((3, 3)))


def test_a_picture_is_drawn_where_asked_for():
    env = FleetEnv(SWAP, render_mode="rgb_array")
    env.reset(seed=1)
    before = env.render()
    for _ in range(100):
        env.step(straight(env))
    after = env.render()
    assert before.dtype == np.uint8 and before.shape == after.shape and before.shape[2] == 3
    assert len(np.unique(before.reshape(-1, 3), axis=0)) >= 3 and not np.array_equal(before, after)
    assert FleetEnv(SWAP).render() is None


@pytest.mark.skipif(not HAS_GYMNASIUM, reason="gymnasium is not installed")
def test_gymnasiums_own_checker_finds_nothing():
    from gymnasium.utils.env_checker import check_env
    check_env(FleetEnv(CROSSING, learner="north_bound"), skip_render_check=True)
    check_env(FleetEnv(CROSSING), skip_render_check=True)


@pytest.mark.parametrize("seed", [1.5, -1, 2**64, True, "1"])
def test_a_seed_that_is_none_is_refused(seed):
    env = FleetEnv(CROSSING)
    with pytest.raises(fairway.InputError, match=r"seed: expected a whole number in \[0, 18446744073709551615\]"):
        env.reset(seed=seed)


def test_the_largest_seed_is_one():
    assert FleetEnv(CROSSING).reset(seed=np.uint64(2**64 - 1))[1]["seed"] == 2**64 - 1


def test_a_situation_has_the_envelope_where_its_own_avoider_is_shown_it():
    env = FleetEnv(ROOT / "scenarios" / "surface_head_on.yaml")
    env.reset(seed=1)
    assert env.situation().envelope.ahead == pytest.approx(1.5)
    env = FleetEnv(CROSSING)
    env.reset(seed=1)
    assert env.situation().envelope is None
