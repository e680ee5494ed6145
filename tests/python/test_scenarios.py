# SPDX-License-Identifier: Apache-2.0
"""Scenarios: loaded, drawn anew, changed, and written back."""

import json

import pytest

import fairway as fw


def test_a_scenario_shows_what_it_holds(scenarios):
    scenario = fw.Scenario.load(scenarios / "cube20_4.yaml")
    assert scenario.name == "cube20_4" and scenario.duration_s == 600
    assert (scenario.crit_dist_m, scenario.safety_distance_m) == (20, 3)
    vehicle = scenario.vehicles[0]
    assert (vehicle.model, vehicle.algorithm, vehicle.radius_m) == ("sparus2", "orca3d", 3)
    assert vehicle.algorithm_params == {"crit_dist_m": 20, "time_horizon_s": 5}
    assert vehicle.limits.max_speed == 0.5
    assert [leg.kind for leg in vehicle.mission] == ["go_to", "rendezvous", "transit"]
    assert vehicle.mission[2].position.tolist() == [-10, -10, 20]


def test_every_scenario_that_comes_with_fairway_is_written_back_to_the_same(scenarios):
    files = sorted(scenarios.glob("*.yaml"))
    assert len(files) >= 30
    for file in files:
        text = fw.Scenario.load(str(file)).to_yaml()
        assert fw.Scenario.parse(text).to_yaml() == text, file


def test_another_seed_is_another_draw_and_the_same_seed_the_same(scenarios):
    scenario = fw.Scenario.load(scenarios / "cube20_4.yaml")
    yaws = [scenario.with_seed(seed).vehicles[0].yaw for seed in (1, 2, 1)]
    assert yaws[0] == yaws[2] != yaws[1]
    assert scenario.with_seed(7).to_yaml() == fw.Scenario.load(scenarios / "cube20_4.yaml", seed=7).to_yaml()


def test_overrides_reach_every_vehicle_and_survive_another_seed(scenarios):
    overrides = {"vehicles[*].radius_m": 2.5, "exam.crit_dist_m": 9, "coincident_start": True}
    scenario = fw.Scenario.load(scenarios / "cube20_4.yaml", overrides=overrides).with_seed(4)
    assert {vehicle.radius_m for vehicle in scenario.vehicles} == {2.5}
    assert scenario.with_overrides({"vehicles[1].start.position_m": [1, 2, 3]}).vehicles[1].position.tolist() == [1, 2, 3]
    assert scenario.crit_dist_m == 9


def test_an_algorithm_goes_to_everyone_and_keeps_parameters_of_its_own(scenarios):
    scenario = fw.Scenario.load(scenarios / "cube20_4.yaml")
    assert scenario.with_algorithm("orca3d").vehicles[0].algorithm_params == {"crit_dist_m": 20, "time_horizon_s": 5}
    longer = scenario.with_algorithm("orca3d", time_horizon_s=9).vehicles[3]
    assert longer.algorithm_params == {"crit_dist_m": 20, "time_horizon_s": 9}
    other = scenario.with_algorithm("apf+stop_and_wait", crit_dist_m=8).with_seed(5).vehicles[2]
    assert (other.algorithm, other.algorithm_params) == ("apf+stop_and_wait", {"crit_dist_m": 8})


def test_the_schema_is_json():
    assert "vehicles" in json.loads(fw.Scenario.schema())["properties"]


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda file: fw.Scenario.load("nowhere.yaml"), "nowhere.yaml: cannot be read"),
        (lambda file: fw.Scenario.load(3), "file: expected a path, got 3"),
        (lambda file: fw.Scenario.load(file, seed=-1), "seed: expected a whole number that fits, got -1"),
        (lambda file: fw.Scenario.load(file, overrides={"exam.crit_dist": 1}), "did you mean crit_dist_m?"),
        (lambda file: fw.Scenario.load(file, overrides=[1]), "overrides: expected a dict of paths and values"),
        (lambda file: fw.Scenario.parse("fairway: 1\nnaem: x\n", file="mine.yaml"), "mine.yaml:2:1: naem"),
        (lambda file: fw.run(file, record=3), "file: expected a path, got 3"),
        (lambda file: fw.run(fw.Scenario.load(file).with_algorithm("orca3")), "did you mean orca3d?"),
    ],
)
def test_a_mistake_says_where_and_names_the_nearest(scenarios, make, message):
    with pytest.raises(fw.InputError) as raised:
        make(scenarios / "cube20_4.yaml")
    assert message in str(raised.value)
