# SPDX-License-Identifier: Apache-2.0
"""fairway_sim alone: what it publishes is the plain run, to the bit where no frame is changed, and people can steer it."""

import math
import os
import subprocess

import pytest
import rospy
from geometry_msgs.msg import PoseStamped, TwistStamped
from nav_msgs.msg import Odometry
from rosgraph_msgs.msg import Clock
from std_srvs.srv import Trigger
from tf2_msgs.msg import TFMessage
from visualization_msgs.msg import Marker, MarkerArray

from graph import BIN, ROOT, parameter, rows_of, wait_for
from listen import Heard, Simulated

HEAD_ON = os.path.join(ROOT, "scenarios", "head_on.yaml")
VEHICLES = ("north_bound", "south_bound")


def command(name, *words):
    return subprocess.run([os.path.join(BIN, name), *words], capture_output=True, text=True)


def plain_run(folder, *words):
    """Rows of the plain run by nanosecond and vehicle, numbers as they are."""
    recording = str(folder / "plain.mcap")
    command("fairway", "run", HEAD_ON, "--out", recording, *words)
    return {(round(float(row["time_s"]) * 1e9), row["vehicle"]): row for row in rows_of(recording)}


def numbers(row, *names):
    return tuple(float(row[name]) for name in names)


def motion_of(odometry):
    p, q = odometry.pose.pose.position, odometry.pose.pose.orientation
    v, w = odometry.twist.twist.linear, odometry.twist.twist.angular
    return (p.x, p.y, p.z), (q.w, q.x, q.y, q.z), (v.x, v.y, v.z), (w.x, w.y, w.z)


def motion_in_ned(row):
    return (
        numbers(row, "x_m", "y_m", "z_m"),
        numbers(row, "qw_ratio", "qx_ratio", "qy_ratio", "qz_ratio"),
        numbers(row, "u_mps", "v_mps", "w_mps"),
        numbers(row, "p_radps", "q_radps", "r_radps"),
    )


def enu(motion):
    """By hand, apart from the node's own: half turns about (1, 1, 0)/sqrt(2) and about forward."""
    (n, e, d), (w, x, y, z), (u, v, s), (p, q, r) = motion
    h = math.sqrt(0.5)
    return (e, n, -d), (h * (w + z), h * (x + y), h * (x - y), h * (w - z)), (u, -v, -s), (p, -q, -r)


def stays(graph, **parameters):
    """A simulator that does not end with its run."""
    settings = dict(scenario=HEAD_ON, **parameters)
    return graph.start("sim", [os.path.join(BIN, "fairway_sim"), *(parameter(n, v) for n, v in settings.items())])


def call(service):
    rospy.wait_for_service(service, 20)
    return rospy.ServiceProxy(service, Trigger)()


@pytest.mark.parametrize("frame", ["ned", "enu"])
def test_odometry_is_that_of_the_plain_run_at_every_instant(graph, tmp_path, frame):
    rows = plain_run(tmp_path, "--set", "duration_s=40")
    heard = {name: Heard(f"/{name}/odometry", Odometry) for name in VEHICLES}
    truths = {name: Heard(f"/{name}/ground_truth", Odometry) for name in VEHICLES}
    clock = Heard("/clock", Clock)
    sim = graph.simulator(
        HEAD_ON, autonomous=True, frame=frame, speed=5, wait_for_subscribers=1, overrides="duration_s=40"
    )
    sim.result(60)
    instants = sorted({time for time, _ in rows})
    for name in VEHICLES:
        messages = {message.header.stamp.to_nsec(): message for message in heard[name].all()}
        assert [time for time in instants if time not in messages] == []
        assert len(messages) <= len(instants) + 1  # and where it ends
        for time in instants:
            expected = motion_in_ned(rows[time, name])
            if frame == "ned":
                assert motion_of(messages[time]) == expected
                continue
            for shown, wanted in zip(motion_of(messages[time]), enu(expected)):
                assert shown == pytest.approx(wanted, rel=0, abs=1e-9)
        assert messages[0].header.frame_id == "world"
        assert messages[0].child_frame_id == name
        # navigation is perfect in this scenario
        assert motion_of(truths[name].all()[-1]) == motion_of(heard[name].all()[-1])
    times = [message.clock.to_nsec() for message in clock.all()]
    assert times == sorted(times)
    assert set(times) - {times[-1]} <= set(instants)  # who is slow to hear it hears the newest
    assert len(set(times)) > len(instants) / 2


def test_the_summary_is_that_of_the_command(graph):
    plain = command("fairway", "run", HEAD_ON)
    sim = graph.simulator(HEAD_ON, autonomous=True, speed=0)
    assert sim.result(60) == 0
    measured = [line for line in plain.stdout.splitlines()[1:] if "decisions:" not in line]
    assert len(measured) > 20
    said = sim.output().splitlines()
    assert [line for line in measured if line not in said] == []


def test_an_expectation_that_fails_is_the_exit_code(graph):
    assert graph.simulator(HEAD_ON, autonomous=True, speed=0, overrides="duration_s=20").result(60) == 1


def test_it_pauses_steps_and_goes_on(graph):
    state = Simulated()
    stays(graph, autonomous=True, speed=1, paused=True)
    state.wait(lambda s: s["paused"] and s["scenario"] == "head_on", 20, "a paused simulator")
    assert state.now() == 0
    for _ in range(3):
        assert call("/fairway/step").success
    state.wait(lambda s: s["time_s"] == pytest.approx(0.15), 10, "three steps")
    assert call("/fairway/resume").success
    refused = call("/fairway/step")
    assert not refused.success and refused.message == "it is not paused"
    state.wait_until(1.0)
    assert call("/fairway/pause").success
    still = state.wait(lambda s: s["paused"], 10, "the pause")["time_s"]
    wait_for(lambda: state.last()["wall_s"] > 1, 10, "time on the wall")
    assert state.now() == pytest.approx(still, abs=0.051)


@pytest.mark.parametrize("speed", [4, 20])
def test_it_goes_at_the_speed_that_is_asked(graph, speed):
    state = Simulated()
    stays(graph, autonomous=True, speed=speed)
    first = state.wait(lambda s: s["time_s"] > 1 and not s["done"], 20, "the run")
    later = state.wait(lambda s: s["time_s"] > first["time_s"] + 2 * speed, 30, "two seconds of it")
    passed = {key: later[key] - first[key] for key in ("time_s", "wall_s", "behind_s")}
    # what a busy machine could not keep up with is said, and nothing else is missing
    assert passed["time_s"] / speed == pytest.approx(passed["wall_s"] - passed["behind_s"], abs=0.1)


def test_with_speed_0_it_goes_as_fast_as_it_can(graph):
    state = Simulated()
    stays(graph, autonomous=True, speed=0)
    done = state.wait(lambda s: s["done"], 40, "the end")
    assert done["time_s"] > 100
    assert done["wall_s"] < done["time_s"] / 10


def test_markers_show_vehicles_spheres_and_goals_and_tf_moves(graph):
    markers, transforms = Heard("/fairway/markers", MarkerArray), Heard("/tf", TFMessage)
    goals = {name: Heard(f"/{name}/goal", PoseStamped) for name in VEHICLES}
    state = Simulated()
    stays(graph, autonomous=True, speed=20)
    orange = lambda m: m.ns == "safety" and m.color.r > 0.8 and 0.4 < m.color.g < 0.6
    wait_for(lambda: any(orange(m) for a in markers.all() for m in a.markers), 30, "an orange sphere")
    last = markers.last().markers
    spaces = {name: [m for m in last if m.ns == name] for name in ("vehicles", "detection", "safety", "names", "goals", "trails")}
    assert {name: len(found) for name, found in spaces.items() if name != "goals"} == dict.fromkeys(
        ("vehicles", "detection", "safety", "names", "trails"), 2
    )
    assert [m.scale.x for m in spaces["detection"]] == [6, 6]
    assert [m.scale.x for m in spaces["safety"]] == [3, 3]
    assert {m.text for m in spaces["names"]} == set(VEHICLES)
    assert all(m.header.frame_id == "world" for m in last)
    hull = spaces["vehicles"][0]
    assert hull.type == Marker.TRIANGLE_LIST and len(hull.points) % 3 == 0
    corners = [(p.x, p.y, p.z) for p in hull.points]
    assert max(math.dist(a, b) for a in corners for b in corners) == pytest.approx(1.6, abs=0.01)
    assert {t.child_frame_id for m in transforms.all() for t in m.transforms} == set(VEHICLES)
    goal = goals["north_bound"].last().pose.position  # 30 north, 5 deep
    assert (goal.x, goal.y, goal.z) == (0, 30, -5)
    done = state.wait(lambda s: s["done"], 60, "the end")
    assert [v["phase"] for v in done["vehicles"]] == ["arrived", "arrived"]
    final = wait_for(lambda: not [m for m in markers.last().markers if m.ns == "goals" and m.action == Marker.ADD], 10, "no goals")
    assert final


def test_who_is_not_told_holds_and_who_is_goes(graph):
    state = Simulated()
    heard = Heard("/north_bound/odometry", Odometry)
    publisher = rospy.Publisher("/north_bound/velocity_command", TwistStamped, queue_size=10, tcp_nodelay=True)

    def tell(age):
        message = TwistStamped()
        message.header.stamp = heard.last().header.stamp - rospy.Duration(age)
        message.twist.linear.x = 0.4
        publisher.publish(message)

    stays(graph, speed=5, command_timeout_s=0.5)
    state.wait_until(5)
    assert state.vehicle("north_bound")["holding"]

    def goes_alone():
        tell(0)
        holding = [v["holding"] for v in state.last()["vehicles"]]
        return heard.last().twist.twist.linear.x > 0.3 and holding == [False, True]

    wait_for(goes_alone, 30, "it goes, and the other holds")
    state.wait(lambda s: s["vehicles"][0]["holding"], 20, "it holds")
    wait_for(lambda: abs(heard.last().twist.twist.linear.x) < 0.05, 20, "it stops")

    before = state.last()["refused_count"]
    tell(2.0)
    state.wait(lambda s: s["refused_count"] > before, 10, "an old command is refused")
    assert state.vehicle("north_bound")["holding"]
    publisher.unregister()


def test_lockstep_goes_on_without_those_who_do_not_answer_and_counts(graph):
    state = Simulated()
    stays(graph, speed=0, lockstep=True, lockstep_timeout_s=0.05)
    seen = state.wait(lambda s: s["missed_count"] >= 5, 20, "five instants without a command")
    assert seen["missed_count"] == pytest.approx(seen["time_s"] / 0.05, abs=2)


@pytest.mark.parametrize(
    "settings, words",
    [
        (["_sped:=3", "_scenario:=" + HEAD_ON], "sped: unknown setting; did you mean"),
        ([], "scenario: expected the file of a scenario"),
        (["_scenario:=nowhere.yaml"], "nowhere.yaml: cannot be read"),
        (["_scenario:=" + HEAD_ON, "_speed:=quick"], "speed: is \"quick\"; expected a number in [0"),
        (["_scenario:=" + HEAD_ON, "_frame:=nwu"], "frame: is \"nwu\"; expected one of enu, ned"),
        (["_scenario:=" + HEAD_ON, "_lockstep:=perhaps"], "lockstep: is \"perhaps\"; expected true or false"),
        (["_scenario:=" + HEAD_ON, "_seed:=-1"], "seed: is -1; expected a number in [0"),
        (["_scenario:=" + HEAD_ON, "_overrides:=duraton_s=3"], "did you mean duration_s?"),
        (["_scenario:=" + HEAD_ON, "_overrides:=duration_s"], "expected path=value"),
        (["_scenario:=" + HEAD_ON, "_record:=/nowhere/run.mcap"], "/nowhere/run.mcap"),
        (["_scenario:=" + HEAD_ON, "_autonomous:=true", "_lockstep:=true"], "expected one of the two"),
    ],
)
def test_what_it_cannot_use_is_said_in_one_line(graph, settings, words):
    process = graph.start("sim", [os.path.join(BIN, "fairway_sim"), *settings])
    assert process.result(20) == 2
    said = [line for line in process.output().splitlines() if line.startswith("fairway_sim: ")]
    assert len(said) == 1
    assert words in said[0]
