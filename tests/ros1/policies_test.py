# SPDX-License-Identifier: Apache-2.0
"""Bad data between the simulator and an avoider: each policy is seen in the commands, and reported."""

import time

import pytest

import apart
import listen
from graph import wait_for

OK, WARNING, ERROR = 0, 1, 2


@pytest.fixture(scope="module")
def pair(master, tmp_path_factory):
    yield apart.Pair(master, tmp_path_factory.mktemp("pair"))
    listen.close_all()
    master.clear()


@pytest.fixture
def settled(pair):
    pair.settle()
    return pair


FAULTS = {
    "invalid": apart.not_a_number,
    "backwards": apart.late_by(10),
    "ahead": apart.ahead_by(10),
    "frozen": apart.frozen(),
    None: apart.silent,
}


def is_silent(settled):
    """Whether no command comes for half a second."""
    settled.commands.forget()
    time.sleep(0.5)
    return settled.commands.all() == []


@pytest.mark.parametrize("verdict", FAULTS, ids=str)
def test_a_vehicle_without_good_navigation_holds_then_is_let_go_and_comes_back(settled, verdict):
    before = settled.count(f"own.{verdict}_count") if verdict else 0
    settled.own.fault = FAULTS[verdict]

    settled.in_state("holding")
    settled.diagnostics.wait("holding: own navigation is stale", ERROR)
    wait_for(lambda: listen.speed(settled.commands.last()) == 0.0, 5, "a command to stand still")

    settled.in_state("handed_back")
    settled.diagnostics.wait("handed back: own navigation is lost", ERROR)
    wait_for(lambda: is_silent(settled), 5, "no command any more; the last ones may still be on their way")
    assert settled.status.last()["in_charge"] is False
    assert settled.state.vehicle("left")["holding"]
    if verdict:
        assert settled.count(f"own.{verdict}_count") > before

    settled.own.fault = None
    settled.in_state("under_way")
    wait_for(lambda: settled.commands.last() and listen.speed(settled.commands.last()) > 0.2, 10, "it goes on")


def test_a_jump_is_refused_until_enough_agree(settled):
    before = settled.count("own.jumped_count")
    accepted = settled.count("own.accepted_count")
    settled.own.fault = apart.moved_by(50.0)
    settled.status.wait(lambda s: int(s["values"]["own.jumped_count"]) > before, 10, "a jump is counted")
    settled.status.wait(
        lambda s: int(s["values"]["own.accepted_count"]) > accepted + 20, 10, "the new position is believed"
    )
    assert settled.count("own.jumped_count") == before + 4, "the fifth that agrees is believed"
    settled.diagnostics.wait("under way", WARNING)
    # the way back is a jump as well
    settled.own.fault = None
    settled.status.wait(lambda s: int(s["values"]["own.jumped_count"]) == before + 8, 10, "believed again")


def test_a_neighbour_that_is_not_heard_grows_and_is_reported(settled):
    settled.others.fault = apart.silent
    settled.status.wait(lambda s: s["values"]["right.state"] == "stale", 10, "stale")
    grown = settled.status.wait(lambda s: float(s["values"]["right.growth_m"]) >= 0.5, 15, "growth")
    # growth_mps = 0.25 from neighbour_stale_s = 1 on
    late = float(grown["values"]["right.age_s"]) - 1.0
    assert float(grown["values"]["right.growth_m"]) == pytest.approx(0.25 * late, abs=0.02)
    assert grown["state"] == "under_way"
    settled.diagnostics.wait("under way", WARNING)
    settled.others.fault = None
    settled.status.wait(lambda s: float(s["values"]["right.growth_m"]) == 0.0, 10, "as large as it is")


def test_a_neighbour_that_tells_nonsense_is_not_believed(settled):
    before = settled.count("right.invalid_count")
    settled.others.fault = apart.no_attitude
    settled.status.wait(lambda s: int(s["values"]["right.invalid_count"]) > before, 10, "invalid")
    settled.diagnostics.wait("under way", WARNING)


def test_how_unsure_of_its_place_a_vehicle_is_reaches_its_avoider(settled):
    name = "own.position_sigma_m"
    assert settled.status.last()["values"][name] == "0.00"
    settled.own.fault = apart.unsure_by(0.4)
    settled.status.wait(lambda s: s["values"][name] == "0.40", 5, "what the covariance says")


def test_a_paused_simulation_is_no_alarm_and_no_reason_to_hold(settled):
    import rospy
    from std_srvs.srv import Trigger

    before = settled.status.last()["watchdog_count"]
    assert rospy.ServiceProxy("/fairway/pause", Trigger)().success
    time.sleep(2.5)
    paused = settled.status.last()
    assert rospy.ServiceProxy("/fairway/resume", Trigger)().success
    assert paused["state"] == "under_way"
    assert paused["watchdog_count"] == before
    assert [s.message for s in settled.diagnostics.statuses() if s.level == ERROR] == []
