# SPDX-License-Identifier: Apache-2.0
"""Two vehicles side by side on a long way north, under ENU: time enough to do something to their data."""

import copy
import math

import rospy
from nav_msgs.msg import Odometry

import listen

SCENARIO = """fairway: 1
name: apart
summary: two AUVs side by side on a long way
duration_s: 5000
defaults:
  model: sparus2
  avoider: {algorithm: orca3d, time_horizon_s: 10}
  tracking: raw
  steering: {kind: proportional}
  radius_m: 2
  limits: {max_speed_mps: 0.5}
vehicles:
  - {name: left, start: {position_m: [0, 0, 5], yaw_deg: 0}, mission: [{transit: {position_m: [2000, 0, 5]}}]}
  - {name: right, start: {position_m: [0, 40, 5], yaw_deg: 0}, mission: [{transit: {position_m: [2000, 40, 5]}}]}
"""


class Relay:
    """Between the simulator and an avoider: hands on odometry as it is, or as `fault` makes it."""

    def __init__(self, vehicle):
        self.fault = None
        self.publisher = rospy.Publisher(f"/{vehicle}/relayed", Odometry, queue_size=1000, tcp_nodelay=True)
        subscriber = rospy.Subscriber(f"/{vehicle}/odometry", Odometry, self.hand_on, tcp_nodelay=True)
        listen.links += [self.publisher, subscriber]

    def hand_on(self, message):
        fault = self.fault
        if fault:
            message = fault(copy.deepcopy(message))
        if message:
            self.publisher.publish(message)


class Pair:
    """`left` gets its own odometry by a relay, and `right` hears of `left` by another."""

    def __init__(self, graph, folder, left=None, right=None, speed=2):
        path = folder / "apart.yaml"
        path.write_text(SCENARIO)
        self.own = Relay("left")
        self.others = Relay("right")
        self.state = listen.Simulated()
        self.status = listen.avoider_status("left")
        self.diagnostics = listen.Diagnostics("left")
        self.commands = listen.commands("left")
        graph.avoider(str(path), "left", ["odometry:=relayed", "/right/odometry:=/right/relayed"], **(left or {}))
        graph.avoider(str(path), "right", **(right or {}))
        self.simulator = graph.simulator(str(path), speed=speed, wait_for_subscribers=2)
        self.state.wait_until(2.0)
        self.in_state("under_way")

    def in_state(self, name, seconds=15):
        return self.status.wait(lambda s: s["state"] == name, seconds, f"state {name}")

    def count(self, name):
        return int(self.status.last()["values"][name])

    def settle(self):
        """Good data again, until nothing of a fault is left."""
        self.own.fault = self.others.fault = None
        self.in_state("under_way")
        self.diagnostics.forget()
        self.commands.forget()


def not_a_number(message):
    message.pose.pose.position.x = math.nan
    return message


def no_attitude(message):
    message.pose.pose.orientation.w = 7.0
    return message


def late_by(seconds):
    def fault(message):
        message.header.stamp -= rospy.Duration(seconds)
        return message

    return fault


def ahead_by(seconds):
    def fault(message):
        message.header.stamp += rospy.Duration(seconds)
        return message

    return fault


def frozen():
    held = []

    def fault(message):
        held.append(message.pose.pose.position)
        message.pose.pose.position = held[0]
        return message

    return fault


def moved_by(metres):
    def fault(message):
        message.pose.pose.position.x += metres
        return message

    return fault


def unsure_by(metres):
    def fault(message):
        covariance = [0.0] * 36
        covariance[0] = covariance[7] = metres**2
        message.pose.covariance = covariance
        return message

    return fault


def silent(_message):
    return None
