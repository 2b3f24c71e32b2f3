// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/light/boundary.hpp"
#include "ideotype/light/device.hpp"

struct RTCRayHit;
struct RTCSceneTy;

namespace ideotype {

//! The place at which light meets a surface or leaves the scene.
struct Hit {
    //! The numbers that stand for the soil and the sky in place of a group.
    static constexpr std::uint32_t soil = ~std::uint32_t{0};
    static constexpr std::uint32_t sky = soil - 1;

    glm::dvec3 position{0};  //!< point on the plane of the face [m]
    glm::dvec3 normal{0, 0,
                      1};  //!< unit normal; for faces that of the adaxial side
    std::uint32_t group = 0;  //!< group of the mesh, or the soil, or the sky
    //! The number of the triangle among those of the scene's surfaces.
    std::uint32_t triangle = 0;
};

//! A box with edges parallel to the axes [m].
struct Box {
    glm::dvec3 lower, upper;
};

//! The part of a ray inside a box, in multiples of the ray's direction.
struct Segment {
    double first, last;
};

//! The lowest and the highest of some coordinates [m]. Without coordinates, the
//! lower end is above the upper end.
struct Interval {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    void include(double x) {
        lower = std::min(lower, x);
        upper = std::max(upper, x);
    }
};

//! The faces of a stand, each once, in the positions that the mesh has. Face f
//! is divided in two triangles as Embree does it: triangle 2 f has its corners
//! 0, 1 and 3, and triangle 2 f + 1 its corners 2, 3 and 1.
struct Surfaces {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> faces;
    std::vector<std::uint32_t> face_group;
    //! The number of the pose in which each face is present; 0 for all poses.
    std::vector<std::uint32_t> face_pose;
    //! The unit normal of each triangle on the adaxial side; a zero vector for
    //! a triangle without area.
    std::vector<glm::dvec3> normals;

    //! Adds a face of a mesh; the surfaces have its vertices.
    void add(const std::array<std::uint32_t, 4>& face, std::uint32_t group,
             std::uint32_t pose);

    //! Returns whether a face is present for light of sources of a pose.
    bool is_there(std::size_t face, std::uint32_t pose) const {
        return face_pose[face] == 0 || face_pose[face] == pose;
    }
};

//! Returns the part of a ray inside a box, with its edges; nothing if the ray
//! misses the box.
std::optional<Segment> clip(const Box& box, const glm::dvec3& origin,
                            const glm::dvec3& direction);

//! The surfaces of a canopy, ready to be traced. A periodic scene holds one
//! cell of an infinite stand. The cell spans [0, period_x] x [0, period_y]; a
//! mesh that is shifted by whole periods gives the same scene. A face that
//! reaches over the cell's boundary has images, which are the faces of
//! neighbouring cells. Nothing is cut off and nothing counts twice, because
//! rays end at the cell's boundary.
//! sun, such as panels that track it, are kept apart: only light of their pose
//! meets their faces.
//! plot, shifted so that the corner of its bounding box is above the origin.
class RayScene {
  public:
    //! Builds a periodic scene. Faces without area and faces below the soil are
    //! left out. Faces that lie on each other, closer than clearance(), are one
    //! surface: light meets one of these faces, and scattered light starts
    //! beyond all of them. If faces have the same corners, in any order, only
    //! the first in the mesh is kept. Otherwise rounding decides at each point
    //! which face the light meets.
    //! @throws Error if a vertex is not finite or too far away, a period is not
    //! positive, there are too many faces, or memory runs out.
    RayScene(const Device& device, const Mesh& mesh, double period_x,
             double period_y);

    //! Builds the scene of a plot that stands alone.
    //! @param ground_area area of ground that all figures refer to [m2]
    //! @throws Error as for a periodic scene, with the ground area in place of
    //! the period.
    static RayScene isolated(const Device& device, const Mesh& mesh,
                             double ground_area);

    RayScene(RayScene&&) = default;
    RayScene& operator=(RayScene&&) = default;

    Boundary boundary() const { return boundary_; }
    //! Returns the period of a periodic scene along x [m].
    double period_x() const { return period_x_; }
    //! Returns the period of a periodic scene along y [m].
    double period_y() const { return period_y_; }
    //! Returns the area of the cell, or the given area of a plot [m2].
    double ground_area() const { return ground_area_; }
    //! Returns the bounding box of an isolated plot.
    const Box& box() const { return box_; }
    double top() const { return top_; }  //!< height above all surfaces [m]

    //! Returns the height of the soil [m]. The soil is below zero by the
    //! rounding error, so that light can pass between the soil and a face at
    //! height zero.
    double soil() const { return -2 * clearance_; }
    std::size_t faces() const { return standing_.face.size(); }

    //! Returns the one-sided area of all faces of the mesh [m2].
    double surface_area() const { return surface_area_; }

    //! Returns the surfaces of the plot or of one cell, at the positions in the
    //! mesh.
    const Surfaces& surfaces() const { return surfaces_; }

    //! Returns the lowest and the highest point of the faces of a group [m].
    Interval heights(std::size_t group) const {
        return group < group_heights_.size() ? group_heights_[group]
                                             : Interval{};
    }

    //! Finds the first face within a distance [m] of a point of the cell, along
    //! a unit direction; returns false if there is no face.
    //! @param pose number of the pose of moving objects
    bool intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                   double distance, Hit& hit, std::uint32_t pose = 0) const;

    //! Returns the number of faces and images that are closer than a clearance
    //! to a point of the cell or the plot.
    int faces_at(const glm::dvec3& point) const;

    //! Returns the position that a point of the mesh has in this scene.
    glm::dvec3 placed(const glm::dvec3& point) const {
        return wrapped(point - plot_corner_);
    }

    //! Returns the position inside the cell that stands for a position anywhere
    //! in the stand. In a plot the position stays as it is.
    glm::dvec3 wrapped(const glm::dvec3& point) const;

    //! Returns the position from which light restarts at a point of a face, on
    //! the side of the normal: a clearance away, but not below the soil.
    glm::dvec3 offset_origin(const glm::dvec3& point,
                             const glm::dvec3& normal) const;

    //! Returns the distance from a face at which light restarts so as not to
    //! meet the face again: a few times the rounding error of single precision
    //! [m].
    double clearance() const { return clearance_; }

  private:
    //! Faces with their images, as the ray tracer stores them.
    struct Part {
        std::vector<std::array<float, 4>>
            corners;  //!< corners of faces, four per face, as x y z 0
        std::vector<std::uint32_t> face;  //!< face of the mesh of each image
        std::shared_ptr<RTCSceneTy> scene;
        Interval heights;
    };

    RayScene() = default;
    void add_plot(const Mesh& mesh, const std::vector<double>& areas);
    //! Adds a face of the mesh, without images, and returns the part that it
    //! belongs to.
    Part& add_face(const std::array<std::uint32_t, 4>& face,
                   std::uint32_t group, std::uint32_t pose,
                   const Interval& heights);
    //! Adds an image of the face that was added last.
    void add_image(Part& part, const glm::dvec3& shift) const;
    void add_images(const std::array<std::uint32_t, 4>& face,
                    std::uint32_t group, std::uint32_t pose);
    void commit(const Device& device);
    static void commit(const Device& device, Part& part);
    static void attach_faces(RTCDeviceTy* embree, Part& part);
    //! Returns whether a ray meets a face of a moving part before it ends.
    [[gnu::cold]] bool meets(const Part& part, RTCRayHit& ray) const;

    Boundary boundary_ = Boundary::periodic;
    Box box_{};
    //! The position of an isolated plot's corner in the axes of the mesh.
    glm::dvec3 plot_corner_{0};
    double ground_area_ = 0;
    double period_x_ = 0;
    double period_y_ = 0;
    double top_ = 0;
    double clearance_ = 0;
    double surface_area_ = 0;
    Surfaces surfaces_;
    Part standing_;
    std::vector<Part> moving_;  //!< moving parts by pose, from 1
    std::vector<Interval> group_heights_;
};

}  // namespace ideotype
