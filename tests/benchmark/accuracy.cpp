//! What accuracy costs: for each stand, light and tolerance the error that
//! evaluations report, the time of the processor they take, and the figure of
//! merit 1 / (relative variance x core-seconds).
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "ideotype/fidelity/probe.hpp"
#include "stand.hpp"

namespace ideotype {

namespace {

//! Under which light and with which surfaces.
struct Setting {
    const char* name;
    bool has_sky;
    Lambertian surface;
    double soil_albedo;
};

constexpr Setting settings[] = {
    {"beams on black surfaces", false, {0, 0}, 0},
    {"PAR", true, {.05, .05}, .1},
    {"near infrared", true, {.42, .42}, .2},
};

//! 14 instants of a clear day, and so many rows of so many plants.
Campaign ames(int plants) {
    Campaign campaign = Stand::ames();
    campaign.days[0].value.step_minutes = 60;
    campaign.field.rows = campaign.field.plants = plants;
    return campaign;
}

void change(Stand& stand, const Setting& setting) {
    Scenario& scenario = stand.request.scenario;
    scenario.optics = {setting.surface, setting.surface, setting.soil_albedo};
    if (!setting.has_sky) {
        std::erase_if(scenario.light.light.sources,
                      [](const Source& source) { return !source.direction; });
        std::fill(scenario.light.sky_of.begin(), scenario.light.sky_of.end(),
                  -1);
    }
}

void print_row(int plants, const Setting& setting, int randomisations,
               double tolerance) {
    Stand stand(ames(plants));
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
    const double time = median(seconds);
    fmt::print(
        "| {} x {} | {} | {} | {:.2f} | {:.4f} | {:.0f} | {:.2f} | {:.2f} "
        "| {:.3g} |\n",
        plants, plants, setting.name, randomisations, 100 * tolerance,
        100 * std::sqrt(squares), paths, 1e3 * time,
        1e3 * (parts.geometry + parts.scene), 1 / (squares * time));
    std::fflush(stdout);
}

void measure(const std::vector<int>& randomisations, double finest) {
    fmt::print(
        "| plants | light | randomisations | tolerance % | s.e. % | paths | ms "
        "| geometry and scene ms | 1 / (variance x core-seconds) |\n"
        "|---|---|---|---|---|---|---|---|---|\n");
    for (const int plants : {2, 6})
        for (const Setting& setting : settings)
            for (const int n : randomisations)
                for (const double tolerance : {8e-3, 3e-3, 1e-3, 3e-4})
                    if (tolerance >= finest)
                        print_row(plants, setting, n, tolerance);
}

}  // namespace

}  // namespace ideotype

//! Arguments: the finest tolerance [%] and numbers of randomisations.
int main(int argc, char** argv) {
    std::vector<int> randomisations;
    for (int i = 2; i < argc; ++i) randomisations.push_back(std::atoi(argv[i]));
    if (randomisations.empty()) randomisations = {8};
    ideotype::measure(randomisations,
                      argc > 1 ? std::atof(argv[1]) / 100 * .999 : 0);
}
