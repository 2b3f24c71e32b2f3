// SPDX-License-Identifier: Apache-2.0
#include "leaves.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/ranges.h>

#include "campaign/checks/checks.hpp"
#include "spec/problems.hpp"
#include "spec/tables.hpp"

namespace ideotype {

namespace {

using All = PhotosynthesisSpec;
using Numbers = std::vector<double> All::*;

//! The absorbed PPFD to which `rate_2000` refers [umol m-2 s-1].
constexpr double full_light = 2000;

//! For each parameter of a leaf model, calls a function with the list in the
//! table and the member of the leaf that stores one of its values. Each model
//! has an overload.
void each_number(HyperbolaLeaf& leaf, const auto& with) {
    with(&All::phi, leaf.response.phi);
    with(&All::theta, leaf.response.theta);
    with(&All::amax, leaf.response.amax);
    std::optional<double> rate;
    with(&All::rate_2000, rate);
    if (rate) leaf.response.amax = leaf.response.amax_for(full_light, *rate);
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
    LeafModel kind;
    LeafRates leaf;  //!< default parameters
};

constexpr Model models[] = {{LeafModel::hyperbola, HyperbolaLeaf{}},
                            {LeafModel::collatz, CollatzLeaf{}},
                            {LeafModel::farquhar, FarquharLeaf{}}};
static_assert(std::size(models) == std::variant_size_v<LeafRates>);

const Model& model_of(const PhotosynthesisSpec& table) {
    return *std::ranges::find(models, table.model, &Model::kind);
}

//! Returns a leaf in which each_number() has set the parameters.
LeafRates filled(LeafRates leaf, const auto& with) {
    std::visit([&](auto& each) { each_number(each, with); }, leaf);
    return leaf;
}

//! The parameters that describe photosynthetic capacity.
constexpr Numbers capacities[] = {&All::amax, &All::rate_2000, &All::vmax,
                                  &All::vcmax, &All::jmax};

//! Returns the keys of leaf parameters of all models.
std::vector<Key> leaf_keys() {
    std::vector<Key> keys;
    std::ranges::copy_if(photosynthesis_table.keys(), std::back_inserter(keys),
                         [](const Key& key) { return key.values.is_by_leaf; });
    return keys;
}

//! Returns the values of a key. The addresses of values are not const, but the
//! table is not changed.
const std::vector<double>& numbers_of(const Key& key, const All& table) {
    return *std::get<std::vector<double>*>(key.place(const_cast<All*>(&table)));
}

bool is_of(const Key& key, Numbers numbers) {
    static const All any;  // only for the addresses of its members
    return &numbers_of(key, any) == &(any.*numbers);
}

bool has(const Model& model, const Key& key) {
    bool is_there = false;
    filled(model.leaf,
           [&](Numbers own, auto&) { is_there = is_there || is_of(key, own); });
    return is_there;
}

std::vector<std::string> models_with(const Key& key) {
    std::vector<std::string> names;
    for (const Model& model : models)
        if (has(model, key)) names.emplace_back(name_of(model.kind));
    return names;
}

std::size_t leaves_of(const PhotosynthesisSpec& table) {
    std::size_t largest = 1;
    for (const Key& key : leaf_keys())
        largest = std::max(largest, numbers_of(key, table).size());
    return largest;
}

std::string file_of(const CropSpec& crop, const std::string& key) {
    const auto found = crop.leaf_files.find(key);
    return found == crop.leaf_files.end() ? "" : found->second;
}

//! Returns the default value of a parameter, or nothing if it follows from
//! other parameters.
std::vector<double> default_of(const Model& model, const Key& key) {
    std::vector<double> values;
    filled(model.leaf, [&](Numbers numbers, auto& value) {
        if (!is_of(key, numbers)) return;
        if constexpr (requires { value.has_value(); }) {
            if (value) values.push_back(*value);
        } else {
            values.push_back(value);
        }
    });
    return values;
}

//! Returns the value of `amax` for each leaf of the hyperbola model.
std::vector<double> capacities_of(const PhotosynthesisSpec& table) {
    std::vector<double> values;
    for (const LeafRates& leaf : to_photosynthesis(table).rates)
        values.push_back(std::get<HyperbolaLeaf>(leaf).response.amax);
    return values;
}

StatedLeaves stated_leaves_of(const CropSpec& crop) {
    const PhotosynthesisSpec& table = crop.photosynthesis;
    const Model& model = model_of(table);
    StatedLeaves leaves{
        crop.baseline.name, name_of(model.kind), file_of(crop, "model"), {}};
    for (const Key& key : leaf_keys()) {
        if (!has(model, key)) continue;
        const std::vector<double>& numbers = numbers_of(key, table);
        if (is_of(key, &All::rate_2000) && numbers.empty()) continue;
        if (is_of(key, &All::amax) && !table.rate_2000.empty()) {
            leaves.numbers.push_back({key.name, capacities_of(table),
                                      file_of(crop, "rate_2000"), true});
            continue;
        }
        leaves.numbers.push_back(
            {key.name, numbers.empty() ? default_of(model, key) : numbers,
             file_of(crop, key.name),
             std::ranges::any_of(
                 capacities, [&](Numbers each) { return is_of(key, each); })});
    }
    return leaves;
}

//! Returns whether a file states the leaf model or any of its parameters.
bool is_stated(const CropSpec& crop) {
    if (!file_of(crop, "model").empty()) return true;
    const Model& model = model_of(crop.photosynthesis);
    return std::ranges::any_of(leaf_keys(), [&](const Key& key) {
        return has(model, key) && !file_of(crop, key.name).empty();
    });
}

//! Warns if a crop uses the default photosynthesis.
//! @param problems problems of the crop
void warn_of_default(const CropSpec& crop, const Problems& problems) {
    problems.doubt(
        {"name"}, crop.is_known && !is_stated(crop),
        "the crop \"{}\" has no [photosynthesis] (its leaves assimilate "
        "by the default, which is right for C4 crops such as maize, not "
        "for C3 crops such as wheat); add the table to the crop file, "
        "with model = \"farquhar\" for a C3 crop, or \"hyperbola\" or "
        "\"collatz\" for a C4 crop",
        crop.baseline.name);
}

//! Reports full-light rates that are given together with amax (only one is
//! allowed), or that no value of amax can reproduce.
//! @param problems problems of the table
void check_full_light(const PhotosynthesisSpec& table,
                      const Problems& problems) {
    const bool is_given =
        !table.rate_2000.empty() && table.model == LeafModel::hyperbola;
    const Keys keys{"rate_2000", "amax", "phi"};
    problems.rule(keys, is_given && !table.amax.empty(),
                  "photosynthesis.rate_2000 is given with photosynthesis.amax "
                  "(each follows from the other); remove one of them");
    problems.rule(keys, [&]() -> std::string {
        const std::vector<double>& rates = table.rate_2000;
        const std::vector<double> phi =
            table.phi.empty() ? std::vector{Hyperbola{}.phi} : table.phi;
        const std::size_t leaves = std::max(rates.size(), phi.size());
        for (std::size_t i = 0; is_given && i < leaves; ++i) {
            const double rate = rates[rates.size() == 1 ? 0 : i];
            const double yield = phi[phi.size() == 1 ? 0 : i];
            const double largest = full_light * yield;
            if (rate < largest) continue;
            return fmt::format(
                "photosynthesis.rate_2000 is {} (the quantum yield "
                "photosynthesis.phi of {} gives less than {} at {} umol m-2 "
                "s-1, whatever the capacity); use less, or a larger phi",
                rate, yield, largest, full_light);
        }
        return "";
    });
}

}  // namespace

void check_photosynthesis(const PhotosynthesisSpec& table, std::size_t leaves,
                          const Problems& root) {
    const Problems problems = root.in("photosynthesis");
    const std::size_t count = leaves > 0 ? leaves : leaves_of(table);
    for (const Key& key : leaf_keys()) {
        const std::vector<double>& numbers = numbers_of(key, table);
        problems.rule({key.name, "model"},
                      !numbers.empty() && !has(model_of(table), key),
                      "photosynthesis.{} is not a parameter of the model "
                      "\"{}\" (but of \"{}\"); remove it",
                      key.name, name_of(table.model),
                      fmt::join(models_with(key), "\" or \""));
        problems.rule({key.name}, numbers.size() > 1 && numbers.size() != count,
                      "photosynthesis.{} has {} values ({} has {}); give one "
                      "number, or one for each leaf",
                      key.name, numbers.size(),
                      leaves > 0 ? "the plant" : "another list", count);
    }
    check_full_light(table, problems);
}

Photosynthesis to_photosynthesis(const PhotosynthesisSpec& table) {
    Photosynthesis result;
    result.rates.clear();
    for (std::size_t i = 0; i < leaves_of(table); ++i) {
        const auto take = [&](Numbers member, auto& to) {
            const std::vector<double>& numbers = table.*member;
            if (!numbers.empty()) to = numbers[numbers.size() == 1 ? 0 : i];
        };
        result.rates.push_back(filled(model_of(table).leaf, take));
    }
    result.profile = table.profile;
    result.nitrogen = {table.nitrogen, table.kn};
    result.rank_capacity = table.rank_capacity;
    result.follows_weather = table.follows_weather;
    result.leaf_mass = table.leaf_mass;
    result.building_days = table.building_days;
    return result;
}

std::vector<StatedLeaves> stated_leaves(const Spec& spec) {
    std::vector<StatedLeaves> leaves;
    if (!spec.assimilates) return leaves;
    leaves.push_back(stated_leaves_of(spec.plant.crop));
    for (const ComponentSpec& each : spec.components)
        if (!each.has_mesh()) leaves.push_back(stated_leaves_of(each.crop));
    return leaves;
}

void check_leaf_models(const Spec& spec, const Problems& problems) {
    if (!spec.assimilates) return;
    warn_of_default(spec.plant.crop, problems.in("plant.baseline"));
    for (std::size_t i = 0; i < spec.components.size(); ++i)
        warn_of_default(spec.components[i].crop,
                        problems.in("component", i).in("crop"));
}

Stomata to_stomata(const WaterSpec& table,
                   const Photosynthesis& photosynthesis) {
    Stomata result{table.model};
    const bool is_medlyn = table.model == Stomata::Model::medlyn;
    const auto* c3 = std::get_if<FarquharLeaf>(&photosynthesis.rates.front());
    result.intercept = table.intercept.value_or(is_medlyn ? 0.01 : 0.017);
    result.slope = table.slope.value_or(is_medlyn ? (c3 ? c3->g1 : 1.6) : 4.53);
    return result;
}

void check_water(const Spec& spec, const Problems& problems) {
    if (!spec.water) return;
    const auto check = [](const CropSpec& crop, const Problems& of_crop,
                          const std::string& whose) {
        of_crop.rule(
            {"photosynthesis.model"},
            crop.is_known && crop.photosynthesis.model == LeafModel::hyperbola,
            "photosynthesis.model{} is \"hyperbola\", which does not depend on "
            "CO2 (as [water] requires); use \"collatz\" or \"farquhar\"",
            whose);
    };
    check(spec.plant.crop, problems, "");
    for (std::size_t i = 0; i < spec.components.size(); ++i) {
        const ComponentSpec& component = spec.components[i];
        check(component.crop, problems.in("component", i),
              " of component \"" + component.name + "\"");
    }
}

void check_prices(const Spec& spec, const Problems& problems) {
    if (!spec.prices) return;
    const Prices& prices = *spec.prices;
    const Problems of_prices = problems.in("prices");
    const bool fills =
        spec.plant.crop.grain && plants_grow(spec) && spec.components.empty();
    of_prices.rule({"grain"}, !fills,
                   "prices are given (the margin needs grain: plants that "
                   "grow, alone, of a crop file with [grain]); add these, or "
                   "remove [prices]");
    of_prices.rule({"water"}, prices.water > 0 && !spec.soil,
                   "prices.water is {} (irrigation needs soil that dries); add "
                   "[soil], or remove the price",
                   prices.water);
    of_prices.rule({"electricity"},
                   prices.electricity > 0 && spec.panels.empty(),
                   "prices.electricity is {} (there are no panels); add "
                   "[[panel]], or remove the price",
                   prices.electricity);
    of_prices.rule({"electricity"},
                   prices.electricity > 0 && !spec.panels.empty() &&
                       !followed_bands(spec)[nir_band],
                   "prices.electricity is {} (modules also convert near "
                   "infrared light, which is not traced); add [[band]] with "
                   "name = \"nir\", or remove the price",
                   prices.electricity);
}

void check_soil(const Spec& spec, const Problems& problems) {
    const Problems of_irrigation = problems.in("irrigation");
    if (spec.irrigation) {
        const IrrigationSpec& plan = *spec.irrigation;
        of_irrigation.rule({"depletion"}, !spec.soil,
                           "irrigation is given (but no soil, to which it adds "
                           "water); add [soil]");
        of_irrigation.rule(
            {"amounts", "dates"},
            plan.amounts.size() > 1 || plan.dates.empty()
                ? plan.amounts.size() != plan.dates.size()
                : plan.amounts.empty(),
            "irrigation.amounts has {} values (for {} dates); give one for "
            "each date, or one for all",
            plan.amounts.size(), plan.dates.size());
    }
    for (const Date& date :
         spec.irrigation ? spec.irrigation->dates : std::vector<Date>{})
        of_irrigation.doubt(
            {"dates"},
            std::ranges::none_of(spec.climates,
                                 [&](const NamedClimate& each) {
                                     const Climate& climate = each.value;
                                     return !(date < climate.emergence) &&
                                            !(climate.period.to < date);
                                 }),
            "irrigation.dates has {}, which is in no season of the campaign",
            to_string(date));
    if (!spec.soil) return;
    const Problems of_soil = problems.in("soil");
    const Soil soil = spec.soil->soil();
    of_soil.rule({"root_depth"}, !plants_grow(spec),
                 "soil is given (it dries in the season of plants that grow); "
                 "add emergence to [[climate]], or remove [soil]");
    of_soil.rule({"root_depth"},
                 !spec.water || !spec.water->rules.has_leaf_temperature,
                 "soil is given (stomata close as it dries, which changes leaf "
                 "temperature); add [water] with leaf_temperature = true");
    of_soil.rule({"wilting_point", "field_capacity"},
                 soil.wilting_point >= soil.field_capacity,
                 "soil.wilting_point is {} (field capacity is {}); give less",
                 soil.wilting_point, soil.field_capacity);
    of_soil.rule(
        {"readily_evaporable", "total_evaporable"},
        soil.readily_evaporable > soil.total_evaporable,
        "soil.readily_evaporable is {} (total_evaporable is {}); give at most "
        "as much",
        soil.readily_evaporable, soil.total_evaporable);
    for (std::size_t c = 0; c < spec.climates.size(); ++c) {
        const auto& [name, climate] = spec.climates[c];
        if (!climate.grows()) continue;
        for (const SiteWeather& weather : spec.weathers)
            problems.in("climate", climate.table)
                .rule(
                    {"rain"}, weather.climate == name && weather.rain.empty(),
                    "climate \"{}\" has no rain (which [soil] needs); name its "
                    "column, rain = [\"rain\", \"mm\"]",
                    name);
    }
}

}  // namespace ideotype
