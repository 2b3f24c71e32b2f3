// SPDX-License-Identifier: Apache-2.0
#include "declaration.hpp"
#include "ideotype/crop/grain.hpp"
#include "randomised.hpp"

namespace ideotype {

namespace {

constexpr double tonnes_per_hectare = 10;  // from kg m-2

bool has_soil(const Scope& scope) {
    return scope.has_soil;
}

bool has_grain(const Scope& scope) {
    return scope.has_grain;
}

bool has_prices(const Scope& scope) {
    return scope.has_prices;
}

bool has_priced_panels(const Scope& scope) {
    return scope.has_prices && scope.has_panels;
}

Randomised randomised(const ByRandomisation& values, double factor = 1) {
    return scaled(Randomised{estimate(values), values}, factor);
}

std::vector<Estimate> of_dates(const ByDate& values, double factor = 1) {
    std::vector<Estimate> dates;
    for (std::size_t d = 0; d < values.front().size(); ++d)
        dates.push_back(scaled(
            estimate(mapped(values, [&](const auto& each) { return each[d]; })),
            factor));
    return dates;
}

TakeNumber water(ByRandomisation SeasonWater::*part) {
    return [=](const CanopyReport& report) {
        return randomised((*report.season_water).*part);
    };
}

TakeNumbers water(ByDate SeasonWater::*part) {
    return [=](const CanopyReport& report) {
        return of_dates((*report.season_water).*part);
    };
}

TakeNumber grain(ByRandomisation SeasonGrain::*part, double factor = 1) {
    return [=](const CanopyReport& report) {
        return randomised((*report.season_grain).*part, factor);
    };
}

TakeNumbers grain(ByDate SeasonGrain::*part) {
    return [=](const CanopyReport& report) {
        return of_dates((*report.season_grain).*part, tonnes_per_hectare);
    };
}

//! Returns a number of each randomisation.
template <class Number>
Randomised by_randomisation(const CanopyReport& report, const Number& number) {
    ByRandomisation values;
    for (std::size_t r = 0; r < report.randomisations(); ++r)
        values.push_back(number(r));
    return randomised(values);
}

std::optional<Randomised> seeds(const CanopyReport& report) {
    return by_randomisation(
        report, [&](std::size_t) { return report.season_prices->seeds; });
}

//! Returns the electricity of panels in the season [kWh m-2].
Randomised electricity_of(const CanopyReport& report) {
    constexpr double megajoule_per_kilowatt_hour = 3.6;
    const SeasonPrices& season = *report.season_prices;
    const Randomised light = light_on_panels(report);
    return by_randomisation(report, [&](std::size_t r) {
        return season.prices.module_efficiency * season.days *
               light.by_randomisation[r] / megajoule_per_kilowatt_hour;
    });
}

std::optional<Randomised> electricity(const CanopyReport& report) {
    return electricity_of(report);
}

//! Returns the revenue of grain and electricity less all costs [ha-1].
std::optional<Randomised> margin(const CanopyReport& report) {
    constexpr double hectare = 1e4;           // m2
    constexpr double litres_per_tonne = 1e3;  // kg of water per m3
    const SeasonPrices& season = *report.season_prices;
    const Prices& price = season.prices;
    const Randomised power =
        has_panels(report.objects) ? electricity_of(report) : Randomised{};
    return by_randomisation(report, [&](std::size_t r) {
        double sum = price.grain * tonnes_per_hectare / (1 - market_moisture) *
                         report.season_grain->mass[r] -
                     price.seed * hectare * season.seeds -
                     price.other * season.share;
        if (report.season_water)
            sum -= price.water * hectare / litres_per_tonne *
                   report.season_water->irrigation[r];
        if (!power.by_randomisation.empty())
            sum += price.electricity * hectare * power.by_randomisation[r];
        return sum;
    });
}

}  // namespace

std::vector<Declaration> season_quantities() {
    using Water = SeasonWater;
    using Yield = SeasonGrain;
    const auto of_soil = [](const char* name, const char* unit,
                            const char* meaning, auto part) {
        return Declaration{
            {name, unit, meaning}, MeanOver::nothing, water(part), has_soil};
    };
    const auto of_soil_by_day = [](const char* name, const char* meaning,
                                   auto part) {
        return Declaration{by({"day"}, {name, "mm", meaning}),
                           MeanOver::nothing, water(part), has_soil};
    };
    const auto of_grain = [](const char* name, const char* unit,
                             const char* meaning, TakeNumber take) {
        return Declaration{{name, unit, meaning},
                           MeanOver::nothing,
                           std::move(take),
                           has_grain};
    };
    const auto of_grain_by_day = [](const char* name, const char* meaning,
                                    auto part) {
        return Declaration{by({"day"}, {name, "t ha-1", meaning}),
                           MeanOver::nothing, grain(part), has_grain};
    };
    return {
        of_soil("soil_evaporation", "mm",
                "water that evaporates from the soil on all days",
                &Water::evaporation),
        of_soil("irrigation", "mm", "irrigation on all days",
                &Water::irrigation),
        of_soil("rain", "mm", "rain on all days", &Water::rain),
        of_soil("runoff", "mm", "rain that runs off on all days",
                &Water::runoff),
        of_soil("drainage", "mm",
                "water that drains below the roots on all days",
                &Water::drainage),
        of_soil("soil_water", "mm",
                "water in the root zone that roots can take up, in the evening",
                &Water::soil_water),
        of_soil("water_stress", "1",
                "transpiration that dry soil prevents, over transpiration with "
                "enough water",
                &Water::stress),
        of_soil_by_day("soil_evaporation_by_day",
                       "water that evaporates from the soil",
                       &Water::evaporation_of_dates),
        of_soil_by_day("soil_water_by_day",
                       "water in the root zone that roots can take up, in the "
                       "evening",
                       &Water::soil_water_of_dates),
        of_grain("kernels", "m-2", "kernels per ground area",
                 grain(&Yield::kernels)),
        of_grain("grain_yield", "t ha-1", "dry mass of grain",
                 grain(&Yield::mass, tonnes_per_hectare)),
        of_grain(
            "grain_yield_moist", "t ha-1", "mass of grain with 15.5 % of water",
            grain(&Yield::mass, tonnes_per_hectare / (1 - market_moisture))),
        of_grain("harvest_index", "1",
                 "dry mass of grain over that of the shoot",
                 grain(&Yield::harvest_index)),
        of_grain_by_day("grain_by_day", "dry mass of grain in the evening",
                        &Yield::mass_of_dates),
        of_grain_by_day("shoot_by_day", "dry mass of the shoot in the evening",
                        &Yield::shoot_of_dates),
        {{"seeds", "m-2", "plants that are sown per ground area"},
         MeanOver::nothing,
         TakeNumber(seeds),
         has_prices},
        {{"electricity", "kWh m-2",
          "electricity of panels on all days of the season, per ground area"},
         MeanOver::nothing,
         TakeNumber(electricity),
         has_priced_panels},
        {{"margin", "currency ha-1",
          "revenue of grain and of electricity less the costs of seed, of "
          "irrigation and of all else, by [prices]"},
         MeanOver::nothing,
         TakeNumber(margin),
         has_prices},
    };
}

}  // namespace ideotype
