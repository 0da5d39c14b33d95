# SPDX-License-Identifier: BSD-3-Clause
"""The pass in a VTK program: python3 minimal_ssao.py [mesh.vtp [picture.png]]

Draws the same picture as MinimalSSAO, the program in C++.
"""

import sys

import vtkssaopass  # before VTK: without a display it makes VTK draw into memory

from vtkmodules.vtkCommonComputationalGeometry import vtkParametricBoy
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

if len(sys.argv) > 1:
    source = vtkXMLPolyDataReader()
    source.SetFileName(sys.argv[1])
else:
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(vtkParametricBoy())
mapper = vtkPolyDataMapper()
mapper.SetInputConnection(source.GetOutputPort())
actor = vtkActor()
actor.SetMapper(mapper)
renderer = vtkRenderer()
renderer.AddActor(actor)

ssao = vtkssaopass.enable_ambient_occlusion(renderer)

window = vtkRenderWindow()
window.SetOffScreenRendering(True)
window.SetSize(800, 600)
window.AddRenderer(renderer)
window.Render()
print("radius:", ssao.GetEffectiveRadius())

picture = vtkWindowToImageFilter()
picture.SetInput(window)
writer = vtkPNGWriter()
writer.SetInputConnection(picture.GetOutputPort())
writer.SetFileName(sys.argv[2] if len(sys.argv) > 2 else "minimal.png")
writer.Write()
