#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fits the bandwidths of the velocity loop to raja2024's published navigation times, and tests each fit on the data that it did not see.

For every pair of bandwidths it makes the published part of the cube study, and takes the deviation of APF's navigation times in the
parameter phase and in the comparison, as the root mean square of ln(measured / published). It prints both for every pair, and then what
the pair that is best on one comes to on the other, in both directions. One pair takes about half a minute on two cores.
"""

import argparse
import json
import math
import subprocess
import sys


def study(fairway: str, surge: float, yaw: float) -> list[dict]:
    """The published part under these bandwidths [rad/s]; heave goes with surge."""
    settings = {"surge": surge, "heave": surge, "yaw": yaw}
    overrides = [f"vehicles[*].autopilot.{axis}_bandwidth_radps={value}" for axis, value in settings.items()]
    command = [fairway, "study", "cubes", "--seeds", "0", "--json"]
    made = subprocess.run(command + [word for text in overrides for word in ("--set", text)], capture_output=True, check=True, text=True)
    return json.loads(made.stdout)["rows"]


def fit(rows: list[dict], is_parameter_phase: bool) -> tuple[float, int, int]:
    """Root mean square of ln(measured / published), how many are within 15 %, of how many."""
    ratios = [
        row["measured"] / row["published"]
        for row in rows
        if row["quantity"] == "navigation_time_s" and row["method"].startswith("apf") and row["mode"] == "as_coded"
        if (row["case"] == "tuning") == is_parameter_phase and row["published"]
    ]
    deviation = math.sqrt(sum(math.log(ratio) ** 2 for ratio in ratios) / len(ratios))
    return deviation, sum(abs(ratio - 1) <= 0.15 for ratio in ratios), len(ratios)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--fairway", default="build/bin/fairway")
    parser.add_argument("--surge", type=float, nargs="+", default=[0.3, 0.4, 0.6, 0.8, 1.2], help="of surge and heave [rad/s]")
    parser.add_argument("--yaw", type=float, nargs="+", default=[0.5, 0.7, 1.0, 1.4], help="[rad/s]")
    options = parser.parse_args()

    def shown(result: tuple[float, int, int]) -> str:
        return f"{result[0]:.3f}, {result[1]} of {result[2]}"

    found = {}
    print("| surge and heave | yaw | parameter phase | comparison |\n|---|---|---|---|")
    for surge in options.surge:
        for yaw in options.yaw:
            rows = study(options.fairway, surge, yaw)
            found[surge, yaw] = fit(rows, True), fit(rows, False)
            print(f"| {surge:g} | {yaw:g} | {shown(found[surge, yaw][0])} | {shown(found[surge, yaw][1])} |")
            sys.stdout.flush()

    print("\n| fitted on | bandwidths | there | tested on the other |\n|---|---|---|---|")
    for fitted, name in enumerate(("parameter phase", "comparison")):
        best = min(found, key=lambda pair: found[pair][fitted][0])
        print(f"| {name} | {best[0]:g}, {best[1]:g} | {shown(found[best][fitted])} | {shown(found[best][1 - fitted])} |")


if __name__ == "__main__":
    main()
