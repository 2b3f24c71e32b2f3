#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/light/report.hpp"
#include "light_report.hpp"

namespace ideotype {

namespace {

constexpr int randomisations = 32;

//! The baseline's field under its day at Ames.
struct Baseline {
    explicit Baseline(const std::string& campaigns)
        : campaign(read_campaign(campaigns + "/ames.toml")),
          chosen(cases(campaign).front()),
          day(clear_day(chosen.site, chosen.day, campaign.par_fraction)),
          illumination(illuminate(day, campaign.sky_model,
                                  campaign.field.row_direction)),
          field(build_field(campaign, chosen, to_genome(campaign.baseline),
                            {chosen.seed, 0, {}, Draws::Fields::one}, 0)),
          device(Device::supported_isas().back()),
          scene(device, field.mesh, field.period_x, field.period_y) {}

    BudgetEstimate light(int paths) const {
        return report(simulate(scene, field.mesh.groups, campaign.optics,
                               illumination.light, {paths, randomisations},
                               {chosen.seed, 0, 0}),
                      illumination, day)
            .day;
    }

    Campaign campaign;
    Case chosen;
    Day day;
    DayIllumination illumination;
    Field field;
    Device device;
    Scene scene;
};

}  // namespace

void report_convergence(const std::string& campaigns) {
    const Baseline baseline(campaigns);
    constexpr double goal = 1e-5;
    constexpr int first = 8, fitted = 20, last = 26;
    fmt::print(
        "\n## Convergence\n\nThe light that the leaves of the baseline at Ames "
        "take in a day, one field, {}\nrandomisations, on one core: until the "
        "relative s.e. is {:.0e}.\n\n| paths | of the randomisation | fraction "
        "| relative s.e. | s |\n|---|---|---|---|---|\n",
        randomisations, goal);
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (int k = first; k <= last; ++k) {
        const auto began = std::chrono::steady_clock::now();
        const BudgetEstimate light = baseline.light(1 << k);
        const std::chrono::duration<double> seconds =
            std::chrono::steady_clock::now() - began;
        const double relative = light.leaves.standard_error / light.leaves.mean;
        fmt::print("| {:.3g} | 2^{} | {:.6f} | {:.2e} | {:.2g} |\n",
                   std::ldexp(randomisations, k), k,
                   light.leaves.mean / light.incident, relative,
                   seconds.count());
        std::fflush(stdout);
        if (k <= fitted) {
            const double log_error = std::log2(relative);
            n += 1;
            x += k;
            y += log_error;
            xx += k * k;
            xy += k * log_error;
        }
        if (k >= fitted && relative <= goal) break;
    }
    fmt::print(
        "\nFrom 2^{} to 2^{} the error falls with paths to the power "
        "{:.2f}; -0.5 is that of\nindependent paths.\n",
        first, fitted, (n * xy - x * y) / (n * xx - x * x));
}

}  // namespace ideotype
