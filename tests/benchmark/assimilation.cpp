// SPDX-License-Identifier: Apache-2.0
//! Measures the bias of canopy assimilation that is found from the light of
//! pieces of leaves: the bias by noise in that light, for several numbers of
//! paths, and the bias by the size of pieces. Tells whether standard errors are
//! honest, too.
//!
//!     assimilation bias SEEDS
//!     assimilation pieces
//!     assimilation cost REPEATS
#include "ideotype/canopy/assimilation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <numeric>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "ideotype/canopy/exact_assimilation.hpp"
#include "ideotype/light/tolerance.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! The stand of a case of campaigns/NAME.toml with one plant, by default its
//! baseline.
struct Stands {
    const char* name;
    const char* campaign = "ames";
    int plants = 0;  //!< rows, and plants in each row; 0: as in the campaign
    const char* plant = nullptr;
    std::optional<double> azimuth{};  //!< azimuth of the leaves [deg]
    std::optional<Spacing> spacing{};
};

//! A canopy in the light of 14 instants of a clear day, or of a season.
class Canopy {
  public:
    explicit Canopy(const Stands& which,
                    std::size_t per_blade = pieces_of_blade,
                    int cells_along = 12)
        : stand_(campaign(which)) {
        Plant plant = stand_.campaign.crop.baseline;
        if (which.plant)
            plant = read_crop(fmt::format("{}/{}.toml", IDEOTYPE_CAMPAIGNS,
                                          which.plant))
                        .baseline;
        if (which.azimuth)
            for (std::size_t i = 0; i < plant.leaves.size(); ++i)
                plant.leaves[i].azimuth =
                    *which.azimuth + (i % 2 == 0 ? 0 : 180);
        Component& component = stand_.request.scene.components.front();
        component.tessellation = {cells_along};
        set_plant(component, plant);
        component.photosynthesis.emplace();
        const Pieces line = cut_leaves(component.mesh, per_blade);
        field_ = draw_field(scene(), {1}, {&line.mesh, 1});
        pieces_ = pieces_of_field({&line, 1}, field_);
        field_.mesh = pieces_.mesh;
        surfaces_.emplace(build_scene(stand_.device, field_));
        std::vector<double> index(line.uncut_groups);
        for (std::size_t v = 0; v < pieces_.count; ++v)
            index[pieces_.group[v]] +=
                pieces_.area[v] / field_.cell.ground_area;
        leaves_ = leaf_groups(scene(), component.mesh.groups, index);
    }

    //! @param has_pieces whether light is resolved by pieces of leaves
    std::vector<Tally> light(double tolerance, std::uint64_t seed,
                             bool has_pieces = true) const {
        return simulate_to_tolerance(
                   {*surfaces_, pieces_.mesh.groups, scene().bands, layers_,
                    has_pieces ? pieces_.count : 0},
                   {1 << 22, 16, tolerance}, {seed})
            .tallies.front();
    }

    //! Returns the daily gross assimilation, computed from pieces [mol m-2].
    Estimate gross(const std::vector<Tally>& tallies) const {
        std::vector<double> values;
        const FluxTallies fluxes =
            assimilate(tallies, pieces_, lit(leaves_)).tallies;
        for (const FluxTally& tally : fluxes.front())
            values.push_back(tally.sum());
        return values.size() > 1 ? estimate(values)
                                 : Estimate{values.front(), 0};
    }

    //! Returns the daily gross assimilation, computed without pieces [mol m-2].
    Estimate exact(double tolerance) const {
        std::vector<LeafGroup> of_pieces;
        for (const std::uint32_t group : pieces_.group)
            of_pieces.push_back(leaves_[group]);
        std::vector<double> values;
        for (const FluxTally& tally :
             assimilate_exactly(field_.mesh, lit(of_pieces),
                                {1 << 22, 16, tolerance}, {1})
                 .tallies)
            values.push_back(tally.sum());
        return estimate(values);
    }

    //! Returns the assimilation computed from the mean light of all tallies. It
    //! is still biased by the noise of this light.
    double plain(const std::vector<Tally>& tallies) const {
        Tally mean = tallies.front();
        for (LeafLight& light : mean.leaf_light) light = {};
        const double part = 1. / static_cast<double>(tallies.size());
        for (const Tally& tally : tallies)
            for (std::size_t s = 0; s < mean.leaf_light.size(); ++s)
                for (auto which : {&LeafLight::beam, &LeafLight::diffuse})
                    for (const auto& [place, energy] :
                         tally.leaf_light[s].*which)
                        (mean.leaf_light[s].*which)
                            .push_back({place, part * energy});
        return gross({mean}).mean;
    }

  private:
    static Campaign campaign(const Stands& which) {
        Campaign campaign = read_campaign(
            fmt::format("{}/{}.toml", IDEOTYPE_CAMPAIGNS, which.campaign));
        for (auto& day : campaign.spec.days) day.value.step_minutes = 60;
        if (which.plants > 0)
            campaign.spec.field.rows = campaign.spec.field.plants =
                which.plants;
        if (which.spacing) campaign.spec.spacings[0].value = *which.spacing;
        return campaign;
    }

    const Scene& scene() const { return stand_.request.scene; }

    LitLeaves lit(const std::vector<LeafGroup>& leaves) const {
        return {*surfaces_,
                pieces_.mesh.groups,
                scene().bands.front(),
                scene().photons,
                leaves,
                layers_};
    }

    BenchStand stand_;
    Field field_;
    Pieces pieces_;
    std::optional<RayScene> surfaces_;
    std::vector<LeafGroup> leaves_;
    Layers layers_;
};

constexpr double along = 0, across = 90;
constexpr auto pole = "../tests/data/golden/pole";
const Stands stands[] = {
    {"2 x 2, leaves along", "ames", 2, pole, along, {}},
    {"2 x 2, leaves across", "ames", 2, pole, across, {}},
    {"6 x 6, leaves along", "ames", 6, pole, along, {}},
    {"6 x 6, leaves across", "ames", 6, pole, across, {}},
    {"ames.toml"},
    {"ames.toml, 15 x 3 inches",
     "ames",
     0,
     nullptr,
     {},
     Spacing{.381, .0762, 90}},
    {"ames.toml, elite", "ames", 0, "plants/elite", {}, {}},
    {"bondville.toml", "bondville"}};

//! Returns the processor time that this program has used [ms].
double processor_time() {
    return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

//! Returns the excess kurtosis, which is 0 for normal values and positive for
//! heavy tails.
double excess_kurtosis(const std::vector<double>& values) {
    const double mean = estimate(values).mean;
    double square = 0, fourth = 0;
    for (const double value : values) {
        const double deviation = (value - mean) * (value - mean);
        square += deviation;
        fourth += deviation * deviation;
    }
    return static_cast<double>(values.size()) * fourth / (square * square) - 3;
}

void print_bias(int seeds) {
    fmt::print(
        "| stand | tolerance | without correction % | corrected % | "
        "beyond 2 s.e. | scatter / s.e. | excess kurtosis |\n"
        "|---|---|---|---|---|---|---|\n");
    for (const Stands& which : stands) {
        const Canopy canopy(which);
        const Estimate truth = canopy.gross(canopy.light(5e-4, 999));
        for (const double tolerance : {.05, .02, .008, .003}) {
            std::vector<double> plain, corrected;
            double variance = 0, beyond = 0;
            for (int seed = 1; seed <= seeds; ++seed) {
                const std::vector<Tally> light =
                    canopy.light(tolerance, static_cast<std::uint64_t>(seed));
                const Estimate found = canopy.gross(light);
                plain.push_back(canopy.plain(light));
                corrected.push_back(found.mean);
                variance += found.standard_error * found.standard_error / seeds;
                if (std::abs(found.mean - truth.mean) >
                    2 * std::hypot(found.standard_error, truth.standard_error))
                    beyond += 1. / seeds;
            }
            const auto against = [&](const std::vector<double>& values) {
                const Estimate mean = estimate(values);
                return fmt::format(
                    "{:+.3f} +- {:.3f}", 100 * (mean.mean / truth.mean - 1),
                    100 *
                        std::hypot(mean.standard_error, truth.standard_error) /
                        truth.mean);
            };
            fmt::print("| {} | {} | {} | {} | {:.3f} | {:.2f} | {:.1f} |\n",
                       which.name, tolerance, against(plain),
                       against(corrected), beyond,
                       estimate(corrected).standard_error *
                           std::sqrt(seeds / variance),
                       excess_kurtosis(corrected));
            std::fflush(stdout);
        }
    }
}

void print_pieces() {
    fmt::print(
        "| stand | cells along | 12 | 24 | 48 | 96 | without pieces |\n"
        "|---|---|---|---|---|---|---|\n");
    constexpr double tolerance = 5e-4;
    for (const Stands& which : {stands[0], stands[1], stands[4]})
        for (const int cells : {12, 48}) {
            fmt::print("| {} | {} ", which.name, cells);
            for (const std::size_t pieces : {12, 24, 48, 96}) {
                if (pieces > 2 * static_cast<std::size_t>(cells)) {
                    fmt::print("| ");
                    continue;
                }
                const Canopy canopy(which, pieces, cells);
                const Estimate gross = canopy.gross(canopy.light(tolerance, 1));
                fmt::print("| {:.5f} +- {:.5f} ", gross.mean,
                           gross.standard_error);
                std::fflush(stdout);
            }
            const Estimate exact = Canopy(which, 12, cells).exact(tolerance);
            fmt::print("| {:.5f} +- {:.5f} |\n", exact.mean,
                       exact.standard_error);
            std::fflush(stdout);
        }
}

//! Evaluates the baseline of a campaign alternately for light alone and for
//! gross assimilation, and compares the costs.
class Costs {
  public:
    Costs(const BenchStand& stand, double tolerance, int repeats) {
        CanopyRequest request = stand.request;
        request.accuracy = {1 << 22, 16, tolerance};
        for (int i = 1; i <= repeats; ++i) {
            request.randomness.seed = static_cast<std::uint64_t>(i);
            request.scene.components[0].photosynthesis.reset();
            add(light_, request, stand.device);
            request.scene.components[0].photosynthesis.emplace();
            add(assimilation_, request, stand.device);
        }
    }

    //! Returns the ratio of times, and the ratio at equal errors, for errors
    //! that are inversely proportional to the square root of time.
    std::string line() const {
        const double ratio = time(assimilation_) / time(light_);
        return fmt::format(
            "{:.1f} | {:.3f} | {:.1f} | {:.3f} | {:.2f} | {:.2f}", time(light_),
            error(light_), time(assimilation_), error(assimilation_), ratio,
            ratio * std::pow(error(assimilation_) / error(light_), 2));
    }

  private:
    struct Runs {
        std::vector<double> times, errors;
    };

    static void add(Runs& runs, const CanopyRequest& request,
                    const Device& device) {
        const double began = processor_time();
        const CanopyReport report = evaluate(request, device);
        runs.times.push_back(processor_time() - began);
        const Estimate& found = report.assimilation
                                    ? report.assimilation->gross.sum
                                    : report.par().light.day.leaves;
        runs.errors.push_back(100 * found.standard_error / found.mean);
    }

    static double time(Runs runs) {
        std::sort(runs.times.begin(), runs.times.end());
        return runs.times[runs.times.size() / 2];
    }

    static double error(const Runs& runs) {
        double squares = 0;
        for (const double each : runs.errors) squares += each * each;
        return std::sqrt(squares / static_cast<double>(runs.errors.size()));
    }

    Runs light_, assimilation_;
};

void print_cost(int repeats) {
    fmt::print(
        "| campaign | tolerance | light ms | error % | assimilation ms | "
        "error % | ratio | at equal error "
        "|\n|---|---|---|---|---|---|---|---|\n");
    for (const char* name : {"ames", "bondville"}) {
        const BenchStand stand(
            read_campaign(fmt::format("{}/{}.toml", IDEOTYPE_CAMPAIGNS, name)));
        for (const double tolerance : {.008, .003, .001}) {
            fmt::print("| {} | {} | {} |\n", name, tolerance,
                       Costs(stand, tolerance, repeats).line());
            std::fflush(stdout);
        }
    }
}

}  // namespace

}  // namespace ideotype

int main(int argc, char** argv) {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "bias" && argc > 2)
        ideotype::print_bias(std::atoi(argv[2]));
    else if (what == "pieces")
        ideotype::print_pieces();
    else if (what == "cost" && argc > 2)
        ideotype::print_cost(std::atoi(argv[2]));
    else
        return 2;
}
