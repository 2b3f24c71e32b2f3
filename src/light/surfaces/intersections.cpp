// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "embree_handle.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

namespace {

//! Returns whether a point is within a clearance of a triangle's plane and its
//! projection is inside the triangle.
bool is_at(const glm::dvec3& point, const glm::dvec3& a, const glm::dvec3& b,
           const glm::dvec3& c, double clearance) {
    const glm::dvec3 u = b - a, v = c - a, p = point - a;
    const glm::dvec3 n = glm::cross(u, v);
    const double square = glm::dot(n, n);
    if (!(square > 0) ||
        std::abs(glm::dot(p, n)) > clearance * std::sqrt(square))
        return false;
    const double s = glm::dot(glm::cross(p, v), n) / square;
    const double t = glm::dot(glm::cross(u, p), n) / square;
    return s >= 0 && t >= 0 && s + t <= 1;
}

}  // namespace

BoxTree quickest_tree(double rays, std::size_t faces) {
    // From so many rays per face on, faster rays outweigh slower building. At
    // 0.5 to 0.9 rays per face an evaluation takes 0.8 of the time with a tree
    // by order, at 3 to 5 rays 1.05 to 1.17 of the time.
    constexpr double rays_of_face = 2;
    return rays < rays_of_face * static_cast<double>(faces) ? BoxTree::by_order
                                                            : BoxTree::by_area;
}

namespace {

RTCBuildQuality quality_of(BoxTree tree) {
    return tree == BoxTree::by_order ? RTC_BUILD_QUALITY_LOW
                                     : RTC_BUILD_QUALITY_MEDIUM;
}

}  // namespace

void RayScene::commit(const Device& device, BoxTree tree) {
    tree_ = tree;
    commit(device, tree, standing_);
    for (Part& part : moving_) commit(device, tree, part);
}

void RayScene::set_tree(const Device& device, BoxTree tree) {
    if (tree != tree_) commit(device, tree);
}

void RayScene::commit(const Device& device, BoxTree tree, Part& part) {
    part.scene = {rtcNewScene(device.device_), rtcReleaseScene};
    // Robust mode prevents light from passing through common edges of faces.
    rtcSetSceneFlags(part.scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(part.scene.get(), quality_of(tree));
    if (!part.face.empty()) attach_faces(device.device_, tree, part);
    rtcCommitScene(part.scene.get());
    require_no_error(device.device_, fmt::format("build a scene of {} faces",
                                                 part.face.size()));
}

void RayScene::attach_faces(RTCDeviceTy* embree, BoxTree tree, Part& part) {
    const auto& corners = part.corners;
    RTCGeometry geometry = rtcNewGeometry(embree, RTC_GEOMETRY_TYPE_QUAD);
    rtcSetGeometryBuildQuality(geometry, quality_of(tree));
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0,
                               RTC_FORMAT_FLOAT3, corners.data(), 0,
                               sizeof corners[0], corners.size());
    auto* indices = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4,
        4 * sizeof(std::uint32_t), part.face.size()));
    if (indices)
        for (std::uint32_t i = 0; i < corners.size(); ++i) indices[i] = i;
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(part.scene.get(), geometry);
    rtcReleaseGeometry(geometry);
}

bool RayScene::meets(const Part& part, RTCRayHit& ray) const {
    const double from = ray.ray.org_z;
    const double to = from + double{ray.ray.dir_z} * double{ray.ray.tfar};
    if (std::max(from, to) < part.heights.lower - clearance_ ||
        std::min(from, to) > part.heights.upper + clearance_)
        return false;
    RTCRayHit nearer = ray;
    nearer.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    intersect_first(part.scene.get(), nearer);
    if (nearer.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
    ray = nearer;
    return true;
}

bool RayScene::intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                         double distance, Hit& hit, std::uint32_t pose) const {
    IDEOTYPE_EXPECT(distance >= 0);
    IDEOTYPE_EXPECT(std::abs(glm::dot(direction, direction) - 1) < 1e-3);
    RTCRayHit query;
    query.ray.org_x = static_cast<float>(origin.x);
    query.ray.org_y = static_cast<float>(origin.y);
    query.ray.org_z = static_cast<float>(origin.z);
    query.ray.dir_x = static_cast<float>(direction.x);
    query.ray.dir_y = static_cast<float>(direction.y);
    query.ray.dir_z = static_cast<float>(direction.z);
    query.ray.tnear = 0;
    query.ray.tfar = static_cast<float>(distance);
    query.ray.time = 0;
    query.ray.mask = ~0u;
    query.ray.id = 0;
    query.ray.flags = 0;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    intersect_first(standing_.scene.get(), query);
    const Part* part = &standing_;
    if (pose > 0 && pose <= moving_.size() && meets(moving_[pose - 1], query))
        part = &moving_[pose - 1];
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;

    const glm::dvec3 normal(query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z);
    hit.normal = normal / glm::length(normal);
    const std::uint32_t face = part->face[query.hit.primID];
    hit.group = surfaces_.face_group[face];
    hit.triangle = 2 * face + (query.hit.u + query.hit.v > 1 ? 1 : 0);

    // Embree returns the distance along the ray in single precision, so the
    // point is projected onto the plane through a corner that both triangles of
    // the face share.
    const auto& corner = part->corners[4 * std::size_t{query.hit.primID} + 1];
    const double t = query.ray.tfar;
    const glm::dvec3 p = origin + t * direction;
    const glm::dvec3 on_plane(corner[0], corner[1], corner[2]);
    hit.position = p - glm::dot(p - on_plane, hit.normal) * hit.normal;
    return true;
}

int RayScene::faces_at(const glm::dvec3& point) const {
    struct Search {
        const RayScene& scene;
        glm::dvec3 point;
        int found = 0;
    } search{*this, point};
    RTCPointQuery query;
    query.x = static_cast<float>(point.x);
    query.y = static_cast<float>(point.y);
    query.z = static_cast<float>(point.z);
    query.radius = static_cast<float>(2 * clearance_);
    query.time = 0;
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    const auto look_at = [](RTCPointQueryFunctionArguments* arguments) {
        auto& at = *static_cast<Search*>(arguments->userPtr);
        const RayScene& scene = at.scene;
        const auto corner = [&scene, arguments](std::size_t i) {
            const auto& c = scene.standing_.corners[4 * arguments->primID + i];
            return glm::dvec3(c[0], c[1], c[2]);
        };
        const auto lies_on = [&](std::size_t a, std::size_t b, std::size_t c) {
            return is_at(at.point, corner(a), corner(b), corner(c),
                         scene.clearance_);
        };
        at.found += lies_on(0, 1, 3) || lies_on(2, 3, 1);
        return false;
    };
    rtcPointQuery(standing_.scene.get(), &query, &context, look_at, &search);
    return search.found;
}

}  // namespace ideotype
