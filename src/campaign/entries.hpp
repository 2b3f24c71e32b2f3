// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/canopy/field.hpp"
#include "ideotype/canopy/panels.hpp"
#include "ideotype/canopy/scene.hpp"
#include "ideotype/climate/light_series.hpp"
#include "ideotype/climate/weather.hpp"
#include "ideotype/core/range.hpp"
#include "ideotype/crop/crop.hpp"
#include "ideotype/crop/measured_lines.hpp"
#include "ideotype/physiology/photosynthesis.hpp"

namespace ideotype {

//! The traits that may be bred; all others keep the baseline's values.
using TraitSet = std::vector<std::string>;

//! A limit of the first measure that a trait acts on, in the unit of this
//! measure. A plant must keep to the limit however it is bred.
struct TraitConstraint {
    std::string trait;
    double step = 0;          //!< largest step from leaf to leaf; 0: any
    Range total{0, 1e9};      //!< total of all leaves
    bool is_falling = false;  //!< no leaf may exceed the leaf below
    //! Largest angle between a leaf and a plane to whose two sides leaves
    //! alternate [deg]; 0: any.
    double distichous = 0;
    Range range{-1e9, 1e9};  //!< range of each leaf
    int highest = 0;         //!< limited leaves, from the top down; 0: all
};

//! Returns whether a limit restricts anything.
bool constrains(const TraitConstraint& limit);

//! All limits that a plant must keep to. A plant that breaks limits is worse
//! than any plant that keeps to all, by its violation().
struct Constraints {
    Range lai{0, 1000};  //!< one-sided leaf area index [m2 m-2]
    std::vector<TraitConstraint> traits;
};

//! Returns how far a plant fails its constraints: the sum of the excesses over
//! all limits, each relative to its limit; 0 if all are met.
//! @param traits traits of the plant's crop
//! @param lai leaf area index of the plant in its stand
double violation(const Constraints& constraints,
                 const std::vector<Trait>& traits, const Plant& plant,
                 double lai);

//! The measured lines near which plants of the crop must stay.
struct Feasibility {
    std::optional<MeasuredLines> lines;
    //! Largest distance from the mean of the lines, see LineDistance; the
    //! excess over it, relative to it, is a violation. 0: no limit.
    double limit = 0;
};

//! The weather of a period from a file.
struct Climate {
    std::string file;  //!< path as written; "": each site has its own
    Period period;
    std::string stamp;  //!< time stamp; "": as in the format
    ColumnMap columns;
    std::optional<double> wind_height;  //!< height above the ground [m]
    std::optional<double> co2;          //!< CO2 of the air [umol mol-1]
    Date emergence{0, 1, 1};            //!< day; year 0: plants do not grow

    bool grows() const { return emergence.year > 0; }
};

//! The weather of a site in a climate, as it was read.
struct SiteWeather {
    std::string site, climate;  //!< names of the site and the climate
    std::string sha256;         //!< SHA-256 of the weather file
    double utc_offset = 0;      //!< time of dates and hours, from UTC [h]
    std::vector<Date> dates;
    std::vector<double> hours;  //!< middle of each step of a day [h]
    //! Light on a horizontal plane, date by date and hour by hour [W m-2];
    //! empty in wavebands that the campaign does not follow.
    ByBand<std::vector<double>> beam, diffuse;
    //! Air temperature [deg C], relative humidity (0 to 1), wind [m s-1],
    //! pressure [kPa] and longwave radiation of the sky [W m-2]; may be empty.
    std::vector<double> temperature, humidity, wind, pressure, longwave;
};

//! The places of the plants of a component in the field.
struct Standing {
    std::vector<int> rows{};  //!< rows of the field, from 0
    //! Number of places of bred plants that the component takes instead of
    //! rows, drawn for each field. 0: none.
    int mixed = 0;
    int plants = 0;                  //!< plants per row; 0: as in the field
    int later = 0;                   //!< delay of emergence after the crop [d]
    std::optional<double> jitter{};  //!< jitter instead of the field's [deg]
    std::optional<PlantVariation> variation{};  //!< variation of its own
};

//! A number of a model of leaves.
struct LeafNumber {
    std::string name;
    std::vector<double> values;  //!< value of all leaves, or of each; none: see
                                 //!< docs/campaign_files.md
    std::string file;            //!< file that states the number; "": default
    bool is_capacity = false;    //!< whether it is a capacity of assimilation
};

//! The photosynthesis of a component, and the files that state it.
struct StatedLeaves {
    std::string crop, model;
    std::string file;  //!< file that states the model; "": default
    std::vector<LeafNumber> numbers;
};

//! A kind of plant that stands in the field beside that of the campaign's crop.
struct ComponentEntry {
    std::string name;
    Standing standing;
    Crop crop;
    std::vector<Range> bounds;  //!< bounds of trait_numbers(crop)
    TraitSet free;              //!< bred traits; none: not bred
    ByBand<PlantOptics> optics;
    //! Model of assimilation, if leaves assimilate.
    std::optional<Photosynthesis> photosynthesis{};
    Stomata stomata{};  //!< stomata, if leaves exchange water
};

//! Rows of panels in a campaign, with the optics of panels in each band.
struct PanelEntry {
    PanelRows rows;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.05, 0}, {.15, 0}});
};

//! An object in the field of a campaign that repeats with the field.
struct ObjectEntry {
    std::string name;
    std::string file;  //!< OBJ file as written
    double x = 0, y = 0, z = 0, turn = 0;
    ByBand<Lambertian> optics = std::to_array<Lambertian>({{.4, 0}, {.4, 0}});
    //! Content of the file: three coordinates of each vertex [m], and four
    //! vertex numbers of each face, from 0.
    std::vector<double> vertices, faces;
};

}  // namespace ideotype
