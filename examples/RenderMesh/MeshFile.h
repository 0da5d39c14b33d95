// SPDX-License-Identifier: BSD-3-Clause
// From a file to a mesh of polygons, lines or points.
#ifndef RenderMesh_MeshFile_h
#define RenderMesh_MeshFile_h

#include "Settings.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace rendermesh
{
/// The extensions that are known, with blanks between them.
std::string KnownExtensions();

/// glTF brings its own materials, and y is up.
bool IsGltf(const std::string& file);

/// Fails where reading the file would be in vain.
void CheckInput(const std::string& file);

/// Fails if there is nothing to draw, or a coordinate is not a number.
void CheckMesh(vtkPolyData* mesh, const std::string& file);

/// Reads any file but glTF. Images become contours or height fields, grids their surface.
vtkSmartPointer<vtkPolyData> LoadMesh(const Settings& settings);
}

#endif
