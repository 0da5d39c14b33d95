# SPDX-License-Identifier: BSD-3-Clause
"""The pass in vedo: python3 vedo_ssao.py [mesh [picture.png]]"""

import sys

import vtkssaopass  # before vedo: without a display it makes VTK draw into memory

import vedo

mesh = vedo.Mesh(sys.argv[1]) if len(sys.argv) > 1 else vedo.ParametricShape("Boy")
plotter = vedo.Plotter(offscreen=True, size=(800, 600))
vtkssaopass.enable_ambient_occlusion(plotter)
plotter.show(mesh)
plotter.screenshot(sys.argv[2] if len(sys.argv) > 2 else "vedo.png")
