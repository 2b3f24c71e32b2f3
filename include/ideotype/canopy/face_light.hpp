#pragma once

#include <vector>

#include "ideotype/canopy/canopy.hpp"

namespace ideotype {

//! The light of one day on each face of a mesh.
struct FaceLight {
    //! Absorbed by both sides, for the one-sided area of the face
    //! [J m-2 day-1].
    std::vector<Estimate> absorbed;
    //! That the faces of the mesh draw their light from [m2]: absorbed light
    //! times area, summed over all faces, over this is what leaves and stalks
    //! absorb for each area of ground.
    double ground_area = 0;
};

//! A plant in the fields of the draws: a mean over all its copies. In a plot
//! that is cut some copies are only there in part.
FaceLight light_on_plant(const CanopyModel& model, const Device& device,
                         const Mesh& plant, const Draws& draws);

//! One field, with all randomisations of the draws.
FaceLight light_on_field(const CanopyModel& model, const Device& device,
                         const Field& field, const Draws& draws);

//! At least as many paths as to know the light on most faces to some 5 %, but
//! no more than take about ten seconds.
Accuracy face_sampling(const Accuracy& sampling, std::size_t faces);

}  // namespace ideotype
