# SPDX-License-Identifier: BSD-3-Clause
"""Tells early, and clearly, that the interpreter has no VTK, or another one."""

import sys

from ._configuration import VTK_VERSION


def check() -> None:
    """Fail unless the interpreter has the VTK that this package was built for."""
    needed = (
        f"vtkssaopass needs VTK {VTK_VERSION} as the distribution has it: "
        "its package python3-vtk9, and its interpreter, usually /usr/bin/python3"
    )
    try:
        import vtkmodules.vtkCommonCore as vtk
    except ImportError as error:
        raise ImportError(f"{needed}; {sys.executable} has no VTK ({error})") from error
    version = vtk.vtkVersion()
    found = f"{version.GetVTKMajorVersion()}.{version.GetVTKMinorVersion()}"
    if found != VTK_VERSION:
        raise ImportError(f"{needed}; {sys.executable} has VTK {found}, {vtk.__file__}")
