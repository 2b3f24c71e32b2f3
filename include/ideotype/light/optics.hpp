// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace ideotype {

//! A Lambertian face: it reflects and transmits fractions of the incident light
//! and absorbs the rest.
struct Lambertian {
    double reflectance = 0;
    double transmittance = 0;

    double scattered() const { return reflectance + transmittance; }
};

//! A thin sheet in one waveband. Its faces may reflect differently;
//! transmittance is equal from both faces (Helmholtz reciprocity).
struct Material {
    Lambertian adaxial;
    Lambertian abaxial;

    constexpr Material() = default;
    //! Makes a sheet with identical faces.
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

    //! Returns the absorptance of the more absorbing face.
    double most_absorbed() const {
        return 1 - std::min(adaxial.scattered(), abaxial.scattered());
    }
    //! Returns the scattered fraction of the more scattering face.
    double most_scattered() const {
        return std::max(adaxial.scattered(), abaxial.scattered());
    }
};

//! The optical properties, in one waveband, of all surfaces.
struct Optics {
    //! The materials; Group::material is an index into this list.
    std::vector<Material> materials;
    double soil_albedo = 0;  //!< reflectance of the Lambertian soil

    //! Returns a material by its index. Unlisted materials absorb all light.
    const Material& of(std::uint32_t material) const {
        static constexpr Material black;
        return material < materials.size() ? materials[material] : black;
    }

    //! Returns the largest fraction of light that any material or the soil
    //! scatters.
    double most_scattered() const {
        double most = soil_albedo;
        for (const Material& each : materials)
            most = std::max(most, each.most_scattered());
        return most;
    }
};

}  // namespace ideotype
