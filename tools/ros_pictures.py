#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The pictures of docs/ros.md: a fleet in RViz, and the recording of the same run in an independent viewer of MCAP.

Everything runs on the loopback address and on a display of its own, and ends with this program.
"""

import ctypes
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

from PIL import Image, ImageGrab

ROOT = pathlib.Path(__file__).resolve().parent.parent
IMAGES = ROOT / "docs/images"
SCENARIO = ROOT / "scenarios/cube20_8.yaml"
COUNT = 8
MOMENT_S = 110.0  # all eight in the middle of the cube, four of them near others
SIZE = (1440, 900)
DISPLAY = ":97"


def end_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)


class Stage:
    """Programs that are started here and ended together."""

    def __init__(self, folder):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            self.port = probe.getsockname()[1]
        self.environment = dict(
            os.environ,
            ROS_MASTER_URI=f"http://127.0.0.1:{self.port}",
            ROS_IP="127.0.0.1",
            ROS_HOME=folder,
            DISPLAY=DISPLAY,
            LIBGL_ALWAYS_SOFTWARE="1",
        )
        self.folder = folder
        self.programs = []

    def start(self, name, *words):
        log = open(os.path.join(self.folder, name + ".log"), "w", encoding="utf-8")
        self.programs.append(
            subprocess.Popen(words, env=self.environment, stdout=log, stderr=log, preexec_fn=end_with_parent)
        )
        return self.programs[-1]

    def ask(self, *words, seconds=30):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=seconds)

    def wait(self, condition, seconds, what):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end:
                sys.exit(f"ros_pictures: not within {seconds} s: {what}; logs: {self.folder}")
            time.sleep(0.05)

    def end(self):
        for program in reversed(self.programs):
            program.terminate()
        for program in self.programs:
            try:
                program.wait(10)
            except subprocess.TimeoutExpired:
                program.kill()


class Clock:
    """The run's time as the simulator tells it. rospy wants the master in the environment."""

    def __init__(self, stage):
        os.environ.update(ROS_MASTER_URI=stage.environment["ROS_MASTER_URI"], ROS_IP="127.0.0.1", ROS_HOME=stage.folder)
        import rospy
        from std_msgs.msg import String
        from std_srvs.srv import Trigger

        rospy.init_node("pictures", disable_signals=True)
        self.time = 0.0
        self.subscriber = rospy.Subscriber("/fairway/state", String, self.hear)
        self.pause = rospy.ServiceProxy("/fairway/pause", Trigger)
        self.resume = rospy.ServiceProxy("/fairway/resume", Trigger)

    def hear(self, message):
        self.time = json.loads(message.data)["time_s"]


def save(picture, name):
    picture = picture.convert("RGB")
    target = IMAGES / f"{name}.webp"
    picture.resize((SIZE[0] * 3 // 4, SIZE[1] * 3 // 4), Image.LANCZOS).save(target, quality=88, method=6)
    print(f"{name}: {target.stat().st_size // 1000} kB")


def photograph_rviz(stage, recording):
    nodes = ROOT / "build/bin"
    stage.start("xvfb", "Xvfb", DISPLAY, "-screen", "0", f"{SIZE[0]}x{SIZE[1]}x24", "-nolisten", "tcp")
    stage.start("roscore", "roscore", "-p", str(stage.port))
    stage.wait(lambda: stage.ask("rosparam", "set", "/use_sim_time", "true").returncode == 0, 60, "a master")
    stage.start("rviz", "rviz", "-d", str(ROOT / "build/share/fairway_ros/fleets/fleet_8.rviz"))
    for i in range(COUNT):
        stage.start(
            f"avoider{i}", str(nodes / "fairway_avoider"), f"__ns:=/robot{i}", "__name:=avoider",
            f"_scenario:={SCENARIO}", f"_vehicle:=robot{i}", "_draw:=true", "_lockstep:=true",
        )  # fmt: skip
    # spheres of 6 m, as in the larger cube: with 20 m nobody is seen for them
    sim = stage.start(
        "sim", str(nodes / "fairway_sim"), f"_scenario:={SCENARIO}", "_overrides:=exam.crit_dist_m=6", "_speed:=6",
        "_lockstep:=true", "_lockstep_timeout_s:=10", f"_wait_for_subscribers:={COUNT}", "_until_done:=true",
        f"_record:={recording}",
    )  # fmt: skip
    clock = Clock(stage)
    stage.wait(lambda: clock.time > MOMENT_S, 240, "the moment")
    clock.pause()
    time.sleep(6)  # RViz draws some pictures a second here
    save(ImageGrab.grab(xdisplay=DISPLAY), "rviz")
    clock.resume()
    stage.wait(lambda: sim.poll() is not None, 180, "the end of the run")
    return clock.time


def photograph_recording(folder, recording, end):
    picture = os.path.join(folder, "viewer.png")
    program = ROOT / "tools/mcap_viewer/picture.mjs"
    subprocess.run(["node", str(program), recording, str(MOMENT_S), str(end - 1.0), picture], check=True)
    save(Image.open(picture), "mcap_viewer")


def main():
    with tempfile.TemporaryDirectory(prefix="fairway-ros-pictures-") as folder:
        recording = os.path.join(folder, "fleet.mcap")
        stage = Stage(folder)
        try:
            end = photograph_rviz(stage, recording)
        finally:
            stage.end()
        photograph_recording(folder, recording, end)


if __name__ == "__main__":
    main()
