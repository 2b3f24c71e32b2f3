// SPDX-License-Identifier: Apache-2.0
#include "ideotype/fidelity/parameters.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ideotype/stand/stand.hpp"

namespace ideotype {

namespace {

//! Values that every campaign is tried with; its own is added.
constexpr std::array cells_along{4, 6, 8, 12, 16, 24, 32};
constexpr std::array stalk_sides{3, 4, 6, 8, 12, 24};
constexpr std::array plants{1, 2, 3, 4, 6};
constexpr std::array step_minutes{15.0, 30.0, 60.0, 120.0, 240.0};
constexpr std::array sun_dates{1, 2, 3, 4, 6, 12};
constexpr std::array paths{256, 1024, 4096, 16384};
constexpr std::array<std::size_t, 4> pieces{12, 24, 48, 96};

//! Paths of one randomisation where they are not what is compared: few, since
//! a draw of a new field tells more than more paths through the same one. Only
//! for cells there are more, to tell the scatter of fields from that of paths.
constexpr int usual_paths = 1024;

//! A parameter whose values are sorted numbers, of which the last is converged.
template <class Numbers, class Number, class Name, class Apply>
Parameter ladder(const std::string& name, const Numbers& numbers, Number own,
                 Name name_of, Apply apply) {
    std::vector<Number> sorted(numbers.begin(), numbers.end());
    if (std::find(sorted.begin(), sorted.end(), own) == sorted.end())
        sorted.push_back(own);
    std::sort(sorted.begin(), sorted.end());
    Parameter parameter;
    parameter.name = name;
    for (const Number& x : sorted)
        parameter.values.push_back(
            {name_of(x), [apply, x](Variant& variant) { apply(variant, x); }});
    parameter.reference = sorted.size() - 1;
    parameter.own = static_cast<std::size_t>(
        std::find(sorted.begin(), sorted.end(), own) - sorted.begin());
    return parameter;
}

std::string number_name(double x) {
    return fmt::format("{}", x);
}

bool divides(double step, const DaySpan& span) {
    const double steps = (span.end - span.start) * 60 / step;
    return steps >= 1 && std::abs(steps - std::round(steps)) < 1e-9;
}

Parameter cell_parameter(const Campaign& campaign) {
    using Cell = std::pair<int, int>;
    std::vector<Cell> cells;
    for (const int n : plants) cells.push_back({n, n});
    Parameter parameter = ladder(
        "cell", cells, Cell{campaign.field.rows, campaign.field.plants},
        [](const Cell& c) { return fmt::format("{}x{}", c.first, c.second); },
        [](Variant& variant, const Cell& c) {
            variant.campaign.field.rows = c.first;
            variant.campaign.field.plants = c.second;
        });
    return parameter;
}

Parameter step_parameter(const DaySpan& span) {
    std::vector<double> finer_last;
    for (const double step : step_minutes)
        if (divides(step, span)) finer_last.push_back(-step);
    return ladder(
        "step_minutes", finer_last, -span.step_minutes,
        [](double x) { return number_name(-x); },
        [](Variant& variant, double x) {
            for (auto& day : variant.campaign.days) day.value.step_minutes = -x;
        });
}

//! Control volumes of a campaign: pieces are no smaller than faces, of which
//! blades have two across.
std::size_t own_pieces(const Campaign& campaign) {
    return std::min(
        pieces_of_blade,
        2 * static_cast<std::size_t>(campaign.tessellation.cells_along));
}

Parameter pieces_parameter(const Campaign& campaign) {
    Parameter parameter = ladder(
        "pieces", pieces, own_pieces(campaign),
        [](std::size_t n) { return fmt::format("{}", n); },
        [](Variant& variant, std::size_t n) { variant.pieces = n; });
    parameter.kind = Parameter::Kind::omission;
    return parameter;
}

bool is_black(const Lambertian& surface) {
    return surface.reflectance + surface.transmittance == 0;
}

//! Plants without some of their organs.
Parameter organs_parameter(const Plant& plant) {
    Parameter parameter;
    parameter.name = "organs";
    parameter.kind = Parameter::Kind::omission;
    parameter.values.push_back({"all", [](Variant&) {}});
    for (const std::string& name : organ_names(plant))
        parameter.values.push_back(
            {"without " + name, [name](Variant& variant) {
                 set_present(variant.campaign.crop.baseline, name, false);
             }});
    return parameter;
}

Parameter scattering_parameter(const Optics& optics, const Plant& plant) {
    Parameter parameter;
    parameter.name = "scattering";
    parameter.kind = Parameter::Kind::omission;
    parameter.values.push_back({"full", [](Variant&) {}});
    const auto set = [](auto change) {
        return [change](Variant& variant) { change(variant.campaign.optics); };
    };
    if (optics.soil_albedo > 0)
        parameter.values.push_back(
            {"black soil", set([](Optics& o) { o.soil_albedo = 0; })});
    if (!is_black(optics.leaf))
        parameter.values.push_back(
            {"black leaves", set([](Optics& o) { o.leaf = {}; })});
    if (plant.stalk.is_present && !is_black(optics.stalk))
        parameter.values.push_back(
            {"black stalks", set([](Optics& o) { o.stalk = {}; })});
    if (plant.sheath.is_present && !is_black(optics.sheath))
        parameter.values.push_back(
            {"black sheaths", set([](Optics& o) { o.sheath = {}; })});
    if (parameter.values.size() > 2)
        parameter.values.push_back({"off", set([](Optics& o) { o = {}; })});
    return parameter;
}

Parameter sky_parameter(const Campaign& campaign) {
    Parameter parameter;
    parameter.name = "sky";
    if (campaign.sky_model == SkyModel::clear) {
        parameter.kind = Parameter::Kind::omission;
        parameter.values = {{"clear, each instant", [](Variant&) {}},
                            {"uniform, shared", [](Variant& variant) {
                                 variant.campaign.sky_model = SkyModel::uniform;
                             }}};
    } else {
        parameter.kind = Parameter::Kind::arrangement;
        parameter.values = {{"shared by all instants", [](Variant&) {}},
                            {"one for each instant", [](Variant& variant) {
                                 variant.skies = Skies::each;
                             }}};
    }
    return parameter;
}

Parameter split_parameter() {
    Parameter parameter;
    parameter.name = "sky_paths";
    parameter.kind = Parameter::Kind::arrangement;
    for (const double effort : {1.0, 0.5, 2.0})
        parameter.values.push_back(
            {fmt::format("x {}", effort),
             [effort](Variant& variant) { variant.sky_effort = effort; }});
    return parameter;
}

//! Fewer paths than sources would be as many as those.
int fewest_paths(const Parameter& instants, const Variant& own,
                 std::size_t case_index) {
    Variant finest = own;
    instants.values[instants.reference].apply(finest);
    const Scenario scenario =
        scenario_of(finest.campaign, case_of(finest, case_index));
    int count = usual_paths;
    while (count < static_cast<int>(scenario.light.light.sources.size()))
        count *= 2;
    return count;
}

//! The suns that are traced: of the time steps of a day, or of the dates of a
//! season.
Parameter instants_parameter(const Campaign& campaign, const DaySpan& span) {
    if (campaign.climates.empty()) return step_parameter(span);
    return ladder(
        "dates", sun_dates, campaign.sun_dates, number_name,
        [](Variant& variant, int n) { variant.campaign.sun_dates = n; });
}

}  // namespace

Variant Parameter::at(std::size_t value) const {
    Variant variant = base;
    values.at(value).apply(variant);
    return variant;
}

bool Parameter::may_be_biased() const {
    if (kind == Kind::paths) return asks_for_assimilation(base.campaign);
    return kind != Kind::arrangement;
}

Case case_of(const Variant& variant, std::size_t case_index) {
    return cases(variant.campaign).at(case_index);
}

CanopyRequest request_of(const Variant& variant, std::size_t case_index,
                         const Genome& genome) {
    const Campaign& campaign = variant.campaign;
    const Case chosen = case_of(variant, case_index);
    CanopyRequest request =
        request_of(sampling_of(Task{}, campaign, chosen), campaign,
                   scenario_of(campaign, chosen), grow(campaign.crop, genome));
    SeriesIllumination& light = request.scenario.light;
    light = illuminate(light.series, campaign.sky_model,
                       chosen.spacing.row_direction, variant.skies,
                       campaign.sun_dates);
    request.details.pieces = variant.pieces;
    for (Source& source : light.light.sources)
        if (!source.direction) source.effort = variant.sky_effort;
    return request;
}

std::vector<Parameter> parameters(const Campaign& campaign,
                                  std::size_t case_index) {
    const DaySpan span = cases(campaign).at(case_index).day;
    const Plant& plant = campaign.crop.baseline;
    const bool has_stalk = plant.stalk.is_present || plant.sheath.is_present;
    std::vector<Parameter> all;
    all.push_back(ladder("cells_along", cells_along,
                         campaign.tessellation.cells_along, number_name,
                         [](Variant& variant, int n) {
                             variant.campaign.tessellation.cells_along = n;
                         }));
    if (has_stalk)
        all.push_back(ladder("stalk_sides", stalk_sides,
                             campaign.tessellation.stalk_sides, number_name,
                             [](Variant& variant, int n) {
                                 variant.campaign.tessellation.stalk_sides = n;
                             }));
    const Parameter instants = instants_parameter(campaign, span);
    all.push_back(instants);
    const bool assimilates = asks_for_assimilation(campaign);
    if (assimilates) all.push_back(pieces_parameter(campaign));
    Parameter scattering = scattering_parameter(campaign.optics, plant);
    if (scattering.values.size() > 1) all.push_back(std::move(scattering));
    Parameter organs = organs_parameter(plant);
    if (organs.values.size() > 1) all.push_back(std::move(organs));
    all.push_back(sky_parameter(campaign));
    all.push_back(split_parameter());

    Variant own{campaign};
    own.campaign.first_tolerance = own.campaign.sampling.tolerance = 0;
    own.campaign.sampling.paths = fewest_paths(instants, own, case_index);
    // A jackknife needs several.
    if (assimilates) own.randomisations = 4;
    Variant fine = own;
    for (const Parameter& parameter : all)
        if (parameter.kind != Parameter::Kind::arrangement)
            parameter.values[parameter.reference].apply(fine);
    fine.campaign.field.rows = fine.campaign.field.plants = 2;
    for (Parameter& parameter : all)
        parameter.base =
            parameter.kind == Parameter::Kind::arrangement ? own : fine;
    // Few paths have biases of their own, the more pieces and suns share them.
    for (Parameter& parameter : all) {
        if (!assimilates) break;
        if (parameter.name == instants.name)
            parameter.effort = campaign.climates.empty() ? 32 : 128;
        if (parameter.name == "pieces") {
            parameter.effort = 16;
            instants.values[instants.own].apply(parameter.base);
        }
        parameter.base.campaign.sampling.paths *= parameter.effort;
    }

    all.push_back(cell_parameter(campaign));
    all.back().base = own;
    all.back().base.campaign.sampling.paths *= 4;
    std::vector<int> enough;
    for (const int n : paths)
        if (n * usual_paths >= paths.front() * own.campaign.sampling.paths)
            enough.push_back(n);
    int own_paths = own.campaign.sampling.paths;
    if (assimilates) {
        // The campaign's own have a bias that many more do not have.
        own_paths = campaign.sampling.paths;
        if (enough.back() < 4 * own_paths) enough.push_back(4 * own_paths);
        own.randomisations = campaign.sampling.randomisations;
    }
    all.push_back(ladder(
        "paths", enough, own_paths, number_name,
        [](Variant& variant, int n) { variant.campaign.sampling.paths = n; }));
    all.back().kind = Parameter::Kind::paths;
    all.back().base = own;
    return all;
}

}  // namespace ideotype
