# SPDX-License-Identifier: Apache-2.0
"""Many environments at once: they show what each shows alone."""

import numpy as np
import pytest

import fairway
from fairway.gym import FleetEnv, FleetVectorEnv

from episodes import CROSSING, SWAP, actions_of, same


@pytest.mark.parametrize("learner", [None, "north_bound"])
def test_many_environments_show_what_each_shows_alone_on_any_number_of_threads(learner):
    short = dict(learner=learner, overrides={"duration_s": 3.0})
    vectors = [FleetVectorEnv(CROSSING, 5, threads=threads, **short) for threads in (1, 2, 7)]
    alone = [FleetEnv(CROSSING, **short) for _ in range(5)]
    first = [env.reset(seed=11) for env in vectors]
    for shown in first[1:]:
        same(shown, first[0])
    for i, env in enumerate(alone):
        observation, info = env.reset(seed=11 + i)
        same(observation, first[0][0][i])
        assert info["seed"] == first[0][1]["seed"][i] == 11 + i
    over, ends = [False] * 5, 0
    for actions in actions_of(0, vectors[0].action_space.shape, 150):
        shown = [env.step(actions) for env in vectors]
        for other in shown[1:]:
            same(other, shown[0])
        for i, env in enumerate(alone):
            if over[i]:  # the step after the end begins anew, whatever was asked
                observation, info = env.reset()
                result = (observation, 0.0, False, False, info)
            else:
                result = env.step(actions[i])
            for one, many in zip(result[:4], shown[0][:4]):
                same(np.asarray(one), np.asarray(many[i]))
            over[i] = result[2] or result[3]
            ends += over[i]
            if over[i]:
                assert shown[0][4]["_measures"][i]
                same(result[4]["measures"]["energy_j"], shown[0][4]["measures"]["energy_j"][i])
    assert ends >= 10


def test_a_vector_has_batched_spaces_and_resets_by_mask():
    env = FleetVectorEnv(CROSSING, 3, "north_bound")
    observations, infos = env.reset(seed=[4, 9, 4])
    assert env.observation_space.contains(observations) and env.action_space.contains(env.action_space.sample())
    assert env.single_observation_space.contains(observations[0]) and observations.shape == (3, 21)
    same(observations[0], observations[2])
    for _ in range(5):
        observations, rewards, terminated, truncated, infos = env.step(env.action_space.sample())
    assert rewards.shape == terminated.shape == truncated.shape == (3,)
    assert rewards.dtype == np.float64 and terminated.dtype == truncated.dtype == bool
    again, infos = env.reset(seed=[4, 9, 4], options={"reset_mask": np.array([True, False, False])})
    assert infos["time_s"].tolist() == [0.0, 0.25, 0.25]
    assert not np.array_equal(again[0], observations[0]) and np.array_equal(again[1:], observations[1:])
    with pytest.raises(fairway.InputError, match="one seed for each of 3"):
        env.reset(seed=[1, 2])
    assert FleetVectorEnv(CROSSING, 2).reset()[0].shape == (2, 2, 21)
    env.close()


def test_an_action_that_makes_no_sense_steps_no_environment():
    told, other = (FleetVectorEnv(CROSSING, 3, "north_bound", threads=1) for _ in range(2))
    told.reset(seed=1), other.reset(seed=1)
    actions = np.zeros((3, 3))
    wrong = actions.copy()
    wrong[1, 0] = np.nan
    with pytest.raises(ValueError, match="NaN"):
        told.step(wrong)
    same(told.step(actions), other.step(actions))


def test_the_action_that_begins_an_episode_may_be_anything():
    env = FleetVectorEnv(CROSSING, 2, "north_bound", overrides={"duration_s": 0.1})
    env.reset(seed=1)
    while not env.step(np.zeros((2, 3)))[3].all():
        pass
    assert env.step(np.full((2, 3), np.nan))[4]["time_s"].tolist() == [0.0, 0.0]


def test_copies_may_be_kept_and_views_are_overwritten():
    kept = FleetVectorEnv(CROSSING, 2)
    view = FleetVectorEnv(CROSSING, 2, copy=False)
    first_kept, first_view = kept.reset(seed=1)[0], view.reset(seed=1)[0]
    for actions in actions_of(0, kept.action_space.shape, 3):
        last, last_view = kept.step(actions)[0], view.step(actions)[0]
    assert not np.array_equal(first_kept, last)
    assert np.shares_memory(first_view, last_view) and np.array_equal(first_view, last)


@pytest.mark.parametrize("seed", [1.5, -1, 2**64, True, "1", 2**64 - 1, [1, -1, 2], [1, 2.0, 3]])
def test_a_seed_that_is_none_is_refused(seed):
    env = FleetVectorEnv(CROSSING, 3)
    with pytest.raises(fairway.InputError, match=r"seed: expected a whole number in \[0, 18446744073709551615\]"):
        env.reset(seed=seed)


def test_with_the_commands_of_their_own_avoiders_many_are_the_ordinary_runs_to_the_bit():
    runs = [fairway.run(fairway.Scenario.load(SWAP, seed=seed)) for seed in (3, 4)]
    env = FleetVectorEnv(SWAP, 2, end_on_collision=False)
    env.reset(seed=3)
    over = np.zeros(2, bool)
    while not over.all():
        _, _, terminated, truncated, infos = env.step_commands(env.advised_commands())
        for i in np.flatnonzero((terminated | truncated) & ~over):
            assert infos["measures"]["energy_j"][i].tolist() == [vehicle["energy_j"] for vehicle in runs[i].vehicles]
        over |= terminated | truncated
