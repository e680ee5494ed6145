# SPDX-License-Identifier: Apache-2.0
"""What `scripts/test NAME...` builds and runs, a line each:

    deps GROUP                  of scripts/deps
    build TARGET
    program TARGET FILTER       a program of tests, and which of them, as --gtest_filter has it
    page play                   scripts/web
    suite NAME                  tests/NAME/run

A name is a library (fairway/<name>), a folder in one, a program of tests of CMakeLists.txt, a test suite of GoogleTest, or a folder of
tests/; what several of them are called means all of these. One that nothing is called ends it with 2.
"""

import difflib
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SUITE_NEEDS = {  # of scripts/deps, and what is built beside the command
    "package": ("arm", "all"), "python": ("python", "fairway_python"), "ros1": ("ros1", "all"), "ros2": ("ros2", "all"),
    "web": ("web", ""), "mcap": ("web", ""), "live": ("web", ""), "cluster": ("cluster", "fairway_mpi"), "cli": ("", ""), "replay": ("", ""), "docs": ("", ""),
    "play": ("web wasm", ""),
}


def suites_in(files):
    """The GoogleTest suites of these files."""
    found = []
    for file in files:
        found += re.findall(r"^(?:TYPED_)?TEST(?:_F|_P|_SUITE)?\((\w+),", file.read_text(encoding="utf-8"), re.M)
    return list(dict.fromkeys(found))


def filter_of(suites):
    return ":".join(f"{suite}.*:*/{suite}.*:{suite}/*" for suite in suites)


def known_names():
    """By name, the lines that it stands for."""
    known = {}
    build_file = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    programs = re.findall(r"^fairway_test\((\w+)", build_file, re.M)
    for program in programs:
        known.setdefault(program, []).append(f"program {program}_test *")
    for test in sorted((ROOT / "fairway").rglob("*_test.cpp")):
        parts = test.relative_to(ROOT / "fairway").parts
        for folder in parts[1:-1]:
            known.setdefault(folder, [])
        for suite in suites_in([test]):
            known.setdefault(suite, []).append(f"program {parts[0]}_test {filter_of([suite])}")
    for folder in [path for path in (ROOT / "fairway").glob("*/**/") if path.parent != ROOT / "fairway" and path.name in known]:
        tests = sorted(folder.rglob("*_test.cpp"))
        library = folder.relative_to(ROOT / "fairway").parts[0]
        if tests:
            known[folder.name].append(f"program {library}_test {filter_of(suites_in(tests))}")
        if library in ("avoidance", "planning"):  # the laws of every avoider
            program = "laws" if library == "avoidance" else library
            known[folder.name].append(f"program {program}_test */{folder.name}:*/{folder.name}_*:*_{folder.name}")
    for suite, (deps, target) in SUITE_NEEDS.items():
        lines = [f"deps {group}" for group in deps.split()] + ["page play"] * (suite == "play") + ["build fairway"] + [f"build {target}"] * bool(target) + [f"suite {suite}"]
        known.setdefault(suite, []).extend(lines)
    return known


def main():
    known = known_names()
    lines = []
    for name in sys.argv[1:]:
        if name not in known:
            near = difflib.get_close_matches(name, known, 1, 0.3)
            folders = ", ".join(sorted(known_name for known_name in known if known_name.islower()))
            print(f"scripts/test: no test is called {name}" + (f"; did you mean {near[0]}?" if near else f"; known: {folders}"), file=sys.stderr)
            return 2
        lines += known[name]
    print("\n".join(dict.fromkeys(lines)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
