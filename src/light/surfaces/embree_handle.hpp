// SPDX-License-Identifier: Apache-2.0
#pragma once

// Only this file, and a benchmark, depend on the version of Embree: queries of
// version 4 have optional arguments in place of a context.
#if IDEOTYPE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "ideotype/light/device.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Requires that Embree has reported no error.
//! @throws std::runtime_error otherwise, which is a fault of the machine and no
//! Error of the evaluated plant.
//! @param device device, or null after a failed creation
void require_no_error(RTCDeviceTy* device, const std::string& action);

inline void intersect_first(RTCScene scene, RTCRayHit& ray) {
#if IDEOTYPE_EMBREE >= 4
    rtcIntersect1(scene, &ray);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
#endif
}

}  // namespace ideotype
