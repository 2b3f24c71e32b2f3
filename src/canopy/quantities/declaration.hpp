// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

//! Takes a single number from a report; nothing if the report lacks it.
using TakeNumber =
    std::function<std::optional<Randomised>(const CanopyReport&)>;

//! Takes the numbers of a quantity that has axes.
using TakeNumbers = std::function<std::vector<Estimate>(const CanopyReport&)>;

//! Takes the numbers of a quantity with axes, by randomisation too.
using TakeProfile = std::function<std::vector<Randomised>(const CanopyReport&)>;

inline constexpr double grams_of_carbon = 12.011;  //!< molar mass [g mol-1]

// Units of light and CO2 on a mean day, per ground area.
inline constexpr auto daily = "MJ m-2 day-1", rate = "mol m-2 day-1";

//! Returns a quantity along axes.
inline Quantity by(std::vector<std::string> axes, Quantity quantity) {
    quantity.axes = std::move(axes);
    return quantity;
}

//! Returns a quantity without error.
inline Quantity exact(Quantity quantity) {
    quantity.certainty = Certainty::exact;
    return quantity;
}

//! A description of a canopy by what can be measured in it.
struct Scope {
    std::size_t components = 1;
    std::vector<std::string> bands;
    bool assimilates = false;
    bool has_form = false;
    bool has_lines = false;
    bool has_rows = false;  //!< whether rows are told apart
    bool has_objects = false;
    bool has_panels = false;
    bool grows = false;
    bool has_water = false;
    bool has_living_organs = false;

    bool has_band(const std::string& name) const {
        return std::find(bands.begin(), bands.end(), name) != bands.end();
    }
};

//! A quantity: its name and unit, its mean over a season, and the way to take
//! it from a report.
struct Declaration {
    Quantity quantity;
    MeanOver mean_over;
    std::variant<TakeNumber, TakeNumbers, TakeProfile> take;
    //! Whether a canopy has the quantity. None: a canopy has it if it has the
    //! other quantities of the list.
    std::function<bool(const Scope&)> is_in{};
    bool is_of_method = false;  //!< whether the quantity describes the method
    //! Returns the names that the number counts. None: it is a measure.
    std::function<std::vector<std::string>(const Details&)> names{};
};

//! Returns the quantities that a canopy has, in the order of their columns.
std::vector<const Declaration*> declared(const Scope& scope);

//! Returns whether any object is a panel.
template <class Object>
bool has_panels(const std::vector<Object>& objects) {
    return std::ranges::any_of(objects, &Object::is_panel);
}

//! Returns the quantities of one kind in the order of columns; the columns of
//! one list follow those of the previous list. Light is PAR, parts are several
//! components or bands, and objects include the ground beside them.
std::vector<Declaration> light_quantities();
std::vector<Declaration> assimilation_quantities();
std::vector<Declaration> form_quantities();
std::vector<Declaration> line_quantities();
std::vector<Declaration> part_quantities();
std::vector<Declaration> row_quantities();
std::vector<Declaration> object_quantities();
std::vector<Declaration> water_quantities();

inline Randomised scaled(Randomised x, double factor) {
    x.estimate = scaled(x.estimate, factor);
    for (double& value : x.by_randomisation) value *= factor;
    return x;
}

//! Returns the mean of values with an error not below the least one.
inline Randomised known_to(double least, std::vector<double> values) {
    Estimate mean = estimate(values);
    mean.standard_error = std::max(mean.standard_error, least);
    return {mean, std::move(values)};
}

//! Combines the numbers of all places with the numbers of each randomisation
//! [randomisation, place].
inline std::vector<Randomised> randomised(
    const std::vector<Estimate>& estimates,
    const std::vector<std::vector<double>>& by_randomisation,
    double factor = 1) {
    std::vector<Randomised> all;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        Randomised one{estimates[i], {}};
        for (const std::vector<double>& each : by_randomisation) {
            IDEOTYPE_EXPECT(each.size() == estimates.size());
            one.by_randomisation.push_back(each[i]);
        }
        all.push_back(scaled(std::move(one), factor));
    }
    return all;
}

//! The respiration and building by which a number is less than gross
//! assimilation.
enum class Loss {
    none,         //!< gross assimilation
    in_light,     //!< net assimilation
    respiration,  //!< carbon from which all organs grow
    all,          //!< carbon balance
};

//! Returns a loss, apart from respiration that
//! AssimilationReport::before_losses() contains already [mol m-2 day-1].
inline double amount(const CarbonLoss& losses, Loss loss) {
    switch (loss) {
        case Loss::none:
            break;
        case Loss::in_light:
            return losses.in_light;
        case Loss::respiration:
            return losses.respired();
        case Loss::all:
            return losses.all();
    }
    return 0;
}

//! Returns the flux from which amount() of a loss is taken.
inline const FluxReport& flux_before(const AssimilationReport& report,
                                     Loss loss) {
    return loss == Loss::none ? report.gross : report.before_losses();
}

//! Returns assimilation lowered by losses. Fields with more leaves lose more,
//! so that errors are those of differences.
//! @param mean,flux flux_before() the loss, and its values by randomisation
//! @param losses losses by randomisation; none: all have the mean loss
inline Randomised lowered(const Estimate& mean, std::vector<double> flux,
                          const CarbonLoss& lost,
                          const std::vector<CarbonLoss>& losses, Loss loss) {
    Randomised net{{mean.mean - amount(lost, loss), mean.standard_error},
                   std::move(flux)};
    for (std::size_t r = 0; r < net.by_randomisation.size(); ++r)
        net.by_randomisation[r] -=
            amount(losses.empty() ? lost : losses[r], loss);
    if (!losses.empty())
        net.estimate.standard_error =
            estimate(net.by_randomisation).standard_error;
    return net;
}

//! Returns the assimilation of all leaves lowered by a loss.
Randomised assimilation_of_all(const AssimilationReport& report, Loss loss);

//! Returns a value that is the same in all randomisations.
inline Randomised certain(const CanopyReport& report, double value) {
    return {{value, 0}, std::vector(report.randomisations(), value)};
}

//! Returns a flux along groups or layers.
inline std::vector<Randomised> along(const std::vector<FluxTally>& tallies,
                                     const std::vector<Estimate>& found,
                                     std::vector<double> FluxTally::*part) {
    return randomised(found, mapped(tallies, part));
}

//! Returns a ratio with its error to first order.
//! @param left function for the numerator of a randomisation less the ratio
//! times its denominator
template <class Left>
Randomised ratio_with_error(double ratio, double denominator,
                            std::size_t randomisations, const Left& left) {
    Randomised result{{ratio, 0}, {}};
    for (std::size_t r = 0; r < randomisations; ++r)
        result.by_randomisation.push_back(ratio + left(r) / denominator);
    result.estimate.standard_error =
        estimate(result.by_randomisation).standard_error;
    return result;
}

//! Returns a number per leaf area of fields, or 0 without leaves, with errors
//! to first order.
//! @param lai mean leaf area index of all fields
inline Randomised per_leaf_area(const CanopyReport& report,
                                const Randomised& number, double lai,
                                double LeafArea::*of) {
    if (!(lai > 0)) return certain(report, 0);
    const double ratio = number.estimate.mean / lai;
    Randomised result = ratio_with_error(
        ratio, lai, report.randomisations(), [&](std::size_t r) {
            return number.by_randomisation[r] -
                   ratio * (report.leaf_area_by_randomisation[r].*of);
        });
    // The error of a number is larger than the scatter of its randomisations
    // tells where these agree by chance.
    const double scatter = estimate(number.by_randomisation).standard_error;
    const double error = number.estimate.standard_error;
    if (error > scatter)
        result.estimate.standard_error =
            std::hypot(result.estimate.standard_error,
                       std::sqrt(error * error - scatter * scatter) / lai);
    return result;
}

//! Returns a number per area of all leaves.
inline Randomised per_leaf_area(const CanopyReport& report,
                                const Randomised& number) {
    return per_leaf_area(report, number, report.lai, &LeafArea::all);
}

//! Sums numbers of groups over those that are wanted by their SurfaceId.
double over_groups(const CanopyReport& report,
                   const std::vector<double>& groups, const auto& is_wanted) {
    IDEOTYPE_EXPECT(groups.size() == report.groups.size());
    double sum = 0;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (is_wanted(report.groups[g].id)) sum += groups[g];
    return sum;
}

//! Sums numbers of groups over the leaves of a component.
inline double over_leaves(const CanopyReport& report,
                          const std::vector<double>& groups,
                          std::size_t component) {
    return over_groups(report, groups, [&](const SurfaceId& id) {
        return id.is_leaf() && id.component == component;
    });
}

//! Sums numbers of groups over all organs of a component.
inline double over_plants(const CanopyReport& report,
                          const std::vector<double>& groups,
                          std::size_t component) {
    return over_groups(report, groups, [&](const SurfaceId& id) {
        return id.component == component;
    });
}

//! Returns the numbers of the groups that are leaves.
template <class Number>
std::vector<Number> of_leaves(const CanopyReport& report,
                              const std::vector<Number>& groups) {
    std::vector<Number> leaves;
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (report.groups[g].id.is_leaf()) leaves.push_back(groups[g]);
    return leaves;
}

}  // namespace ideotype
