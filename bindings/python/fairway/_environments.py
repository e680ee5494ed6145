# SPDX-License-Identifier: Apache-2.0
"""What the environments of fairway.gym share."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from fairway import _core
from fairway._spaces import Box

Array = np.ndarray[Any, Any]

#: What `info` has for each learner, and the attribute of FleetEnvironments that it comes from.
BY_LEARNER = {"rewards": "rewards", "goal_distance_m": "goal_distance", "separation_m": "separation",
              "clearance_m": "clearance", "deciding": "deciding", "arrived": "arrived", "stuck": "stuck",
              "collided": "collided"}

OPTIONS = """
    scenario:
        A file or a `fairway.Scenario`, drawn anew for each seed.
    learner:
        A vehicle's name, for one learner; several names; or None, for all vehicles. All others keep the avoiders
        of the scenario.
    tracks, obstacles:
        How many of the nearest are seen; None: as many as there are, 8 and 4 at most.
    axes:
        "ned", or "heading": ahead, to starboard, down. Of observations and actions alike.
    actions:
        "scaled": parts of the vehicle's greatest speed in the episode, clipped to [-1, 1]; "mps": [m/s].
    reward:
        Weights that differ from the usual ones, by name:
        progress (1): for each metre nearer to the end of the leg; arrival (10): once; collision (-50): each time
        that one begins; nearness (-1): for each second at the distance of a collision, falling to 0 at near_m
        (twice the safety distance of the scenario; between centres); time (-0.01): for each second.
    action_repeat:
        Decisions that one action is held for.
    end_on_collision:
        Whether a learner's collision ends the episode.
    skip_deployment:
        Whether an episode begins when the first learner is under way; until then vehicles act by themselves.
    overrides:
        {"vehicles[0].limits.max_speed_mps": 1.0}, as `--set` takes them.
    algorithms:
        Algorithms written in Python that the scenario names: {"mine": Mine}.

    An observation has for each learner, as float32 in SI units (`observation_names` lists them):

        velocity over ground (3), sin and cos of yaw, yaw rate, offset of the goal (3), cruise speed, depth, radius,
        of each track, nearest first: 1, relative position (3), velocity over ground (3), radius, age,
        of each obstacle, nearest first: 1, offset of its nearest point (3).

    Where there are fewer tracks or obstacles than places, zeros follow. It rests on what the vehicle believes and
    perceives; rewards rest on the truth. A vehicle that is not under way sees no tracks.

    An action is the desired velocity over ground (3), held to the vehicle's limits as every algorithm is. A step
    lasts for one decision of the scenario, times action_repeat.
"""


#: The largest seed, as of a scenario.
MOST_SEED = 2**64 - 1


def seed_of(seed: Any, count: int = 1) -> int:
    """The first of `count` seeds in a row. Raises InputError for what is no whole number, or out of range."""
    if isinstance(seed, (bool, np.bool_)) or not isinstance(seed, (int, np.integer)):
        raise _core.InputError(f"seed: expected a whole number in [0, {MOST_SEED}], got {seed!r}")
    if not 0 <= int(seed) <= MOST_SEED - (count - 1):
        row = "" if count == 1 else f" with {count - 1} more behind it"
        raise _core.InputError(f"seed: expected a whole number in [0, {MOST_SEED}]{row}, got {seed}")
    return int(seed)


def environments(scenario: Any, learner: str | Sequence[str] | None, reward: Mapping[str, float] | None,
                 algorithms: Mapping[str, Any] | None, **options: Any) -> _core.FleetEnvironments:
    """One or more, of what both kinds of environments are told."""
    learners = [] if learner is None else [learner] if isinstance(learner, str) else list(learner)
    return _core.FleetEnvironments(scenario, learners=learners, reward=dict(reward or {}),
                                   algorithms=None if algorithms is None else dict(algorithms), **options)


def spaces_of(core: _core.FleetEnvironments, is_single: bool, actions: str) -> tuple[Any, Any]:
    """Of observations and actions of one environment."""
    names = core.observation_names
    high = np.array([1.0 if name.endswith("_ratio") else np.inf for name in names], np.float32)
    low = np.array([0.0 if name.endswith("_present_ratio") else -1.0 for name in names], np.float32) * high
    fastest = np.ones(len(core.learners)) if actions == "scaled" else np.asarray(core.max_speeds)
    reach = np.repeat(fastest[:, None], 3, axis=1).astype(np.float32)
    if is_single:
        return Box(low, high, dtype=np.float32), Box(-reach[0], reach[0], dtype=np.float32)
    rows = (len(core.learners), 1)
    return Box(np.tile(low, rows), np.tile(high, rows), dtype=np.float32), Box(-reach, reach, dtype=np.float32)
