# SPDX-License-Identifier: BSD-3-Clause
"""enable_ambient_occlusion puts the pass where VTK's own would go; disable takes it out again."""

import unittest

from ssao_test_support import View, largest_difference, mean

import vtkssaopass
from vtkmodules.vtkRenderingCore import vtkRenderer
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkOpenGLFXAAPass,
    vtkRenderStepsPass,
    vtkSSAAPass,
    vtkSSAOPass,
)
from vtkssaopass import disable_ambient_occlusion, enable_ambient_occlusion

PASS = vtkssaopass.vtkScreenSpaceAmbientOcclusionPass


def chain(renderer):
    """The names of the passes of a renderer, from the outside in."""
    names = []
    found = renderer.GetPass()
    while found is not None:
        names.append(found.GetClassName())
        found = found.GetDelegatePass() if hasattr(found, "GetDelegatePass") else None
    return names


def stacked(*passes):
    for outer, inner in zip(passes, passes[1:]):
        outer.SetDelegatePass(inner)
    return passes[0]


class TestPythonHelper(unittest.TestCase):
    def test_draws_as_the_pass_set_by_hand(self):
        by_hand, by_helper = View(), View()
        plain = by_helper.picture()
        by_hand.renderer.SetPass(PASS())
        ssao = enable_ambient_occlusion(by_helper)
        self.assertIs(by_helper.renderer.GetPass(), ssao)
        picture = by_helper.picture()
        self.assertEqual(picture, by_hand.picture())
        self.assertLess(mean(picture), 0.99 * mean(plain))

    def test_radius_is_automatic(self):
        view = View()
        ssao = enable_ambient_occlusion(view.renderer)
        view.picture()
        low, high = zip(*zip(*[iter(view.renderer.ComputeVisiblePropBounds())] * 2))
        diagonal = sum((b - a) ** 2 for a, b in zip(low, high)) ** 0.5
        self.assertAlmostEqual(ssao.GetEffectiveRadius(), 0.1 * diagonal, delta=1e-9 * diagonal)

    def test_settings_change_the_pass_that_is_there(self):
        view = View()
        ssao = enable_ambient_occlusion(view, radius=0.25, quality="accurate")
        self.assertEqual((ssao.GetRadius(), ssao.GetDirections(), ssao.GetSteps()), (0.25, 1, 14))
        self.assertIs(enable_ambient_occlusion(view, quality="fast"), ssao)
        self.assertEqual((ssao.GetRadius(), ssao.GetDirections(), ssao.GetSteps()), (0.0, 1, 8))
        self.assertEqual(chain(view.renderer), [PASS.__name__])

    def test_goes_where_vtk_has_its_own(self):
        own = PASS.__name__
        fxaa, ssaa, old, steps = (
            "vtkOpenGLFXAAPass", "vtkSSAAPass", "vtkSSAOPass", "vtkRenderStepsPass")  # fmt: skip
        for before, after in (
            ([], [own]),
            ([steps], [own, steps]),
            ([fxaa, steps], [own, fxaa, steps]),
            ([ssaa, steps], [ssaa, own, steps]),
            ([old, steps], [own, steps]),
            ([ssaa, old, fxaa, steps], [ssaa, own, fxaa, steps]),
            ([fxaa, old, steps], [fxaa, own, steps]),
        ):
            with self.subTest(before):
                renderer = vtkRenderer()
                if before:
                    renderer.SetPass(stacked(*(globals()[name]() for name in before)))
                enable_ambient_occlusion(renderer)
                self.assertEqual(chain(renderer), after)
                disable_ambient_occlusion(renderer)
                after.remove(own)
                self.assertEqual(chain(renderer), after)

    def test_draws_below_supersampling(self):
        view = View()
        view.renderer.SetPass(stacked(vtkSSAAPass(), vtkRenderStepsPass()))
        plain = view.picture()
        enable_ambient_occlusion(view)
        self.assertLess(mean(view.picture()), 0.99 * mean(plain))

    def test_disable_brings_the_old_picture_back(self):
        view = View()
        plain = view.picture()
        enable_ambient_occlusion(view)
        self.assertGreater(largest_difference(plain, view.picture()), 10)
        disable_ambient_occlusion(view)
        self.assertEqual(view.picture(), plain)
        disable_ambient_occlusion(view)  # there is none any more
        enable_ambient_occlusion(view)
        self.assertGreater(largest_difference(plain, view.picture()), 10)

    def test_refuses_what_it_cannot_use(self):
        view = View()
        for arguments in ({"quality": "best"}, {"radius": -1.0}, {"radius": float("nan")}):
            with self.subTest(arguments), self.assertRaises(ValueError):
                enable_ambient_occlusion(view, **arguments)
        with self.assertRaisesRegex(TypeError, "str is no vtkRenderer"):
            enable_ambient_occlusion("renderer")
        self.assertIsNone(view.renderer.GetPass())


unittest.main()
