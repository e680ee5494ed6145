#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fails on a source file without a licence line, or so long that a reader loses the thread."""

import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ("*.cpp", "*.hpp", "*.py", "*.ts", "*.mjs", "*.cmake", "scripts/*", ".ci/run", "CMakeLists.txt")
LONGEST = 450


def main() -> int:
    listing = ["git", "ls-files", "--cached", "--others", "--exclude-standard", "--deduplicate", *SOURCES]
    listed = subprocess.run(listing, cwd=ROOT, check=True, capture_output=True, text=True)
    failures = 0
    for name in listed.stdout.splitlines():
        if not (ROOT / name).is_file():
            continue  # deleted, and not committed yet
        text = (ROOT / name).read_text()
        if "SPDX-License-Identifier: Apache-2.0" not in "\n".join(text.splitlines()[:3]):
            print(f"{name}: no SPDX licence line in its first three lines")
            failures += 1
        if (lines := text.count("\n")) > LONGEST:
            print(f"{name}: {lines} lines; split it below {LONGEST}")
            failures += 1
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
