// SPDX-License-Identifier: Apache-2.0
//! Measures what accuracy costs: for each stand, light and tolerance the error
//! that evaluations report, the time of the processor they take, the figure of
//! merit 1 / (relative variance x core-seconds), and the parts of the variance.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

#include "ideotype/light/tolerance.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Returns the processor time that this process has used [s].
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

//! A stand with its light and the surfaces of its plants.
struct Setting {
    const char* name;
    bool has_sky;
    Lambertian surface;
    double soil_albedo;
    double finest;  //!< tolerance: beyond it an evaluation takes ten seconds
};

constexpr Setting settings[] = {
    {"beams on black surfaces", false, {0, 0}, 0, 3e-4},
    {"PAR", true, {.05, .05}, .1, 3e-4},
    {"near infrared", true, {.42, .42}, .2, 1e-3},
};

//! Returns a campaign as version 0.1 had it, so that results can be compared:
//! 14 instants of a clear day, and a field with as many rows as plants per row.
Campaign ames(int plants) {
    Campaign campaign = BenchStand::ames();
    campaign.crop.baseline =
        read_crop(IDEOTYPE_CAMPAIGNS "/../tests/data/golden/pole.toml")
            .baseline;
    campaign.spec.days[0].value.step_minutes = 60;
    campaign.spec.field.rows = campaign.spec.field.plants = plants;
    return campaign;
}

void change(BenchStand& stand, const Setting& setting) {
    Band& par = stand.request.scene.bands.front();
    const PlantOptics optics{setting.surface, setting.surface,
                             usual_optics[0].sheath};
    par.optics = {optics.materials(), setting.soil_albedo};
    if (!setting.has_sky) {
        std::erase_if(par.light.light.sources,
                      [](const Source& source) { return !source.direction; });
        std::fill(par.light.sky_of.begin(), par.light.sky_of.end(), -1);
    }
}

//! Relative standard errors of the light absorbed by leaves: the part due to
//! beams and skies that hit leaves directly, and the part due to scattered
//! light.
struct Origins {
    double beams, skies, scattered;
};

//! Returns the errors of an evaluation with the workload that a tolerance
//! requires.
Origins origins_of(const BenchStand& stand, const Accuracy& accuracy) {
    const Field field = stand.field(stand.baseline);
    const RayScene scene = stand.scene(field);
    const Bands& bands = stand.request.scene.bands;
    const Illumination& light = bands.front().light.light;
    const Layers layers;
    const Subject subject{scene, field.mesh.groups, bands, layers};
    const Workload work =
        simulate_to_tolerance(subject, accuracy, {3, 0, 0}).work;
    const double n = accuracy.randomisations;
    const std::vector<Tally> tallies =
        simulate(subject, work, 4 * accuracy.randomisations, {4, 0, 0}).front();
    Budget all;
    for (const Tally& tally : tallies)
        for (const Budget& budget : tally.sources) all += budget;
    const double mean = all.leaves / static_cast<double>(tallies.size());
    const double caught =
        all.sent_on > 0 ? (all.leaves - all.unscattered) / all.sent_on : 0;
    std::vector<double> beams, skies, scattered;
    for (const Tally& tally : tallies) {
        double by_beams = 0, by_skies = 0;
        for (std::size_t s = 0; s < light.sources.size(); ++s) {
            const Budget& budget = tally.sources[s];
            (light.sources[s].direction ? by_beams : by_skies) +=
                budget.unscattered + caught * budget.sent_on;
        }
        beams.push_back(by_beams);
        skies.push_back(by_skies);
        scattered.push_back(tally.leaves() - by_beams - by_skies);
    }
    const auto error = [&](const std::vector<double>& replicates) {
        return estimate(replicates).standard_error *
               std::sqrt(static_cast<double>(replicates.size()) / n) / mean;
    };
    return {error(beams), error(skies), error(scattered)};
}

void print_row(int plants, const Setting& setting, int randomisations,
               double tolerance) {
    BenchStand stand(ames(plants));
    change(stand, setting);
    CanopyRequest& request = stand.request;
    request.accuracy = {1 << 24, randomisations, tolerance};
    const int draws = tolerance < 5e-4 ? 4 : 16;
    double squares = 0;
    std::vector<double> seconds;
    double paths = 0;
    Timing parts;
    for (int d = 0; d < draws; ++d) {
        request.randomness.generation = static_cast<std::uint32_t>(d);
        const double began = processor_seconds();
        const CanopyReport report =
            evaluate(request, stand.device, processor_seconds);
        seconds.push_back(processor_seconds() - began);
        squares += std::pow(relative_error(report), 2) / draws;
        paths += static_cast<double>(report.paths) / draws;
        parts = report.seconds;
    }
    std::ranges::nth_element(seconds, seconds.begin() + draws / 2);
    const double time = seconds[static_cast<std::size_t>(draws) / 2];
    const Origins by = origins_of(stand, request.accuracy);
    fmt::print(
        "| {} x {} | {} | {} | {:.2f} | {:.4f} | {:.0f} | {:.2f} | {:.2f} "
        "| {:.3g} | {:.4f} | {:.4f} | {:.4f} |\n",
        plants, plants, setting.name, randomisations, 100 * tolerance,
        100 * std::sqrt(squares), paths, 1e3 * time,
        1e3 * (parts.geometry + parts.scene), 1 / (squares * time),
        100 * by.beams, 100 * by.skies, 100 * by.scattered);
    std::fflush(stdout);
}

void measure_all(const std::vector<int>& randomisations, double finest) {
    fmt::print(
        "| plants | light | randomisations | tolerance % | s.e. % | paths | ms "
        "| geometry and scene ms | 1 / (variance x core-seconds) | s.e. of "
        "beams % | of skies % | of scattered light % |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const int plants : {2, 6})
        for (const Setting& setting : settings)
            for (const int n : randomisations)
                for (const double tolerance : {8e-3, 3e-3, 1e-3, 3e-4})
                    if (tolerance >= std::max(finest, setting.finest))
                        print_row(plants, setting, n, tolerance);
}

}  // namespace

}  // namespace ideotype

//! Arguments: the smallest tolerance [%], then numbers of randomisations.
int main(int argc, char** argv) {
    std::vector<int> randomisations;
    for (int i = 2; i < argc; ++i) randomisations.push_back(std::atoi(argv[i]));
    if (randomisations.empty()) randomisations = {8};
    ideotype::measure_all(randomisations,
                          argc > 1 ? std::atof(argv[1]) / 100 * .999 : 0);
}
