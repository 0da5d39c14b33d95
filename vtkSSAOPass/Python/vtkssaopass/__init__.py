# SPDX-License-Identifier: BSD-3-Clause
"""Screen-space ambient occlusion for VTK, and for PyVista and vedo, which draw with VTK.

    import vtkssaopass  # before VTK, if there is no display
    ssao = vtkssaopass.enable_ambient_occlusion(plotter)

The pass has an automatic radius; help(vtkssaopass.vtkScreenSpaceAmbientOcclusionPass) tells what
else it has. Without a display (the variable DISPLAY is not set) importing this package first lets
VTK draw into memory by OSMesa, where the package was built with it.
"""

from . import _headless, _vtk

_headless.prepare()
_vtk.check()

from ._configuration import VERSION as __version__  # noqa: E402
from ._insertion import disable_ambient_occlusion, enable_ambient_occlusion  # noqa: E402
from .vtkSSAOPass import vtkScreenSpaceAmbientOcclusionPass  # noqa: E402

__all__ = [
    "disable_ambient_occlusion",
    "enable_ambient_occlusion",
    "vtkScreenSpaceAmbientOcclusionPass",
]
