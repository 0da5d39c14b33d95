# SPDX-License-Identifier: BSD-3-Clause
"""Python draws what C++ draws: TestPythonPictures.py plain|vedo|pyvista PROGRAM [SCRIPT [MESH]]

PROGRAM is MinimalSSAO. Plain VTK runs SCRIPT, the same program in Python; vedo and PyVista draw the
same surface with VTK's material in plotters of their own. All take the same way through VTK and
OpenGL, so the pictures are the same to the bit.
"""

import os
import subprocess
import sys
import tempfile

from ssao_test_support import boy_actor, largest_difference, mean, read_picture, read_window

import vtkssaopass
from vtkmodules.vtkRenderingCore import vtkRenderWindow

SIZE = (800, 600)  # of MinimalSSAO
SAMPLES = vtkRenderWindow().GetMultiSamples()


def picture_of(command):
    """What a program draws that is called as MinimalSSAO is."""
    with tempfile.TemporaryDirectory() as folder:
        mesh = sys.argv[4:5]
        file = os.path.join(folder, "picture.png" if mesh else "minimal.png")
        subprocess.run(command + (mesh + [file] if mesh else []), cwd=folder, check=True)
        return read_picture(file)


def draw_plain():
    return picture_of([sys.executable, sys.argv[3]])


def draw_vedo():
    import vedo

    plotter = vedo.Plotter(offscreen=True, size=SIZE, bg="black")
    plotter.window.SetMultiSamples(SAMPLES)
    plotter.renderer.AddActor(boy_actor())
    ssao = vtkssaopass.enable_ambient_occlusion(plotter)
    plotter.show()
    assert plotter.renderer.GetPass() is ssao
    return read_window(plotter.window)


def draw_pyvista():
    import pyvista

    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE, lighting="none")
    plotter.background_color = "black"
    plotter.render_window.SetMultiSamples(SAMPLES)
    plotter.renderer.AddActor(boy_actor())
    plotter.renderer.AutomaticLightCreationOn()
    plotter.renderer.ResetCamera()
    plotter.camera_set = True  # PyVista would look from elsewhere
    ssao = vtkssaopass.enable_ambient_occlusion(plotter)
    plotter.show(auto_close=False)
    assert plotter.renderer.GetPass() is ssao
    return read_window(plotter.render_window)


def main():
    kind, program = sys.argv[1:3]
    expected = picture_of([program])
    picture = {"plain": draw_plain, "vedo": draw_vedo, "pyvista": draw_pyvista}[kind]()
    difference = largest_difference(picture, expected)
    print(f"mean {mean(picture):.3f}, in C++ {mean(expected):.3f}; largest difference {difference}")
    if difference != 0 or mean(expected) < 10:
        sys.exit("FAILED: the pictures are not the same, or show nothing")


main()
