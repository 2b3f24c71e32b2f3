//! The bias of canopy assimilation by the light of pieces of leaves: of noise
//! in that light, against the number of paths, and of the size of pieces; and
//! whether standard errors are honest.
//!
//!     assimilation bias SEEDS
//!     assimilation pieces
//!     assimilation time
#include "ideotype/canopy/assimilation.hpp"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "ideotype/light/tolerance.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! b73_v01 at Ames, 30 x 6 inches, 14 instants of a clear day; its leaves
//! along the row or across it.
struct Layout {
    int plants;  //!< rows, and plants of each
    bool is_across;
};

class Canopy {
  public:
    explicit Canopy(const Layout& which,
                    std::size_t per_blade = pieces_of_blade,
                    int cells_along = 12)
        : stand_(ames(which.plants)) {
        Plant plant = read_plant(IDEOTYPE_CAMPAIGNS "/plants/b73_v01.toml");
        for (std::size_t i = 0; i < plant.leaves.size(); ++i)
            plant.leaves[i].azimuth =
                (i % 2 == 0 ? 0 : 180) + (which.is_across ? 90 : 0);
        const Mesh mesh = build_plant(plant, {cells_along});
        const Pieces pieces = cut_leaves(mesh, {}, per_blade);
        field_ = draw_field(pieces.mesh, stand_.request.scenario.field, {1});
        pieces_ = pieces_of_field(pieces, field_.mesh, field_.face_plant);
        field_.mesh = pieces_.mesh;
        scene_.emplace(build_scene(stand_.device, field_));
        std::vector<double> index(mesh.groups.size());
        for (std::size_t v = 0; v < pieces_.count; ++v)
            index[pieces_.group[v]] += pieces_.area[v] / field_.ground_area;
        rates_ = rates_of_groups(photosynthesis_, mesh.groups, index);
    }

    std::vector<Tally> light(double tolerance, std::uint64_t seed,
                             Detail detail = Detail::leaf_light) const {
        return simulate_to_tolerance(*scene_, pieces_.mesh.groups,
                                     scenario().optics, scenario().light.light,
                                     {1 << 22, 16, tolerance}, {seed}, {},
                                     detail)
            .tallies;
    }

    //! Gross assimilation of a day [mol m-2].
    Estimate gross(const std::vector<Tally>& tallies) const {
        std::vector<double> values;
        for (const AssimilationTally& tally :
             assimilate(tallies, *scene_, pieces_, scenario().optics,
                        scenario().light, photosynthesis_, rates_, {}))
            values.push_back(tally.gross());
        return values.size() > 1 ? estimate(values)
                                 : Estimate{values.front(), 0};
    }

    //! Of the mean light, with what its noise does.
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
    static Campaign ames(int plants) {
        Campaign campaign = Stand::ames();
        campaign.days[0].value.step_minutes = 60;
        campaign.field.rows = campaign.field.plants = plants;
        return campaign;
    }

    const Scenario& scenario() const { return stand_.request.scenario; }

    Stand stand_;
    Field field_;
    Pieces pieces_;
    std::optional<Scene> scene_;
    Photosynthesis photosynthesis_;
    std::vector<LeafRates> rates_;
};

std::string name(const Layout& which) {
    return fmt::format("{0} x {0}, leaves {1}", which.plants,
                       which.is_across ? "across" : "along");
}

constexpr Layout layouts[] = {{2, false}, {2, true}, {6, false}, {6, true}};

double seconds() {
    return std::chrono::duration<double>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

void print_bias(int seeds) {
    fmt::print(
        "| stand | tolerance | without correction % | corrected % | "
        "beyond 2 s.e. | scatter / s.e. |\n|---|---|---|---|---|---|\n");
    for (const Layout& which : layouts) {
        const Canopy canopy(which);
        const Estimate truth = canopy.gross(canopy.light(5e-4, 999));
        for (const double tolerance : {.008, .003}) {
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
            fmt::print("| {} | {} | {} | {} | {:.3f} | {:.2f} |\n", name(which),
                       tolerance, against(plain), against(corrected), beyond,
                       estimate(corrected).standard_error *
                           std::sqrt(seeds / variance));
            std::fflush(stdout);
        }
    }
}

void print_pieces() {
    fmt::print("| stand | 12 | 24 | 48 | 96 |\n|---|---|---|---|---|\n");
    constexpr int fine = 48;
    for (const bool is_across : {false, true}) {
        const Layout which{2, is_across};
        fmt::print("| {} ", name(which));
        for (const std::size_t pieces : {12, 24, 48, 96}) {
            const Canopy canopy(which, pieces, fine);
            const Estimate gross = canopy.gross(canopy.light(5e-4, 1));
            fmt::print("| {:.5f} +- {:.5f} ", gross.mean, gross.standard_error);
            std::fflush(stdout);
        }
        fmt::print("|\n");
    }
}

void print_time() {
    fmt::print(
        "| stand | tolerance | light ms | light of leaves ms | assimilation "
        "ms |\n|---|---|---|---|---|\n");
    for (const Layout& which : {layouts[0], layouts[2]}) {
        const Canopy canopy(which);
        for (const double tolerance : {.008, .001}) {
            const double began = seconds();
            canopy.light(tolerance, 1, Detail::sums);
            const double sums = seconds();
            const std::vector<Tally> light = canopy.light(tolerance, 1);
            const double lit = seconds();
            canopy.gross(light);
            fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.1f} |\n", name(which),
                       tolerance, 1e3 * (sums - began), 1e3 * (lit - sums),
                       1e3 * (seconds() - lit));
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
    else if (what == "time")
        ideotype::print_time();
    else
        return 2;
}
