# SPDX-License-Identifier: Apache-2.0
"""The examples of the documents run: blocks of Python after <!-- python -->, those of one page in one program."""

import os
import re
import subprocess
import sys

import pytest

from conftest import ROOT

MARKED = re.compile(r"^<!-- python -->\n```python\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PAGES = [page for page in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))] if MARKED.search(page.read_text())]


def test_there_are_pages_with_examples():
    assert ROOT / "docs" / "python.md" in PAGES


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_the_examples_of_a_page_run(page, tmp_path):
    for folder in ("scenarios", "campaigns"):
        (tmp_path / folder).symlink_to(ROOT / folder)
    program = "\n".join(MARKED.findall(page.read_text()))
    import fairway

    package = os.path.dirname(os.path.dirname(fairway.__file__))
    ran = subprocess.run(
        [sys.executable, "-c", program], cwd=tmp_path, env={**os.environ, "PYTHONPATH": package},
        capture_output=True, text=True,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout
