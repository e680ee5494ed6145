# SPDX-License-Identifier: Apache-2.0
"""Recordings and results stores as arrays, and studies."""

import subprocess

import numpy as np
import pytest

import fairway as fw


@pytest.fixture
def recorded(scenarios, tmp_path):
    run = fw.run(fw.Scenario.load(scenarios / "cube20_4.yaml", seed=3), record=tmp_path / "cube.mcap", trajectories=True)
    return run, fw.Recording.read(tmp_path / "cube.mcap")


def test_a_recording_holds_what_the_run_was_to_the_bit(recorded):
    run, recording = recorded
    assert len(recording) == len(run.trajectories)
    for name in ("times", "positions", "velocities", "quaternions", "yaws", "commands", "goals", "modes", "phases"):
        assert np.array_equal(getattr(recording, name), getattr(run.trajectories, name)), name
    assert recording.fleet == run.fleet and recording.vehicles == run.vehicles
    assert recording.positions is recording.trajectories.positions, "made once"


def test_a_recording_says_what_it_is_of_and_the_run_can_be_made_again(recorded):
    run, recording = recorded
    assert recording.names == [vehicle["name"] for vehicle in run.vehicles]
    assert recording.models == ["sparus2"] * 4
    assert (recording.seed, recording.scenario_name) == (3, "cube20_4")
    assert recording.version == fw.__version__
    assert fw.run(fw.Scenario.parse(recording.scenario_yaml)).fleet == run.fleet


def test_a_recording_holds_what_methods_said(scenarios, tmp_path):
    scenario = fw.Scenario.load(scenarios / "pledge_cube.yaml", overrides={"duration_s": 60})
    fw.run(scenario, record=tmp_path / "pledge.mcap")
    words = fw.Recording.read(tmp_path / "pledge.mcap").words
    assert len(words) > 30
    assert {word["vehicle"] for word in words} <= set(range(8))
    assert all(len(word["bytes"]) == 25 for word in words)
    assert [word["time_s"] for word in words] == sorted(word["time_s"] for word in words)


def test_a_recording_of_nobody_who_speaks_has_no_words(recorded):
    assert recorded[1].words == []


def test_csv_is_that_of_the_command(recorded, fairway_command, tmp_path):
    _, recording = recorded
    said = subprocess.run(
        [fairway_command, "replay", recording.file, "--csv", "-"], capture_output=True, text=True, check=True
    ).stdout
    assert recording.csv() == said
    assert recording.csv(tmp_path / "cube.csv") is None and (tmp_path / "cube.csv").read_text() == said
    with pytest.raises(fw.InputError, match="perception"):
        recording.tracks_csv()


def test_a_file_that_is_no_recording_is_refused(tmp_path):
    (tmp_path / "no.mcap").write_text("nothing")
    with pytest.raises(fw.InputError, match="no.mcap"):
        fw.Recording.read(tmp_path / "no.mcap")


def test_stored_results_are_columns(scenarios, fairway_command, tmp_path):
    (tmp_path / "duel.yaml").write_text(
        f"fairway_campaign: 1\nname: duel\nscenario: {scenarios}/cube20_4.yaml\n"
        "algorithms: [apf, orca3d]\nseeds: {first: 1, count: 3}\n"
    )
    store = tmp_path / "duel.db"
    subprocess.run([fairway_command, "sweep", tmp_path / "duel.yaml", "--out", store], check=True, capture_output=True)
    results = fw.load_results(store)
    assert len(results) == 6 and results.labels["method"] == ["apf"] * 3 + ["orca3d"] * 3
    assert results.seeds.tolist() == [1, 2, 3] * 2
    assert not results.failures and all("fairway run" in command for command in results.commands)
    batch = fw.run_batch(scenarios / "cube20_4.yaml", seeds=[1, 2, 3])
    orca = np.array([method == "orca3d" for method in results.labels["method"]])
    assert results.vehicles["navigation_time_s"][orca].shape == (3, 4)
    assert np.array_equal(results.fleet["makespan_s"][orca].shape, batch.fleet["makespan_s"].shape)
    with pytest.raises(fw.InputError):
        fw.load_results(tmp_path / "nowhere.db")


def test_studies_have_names_and_refuse_others():
    assert {"cubes", "transport", "surface", "uuv", "pledge"} == {study["name"] for study in fw.studies()}
    with pytest.raises(fw.InputError, match="did you mean cubes"):
        fw.study("cube")
    with pytest.raises(fw.InputError, match="seeds: expected 0 or more"):
        fw.study("cubes", seeds=-1)


def test_the_rows_of_a_study_are_those_of_the_command(fairway_command):
    import json

    said = subprocess.run(
        [fairway_command, "study", "uuv", "--seeds", "0", "--json"], capture_output=True, text=True, check=True
    ).stdout
    rows = fw.study("uuv", seeds=0)
    assert rows == json.loads(said)["rows"]
    assert all(row["verdict"] for row in rows)
