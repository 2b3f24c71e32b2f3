// SPDX-License-Identifier: Apache-2.0
#include "randomised.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ideotype {

Randomised scaled(Randomised x, double factor) {
    x.estimate = scaled(x.estimate, factor);
    for (double& value : x.by_randomisation) value *= factor;
    return x;
}

Randomised known_to(double least, std::vector<double> values) {
    Estimate mean = estimate(values);
    mean.standard_error = std::max(mean.standard_error, least);
    return {mean, std::move(values)};
}

std::vector<Randomised> randomised(
    const std::vector<Estimate>& estimates,
    const std::vector<std::vector<double>>& by_randomisation, double factor) {
    std::vector<Randomised> all;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        Randomised one{estimates[i], {}};
        for (const std::vector<double>& each : by_randomisation) {
            IDEOTYPE_EXPECT(each.size() == estimates.size());
            one.by_randomisation.push_back(each[i]);
        }
        all.push_back(scaled(std::move(one), factor));
    }
    return all;
}

Randomised certain(const CanopyReport& report, double value) {
    return {{value, 0}, std::vector(report.randomisations(), value)};
}

namespace {

//! Returns a loss without the respiration that is already subtracted in
//! AssimilationReport::before_losses() [mol m-2 day-1].
double amount(const CarbonLoss& losses, Loss loss) {
    switch (loss) {
        case Loss::none:
            break;
        case Loss::in_light:
            return losses.in_light;
        case Loss::respiration:
            return losses.respired();
        case Loss::all:
            return losses.all();
    }
    return 0;
}

}  // namespace

const FluxReport& flux_before(const AssimilationReport& report, Loss loss) {
    return loss == Loss::none ? report.gross : report.before_losses();
}

Randomised lowered(const Estimate& mean, std::vector<double> flux,
                   const CarbonLoss& lost,
                   const std::vector<CarbonLoss>& losses, Loss loss) {
    Randomised net{{mean.mean - amount(lost, loss), mean.standard_error},
                   std::move(flux)};
    for (std::size_t r = 0; r < net.by_randomisation.size(); ++r)
        net.by_randomisation[r] -=
            amount(losses.empty() ? lost : losses[r], loss);
    if (!losses.empty())
        net.estimate.standard_error =
            estimate(net.by_randomisation).standard_error;
    return net;
}

std::vector<Randomised> along(const std::vector<FluxTally>& tallies,
                              const std::vector<Estimate>& found,
                              std::vector<double> FluxTally::*part) {
    return randomised(found, mapped(tallies, part));
}

Randomised per_leaf_area(const CanopyReport& report, const Randomised& number,
                         double lai, double LeafArea::*of) {
    if (!(lai > 0)) return certain(report, 0);
    const double ratio = number.estimate.mean / lai;
    Randomised result = ratio_with_error(
        ratio, lai, report.randomisations(), [&](std::size_t r) {
            return number.by_randomisation[r] -
                   ratio * (report.leaf_area_by_randomisation[r].*of);
        });
    // If randomisations agree by chance, their scatter underestimates the
    // error.
    const double scatter = estimate(number.by_randomisation).standard_error;
    const double error = number.estimate.standard_error;
    if (error > scatter)
        result.estimate.standard_error =
            std::hypot(result.estimate.standard_error,
                       std::sqrt(error * error - scatter * scatter) / lai);
    return result;
}

Randomised per_leaf_area(const CanopyReport& report, const Randomised& number) {
    return per_leaf_area(report, number, report.lai, &LeafArea::all);
}

double over_leaves(const CanopyReport& report,
                   const std::vector<double>& groups, std::size_t component) {
    return over_groups(report, groups, [&](const SurfaceId& id) {
        return id.is_leaf() && id.component == component;
    });
}

double over_plants(const CanopyReport& report,
                   const std::vector<double>& groups, std::size_t component) {
    return over_groups(report, groups, [&](const SurfaceId& id) {
        return id.component == component;
    });
}

}  // namespace ideotype
