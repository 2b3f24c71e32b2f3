#pragma once

#include <optional>
#include <vector>

#include "ideotype/core/mesh.hpp"
#include "ideotype/sky/day.hpp"

namespace ideotype {

//! Light that comes from one direction, or, without one, from a sky of
//! uniform radiance.
struct Source {
    std::optional<Vec3> direction;  //!< of travel, unit length, downwards
    double energy = 0;              //!< on horizontal ground [J m-2]
};

//! All light that falls on a stand, each source traced for itself.
struct Illumination {
    std::vector<Source> sources;

    double energy() const;  //!< [J m-2]
};

//! The light of a day in the axes of a field: one beam for each instant and,
//! because its shape does not change, one sky for the whole day. Sources
//! without energy are left out. beam_of[i] is the source of instant i and
//! sky the source of the diffuse light, or -1 if they carry nothing.
struct DayIllumination {
    Illumination light;
    std::vector<int> beam_of;
    int sky = -1;
};

//! @param row_direction of the field's y axis, clockwise from north [deg]
DayIllumination illuminate(const Day& day, double row_direction);

}  // namespace ideotype
