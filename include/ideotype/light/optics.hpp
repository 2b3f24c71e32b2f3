// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ideotype {

//! A Lambertian face that reflects, transmits and absorbs the rest of the light
//! that comes to it.
struct Lambertian {
    double reflectance = 0;
    double transmittance = 0;

    double scattered() const { return reflectance + transmittance; }
};

//! A thin sheet in one waveband. Its faces may reflect differently; as much
//! light passes from one face to the other as back (Helmholtz reciprocity).
struct Material {
    Lambertian adaxial;
    Lambertian abaxial;

    constexpr Material() = default;
    //! Makes a sheet whose faces are alike.
    constexpr explicit Material(const Lambertian& both)
        : adaxial(both), abaxial(both) {}
    constexpr Material(double reflectance, double transmittance)
        : Material(reflectance, reflectance, transmittance) {}
    constexpr Material(double reflectance_of_adaxial,
                       double reflectance_of_abaxial, double transmittance)
        : adaxial{reflectance_of_adaxial, transmittance},
          abaxial{reflectance_of_abaxial, transmittance} {}

    const Lambertian& face(bool is_adaxial) const {
        return is_adaxial ? adaxial : abaxial;
    }

    //! Returns the largest part of light that either face absorbs.
    double most_absorbed() const {
        return 1 - std::min(adaxial.scattered(), abaxial.scattered());
    }
    //! Returns the largest part of light that either face scatters.
    double most_scattered() const {
        return std::max(adaxial.scattered(), abaxial.scattered());
    }
};

//! The optical properties, in one waveband, of all that light can meet.
struct Optics {
    //! Materials, to which Group::material points.
    std::vector<Material> materials;
    double soil_albedo = 0;  //!< Lambertian

    //! Returns a material; one that is not listed absorbs all light.
    const Material& of(std::uint32_t material) const {
        static constexpr Material black;
        return material < materials.size() ? materials[material] : black;
    }

    //! Returns the largest part of light that anything scatters.
    double most_scattered() const {
        double most = soil_albedo;
        for (const Material& each : materials)
            most = std::max(most, each.most_scattered());
        return most;
    }
};

}  // namespace ideotype
