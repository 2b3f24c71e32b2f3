// SPDX-License-Identifier: Apache-2.0
#include "photosynthesis_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "checks.hpp"
#include "schema.hpp"

namespace ideotype {

namespace {

using All = PhotosynthesisTable;
using Numbers = std::vector<double> All::*;

//! Calls a function with the lists of numbers that leaves of a model have, and
//! with where a leaf keeps each: an overload for each model.
void each_number(HyperbolaLeaf& leaf, const auto& with) {
    with(&All::phi, leaf.response.phi);
    with(&All::theta, leaf.response.theta);
    with(&All::amax, leaf.response.amax);
    with(&All::rd, leaf.respiration);
}

void each_number(CollatzLeaf& leaf, const auto& with) {
    with(&All::vmax, leaf.vmax);
    with(&All::alpha, leaf.alpha);
    with(&All::theta, leaf.theta);
    with(&All::beta, leaf.beta);
    with(&All::k, leaf.k);
    with(&All::rd, leaf.respiration);
}

void each_number(FarquharLeaf& leaf, const auto& with) {
    with(&All::vcmax, leaf.vcmax);
    with(&All::jmax, leaf.jmax);
    with(&All::tpu, leaf.tpu);
    with(&All::theta, leaf.theta);
    with(&All::beta, leaf.beta);
    with(&All::g1, leaf.g1);
    with(&All::rd, leaf.respiration);
}

struct Model {
    const char* name;
    LeafModel kind;
    LeafRates leaf;  //!< where a table has no numbers
};

constexpr Model models[] = {
    {"hyperbola", LeafModel::hyperbola, HyperbolaLeaf{}},
    {"collatz", LeafModel::collatz, CollatzLeaf{}},
    {"farquhar", LeafModel::farquhar, FarquharLeaf{}}};
static_assert(std::size(models) == std::variant_size_v<LeafRates>);

const Model& model_of(const PhotosynthesisTable& table) {
    return *std::ranges::find(models, table.model, &Model::kind);
}

//! A leaf with what each_number() tells such a function to fill in.
LeafRates filled(LeafRates leaf, const auto& with) {
    std::visit([&](auto& each) { each_number(each, with); }, leaf);
    return leaf;
}

//! The names of the models that a predicate holds for.
std::vector<std::string> names_of_models(const auto& is_one) {
    std::vector<std::string> names;
    for (const Model& model : models)
        if (is_one(model)) names.emplace_back(model.name);
    return names;
}

bool has(const Model& model, Numbers numbers) {
    bool is_there = false;
    filled(model.leaf,
           [&](Numbers own, auto&) { is_there = is_there || own == numbers; });
    return is_there;
}

struct LeafKey {
    const char* name;
    Numbers numbers;
};

constexpr LeafKey leaf_keys[] = {
    {"phi", &All::phi},   {"theta", &All::theta}, {"amax", &All::amax},
    {"rd", &All::rd},     {"vmax", &All::vmax},   {"alpha", &All::alpha},
    {"beta", &All::beta}, {"k", &All::k},         {"vcmax", &All::vcmax},
    {"jmax", &All::jmax}, {"tpu", &All::tpu},     {"g1", &All::g1},
};

std::size_t leaves_of(const PhotosynthesisTable& table) {
    std::size_t most = 1;
    for (const LeafKey& key : leaf_keys)
        most = std::max(most, (table.*key.numbers).size());
    return most;
}

}  // namespace

Section photosynthesis_section(PhotosynthesisTable& table) {
    Section keys{"photosynthesis"};
    const auto add_by_leaf =
        [&](const std::string& name, std::vector<double>& value,
            const Bounds& bounds, const std::string& initial,
            const std::string& meaning) {
            keys.add(name, value, bounds, meaning).or_list().defaults(initial);
        };
    ValueNames<LeafModel> names;
    for (const Model& each : models) names.emplace_back(each.name, each.kind);
    keys.add("model", table.model, names,
             "response of leaves to light: the non-rectangular hyperbola, the "
             "C4 model of Collatz et al. 1992, or the C3 model of Farquhar, "
             "von Caemmerer and Berry 1980");
    add_by_leaf("phi", table.phi, {0, 0.2}, "0.06",
                "quantum yield of the hyperbola [mol mol-1]");
    add_by_leaf("theta", table.theta, {0, 1},
                "0.7 of the hyperbola, 0.83 by Collatz, 0.97875 by Farquhar",
                "curvature of the response to light; by Farquhar that of "
                "electron transport, at 25 deg C");
    add_by_leaf("amax", table.amax, {0, 1e9, "umol m-2 s-1"}, "50",
                "gross assimilation of the hyperbola in saturating light, at "
                "30 deg C");
    add_by_leaf("rd", table.rd, {0, 1000, "umol m-2 s-1"},
                "0.04 amax, at 30 deg C; 0.8 by Collatz and 1.28 by Farquhar, "
                "at 25 deg C",
                "respiration in the dark");
    add_by_leaf("vmax", table.vmax, {0, 1e6, "umol m-2 s-1"}, "39",
                "capacity by Collatz, at 25 deg C");
    add_by_leaf("alpha", table.alpha, {0, 0.2}, "0.067",
                "quantum yield by Collatz [mol mol-1]");
    add_by_leaf("beta", table.beta, {0, 1}, "0.93 by Collatz, 0.98 by Farquhar",
                "curvature between light and CO2 by Collatz, between the "
                "limits by Farquhar, where 1 is the smallest limit itself");
    add_by_leaf("k", table.k, {0, 100, "mol m-2 s-1"}, "0.7",
                "initial slope of the response to CO2 by Collatz, at 25 deg C");
    add_by_leaf("vcmax", table.vcmax, {0, 1e6, "umol m-2 s-1"}, "110",
                "capacity of Rubisco by Farquhar, at 25 deg C");
    add_by_leaf("jmax", table.jmax, {0, 1e6, "umol m-2 s-1"}, "195",
                "capacity of electron transport by Farquhar, at 25 deg C, "
                "from a fit with 4.5 ci + 10.5 Gamma*");
    add_by_leaf("tpu", table.tpu, {0, 1e6, "umol m-2 s-1"}, "13",
                "capacity of the use of triose phosphate by Farquhar, at 25 "
                "deg C");
    add_by_leaf("g1", table.g1, {0, 100, "kPa^0.5"}, "5.79",
                "slope of stomata by Farquhar, after Medlyn et al. 2011");
    keys.add("profile", table.profile,
             {{"none", CapacityProfile::none},
              {"exponential", CapacityProfile::exponential},
              {"nitrogen", CapacityProfile::nitrogen},
              {"rank", CapacityProfile::rank}},
             "how the capacity of leaves falls with depth: not, as exp(-kn L) "
             "of the leaf area index L above, by a fixed canopy nitrogen that "
             "is spread in this way, or as rank_capacity tells");
    keys.add("rank_capacity", table.rank_capacity, {0, 2},
             "of the profile by rank: capacity over the above at equal "
             "distances from the lowest leaf to the highest, linear in between")
        .or_list("number or list");
    keys.add("kn", table.kn, {0, 5}, "of the profile, per leaf area index");
    keys.add("nitrogen", table.nitrogen, {0.01, 100, "g m-2"},
             "in leaves, per ground area");
    keys.add("weather", table.follows_weather,
             "whether leaves have the temperature and humidity of the weather; "
             "else, and on clear days, they have 30 deg C and 60 %");
    keys.add("leaf_mass", table.building_cost, {0, 1000, "g m-2"},
             "that leaves are built of, which the carbon balance pays for");
    keys.add("leaf_days", table.building_days, {1, 1000, "day"},
             "that the building of leaves is spread over");
    return keys;
}

void check_photosynthesis(const PhotosynthesisTable& table, std::size_t leaves,
                          const Problems& root) {
    const Problems problems = root.in("photosynthesis");
    const std::size_t count = leaves > 0 ? leaves : leaves_of(table);
    for (const LeafKey& key : leaf_keys) {
        const std::vector<double>& numbers = table.*key.numbers;
        if (numbers.empty() || !problems.usable({key.name})) continue;
        if (!has(model_of(table), key.numbers))
            problems.add(
                key.name,
                "photosynthesis.{} is no number of the model \"{}\" (it is one "
                "of \"{}\"); remove it",
                key.name, model_of(table).name,
                fmt::join(names_of_models([&](const Model& each) {
                              return has(each, key.numbers);
                          }),
                          "\" or \""));
        else if (numbers.size() != 1 && numbers.size() != count)
            problems.add(key.name,
                         "photosynthesis.{} has {} values ({} has {}); give "
                         "one number, or one for each leaf",
                         key.name, numbers.size(),
                         leaves > 0 ? "the plant" : "another list", count);
    }
}

PhotosynthesisTable photosynthesis_of_meshes() {
    PhotosynthesisTable table;
    table.profile = CapacityProfile::none;
    table.follows_weather = false;
    return table;
}

Photosynthesis to_photosynthesis(const PhotosynthesisTable& table) {
    Photosynthesis result;
    result.rates.clear();
    for (std::size_t i = 0; i < leaves_of(table); ++i) {
        const auto take = [&](Numbers from, auto& to) {
            const std::vector<double>& numbers = table.*from;
            if (!numbers.empty()) to = numbers[numbers.size() == 1 ? 0 : i];
        };
        result.rates.push_back(filled(model_of(table).leaf, take));
    }
    result.profile = table.profile;
    result.nitrogen = {table.nitrogen, table.kn};
    result.rank_capacity = table.rank_capacity;
    result.follows_weather = table.follows_weather;
    result.building_cost = leaf_building_cost(table.building_cost);
    result.building_days = table.building_days;
    return result;
}

}  // namespace ideotype
