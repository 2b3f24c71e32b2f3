// SPDX-License-Identifier: Apache-2.0
#include "ideotype/fidelity/trade.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/run/progress.hpp"
#include "ideotype/stand/stand.hpp"

namespace ideotype {

namespace {

//! Part of the time for the converged figures.
constexpr double for_converged = 0.2;

//! Biases far beyond this are too large for any use, and known well enough.
constexpr double relevant = 2e-3;

//! So many draws at a time, between two decisions.
constexpr std::size_t batch = 4;

//! Mean of differences between two probes' draws that share their numbers.
Estimate paired(const Probe& a, const Probe& b, Goal goal) {
    const std::size_t n = std::min(a.draws(), b.draws());
    std::vector<double> apart(n);
    for (std::size_t i = 0; i < n; ++i)
        apart[i] = a.means(goal)[i] - b.means(goal)[i];
    return estimate(apart);
}

Scatter scaled(const Scatter& scatter, double factor) {
    return {scaled(scatter.field, factor), scaled(scatter.path, factor)};
}

//! The probes of one parameter.
class ParameterProbes {
  public:
    ParameterProbes(const Parameter& parameter, std::size_t case_index,
                    const Device& device, const Rivals& plants)
        : parameter_(parameter) {
        for (std::size_t v = 0; v < parameter.values.size(); ++v)
            probes_.emplace_back(parameter.at(v), case_index, device, plants);
    }

    const Parameter& parameter() const { return parameter_; }
    std::size_t size() const { return probes_.size(); }
    std::size_t draws(std::size_t value) const {
        return probes_[value].draws();
    }

    //! A value is only as well known as its reference has draws.
    void draw(std::size_t value) {
        probes_[value].draw();
        Probe& reference = probes_[parameter_.reference];
        while (reference.draws() < probes_[value].draws()) reference.draw();
    }

    //! By how much the error of the biases would fall [relative, squared, per
    //! second], if there was one draw more.
    double worth(std::size_t value) const {
        if (value == parameter_.reference) return 0;
        const Probe& probe = probes_[value];
        const Probe& reference = probes_[parameter_.reference];
        const double scale =
            std::abs(estimate(reference.means(Goal::value)).mean);
        const Estimate light = paired(probe, reference, Goal::value);
        const Estimate difference = paired(probe, reference, Goal::difference);
        const double error =
            std::max(light.standard_error, difference.standard_error) / scale;
        const double bias =
            std::min(std::abs(light.mean), std::abs(difference.mean)) / scale;
        const auto n = static_cast<double>(probe.draws());
        double seconds = probe.seconds() / n;
        if (reference.draws() <= probe.draws())
            seconds += reference.seconds() / n;
        const double use = 1 / (1 + bias * bias / (relevant * relevant));
        return use * error * error / (n * seconds);
    }

    MeasuredParameter measured() const {
        MeasuredParameter result{parameter_, {}};
        const Probe& reference = probes_[parameter_.reference];
        const double scale =
            1 / std::abs(estimate(reference.means(Goal::value)).mean);
        for (std::size_t v = 0; v < size(); ++v) {
            const Probe& probe = probes_[v];
            ParameterPoint point;
            point.name = parameter_.values[v].name;
            point.draws = probe.draws();
            for (const Goal goal : {Goal::value, Goal::difference})
                point.inaccuracy[goal == Goal::value ? 0 : 1] = {
                    scaled(paired(probe, reference, goal), scale),
                    scaled(probe.scatter(goal), scale)};
            point.cost = probe.cost();
            result.points.push_back(point);
        }
        return result;
    }

  private:
    Parameter parameter_;
    std::vector<Probe> probes_;
};

//! Measures all parameters, within a time.
class Survey {
  public:
    Survey(const Effort& effort, const OnProgress& on_progress)
        : effort_(effort), on_progress_(on_progress), began_(now()) {}

    void add(ParameterProbes probes) { all_.push_back(std::move(probes)); }

    void run() {
        // In turns, so that what else the machine does slows all alike.
        const std::size_t least =
            std::min(effort_.least_draws, effort_.most_draws);
        for (std::size_t n = 1; n <= least; ++n)
            for (ParameterProbes& probes : all_)
                for (std::size_t v = 0; v < probes.size(); ++v)
                    while (probes.draws(v) < std::min(n, least_of(probes)))
                        step(probes, v);
        const double until = effort_.seconds * (1 - for_converged);
        while (elapsed() < until && refine()) {
        }
    }

    //! The figures with all parameters at their references.
    void converge(Probe& probe) {
        while (probe.draws() < effort_.least_draws ||
               (elapsed() < effort_.seconds &&
                probe.draws() < effort_.most_draws)) {
            tell("converged figures");
            probe.draw();
        }
    }

    std::vector<MeasuredParameter> measured() const {
        std::vector<MeasuredParameter> result;
        for (const ParameterProbes& probes : all_)
            result.push_back(probes.measured());
        return result;
    }

  private:
    //! Draws with many paths scatter less.
    std::size_t least_of(const ParameterProbes& probes) const {
        const auto effort = static_cast<std::size_t>(probes.parameter().effort);
        return std::max(effort_.least_draws / effort, batch);
    }

    double elapsed() const { return now() - began_; }

    void tell(const std::string& what) const {
        on_progress_(what, std::min(1.0, elapsed() / effort_.seconds));
    }

    void step(ParameterProbes& probes, std::size_t value) {
        tell(probes.parameter().name + " " +
             probes.parameter().values[value].name);
        probes.draw(value);
    }

    //! A few draws where they help most; false if none does.
    bool refine() {
        double most = 0;
        ParameterProbes* best = nullptr;
        std::size_t value = 0;
        for (ParameterProbes& probes : all_) {
            // What has no bias is known well enough.
            if (!probes.parameter().may_be_biased()) continue;
            for (std::size_t v = 0; v < probes.size(); ++v) {
                if (probes.draws(v) >= effort_.most_draws) continue;
                const double worth = probes.worth(v);
                if (worth <= most) continue;
                most = worth;
                best = &probes;
                value = v;
            }
        }
        if (!best) return false;
        const std::size_t until = std::min(
            best->draws(value) + std::max(batch, best->draws(value) / 8),
            effort_.most_draws);
        while (best->draws(value) < until) step(*best, value);
        return true;
    }

    Effort effort_;
    const OnProgress& on_progress_;
    double began_;
    std::vector<ParameterProbes> all_;
};

//! Per randomisation, for the tolerance of the campaign.
int needed_paths(const Campaign& campaign, const Case& chosen,
                 const Device& device, const Genome& genome) {
    CanopyRequest request =
        request_of(sampling_of(Task{}, campaign, chosen), campaign,
                   scenario_of(campaign, chosen), grow(campaign.crop, genome));
    request.accuracy = campaign.sampling;
    const CanopyReport report = evaluate(request, device);
    return static_cast<int>(
        report.paths /
        static_cast<std::uint64_t>(campaign.sampling.randomisations));
}

}  // namespace

const MeasuredParameter& Trade::parameter(const std::string& name) const {
    for (const MeasuredParameter& each : parameters)
        if (each.parameter.name == name) return each;
    throw Error("no parameter " + name);
}

Trade measure_trade(const Campaign& campaign, std::size_t case_index,
                    const Device& device, const Effort& effort,
                    const OnProgress& on_progress) {
    Trade trade;
    trade.own = Variant{campaign};
    trade.case_index = case_index;
    const Case chosen = case_of(trade.own, case_index);
    trade.rivals = rivals(campaign, chosen);
    if (campaign.sampling.tolerance > 0)
        trade.own.campaign.sampling.paths =
            needed_paths(campaign, chosen, device, trade.rivals[0]);
    Survey survey(effort, on_progress);
    Variant converged = trade.own;
    for (const Parameter& parameter :
         parameters(trade.own.campaign, case_index)) {
        survey.add({parameter, case_index, device, trade.rivals});
        if (parameter.kind == Parameter::Kind::arrangement) continue;
        parameter.values[parameter.reference].apply(converged);
        converged.randomisations = parameter.base.randomisations;
    }
    survey.run();
    Probe probe(converged, case_index, device, trade.rivals);
    survey.converge(probe);
    trade.parameters = survey.measured();
    trade.value = estimate(probe.means(Goal::value));
    trade.difference = estimate(probe.means(Goal::difference));
    return trade;
}

}  // namespace ideotype
