# SPDX-License-Identifier: BSD-3-Clause
"""Without a display: the package makes VTK draw, if it is imported first, and says so if not."""

import subprocess
import sys
import unittest

from vtkssaopass._configuration import OSMESA_BEFORE_VTK

DRAW = """
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow
window = vtkRenderWindow()
window.AddRenderer(vtkRenderer())
window.Render()
print("drawn", window.GetSize())
"""


def run(program):
    return subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=False)  # fmt: skip


class TestPythonImportOrder(unittest.TestCase):
    def test_package_first(self):
        done = run("import vtkssaopass\nimport vtkmodules.all\n" + DRAW)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("drawn", done.stdout)

    @unittest.skipUnless(OSMESA_BEFORE_VTK, "this VTK has a headless window of its own")
    def test_package_too_late(self):
        done = run("import vtkmodules.vtkRenderingOpenGL2\nimport vtkssaopass\n")
        self.assertEqual(done.returncode, 0)
        self.assertIn("<string>:2: RuntimeWarning", done.stderr)
        self.assertIn("import vtkssaopass first", done.stderr)


unittest.main()
