# SPDX-License-Identifier: Apache-2.0
"""What Gymnasium would give: its classes where it is installed, else as much of them as an environment needs."""

from __future__ import annotations

from typing import Any

import numpy as np

__all__ = ["HAS_GYMNASIUM", "Box", "Env", "VectorEnv", "autoreset_next_step", "batch_box"]

try:
    from gymnasium import Env  # type: ignore[import]
    from gymnasium.spaces import Box  # type: ignore[import]
    from gymnasium.vector import VectorEnv  # type: ignore[import]

    HAS_GYMNASIUM = True
except ImportError:
    HAS_GYMNASIUM = False

    class Box:  # type: ignore[no-redef]
        """Arrays of one shape and type, each number between `low` and `high`."""

        def __init__(self, low: Any, high: Any, shape: tuple[int, ...] | None = None, dtype: Any = np.float32,
                     seed: int | None = None) -> None:
            given = np.shape(low) if shape is None else tuple(shape)
            self.dtype = np.dtype(dtype)
            self.low = np.broadcast_to(np.asarray(low, self.dtype), given).copy()
            self.high = np.broadcast_to(np.asarray(high, self.dtype), given).copy()
            self.shape = self.low.shape
            self._random = np.random.default_rng(seed)

        def seed(self, seed: int | None = None) -> int | None:
            """Begins the draws of sample() anew."""
            self._random = np.random.default_rng(seed)
            return seed

        def sample(self) -> np.ndarray[Any, Any]:
            """Uniform between bounds, normal where there are none, exponential from the one that there is."""
            below, above = np.isfinite(self.low), np.isfinite(self.high)
            low = np.where(below, self.low, 0.0)
            high = np.where(above, self.high, 0.0)
            tail = self._random.exponential(size=self.shape)
            drawn = np.where(below & above, self._random.uniform(np.minimum(low, high), np.maximum(low, high)),
                             self._random.normal(size=self.shape))
            drawn = np.where(below & ~above, low + tail, drawn)
            drawn = np.where(~below & above, high - tail, drawn)
            return np.clip(drawn, self.low, self.high).astype(self.dtype)

        def contains(self, x: Any) -> bool:
            """Whether `x` is an array of this shape, of a type that fits, within the bounds."""
            if not isinstance(x, np.ndarray) or x.shape != self.shape or not np.can_cast(x.dtype, self.dtype):
                return False
            return bool(np.all(x >= self.low) and np.all(x <= self.high))

        __contains__ = contains

        def __eq__(self, other: object) -> bool:
            return (isinstance(other, Box) and self.shape == other.shape and self.dtype == other.dtype
                    and np.array_equal(self.low, other.low) and np.array_equal(self.high, other.high))

        def __repr__(self) -> str:
            return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.dtype})"

    class _Base:
        """What the environments inherit without Gymnasium."""

        metadata: dict[str, Any] = {}
        render_mode: str | None = None
        spec = None
        _np_random: np.random.Generator | None = None
        _np_random_seed: int | None = None

        @property
        def np_random(self) -> np.random.Generator:
            """For the user: no environment draws from it."""
            if self._np_random is None:
                self._np_random = np.random.default_rng()
            return self._np_random

        def reset(self, *, seed: Any = None, options: dict[str, Any] | None = None) -> Any:
            if isinstance(seed, int):
                self._np_random = np.random.default_rng(seed)
                self._np_random_seed = seed

        @property
        def unwrapped(self) -> Any:
            return self

        def close(self) -> None:
            """Nothing is open."""

        def __enter__(self) -> Any:
            return self

        def __exit__(self, *_: Any) -> None:
            self.close()

    class Env(_Base):  # type: ignore[no-redef]
        """Of one environment."""

    class VectorEnv(_Base):  # type: ignore[no-redef]
        """Of several environments."""


def autoreset_next_step() -> Any:
    """Gymnasium's word for it, where it has one (since 1.1)."""
    try:
        from gymnasium.vector import AutoresetMode
    except ImportError:
        return "NextStep"
    return AutoresetMode.NEXT_STEP


def batch_box(space: Any, count: int) -> Any:
    """The space of `count` values of `space`, one after the other."""
    repeats = (count,) + (1,) * len(space.shape)
    return Box(np.tile(space.low, repeats), np.tile(space.high, repeats), dtype=space.dtype)
