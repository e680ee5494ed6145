# SPDX-License-Identifier: Apache-2.0
"""A small program that `mypy --strict` must accept: what the stubs promise is used as a reader would."""

import numpy as np
import numpy.typing as npt

import fairway as fw


class Straight:
    """An algorithm of one's own."""

    def __init__(self, gain: float = 1.0) -> None:
        self.gain = gain

    def decide(self, situation: fw.Situation) -> fw.Command:
        return fw.Command(velocity=self.gain * situation.preferred_velocity, mode=fw.Mode.cruise)


def nearest_distance(situation: fw.Situation) -> float:
    gaps = situation.track_positions - situation.own.position
    return float(np.linalg.norm(gaps, axis=1).min(initial=np.inf))


def main(file: str) -> npt.NDArray[np.float64]:
    scenario = fw.Scenario.load(file, overrides={"duration_s": 10}, seed=3).with_algorithm("straight", gain=0.5)
    run = fw.run(scenario, algorithms={"straight": Straight}, trajectories=True)
    assert run.trajectories is not None
    batch = fw.run_batch([scenario], seeds=range(3), algorithms={"straight": Straight})
    separation: npt.NDArray[np.float64] = batch.fleet["min_separation_m"]
    return separation


def campaign(file: str, recording: fw.Recording) -> str:
    results = fw.sweep(file, out="results.sqlite", jobs=2, algorithms={"straight": Straight})
    compared = fw.compare([results, "more.sqlite"], baseline="straight", quantities=["makespan_s"])
    why = fw.explain(recording, vehicle=recording.names[0], time=10.0, algorithms={"straight": Straight})
    page: str = fw.view(recording, sketch=True, algorithms={"straight": Straight})
    return f"{results.made} of {len(results)}: {compared['baseline']}, {why['headline']}, {page}"


def decide(avoider: fw.Avoider) -> str:
    own = fw.Ownship(position=[0, 0, 5], velocity=(0.5, 0, 0))
    other = fw.Track(id=1, position=np.array([10.0, 0.5, 5.0]))
    situation = fw.Situation(own=own, goal=fw.Goal([50, 0, 5], 0.5), period=0.1, tracks=[other])
    command = avoider.decide(situation)
    return f"{command.mode.name} {command.velocity[0]:.3f} {nearest_distance(situation):.1f}"


if __name__ == "__main__":
    print(decide(fw.Avoider("orca3d", seed=1, time_horizon_s=10)))
