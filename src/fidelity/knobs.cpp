#include "ideotype/fidelity/knobs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace ideotype {

namespace {

//! Values that every campaign is tried with; its own is added.
constexpr std::array cells_along{4, 6, 8, 12, 16, 24, 32};
constexpr std::array stalk_sides{3, 4, 6, 8, 12, 24};
constexpr std::array plants{1, 2, 3, 4, 6};
constexpr std::array step_minutes{15.0, 30.0, 60.0, 120.0, 240.0};
constexpr std::array paths{256, 1024, 4096, 16384};

//! Paths of one randomisation where they are not what is compared: few, since
//! a draw of a new field tells more than more paths through the same one. Only
//! for cells there are more, to tell the scatter of fields from that of paths.
constexpr int usual_paths = 1024;

//! A knob whose values are sorted numbers, of which the last is converged.
template <class Numbers, class Number, class Name, class Apply>
Knob ladder(const std::string& name, const Numbers& numbers, Number own,
            Name name_of, Apply apply) {
    std::vector<Number> sorted(numbers.begin(), numbers.end());
    if (std::find(sorted.begin(), sorted.end(), own) == sorted.end())
        sorted.push_back(own);
    std::sort(sorted.begin(), sorted.end());
    Knob knob;
    knob.name = name;
    for (const Number& x : sorted)
        knob.values.push_back(
            {name_of(x), [apply, x](Variant& variant) { apply(variant, x); }});
    knob.reference = sorted.size() - 1;
    knob.own = static_cast<std::size_t>(
        std::find(sorted.begin(), sorted.end(), own) - sorted.begin());
    return knob;
}

std::string number_name(double x) {
    return fmt::format("{}", x);
}

bool divides(double step, const DaySpan& span) {
    const double steps = (span.end - span.start) * 60 / step;
    return steps >= 1 && std::abs(steps - std::round(steps)) < 1e-9;
}

Knob cell_knob(const Campaign& campaign) {
    using Cell = std::pair<int, int>;
    std::vector<Cell> cells;
    for (const int n : plants) cells.push_back({n, n});
    Knob knob = ladder(
        "cell", cells, Cell{campaign.field.rows, campaign.field.plants},
        [](const Cell& c) { return fmt::format("{}x{}", c.first, c.second); },
        [](Variant& variant, const Cell& c) {
            variant.campaign.field.rows = c.first;
            variant.campaign.field.plants = c.second;
        });
    return knob;
}

Knob step_knob(const DaySpan& span) {
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

bool is_black(const Lambertian& surface) {
    return surface.reflectance + surface.transmittance == 0;
}

Knob scattering_knob(const Optics& optics, bool has_stalk) {
    Knob knob;
    knob.name = "scattering";
    knob.kind = Knob::Kind::omission;
    knob.values.push_back({"full", [](Variant&) {}});
    const auto set = [](auto change) {
        return [change](Variant& variant) { change(variant.campaign.optics); };
    };
    if (optics.soil_albedo > 0)
        knob.values.push_back(
            {"black soil", set([](Optics& o) { o.soil_albedo = 0; })});
    if (!is_black(optics.leaf))
        knob.values.push_back(
            {"black leaves", set([](Optics& o) { o.leaf = {}; })});
    if (has_stalk && !is_black(optics.stalk))
        knob.values.push_back(
            {"black stalks", set([](Optics& o) { o.stalk = {}; })});
    if (knob.values.size() > 2)
        knob.values.push_back({"off", set([](Optics& o) { o = {}; })});
    return knob;
}

Knob sky_knob(const Campaign& campaign) {
    Knob knob;
    knob.name = "sky";
    if (campaign.sky_model == SkyModel::clear) {
        knob.kind = Knob::Kind::omission;
        knob.values = {{"clear, each instant", [](Variant&) {}},
                       {"uniform, shared", [](Variant& variant) {
                            variant.campaign.sky_model = SkyModel::uniform;
                        }}};
    } else {
        knob.kind = Knob::Kind::arrangement;
        knob.values = {{"shared by all instants", [](Variant&) {}},
                       {"one for each instant", [](Variant& variant) {
                            variant.skies = Variant::Skies::each;
                        }}};
    }
    return knob;
}

Knob split_knob() {
    Knob knob;
    knob.name = "sky_paths";
    knob.kind = Knob::Kind::arrangement;
    for (const double effort : {1.0, 0.5, 2.0})
        knob.values.push_back(
            {fmt::format("x {}", effort),
             [effort](Variant& variant) { variant.sky_effort = effort; }});
    return knob;
}

Knob stalk_knob() {
    Knob knob;
    knob.name = "stalk";
    knob.kind = Knob::Kind::omission;
    knob.values = {{"true", [](Variant&) {}},
                   {"false", [](Variant& variant) {
                        variant.campaign.plant.stalk.is_present = false;
                    }}};
    return knob;
}

//! Fewer paths than sources cannot be shared among them.
int fewest_paths(const Campaign& campaign, const DaySpan& span) {
    const double finest = std::min(span.step_minutes, step_minutes.front());
    const double steps = (span.end - span.start) * 60 / finest + 1;
    const double sources =
        campaign.sky_model == SkyModel::clear ? 2 * steps : steps + 1;
    int count = usual_paths;
    while (count < sources) count *= 2;
    return count;
}

}  // namespace

Variant Knob::at(std::size_t value) const {
    Variant variant = base;
    values.at(value).apply(variant);
    return variant;
}

Case case_of(const Variant& variant, std::size_t case_index) {
    return cases(variant.campaign).at(case_index);
}

std::vector<Knob> knobs(const Campaign& campaign, std::size_t case_index) {
    const DaySpan span = cases(campaign).at(case_index).day;
    const bool has_stalk = campaign.plant.stalk.is_present;
    std::vector<Knob> all;
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
    all.push_back(step_knob(span));
    Knob scattering = scattering_knob(campaign.optics, has_stalk);
    if (scattering.values.size() > 1) all.push_back(std::move(scattering));
    if (has_stalk) all.push_back(stalk_knob());
    all.push_back(sky_knob(campaign));
    all.push_back(split_knob());

    Variant own{campaign};
    own.campaign.first_tolerance = own.campaign.sampling.tolerance = 0;
    own.campaign.sampling.paths = fewest_paths(campaign, span);
    Variant fine = own;
    for (const Knob& knob : all)
        if (knob.kind != Knob::Kind::arrangement)
            knob.values[knob.reference].apply(fine);
    fine.campaign.field.rows = fine.campaign.field.plants = 2;
    for (Knob& knob : all)
        knob.base = knob.kind == Knob::Kind::arrangement ? own : fine;

    all.push_back(cell_knob(campaign));
    all.back().base = own;
    all.back().base.campaign.sampling.paths *= 4;
    std::vector<int> enough;
    for (const int n : paths)
        if (n * usual_paths >= paths.front() * own.campaign.sampling.paths)
            enough.push_back(n);
    all.push_back(ladder(
        "paths", enough, own.campaign.sampling.paths, number_name,
        [](Variant& variant, int n) { variant.campaign.sampling.paths = n; }));
    all.back().kind = Knob::Kind::paths;
    all.back().base = own;
    return all;
}

}  // namespace ideotype
