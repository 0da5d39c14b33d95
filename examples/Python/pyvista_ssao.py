# SPDX-License-Identifier: BSD-3-Clause
"""The pass in PyVista: python3 pyvista_ssao.py [mesh [picture.png]]"""

import sys

import vtkssaopass  # before PyVista: without a display it makes VTK draw into memory

import pyvista

mesh = pyvista.read(sys.argv[1]) if len(sys.argv) > 1 else pyvista.ParametricBoy()
plotter = pyvista.Plotter(off_screen=True, window_size=(800, 600))
plotter.add_mesh(mesh)
vtkssaopass.enable_ambient_occlusion(plotter)
plotter.show(screenshot=sys.argv[2] if len(sys.argv) > 2 else "pyvista.png")
