# SPDX-License-Identifier: Apache-2.0
"""Where the repository and its build are; tests run from anywhere."""

import os
import pathlib

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture
def scenarios():
    return ROOT / "scenarios"


@pytest.fixture
def fairway_command():
    """The command of the build, whose numbers the module's must equal."""
    command = pathlib.Path(os.environ.get("FAIRWAY_BUILD_DIR", ROOT / "build")) / "bin" / "fairway"
    assert command.exists(), f"{command}: build it first"
    return command
