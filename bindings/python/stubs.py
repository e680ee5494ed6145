# SPDX-License-Identifier: Apache-2.0
"""Writes the stubs of the module in PACKAGE/fairway to the file OUT: those of TEMPLATE, with the fields of values.

    stubs.py PACKAGE TEMPLATE OUT"""

import pathlib
import re
import sys

sys.path.insert(0, sys.argv[1])
from fairway import _core  # noqa: E402: it was built a moment ago

template = pathlib.Path(sys.argv[2]).read_text()
stubs = re.sub(r"class (\w+)\(_Value\):\n", lambda found: found[0] + getattr(_core, found[1])._stub, template)
pathlib.Path(sys.argv[3]).write_text(stubs)
