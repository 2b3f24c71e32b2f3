#include "ideotype/canopy/quantities.hpp"

#include <functional>
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
        {{"absorbed_fraction", "1", "absorbed by leaves over incident PAR"},
         [](const Report& r) { return fraction(r, &BudgetEstimate::leaves); }},
        {{"stalk_fraction", "1",
          "absorbed by stalks, sheaths and all other organs but leaves over "
          "incident PAR"},
         [](const Report& r) { return fraction(r, &BudgetEstimate::stalks); }},
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
                              const LightSeries& series) {
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
    for (const Declaration& each : declarations())
        if (has_days || each.quantity.axes != Names{"day"})
            set.quantities.push_back(each.quantity);
    return set;
}

std::vector<Estimate> measure(const CanopyReport& report) {
    Values all;
    for (const Declaration& each : declarations())
        for (const Estimate& x : each.take(report)) all.push_back(x);
    return all;
}

Randomised measure_objective(const std::string& name,
                             const CanopyReport& report) {
    for (const Declaration& each : declarations())
        if (each.quantity.name == name && each.randomised)
            return {each.take(report).front(), each.randomised(report)};
    throw Error(name + " is no objective");
}

}  // namespace ideotype
