# SPDX-License-Identifier: Apache-2.0
"""What people and missions ask of an avoider: goals, paths, services, advice, limits, parameters."""

import math
import time

import pytest

import apart
import listen
from graph import rows_of, wait_for

OK = 0


@pytest.fixture
def alone(graph, tmp_path):
    """`left` steered by its avoider, `right` by nobody."""
    class Alone:
        def __init__(self):
            self.path = tmp_path / "apart.yaml"
            self.path.write_text(apart.SCENARIO)

        def start(self, **left):
            self.state = listen.Simulated()
            self.status = listen.avoider_status("left")
            self.commands = listen.commands("left")
            graph.avoider(str(self.path), "left", **left)
            graph.simulator(str(self.path), speed=2)
            self.state.wait_until(1.0)
            self.status.wait(lambda s: s["state"] == "under_way", 10, "under way")

    return Alone()


def test_orders_come_as_services_and_unusable_ones_are_refused_in_words(alone):
    import rospy
    from fairway_ros.srv import GoTo, Section
    from geometry_msgs.msg import Point
    from std_srvs.srv import Trigger

    alone.start()

    def call(name, kind, *arguments):
        return rospy.ServiceProxy("/left/" + name, kind)(*arguments)

    def state(name):
        return alone.status.wait(lambda s: s["state"] == name, 10, name)

    assert call("keep_position", Trigger).success
    state("keeping")
    wait_for(lambda: abs(alone.commands.last().twist.linear.x) < 0.1, 10, "it keeps its position")

    # ENU: x is east; it lies on a line north and turns to starboard
    answer = call("go_to", GoTo, Point(500, 0, -5), 0.4)
    assert answer.ok and answer.message == ""
    state("under_way")
    asked = alone.status.wait(lambda s: s["velocity_mps"][0] > 0.3, 10, "eastwards")
    assert math.hypot(*asked["velocity_mps"]) <= 0.4 + 1e-9

    assert call("section", Section, Point(0, 0, -5), Point(0, 900, -5), 0).ok
    alone.status.wait(lambda s: s["state"] == "under_way" and s["velocity_mps"][1] > 0.3, 10, "northwards")

    for place, speed, why in [
        (Point(math.nan, 0, -5), 0.4, "not a number"),
        (Point(0, 100, -5), -1.0, "speed"),
        (Point(0, 100, -5), math.inf, "speed"),
        (Point(0, 1e9, -5), 0.4, "refused"),
    ]:
        answer = call("go_to", GoTo, place, speed)
        assert not answer.ok and why in answer.message, answer
    assert alone.status.last()["state"] == "under_way", "what was refused changes nothing"
    assert not call("section", Section, Point(1, 1, -5), Point(1, 1, -5), 0.5).ok

    assert call("stand_by", Trigger).success
    state("idle")
    alone.commands.forget()
    time.sleep(0.4)
    assert alone.commands.all() == []


def test_a_goal_and_a_path_come_as_messages(alone):
    import rospy
    from geometry_msgs.msg import PoseStamped
    from nav_msgs.msg import Path

    alone.start(arrival_m=3.0)
    goals = rospy.Publisher("/left/goal", PoseStamped, queue_size=1)
    paths = rospy.Publisher("/left/path", Path, queue_size=1)
    wait_for(lambda: goals.get_num_connections() and paths.get_num_connections(), 10, "connected")

    def pose(east, north, frame="world"):
        stamped = PoseStamped()
        stamped.header.frame_id = frame
        stamped.pose.position.x, stamped.pose.position.y, stamped.pose.position.z = east, north, -5
        return stamped

    goals.publish(pose(-400, 0))
    alone.status.wait(lambda s: s["velocity_mps"][0] < -0.3, 10, "westwards")
    goals.publish(pose(400, 0, frame="base_link"))
    time.sleep(0.5)
    assert alone.status.last()["velocity_mps"][0] < -0.3, "a goal in another frame is not taken"

    path = Path()
    path.header.frame_id = "world"
    path.poses = [pose(400, 0), pose(400, 400)]
    paths.publish(path)
    alone.status.wait(lambda s: s["velocity_mps"][0] > 0.3, 10, "eastwards, to the path's first point")


def test_advice_commands_nobody(alone):
    import rosgraph
    from geometry_msgs.msg import TwistStamped

    advice = listen.Heard("/left/advice", TwistStamped)
    alone.start(advisory=True)
    wait_for(lambda: advice.last() and listen.speed(advice.last()) > 0.1, 10, "advice")
    assert alone.commands.all() == []
    publishers = dict(rosgraph.Master("/tests").getSystemState()[0])
    assert "/left/velocity_command" not in publishers
    assert alone.state.vehicle("left")["holding"]
    assert alone.status.last()["advisory"] is True


ONE_ABOVE_THE_OTHER = """fairway: 1
name: one_above_the_other
summary: two AUVs meet, one half a metre above the other
duration_s: 200
defaults:
  model: sparus2
  avoider: {algorithm: orca3d, time_horizon_s: 10}
  tracking: raw
  steering: {kind: proportional}
  radius_m: 2
  limits: {max_speed_mps: 0.5}
vehicles:
  - {name: upper, start: {position_m: [-12, 0, 5], yaw_deg: 0}, mission: [{transit: {position_m: [12, 0, 5]}}]}
  - {name: lower, start: {position_m: [12, 0, 5.5], yaw_deg: 180}, mission: [{transit: {position_m: [-12, 0, 5.5]}}]}
"""


def highest_and_deepest(graph, tmp_path, **limits):
    """Depths that the vehicles came to [m], by the recording."""
    path = tmp_path / "one_above_the_other.yaml"
    path.write_text(ONE_ABOVE_THE_OTHER)
    recording = str(tmp_path / "depths.mcap")
    for vehicle in ("upper", "lower"):
        graph.avoider(str(path), vehicle, lockstep=True, **limits)
    simulator = graph.simulator(str(path), speed=0, lockstep=True, wait_for_subscribers=2, record=recording)
    assert simulator.result(90) == 0, simulator.output()
    graph.clear()
    depths = [float(row["z_m"]) for row in rows_of(recording)]
    return min(depths), max(depths)


def test_depth_floor_and_ceiling_are_kept(graph, tmp_path):
    free = highest_and_deepest(graph, tmp_path)
    assert free[0] < 4.5 and free[1] > 6.0, "without a band one passes above the other"
    band = highest_and_deepest(graph, tmp_path, min_depth_m=4.8, max_depth_m=5.7)
    # commands do not lead out of the band; the hull runs on for as long as it takes to stop its heave
    assert band[0] >= 4.6 and band[1] <= 5.9


@pytest.mark.parametrize(
    "settings, words",
    [
        (dict(lockstpe=True), "lockstep"),
        (dict(algorithm="orca3"), "orca3d"),
        (dict(params__time_horizn_s=3.0), "time_horizon_s"),
        (dict(policy__own_stal_s=3.0), "own_stale_s"),
        (dict(policy__own_stale_s=-3.0), "own_stale_s"),
        (dict(frame="nwu"), "enu"),
        (dict(advisory="perhaps"), "perhaps"),
        (dict(vehicle="nobody"), "north_bound"),
        (dict(scenario="nowhere.yaml"), "nowhere.yaml"),
    ],
    ids=lambda value: ",".join(value) if isinstance(value, dict) else None,
)
def test_a_parameter_that_cannot_be_used_is_refused_with_the_nearest_name(graph, settings, words):
    settings = {**settings}
    scenario = settings.pop("scenario", "head_on")
    scenario = scenario if "." not in scenario else f"./{scenario}"
    avoider = graph.avoider(scenario, "north_bound", parameters=settings)
    assert avoider.result(20) == 2
    said = avoider.output().strip()
    assert words in said and len(said.splitlines()) == 1, said
