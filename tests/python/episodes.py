# SPDX-License-Identifier: Apache-2.0
"""What tests of environments share: scenarios, whole episodes, and when two are the same."""

import numpy as np

from conftest import ROOT

CROSSING = ROOT / "scenarios" / "crossing.yaml"
SWAP = ROOT / "scenarios" / "swap_8.yaml"
CUBE = ROOT / "scenarios" / "cube20_4.yaml"
OBSTACLES = ROOT / "scenarios" / "static_obstacles.yaml"


def follow(env, choose, seed=1, steps=100_000):
    """An episode: everything that it showed."""
    shown = [env.reset(seed=seed)]
    for _ in range(steps):
        shown.append(env.step(choose(env)))
        if shown[-1][2] or shown[-1][3]:
            return shown
    return shown


def straight(env):
    """At full speed to the goal, whoever is in the way."""
    goal = np.atleast_2d(env.core.observations[0])[:, 6:9]
    actions = goal / np.maximum(np.linalg.norm(goal, axis=1, keepdims=True), 1e-9)
    return actions.reshape(env.action_space.shape).astype(np.float32)


def same(a, b):
    """To the bit, NaN being itself."""
    if isinstance(a, dict):
        assert a.keys() == b.keys()
        for key in a:
            same(a[key], b[key])
    elif isinstance(a, tuple):
        assert len(a) == len(b)
        for x, y in zip(a, b):
            same(x, y)
    else:
        assert np.asarray(a).dtype == np.asarray(b).dtype
        assert np.array_equal(np.asarray(a), np.asarray(b), equal_nan=np.asarray(a).dtype.kind == "f"), (a, b)


def actions_of(seed, shape, steps):
    """Drawn at random: steps x shape."""
    return np.random.default_rng(seed).uniform(-1, 1, (steps, *shape)).astype(np.float32)
