// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! A Lambertian surface that reflects, transmits and absorbs the rest, the
//! same on both faces.
struct Lambertian {
    double reflectance = 0;
    double transmittance = 0;

    double scattered() const { return reflectance + transmittance; }
};

//! Optical properties of all that light can meet.
struct Optics {
    Lambertian leaf;
    Lambertian stalk;
    double soil_albedo = 0;  //!< Lambertian
    Lambertian sheath{};

    //! What a tissue does with light.
    const Lambertian& of(Tissue tissue) const {
        switch (tissue) {
            case Tissue::stalk:
                return stalk;
            case Tissue::sheath:
                return sheath;
            case Tissue::leaf:
                break;
        }
        return leaf;
    }
};

}  // namespace ideotype
