#pragma once

#include "ideotype/light/illumination.hpp"
#include "ideotype/light/scene.hpp"
#include "ideotype/run/evaluator.hpp"

namespace ideotype {

//! The baseline at Ames under its day, with what may be changed about it
//! first.
struct Stand {
    //! campaigns/ames.toml
    static Campaign ames();

    explicit Stand(Campaign changed);

    Field field(const Genome& genome) const;
    Scene scene(const Field& field) const;

    Campaign campaign;
    Case chosen;
    Genome baseline;
    CanopyRequest request;  //!< of the baseline in the first generation
    Device device;
};

//! Relative standard error of the leaves' light.
double relative_error(const CanopyReport& report);

}  // namespace ideotype
