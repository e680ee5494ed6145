# SPDX-License-Identifier: Apache-2.0
"""Campaigns from Python, with algorithms written in Python among the methods."""

import json
import os
import signal
import subprocess
import sys
import textwrap
import time

import numpy as np
import pytest

import fairway

from conftest import ROOT

SCENARIO = ROOT / "scenarios" / "crossing.yaml"


class Mine:
    """Asks an avoider that comes with fairway, and goes a little slower."""

    def __init__(self, gain=0.9, seed=0):
        self.avoider = fairway.Avoider("orca3d", time_horizon_s=20)
        self.random = np.random.default_rng(seed)
        self.gain = gain

    def decide(self, situation):
        command = self.avoider.decide(situation)
        return command.replace(velocity=self.gain * command.velocity + self.random.normal(0.0, 0.01, 3))


class Raises(Mine):
    def decide(self, situation):
        if situation.time > 1.0:
            raise LookupError("lost at sea")
        return super().decide(situation)


def campaign_of(folder, methods="[{algorithm: orca3d, time_horizon_s: 20}, {algorithm: mine, gain: 0.8}]", seeds=2):
    file = folder / "mine.yaml"
    file.write_text(
        f"fairway_campaign: 1\nname: mine\nscenario: {SCENARIO}\nalgorithms: {methods}\n"
        f"seeds: {{count: {seeds}}}\nquantities: [min_separation_m, makespan_s]\n"
    )
    return file


@pytest.fixture
def campaign(tmp_path):
    return campaign_of(tmp_path)


def rows(results):
    return [
        (results.labels["method"][i], int(results.seeds[i]), {q: v[i] for q, v in results.fleet.items()})
        for i in range(len(results))
    ]


def same(a, b):
    assert a.keys == b.keys and a.labels == b.labels and a.failures == b.failures
    for columns, others in ((a.fleet, b.fleet), (a.vehicles, b.vehicles)):
        assert columns.keys() == others.keys()
        for quantity, values in columns.items():
            assert np.array_equal(values, others[quantity], equal_nan=True), quantity


def test_its_numbers_are_those_of_each_run_alone(campaign):
    results = fairway.sweep(campaign, algorithms={"mine": Mine})
    assert len(results) == results.made == 4 and not results.failures
    assert {(method, seed) for method, seed, _ in rows(results)} == {(m, s) for m in ("mine", "orca3d") for s in (1, 2)}
    for method, seed, numbers in rows(results):
        params = {"gain": 0.8} if method == "mine" else {"time_horizon_s": 20}
        scenario = fairway.Scenario.load(SCENARIO, seed=seed).with_algorithm(method, **params)
        assert fairway.run(scenario, algorithms={"mine": Mine}).fleet == numbers


def test_the_results_do_not_depend_on_jobs_nor_on_interruptions(campaign, tmp_path):
    one = fairway.sweep(campaign, out=tmp_path / "one.sqlite", jobs=1, algorithms={"mine": Mine})
    three = fairway.sweep(campaign, out=tmp_path / "three.sqlite", jobs=3, algorithms={"mine": Mine})
    same(one, three)
    half = campaign_of(tmp_path, seeds=1)
    assert fairway.sweep(half, out=tmp_path / "parts.sqlite", algorithms={"mine": Mine}).made == 2
    rest = fairway.sweep(campaign_of(tmp_path), out=tmp_path / "parts.sqlite", algorithms={"mine": Mine})
    assert rest.made == 2
    same(one, rest)
    again = fairway.sweep(campaign, out=tmp_path / "parts.sqlite", algorithms={"mine": Mine})
    assert again.made == 0
    same(one, again)


def test_without_an_algorithm_in_python_it_is_the_commands(fairway_command, tmp_path):
    campaign = campaign_of(tmp_path, "[orca3d, {algorithm: apf, crit_dist_m: 8}]")
    subprocess.run([fairway_command, "sweep", campaign, "--out", tmp_path / "a.sqlite"], check=True, capture_output=True)
    same(fairway.sweep(campaign, out=tmp_path / "b.sqlite"), fairway.load_results(tmp_path / "a.sqlite"))
    assert fairway.sweep(campaign, out=tmp_path / "a.sqlite").made == 0, "the keys are the command's"


def test_compare_is_the_commands_document(campaign, fairway_command, tmp_path):
    store = tmp_path / "results.sqlite"
    results = fairway.sweep(campaign, out=store, algorithms={"mine": Mine})
    flags = ["--baseline", "mine", "--quantity", "makespan_s", "--confidence", "0.9", "--json"]
    said = subprocess.run([fairway_command, "compare", store, *flags], check=True, capture_output=True, text=True)
    for given in (results, store, str(store), [results]):
        compared = fairway.compare(given, baseline="mine", quantities=["makespan_s"], confidence=0.9)
        assert compared == json.loads(said.stdout)
    assert json.loads(
        subprocess.run([fairway_command, "compare", store, "--json"], check=True, capture_output=True, text=True).stdout
    ) == fairway.compare(results)


@pytest.mark.parametrize("wanted, words", [
    ({"baseline": "nobody"}, "nobody"),
    ({"quantities": ["makespan"]}, "makespan"),
    ({"confidence": 0.2}, r"\[0.5, 0.9999\], got 0.2"),
    ({"by": "colour"}, "colour"),
])
def test_compare_refuses_what_there_is_not(campaign, wanted, words):
    with pytest.raises(fairway.InputError, match=words):
        fairway.compare(fairway.sweep(campaign, algorithms={"mine": Mine}), **wanted)


def test_a_run_that_raises_is_stored_as_failed_and_the_others_go_on(campaign, tmp_path):
    store = tmp_path / "results.sqlite"
    results = fairway.sweep(campaign, out=store, algorithms={"mine": Raises})
    assert results.labels["method"] == ["mine", "mine", "orca3d", "orca3d"]
    assert set(results.failures) == {0, 1}
    assert results.failures[0].startswith("LookupError: lost at sea") and "\n" not in results.failures[0]
    assert np.isfinite(results.fleet["makespan_s"][2:]).all()
    assert fairway.sweep(campaign, out=store, algorithms={"mine": Raises}).made == 0
    assert fairway.sweep(campaign, out=store, algorithms={"mine": Raises}, retry_failures=True).made == 2


@pytest.mark.parametrize("methods, words", [
    ("[minne]", "did you mean mine?"),
    ("[orca]", "did you mean orca"),
    ("[{algorithm: mine, gian: 1}]", "did you mean gain?"),
    ("[{algorithm: mine, gain: fast}]", "expected a number"),
])
def test_a_mistake_is_refused_before_any_run_and_nothing_is_written(tmp_path, methods, words):
    with pytest.raises(fairway.InputError) as refused:
        fairway.sweep(campaign_of(tmp_path, methods), out=tmp_path / "none.sqlite", algorithms={"mine": Mine})
    assert words in str(refused.value) and "\n" not in str(refused.value)
    assert not (tmp_path / "none.sqlite").exists()


def test_wrappers_stand_around_it(tmp_path):
    campaign = campaign_of(tmp_path, "[{algorithm: mine+stop_and_wait, crit_dist_m: 12}]", seeds=1)
    results = fairway.sweep(campaign, out=tmp_path / "r.sqlite", algorithms={"mine": Mine})
    scenario = fairway.Scenario.load(SCENARIO, seed=1).with_algorithm("mine+stop_and_wait", crit_dist_m=12)
    assert rows(results)[0][2] == fairway.run(scenario, algorithms={"mine": Mine}).fleet

    class Other(Mine):
        pass

    assert fairway.sweep(campaign, out=tmp_path / "r.sqlite", algorithms={"mine": Other}).made == 1


# ---- which stored run is of which version

FACTOR = 1.0


def factor():
    return FACTOR


class Steady:
    def decide(self, situation):
        return factor() * np.array(situation.preferred_velocity)


class Quick(Steady):
    SPEED = 1.5

    def decide(self, situation):
        return self.SPEED * super().decide(situation)


def maker(gain):
    class Made(Steady):
        def decide(self, situation):
            return gain * super().decide(situation)

    return Made


def keys(folder, algorithm):
    campaign = campaign_of(folder, "[mine]", seeds=1)
    return fairway.sweep(campaign, out=folder / "versions.sqlite", algorithms={"mine": algorithm}).keys


def test_what_has_changed_is_never_taken_for_what_was_stored(tmp_path, monkeypatch):
    known = [keys(tmp_path, Steady)]
    assert keys(tmp_path, Steady) == known[0]

    def is_new(algorithm):
        key = keys(tmp_path, algorithm)
        assert key not in known
        known.append(key)

    is_new(Quick)
    is_new(maker(1.0))
    is_new(maker(2.0))  # the same code around another number
    is_new(lambda: maker(1.0)())
    monkeypatch.setattr(Quick, "SPEED", 2.0)
    is_new(Quick)
    monkeypatch.setattr(sys.modules[__name__], "FACTOR", 2.0)  # a constant that a function reads that it calls
    is_new(Steady)
    monkeypatch.setattr(sys.modules[__name__], "factor", lambda: 3.0)
    is_new(Steady)
    assert keys(tmp_path, maker(2.0)) not in known, "its base has changed with what that calls"


def test_a_version_of_ones_own_stands_for_all_else(tmp_path):
    class First(Mine):
        version = "1"

    class Second(Quick):
        version = "1"

    class Third(Quick):
        version = "2"

    assert keys(tmp_path, First) == keys(tmp_path, Second) != keys(tmp_path, Third)


def test_what_cannot_be_read_is_refused_where_runs_are_kept(tmp_path):
    import threading

    lock = threading.Lock()

    class Locked(Mine):
        def decide(self, situation):
            with lock:
                return super().decide(situation)

    with pytest.raises(fairway.InputError, match='"mine" uses <unlocked .*give it an attribute version'):
        keys(tmp_path, Locked)
    assert len(fairway.sweep(campaign_of(tmp_path), algorithms={"mine": Locked})) == 4
    Locked.version = 1
    assert keys(tmp_path, Locked)


def test_another_process_finds_the_same_version_and_another_file_another(tmp_path):
    campaign_of(tmp_path, "[mine]", seeds=1)
    program = textwrap.dedent("""
        import fairway, own
        print(fairway.sweep("mine.yaml", out="r.sqlite", algorithms={"mine": own.Own}).made)
    """)
    own = tmp_path / "own.py"
    helper = tmp_path / "helper.py"
    own.write_text("import helper\n\nclass Own:\n    def decide(self, s):\n        return helper.speed() * s.preferred_velocity\n")
    helper.write_text("def speed():\n    return 0.5\n")

    def made():
        environment = {**os.environ, "PYTHONHASHSEED": "random", "PYTHONPATH": os.pathsep.join(
            [os.path.dirname(os.path.dirname(fairway.__file__)), str(tmp_path)])}  # fmt: skip
        ran = subprocess.run([sys.executable, "-c", program], cwd=tmp_path, env=environment, capture_output=True, text=True)
        assert ran.returncode == 0, ran.stderr
        return int(ran.stdout)

    assert [made(), made()] == [1, 0]
    own.write_text("# a comment\n" + own.read_text())
    assert made() == 0
    helper.write_text("def speed():\n    return 0.25\n")
    assert made() == 1


def test_ctrl_c_leaves_a_store_that_goes_on(tmp_path):
    campaign_of(tmp_path, "[mine]", seeds=200)
    program = textwrap.dedent("""
        import time, fairway
        class Slow:
            version = 1
            def decide(self, situation):
                if situation.time == 0.0:
                    time.sleep(0.02)
                return situation.preferred_velocity
        print("begins", flush=True)
        try:
            fairway.sweep("mine.yaml", out="r.sqlite", jobs=2, algorithms={"mine": Slow})
        except KeyboardInterrupt:
            print("interrupted", flush=True)
    """)
    environment = {**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(fairway.__file__))}
    process = subprocess.Popen([sys.executable, "-c", program], cwd=tmp_path, env=environment, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)  # fmt: skip
    assert process.stdout.readline() == "begins\n"
    stored = 0
    while stored == 0 and process.poll() is None:
        time.sleep(0.05)
        try:
            stored = len(fairway.load_results(tmp_path / "r.sqlite"))
        except fairway.InputError:  # it is not there yet
            pass
    process.send_signal(signal.SIGINT)
    out, error = process.communicate(timeout=60)
    assert out == "interrupted\n" and error == "", "and no progress where there is no terminal"
    left = fairway.load_results(tmp_path / "r.sqlite")
    assert stored <= len(left) < 200 and not left.failures

    class Slow:
        version = 1

        def decide(self, situation):
            return situation.preferred_velocity

    assert fairway.sweep(tmp_path / "mine.yaml", out=tmp_path / "r.sqlite", algorithms={"mine": Slow}).made == 200 - len(left)


# ---- looking at a run of it

@pytest.fixture
def recorded(tmp_path):
    scenario = fairway.Scenario.load(SCENARIO, seed=1).with_algorithm("mine", gain=0.8)
    fairway.run(scenario, algorithms={"mine": Mine}, record=tmp_path / "mine.mcap")
    return tmp_path / "mine.mcap"


def test_a_decision_of_it_is_explained_to_the_bit(recorded, tmp_path):
    recording = fairway.Recording.read(recorded)
    why = fairway.explain(recording, vehicle=recording.names[0], time=10, algorithms={"mine": Mine}, out=tmp_path / "why.html")
    assert why["recorded_command_to_the_bit"] is True and why["avoider"] == "mine"
    frame = int(np.searchsorted(recording.times, 10.0, side="right")) - 1
    assert why["decision"]["command"]["velocity_mps"] == recording.commands[frame, 0].tolist()
    assert (tmp_path / "why.html").stat().st_size > 100_000
    assert fairway.explain(recorded, 0, 10, algorithms={"mine": Mine}) == why


def test_another_algorithm_under_its_name_is_found_out(recorded):
    class Another(Steady):
        def __init__(self, gain):
            pass

    with pytest.raises(fairway.InputError, match="this is another run"):
        fairway.explain(recorded, 0, 10, algorithms={"mine": Another})
    with pytest.raises(fairway.InputError, match="but the run"):
        fairway.view(recorded, sketch=True, algorithms={"mine": Another})
    with pytest.raises(LookupError, match="lost at sea"):
        fairway.explain(recorded, 0, 10, algorithms={"mine": Raises})


def test_its_page_has_what_was_thought(recorded, tmp_path):
    page = fairway.view(recorded, sketch=True, algorithms={"mine": Mine}, out=tmp_path / "sketch.html")
    assert page == str(tmp_path / "sketch.html")
    plain = fairway.view(recorded)
    assert plain == str(recorded.with_suffix(".html"))
    assert os.path.getsize(page) > 100_000 and os.path.getsize(plain) > 100_000
    with pytest.raises(fairway.InputError, match="is an input, too"):
        fairway.view(recorded, out=recorded)
    with pytest.raises(fairway.InputError, match="no frame in the time"):
        fairway.view(recorded, from_s=1e6)


def test_where_it_is_not_the_reason_is_said(recorded, fairway_command):
    said = '"mine" is not in this program; it was registered in Python: open the recording there, with fairway.explain('
    for verb in (["explain", recorded, "--vehicle", "0", "--time", "10"], ["replay", recorded, "--verify"],
                 ["view", recorded, "--sketch"]):  # fmt: skip
        ran = subprocess.run([fairway_command, *verb], capture_output=True, text=True)
        assert ran.returncode == 2 and ran.stdout == ""
        assert ran.stderr.startswith(f"fairway: {recorded}: ") and said in ran.stderr and ran.stderr.count("\n") == 1
    assert subprocess.run([fairway_command, "replay", recorded], capture_output=True).returncode == 0
    with pytest.raises(fairway.InputError) as refused:
        fairway.explain(recorded, 0, 10)
    assert said in str(refused.value)


def test_a_recording_of_the_command_is_explained_as_by_the_command(fairway_command, tmp_path):
    file = tmp_path / "plain.mcap"
    subprocess.run([fairway_command, "run", SCENARIO, "--out", file], check=True, capture_output=True)
    ran = subprocess.run([fairway_command, "explain", file, "--vehicle", "0", "--time", "12", "--json"],
                         check=True, capture_output=True, text=True)  # fmt: skip
    assert fairway.explain(file, "0", 12) == json.loads(ran.stdout)


def test_a_list_of_stores_that_share_runs_takes_each_once(campaign, tmp_path):
    one, two = tmp_path / "one.sqlite", tmp_path / "two.sqlite"
    results = fairway.sweep(campaign, out=one, algorithms={"mine": Mine})
    fairway.sweep(campaign, out=two, algorithms={"mine": Mine})
    for given in ([one, two], [two, one], [results, two], [one, results]):
        assert fairway.compare(given) == fairway.compare(results)


def test_two_versions_of_a_campaign_are_mixed_only_where_it_is_asked_for(tmp_path):
    methods = "[orca3d, {algorithm: apf, crit_dist_m: 8}]"
    fairway.sweep(campaign_of(tmp_path, methods), out=tmp_path / "two.sqlite")
    more = fairway.sweep(campaign_of(tmp_path, methods, seeds=3))
    with pytest.raises(fairway.InputError, match=r"results\[1\]: is of another version of campaign mine than .*two"):
        fairway.compare([tmp_path / "two.sqlite", more])
    mixed = fairway.compare([tmp_path / "two.sqlite", more], mixed=True)
    assert [cell["runs"] for cell in mixed["cells"]] == [1, 1]  # nothing is drawn, so all are the same run


def test_a_store_without_a_name_is_refused(campaign):
    with pytest.raises(fairway.InputError, match="out: expected the path of a results store, or None"):
        fairway.sweep(campaign, out="", algorithms={"mine": Mine})
