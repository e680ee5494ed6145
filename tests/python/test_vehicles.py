# SPDX-License-Identifier: Apache-2.0
"""Vehicles: stepped, driven, and as open-loop trials."""

import copy
import math
import subprocess

import numpy as np
import pytest

import fairway as fw


def test_every_vehicle_says_what_it_is_and_moves():
    for info in fw.vehicles():
        assert info.title and info.source
        vehicle = fw.Vehicle(info.name)
        assert vehicle.name == info.name
        push = {actuator.name: actuator.high for actuator in vehicle.actuators if math.isfinite(actuator.high)}
        for _ in range(100):
            vehicle.step(push, 0.05)
        assert np.linalg.norm(vehicle.state.position) > 0, info.name
    assert {"sparus2", "kinematic", "otter"} <= {info.name for info in fw.vehicles()}


def test_steps_by_name_and_driving_by_rows_give_the_same_bits():
    names = [actuator.name for actuator in fw.Vehicle("sparus2").actuators]
    commands = np.random.default_rng(1).uniform(-5, 5, (50, len(names)))
    driven = fw.Vehicle("sparus2")
    states = driven.drive(commands, 0.05, current=[0.1, 0, 0])
    stepped = fw.Vehicle("sparus2")
    for row in commands:
        state = stepped.step(dict(zip(names, row)), 0.05, current=[0.1, 0, 0])
    assert states.shape == (51, 13)
    assert states[-1, :3].tolist() == state.position.tolist() == driven.state.position.tolist()
    assert states[-1, 3:7].tolist() == state.quaternion.tolist()
    assert states[-1, 7:10].tolist() == state.velocity.tolist()
    assert states[-1, 10:].tolist() == state.angular_velocity.tolist()


def test_an_actuator_that_is_not_named_stays_where_it_is():
    vehicle = fw.Vehicle("sparus2")
    first = vehicle.actuators[0].name
    vehicle.actuator_state = {first: 3.0}
    before = vehicle.actuator_state
    vehicle.step({}, 0.05)
    assert vehicle.actuator_state.tolist() == before.tolist() and before[0] == 3.0


@pytest.mark.parametrize(
    "water, message",
    [
        ({"current": [math.nan, 0, 0]}, "current: expected three finite numbers"),
        ({"current": [0, math.inf, 0]}, "current: expected three finite numbers"),
        ({"density": 0}, "density: expected kg/m3 above 0, got 0"),
        ({"density": -5}, "density: expected kg/m3 above 0, got -5"),
        ({"density": math.nan}, "density: expected kg/m3 above 0, got nan"),
    ],
)
def test_water_that_cannot_be_is_refused_and_moves_nothing(water, message):
    vehicle = fw.Vehicle("sparus2")
    for move in (lambda: vehicle.step({}, 0.05, **water), lambda: vehicle.drive(np.zeros((1, len(vehicle.actuators))), 0.05, **water)):
        with pytest.raises(fw.InputError) as raised:
            move()
        assert message in str(raised.value)
    assert np.isfinite(vehicle.state.position).all()


def test_a_state_is_of_finite_numbers():
    for given in ({"position": [math.nan] * 3}, {"velocity": [0, math.inf, 0]}, {"angular_velocity": [0, 0, math.nan]}):
        with pytest.raises(fw.InputError, match=f"State.{next(iter(given))}: is not finite"):
            fw.State(**given)
    for level in ({"yaw": math.nan}, {"surge": math.inf}):
        with pytest.raises(fw.InputError, match="finite"):
            fw.State.level([0, 0, 5], **level)


def test_a_copy_is_a_snapshot():
    vehicle = fw.Vehicle("kinematic")
    vehicle.state = fw.State.level([1, 2, 3], yaw=math.pi / 2, surge=0.5)
    snapshot = copy.copy(vehicle)
    vehicle.step({}, 1.0)
    assert snapshot.state.position.tolist() == [1, 2, 3]
    assert snapshot.state.yaw == pytest.approx(math.pi / 2)
    assert snapshot.state.velocity_ned == pytest.approx([0, 0.5, 0])


def test_a_trial_is_that_of_the_command_to_the_bit(fairway_command, tmp_path):
    times, port = [0.0, 7.3, 20.0], [10.0, 1 / 3, 0.0]
    columns = fw.trial(
        "sparus2", times, {"surge_port_n": port, "surge_starboard_n": [10, 10, 0]}, {"state.u_mps": 0.5}
    )
    lines = ["time_s,surge_port_n,surge_starboard_n"]
    lines += [f"{t!r},{p!r},{s!r}" for t, p, s in zip(times, port, [10, 10, 0])]
    (tmp_path / "in.csv").write_text("\n".join(lines) + "\n")
    subprocess.run(
        [fairway_command, "trial", "sparus2", "--inputs", tmp_path / "in.csv", "--out", tmp_path / "out.csv",
         "--set", "state.u_mps=0.5"],
        check=True,
    )  # fmt: skip
    rows = (tmp_path / "out.csv").read_text().split()
    assert list(columns) == rows[0].split(",")
    for i, row in enumerate(rows[1:]):
        assert [column[i] for column in columns.values()] == [float(cell) for cell in row.split(",")]
    assert columns["u_mps"][0] == 0.5


def test_lists_of_structs_are_lists_of_dicts():
    layout = [{"x_m": 1.0}, {"x_m": -1.0}]
    assert len(fw.Vehicle("minerva_transport", layout=layout).actuators) != len(fw.Vehicle("minerva").actuators)


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: fw.Vehicle("sparus"), "did you mean sparus2?"),
        (lambda: fw.Vehicle("sparus2", mas_kg=1), "unknown parameter; did you mean"),
        (lambda: fw.Vehicle("sparus2").step({"surge_prt_n": 1}, 0.1), "did you mean surge_port_n?"),
        (lambda: fw.Vehicle("sparus2").step([1, 2], 0.1), "actuators: expected"),
        (lambda: fw.Vehicle("sparus2").step({}, 0.0), "period: expected seconds above 0, got 0"),
        (lambda: fw.State(quaternion=[1, 1, 0, 0]), "State.quaternion: expected length 1, got 1.414"),
        (lambda: fw.trial("sparus2", [0, 1], {"surge_port": [1, 2]}), "surge_port: unknown column; did you mean surge_port_n?"),
        (lambda: fw.trial("sparus2", [0, 1], {}, {"state.u_mp": 1}), "unknown setting; did you mean state.u_mps?"),
    ],
)
def test_a_mistake_names_the_nearest(make, message):
    with pytest.raises(fw.InputError) as raised:
        make()
    assert message in str(raised.value)
