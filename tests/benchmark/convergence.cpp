//! Error of the canopy's light against paths, as JSON; draw.py draws it.
#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/estimate.hpp"
#include "ideotype/fidelity/probe.hpp"
#include "ideotype/light/transport.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! The scene of the study: 14 instants, and so many rows of so many plants.
Campaign ames(int plants) {
    Campaign campaign = Stand::ames();
    campaign.days[0].value.step_minutes = 60;
    campaign.field.rows = campaign.field.plants = plants;
    return campaign;
}

//! Under which light and with which surfaces.
struct Setting {
    const char* name;
    Optics optics;
    Illumination light;
};

std::vector<Setting> settings(const Stand& stand) {
    Illumination beams = stand.request.scenario.light.light;
    std::erase_if(beams.sources,
                  [](const Source& source) { return !source.direction; });
    return {
        {"whole day", stand.campaign.optics,
         stand.request.scenario.light.light},
        {"beams on black surfaces", {}, beams},
    };
}

//! Relative standard deviation of one path with independent random numbers: of
//! paths that are alone in their randomisation, at the sources' shares.
double plain_deviation(const Setting& setting, const Scene& scene,
                       const std::vector<Group>& groups) {
    const std::vector<Source>& sources = setting.light.sources;
    constexpr int repetitions = 20000;
    const std::vector<Tally> tallies =
        simulate(scene, groups, setting.optics, setting.light,
                 {static_cast<int>(sources.size()), repetitions}, {2, 0, 0});
    double variance = 0, mean = 0;
    for (std::size_t s = 0; s < sources.size(); ++s) {
        std::vector<double> alone;
        for (const Tally& tally : tallies)
            alone.push_back(tally.sources[s].leaves);
        const Estimate found = estimate(alone);
        const double share = sources[s].energy / setting.light.energy();
        mean += found.mean;
        variance +=
            found.standard_error * found.standard_error * repetitions / share;
    }
    return std::sqrt(variance) / mean;
}

void print_point(const Setting& setting, const Scene& scene,
                 const std::vector<Group>& groups, int paths) {
    const int repetitions = std::clamp((1 << 21) / paths, 32, 512);
    const double began = processor_seconds();
    const std::vector<Tally> tallies =
        simulate(scene, groups, setting.optics, setting.light,
                 {paths, repetitions}, {1, 0, 0});
    const double seconds = processor_seconds() - began;
    std::vector<double> leaves;
    for (const Tally& tally : tallies) leaves.push_back(tally.leaves());
    const Estimate found = estimate(leaves);
    fmt::print(
        "{{\"paths\": {}, \"repetitions\": {}, \"error\": {:.4g}, "
        "\"seconds_per_path\": {:.3g}}}",
        paths, repetitions,
        found.standard_error * std::sqrt(repetitions) / found.mean,
        seconds / paths / repetitions);
}

//! Median time of geometry and scene [s].
double build_seconds(const Stand& stand) {
    std::vector<double> seconds;
    for (int i = 0; i < 25; ++i) {
        const double began = processor_seconds();
        stand.scene(stand.field(stand.baseline));
        seconds.push_back(processor_seconds() - began);
    }
    return median(seconds);
}

void measure() {
    fmt::print("[");
    const char* between = "";
    for (const int plants : {6, 2}) {
        const Stand stand(ames(plants));
        const Field field = stand.field(stand.baseline);
        const Scene scene = stand.scene(field);
        const std::vector<Group>& groups = field.mesh.groups;
        for (const Setting& setting : settings(stand)) {
            fmt::print(
                "{}\n{{\"cell\": {}, \"light\": \"{}\", "
                "\"build_seconds\": {:.4g}, \"plain_deviation\": {:.4g}, "
                "\"points\": [",
                std::exchange(between, ","), plants, setting.name,
                build_seconds(stand), plain_deviation(setting, scene, groups));
            for (int power = 8; power <= 20; ++power) {
                fmt::print("{}\n    ", power == 8 ? "" : ",");
                print_point(setting, scene, groups, 1 << power);
            }
            fmt::print("]}}");
        }
    }
    fmt::print("]\n");
}

}  // namespace

}  // namespace ideotype

int main() {
    ideotype::measure();
}
