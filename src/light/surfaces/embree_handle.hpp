// SPDX-License-Identifier: Apache-2.0
#pragma once

// Only this file depends on the version of Embree: queries of version 4 have
// optional arguments in place of a context.
#if IDEOTYPE_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "ideotype/light/device.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

struct Device::Handle {
    RTCDevice device;
};

//! Requires that Embree has reported no error.
//! @throws std::runtime_error otherwise, which is a fault of the machine and no
//! Error of the evaluated plant.
//! @param device device, or null after a failed creation
void require_no_error(RTCDeviceTy* device, const std::string& action);

struct RayScene::Handle {
    explicit Handle(RTCScene s) : scene(s) {}
    ~Handle() { rtcReleaseScene(scene); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    RTCScene scene;
};

#if IDEOTYPE_EMBREE >= 4

inline void intersect_first(RTCScene scene, RTCRayHit& ray) {
    rtcIntersect1(scene, &ray);
}

//! Returns hints for rays that are neighbours in space.
inline RTCIntersectArguments coherent() {
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    return arguments;
}

inline void intersect_first(const int* valid, RTCScene scene,
                            RTCRayHit8& packet) {
    RTCIntersectArguments arguments = coherent();
    rtcIntersect8(valid, scene, &packet, &arguments);
}

inline void intersect_first(const int* valid, RTCScene scene,
                            RTCRayHit16& packet) {
    RTCIntersectArguments arguments = coherent();
    rtcIntersect16(valid, scene, &packet, &arguments);
}

#else

inline void intersect_first(RTCScene scene, RTCRayHit& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
}

//! Returns hints for rays that are neighbours in space.
inline RTCIntersectContext coherent() {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    return context;
}

inline void intersect_first(const int* valid, RTCScene scene,
                            RTCRayHit8& packet) {
    RTCIntersectContext context = coherent();
    rtcIntersect8(valid, scene, &context, &packet);
}

inline void intersect_first(const int* valid, RTCScene scene,
                            RTCRayHit16& packet) {
    RTCIntersectContext context = coherent();
    rtcIntersect16(valid, scene, &context, &packet);
}

#endif

}  // namespace ideotype
