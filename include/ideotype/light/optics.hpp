#pragma once

#include <cstdint>

namespace ideotype {

//! A Lambertian surface that reflects, transmits and absorbs the rest, the
//! same on both faces.
struct Lambertian {
    double reflectance = 0;
    double transmittance = 0;
};

//! Optical properties of all that light can meet.
struct Optics {
    Lambertian leaf;
    Lambertian stalk;
    double soil_albedo = 0;  //!< Lambertian
};

//! How much work one estimate of the light may cost.
struct Sampling {
    int paths = 4096;        //!< per randomisation; with a tolerance at most
    int randomisations = 8;  //!< independent, at least 2
    //! Relative standard error of the leaves' light that will do; 0: none, as
    //! many paths as given.
    double tolerance = 0;

    //! Of all randomisations.
    std::uint64_t all_paths() const {
        return static_cast<std::uint64_t>(paths) *
               static_cast<std::uint64_t>(randomisations);
    }
};

}  // namespace ideotype
