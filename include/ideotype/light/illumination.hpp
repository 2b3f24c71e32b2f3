// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/sky_sampler.hpp"
#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! A light source: parallel light from one direction, or a sky if there is no
//! direction.
struct Source {
    //! The direction of travel, downwards, of unit length.
    std::optional<glm::dvec3> direction;
    double energy = 0;  //!< energy on horizontal ground [J m-2]
    SkySampler sky;     //!< sky of a source without a direction
    double effort = 1;  //!< paths per energy, relative to other sources
    //! Orientation index: the light meets all fixed groups, but only those
    //! moving groups that have this index.
    std::uint32_t pose = 0;
};

//! The light incident on a stand, from sources that are traced separately.
struct Illumination {
    std::vector<Source> sources;

    double energy() const;  //!< energy of all sources [J m-2]
};

//! Whether skies of constant shape form one source for all instants or one for
//! each sun position. A clear sky always forms one for each sun position.
enum class Skies { shared, each };

//! The light of a series in the axes of a field: beams and skies as sources,
//! each with its energy on a mean day [J m-2 day-1]. Sources without energy are
//! omitted. beam_of[i] and sky_of[i] are the indices of the sources of instant
//! i, or -1 if there is none. Instants that share a source divide its light in
//! proportion to their incident light.
struct SeriesIllumination {
    LightSeries series;
    Illumination light;
    std::vector<int> beam_of;
    std::vector<int> sky_of;
    //! For each source, the instant that provides its sun position; 0 for a sky
    //! without a sun.
    std::vector<std::size_t> instant_of{};
};

//! Converts a series to light sources.
//! @param row_direction direction of the field's y axis, clockwise from north
//! [deg]
//! @param dates number of dates that provide sun positions for the whole
//! series. They are the middle dates of equal parts of the season; each instant
//! uses the nearest direction among these positions. 0: each instant uses its
//! actual sun position
SeriesIllumination illuminate(LightSeries series, SkyModel sky_model,
                              double row_direction, Skies skies = Skies::shared,
                              int dates = 0);

//! Returns the light of the same sources in another waveband, with the energies
//! that each instant's sun and sky have in that band. Instants without light in
//! the first band are dark here too.
SeriesIllumination in_band(SeriesIllumination light,
                           Irradiance TimeStep::*band);

}  // namespace ideotype
