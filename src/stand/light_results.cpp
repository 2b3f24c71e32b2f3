// SPDX-License-Identifier: Apache-2.0
#include "light_results.hpp"

#include <algorithm>

#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

ResultAxis band_axis(const CanopyReport& report) {
    return {"band", mapped(report.bands, &BandReport::name)};
}

ResultAxis component_axis(const CanopyReport& report) {
    return {"component", mapped(report.components, &ComponentReport::name)};
}

//! Returns the axis of groups, with component names if there are several
//! components.
ResultAxis group_axis(const CanopyReport& report) {
    return {"group", mapped(report.groups, [&](const Group& group) {
                return report.components.size() > 1 && !group.id.is_object()
                           ? report.components[group.id.component].name + '_' +
                                 group.name
                           : group.name;
            })};
}

}  // namespace

std::vector<LightResult> budget_results(const BudgetEstimate& budget,
                                        const CanopyReport& report) {
    const bool has_stalks =
        !std::ranges::all_of(report.groups, &SurfaceId::is_leaf, &Group::id);
    std::vector<LightResult> results{
        {"leaf", "leaves", {}, {budget.leaves}},
        {"stalk", "stalks", {}, {budget.organs}, has_stalks},
        {"soil", "soil", {}, {budget.soil}},
        {"reflected", "reflected", {}, {budget.reflected}},
        {"leaf_by_origin",
         "leaves_by_origin",
         {{"origin", {"beam", "sky", "scattered"}}},
         {budget.leaves_beam, budget.leaves_sky, budget.leaves_scattered}}};
    if (report.boundary == Boundary::isolated)
        results.insert(results.begin(),
                       {"entered", "entered", {}, {budget.entered}});
    return results;
}

std::vector<LightResult> part_results(const CanopyReport& report) {
    const DayReport& light = report.par().light;
    return {{"leaf_by_face",
             "leaves_by_side",
             {{"side", {"upper", "lower"}}},
             {light.adaxial, light.abaxial}},
            {"leaf_by_layer", "absorbed_by_layer", {{"layer"}}, light.layers},
            {"groups", "absorbed", {group_axis(report)}, light.groups}};
}

std::vector<LightResult> band_results(const CanopyReport& report) {
    const ResultAxis bands = band_axis(report);
    LightResult components{"components",
                           "absorbed_by_component",
                           {bands, component_axis(report)},
                           {}},
        groups{"groups",
               "absorbed",
               {bands, {"group", mapped(report.groups, &Group::name)}},
               {}},
        soil{"soil", "soil", {bands}, {}},
        reflected{"reflected", "reflected", {bands}, {}};
    for (const BandReport& band : report.bands) {
        for (std::size_t c = 0; c < report.components.size(); ++c)
            components.values.push_back(band.part(c).all);
        groups.values.insert(groups.values.end(), band.light.groups.begin(),
                             band.light.groups.end());
        soil.values.push_back(band.light.day.soil);
        reflected.values.push_back(band.light.day.reflected);
    }
    return {components, groups, soil, reflected};
}

std::vector<LightResult> carbon_results(const CanopyReport& report,
                                        CarbonOf parts, Span span) {
    const AssimilationReport& assimilation = *report.assimilation;
    const FluxReport& uptake = assimilation.before_losses();
    std::vector<ResultAxis> along;
    std::vector<Estimate> gross, net;
    const auto lowered = [&](const Estimate& flux, double loss) {
        return scaled({flux.mean - loss, flux.standard_error},
                      span == Span::single ? 1e6 : 1);
    };
    const auto add = [&](const Estimate& before, const Estimate& flux,
                         const CarbonLoss& loss) {
        gross.push_back(lowered(before, 0));
        net.push_back(lowered(flux, loss.in_light));
    };
    if (parts == CarbonOf::groups) {
        along = {group_axis(report)};
        for (std::size_t g = 0; g < report.groups.size(); ++g)
            add(assimilation.gross.groups[g], uptake.groups[g],
                assimilation.losses[g]);
    } else if (parts == CarbonOf::components) {
        along = {component_axis(report)};
        for (const ComponentAssimilation& each : by_component(
                 assimilation, report.groups, report.components.size()))
            add(each.gross, each.uptake, each.loss);
    } else {
        add(assimilation.gross.sum, uptake.sum, sum_of(assimilation.losses));
    }
    std::vector<LightResult> results{
        {"gross", "gross_assimilation", along, gross},
        {"net", "net_assimilation", along, net}};
    if (parts == CarbonOf::all && span == Span::day)
        results.push_back(
            {"carbon_balance",
             nullptr,
             {},
             {lowered(uptake.sum, sum_of(assimilation.losses).all())}});
    return results;
}

std::vector<Measured> numbers_of(const CanopyReport& report, Span span) {
    std::vector<Measured> numbers = measure_numbers(report);
    if (span == Span::single)
        std::erase_if(numbers, [](const Measured& each) {
            return each.quantity.unit != "1" && each.quantity.unit != "m2 m-2";
        });
    return numbers;
}

}  // namespace ideotype
