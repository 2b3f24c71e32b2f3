#include "ideotype/canopy/quantities.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "ideotype/core/error.hpp"
#include "ideotype/core/units.hpp"

namespace ideotype {

namespace {

using Values = std::vector<Estimate>;

//! What is measured, and how it is taken from a report.
struct Declaration {
    Quantity quantity;
    std::function<Values(const CanopyReport&)> take;
    //! By randomisation, of what can be an objective.
    std::function<std::vector<double>(const CanopyReport&)> randomised{};
};

constexpr auto daily = "MJ m-2 day-1";
constexpr Certainty exact = Certainty::exact;

Values to_mj(Values joules) {
    for (Estimate& x : joules) x = scaled(x, 1 / joule_per_megajoule);
    return joules;
}

std::vector<double> leaves_in_mj(const CanopyReport& report, double area) {
    std::vector<double> values = report.leaves_by_randomisation;
    for (double& x : values) x *= 1 / joule_per_megajoule / area;
    return values;
}

//! Of the incident light; nothing of nothing is nothing.
Values fraction(const CanopyReport& report, Estimate BudgetEstimate::*part) {
    const BudgetEstimate& day = report.light.day;
    return {scaled(day.*part, day.incident > 0 ? 1 / day.incident : 0)};
}

constexpr auto extinction = "extinction_coefficient";

//! -ln(1 - fAPAR) / LAI by the delta method. What is left of the light is
//! taken as at least its standard error. A plot alone has none: light enters
//! from its sides.
Values extinction_coefficient(const CanopyReport& report) {
    if (report.boundary == Boundary::isolated) return {};
    const Estimate absorbed = fraction(report, &BudgetEstimate::plants)[0];
    constexpr double least = 1e-9;
    const double left =
        std::max({1 - absorbed.mean, absorbed.standard_error, least});
    return {{-std::log(left) / report.lai,
             absorbed.standard_error / left / report.lai}};
}

Values by_leaf(const CanopyReport& report) {
    Values leaves;
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].tissue == Tissue::leaf)
            leaves.push_back(report.light.groups[g]);
    return leaves;
}

//! All leaves, then each of organ_names() of the plant.
Values by_organ(const CanopyReport& report) {
    Values organs{report.light.day.leaves};
    for (std::size_t g = 0; g < report.groups.size(); ++g)
        if (report.groups[g].tissue != Tissue::leaf)
            organs.push_back(report.light.groups[g]);
    return organs;
}

Values by_hour(const CanopyReport& report) {
    Values hours;
    for (const StepReport& step : report.light.steps)
        hours.push_back(step.budget.leaves);
    return hours;
}

const std::vector<Declaration>& declarations() {
    using Report = CanopyReport;
    static const std::vector<Declaration> all{
        {{"absorbed_par", daily, "PAR that leaves absorb per ground area"},
         [](const Report& r) { return to_mj({r.light.day.leaves}); },
         [](const Report& r) { return leaves_in_mj(r, 1); }},
        {{"absorbed_par_per_leaf_area", daily,
          "PAR that leaves absorb per one-sided leaf area"},
         [](const Report& r) {
             return Values{
                 scaled(r.light.day.leaves, 1 / joule_per_megajoule / r.lai)};
         },
         [](const Report& r) { return leaves_in_mj(r, r.lai); }},
        {{"incident", daily, "PAR on level ground above the canopy", {}, exact},
         [](const Report& r) {
             return to_mj({{r.light.day.incident, 0}});
         }},
        {{"absorbed_fraction", "1",
          "fAPAR of leaves alone: absorbed by them over incident PAR"},
         [](const Report& r) { return fraction(r, &BudgetEstimate::leaves); }},
        {{"stalk_fraction", "1",
          "absorbed by stalks, sheaths and all other organs but leaves over "
          "incident PAR"},
         [](const Report& r) { return fraction(r, &BudgetEstimate::stalks); }},
        {{"fapar", "1",
          "absorbed by leaves and all other organs over incident PAR"},
         [](const Report& r) { return fraction(r, &BudgetEstimate::plants); }},
        {{extinction, "1",
          "of the day's light by leaf area index: -ln(1 - fapar) / lai"},
         extinction_coefficient},
        {{"soil_fraction", "1", "absorbed by the soil over incident PAR"},
         [](const Report& r) { return fraction(r, &BudgetEstimate::soil); }},
        {{"reflected_fraction", "1", "sent back to the sky over incident PAR"},
         [](const Report& r) {
             return fraction(r, &BudgetEstimate::reflected);
         }},
        {{"balance_error",
          "1",
          "largest error of the energy balance of any randomisation over the "
          "light that entered",
          {},
          exact},
         [](const Report& r) {
             return Values{{r.light.balance_error, 0}};
         }},
        {{"paths", "1", "paths of light in all randomisations", {}, exact},
         [](const Report& r) {
             return Values{{static_cast<double>(r.paths), 0}};
         }},
        {{"capped",
          "1",
          "1 if more paths would be needed for the tolerance",
          {},
          exact},
         [](const Report& r) {
             return Values{{r.is_capped ? 1.0 : 0.0, 0}};
         }},
        {{"lai", "m2 m-2", "one-sided leaf area per ground area", {}, exact},
         [](const Report& r) {
             return Values{{r.lai, 0}};
         },
         [](const Report& r) {
             return std::vector<double>(r.leaves_by_randomisation.size(),
                                        r.lai);
         }},
        {{"absorbed_by_leaf", daily, "PAR that each leaf absorbs", {"leaf"}},
         [](const Report& r) { return to_mj(by_leaf(r)); }},
        {{"absorbed_by_organ",
          daily,
          "PAR that leaves and each other organ absorb",
          {"organ"}},
         [](const Report& r) { return to_mj(by_organ(r)); }},
        {{"absorbed_by_layer",
          daily,
          "PAR that leaves in each layer absorb",
          {"layer"}},
         [](const Report& r) { return to_mj(r.light.layers); }},
        {{"absorbed_by_source",
          daily,
          "PAR that leaves absorb, by where it came from at last",
          {"light_source"}},
         [](const Report& r) {
             const BudgetEstimate& day = r.light.day;
             return to_mj(
                 {day.leaves_beam, day.leaves_sky, day.leaves_scattered});
         }},
        {{"absorbed_by_side",
          daily,
          "PAR that each side of leaves absorbs",
          {"leaf_side"}},
         [](const Report& r) {
             return to_mj({r.light.adaxial, r.light.abaxial});
         }},
        {{"absorbed_by_hour",
          "W m-2",
          "PAR that leaves absorb at each instant",
          {"hour"}},
         by_hour},
        {{"absorbed_by_day",
          daily,
          "PAR that leaves absorb on each day",
          {"day"}},
         [](const Report& r) { return to_mj(r.light.dates); }},
    };
    return all;
}

constexpr auto daily_co2 = "mol m-2 day-1";

//! Gross assimilation, by how much lower a figure is, and its scale.
struct Carbon {
    double loss = 0;
    double scale = 1;

    Values operator()(const CanopyReport& report) const {
        const Estimate gross = report.assimilation->gross;
        return {scaled({gross.mean - loss, gross.standard_error}, scale)};
    }
    std::vector<double> randomised(const CanopyReport& report) const {
        std::vector<double> values;
        for (const AssimilationTally& tally : report.assimilation->tallies)
            values.push_back(scale * (tally.gross() - loss));
        return values;
    }
};

//! A figure that can be an objective.
Declaration carbon(const Quantity& quantity,
                   const std::function<Carbon(const CanopyReport&)>& of) {
    return {quantity, [of](const CanopyReport& r) { return of(r)(r); },
            [of](const CanopyReport& r) { return of(r).randomised(r); }};
}

Declaration carbon_part(
    const Quantity& quantity,
    const std::function<Values(const CanopyReport&)>& take) {
    return {quantity, take};
}

//! The groups that are leaves, each lowered by its respiration in the light.
Values net_by_leaf(const CanopyReport& report) {
    Values leaves;
    for (std::size_t g = 0; g < report.groups.size(); ++g) {
        if (report.groups[g].tissue != Tissue::leaf) continue;
        leaves.push_back(report.assimilation->groups[g]);
        leaves.back().mean -= report.assimilation->respiration[g].in_light;
    }
    return leaves;
}

//! Of gross assimilation over absorbed light, to first order.
Values light_use(const CanopyReport& report) {
    constexpr double grams_of_carbon = 12.011;
    const AssimilationReport& all = *report.assimilation;
    const double light = report.light.day.leaves.mean / joule_per_megajoule;
    if (!(light > 0)) return {{}};
    const double ratio = grams_of_carbon * all.gross.mean / light;
    std::vector<double> replicates;
    for (std::size_t r = 0; r < all.tallies.size(); ++r)
        replicates.push_back(
            ratio +
            (grams_of_carbon * all.tallies[r].gross() -
             ratio * report.leaves_by_randomisation[r] / joule_per_megajoule) /
                light);
    return {{ratio, estimate(replicates).standard_error}};
}

const std::vector<Declaration>& assimilation_declarations() {
    using Report = CanopyReport;
    constexpr double grams_of_co2 = 44.0095;
    // Of carbohydrate for each mol of carbon, on a hectare.
    constexpr double tonnes = 30e-6 * 1e4;
    static const std::vector<Declaration> all{
        carbon({"gross_assimilation", daily_co2,
                "CO2 that leaves take up per ground area"},
               [](const Report&) { return Carbon{}; }),
        carbon(
            {"net_assimilation", daily_co2,
             "the same less what they respire while there is light"},
            [](const Report& r) { return Carbon{r.assimilation->net_loss()}; }),
        carbon({"net_assimilation_per_leaf_area", daily_co2,
                "net assimilation per one-sided leaf area"},
               [](const Report& r) {
                   return Carbon{r.assimilation->net_loss(), 1 / r.lai};
               }),
        carbon({"carbon_balance", daily_co2,
                "gross assimilation less what leaves respire day and night "
                "and the carbon that they are built of"},
               [](const Report& r) {
                   return Carbon{r.assimilation->carbon_loss()};
               }),
        carbon_part({"gross_co2", "g m-2 day-1", "gross assimilation"},
                    [](const Report& r) {
                        return Carbon{0, grams_of_co2}(r);
                    }),
        carbon_part(
            {"net_co2", "g m-2 day-1", "net assimilation"},
            [](const Report& r) {
                return Carbon{r.assimilation->net_loss(), grams_of_co2}(r);
            }),
        carbon_part({"dry_matter", "t ha-1",
                     "carbon balance of all days as carbohydrate"},
                    [](const Report& r) {
                        return Carbon{r.assimilation->carbon_loss(),
                                      tonnes * r.days}(r);
                    }),
        carbon_part(
            {"respiration", daily_co2, "of leaves, day and night", {}, exact},
            [](const Report& r) {
                const Respiration sum = r.assimilation->all_respiration();
                return Values{{sum.in_light + sum.at_night, 0}};
            }),
        carbon_part({"sunlit_lai", "m2 m-2",
                     "leaf area index that the sun shines on, a mean over the "
                     "time with any light"},
                    [](const Report& r) {
                        Values mean;
                        if (r.hit_by_sun)
                            mean.push_back(scaled(r.hit_by_sun->mean, r.lai));
                        return mean;
                    }),
        carbon_part({"sunlit_lai_by_hour",
                     "m2 m-2",
                     "leaf area index that the sun shines on at each instant",
                     {"hour"}},
                    [](const Report& r) {
                        Values hours;
                        for (const Estimate& x : r.hit_by_sun->hours)
                            hours.push_back(scaled(x, r.lai));
                        return hours;
                    }),
        carbon_part({"light_use_efficiency", "g MJ-1",
                     "carbon of gross assimilation over absorbed PAR"},
                    light_use),
        carbon_part({"assimilation_by_leaf",
                     daily_co2,
                     "gross assimilation of each leaf",
                     {"leaf"}},
                    [](const Report& r) {
                        Values leaves;
                        for (std::size_t g = 0; g < r.groups.size(); ++g)
                            if (r.groups[g].tissue == Tissue::leaf)
                                leaves.push_back(r.assimilation->groups[g]);
                        return leaves;
                    }),
        carbon_part({"net_assimilation_by_leaf",
                     daily_co2,
                     "net assimilation of each leaf",
                     {"leaf"}},
                    net_by_leaf),
        carbon_part({"assimilation_by_layer",
                     daily_co2,
                     "gross assimilation of leaves in each layer",
                     {"layer"}},
                    [](const Report& r) { return r.assimilation->layers; }),
        carbon_part({"assimilation_by_hour",
                     "umol m-2 s-1",
                     "gross assimilation at each instant",
                     {"hour"}},
                    [](const Report& r) { return r.assimilation->hours; }),
        carbon_part({"assimilation_by_day",
                     daily_co2,
                     "gross assimilation on each day",
                     {"day"}},
                    [](const Report& r) { return r.assimilation->dates; }),
    };
    return all;
}

//! All that a report has.
const std::vector<Declaration>& declared(bool with_assimilation) {
    static const std::vector<Declaration> both = [] {
        std::vector<Declaration> all = declarations();
        const std::vector<Declaration>& more = assimilation_declarations();
        all.insert(all.end(), more.begin(), more.end());
        return all;
    }();
    return with_assimilation ? both : declarations();
}

Axis layer_axis(const Layers& layers) {
    std::vector<double> middles;
    for (std::size_t l = 0; l < layers.count; ++l)
        middles.push_back(layers.thickness * (static_cast<double>(l) + 0.5));
    return {"layer", "m", "height of the middle of the layer above the soil",
            std::move(middles)};
}

Axis hour_axis(const LightSeries& series) {
    return {"hour", "h", "local clock", series.hours()};
}

Axis day_axis(const LightSeries& series) {
    std::vector<std::string> dates;
    for (const Date& date : series.dates()) dates.push_back(to_string(date));
    return {"day", "", "dates on the local clock", std::move(dates)};
}

}  // namespace

QuantitySet canopy_quantities(const Plant& plant, const Layers& layers,
                              const LightSeries& series, Boundary boundary,
                              bool with_assimilation) {
    using Names = std::vector<std::string>;
    QuantitySet set;
    Names organs = organ_names(plant);
    organs.insert(organs.begin(), "leaves");
    set.axes = {
        counted("leaf", "leaf rank, 1 is the lowest", plant.leaves.size(), 1),
        {"organ", "", "leaves together, or another organ", std::move(organs)},
        layer_axis(layers),
        hour_axis(series),
        {"light_source", "", "where light came from at last",
         Names{"beam", "sky", "scattered"}},
        {"leaf_side", "", "upper or lower side of leaves",
         Names{"adaxial", "abaxial"}}};
    const bool has_days = series.days > 1;
    if (has_days) set.axes.push_back(day_axis(series));
    for (const Declaration& each : declared(with_assimilation))
        if ((has_days || each.quantity.axes != Names{"day"}) &&
            (boundary == Boundary::periodic ||
             each.quantity.name != extinction))
            set.quantities.push_back(each.quantity);
    return set;
}

std::vector<Estimate> measure(const CanopyReport& report) {
    Values all;
    for (const Declaration& each : declared(report.assimilation.has_value()))
        for (const Estimate& x : each.take(report)) all.push_back(x);
    return all;
}

std::vector<Measured> measure_numbers(const CanopyReport& report) {
    std::vector<Measured> all;
    for (const Declaration& each : declared(report.assimilation.has_value()))
        if (each.quantity.axes.empty())
            for (const Estimate& x : each.take(report))
                all.push_back({each.quantity, x});
    return all;
}

std::string unit_of(const std::string& quantity) {
    for (const Declaration& each : declared(true))
        if (each.quantity.name == quantity) return each.quantity.unit;
    throw std::out_of_range("no quantity " + quantity);
}

Randomised measure_objective(const std::string& name,
                             const CanopyReport& report) {
    for (const Declaration& each : declared(report.assimilation.has_value()))
        if (each.quantity.name == name && each.randomised)
            return {each.take(report).front(), each.randomised(report)};
    throw Error(name + " is no objective");
}

}  // namespace ideotype
