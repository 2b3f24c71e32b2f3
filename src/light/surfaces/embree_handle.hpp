// SPDX-License-Identifier: Apache-2.0
#pragma once

// Only this file and a benchmark depend on the version of Embree. In version 4,
// queries take optional arguments instead of a context.
#if IDEOTYPE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "ideotype/light/device.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! Checks that Embree has reported no error.
//! @throws std::runtime_error, not Error, since the machine is at fault and not
//! the evaluated plant.
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
