# SPDX-License-Identifier: Apache-2.0
"""Environments for reinforcement learning, with Gymnasium's interface.

Gymnasium need not be installed; where it is, the environments are its subclasses and their spaces its spaces.

    from fairway.gym import FleetEnv

    env = FleetEnv("scenarios/crossing.yaml", learner="north_bound")
    observation, info = env.reset(seed=1)
    while True:
        observation, reward, terminated, truncated, info = env.step(env.action_space.sample())
        if terminated or truncated:
            break

`FleetVectorEnv` runs many of them at once, on all cores.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from fairway import _core
from fairway._environments import BY_LEARNER, OPTIONS, Array, environments, seed_of, spaces_of
from fairway._render import picture
from fairway._spaces import HAS_GYMNASIUM, Env
from fairway.gym_vector import FleetVectorEnv

__all__ = ["FleetEnv", "FleetVectorEnv", "HAS_GYMNASIUM"]


class FleetEnv(Env):  # type: ignore[misc]
    __doc__ = """One or more vehicles of a scenario, told what to do from outside: `gymnasium.Env`.

    With `learner="auv_1"` observations have one dimension and actions three numbers. With more learners both have
    a row for each, in the order of `learners`; the reward is then the sum over them, and info["rewards"] has one
    for each.
""" + OPTIONS + """
    `info` has time_s, seed, and for each learner goal_distance_m, separation_m (least in the step, between
    centres), clearance_m (likewise, of its sphere from an obstacle), deciding (whether the next action is heeded),
    arrived, stuck and collided; at the end of an episode also `measures`, all that a run is measured by.

    terminated: all learners have arrived, or one has collided. truncated: time is up, or nobody goes on because
    those who have not arrived are stuck. The same seed and actions give the same bits.
    """

    metadata: dict[str, Any] = {"render_modes": ["rgb_array"], "render_fps": 20}

    def __init__(self, scenario: Any, learner: str | Sequence[str] | None = None, *, tracks: int | None = None,
                 obstacles: int | None = None, axes: str = "ned", actions: str = "scaled",
                 reward: Mapping[str, float] | None = None, action_repeat: int = 1, end_on_collision: bool = True,
                 skip_deployment: bool = True, overrides: Mapping[str, Any] | None = None,
                 algorithms: Mapping[str, Any] | None = None, render_mode: str | None = None) -> None:
        if render_mode not in (None, "rgb_array"):
            raise _core.InputError(f'render_mode: unknown "{render_mode}"; known: rgb_array')
        self.core = environments(scenario, learner, reward, algorithms, tracks=tracks, obstacles=obstacles, axes=axes,
                                 actions=actions, action_repeat=action_repeat, end_on_collision=end_on_collision,
                                 skip_deployment=skip_deployment, overrides=overrides, threads=1)
        self.render_mode = render_mode
        self.metadata = {**self.metadata, "render_fps": max(1, round(1.0 / self.core.period))}
        self._is_single = isinstance(learner, str)
        self.observation_space, self.action_space = spaces_of(self.core, self._is_single, actions)
        self._shape = self.action_space.shape
        self._observations: Array = self.core.observations[0, 0] if self._is_single else self.core.observations[0]
        self._views = {name: getattr(self.core, attribute)[0] for name, attribute in BY_LEARNER.items()}
        self._returns, self._time, self._seed = self.core.returns, self.core.time, self.core.seed
        self._terminated, self._truncated = self.core.terminated, self.core.truncated

    @property
    def learners(self) -> list[str]:
        """Names of the vehicles that learn, by row."""
        return self.core.learners

    @property
    def observation_names(self) -> list[str]:
        """Of the numbers that a learner sees; each ends in its unit."""
        return self.core.observation_names

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Begins an episode: with a seed, the run that `fairway run --seed` makes; without, the next one after the
        last seed that was given, or after the scenario's own. There are no options."""
        seeds = [] if seed is None else [seed_of(seed)]
        super().reset(seed=seeds[0] if seeds else None)
        self.core.reset(None, seeds)
        return self._observations.copy(), self._info()

    def step(self, action: Any) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """One decision of every learner. Raises ValueError for what is not finite or of another shape, and
        RuntimeError after the end of an episode."""
        if np.shape(action) != self._shape:
            raise _core.InputError(f"step: expected an action of shape {self._shape}, got {np.shape(action)}")
        self.core.step(action)
        return self._result()

    def step_commands(self, commands: Sequence[_core.Command]) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        """The same with a `fairway.Command` for each learner, as avoiders give them: they may hold, too."""
        self.core.step_commands(list(commands))
        return self._result()

    def situation(self, learner: int = 0) -> _core.Situation | None:
        """What an avoider would be shown in its place, or None while it is not to decide."""
        return self.core.situation(0, learner)

    def advice(self) -> Array:
        """What the learners' own avoiders of the scenario would do, as an action: a teacher to imitate. They
        remember, so ask at each step of an episode or at none. Raises InputError where one commands a heading or a
        turn rate, with which its vehicle would do other than with the velocity alone: advised_commands() says it."""
        advice: Array = self.core.advise()[0].reshape(self._shape)
        return advice.copy()

    def advised_commands(self) -> list[_core.Command]:
        """The same as commands for step_commands(), which makes just the run that the avoiders would make."""
        return self.core.advised_commands()

    def measures(self) -> dict[str, Any]:
        """What a run is measured by, of this episode so far: numbers of the fleet, arrays by vehicle."""
        return self.core.measures(0)

    def render(self) -> Array | None:
        """A picture of height x width x 3 bytes: the fleet from above, north up; vehicles as the circles that
        others keep clear of, learners filled, and their goals as crosses. None without render_mode."""
        if self.render_mode is None:
            return None
        positions, goals, radii = self.core.outline(0)
        return picture(positions, goals, radii, np.isin(self.core.vehicles, self.core.learners))

    def close(self) -> None:
        """Nothing is open."""

    def _result(self) -> tuple[Array, float, bool, bool, dict[str, Any]]:
        core = self.core
        terminated, truncated = bool(self._terminated[0]), bool(self._truncated[0])
        info = self._info()
        if terminated or truncated:
            info["measures"] = core.measures(0)
        return self._observations.copy(), float(self._returns[0]), terminated, truncated, info

    def _info(self) -> dict[str, Any]:
        if self._is_single:
            info = {name: view[0].item() for name, view in self._views.items()}
            del info["rewards"]
        else:
            info = {name: view.copy() for name, view in self._views.items()}
        info["time_s"] = float(self._time[0])
        info["seed"] = int(self._seed[0])
        return info
