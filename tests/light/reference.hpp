// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "ideotype/core/estimate.hpp"
#include "ideotype/core/mesh.hpp"
#include "ideotype/light/illumination.hpp"
#include "ideotype/light/optics.hpp"
#include "one_band.hpp"

namespace ideotype {

//! Returns the widest instruction set of this processor.
const Device& widest_device();

//! Returns a mesh of tests/data/reference; each OBJ group becomes a group.
Mesh load_reference_mesh(const std::string& name);

//! Returns the period of a reference mesh.
struct GroundPeriod {
    double x, y;
};

inline constexpr GroundPeriod unit_cell{1, 1};

//! Returns the light of a sun that gives unit irradiance on level ground;
//! azimuths count from +y.
Illumination sun_from(double elevation, double azimuth);

//! Returns the light of a sky that gives unit irradiance on level ground.
Illumination sky_of(const SkyRadiance& sky);
Illumination uniform_sky();
Illumination overcast_sky();

//! Fractions of the incident light, with standard errors.
struct Fractions {
    Estimate leaves, soil, reflected;
    std::vector<Estimate> groups;
    double balance_error = 0;
};

//! Returns the fractions in tallies, summed over all sources.
Fractions fractions_of(const std::vector<Tally>& tallies, std::size_t groups,
                       double incident);

Fractions trace(const Mesh& mesh, GroundPeriod period, const Optics& optics,
                const Illumination& light, Accuracy accuracy = {16384, 16},
                std::uint64_t seed = 1);

//! Returns the optics of leaves with a reflectance and a transmittance over
//! soil, without stalks.
Optics leaf_optics(double reflectance, double transmittance,
                   double soil_albedo);

//! Returns the deviation from a reference in combined standard errors.
double deviation(Estimate ours, Estimate reference);

//! Adds a horizontal square that covers a period.
void add_sheet(Mesh& mesh, GroundPeriod period, double height,
               std::uint32_t group);

}  // namespace ideotype
