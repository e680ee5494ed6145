# SPDX-License-Identifier: Apache-2.0
"""Launch files: make_launch writes them for any scenario, and roslaunch runs a fleet from one without a catkin workspace."""

import os
import subprocess

from graph import BIN

PACKAGES = os.path.join(os.path.dirname(BIN), "share")
MAKE_LAUNCH = os.path.join(PACKAGES, "fairway_ros", "launch", "make_launch")


def roslaunch(graph, *words, seconds=120):
    environment = dict(graph.environment, ROS_PACKAGE_PATH=PACKAGES + ":/usr/share")
    return subprocess.run(["roslaunch", *words], env=environment, capture_output=True, text=True, timeout=seconds)


def test_there_is_an_avoider_for_each_vehicle(graph):
    nodes = roslaunch(graph, "--nodes", "fairway_ros", "fleet_8.launch").stdout.split()
    assert nodes == ["/fairway_sim", *(f"/robot{i}/avoider" for i in range(8)), "/rviz"]


def test_vehicles_get_their_topics_in_rviz():
    with open(os.path.join(PACKAGES, "fairway_ros", "fleets", "fleet_2.rviz"), encoding="utf-8") as configuration:
        text = configuration.read()
    for vehicle in ("north_bound", "south_bound"):
        assert f"/{vehicle}/odometry" in text and f"/{vehicle}/sketch" in text
    assert "robot" not in text


def test_a_scenario_that_cannot_be_read_is_said_by_the_command(tmp_path):
    made = subprocess.run([MAKE_LAUNCH, "nowhere.yaml", tmp_path / "made.launch"], capture_output=True, text=True)
    assert made.returncode == 2
    assert "nowhere.yaml: cannot be read" in made.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_launched_fleet_meets_and_arrives(graph):
    launched = roslaunch(graph, "fairway_ros", "fleet_2.launch", "rviz:=false", "until_done:=true", "speed:=20")
    assert "arrived_ratio            1" in launched.stdout, launched.stdout + launched.stderr
    assert "pair_collision_count     0" in launched.stdout
