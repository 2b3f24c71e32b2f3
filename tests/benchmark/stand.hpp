// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/ray_scene.hpp"
#include "stand/stand.hpp"

namespace ideotype {

//! The baseline at Ames under the light of its day. Settings may be changed
//! before the evaluation.
struct BenchStand {
    //! campaigns/ames.toml
    static Campaign ames();

    explicit BenchStand(Campaign changed);

    Field field(const Genome& genome) const;
    RayScene scene(const Field& field) const;

    Campaign campaign;
    Case chosen;
    Genome baseline;
    CanopyRequest request;  //!< request of the baseline in generation 0
    Device device;
};

//! Returns the relative standard error of the light absorbed by leaves.
double relative_error(const CanopyReport& report);

}  // namespace ideotype
