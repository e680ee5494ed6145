# SPDX-License-Identifier: Apache-2.0
"""One graph for all tests of a process; each test has its own simulator and avoiders in it."""

import os

import pytest

import listen
from graph import Graph


@pytest.fixture(scope="session")
def master():
    graph = Graph()
    os.environ.update(
        ROS_MASTER_URI=graph.environment["ROS_MASTER_URI"], ROS_IP="127.0.0.1", ROSCONSOLE_CONFIG_FILE=""
    )
    os.environ.pop("ROS_HOSTNAME", None)
    import rospy

    rospy.init_node("tests", anonymous=True, disable_signals=True)
    yield graph
    rospy.signal_shutdown("done")
    graph.end()


@pytest.fixture
def graph(master, request):
    yield master
    if getattr(request.node, "failed", False):
        print(master.output())
    master.clear()
    listen.close_all()


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_makereport(item, call):
    outcome = yield
    if call.when == "call":
        item.failed = outcome.get_result().failed


def pytest_terminal_summary(terminalreporter):
    count = {name: len(terminalreporter.getreports(name)) for name in ("passed", "failed", "error")}
    terminalreporter.write_line(f"{count['passed']} passed, {count['failed'] + count['error']} failed")
