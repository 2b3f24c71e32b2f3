#pragma once

// The only file that says which Embree this is: version 4 needs its header
// here and the changed call of rtcIntersect1 below.
#include <embree3/rtcore.h>

#include "ideotype/light/device.hpp"
#include "ideotype/light/scene.hpp"

namespace ideotype {

struct Device::Handle {
    RTCDevice device;
};

struct Scene::Handle {
    explicit Handle(RTCScene s) : scene(s) {}
    ~Handle() { rtcReleaseScene(scene); }
    Handle(const Handle&) = delete;
    Handle& operator=(const Handle&) = delete;

    RTCScene scene;
};

inline void intersect_first(RTCScene scene, RTCRayHit& ray) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
}

}  // namespace ideotype
