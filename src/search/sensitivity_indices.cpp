// SPDX-License-Identifier: Apache-2.0
#include "ideotype/search/sensitivity_indices.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>
#include <span>

#include "ideotype/core/random.hpp"

namespace ideotype {

namespace {

//! Rows of one sample.
using Sample = std::span<const Estimate>;

//! Indices of a number of samples, [index, factor].
using Indices = std::vector<std::vector<double>>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double squared(double x) {
    return x * x;
}

double noise_of(const Estimate& x) {
    return squared(x.standard_error);
}

//! What the indices are means and variances of, with one column for each.
class Terms {
  public:
    explicit Terms(std::size_t factors) : factors_(factors) {}
    virtual ~Terms() = default;
    virtual void add(std::uint32_t sample, Sample rows) = 0;
    //! Of these samples, which may repeat.
    virtual Indices indices(std::span<const std::size_t> chosen) const = 0;

  protected:
    std::size_t factors_;
};

class SobolTerms : public Terms {
  public:
    SobolTerms(std::size_t factors, double centre)
        : Terms(factors), centre_(centre) {}

    void add(std::uint32_t, Sample rows) override {
        const Estimate &a = rows.front(), &b = rows.back();
        const double at_a = a.mean - centre_, at_b = b.mean - centre_;
        Sums sums{at_a + at_b,
                  squared(at_a) + squared(at_b),
                  noise_of(a) + noise_of(b),
                  {},
                  {}};
        for (std::size_t i = 1; i <= factors_; ++i) {
            const double change = rows[i].mean - a.mean;
            sums.first.push_back(at_b * change);
            sums.total.push_back(
                (squared(change) - noise_of(a) - noise_of(rows[i])) / 2);
        }
        samples_.push_back(std::move(sums));
    }

    Indices indices(std::span<const std::size_t> chosen) const override {
        double sum = 0, squares = 0, noise = 0;
        Indices found(2, std::vector<double>(factors_));
        for (const std::size_t i : chosen) {
            const Sums& each = samples_[i];
            sum += each.sum;
            squares += each.squares;
            noise += each.noise;
            for (std::size_t k = 0; k < factors_; ++k) {
                found[0][k] += each.first[k];
                found[1][k] += each.total[k];
            }
        }
        const auto count = static_cast<double>(chosen.size());
        const double variance =
            (squares - noise) / (2 * count) - squared(sum / (2 * count));
        // Rounding alone makes constants vary.
        const bool is_constant = !(variance > squared(1e-12 * centre_));
        for (std::vector<double>& index : found)
            for (double& x : index)
                x = is_constant ? nan : x / count / variance;
        return found;
    }

  private:
    struct Sums {
        double sum, squares, noise;        //!< of A and B
        std::vector<double> first, total;  //!< of each factor
    };
    double centre_;
    std::vector<Sums> samples_;
};

class MorrisTerms : public Terms {
  public:
    explicit MorrisTerms(const SensitivityDesign& design)
        : Terms(design.factors().size()), design_(design) {}

    void add(std::uint32_t sample, Sample rows) override {
        std::vector<Estimate> effects(factors_);
        std::size_t row = 0;
        for (const auto& [factor, sign] : design_.steps(sample)) {
            const Estimate &before = rows[row], &after = rows[++row];
            const double scale = sign / design_.step_size();
            effects[factor] = scaled(
                {after.mean - before.mean,
                 std::hypot(before.standard_error, after.standard_error)},
                scale);
        }
        effects_.push_back(std::move(effects));
    }

    Indices indices(std::span<const std::size_t> chosen) const override {
        Indices found(4, std::vector<double>(factors_));
        for (std::size_t k = 0; k < factors_; ++k) {
            std::vector<double> effects;
            double sizes = 0, variance = 0, noise = 0;
            for (const std::size_t i : chosen) {
                const auto& [effect, error] = effects_[i][k];
                effects.push_back(effect);
                sizes += std::abs(effect);
                variance += squared(error);
                noise += error * std::sqrt(2 / std::numbers::pi);
            }
            const auto count = static_cast<double>(chosen.size());
            const auto [mean, error] = estimate(effects);
            const bool is_group = design_.factors()[k].genes.size() > 1;
            found[0][k] = is_group ? nan : mean;
            found[1][k] = sizes / count;
            found[2][k] = std::sqrt(
                std::max(0.0, count * squared(error) - variance / count));
            found[3][k] = noise / count;
        }
        return found;
    }

  private:
    const SensitivityDesign& design_;
    std::vector<std::vector<Estimate>> effects_;  //!< [sample, factor]
};

//! Indices with their standard deviations over samples drawn with replacement.
std::vector<std::vector<Estimate>> with_errors(const Terms& terms,
                                               std::size_t samples) {
    std::vector<std::size_t> chosen(samples);
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    std::vector<std::vector<Estimate>> result;
    for (const std::vector<double>& index : terms.indices(chosen)) {
        result.emplace_back();
        for (const double x : index) result.back().push_back({x, 0});
    }
    constexpr std::uint32_t draws = 500;
    std::vector<Indices> drawn;
    for (std::uint32_t draw = 0; draw < draws; ++draw) {
        RandomStream stream(0, Purpose::bootstrap, draw);
        for (std::size_t& each : chosen)
            each = stream.below(static_cast<std::uint32_t>(samples));
        drawn.push_back(terms.indices(chosen));
    }
    std::vector<double> values(draws);
    for (std::size_t i = 0; i < result.size(); ++i)
        for (std::size_t k = 0; k < result[i].size(); ++k) {
            for (std::size_t d = 0; d < draws; ++d) values[d] = drawn[d][i][k];
            result[i][k].standard_error =
                std::sqrt(1.0 * draws) * estimate(values).standard_error;
        }
    return result;
}

bool is_known(Sample rows) {
    return std::all_of(rows.begin(), rows.end(), [](const Estimate& row) {
        return std::isfinite(row.mean) && std::isfinite(row.standard_error);
    });
}

}  // namespace

std::vector<SensitivityIndex> sensitivity_indices(SensitivityMethod method) {
    if (method == SensitivityMethod::sobol)
        return {
            {"first", "share of the variance that the factor makes by itself"},
            {"total", "the same with all that it does together with others"}};
    return {
        {"mu", "mean effect; NaN of several genes", false},
        {"mu_star", "mean size of the effect, noise included", false},
        {"sigma", "standard deviation of the effect without noise", false},
        {"mu_star_of_noise", "mu_star if there were nothing but noise", false}};
}

QuantitySensitivity analyse(const SensitivityDesign& design,
                            const std::vector<Estimate>& rows) {
    const std::size_t size = design.rows_per_sample();
    const bool is_sobol = design.settings().method == SensitivityMethod::sobol;
    const auto sample = [&](std::size_t i) {
        return Sample(rows).subspan(i * size, size);
    };
    std::vector<std::uint32_t> known;
    for (std::uint32_t i = 0; (i + 1) * size <= rows.size(); ++i)
        if (is_known(sample(i))) known.push_back(i);
    QuantitySensitivity result;
    result.samples = known.size();
    std::vector<double> values, independent;
    double noise = 0;
    for (const std::uint32_t i : known)
        for (std::size_t place = 0; place < size; ++place) {
            const Estimate& row = sample(i)[place];
            values.push_back(row.mean);
            if (is_sobol && place > 0 && place + 1 < size) continue;
            independent.push_back(row.mean);
            noise += noise_of(row);
        }
    const auto count = static_cast<double>(independent.size());
    result.mean = estimate(values).mean;
    const double all = (count - 1) * noise_of(estimate(independent));
    result.noise = std::sqrt(noise / count);
    result.standard_deviation = std::sqrt(std::max(0.0, all - noise / count));
    std::unique_ptr<Terms> terms;
    if (is_sobol)
        terms =
            std::make_unique<SobolTerms>(design.factors().size(), result.mean);
    else
        terms = std::make_unique<MorrisTerms>(design);
    for (const std::uint32_t i : known) terms->add(i, sample(i));
    if (known.size() > 1)
        result.indices = with_errors(*terms, known.size());
    else
        result.indices.assign(
            sensitivity_indices(design.settings().method).size(),
            std::vector<Estimate>(design.factors().size(), {nan, nan}));
    return result;
}

}  // namespace ideotype
