# SPDX-License-Identifier: Apache-2.0
"""Many environments at once; import FleetVectorEnv from fairway.gym."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from fairway import _core
from fairway._environments import BY_LEARNER, OPTIONS, Array, environments, seed_of, spaces_of
from fairway._spaces import VectorEnv, autoreset_next_step, batch_box


class FleetVectorEnv(VectorEnv):  # type: ignore[misc]
    __doc__ = """`num_envs` environments of one scenario, stepped together: `gymnasium.vector.VectorEnv`.

    Arrays have the environments as their first dimension: with one learner observations are num_envs x numbers and
    actions num_envs x 3; with more there are rows between, num_envs x learners x numbers. Rewards are num_envs, the
    sums over learners; infos["rewards"] has one for each.

    The interpreter's lock is released while environments step, on `threads` threads; results are the same on any
    number of them.

    Episodes begin anew by Gymnasium 1.0's NEXT_STEP: the step after the end of an episode ignores its action, returns
    the first observation of the next episode, a reward of 0 and neither terminated nor truncated.
""" + OPTIONS + """
    num_envs:
        How many.
    threads:
        That step; 0: as many as the machine has.
    copy:
        Whether what is returned may be kept. If not, the next step overwrites it.

    `infos` has arrays over environments, or environments and learners, as FleetEnv has numbers, each `name` with the
    mask `_name`; where episodes have just ended also `measures`, whose mask `_measures` says in which.
    """

    metadata: dict[str, Any] = {"render_modes": [], "autoreset_mode": autoreset_next_step()}

    def __init__(self, scenario: Any, num_envs: int, learner: str | Sequence[str] | None = None, *,
                 threads: int = 0, tracks: int | None = None, obstacles: int | None = None, axes: str = "ned",
                 actions: str = "scaled", reward: Mapping[str, float] | None = None, action_repeat: int = 1,
                 end_on_collision: bool = True, skip_deployment: bool = True,
                 overrides: Mapping[str, Any] | None = None, algorithms: Mapping[str, Any] | None = None,
                 copy: bool = True) -> None:
        if num_envs < 1:
            raise _core.InputError(f"num_envs is {num_envs}; it is at least 1")
        self.core = environments(scenario, learner, reward, algorithms, tracks=tracks, obstacles=obstacles, axes=axes,
                                 actions=actions, action_repeat=action_repeat, end_on_collision=end_on_collision,
                                 skip_deployment=skip_deployment, overrides=overrides, threads=threads,
                                 count=num_envs, autoreset=True)
        self.num_envs = num_envs
        self.copy = copy
        self.closed = False
        self._is_single = isinstance(learner, str)
        self.single_observation_space, self.single_action_space = spaces_of(self.core, self._is_single, actions)
        self.observation_space = batch_box(self.single_observation_space, num_envs)
        self.action_space = batch_box(self.single_action_space, num_envs)
        self._shape = self.action_space.shape
        core = self.core
        self._observations = core.observations[:, 0] if self._is_single else core.observations
        self._results = (core.returns, core.terminated, core.truncated)
        self._views = {"time_s": core.time, "seed": core.seed}
        for name, attribute in BY_LEARNER.items():
            view = getattr(core, attribute)
            self._views[name] = view[:, 0] if self._is_single else view
        self._everywhere = np.ones(num_envs, bool)

    @property
    def learners(self) -> list[str]:
        """Names of the vehicles that learn, by row."""
        return self.core.learners

    @property
    def observation_names(self) -> list[str]:
        """Of the numbers that a learner sees; each ends in its unit."""
        return self.core.observation_names

    def reset(self, *, seed: int | Sequence[int | None] | None = None,
              options: dict[str, Any] | None = None) -> tuple[Array, dict[str, Any]]:
        """Begins episodes in all environments, or where options["reset_mask"] is true. A seed is that of the first
        environment, and the next have the next ones; or a list of one each."""
        seeds: list[int | None] = []
        if isinstance(seed, (Sequence, np.ndarray)) and not isinstance(seed, (str, bytes)):
            seeds = [None if each is None else seed_of(each) for each in seed]
        elif seed is not None:
            first = seed_of(seed, self.num_envs)
            seeds = [first + i for i in range(self.num_envs)]
        super().reset(seed=seeds[0] if isinstance(seed, (int, np.integer)) else None)
        self.core.reset((options or {}).get("reset_mask"), seeds)
        return self._shown(self._observations), self._infos()

    def step(self, actions: Any) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """One decision of every learner. Raises ValueError for what is not finite or of another shape, and no
        environment has stepped then."""
        if np.shape(actions) != self._shape:
            raise _core.InputError(f"step: expected actions of shape {self._shape}, got {np.shape(actions)}")
        self.core.step(actions)
        return self._result()

    def step_commands(self, commands: Sequence[_core.Command]) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        """The same with a `fairway.Command` for each learner, those of one environment after those of another."""
        self.core.step_commands(list(commands))
        return self._result()

    def advice(self) -> Array:
        """What the learners' own avoiders of the scenario would do, as actions: teachers to imitate. They remember,
        so ask at each step or at none. Raises InputError where one commands a heading or a turn rate, with which its
        vehicle would do other than with the velocity alone: advised_commands() says it."""
        return self.core.advise().reshape(self._shape).copy()

    def advised_commands(self) -> list[_core.Command]:
        """The same as commands for step_commands(), which makes just the runs that the avoiders would make."""
        return self.core.advised_commands()

    def render(self) -> None:
        """Nothing: render a FleetEnv."""

    def close(self, **_: Any) -> None:
        """Nothing is open."""
        self.closed = True

    def _shown(self, array: Array) -> Array:
        return array.copy() if self.copy else array

    def _result(self) -> tuple[Array, Array, Array, Array, dict[str, Any]]:
        rewards, terminated, truncated = self._results
        infos = self._infos()
        ended = terminated | truncated
        if ended.any():
            infos["measures"], infos["_measures"] = self._measures(ended), ended
        return (self._shown(self._observations), self._shown(rewards), self._shown(terminated),
                self._shown(truncated), infos)

    def _infos(self) -> dict[str, Any]:
        infos: dict[str, Any] = {}
        for name, view in self._views.items():
            infos[name], infos["_" + name] = self._shown(view), self._everywhere
        return infos

    def _measures(self, ended: Array) -> dict[str, Array]:
        all_measures: dict[str, Array] = {}
        for index in np.flatnonzero(ended):
            for quantity, value in self.core.measures(int(index)).items():
                if quantity not in all_measures:
                    all_measures[quantity] = np.full((self.num_envs, *np.shape(value)), np.nan)
                all_measures[quantity][index] = value
        return all_measures
