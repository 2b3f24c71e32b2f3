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

//! The point where light meets a surface or leaves the scene.
struct Hit {
    //! The values of `group` that represent the soil and the sky.
    static constexpr std::uint32_t soil = ~std::uint32_t{0};
    static constexpr std::uint32_t sky = soil - 1;

    glm::dvec3 position{0};  //!< point on the plane of the face [m]
    glm::dvec3 normal{0, 0,
                      1};  //!< unit normal; for faces that of the adaxial side
    std::uint32_t group = 0;  //!< group of the mesh, or the soil, or the sky
    //! Index of the triangle among the surfaces of the scene.
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

//! The range of some coordinates [m]. Without coordinates, the lower end is
//! above the upper end.
struct Interval {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    void include(double x) {
        lower = std::min(lower, x);
        upper = std::max(upper, x);
    }
};

//! The faces of a stand, each once, at their positions in the mesh. Each face f
//! is divided into two triangles as in Embree: triangle 2 f has the corners 0,
//! 1 and 3 of the face, triangle 2 f + 1 the corners 2, 3 and 1.
struct Surfaces {
    std::vector<glm::dvec3> vertices;
    std::vector<std::array<std::uint32_t, 4>> faces;
    std::vector<std::uint32_t> face_group;
    //! Orientation index for which each face is present; 0: always present.
    std::vector<std::uint32_t> face_pose;
    //! The unit normal of each triangle on the adaxial side; zero for a
    //! triangle without area.
    std::vector<glm::dvec3> normals;

    //! Adds a face with vertices that are already in `vertices`.
    void add(const std::array<std::uint32_t, 4>& face, std::uint32_t group,
             std::uint32_t pose);

    //! Returns whether a face is present for light with an orientation index.
    bool is_there(std::size_t face, std::uint32_t pose) const {
        return face_pose[face] == 0 || face_pose[face] == pose;
    }
};

//! Returns the part of a ray inside a box, including its boundary; nothing if
//! the ray misses the box.
std::optional<Segment> clip(const Box& box, const glm::dvec3& origin,
                            const glm::dvec3& direction);

//! How the tree of boxes is built in which rays search for faces: in the order
//! of Morton codes of the faces, in a sixth of the time, or by the areas of
//! boxes, so that a ray takes three quarters of the time.
enum class BoxTree { by_order, by_area };

//! Returns the tree with which a scene is built and traced in the shortest
//! time.
//! @param rays expected number of rays
BoxTree quickest_tree(double rays, std::size_t faces);

//! The surfaces of a canopy, ready for ray tracing.
//!
//! A periodic scene contains one cell of an infinite stand. The cell spans [0,
//! period_x] x [0, period_y]; shifting the mesh by whole periods does not
//! change the scene. A face that extends over the cell's boundary gets images,
//! which are the faces of neighbouring cells. Nothing is cut off or counted
//! twice, because rays end at the cell's boundary.
//!
//! Objects that move with the sun, such as tracking panels, are stored
//! separately for each orientation. Light meets only the orientation that
//! belongs to its source.
//!
//! An isolated scene contains a plot, shifted so that the corner of its
//! bounding box is above the origin.
class RayScene {
  public:
    //! Builds a periodic scene. Faces without area and faces below the soil are
    //! omitted. Faces that coincide, at distances below clearance(), act as one
    //! surface: light meets one of them, and scattered light starts beyond all
    //! of them. Of faces with the same corners, in any order, only the first in
    //! the mesh is used. Otherwise rounding decides at each point which face
    //! the light meets.
    //! @throws Error if a vertex is not finite or too far away, a period is not
    //! positive, there are too many faces, or memory runs out.
    RayScene(const Device& device, const Mesh& mesh, double period_x,
             double period_y, BoxTree tree = BoxTree::by_area);

    //! Builds the scene of an isolated plot.
    //! @param ground_area area of ground that all figures refer to [m2]
    //! @throws Error as for a periodic scene, for the ground area instead of a
    //! period.
    static RayScene isolated(const Device& device, const Mesh& mesh,
                             double ground_area,
                             BoxTree tree = BoxTree::by_area);

    //! Replaces the tree of boxes if it is another one. Rays meet the same
    //! faces; only at edges and where faces coincide may they meet another one.
    void set_tree(const Device& device, BoxTree tree);

    RayScene(RayScene&&) = default;
    RayScene& operator=(RayScene&&) = default;

    Boundary boundary() const { return boundary_; }
    double period_x() const { return period_x_; }
    double period_y() const { return period_y_; }
    //! Returns the area of the cell, or the ground area given for a plot [m2].
    double ground_area() const { return ground_area_; }
    //! Returns the bounding box of an isolated plot.
    const Box& box() const { return box_; }
    double top() const { return top_; }  //!< height above all surfaces [m]

    //! Returns the height of the soil [m]. It is below zero by the rounding
    //! error, so that light can pass between the soil and a face at height
    //! zero.
    double soil() const { return -2 * clearance_; }
    std::size_t faces() const { return standing_.face.size(); }

    //! Returns the one-sided area of all faces of the mesh [m2].
    double surface_area() const { return surface_area_; }

    //! Returns the surfaces of the plot or of one cell, at their positions in
    //! the mesh.
    const Surfaces& surfaces() const { return surfaces_; }

    //! Returns the height range of the faces of a group [m].
    Interval heights(std::size_t group) const {
        return group < group_heights_.size() ? group_heights_[group]
                                             : Interval{};
    }

    //! Finds the first face within a distance [m] of a point of the cell, along
    //! a unit direction; returns false if there is no face.
    //! @param pose orientation index of moving objects
    bool intersect(const glm::dvec3& origin, const glm::dvec3& direction,
                   double distance, Hit& hit, std::uint32_t pose = 0) const;

    //! Returns the number of faces and images that are closer than clearance()
    //! to a point of the cell or the plot.
    int faces_at(const glm::dvec3& point) const;

    //! Converts a position in the mesh to a position in this scene.
    glm::dvec3 placed(const glm::dvec3& point) const {
        return wrapped(point - plot_corner_);
    }

    //! Returns the position inside the cell that is equivalent to a position
    //! anywhere in the stand. For a plot, returns the position unchanged.
    glm::dvec3 wrapped(const glm::dvec3& point) const;

    //! Returns the start position for light that continues from a point on a
    //! face: clearance() away on the side of the normal, but not below the
    //! soil.
    glm::dvec3 offset_origin(const glm::dvec3& point,
                             const glm::dvec3& normal) const;

    //! Returns the distance from a face at which light continues so that it
    //! does not meet the same face again: a few times the rounding error of
    //! single precision [m].
    double clearance() const { return clearance_; }

  private:
    //! Faces with their images, as the ray tracer stores them.
    struct Part {
        std::vector<std::array<float, 4>>
            corners;  //!< corners of faces, four per face, as x y z 0
        //! Index in the mesh of the face of each image.
        std::vector<std::uint32_t> face;
        std::shared_ptr<RTCSceneTy> scene;
        Interval heights;
    };

    RayScene() = default;
    void add_plot(const Mesh& mesh, const std::vector<double>& areas);
    //! Adds a face of the mesh without images. Returns the part that contains
    //! the face.
    Part& add_face(const std::array<std::uint32_t, 4>& face,
                   std::uint32_t group, std::uint32_t pose,
                   const Interval& heights);
    //! Adds an image of the face that was added last.
    void add_image(Part& part, const glm::dvec3& shift) const;
    void add_images(const std::array<std::uint32_t, 4>& face,
                    std::uint32_t group, std::uint32_t pose);
    void commit(const Device& device, BoxTree tree);
    static void commit(const Device& device, BoxTree tree, Part& part);
    static void attach_faces(RTCDeviceTy* embree, BoxTree tree, Part& part);
    //! Returns whether a ray meets a face of a moving part before the end of
    //! the ray.
    [[gnu::cold]] bool meets(const Part& part, RTCRayHit& ray) const;

    BoxTree tree_ = BoxTree::by_area;
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
    std::vector<Part> moving_;  //!< moving parts by orientation index, from 1
    std::vector<Interval> group_heights_;
};

}  // namespace ideotype
