#pragma once

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

}  // namespace ideotype
