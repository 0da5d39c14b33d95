# SPDX-License-Identifier: BSD-3-Clause
"""Without a display: the package makes VTK draw, if it is imported first, and says so if not. An
interpreter without VTK, or with another one, is told what is needed."""

import os
import subprocess
import sys
import tempfile
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

    def check_other_vtk(self, module, message):
        """Import the package where vtkmodules is a folder with this module."""
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "vtkmodules"))
            for name, text in (("__init__", ""), ("vtkCommonCore", module)):
                with open(os.path.join(folder, "vtkmodules", name + ".py"), "w") as file:
                    file.write(text)
            done = run(f"import sys\nsys.path.insert(0, {folder!r})\nimport vtkssaopass\n")
        self.assertEqual(done.returncode, 1)
        self.assertIn("ImportError: vtkssaopass needs VTK", done.stderr)
        self.assertIn(message, done.stderr.splitlines()[-1])

    def test_no_vtk(self):
        self.check_other_vtk("raise ImportError('none here')", "has no VTK (none here)")

    def test_other_version(self):
        self.check_other_vtk(
            "class vtkVersion:\n"
            "    def GetVTKMajorVersion(self): return 8\n"
            "    def GetVTKMinorVersion(self): return 90\n",
            "has VTK 8.90",
        )


unittest.main()
