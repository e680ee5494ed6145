#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails if a folder includes one that tools/layers.toml does not let it see."""

import pathlib
import re
import sys
import tomllib

ROOT = pathlib.Path(__file__).resolve().parent.parent
INCLUDE = re.compile(r'^\s*#include "(?:fairway/)?((?:ros/|bindings/)?\w+)/', re.MULTILINE)


def main() -> int:
    layers = tomllib.loads((ROOT / "tools/layers.toml").read_text())
    seen = set()
    for library, uses in layers.items():
        if unknown := set(uses) - seen:
            sys.exit(f"layers.toml: {library} uses {unknown}, not declared above it")
        seen.add(library)

    failures = 0
    for library in layers:
        folder = ROOT / "fairway" / library
        for path in sorted((folder if folder.is_dir() else ROOT / library).rglob("*.[hc]pp")):
            if path.name.endswith("_test.cpp") or "testing" in path.parts:
                continue  # tests may look from anywhere
            for target in INCLUDE.findall(path.read_text()):
                if target in layers and target != library and target not in layers[library]:
                    print(f"{path.relative_to(ROOT)}: {library} must not include {target}")
                    failures += 1
    declared = {folder.name for folder in (ROOT / "fairway").iterdir() if folder.is_dir()}
    for library in sorted(declared - seen):
        print(f"layers.toml: fairway/{library} is not declared")
        failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
