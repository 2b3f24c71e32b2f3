#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/light/device.hpp"

struct RTCDeviceTy;

namespace ideotype {

//! Where light meets a face.
struct Hit {
    Vec3 position;            //!< on the plane of the face [m]
    Vec3 normal;              //!< unit length, on either side
    std::uint32_t group = 0;  //!< of the mesh
};

//! All surfaces inside one cell of an infinite periodic stand, ready to be
//! traced. The cell spans [0, period_x] x [0, period_y]; its lattice is where
//! the mesh says, so any shift of the mesh by whole periods is the same scene.
//! A face that reaches over the cell's boundary is also there as its images
//! from the neighbouring cells: nothing is cut off, nothing is doubled, since
//! rays end where the cell does.
class Scene {
  public:
    //! Faces without area and faces below the soil are left out.
    //! @throws Error if a vertex is not finite or beyond reason, a period not
    //! positive, there are too many faces, or memory runs out.
    Scene(const Device& device, const Mesh& mesh, double period_x,
          double period_y);
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;

    double period_x() const { return period_x_; }  //!< [m]
    double period_y() const { return period_y_; }  //!< [m]
    double top() const { return top_; }            //!< above all surfaces [m]
    std::size_t faces() const { return face_group_.size(); }

    //! The first face within a distance [m] of a point of the cell, along a
    //! unit direction; false if there is none.
    bool intersect(const Vec3& origin, const Vec3& direction, double distance,
                   Hit& hit) const;

    //! How far from a face light must restart so as not to meet it again: a
    //! few times the rounding error of single precision in this cell [m].
    double clearance() const { return clearance_; }

  private:
    struct Handle;

    void add_images(const Mesh& mesh, std::size_t face);
    void commit(const Device& device);
    void attach_faces(RTCDeviceTy* embree);

    double period_x_ = 0;
    double period_y_ = 0;
    double top_ = 0;
    double clearance_ = 0;
    std::vector<std::array<float, 4>> corners_;  //!< four per face, x y z 0
    std::vector<std::uint32_t> face_group_;
    std::unique_ptr<Handle> handle_;
};

}  // namespace ideotype
