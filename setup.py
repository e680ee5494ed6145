# SPDX-License-Identifier: Apache-2.0
"""Builds the module with CMake: pyproject.toml says the rest.

FAIRWAY_BUILD_DIR names a build folder that is there, or is to stay: what is compiled in it is not compiled again.
FAIRWAY_BUILD_JOBS is the number of compilers at once; all cores without it.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


def version() -> str:
    """As CMake's project() has it, the one place where it is said."""
    text = (ROOT / "CMakeLists.txt").read_text()
    found = re.search(r"project\(fairway VERSION ([0-9.]+)", text)
    if found is None:
        raise SystemExit("CMakeLists.txt: no project(fairway VERSION ...)")
    return found[1]


class CMakeBuild(build_ext):
    """Configures a build folder, unless it is one already, and builds the module alone."""

    def build_extension(self, ext: Extension) -> None:
        kept = os.environ.get("FAIRWAY_BUILD_DIR")
        folder = pathlib.Path(kept).resolve() if kept else pathlib.Path(self.build_temp).resolve() / "cmake"
        if not (folder / "CMakeCache.txt").exists():
            self.configure(folder)
        jobs = os.environ.get("FAIRWAY_BUILD_JOBS", str(os.cpu_count() or 1))
        subprocess.run(["cmake", "--build", folder, "--target", "fairway_python", "-j", jobs], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        for built in (folder / "python" / "fairway").glob("_core*"):  # the module and its stubs
            shutil.copyfile(built, target.parent / built.name)

    def configure(self, folder: pathlib.Path) -> None:
        choices = {
            "CMAKE_BUILD_TYPE": "Release",
            "FAIRWAY_TESTS": "OFF",
            "FAIRWAY_BENCHMARKS": "OFF",
            "FAIRWAY_PYTHON": "ON",
            "FAIRWAY_ROS1": "OFF",
            "FAIRWAY_ROS2": "OFF",
            "Python_EXECUTABLE": sys.executable,
        }
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        flags = [f"-D{name}={value}" for name, value in choices.items()]
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, *generator, *flags], check=True)


SCRATCH = ROOT / "build-pip"  # git ignores it, like every other build
SCRATCH.mkdir(exist_ok=True)
setup(
    version=version(),
    ext_modules=[Extension("fairway._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"build": {"build_base": str(SCRATCH)}, "egg_info": {"egg_base": str(SCRATCH)}},
)
