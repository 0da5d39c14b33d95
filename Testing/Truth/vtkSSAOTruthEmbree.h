// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * @brief The few calls that differ between Embree 3 and Embree 4.
 *
 * Both call the filter functions of a geometry and hand them a context that the caller may extend;
 * only its name and the way to pass it differ. VTK_SSAO_TRUTH_EMBREE_MAJOR comes from CMake.
 */

#ifndef vtkSSAOTruthEmbree_h
#define vtkSSAOTruthEmbree_h

#if VTK_SSAO_TRUTH_EMBREE_MAJOR >= 4

#include <embree4/rtcore.h>

typedef RTCRayQueryContext vtkSSAOTruthRayContext;

inline void vtkSSAOTruthIntersect(RTCScene scene, vtkSSAOTruthRayContext* context, RTCRayHit* ray)
{
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  rtcInitRayQueryContext(context);
  arguments.context = context;
  rtcIntersect1(scene, ray, &arguments);
}

inline void vtkSSAOTruthOccluded(RTCScene scene, vtkSSAOTruthRayContext* context, RTCRay* ray)
{
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  rtcInitRayQueryContext(context);
  arguments.context = context;
  rtcOccluded1(scene, ray, &arguments);
}

#else

#include <embree3/rtcore.h>

typedef RTCIntersectContext vtkSSAOTruthRayContext;

inline void vtkSSAOTruthIntersect(RTCScene scene, vtkSSAOTruthRayContext* context, RTCRayHit* ray)
{
  rtcInitIntersectContext(context);
  rtcIntersect1(scene, context, ray);
}

inline void vtkSSAOTruthOccluded(RTCScene scene, vtkSSAOTruthRayContext* context, RTCRay* ray)
{
  rtcInitIntersectContext(context);
  rtcOccluded1(scene, context, ray);
}

#endif

#endif
