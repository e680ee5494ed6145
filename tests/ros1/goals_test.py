# SPDX-License-Identifier: Apache-2.0
"""Vehicles that reach their goals through ROS without a collision: the simulator ends with 0 only if all that the
scenario expects is so."""

import os
import subprocess

import pytest

from graph import BIN, FLEET, ROOT, measures, states_of


def run_through(graph, scenario, sim, avoider, file=None):
    for vehicle in FLEET[scenario]:
        graph.avoider(scenario, vehicle, **avoider)
    settings = {"wait_for_subscribers": len(FLEET[scenario]), **sim}
    process = graph.simulator(file or scenario, **settings)
    assert process.result(120) == 0, process.output()
    return process.output()


def plain_run(scenario, recording):
    path = os.path.join(ROOT, "scenarios", scenario + ".yaml")
    subprocess.run([os.path.join(BIN, "fairway"), "run", path, "--out", recording], check=True, capture_output=True)


@pytest.mark.parametrize("scenario", ["head_on", "priority_wait", "cube20_4"])
def test_a_fleet_in_lockstep_goes_where_it_goes_without_ros(graph, tmp_path, scenario):
    through, plain = str(tmp_path / "through.mcap"), str(tmp_path / "plain.mcap")
    run_through(graph, scenario, dict(speed=0, lockstep=True, lockstep_timeout_s=20, frame="ned", record=through), dict(frame="ned", lockstep=True))
    plain_run(scenario, plain)
    assert measures(through)["min_separation_m"] == measures(plain)["min_separation_m"]
    first = next((pair for pair in zip(states_of(through), states_of(plain)) if pair[0] != pair[1]), None)
    assert first is None
    assert measures(through)["frames"] == measures(plain)["frames"]


@pytest.fixture
def cube_in_any_time(tmp_path):
    """The cube without its bound on time: against the clock of a busy machine commands come late."""
    with open(os.path.join(ROOT, "scenarios", "cube20_8.yaml"), encoding="utf-8") as file:
        lines = file.readlines()
    kept = [line for line in lines if "makespan_s" not in line]
    assert len(kept) == len(lines) - 1
    path = tmp_path / "cube20_8.yaml"
    path.write_text("".join(kept), encoding="utf-8")
    return str(path)


def test_eight_vehicles_reach_their_goals_at_ten_times_real_time(graph, cube_in_any_time):
    said = run_through(graph, "cube20_8", dict(speed=10), dict(rate_hz=20), cube_in_any_time)
    assert "pair_collision_count" in said


def test_eight_vehicles_reach_their_goals_on_records_of_25_bytes_alone(graph, cube_in_any_time):
    sim = dict(speed=10, wait_for_subscribers=1)
    run_through(graph, "cube20_8", sim, dict(input="team_record", record_rate_hz=5), cube_in_any_time)
