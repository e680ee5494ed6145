# SPDX-License-Identifier: Apache-2.0
"""A ROS graph of its own on the loopback address: master, simulator and avoiders as child processes that end with it."""

import csv
import ctypes
import json
import os
import signal
import socket
import subprocess
import sys
import tempfile
import time
import xmlrpc.client

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
BIN = os.environ.get("FAIRWAY_BIN", os.path.join(ROOT, "build", "bin"))
SERVICES = os.path.join(os.path.dirname(BIN), "ros1", "python")
FLEET = {
    "cube20_4": [f"robot{i}" for i in range(4)],
    "cube20_8": [f"robot{i}" for i in range(8)],
    "head_on": ["north_bound", "south_bound"],
    "priority_wait": ["first", "second", "third"],
}

sys.path.insert(0, SERVICES)


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def wait_for(condition, seconds, what):
    """The first true value of condition(), asked again and again; AssertionError after so many seconds."""
    end = time.monotonic() + seconds
    while True:
        value = condition()
        if value:
            return value
        assert time.monotonic() < end, f"not within {seconds} s: {what}"
        time.sleep(0.02)


def end_with_parent():
    """In the child: nobody is left behind, whatever happens to this process."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)


def parameter(name, value):
    if isinstance(value, bool):
        value = str(value).lower()
    return f"_{name}:={value}"


class Process:
    """A child; its output is kept and shown when a test fails."""

    def __init__(self, name, command, environment):
        self.name = name
        self.log = tempfile.TemporaryFile("w+")
        self.child = subprocess.Popen(
            command, env=environment, stdout=self.log, stderr=subprocess.STDOUT, preexec_fn=end_with_parent
        )

    def output(self):
        self.log.seek(0)
        return self.log.read()

    def is_running(self):
        return self.child.poll() is None

    def signal(self, number):
        self.child.send_signal(number)

    def kill(self):
        if self.is_running():
            self.child.kill()
        self.child.wait()

    def end(self, seconds=5):
        """Politely, then not."""
        if self.is_running():
            self.child.send_signal(signal.SIGCONT)
            self.child.terminate()
        try:
            self.child.wait(seconds)
        except subprocess.TimeoutExpired:
            self.kill()

    def result(self, seconds):
        """Its exit status, when it has come to its end by itself; of one that has not, how far it came."""
        try:
            return self.child.wait(seconds)
        except subprocess.TimeoutExpired:
            self.end()
            raise AssertionError(f"{self.name} has not ended within {seconds} s: {self.output()}") from None


class Graph:
    """Everything that runs under one master."""

    def __init__(self, port=None):
        self.port = port or free_port()
        self.environment = dict(
            os.environ,
            ROS_MASTER_URI=f"http://127.0.0.1:{self.port}",
            ROS_IP="127.0.0.1",
            ROSCONSOLE_FORMAT="[${severity}] ${node}: ${message}",
            PYTHONPATH=SERVICES + ":" + os.environ.get("PYTHONPATH", ""),
        )
        self.environment.pop("ROS_HOSTNAME", None)
        self.processes = []
        self.master = None
        self.start_master()

    def start_master(self):
        self.master = Process("roscore", ["roscore", "-p", str(self.port)], self.environment)
        self.wait_for_master()
        subprocess.run(["rosparam", "set", "/use_sim_time", "true"], env=self.environment, check=True)

    def wait_for_master(self):
        def answers():
            with socket.socket() as probe:
                return probe.connect_ex(("127.0.0.1", self.port)) == 0

        wait_for(answers, 30, "the master answers")

    def kill_master(self):
        # roscore's children: the master itself, and rosout
        children = subprocess.run(
            ["ps", "-o", "pid=", "--ppid", str(self.master.child.pid)], capture_output=True, text=True
        ).stdout.split()
        for child in children:
            os.kill(int(child), signal.SIGKILL)
        self.master.kill()

    def start(self, name, command):
        process = Process(name, command, self.environment)
        self.processes.append(process)
        return process

    def simulator(self, scenario, **parameters):
        path = scenario if "/" in scenario else os.path.join(ROOT, "scenarios", scenario + ".yaml")
        settings = dict(scenario=path, until_done=True, **parameters)
        return self.start(
            "sim", [os.path.join(BIN, "fairway_sim"), *(parameter(n, v) for n, v in settings.items())]
        )

    def avoider(self, scenario, vehicle, remaps=(), parameters=None, **more):
        """Parameters as they are named, with __ for the / of a folder."""
        given = {**(parameters or {}), **more}
        settings = {name.replace("__", "/"): value for name, value in given.items()}
        if scenario:
            path = scenario if "/" in scenario else os.path.join(ROOT, "scenarios", scenario + ".yaml")
            settings = dict(scenario=path, **settings)
        command = [os.path.join(BIN, "fairway_avoider"), f"__ns:=/{vehicle}", "__name:=avoider"]
        return self.start(
            "avoider of " + vehicle,
            [*command, *remaps, *(parameter(name, value) for name, value in settings.items())],
        )

    def clear(self):
        """Ends all but the master."""
        for process in self.processes:
            process.end()
        self.processes = []
        self.forget_parameters()

    def forget_parameters(self):
        """A master keeps the private parameters of nodes that are gone, and the next of that name would have them."""
        server = xmlrpc.client.ServerProxy(self.environment["ROS_MASTER_URI"])
        _, _, names = server.getParamNames("/tests")
        for node in {"/".join(n.split("/")[:3]) for n in names if n.split("/")[2:3] == ["avoider"]}:
            server.deleteParam("/tests", node)
        if any(name.startswith("/fairway_sim/") for name in names):
            server.deleteParam("/tests", "/fairway_sim")

    def address_of(self, node):
        code, words, address = xmlrpc.client.ServerProxy(self.environment["ROS_MASTER_URI"]).lookupNode("/tests", node)
        assert code == 1, words
        return address

    def output(self):
        return "\n".join(f"--- {p.name}\n{p.output()}" for p in [self.master, *self.processes])

    def end(self):
        for process in self.processes:
            process.end()
        try:
            self.kill_master()
        except ProcessLookupError:
            pass


def measures(recording):
    """Of a recording, by the command: what a plain run of it prints, too."""
    text = subprocess.run(
        [os.path.join(BIN, "fairway"), "replay", recording, "--json"], capture_output=True, text=True, check=True
    ).stdout
    return json.loads(text)


def rows_of(recording):
    """Its CSV: a row for each vehicle at each frame, numbers as text."""
    text = subprocess.run(
        [os.path.join(BIN, "fairway"), "replay", recording, "--csv", "-"], capture_output=True, text=True, check=True
    ).stdout
    return list(csv.DictReader(text.splitlines()))


def states_of(recording):
    """Each vehicle's state in each frame: the command is not the avoider's there but what was asked of the vehicle's controller."""
    rows = rows_of(recording)
    kept = [n for n in rows[0] if not n.startswith("command_") and n not in ("mode", "astern")]
    return [[row[name] for name in kept] for row in rows]
