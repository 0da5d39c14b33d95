// SPDX-License-Identifier: BSD-3-Clause
// Where the camera stands.
#ifndef RenderMesh_Framing_h
#define RenderMesh_Framing_h

#include "Scene.h"

namespace rendermesh
{
/// Sets the camera so that the scene fills the picture but for a small rim.
void FrameScene(const Settings& settings, Scene& scene);
}

#endif
