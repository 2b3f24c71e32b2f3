// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>

#include "field_of_two_leaves.hpp"
#include "ideotype/canopy/water.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/physiology/temperature.hpp"
#include "water/leaf_lines.hpp"

namespace ideotype {
namespace {

//! Plants of two leaves that exchange heat and water with the air of a hot day.
class WaterOfTwoLeaves : public FieldOfTwoLeaves {
  protected:
    explicit WaterOfTwoLeaves(double erect = 0) : FieldOfTwoLeaves(erect) {
        request.scene.water.emplace();
        Band& par = request.scene.bands.front();
        pieces.width.assign(pieces.count, .06);
        for (TimeStep& step : par.light.series.steps) {
            step.temperature = 34;
            step.humidity = .5;
            step.wind = 2;
            step.pressure = 100;
            step.longwave = 400;
            step.nir = {step.par.beam * 11 / 9, step.par.diffuse * 11 / 9};
        }
        request.scene.components[0].photosynthesis->rates = {CollatzLeaf{}};
        for (LeafGroup& leaf : leaves)
            if (leaf.photosynthesis) leaf.rates = CollatzLeaf{};
        nir = par;
        nir.optics = {PlantOptics{{.45, .45}, {.5, .1}, {}}.materials(), .25};
        longwave = par;
        longwave.optics = {PlantOptics{}.materials(), 0};
        tallies = light(par, accuracy, 1);
        nir_tallies = light(nir, accuracy, 2);
        longwave_tallies = light(longwave, accuracy, 3);
    }

    WaterLeaves water(std::uint64_t seed) const {
        return {request.scene,
                leaves,
                request.scene.components[0].mesh.groups,
                2,
                {seed},
                OtherLight{nir, nir_tallies},
                OtherLight{longwave, longwave_tallies}};
    }

    FluxTallies tally(std::uint64_t seed, double points) const {
        WaterLeaves of = water(seed);
        of.points = points;
        LeafAir air(of);
        LitLeaves with = lit();
        with.air = &air;
        return assimilate(tallies, pieces, with).tallies;
    }

    double flux(LeafFlux of) const {
        return fluxes(1, 6000)[static_cast<std::size_t>(of)].mean;
    }

    void change(const std::function<void(TimeStep&)>& step) {
        for (TimeStep& each : request.scene.bands.front().light.series.steps)
            step(each);
    }

    //! Returns the temperature of the upper leaves minus that of the air,
    //! integrated over time [K s].
    double warming_of_top() const {
        std::size_t top = 0;
        for (std::size_t g = 0; g < leaves.size(); ++g)
            if (leaves[g].photosynthesis) top = g;
        double area = 0, sum = 0;
        for (std::size_t v = 0; v < pieces.count; ++v)
            if (pieces.group[v] == top)
                area += pieces.area[v] / scene->ground_area();
        const FluxTallies all = tally(1, 6000);
        for (const FluxTally& each :
             all[static_cast<std::size_t>(LeafFlux::warming)])
            sum += each.groups[top] / accuracy.randomisations;
        return sum / area;
    }

    //! Returns the daily sum of each flux, for the given number of solved
    //! points.
    std::vector<Estimate> fluxes(std::uint64_t seed, double points) const {
        std::vector<Estimate> sums;
        for (const auto& flux : tally(seed, points)) {
            std::vector<double> values;
            for (const FluxTally& tally : flux) values.push_back(tally.sum());
            sums.push_back(estimate(values));
        }
        return sums;
    }

    const Accuracy accuracy{1024, 16};
    Band nir, longwave;
    std::vector<Tally> tallies, nir_tallies, longwave_tallies;
};

//! All evaluations use the same light, so that fluxes scatter only because
//! points are sampled.
TEST_F(WaterOfTwoLeaves, SamplingFewPointsIsUnbiasedAndReportsItsError) {
    const std::vector<Estimate> all = fluxes(1, 1e6);
    constexpr int runs = 400;
    std::vector<std::vector<double>> found(leaf_fluxes);
    std::vector<double> variance(leaf_fluxes);
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
        const std::vector<Estimate> one = fluxes(seed, 1);
        for (std::size_t k = 0; k < leaf_fluxes; ++k) {
            found[k].push_back(one[k].mean);
            // Both variances include the variance of light.
            variance[k] += (std::pow(one[k].standard_error, 2) -
                            std::pow(all[k].standard_error, 2)) /
                           runs;
        }
    }
    for (std::size_t k = 0; k < leaf_fluxes; ++k) {
        const Estimate mean = estimate(found[k]);
        const double scatter = mean.standard_error * std::sqrt(runs);
        EXPECT_NEAR(mean.mean, all[k].mean,
                    4 * mean.standard_error + 1e-3 * std::abs(all[k].mean))
            << k;
        EXPECT_GT(scatter, 0) << k;
        EXPECT_GT(std::sqrt(variance[k]), .75 * scatter) << k;
        EXPECT_LT(std::sqrt(variance[k]), 2 * scatter) << k;
    }
}

//! All runs have the same field, with different light paths. The scatter of the
//! means agrees with the reported errors, also where few paths hit a piece by
//! chance. The errors of leaf temperature exclude the error of the air
//! temperature, which all randomisations share.
TEST_F(WaterOfTwoLeaves, ErrorsAreThoseOfLightInTheField) {
    constexpr int runs = 40;
    const Accuracy few{64, 16};
    std::vector<std::vector<double>> found(leaf_fluxes), errors(leaf_fluxes);
    for (std::uint64_t seed = 1; seed <= runs; ++seed) {
        tallies = light(request.scene.bands.front(), few, seed);
        const std::vector<Estimate> one = fluxes(seed, 6000);
        for (std::size_t k = 0; k < leaf_fluxes; ++k) {
            found[k].push_back(one[k].mean);
            errors[k].push_back(one[k].standard_error);
        }
    }
    for (const LeafFlux of : {LeafFlux::uptake, LeafFlux::transpiration,
                              LeafFlux::sensible, LeafFlux::conductance}) {
        const auto k = static_cast<std::size_t>(of);
        const double scatter =
            estimate(found[k]).standard_error * std::sqrt(runs);
        double squares = 0;
        for (const double error : errors[k]) squares += error * error / runs;
        EXPECT_GT(std::sqrt(squares), .5 * scatter) << k;
        EXPECT_LT(std::sqrt(squares), 2 * scatter) << k;
        EXPECT_LT(*std::ranges::max_element(errors[k]), 4 * scatter) << k;
    }
}

TEST_F(WaterOfTwoLeaves, FewPathsOfNearInfraredAreEnough) {
    const auto rays = [&] {
        std::uint64_t sum = 0;
        for (const Tally& each : nir_tallies) sum += each.next_rays;
        return static_cast<double>(sum);
    };
    const std::vector<Estimate> before = fluxes(1, 6000);
    const double many = rays();
    nir.path_share = .1;
    constexpr int runs = 16;
    std::vector<std::vector<double>> found(leaf_fluxes);
    for (std::uint64_t seed = 2; seed < 2 + runs; ++seed) {
        nir_tallies =
            simulate(
                {*scene, pieces.mesh.groups, {&nir, 1}, layers, pieces.count},
                accuracy, {seed})
                .front();
        EXPECT_LT(rays(), .15 * many);
        const std::vector<Estimate> after = fluxes(1, 6000);
        for (std::size_t k = 0; k < leaf_fluxes; ++k)
            found[k].push_back(after[k].mean);
    }
    for (const LeafFlux of :
         {LeafFlux::transpiration, LeafFlux::conductance, LeafFlux::sensible}) {
        const auto k = static_cast<std::size_t>(of);
        const Estimate after = estimate(found[k]);
        const double scatter = after.standard_error * std::sqrt(runs);
        EXPECT_GT(scatter, 0) << k;
        EXPECT_LT(scatter, before[k].standard_error) << k;
        EXPECT_NEAR(after.mean, before[k].mean, before[k].standard_error) << k;
    }
}

TEST_F(WaterOfTwoLeaves, EnergyOfTheCanopyCloses) {
    LeafAir air(water(1));
    const LeafPlaces places(pieces, lit(), tallies);
    air.see(places);
    const SeriesIllumination& day = request.scene.light();
    for (std::size_t i = 0; i < day.series.steps.size(); ++i) {
        air.meet(day.beam_of[i], day.sky_of[i]);
        air.begin(i);
        air.set_air({1.5, .3});
        double absorbed = 0, lost = 0;
        for (std::size_t p = 0; p < places.count(); ++p) {
            if (!leaves[places.group[p]].photosynthesis) continue;
            for (const double cosine : {0., .7}) {
                const LeafAir::Point point{p, 100 + 1200 * cosine, cosine};
                const LeafSurroundings around = air.around(point);
                LeafAir::Batch batch(air);
                batch.add(point, nullptr);
                const LeafExchange found = batch.solve().front();
                absorbed += places.index[p] *
                            (around.ppfd / 4.57 + around.nir + around.longwave);
                const double emitted = 2 * leaf_emissivity * stefan_boltzmann *
                                       std::pow(found.temperature + kelvin, 4);
                lost += places.index[p] *
                        (emitted + found.sensible +
                         1e-3 * found.transpiration.value * .0180153 *
                             (2.501e6 - 2361 * around.temperature));
            }
        }
        EXPECT_GT(absorbed, 0);
        EXPECT_NEAR(lost / absorbed, 1, 1e-12) << i;
    }
}

TEST_F(WaterOfTwoLeaves, AirOfTheCanopyFollowsFromItsLeaves) {
    LeafAir air(water(1));
    const LeafPlaces places(pieces, lit(), tallies);
    air.see(places);
    LeafLines lines(air);
    const SeriesIllumination& day = request.scene.light();
    double most = 0;
    for (std::size_t i = 0; i < day.series.steps.size(); ++i) {
        air.meet(day.beam_of[i], day.sky_of[i]);
        air.begin(i);
        std::vector<LeafResponse> responses;
        for (const LeafGroup& leaf : leaves)
            responses.push_back(
                leaf.photosynthesis
                    ? response(leaf.rates, air_of(day.series.steps[i],
                                                  *leaf.photosynthesis))
                    : LeafResponse{});
        lines.clear();
        for (std::size_t p = 0; p < places.count(); ++p) {
            if (!leaves[places.group[p]].photosynthesis) continue;
            lines.add(places.group[p], 150, 0, places.index[p] / 2);
            lines.add(places.group[p], 1200, .7, places.index[p] / 2);
            lines.add_gross(places.group[p], 20 * places.index[p]);
        }
        lines.settle(responses);
        const double guessed = std::abs(lines.air_left().warmer);
        lines.correct(0, 0);
        EXPECT_LT(std::abs(lines.air_left().warmer), .05) << i;
        EXPECT_LT(std::abs(lines.air_left().moister), .005) << i;
        most = std::max(most, guessed);
    }
    EXPECT_GT(most, .001) << "nothing to correct";
}

TEST_F(WaterOfTwoLeaves, Co2ShutsStomataAndWarms) {
    // Leaves that are already hot would assimilate less at a higher
    // temperature.
    change([](TimeStep& step) { step.temperature = 24; });
    const auto warming = flux(LeafFlux::warming);
    const auto water = flux(LeafFlux::transpiration);
    const auto conductance = flux(LeafFlux::conductance);
    const auto gross = flux(LeafFlux::uptake);
    request.scene.bands.front().light.series.co2 = 600;
    EXPECT_LT(flux(LeafFlux::conductance), .9 * conductance);
    EXPECT_LT(flux(LeafFlux::transpiration), .97 * water);
    EXPECT_GT(flux(LeafFlux::warming), warming);
    EXPECT_GT(flux(LeafFlux::uptake), gross);
}

TEST_F(WaterOfTwoLeaves, WindAndNarrowLeavesBringThemTowardsTheAir) {
    request.scene.water->has_canopy_air = false;
    change([](TimeStep& step) { step.humidity = .9; });
    const double warming = flux(LeafFlux::warming);
    ASSERT_GT(warming, 0);
    pieces.width.assign(pieces.count, .12);
    const double wide = flux(LeafFlux::warming);
    EXPECT_GT(wide, 1.05 * warming);
    change([](TimeStep& step) { step.wind = 6; });
    EXPECT_LT(flux(LeafFlux::warming), .9 * wide);
}

TEST_F(WaterOfTwoLeaves, DryAirShutsStomataAndTakesMoreWater) {
    const auto warming = flux(LeafFlux::warming);
    const auto water = flux(LeafFlux::transpiration);
    const auto conductance = flux(LeafFlux::conductance);
    change([](TimeStep& step) { step.humidity = .3; });
    EXPECT_LT(flux(LeafFlux::conductance), .95 * conductance);
    EXPECT_GT(flux(LeafFlux::transpiration), 1.05 * water);
    EXPECT_LT(flux(LeafFlux::warming), warming);
}

TEST_F(WaterOfTwoLeaves, ExactAssimilationIsRefused) {
    request.details.exact = true;
    request.scene.water->has_leaf_temperature = false;
    try {
        evaluate(request, device);
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("without details.exact"),
                  std::string::npos)
            << error.what();
    }
}

//! Plants with more erect leaves.
class ErectWater : public WaterOfTwoLeaves {
  public:
    ErectWater() : WaterOfTwoLeaves(25) {}
    using WaterOfTwoLeaves::warming_of_top;

  private:
    void TestBody() override {}
};

TEST_F(WaterOfTwoLeaves, ErectLeavesAreCooler) {
    EXPECT_LT(ErectWater().warming_of_top(), warming_of_top());
}

}  // namespace
}  // namespace ideotype
