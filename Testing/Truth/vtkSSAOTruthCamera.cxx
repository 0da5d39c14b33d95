// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSSAOTruthCamera.h"

#include "vtkSSAOTruthDigest.h"

#include "vtkCamera.h"
#include "vtkMatrix4x4.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkSSAOTruthCamera::vtkSSAOTruthCamera(
  vtkCamera* camera, int width, int height, const double origin[3])
  : Width(width)
  , Height(height)
{
  const vtkMatrix4x4* view = camera->GetModelViewTransformMatrix();
  std::copy(view->GetData(), view->GetData() + 16, this->ViewMatrix);
  for (int row = 0; row < 3; ++row)
  {
    double* m = this->ViewMatrix + 4 * row;
    m[3] += m[0] * origin[0] + m[1] * origin[1] + m[2] * origin[2];
  }
  vtkMatrix4x4::Invert(this->ViewMatrix, this->InverseViewMatrix);

  const double aspect = static_cast<double>(width) / static_cast<double>(height);
  const vtkMatrix4x4* projection = camera->GetProjectionTransformMatrix(aspect, -1.0, 1.0);
  vtkMatrix4x4::Invert(projection->GetData(), this->InverseProjection);
}

//------------------------------------------------------------------------------
void vtkSSAOTruthCamera::GetRay(int x, int y, double nearPoint[3], double farPoint[3]) const
{
  for (int end = 0; end < 2; ++end)
  {
    const double device[4] = { 2.0 * (x + 0.5) / this->Width - 1.0,
      2.0 * (y + 0.5) / this->Height - 1.0, end == 0 ? -1.0 : 1.0, 1.0 };
    double view[4];
    vtkMatrix4x4::MultiplyPoint(this->InverseProjection, device, view);
    const double point[4] = { view[0] / view[3], view[1] / view[3], view[2] / view[3], 1.0 };
    double world[4];
    vtkMatrix4x4::MultiplyPoint(this->InverseViewMatrix, point, world);
    std::copy(world, world + 3, end == 0 ? nearPoint : farPoint);
  }
}

//------------------------------------------------------------------------------
void vtkSSAOTruthCamera::GetPoint(int x, int y, double depth, double point[3]) const
{
  double nearPoint[3], farPoint[3];
  this->GetRay(x, y, nearPoint, farPoint);
  const double nearDepth = this->GetDepth(nearPoint);
  const double t = (depth - nearDepth) / (this->GetDepth(farPoint) - nearDepth);
  for (int axis = 0; axis < 3; ++axis)
  {
    point[axis] = nearPoint[axis] + t * (farPoint[axis] - nearPoint[axis]);
  }
}

//------------------------------------------------------------------------------
double vtkSSAOTruthCamera::GetDepth(const double point[3]) const
{
  const double* m = this->ViewMatrix + 8;
  return -(m[0] * point[0] + m[1] * point[1] + m[2] * point[2] + m[3]);
}

//------------------------------------------------------------------------------
void vtkSSAOTruthCamera::ToView(const double world[3], double view[3]) const
{
  for (int row = 0; row < 3; ++row)
  {
    const double* m = this->ViewMatrix + 4 * row;
    view[row] = m[0] * world[0] + m[1] * world[1] + m[2] * world[2];
  }
}

//------------------------------------------------------------------------------
bool vtkSSAOTruthCamera::IsMirrored() const
{
  return vtkMatrix4x4::Determinant(this->ViewMatrix) *
    vtkMatrix4x4::Determinant(this->InverseProjection) >
    0.0;
}

//------------------------------------------------------------------------------
std::string vtkSSAOTruthCamera::GetDigest() const
{
  vtkSSAOTruthDigest digest;
  digest.Add(this->Width);
  digest.Add(this->Height);
  digest.Add(this->ViewMatrix);
  digest.Add(this->InverseProjection);
  return digest.GetHex();
}
