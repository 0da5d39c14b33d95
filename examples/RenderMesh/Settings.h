// SPDX-License-Identifier: BSD-3-Clause
// What the command line of RenderMesh sets, except the pass's parameters: the pass holds those.
#ifndef RenderMesh_Settings_h
#define RenderMesh_Settings_h

#include <vtkVector.h>

#include <optional>
#include <string>

namespace rendermesh
{
struct Settings
{
  std::string Input;
  std::string Folder = ".";
  std::string Prefix;            // empty: the input's name
  std::optional<int> OutputMode; // of the pass; empty: the set of pictures
  int Size[2] = { 800, 600 };    // pixels
  int Supersample = 1;
  int MultiSamples = 0;
  int Frames = 0;
  bool Quiet = false;
  bool Help = false;

  std::optional<vtkVector3d> Look; // empty, as Up: what suits the format
  std::optional<vtkVector3d> Up;
  std::optional<vtkVector3d> Position; // empty: where all is in the picture
  double Zoom = 1.0;
  double ViewAngle = 30.0; // degrees
  bool Parallel = false;
  vtkVector3d Background = vtkVector3d(1.0, 1.0, 1.0);

  std::optional<vtkVector3d> Color; // empty: the file's own
  std::string ColorBy;
  std::string Scalars;
  std::optional<double> Contour;
  double WarpScale = 0.0;     // 0: automatic, as the two radii
  double PointRadius = 0.0;   // world units
  double TubeRadius = 0.0;    // world units
  double FeatureAngle = 30.0; // degrees
  double Ambient = 0.3;
  double Diffuse = 0.7;
  double Specular = 0.0;
};
}

#endif
