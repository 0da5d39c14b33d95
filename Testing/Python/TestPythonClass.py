# SPDX-License-Identifier: BSD-3-Clause
"""The wrapped class: one process with all of VTK, documented, typed, refusing bad values."""

import ast
import inspect
import os
import unittest

import vtkssaopass

import vtkmodules.all as vtk

PASS = vtkssaopass.vtkScreenSpaceAmbientOcclusionPass


class TestPythonClass(unittest.TestCase):
    def test_lives_with_all_of_vtk(self):
        ssao = PASS()
        self.assertIsInstance(ssao, vtk.vtkImageProcessingPass)
        renderer = vtk.vtkRenderer()
        renderer.SetPass(ssao)
        self.assertIs(renderer.GetPass(), ssao)

    def test_values_are_kept_or_refused(self):
        ssao = PASS()
        ssao.SetRadius(2.5)
        ssao.SetEstimatorToExactHorizon()
        self.assertEqual(ssao.GetRadius(), 2.5)
        self.assertEqual(ssao.GetEstimator(), PASS.ExactHorizon)
        errors = []
        ssao.AddObserver("ErrorEvent", lambda *_: errors.append(1))
        ssao.SetRadius(-1.0)
        self.assertEqual((ssao.GetRadius(), len(errors)), (2.5, 1))

    def test_is_documented(self):
        self.assertIn("ambient light", PASS.__doc__)
        for name in ("SetRadius", "SetEstimator", "SetDenoiser", "SetModulation", "GetVisibility"):
            self.assertRegex(getattr(PASS, name).__doc__, r"C\+\+:.*\n\n\w", name)
        for function in (
            vtkssaopass.enable_ambient_occlusion,
            vtkssaopass.disable_ambient_occlusion,
        ):
            self.assertTrue(inspect.getdoc(function))

    def test_is_typed(self):
        folder = os.path.dirname(vtkssaopass.__file__)
        self.assertTrue(os.path.exists(os.path.join(folder, "py.typed")))
        with open(os.path.join(folder, "vtkSSAOPass.pyi"), encoding="utf-8") as file:
            tree = ast.parse(file.read())
        known = {"Any", "bool", "float", "int", "str", "None"}
        for node in tree.body:
            if isinstance(node, ast.ImportFrom):
                known.update(alias.name for alias in node.names)
        (written,) = [node for node in tree.body if isinstance(node, ast.ClassDef)]
        known.add(written.name)
        known.update(node.name for node in written.body if isinstance(node, ast.ClassDef))
        methods = {node.name: node for node in written.body if isinstance(node, ast.FunctionDef)}
        values = {node.target.id for node in written.body if isinstance(node, ast.AnnAssign)}
        for name in (name for name in vars(PASS) if not name.startswith("__")):
            self.assertIn(name, set(methods) | values | known)
        for node in ast.walk(written):
            annotations = [getattr(node, "annotation", None), getattr(node, "returns", None)]
            for annotation in annotations:
                if isinstance(annotation, ast.Name):
                    self.assertIn(annotation.id, known)
        self.assertEqual(ast.unparse(methods["SetRadius"].args), "self, radius: float")
        self.assertEqual(ast.unparse(methods["GetVisibility"].returns), "bool")


unittest.main()
