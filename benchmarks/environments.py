#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Vehicle-steps per second of one core from Python, in time of the processor: what others do on the same core does not count.

    PYTHONPATH=build/python benchmarks/environments.py
"""

import pathlib
import time

import numpy as np

from fairway.gym import FleetEnv, FleetVectorEnv

SWAP = pathlib.Path(__file__).resolve().parent.parent / "scenarios" / "swap_8.yaml"


def rate(env, vehicles, seconds=2.0):
    env.reset(seed=1)
    actions = np.random.default_rng(0).uniform(-1, 1, env.action_space.shape).astype(np.float32)
    steps, begin = 0, time.process_time()
    while time.process_time() - begin < seconds:
        result = env.step(actions)
        steps += 1
        if not isinstance(env, FleetVectorEnv) and (result[2] or result[3]):
            env.reset()
    return steps * vehicles / (time.process_time() - begin)


for model in ("kinematic", "sparus2"):
    options = {"overrides": {"vehicles[*].model": model}, "end_on_collision": False}
    alone = rate(FleetEnv(SWAP, **options), 8)
    vector = rate(FleetVectorEnv(SWAP, 32, threads=1, copy=False, **options), 32 * 8)
    print(f"{model}: {alone:.0f} alone, {vector:.0f} in a vector of 32")
