// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Corners of a polygon, as indices of vertices.
using Corners = std::vector<std::uint32_t>;

//! The kind of a polygon, which determines its faces.
enum class PolygonKind {
    simple,
    without_area,  //!< there are no faces
    crossing,      //!< the outline crosses itself; faces may overlap
    intricate,     //!< splitting would take too long; there are no faces
};

//! The faces of a mesh that cover a polygon: one quadrilateral for four
//! corners, else triangles.
struct SplitPolygon {
    PolygonKind kind = PolygonKind::simple;
    std::vector<std::array<std::uint32_t, 4>> faces;
};

//! Splits a polygon of any shape into faces: into a triangle fan if possible,
//! otherwise by ear clipping. Seen along the mean normal the faces do not
//! overlap, unless the outline crosses itself. Polygons with tens of thousands
//! of corners and both left and right turns would take more than seconds and
//! are not split.
SplitPolygon split_polygon(const std::vector<glm::dvec3>& vertices,
                           Corners corners);

}  // namespace ideotype
