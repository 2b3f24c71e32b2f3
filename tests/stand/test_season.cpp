// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "campaign/season_days.hpp"
#include "season_numbers.hpp"

namespace ideotype {
namespace {

//! Returns a season of maize with [water] at Bondville, from emergence to 10
//! September 2011, in a soil with some rain at the beginning of each tenth day.
//! @param rain on each of these days [mm]; negative: without soil
Campaign dry_land(double rain, double depletion = 1,
                  const std::string& paths = "128",
                  const std::string& randomisations = "8") {
    std::string text =
        read_campaign(std::string(IDEOTYPE_CAMPAIGNS) + "/growing_season.toml")
            .source;
    const std::size_t second = text.find("[[climate]]\nname = \"2012\"");
    text.erase(second, text.find("[[spacing]]") - second);
    text += "\n[water]\n";
    Campaign campaign = read_campaign_text(
        text, std::string(IDEOTYPE_CAMPAIGNS) + "/growing.toml",
        {"climate.from=2011-05-15", "climate.to=2011-09-10",
         "objective.over=[]", "light.tolerance=0", "light.stages=5",
         "light.paths=" + paths, "light.randomisations=" + randomisations});
    campaign.crop.grain = Grain{};
    if (rain < 0) return campaign;
    campaign.spec.soil.emplace().texture = Texture::sandy_loam;
    campaign.spec.irrigation.emplace().depletion = depletion;
    SiteWeather& weather = campaign.spec.weathers.front();
    weather.rain.assign(weather.dates.size() * weather.hours.size(), 0);
    for (std::size_t d = 0; d < weather.dates.size(); d += 10)
        weather.rain[d * weather.hours.size()] = rain;
    return campaign;
}

//! Returns the sum over an axis.
double sum(const std::map<std::string, double>& numbers,
           const std::string& name) {
    double all = 0;
    for (const auto& [each, number] : numbers)
        if (each.starts_with(name + "_") &&
            each.find_first_not_of("0123456789", name.size() + 1) ==
                std::string::npos)
            all += number;
    return all;
}

//! Water from above every tenth day is enough if it fills a large soil.
TEST(Season, SoilWithEnoughWaterChangesNoBit) {
    const auto without = numbers(dry_land(-1));
    Campaign wet = dry_land(150);
    wet.spec.soil->texture = Texture::silt_loam;
    wet.spec.soil->root_depth = 5;
    wet.spec.soil->root_rate = 0.05;
    const auto with = numbers(wet);
    EXPECT_EQ(with.at("water_stress_0"), 0);
    EXPECT_GT(with.at("drainage_0"), 100);
    for (const auto& [name, number] : without)
        EXPECT_EQ(with.at(name), number) << name;
    EXPECT_GT(with.size(), without.size() + 100);
}

TEST(Season, DrySoilClosesStomata) {
    const auto open = numbers(dry_land(-1)), closed = numbers(dry_land(15));
    EXPECT_GT(closed.at("water_stress_0"), 0.2);
    for (const char* less :
         {"transpiration_0", "gross_assimilation_0", "carbon_balance_0",
          "canopy_conductance_0", "kernels_0", "grain_yield_0"})
        EXPECT_LT(closed.at(less), 0.99 * open.at(less)) << less;
    for (const char* more : {"leaf_warming_0", "sensible_heat_0"})
        EXPECT_GT(closed.at(more), open.at(more)) << more;
    // Light does not depend on water.
    EXPECT_EQ(closed.at("absorbed_par_0"), open.at("absorbed_par_0"));
    // Parts agree with their sums.
    const double transpired = closed.at("transpiration_0");
    EXPECT_NEAR(sum(closed, "transpiration_by_leaf"), transpired, 1e-9);
    EXPECT_NEAR(sum(closed, "transpiration_by_layer"), transpired, 1e-9);
    EXPECT_NEAR(sum(closed, "assimilation_by_organ"),
                closed.at("gross_assimilation_0"), 1e-9);
    EXPECT_NEAR(sum(closed, "assimilation_by_layer"),
                closed.at("gross_assimilation_0"), 1e-9);
}

TEST(Season, WaterBalanceCloses) {
    Campaign campaign = dry_land(25, 0.5);
    campaign.spec.soil->curve_number = 80;
    const auto found = numbers(campaign);
    const std::size_t days =
        season_days(campaign, cases(campaign).at(0)).size();
    EXPECT_GT(found.at("runoff_0"), 1);
    EXPECT_GT(found.at("irrigation_0"), 1);
    EXPECT_GT(found.at("soil_evaporation_0"), 20);
    EXPECT_NEAR(sum(found, "soil_evaporation_by_day"),
                found.at("soil_evaporation_0"), 1e-9);
    EXPECT_NEAR(sum(found, "soil_water_by_day") / static_cast<double>(days),
                found.at("soil_water_0"), 1e-9);
    // Roots reach their greatest depth, so that the water that is missing at
    // the end follows from that which is left.
    const SoilSpec& soil = *campaign.spec.soil;
    const double left =
        found.at("soil_water_by_day_" + std::to_string(days - 1));
    const double missing = soil.soil().available(soil.root_depth) - left;
    EXPECT_NEAR(found.at("rain_0") + found.at("irrigation_0") + missing,
                found.at("water_use_0") + found.at("soil_evaporation_0") +
                    found.at("drainage_0") + found.at("runoff_0"),
                1e-3);
}

TEST(Season, IrrigationByDepletionPreventsStress) {
    const auto found = numbers(dry_land(0, 0.5));
    EXPECT_EQ(found.at("water_stress_0"), 0);
    EXPECT_GT(found.at("irrigation_0"), 200);
    Campaign limited = dry_land(0, 0.5);
    limited.spec.irrigation->limit = 100;
    EXPECT_NEAR(numbers(limited).at("irrigation_0"), 100, 1e-9);
    EXPECT_GT(numbers(limited).at("water_stress_0"), 0.05);
}

TEST(Season, GrainIsPartOfTheShoot) {
    const Campaign campaign = dry_land(-1);
    const auto found = numbers(campaign);
    const std::size_t last =
        season_days(campaign, cases(campaign).at(0)).size() - 1;
    const auto at = [&](const std::string& name, std::size_t day) {
        return found.at(name + "_by_day_" + std::to_string(day));
    };
    EXPECT_NEAR(at("grain", last), found.at("grain_yield_0"), 1e-9);
    EXPECT_NEAR(found.at("grain_yield_moist_0"),
                found.at("grain_yield_0") / 0.845, 1e-9);
    // The ratio of means differs from the mean of ratios.
    EXPECT_NEAR(found.at("harvest_index_0"),
                at("grain", last) / at("shoot", last), 0.02);
    EXPECT_GT(found.at("kernels_0"), 1000);
    for (std::size_t day = 1; day <= last; ++day) {
        EXPECT_GE(at("grain", day), at("grain", day - 1) - 1e-3);
        if (day > 20) {
            EXPECT_LE(at("grain", day), at("shoot", day));
        }
    }
    EXPECT_EQ(at("grain", 50), 0);
}

//! A quantity of the season has the error of the same objective.
TEST(Season, ErrorsOfTheSeasonAreThoseOfObjectives) {
    Campaign campaign = dry_land(15);
    campaign.spec.objective.maximised = {"grain_yield", "water_stress",
                                         "soil_evaporation"};
    const Outcome outcome = season_of(campaign);
    const QuantitySet measured =
        outcome_schema(campaign, cases(campaign).at(0), campaign.sampling)
            .measured;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::string& name = campaign.spec.objective.maximised[k];
        const Estimate &objective = outcome.objectives[k],
                       &quantity = outcome.quantities.at(measured.offset(name));
        EXPECT_GT(objective.standard_error, 0) << name;
        EXPECT_NEAR(quantity.standard_error / objective.standard_error, 1, 1e-9)
            << name;
        EXPECT_NEAR(quantity.mean, objective.mean, 1e-9) << name;
    }
}

//! Interpolates fluxes between openings of stomata, and computes them directly.
TEST(Season, InterpolatedFluxesAgreeWithDirectOnes) {
    const Campaign campaign = dry_land(15, 1, "512", "32");
    const Case stage = cases(campaign).at(0).stages.at(3);
    const Device device(Device::supported_isas().back());
    const auto canopy_at = [&](double opening) {
        CanopyRequest request =
            request_of(sampling_of({}, campaign, stage), campaign, stage,
                       scene_of(campaign, stage), {campaign.crop.baseline});
        for (Band& band : request.scene.bands)
            for (TimeStep& step : band.light.series.steps)
                step.opening = opening;
        return LitCanopy(std::move(request), device);
    };
    const LitCanopy open = canopy_at(1);
    const std::vector<double> openings = open.scene().water->openings;
    const LightSeries& series = open.scene().light().series;
    const auto amount = [&](const LitCanopy& canopy, LeafFlux flux,
                            Closure closure) {
        double sum = 0;
        for (const FluxTally& tally :
             canopy.fluxes().tallies[static_cast<std::size_t>(flux)])
            for (std::size_t i = 0; i < series.steps.size(); ++i)
                sum += amount_of(flux, series.steps[i]) * tally.steps[i] *
                       change_of(canopy.fluxes().closed, flux, i, closure);
        return sum;
    };
    const auto relative = [&](const LitCanopy& canopy, LeafFlux flux,
                              Closure closure) {
        return amount(canopy, flux, closure) / amount(open, flux, 0);
    };
    // At the openings themselves.
    for (std::size_t l = 0; l < openings.size(); ++l) {
        const LitCanopy direct = canopy_at(openings[l]);
        const auto closure = static_cast<double>(l + 1);
        for (const LeafFlux flux : {LeafFlux::uptake, LeafFlux::transpiration})
            EXPECT_NEAR(relative(open, flux, closure),
                        relative(direct, flux, 0), 0.03)
                << openings[l];
    }
    // Between them, at the same transpiration.
    for (const double opening : {0.6, 0.18, 0.06, 0.025, 0.008}) {
        const LitCanopy direct = canopy_at(opening);
        const double water = relative(direct, LeafFlux::transpiration, 0);
        double closure = 0;
        while (relative(open, LeafFlux::transpiration, closure) > water)
            closure += 0.01;
        EXPECT_NEAR(relative(open, LeafFlux::uptake, closure),
                    relative(direct, LeafFlux::uptake, 0), 0.04)
            << opening;
    }
}

//! Prices without rounding, so that each part can be told from the others.
constexpr Prices some_prices{200, 0.003, 0.4, 0.05, 0.2, 700};

TEST(Season, MarginIsRevenueLessCosts) {
    Campaign campaign = dry_land(15, 0.5);
    campaign.spec.prices = some_prices;
    const auto found = numbers(campaign);
    EXPECT_EQ(found.count("electricity_0"), 0u);
    // 7.5 plants m-2, all sown, are also those of missing plants.
    EXPECT_NEAR(found.at("seeds_0"), 7.5, 1e-9);
    const double water = 10 * found.at("irrigation_0");  // m3 ha-1
    EXPECT_GT(water, 100);
    EXPECT_NEAR(found.at("margin_0"),
                200 * found.at("grain_yield_moist_0") - 0.003 * 75000 -
                    0.4 * water - 700,
                1e-6);
}

TEST(Season, ElectricityIsThatOfThePanelsOnAllDays) {
    Campaign campaign = dry_land(-1);
    campaign.spec.prices = some_prices;
    campaign.spec.panels.emplace_back().rows = {
        .name = "panel", .height = 4, .width = 0.5, .azimuth = 180};
    const auto found = numbers(campaign);
    const auto days = static_cast<double>(
        season_days(campaign, cases(campaign).at(0)).size());
    EXPECT_GT(found.at("panel_light_0"), 1);
    EXPECT_NEAR(found.at("electricity_0"),
                0.2 * days * found.at("panel_light_0") / 3.6,
                1e-9 * found.at("electricity_0"));
    EXPECT_NEAR(found.at("margin_0"),
                200 * found.at("grain_yield_moist_0") - 0.003 * 75000 +
                    0.05 * 1e4 * found.at("electricity_0") - 700,
                1e-6);
}

}  // namespace
}  // namespace ideotype
