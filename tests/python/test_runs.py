# SPDX-License-Identifier: Apache-2.0
"""Runs, one and many: the numbers of the command, to the bit."""

import _thread
import json
import math
import os
import signal
import subprocess
import threading
import time

import numpy as np
import pytest

import fairway as fw


def command_json(command, *arguments):
    """What `fairway run ... --json` says; JSON has no infinity, which is null there."""
    made = subprocess.run([command, "run", *map(str, arguments), "--json"], capture_output=True, text=True)
    assert made.returncode in (0, 1), made.stderr  # 1: an expectation of the file failed
    return json.loads(made.stdout)


def finite(numbers):
    return {name: value if not isinstance(value, float) or math.isfinite(value) else None for name, value in numbers.items()}


def test_a_run_has_the_numbers_of_the_command_to_the_bit(scenarios, fairway_command):
    for name, seed in [("cube20_4", 3), ("crossing", 1), ("sonar_crossing", 2), ("otter_in_waves", 5)]:
        file = scenarios / f"{name}.yaml"
        said = command_json(fairway_command, file, "--seed", seed)
        run = fw.run(fw.Scenario.load(file, seed=seed))
        assert finite(run.fleet) == said["fleet"], name
        assert [finite(vehicle) for vehicle in run.vehicles] == said["vehicles"], name
        assert (run.simulated_s, run.seed, run.scenario) == (said["simulated_s"], seed, name)
        assert run.notes == said.get("notes", {})


def test_an_algorithm_chosen_here_is_as_chosen_there(scenarios, fairway_command):
    file = scenarios / "cube20_4.yaml"
    said = command_json(fairway_command, file, "--seed", 2, "--algorithm", "apf+stop_and_wait")
    run = fw.run(fw.Scenario.load(file, seed=2).with_algorithm("apf+stop_and_wait"))
    assert finite(run.fleet) == said["fleet"]


def test_trajectories_are_arrays_of_frames_and_vehicles(scenarios):
    run = fw.run(scenarios / "cube20_4.yaml", trajectories=True)
    moved = run.trajectories
    frames = len(moved)
    assert moved.positions.shape == moved.velocities.shape == moved.commands.shape == (frames, 4, 3)
    assert moved.quaternions.shape == (frames, 4, 4)
    assert moved.modes.shape == moved.phases.shape == moved.yaws.shape == (frames, 4)
    assert np.all(np.diff(moved.times) > 0)
    assert fw.Phase(int(moved.phases[0, 0])) == fw.Phase.deploying
    assert fw.Phase(int(moved.phases[-1, 0])) == fw.Phase.arrived
    under_way = np.all(moved.phases >= int(fw.Phase.under_way), axis=1)
    gaps = moved.positions[:, :, None] - moved.positions[:, None, :]
    distances = np.linalg.norm(gaps, axis=-1) + 1e9 * np.eye(4)
    assert distances[under_way].min() >= run.fleet["min_separation_m"] - 1e-9
    with pytest.raises(ValueError):
        moved.positions[0, 0, 0] = 1
    assert fw.run(scenarios / "crossing.yaml").trajectories is None


def test_arrays_outlive_their_run(scenarios):
    positions = fw.run(scenarios / "crossing.yaml", trajectories=True).trajectories.positions
    again = fw.run(scenarios / "crossing.yaml", trajectories=True).trajectories.positions
    assert np.array_equal(positions, again)


def test_a_thousand_runs_of_the_small_cube_in_one_call(scenarios, fairway_command):
    file = scenarios / "cube20_4.yaml"
    begin = time.perf_counter()
    batch = fw.run_batch(file, seeds=range(1000))
    wall = time.perf_counter() - begin
    print(f"\n1000 runs of cube20_4 in {wall:.1f} s on {os.cpu_count()} cores", flush=True)
    assert len(batch) == 1000 and not batch.failures
    assert batch.seeds.tolist() == list(range(1000))
    assert batch.vehicles["navigation_time_s"].shape == (1000, 4)
    assert batch.fleet["min_separation_m"].shape == (1000,)
    for seed in (0, 1, 17, 500, 999):
        said = command_json(fairway_command, file, "--seed", seed)
        assert finite({name: values[seed].item() for name, values in batch.fleet.items()}) == said["fleet"], seed
        for vehicle in range(4):
            mine = finite({name: values[seed, vehicle].item() for name, values in batch.vehicles.items()})
            theirs = {name: value for name, value in said["vehicles"][vehicle].items() if name != "name"}
            assert mine == theirs, (seed, vehicle)


def test_the_results_do_not_depend_on_jobs_and_threads_do_not_wait_for_each_other(scenarios):
    batches, walls, busy = {}, {}, {}
    for jobs in (1, 2, 5):
        begin = time.process_time()
        batches[jobs] = fw.run_batch(scenarios / "cube20_8.yaml", seeds=range(40), jobs=jobs)
        busy[jobs] = time.process_time() - begin
        walls[jobs] = batches[jobs].wall_s
    print(
        f"\n40 runs of cube20_8: {walls[1]:.2f} s with one job, {walls[2]:.2f} s with two; "
        f"processor time {busy[1]:.2f} and {busy[2]:.2f} s",
        flush=True,
    )
    # on a shared machine wall time says nothing; who waits for a lock or spins shows in the processor's
    assert busy[2] < 1.6 * busy[1]
    for jobs in (2, 5):
        for quantity, values in batches[1].vehicles.items():
            assert np.array_equal(values, batches[jobs].vehicles[quantity], equal_nan=True), quantity
        for quantity, values in batches[1].fleet.items():
            assert np.array_equal(values, batches[jobs].fleet[quantity], equal_nan=True), quantity


def test_a_list_of_scenarios_is_run_one_after_the_other(scenarios):
    batch = fw.run_batch([scenarios / "crossing.yaml", fw.Scenario.load(scenarios / "cube20_4.yaml")], seeds=[4, 5])
    assert batch.scenario_names == ["crossing", "cube20_4"]
    assert batch.scenarios.tolist() == [0, 0, 1, 1] and batch.seeds.tolist() == [4, 5, 4, 5]
    times = batch.vehicles["navigation_time_s"]
    assert times.shape == (4, 4)
    assert np.isnan(times[0, 2:]).all() and np.isfinite(times[2]).all(), "the crossing has two vehicles"


def test_without_seeds_each_scenario_has_its_own(scenarios):
    batch = fw.run_batch([fw.Scenario.load(scenarios / "crossing.yaml", seed=9)])
    assert batch.seeds.tolist() == [9]


# drawn so that now and then a vehicle starts inside an obstacle, which a scenario may not have
UNLUCKY = {
    "vehicles[0].start.position_m": [{"uniform": [-40, -25]}, 0, 5],
    "obstacles": [{"sphere": {"position_m": [-36, 0, 5], "radius_m": 4}}],
}


def first_lucky_seed(file):
    for seed in range(100):
        try:
            fw.Scenario.load(file, overrides=UNLUCKY, seed=seed)
        except fw.InputError:
            continue
        return seed
    raise AssertionError("every draw is unlucky")


def test_one_failing_run_does_not_end_the_others(scenarios):
    file = scenarios / "crossing.yaml"
    scenario = fw.Scenario.load(file, overrides=UNLUCKY, seed=first_lucky_seed(file))
    batch = fw.run_batch(scenario, seeds=range(12))
    assert 0 < len(batch.failures) < 12
    for i, failure in batch.failures.items():
        assert isinstance(failure, fw.InputError) and "vehicles[0].start" in str(failure)
        assert np.isnan(batch.fleet["makespan_s"][i])
    fine = [i for i in range(12) if i not in batch.failures]
    assert np.isfinite(batch.fleet["makespan_s"][fine]).all()
    alone = fw.run(fw.Scenario.load(file, overrides=UNLUCKY, seed=fine[-1]))
    assert batch.fleet["makespan_s"][fine[-1]] == alone.fleet["makespan_s"]


def test_a_name_that_nobody_has_is_refused_before_anything_runs(scenarios):
    scenario = fw.Scenario.load(scenarios / "crossing.yaml").with_algorithm("orca3")
    with pytest.raises(fw.InputError, match="did you mean orca3d"):
        fw.run_batch(scenario, seeds=range(10))


def test_progress_is_told_and_may_end_the_batch(scenarios):
    told = []
    fw.run_batch(scenarios / "cube20_4.yaml", seeds=range(40), progress=lambda done, total: told.append((done, total)))
    assert told[-1] == (40, 40) and told == sorted(told)

    class Enough(Exception):
        pass

    def refuse(done, total):
        raise Enough

    begin = time.perf_counter()
    with pytest.raises(Enough):
        fw.run_batch(scenarios / "cube60_8.yaml", seeds=range(100000), progress=refuse)
    assert time.perf_counter() - begin < 20


def test_ctrl_c_ends_a_batch_and_a_run(scenarios):
    signal.signal(signal.SIGINT, signal.default_int_handler)  # whoever starts tests in the background ignores it
    for work in (
        lambda: fw.run_batch(scenarios / "cube60_8.yaml", seeds=range(1000000)),
        lambda: fw.run(fw.Scenario.load(scenarios / "cube60_8.yaml", overrides={"duration_s": 1e6, "stop_when_done": False})),
        lambda: fw.study("cubes", seeds=500),
    ):
        threading.Timer(0.5, _thread.interrupt_main).start()
        begin = time.perf_counter()
        with pytest.raises(KeyboardInterrupt):
            work()
        assert time.perf_counter() - begin < 60, "each of them would take hours"


def test_other_threads_of_python_go_on_meanwhile(scenarios):
    ticks = []
    done = threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.perf_counter())
            time.sleep(0.002)

    thread = threading.Thread(target=tick)
    thread.start()
    fw.run_batch(scenarios / "cube20_4.yaml", seeds=range(60))
    done.set()
    thread.join()
    assert len(ticks) > 20 and max(np.diff(ticks)) < 0.5, "the lock was held"


def test_a_run_is_recorded_as_by_the_command(scenarios, fairway_command, tmp_path):
    file = scenarios / "cube20_4.yaml"
    fw.run(fw.Scenario.load(file, seed=3), record=tmp_path / "mine.mcap", perception=True, sketches=True)
    subprocess.run(
        [fairway_command, "run", file, "--seed", "3", "--out", tmp_path / "its.mcap", "--perception", "--sketch"],
        check=True, capture_output=True,
    )  # fmt: skip
    assert (tmp_path / "mine.mcap").read_bytes() == (tmp_path / "its.mcap").read_bytes()
    with pytest.raises(fw.InputError, match="record: is empty"):
        fw.run(file, record="")
    with pytest.raises(fw.InputError, match="record is missing"):
        fw.run(file, sketches=True)
