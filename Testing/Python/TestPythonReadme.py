# SPDX-License-Identifier: BSD-3-Clause
"""The programs in the README run, and draw something that the pass has darkened."""

import os
import re
import subprocess
import sys
import tempfile
from importlib.util import find_spec

from ssao_test_support import mean, read_picture

with open(sys.argv[1], encoding="utf-8") as readme:
    programs = re.findall(r"```python\n(.*?)```", readme.read(), re.DOTALL)
assert len(programs) == 2, f"{len(programs)} programs"
for program in programs:
    package = re.search(r"^import (?!vtkssaopass)(\w+)", program, re.MULTILINE).group(1)
    if not find_spec(package):
        print(f"{package}: not installed, left out")
        continue
    means = []
    without, count = re.subn(r"\nvtkssaopass\.enable.*", "", program)
    assert count == 1, program
    for text in (program, without):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([sys.executable, "-c", text], cwd=folder, check=True)
            means.append(mean(read_picture(os.path.join(folder, "boy.png"))))
    print(f"{package}: mean {means[0]:.2f} with, {means[1]:.2f} without the pass")
    if not 0 < means[0] < means[1] - 0.5:
        sys.exit(f"FAILED: {package} draws nothing darker with the pass")
