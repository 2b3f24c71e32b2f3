// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Light that comes from one direction, or, without one, from a sky.
struct Source {
    //! Direction of travel, unit length, downwards.
    std::optional<glm::dvec3> direction;
    double energy = 0;  //!< on horizontal ground [J m-2]
    SkySampler sky;     //!< used if there is no direction
    double effort = 1;  //!< paths for its energy, relative to other sources
    //! The pose whose groups the light meets, besides all that stands.
    std::uint32_t pose = 0;
};

//! The light that falls on a stand, from sources that are each traced for
//! themselves.
struct Illumination {
    std::vector<Source> sources;

    double energy() const;  //!< [J m-2]
};

//! Tells whether a sky whose shape does not change is one source for all
//! instants, or one for each sun, as a clear one always is.
enum class Skies { shared, each };

//! The light of a series in the axes of a field: beams from the suns and their
//! skies, each with its energy on a mean day [J m-2 day-1]. Sources without
//! energy are left out. beam_of[i] and sky_of[i] are the sources of instant
//! i, or -1 if it has none. Instants may share a source, in which each has its
//! part by the light that it has itself.
struct SeriesIllumination {
    LightSeries series;
    Illumination light;
    std::vector<int> beam_of;
    std::vector<int> sky_of;
    //! The instant whose sun each source has; 0 for a sky without one.
    std::vector<std::size_t> instant_of{};
};

//! Returns the light of a series.
//! @param row_direction of the field's y axis, clockwise from north [deg]
//! @param dates the suns of so many dates of a season, each from the middle of
//! an equal part, stand for all: the nearest in direction for each instant; 0:
//! each instant has its own
SeriesIllumination illuminate(LightSeries series, SkyModel sky_model,
                              double row_direction, Skies skies = Skies::shared,
                              int dates = 0);

//! Returns the light of the same sources in another waveband, in which each
//! instant has its own light from sun and sky. Light of instants that have none
//! in the first band is left out.
SeriesIllumination in_band(SeriesIllumination light,
                           Irradiance TimeStep::*band);

}  // namespace ideotype
