// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file   vtkSSAOTestCompatibility.h
 * @brief  What differs between the VTK versions the tests compile for.
 */

#ifndef vtkSSAOTestCompatibility_h
#define vtkSSAOTestCompatibility_h

#include "vtkVersionMacros.h"

// The mapper that draws the blocks of a composite data set by themselves.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using vtkSSAOTestCompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using vtkSSAOTestCompositeMapper = vtkCompositePolyDataMapper2;
#endif

#endif
