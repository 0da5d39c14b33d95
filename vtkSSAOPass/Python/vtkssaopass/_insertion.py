# SPDX-License-Identifier: BSD-3-Clause
"""Puts the pass into the chain of passes of a renderer, and takes it out."""

from typing import Any, Optional, Tuple

from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import vtkSSAAPass, vtkSSAOPass

from .vtkSSAOPass import vtkScreenSpaceAmbientOcclusionPass

_QUALITIES = {
    "fast": "SetQualityToFast",
    "balanced": "SetQualityToBalanced",
    "accurate": "SetQualityToAccurate",
}


def enable_ambient_occlusion(
    view: Any, radius: float = 0.0, quality: str = "balanced"
) -> vtkScreenSpaceAmbientOcclusionPass:
    """Draw a renderer with ambient occlusion, and return the pass that does it.

    The pass takes the place that VTK's vtkSSAOPass has, or would have: it replaces one, goes below
    supersampling and above all other passes, which it keeps. Called again, it changes the settings
    of the pass that is there.

    Programs that set passes later drop this one, so call it last: in PyVista after
    enable_anti_aliasing("ssaa"), enable_eye_dome_lighting and the like.

    Parameters
    ----------
    view
        A vtkRenderer, or what has one as its attribute "renderer", as plotters of PyVista and vedo
        have.
    radius
        Distance within which geometry occludes, in world units. 0 is automatic: a tenth of the
        diagonal of what is visible.
    quality
        "fast", "balanced" or "accurate".
    """
    renderer = _renderer_of(view)
    if quality not in _QUALITIES:
        raise ValueError(f"quality is {quality!r}, and may be one of {', '.join(_QUALITIES)}")
    if not 0.0 <= radius < float("inf"):
        raise ValueError(f"radius is {radius!r}, and may be 0 or more")

    owner, ssao = _find(renderer, vtkScreenSpaceAmbientOcclusionPass)
    if ssao is None:
        ssao = vtkScreenSpaceAmbientOcclusionPass()
        owner, replaced = _find(renderer, vtkSSAOPass)
        if replaced is not None:
            ssao.SetDelegatePass(replaced.GetDelegatePass())
            _release(replaced, renderer)
        else:
            owner = renderer
            while isinstance(_inner(owner), vtkSSAAPass):
                owner = _inner(owner)
            ssao.SetDelegatePass(_inner(owner))
        _set_inner(owner, ssao)
    getattr(ssao, _QUALITIES[quality])()
    ssao.SetRadius(radius)
    return ssao


def disable_ambient_occlusion(view: Any) -> None:
    """Take out the pass that enable_ambient_occlusion has put in, and leave all others."""
    renderer = _renderer_of(view)
    owner, ssao = _find(renderer, vtkScreenSpaceAmbientOcclusionPass)
    if ssao is not None:
        _release(ssao, renderer)
        _set_inner(owner, ssao.GetDelegatePass())


def _renderer_of(view: Any) -> vtkRenderer:
    renderer = view if isinstance(view, vtkRenderer) else getattr(view, "renderer", None)
    if not isinstance(renderer, vtkRenderer):
        raise TypeError(f"{type(view).__name__} is no vtkRenderer, and has no attribute 'renderer'")
    return renderer


def _release(found: Any, renderer: vtkRenderer) -> None:
    if renderer.GetRenderWindow() is not None:
        found.ReleaseGraphicsResources(renderer.GetRenderWindow())


def _inner(owner: Any) -> Any:
    """The pass that a renderer or a pass draws with."""
    if isinstance(owner, vtkRenderer):
        return owner.GetPass()
    return owner.GetDelegatePass() if hasattr(owner, "GetDelegatePass") else None


def _set_inner(owner: Any, inner: Any) -> None:
    if isinstance(owner, vtkRenderer):
        owner.SetPass(inner)
    else:
        owner.SetDelegatePass(inner)


def _find(renderer: vtkRenderer, wanted: type) -> Tuple[Any, Optional[Any]]:
    """The first pass of a class in the chain of the renderer, after the one that holds it."""
    owner: Any = renderer
    found = _inner(owner)
    while found is not None and not isinstance(found, wanted):
        owner, found = found, _inner(found)
    return owner, found
