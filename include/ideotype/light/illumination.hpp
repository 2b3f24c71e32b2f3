// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Light that comes from one direction, or from a sky if there is no direction.
struct Source {
    //! The direction of travel, downwards, with unit length.
    std::optional<glm::dvec3> direction;
    double energy = 0;  //!< energy on horizontal ground [J m-2]
    SkySampler sky;     //!< sky of a source without a direction
    double effort = 1;  //!< paths per energy, relative to other sources
    //! The number of the pose of moving groups that the light meets, other than
    //! all fixed groups.
    std::uint32_t pose = 0;
};

//! The light that falls on a stand, from sources that are traced separately.
struct Illumination {
    std::vector<Source> sources;

    double energy() const;  //!< energy of all sources [J m-2]
};

//! The division of skies of constant shape into sources: one for all instants,
//! or one for each sun. A clear sky always has one for each sun.
enum class Skies { shared, each };

//! The light of a series in the axes of a field: beams from the suns and their
//! skies, each with its energy on a mean day [J m-2 day-1]. Sources without
//! energy are left out. beam_of[i] and sky_of[i] are the sources of instant i,
//! or -1 if there is none. Instants that share a source have parts of its light
//! in proportion to their own light.
struct SeriesIllumination {
    LightSeries series;
    Illumination light;
    std::vector<int> beam_of;
    std::vector<int> sky_of;
    //! The instant that each source has its sun from; 0 for a sky without a
    //! sun.
    std::vector<std::size_t> instant_of{};
};

//! Returns the light of a series.
//! @param row_direction direction of the field's y axis, clockwise from north
//! [deg]
//! @param dates number of dates, from the middles of equal parts of a season,
//! with suns that represent all: each instant has that nearest in direction; 0:
//! each instant has its own sun
SeriesIllumination illuminate(LightSeries series, SkyModel sky_model,
                              double row_direction, Skies skies = Skies::shared,
                              int dates = 0);

//! Returns the light of the same sources in another waveband, in which each
//! instant has its own light from sun and sky. Instants without light in the
//! first band have none here.
SeriesIllumination in_band(SeriesIllumination light,
                           Irradiance TimeStep::*band);

}  // namespace ideotype
