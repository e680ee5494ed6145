# SPDX-License-Identifier: Apache-2.0
"""A fleet from above, as an array of bytes."""

from __future__ import annotations

from typing import Any

import numpy as np

Array = np.ndarray[Any, Any]

SIDE = 480  # pixels
WATER, OTHER, LEARNER, GOAL = (246, 248, 250), (90, 105, 125), (20, 120, 220), (220, 90, 30)


def picture(positions: Array, goals: Array, radii: Array, learners: Array) -> Array:
    """Height x width x 3. Positions and goals are vehicles x 3 [m, NED], radii [m]; `learners` says who is one.
    All of them are inside, north up."""
    image = np.empty((SIDE, SIDE, 3), np.uint8)
    image[:] = WATER
    places = np.vstack([positions[:, :2], goals[:, :2]])
    middle = (places.min(axis=0) + places.max(axis=0)) / 2.0
    reach = max(float(np.abs(places - middle).max()), 1.0) + float(radii.max()) + 1.0
    axis = np.linspace(-reach, reach, SIDE)
    north, east = middle[0] - axis[:, None], middle[1] + axis[None, :]
    pixel = 2.0 * reach / SIDE
    for goal in goals:
        d_n, d_e = np.abs(north - goal[0]), np.abs(east - goal[1])
        image[(d_n < 7 * pixel) & (d_e < pixel) | (d_e < 7 * pixel) & (d_n < pixel)] = GOAL
    for position, radius, learns in zip(positions, radii, learners):
        distance = np.hypot(north - position[0], east - position[1])
        colour = LEARNER if learns else OTHER
        image[np.abs(distance - radius) < 1.5 * pixel] = colour
        image[distance < (max(radius, 3 * pixel) if learns else 3 * pixel)] = colour
    return image
