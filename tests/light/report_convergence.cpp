// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "ideotype/light/report.hpp"
#include "light_report.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

constexpr int randomisations = 32;

//! Returns the campaign with 36 plants and a sun position for every hour.
Campaign ames(const std::string& campaigns) {
    Campaign campaign = read_campaign(campaigns + "/ames.toml");
    campaign.spec.field.rows = campaign.spec.field.plants = 6;
    campaign.spec.days[0].value.step_minutes = 60;
    return campaign;
}

//! The field of the baseline under the light of its day at Ames.
struct Baseline {
    explicit Baseline(const std::string& campaigns)
        : campaign(ames(campaigns)),
          chosen(cases(campaign).front()),
          scene(scene_of(campaign, chosen)),
          field(draw_field(scene, {chosen.seed})),
          device(Device::supported_isas().back()),
          surfaces(build_scene(device, field)) {}

    BudgetEstimate light(int paths) const {
        const Layers layers;
        const Subject subject{surfaces, field.mesh.groups, scene.bands, layers};
        return report(simulate(subject, Accuracy{paths, randomisations},
                               {chosen.seed})
                          .front(),
                      scene.light())
            .day;
    }

    Campaign campaign;
    Case chosen;
    Scene scene;
    Field field;
    Device device;
    RayScene surfaces;
};

//! A straight line fitted by least squares.
class Line {
  public:
    void add(double x, double y) {
        n_ += 1;
        x_ += x;
        y_ += y;
        xx_ += x * x;
        xy_ += x * y;
    }
    double slope() const { return (n_ * xy_ - x_ * y_) / (n_ * xx_ - x_ * x_); }

  private:
    double n_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

//! Prints a row for 2^k paths and returns the relative standard error.
double measure(const Baseline& baseline, int k) {
    const auto began = std::chrono::steady_clock::now();
    const BudgetEstimate light = baseline.light(1 << k);
    const std::chrono::duration<double> seconds =
        std::chrono::steady_clock::now() - began;
    const double relative = light.leaves.standard_error / light.leaves.mean;
    fmt::print("| {:.3g} | 2^{} | {:.6f} | {:.2e} | {:.2g} |\n",
               std::ldexp(randomisations, k), k,
               light.leaves.mean / light.incident, relative, seconds.count());
    std::fflush(stdout);
    return relative;
}

}  // namespace

void report_convergence(const std::string& campaigns) {
    const Baseline baseline(campaigns);
    constexpr int first = 8, last = 20;
    fmt::print(
        "\n## Convergence\n\nHow fast does the error fall with paths? PAR that "
        "the baseline's leaves absorb in a day at Ames: one field of\n6 x 6 "
        "plants, a sun for every hour, {} randomisations, one core.\n\n"
        "| paths | per randomisation | fraction | relative s.e. | s |\n"
        "|---|---|---|---|---|\n",
        randomisations);
    Line fit;
    for (int k = first; k <= last; ++k)
        fit.add(k, std::log2(measure(baseline, k)));
    fmt::print(
        "\nFrom 2^{} to 2^{} the error falls with paths to the power "
        "{:.2f}; -0.5 is that of\nindependent paths.\n",
        first, last, fit.slope());
}

}  // namespace ideotype
