# SPDX-License-Identifier: Apache-2.0
"""Algorithms written in Python: in any scenario, as good as those that come with fairway, and as safe to get wrong."""

import sys
import traceback

import numpy as np
import pytest

import fairway

from conftest import ROOT

CROSSING = ROOT / "scenarios" / "crossing.yaml"
SWAP = ROOT / "scenarios" / "swap_8.yaml"


class Straight:
    """The velocity that ignores everyone, as `direct` has it."""

    def decide(self, situation):
        return situation.preferred_velocity


class Borrowed:
    """Asks an avoider that comes with fairway."""

    def __init__(self, name="orca3d", time_horizon_s=20.0):
        self.avoider = fairway.Avoider(name, time_horizon_s=time_horizon_s)

    def decide(self, situation):
        return self.avoider.decide(situation)


def scenario(name="mine", file=CROSSING, **params):
    return fairway.Scenario.load(file).with_algorithm(name, **params)


def same(a, b):
    """Two runs to the bit, whatever their algorithms are called."""
    assert a.fleet == b.fleet
    assert a.vehicles == b.vehicles


def test_a_class_in_python_makes_the_run_of_the_same_method_in_cpp():
    same(fairway.run(scenario(), algorithms={"mine": Straight}), fairway.run(scenario("direct")))


def test_its_commands_keep_mode_and_all_else():
    mine = fairway.run(scenario(time_horizon_s=20), algorithms={"mine": Borrowed})
    same(mine, fairway.run(CROSSING))


def test_parameters_of_the_scenario_are_keywords_of_the_constructor():
    seen = []

    class Mine(Straight):
        def __init__(self, gain, turns=1, careful=False, word="port"):
            seen.append((gain, turns, careful, word))

    chosen = scenario(gain=2, turns=3, careful=True, word="starboard")
    fairway.run(chosen, algorithms={"mine": Mine})
    assert seen == [(2.0, 3, True, "starboard")] * 2
    assert [type(value) for value in seen[0]] == [float, int, bool, str]


def test_a_scenario_file_names_it_like_any_other(tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text(CROSSING.read_text().replace("orca3d, time_horizon_s: 20", "mine, gain: 0.25"))

    class Mine(Straight):
        def __init__(self, gain=1.0):
            self.gain = gain

        def decide(self, situation):
            return self.gain * situation.preferred_velocity

    slow = fairway.run(file, algorithms={"mine": Mine})
    fast = fairway.run(fairway.Scenario.load(file, overrides={"vehicles[*].avoider.gain": 1.0}),
                       algorithms={"mine": Mine})
    assert slow.fleet["makespan_s"] > 2.0 * fast.fleet["makespan_s"]


@pytest.mark.parametrize("params, words", [
    ({"gian": 2}, ["gian", "unknown parameter", "did you mean gain?"]),
    ({}, ["needs a value of \"gain\""]),
    ({"gain": 1, "turns": 1.5}, ["turns", "expected an integer"]),
    ({"gain": 1, "word": 3}, ["word", "expected a text"]),
])
def test_a_parameter_that_does_not_fit_is_refused_before_the_run(params, words):
    class Mine(Straight):
        def __init__(self, gain, turns=1, word="port"):
            pass

        def decide(self, situation):
            pytest.fail("the run began")

    with pytest.raises(fairway.InputError) as refused:
        fairway.run(scenario(**params), algorithms={"mine": Mine})
    for word in words:
        assert word in str(refused.value)
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("algorithms, words", [
    ({"orca3d": Straight}, "comes with fairway"),
    ({"saw": Straight}, "comes with fairway"),
    ({"mine+more": Straight}, "no name"),
    ({"": Straight}, "no name"),
    ({3: Straight}, "expected names"),
    ({"mine": 7}, "is to be a class"),
    ({"mine": int}, "has no decide"),
    ([Straight], "expected a dict"),
])
def test_what_is_no_algorithm_is_refused(algorithms, words):
    with pytest.raises(fairway.InputError, match=words):
        fairway.run(scenario("direct"), algorithms=algorithms)


def test_a_misspelt_name_gets_the_nearest():
    with pytest.raises(fairway.InputError, match="did you mean mine?"):
        fairway.run(scenario("minne"), algorithms={"mine": Straight})


def test_every_vehicle_has_an_object_of_its_own_and_a_seed_of_its_own():
    made = []

    class Mine(Straight):
        def __init__(self, seed):
            self.seed = seed
            self.vehicles = set()
            made.append(self)

        def decide(self, situation):
            self.vehicles.add(situation.own.id)
            return super().decide(situation)

    fairway.run(scenario(file=SWAP), algorithms={"mine": Mine})
    assert len(made) == 8
    assert sorted(vehicle for mine in made for vehicle in mine.vehicles) == sorted({v for m in made for v in m.vehicles})
    assert all(len(mine.vehicles) == 1 for mine in made)
    assert len({mine.seed for mine in made}) == 8
    first = [mine.seed for mine in made]
    made.clear()
    fairway.run(scenario(file=SWAP), algorithms={"mine": Mine})
    assert [mine.seed for mine in made] == first
    made.clear()
    fairway.run(scenario(file=SWAP).with_seed(2), algorithms={"mine": Mine})
    assert not set(first) & {mine.seed for mine in made}


def test_reset_is_called_before_the_first_decision():
    log = []

    class Mine(Straight):
        def reset(self):
            log.append("reset")

        def decide(self, situation):
            if len(log) < 4:
                log.append("decide")
            return super().decide(situation)

    fairway.run(scenario(), algorithms={"mine": Mine})
    assert log == ["reset", "reset", "decide", "decide"]


def test_wrappers_stand_around_it():
    mine = fairway.run(scenario("mine+stop_and_wait", crit_dist_m=12), algorithms={"mine": Straight})
    same(mine, fairway.run(scenario("direct+stop_and_wait", crit_dist_m=12)))
    assert mine.vehicles[1]["hold_time_s"] + mine.vehicles[0]["hold_time_s"] > 0


def test_an_exception_ends_the_run_with_its_traceback():
    class Mine(Straight):
        def decide(self, situation):
            if situation.time > 1.0:
                return self.divide(situation)
            return super().decide(situation)

        def divide(self, situation):
            return 1 / 0

    with pytest.raises(ZeroDivisionError) as raised:
        fairway.run(scenario(), algorithms={"mine": Mine})
    text = "".join(traceback.format_exception(raised.value))
    assert "in divide" in text and "return 1 / 0" in text
    if sys.version_info >= (3, 11):  # before, exceptions have no notes
        assert "the algorithm \"mine\" of the vehicle" in raised.value.__notes__[0]


def test_an_exception_in_a_constructor_surfaces_too():
    class Mine(Straight):
        def __init__(self):
            raise KeyError("no map on board")

    with pytest.raises(KeyError, match="no map on board"):
        fairway.run(scenario(), algorithms={"mine": Mine})


def test_an_exception_without_words_is_still_itself():
    class Dumb(Exception):
        def __str__(self):
            raise RuntimeError("never mind")

    class Mine(Straight):
        def decide(self, situation):
            raise Dumb

    with pytest.raises(Dumb):
        fairway.run(scenario(), algorithms={"mine": Mine})


@pytest.mark.parametrize("answer, error, words", [
    (None, TypeError, "not on NoneType"),
    ("north", TypeError, "'north'"),
    (3.0, TypeError, "not on float"),
    ([1.0, 2.0], TypeError, r"shape \(2,\)"),
    (np.zeros((3, 1)), TypeError, r"shape \(3, 1\)"),
    ([0.0, np.nan, 0.0], ValueError, "not finite"),
    (fairway.Command(velocity=[np.inf, 0, 0]), ValueError, "not finite"),
    (fairway.Command(heading=np.nan), ValueError, "not finite"),
])
def test_a_wrong_answer_is_told_with_the_name_of_the_algorithm(answer, error, words):
    class Mine:
        def decide(self, situation):
            return answer

    with pytest.raises(error, match=words) as raised:
        fairway.run(scenario(), algorithms={"mine": Mine})
    assert '"mine"' in str(raised.value)


@pytest.mark.parametrize("answer", [[0.3, 0.0, 0.0], (0.3, 0.0, 0.0), np.array([0.3, 0.0, 0.0], np.float32)])
def test_three_numbers_of_any_kind_are_a_velocity(answer):
    class Mine:
        def decide(self, situation):
            return answer

    trajectories = fairway.run(scenario(), algorithms={"mine": Mine}, trajectories=True).trajectories
    assert trajectories.commands[10, 0] == pytest.approx([0.3, 0.0, 0.0], abs=1e-6)


def test_an_answer_is_held_to_the_limits_of_the_vehicle():
    class Mine:
        def decide(self, situation):
            return [3.0, 4.0, 0.0]

    trajectories = fairway.run(scenario(), algorithms={"mine": Mine}, trajectories=True).trajectories
    assert trajectories.commands[0, 0] == pytest.approx([0.3, 0.4, 0.0])


def test_a_situation_may_be_kept():
    kept = []

    class Mine(Straight):
        def decide(self, situation):
            kept.append(situation)
            return super().decide(situation)

    fairway.run(scenario(), algorithms={"mine": Mine})
    times = [situation.time for situation in kept]
    assert times == sorted(times) and len(set(times)) > 100
    assert all(len(situation.tracks) == 1 for situation in kept)
    nearest = min(float(np.linalg.norm(s.tracks[0].position - s.own.position)) for s in kept)
    assert nearest < 3.0


def test_batches_are_the_same_on_any_number_of_jobs():
    class Wanders(Straight):
        def __init__(self, seed):
            self.random = np.random.default_rng(seed)

        def decide(self, situation):
            return situation.preferred_velocity + self.random.normal(0.0, 0.05, 3)

    one, three = (fairway.run_batch(scenario(), seeds=range(5), jobs=jobs, algorithms={"mine": Wanders})
                  for jobs in (1, 3))
    assert not one.failures and not three.failures
    for quantity, values in one.fleet.items():
        assert np.array_equal(values, three.fleet[quantity], equal_nan=True)
    alone = fairway.run(scenario().with_seed(3), algorithms={"mine": Wanders})
    assert one.fleet["min_separation_m"][3] == alone.fleet["min_separation_m"]


def test_an_exception_ends_only_its_own_run_of_a_batch():
    class Mine(Straight):
        def __init__(self, seed):
            self.fails = seed in unlucky

        def decide(self, situation):
            if self.fails:
                raise LookupError("lost")
            return super().decide(situation)

    class SeesSeed(Straight):
        def __init__(self, seed):
            unlucky.append(seed)

    unlucky = []
    fairway.run(scenario().with_seed(2), algorithms={"mine": SeesSeed})
    batch = fairway.run_batch(scenario(), seeds=range(4), jobs=2, algorithms={"mine": Mine})
    assert list(batch.failures) == [2]
    failure = batch.failures[2]
    assert isinstance(failure, LookupError)
    assert "raise LookupError" in "".join(traceback.format_exception(failure))
    assert np.isfinite(batch.fleet["makespan_s"][[0, 1, 3]]).all()


def test_it_is_told_the_current_as_estimated_on_board():
    told = []

    class Drifts(Straight):
        def decide(self, situation):
            told.append(situation.current.tolist())
            return super().decide(situation)

    water = {"water.current_mps": [0.1, -0.05, 0], "duration_s": 2}
    fairway.run(fairway.Scenario.load(CROSSING, overrides=water).with_algorithm("mine"), algorithms={"mine": Drifts})
    assert told and all(each == pytest.approx([0.1, -0.05, 0]) for each in told)
