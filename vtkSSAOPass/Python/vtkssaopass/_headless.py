# SPDX-License-Identifier: BSD-3-Clause
"""Lets VTK draw without a display."""

import ctypes
import os
import sys
import warnings

from ._configuration import OSMESA_BEFORE_VTK, OSMESA_LIBRARY


def prepare() -> None:
    """Load the headless window if there is no display, so that vtkRenderWindow() makes it.

    A VTK that has none of its own must find the OpenGL functions of OSMesa, so the library has to
    be there, with global symbols, before VTK's.
    """
    library = os.path.join(os.path.dirname(__file__), OSMESA_LIBRARY)
    if os.environ.get("DISPLAY") or not os.path.exists(library):
        return
    if OSMESA_BEFORE_VTK and "vtkmodules.vtkRenderingOpenGL2" in sys.modules:
        warnings.warn(
            "there is no display, and VTK was imported before vtkssaopass, so it cannot draw; "
            "import vtkssaopass first",
            RuntimeWarning,
            stacklevel=3,
        )
        return
    try:
        ctypes.CDLL(library, mode=ctypes.RTLD_GLOBAL)
    except OSError as error:
        warnings.warn(f"no headless window: {error}", RuntimeWarning, stacklevel=3)
