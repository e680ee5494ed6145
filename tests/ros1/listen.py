# SPDX-License-Identifier: Apache-2.0
"""What is heard in a graph, from the process of the tests. Whoever listens does so until close_all()."""

import json
import threading

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TwistStamped
from std_msgs.msg import String

from graph import wait_for


links = []  # publishers and subscribers that are to be closed


def close_all():
    while links:
        links.pop().unregister()


class Heard:
    """The messages of a topic since it began to listen, or since forget()."""

    def __init__(self, topic, kind):
        self.lock = threading.Lock()
        self.messages = []
        links.append(rospy.Subscriber(topic, kind, self.hear, queue_size=1000, tcp_nodelay=True))

    def hear(self, message):
        with self.lock:
            self.messages.append(message)

    def all(self):
        with self.lock:
            return list(self.messages)

    def last(self):
        with self.lock:
            return self.messages[-1] if self.messages else None

    def forget(self):
        with self.lock:
            self.messages = []


class Words(Heard):
    """A topic of JSON."""

    def __init__(self, topic):
        super().__init__(topic, String)

    def last(self):
        message = super().last()
        return json.loads(message.data) if message else None

    def wait(self, condition, seconds, what):
        """The first that meets the condition from now on."""

        def met():
            state = self.last()
            return state if state and condition(state) else None

        try:
            return wait_for(met, seconds, what)
        except AssertionError as error:
            raise AssertionError(f"{error}; last heard: {super().last()}") from None


class Simulated(Words):
    """The simulator's state."""

    def __init__(self):
        super().__init__("/fairway/state")

    def vehicle(self, name):
        state = self.last()
        return next(v for v in state["vehicles"] if v["name"] == name)

    def wait_until(self, time, seconds=60):
        self.wait(lambda s: s["time_s"] >= time, seconds, f"simulated time {time}")

    def now(self):
        return self.last()["time_s"]


class Diagnostics(Heard):
    def __init__(self, vehicle):
        self.vehicle = vehicle
        super().__init__("/diagnostics", DiagnosticArray)

    def statuses(self):
        return [s for array in self.all() for s in array.status if s.hardware_id == self.vehicle]

    def wait(self, words, level, seconds=10):
        """Until a status of that level holds these words."""

        def met():
            return next((s for s in self.statuses() if words in s.message and s.level == level), None)

        try:
            return wait_for(met, seconds, f"a diagnosis of level {level}: {words}")
        except AssertionError as error:
            raise AssertionError(f"{error}; heard {sorted({(s.level, s.message) for s in self.statuses()})}") from None


def commands(vehicle):
    return Heard(f"/{vehicle}/velocity_command", TwistStamped)


def speed(command):
    v = command.twist.linear
    return (v.x**2 + v.y**2 + v.z**2) ** 0.5


def avoider_status(vehicle):
    return Words(f"/{vehicle}/status")
