# SPDX-License-Identifier: Apache-2.0
"""Launch files: make_launch writes them for any scenario, and roslaunch runs a fleet from one without a catkin workspace."""

import os
import shlex
import subprocess
import xml.etree.ElementTree

import yaml

from graph import BIN, ROOT

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


def renamed(folder, one, other):
    """A scenario of two that are called so."""
    with open(os.path.join(ROOT, "scenarios", "head_on.yaml"), encoding="utf-8") as file:
        scenario = yaml.safe_load(file)
    scenario["name"] = "a -- <b> & 'c'"
    scenario.pop("expect", None)
    for vehicle, name in zip(scenario["vehicles"], (one, other)):
        vehicle["name"] = name
    path = folder / "a scene.yaml"
    path.write_text(yaml.safe_dump(scenario))
    return path


def test_names_are_what_they_are_in_the_scenario(tmp_path):
    launch = tmp_path / "it's \"two\" -- of.launch"
    made = subprocess.run([MAKE_LAUNCH, renamed(tmp_path, "1.0", "<b> & \"c\""), launch], capture_output=True, text=True)
    assert made.returncode == 0, made.stderr
    loaded = roslaunch_parameters(launch)
    assert loaded["/vehicle_0/avoider/vehicle"] == "1.0"
    assert loaded["/_b_____c_/avoider/vehicle"] == "<b> & \"c\""
    assert loaded["/fairway_sim/scenario"] == str(tmp_path / "a scene.yaml")
    [rviz] = [node for node in xml.etree.ElementTree.parse(launch).getroot().iter("node") if node.get("name") == "rviz"]
    assert shlex.split(rviz.get("args")) == ["-d", "$(dirname)/it's \"two\" -- of.rviz"]


def roslaunch_parameters(launch):
    """As roslaunch reads the file."""
    import roslaunch.config

    os.environ["ROS_PACKAGE_PATH"] = PACKAGES + ":/usr/share"
    config = roslaunch.config.load_config_default([str(launch)], 11311, verbose=False)
    return {name: parameter.value for name, parameter in config.params.items()}


def test_what_roslaunch_would_work_out_is_refused(tmp_path):
    for name in ("$(env HOME)", " left"):
        made = subprocess.run(
            [MAKE_LAUNCH, renamed(tmp_path, name, "right"), tmp_path / "made.launch"], capture_output=True, text=True
        )
        assert made.returncode != 0 and "cannot stand in a launch file" in made.stderr, made.stderr
        assert not (tmp_path / "made.launch").exists()


def test_help_needs_no_master():
    for program in ("fairway_avoider", "fairway_sim"):
        environment = dict(os.environ, ROS_MASTER_URI="http://127.0.0.1:1")
        told = subprocess.run([os.path.join(BIN, program), "--help"], env=environment, capture_output=True, text=True, timeout=20)
        assert told.returncode == 0 and f"usage: {program} " in told.stdout and "lockstep" in told.stdout


def test_a_launched_fleet_meets_and_arrives(graph):
    launched = roslaunch(graph, "fairway_ros", "fleet_2.launch", "rviz:=false", "until_done:=true", "speed:=20")
    assert "arrived_ratio            1" in launched.stdout, launched.stdout + launched.stderr
    assert "pair_collision_count     0" in launched.stdout
