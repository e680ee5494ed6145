# SPDX-License-Identifier: Apache-2.0
"""Launch files: those that are ready are what make_launch prints, and roslaunch runs a fleet from one without a catkin workspace."""

import os
import subprocess

import pytest

from graph import BIN, ROOT

PACKAGES = os.path.join(os.path.dirname(BIN), "share")
MAKE_LAUNCH = os.path.join(PACKAGES, "fairway_ros", "launch", "make_launch")
READY = {2: "head_on", 4: "cube20_4", 8: "cube20_8"}


def roslaunch(graph, *words, seconds=120):
    environment = dict(graph.environment, ROS_PACKAGE_PATH=PACKAGES + ":/usr/share")
    return subprocess.run(["roslaunch", *words], env=environment, capture_output=True, text=True, timeout=seconds)


@pytest.mark.parametrize("count", READY)
def test_a_ready_launch_file_is_what_make_launch_prints(count):
    scenario = READY[count] + ".yaml"
    words = [os.path.join(ROOT, "scenarios", scenario), "--as", "$(find fairway_ros)/scenarios/" + scenario]
    made = subprocess.run([MAKE_LAUNCH, *words], capture_output=True, text=True, check=True).stdout
    with open(os.path.join(ROOT, f"ros/ros1/launch/fleet_{count}.launch"), encoding="utf-8") as ready:
        assert ready.read() == made


def test_there_is_an_avoider_for_each_vehicle(graph):
    nodes = roslaunch(graph, "--nodes", "fairway_ros", "fleet_8.launch").stdout.split()
    assert nodes == ["/fairway_sim", *(f"/robot{i}/avoider" for i in range(8)), "/rviz"]


def test_vehicles_of_other_names_get_their_topics_in_rviz(tmp_path):
    configuration = tmp_path / "made.rviz"
    scenario = os.path.join(ROOT, "scenarios", "head_on.yaml")
    made = subprocess.run([MAKE_LAUNCH, scenario, "--rviz", configuration], capture_output=True, text=True, check=True)
    assert f'args="-d {configuration}"' in made.stdout
    text = configuration.read_text()
    for vehicle in ("north_bound", "south_bound"):
        assert f"/{vehicle}/odometry" in text and f"/{vehicle}/sketch" in text
    assert "robot" not in text


def test_a_scenario_that_cannot_be_read_is_said_by_the_command():
    made = subprocess.run([MAKE_LAUNCH, "nowhere.yaml"], capture_output=True, text=True)
    assert made.returncode == 2
    assert "nowhere.yaml: cannot be read" in made.stderr


def test_a_launched_fleet_meets_and_arrives(graph):
    launched = roslaunch(graph, "fairway_ros", "fleet_2.launch", "rviz:=false", "until_done:=true", "speed:=20")
    assert "arrived_ratio            1" in launched.stdout, launched.stdout + launched.stderr
    assert "pair_collision_count     0" in launched.stdout
