# SPDX-License-Identifier: BSD-3-Clause
"""What the Python tests share: a scene, and pictures that are read and compared."""

import vtkssaopass  # noqa: F401  before VTK

from vtkmodules.vtkCommonComputationalGeometry import vtkParametricBoy
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)


def boy_actor():
    """The surface that MinimalSSAO draws, with VTK's default material."""
    source = vtkParametricFunctionSource()
    source.SetParametricFunction(vtkParametricBoy())
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


class View:
    """A window with one renderer that shows the surface; plotters have the same attribute."""

    def __init__(self):
        self.renderer = vtkRenderer()
        self.renderer.AddActor(boy_actor())
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetMultiSamples(0)
        self.window.SetSize(200, 150)
        self.window.AddRenderer(self.renderer)

    def picture(self):
        self.window.Render()
        return read_window(self.window)


def read_window(window):
    """As MinimalSSAO reads it: the front buffer, which VTK multisamples otherwise than the back."""
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.Update()
    return channels(grab.GetOutput())


def channels(image):
    """Size and channels of a picture, without alpha."""
    scalars = image.GetPointData().GetScalars()
    values = bytes(memoryview(scalars).cast("B"))
    count = scalars.GetNumberOfComponents()
    if count == 4:
        values = bytes(value for i, value in enumerate(values) if i % 4 != 3)
    return image.GetDimensions(), values


def read_picture(file):
    reader = vtkPNGReader()
    reader.SetFileName(str(file))
    reader.Update()
    return channels(reader.GetOutput())


def mean(picture):
    return sum(picture[1]) / len(picture[1])


def largest_difference(first, second):
    """Over all channels, in grey levels; 256 if the sizes differ."""
    if first == second:
        return 0
    if first[0] != second[0]:
        return 256
    return max(abs(a - b) for a, b in zip(first[1], second[1]))
