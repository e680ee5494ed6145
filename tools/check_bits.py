#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails where a run could ask the C library, Eigen or the standard library for what differs between them: sines and the like
are those of fairway/core/math.hpp, random numbers those of fairway/core/rng.hpp."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("fairway", "examples/own_method", "ros/bridge", "bindings")
NAMES = (
    "a?(?:sin|cos|tan)h?|atan2|sincos|exp(?:2|m1)?|log(?:1p|2|10|b)?|pow|cbrt|hypot|erfc?|[tl]gamma|fm(?:a|in|ax)|lerp|polar|beta"
)
FORBIDDEN = (
    (re.compile(rf"(?:\bstd::|(?<![\w:.>]))({NAMES})f?\("), "take it from fairway/core/math.hpp"),
    (re.compile(rf"\.({NAMES})\(\)"), "Eigen asks the C library: take it from fairway/core/math.hpp"),
    (re.compile(r"\b(AngleAxis|Rotation2D|slerp|angularDistance|eulerAngles)"), "Eigen asks the C library: see vec.hpp, state.hpp"),
    (re.compile(r"\bstd::(\w+_distribution|shuffle|sample|reduce)\b"), "it differs between libraries: see fairway/core/rng.hpp"),
    (re.compile(r"#include <(boost/math|ceres)/"), "nobody promises its bits"),
)
# Not what a run does: the functions themselves, intervals and tests of reports, marks that are drawn.
OUTSIDE = (
    "fairway/core/math.hpp",
    "fairway/core/math.cpp",
    "fairway/experiment/paired_tests.cpp",
    "fairway/experiment/ranks.cpp",
    "fairway/experiment/statistics.cpp",
    "fairway/experiment/survival.cpp",
    "ros/bridge/fleet_marks.cpp",
    "ros/bridge/hull_mesh.cpp",
)


def main() -> int:
    failures = 0
    for path in sorted(path for folder in FOLDERS for path in (ROOT / folder).rglob("*.[hc]pp")):
        name = str(path.relative_to(ROOT))
        if name.endswith("_test.cpp") or "testing" in path.parts or name in OUTSIDE:
            continue
        for number, line in enumerate(path.read_text().splitlines(), 1):
            for pattern, instead in FORBIDDEN:
                if found := pattern.search(line.split("//")[0]):
                    print(f"{name}:{number}: {found[1]} is not the same on every machine; {instead}")
                    failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
