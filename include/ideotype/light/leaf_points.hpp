// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "ideotype/light/ray_scene.hpp"

namespace ideotype {

//! A point on a leaf.
struct LeafPoint {
    glm::dvec3 position;  //!< position in the axes of the mesh [m]
    glm::dvec3 normal;    //!< normal of the adaxial side, unit length
    std::uint32_t group;  //!< group of the mesh
    //! Whether light cannot reach the point because it is below the soil, or on
    //! a face that repeats the corners of an earlier face.
    bool is_hidden;
};

//! Returns the weight of a point in the leaf area: one over the number of faces
//! that coincide there.
double own_part(const RayScene& scene, const LeafPoint& point);

//! The surface of leaves as triangles, from which points can be sampled.
class LeafPoints {
  public:
    //! A function that returns whether a group of the mesh is included.
    using Wanted = std::function<bool(std::uint32_t)>;

    //! Makes the surface of all leaves.
    explicit LeafPoints(const Mesh& mesh);
    LeafPoints(const Mesh& mesh, const Wanted& is_wanted);

    //! Returns the one-sided area of all leaves [m2].
    double area() const { return ends_.empty() ? 0 : ends_.back(); }

    //! Returns a point on the leaves, which must have some area. Uniform
    //! numbers give points uniform over this area.
    //! @param share,s,t numbers in [0, 1)
    LeafPoint at(double share, double s, double t) const;

  private:
    //! A flat part of a leaf.
    struct Triangle {
        glm::dvec3 corner, u, v, normal;
        std::uint32_t group;
        bool is_repeated;
    };

    void add(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
             std::uint32_t group, bool is_repeated);

    std::vector<Triangle> triangles_;
    std::vector<double>
        ends_;  //!< cumulative areas, up to and including each triangle [m2]
};

}  // namespace ideotype
