# SPDX-License-Identifier: Apache-2.0
"""Collision avoidance for marine robots."""

from fairway._core import *  # noqa: F401,F403
from fairway._core import __version__  # noqa: F401
