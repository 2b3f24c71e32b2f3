// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ideotype/canopy/quantities.hpp"

namespace ideotype {

//! Extracts a single number from a report; nothing if the report lacks it.
using TakeNumber =
    std::function<std::optional<Randomised>(const CanopyReport&)>;

//! Extracts the numbers of a quantity with axes.
using TakeNumbers = std::function<std::vector<Estimate>(const CanopyReport&)>;

//! Extracts the numbers of a quantity with axes, including values by
//! randomisation.
using TakeProfile = std::function<std::vector<Randomised>(const CanopyReport&)>;

inline constexpr double grams_of_carbon = 12.011;  //!< molar mass [g mol-1]

// Units of light and CO2 on a mean day, per ground area.
inline constexpr auto daily = "MJ m-2 day-1", rate = "mol m-2 day-1";

//! Returns a quantity along axes.
inline Quantity by(std::vector<std::string> axes, Quantity quantity) {
    quantity.axes = std::move(axes);
    return quantity;
}

//! Marks a quantity as exact.
inline Quantity exact(Quantity quantity) {
    quantity.certainty = Certainty::exact;
    return quantity;
}

//! The properties of a canopy that determine its quantities.
struct Scope {
    std::size_t components = 1;
    std::vector<std::string> bands;
    bool assimilates = false;
    bool has_form = false;
    bool has_lines = false;
    bool has_rows = false;  //!< whether rows are distinguished
    bool has_objects = false;
    bool has_panels = false;
    bool grows = false;
    bool has_water = false;
    bool has_living_organs = false;
    bool has_soil = false;    //!< whether the season has soil that dries
    bool has_grain = false;   //!< whether the season has grain
    bool has_prices = false;  //!< whether the season has prices

    bool has_band(const std::string& name) const {
        return std::find(bands.begin(), bands.end(), name) != bands.end();
    }
};

//! A quantity: its name and unit, the way it is averaged over a season, and a
//! function that extracts it from a report.
struct Declaration {
    Quantity quantity;
    MeanOver mean_over;
    std::variant<TakeNumber, TakeNumbers, TakeProfile> take;
    //! Whether a canopy has this quantity. None: a canopy that has the other
    //! quantities of the list has this one too.
    std::function<bool(const Scope&)> is_in{};
    bool is_of_method = false;  //!< whether the quantity describes the method
    //! Returns the names that the value refers to by number. None: the value is
    //! a measurement.
    std::function<std::vector<std::string>(const Details&)> names{};
};

//! Returns the quantities of a canopy in the order of their columns.
std::vector<const Declaration*> declared(const Scope& scope);

//! Returns the light on both sides of panels in all bands, per area of ground
//! [MJ m-2 day-1].
Randomised light_on_panels(const CanopyReport& report);

//! Returns whether any object is a panel.
template <class Object>
bool has_panels(const std::vector<Object>& objects) {
    return std::ranges::any_of(objects, &Object::is_panel);
}

//! Return the quantities of one kind in the order of columns; the columns of
//! each list follow those of the previous list. Light quantities are for PAR,
//! part quantities for several components or bands. Object quantities include
//! the ground around objects.
std::vector<Declaration> light_quantities();
std::vector<Declaration> assimilation_quantities();
std::vector<Declaration> form_quantities();
std::vector<Declaration> line_quantities();
std::vector<Declaration> part_quantities();
std::vector<Declaration> row_quantities();
std::vector<Declaration> object_quantities();
std::vector<Declaration> water_quantities();
std::vector<Declaration> season_quantities();

}  // namespace ideotype
