// SPDX-License-Identifier: Apache-2.0
#include "water_fluxes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ideotype {

namespace {

//! Light added to sampling weights, because leaves in the dark also exchange
//! water [umol m-2 s-1].
constexpr double dark = 100;

//! Closed stomata are computed at each hour of every third day.
constexpr std::size_t closed_days = 3;

//! Returns the steps with the same hour, by day or by night, in groups.
std::vector<std::vector<std::size_t>> alike(
    const std::vector<TimeStep>& steps) {
    std::map<std::pair<double, bool>, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < steps.size(); ++i)
        groups[{steps[i].hour, steps[i].is_lit()}].push_back(i);
    std::vector<std::vector<std::size_t>> all;
    for (auto& [hour, group] : groups) all.push_back(std::move(group));
    return all;
}

}  // namespace

WaterFluxes::WaterFluxes(const LitLeaves& lit, const LeafPlaces& places,
                         FluxTallies empty)
    : lit_(lit),
      light_(lit.par.light),
      places_(places),
      air_(*lit.air),
      drawn_(std::move(empty)),
      fluxes_(leaf_fluxes,
              Flux{std::vector<double>(places.count()),
                   std::vector<double>(lit.par.light.series.steps.size())}),
      layers_(places.count()) {
    prepare_closed();
    for (std::size_t p = 0; p < places.count(); ++p)
        places.for_parts(p, [&](std::size_t, double height, double share) {
            layers_[p][lit.layers.at(height)] += share;
        });
    air_.see(places);
    lines_.emplace(air_);
    batch_.emplace(air_);
    const Randomness& of = air_.leaves().randomness;
    for (std::uint32_t r = 0; r < drawn_.front().size(); ++r)
        starts_.push_back(RandomStream(of.seed, Purpose::leaf_point,
                                       of.generation,
                                       of.first_randomisation + r)
                              .uniform());
    find_counts();
}

//! Chooses the steps in which closed stomata are computed.
void WaterFluxes::prepare_closed() {
    const std::vector<TimeStep>& steps = light_.series.steps;
    closed_.assign(
        air_.leaves().scene.water->openings.size(),
        ClosedStomata(leaf_fluxes, std::vector<double>(steps.size())));
    if (closed_.empty()) return;
    closes_in_.assign(steps.size(), false);
    std::size_t number = 0;
    for (const std::vector<std::size_t>& each : alike(steps)) {
        const std::size_t first = number++ % closed_days;
        for (std::size_t i = std::min(first, each.size() - 1); i < each.size();
             i += closed_days)
            closes_in_[each[i]] = true;
    }
}

//! Computes the mean number of points that each randomisation samples in each
//! step. It is proportional to light, since deviations from the lines increase
//! with light.
void WaterFluxes::find_counts() {
    double all = 0;
    for (const TimeStep& step : light_.series.steps) {
        counts_.push_back((step.par.beam + step.par.diffuse) * lit_.photons +
                          dark);
        all += counts_.back();
    }
    constexpr double per_step = 6;
    const double points =
        std::max(air_.leaves().points,
                 per_step * static_cast<double>(counts_.size())) /
        static_cast<double>(starts_.size());
    for (double& count : counts_) count *= points / all;
}

void WaterFluxes::add(std::size_t step, const StepLight* light) {
    for (std::size_t k = 0; k < leaf_fluxes; ++k)
        amounts_[k] =
            amount_of(static_cast<LeafFlux>(k), light_.series.steps[step]) /
            light_.series.days;
    air_.begin(step);
    find_areas(light);
    find_lines(light);
    // The canopy air depends on the losses of all leaves. Deviations of sampled
    // points from their lines are assumed to be the same in the corrected air.
    drawn_sums_ = {};
    draw(step, light);
    lines_->correct(
        drawn_sums_[static_cast<std::size_t>(LeafFlux::sensible)],
        drawn_sums_[static_cast<std::size_t>(LeafFlux::transpiration)]);
    add_lines(step, light);
    close_stomata(step, light);
}

void WaterFluxes::add_nights() {
    air_.meet(-1, -1);
    for (std::size_t i = 0; i < light_.beam_of.size(); ++i)
        if (light_.beam_of[i] < 0 && light_.sky_of[i] < 0) add(i, nullptr);
    complete_closed();
}

//! Returns whether a flux is summed in a step. At night these are only heat and
//! water. The assimilation of leaves at air temperature is already known.
bool WaterFluxes::takes(LeafFlux flux, const StepLight* light) const {
    if (flux == LeafFlux::uptake || flux == LeafFlux::respiration)
        return light && air_.warms();
    return light || flux == LeafFlux::transpiration ||
           flux == LeafFlux::sensible;
}

void WaterFluxes::find_areas(const StepLight* light) {
    areas_ = places_.index;
    if (!light) return;
    const PairLight::Bins& bins = light->pair.bins();
    for (std::size_t b = 0; b < bins.size(); ++b) {
        // Sunlit leaf area is the light absorbed at hits divided by the beam.
        const double beam = light->beams[b];
        const double area =
            beam > 0 ? light->scales.of_sun * bins.moments.one[b] / beam : 0;
        areas_.push_back(area);
        areas_[bins.place[b]] -= area;
    }
}

LeafAir::Point WaterFluxes::point(const StepLight* light,
                                  std::size_t area) const {
    if (!light) return {area};
    if (area < places_.count())
        return {area, light->shaded.light[area], 0, light->shaded.at(area)};
    const std::size_t b = area - places_.count();
    const PairLight::Bins& bins = light->pair.bins();
    return {bins.place[b], light->lit.light[b], bins.cosine[b],
            light->lit.at(b)};
}

//! Computes the lines of a step and the sampling probabilities of points.
void WaterFluxes::find_lines(const StepLight* light) {
    lines_->clear();
    chances_.clear();
    brightest_ = 0;
    double all = 0;
    const auto add = [&](std::size_t place, double ppfd, double cosine) {
        const std::uint32_t group = places_.group[place];
        if (lit_.leaves[group].exchanges_water()) {
            const double area = areas_[chances_.size()];
            lines_->add(group, ppfd, cosine, area);
            brightest_ = std::max(brightest_, ppfd);
            all += std::abs(area) * (ppfd + dark);
        }
        chances_.push_back(all);
    };
    for (std::size_t p = 0; p < places_.count(); ++p)
        add(p, light ? light->shaded.light[p] : 0, 0);
    absorbed_.assign(places_.count(), 0);
    gross_.assign(places_.count(), 0);
    if (light) {
        const PairLight::Bins& bins = light->pair.bins();
        for (std::size_t b = 0; b < bins.size(); ++b)
            add(bins.place[b], light->lit.light[b], bins.cosine[b]);
        for (std::size_t p = 0; p < places_.count(); ++p) {
            absorbed_[p] = places_.index[p] * light->shaded.light[p];
            gross_[p] = light->of_places[p] / amounts_.front();
            if (lit_.leaves[places_.group[p]].exchanges_water())
                lines_->add_gross(places_.group[p], gross_[p]);
        }
        for (std::size_t b = 0; b < bins.size(); ++b)
            absorbed_[bins.place[b]] +=
                light->scales.of_sun * bins.moments.one[b];
    }
    lines_->settle(light ? light->responses : std::vector<LeafResponse>{});
}

void WaterFluxes::add_lines(std::size_t step, const StepLight* light) {
    for (std::size_t k = 0; k < leaf_fluxes; ++k) {
        const auto flux = static_cast<LeafFlux>(k);
        if (flux == LeafFlux::hot || !takes(flux, light)) continue;
        // Assimilation at air temperature is already known.
        const double known = flux == LeafFlux::uptake ? 1 : 0;
        const std::vector<double>& by =
            LeafLines::is_in_gross(flux) ? gross_ : absorbed_;
        auto& [mean, steps] = fluxes_[k];
        for (std::size_t p = 0, last = 0; p < places_.count(); p = last) {
            const std::uint32_t group = places_.group[p];
            last = p + 1;
            if (!lit_.leaves[group].exchanges_water()) continue;
            const auto [constant, slope] = lines_->line(flux, group);
            double of_group = 0;
            for (last = p;
                 last < places_.count() && places_.group[last] == group;
                 ++last) {
                const double sum =
                    constant * places_.index[last] + (slope - known) * by[last];
                of_group += sum;
                mean[last] += amounts_[k] * sum;
            }
            steps[step] += of_group;
        }
    }
    if (light) add_hot(step, light);
}

//! Adds leaves that are hot according to their lines.
void WaterFluxes::add_hot(std::size_t step, const StepLight* light) {
    constexpr auto k = static_cast<std::size_t>(LeafFlux::hot);
    fluxes_[k].steps[step] = 0;
    if (!lines_->reaches_heat(brightest_)) return;
    double all = 0;
    for (std::size_t j = 0; j < areas_.size(); ++j) {
        const LeafAir::Point each = point(light, j);
        const std::uint32_t group = places_.group[each.place];
        if (!lit_.leaves[group].exchanges_water() ||
            lines_->at(LeafFlux::hot, group, each).value == 0)
            continue;
        all += areas_[j];
        fluxes_[k].mean[each.place] += amounts_[k] * areas_[j];
    }
    fluxes_[k].steps[step] = all;
}

//! Divides the leaves of each component into strata of similar light.
std::vector<LeafLines::Stratum> WaterFluxes::strata(
    const StepLight* light) const {
    // Limits of strata in shade and in the sun, relative to the brightest leaf.
    constexpr std::array limits{std::array{0.06, 0.2}, std::array{0.3, 0.6}};
    constexpr std::size_t count = limits[0].size() + 1;
    struct Part {
        LeafLines::Stratum stratum{};
        std::array<double, LeafAir::classes_per_component> area{};
    };
    std::vector<Part> parts(2 * count * air_.leaves().scene.components.size());
    for (std::size_t j = 0; j < areas_.size(); ++j) {
        const LeafAir::Point each = point(light, j);
        const std::uint32_t group = places_.group[each.place];
        if (!lit_.leaves[group].exchanges_water() || !(areas_[j] > 0)) continue;
        const std::uint32_t number = air_.class_of(group);
        const std::size_t is_sunlit = each.cosine > 0 ? 1 : 0;
        const std::size_t place = static_cast<std::size_t>(
            std::ranges::count_if(limits[is_sunlit], [&](double x) {
                return each.ppfd > x * brightest_;
            }));
        auto& [stratum, area] =
            parts[2 * count * (number / LeafAir::classes_per_component) +
                  count * is_sunlit + place];
        stratum.area += areas_[j];
        stratum.ppfd += areas_[j] * each.ppfd;
        stratum.cosine += areas_[j] * each.cosine;
        double& own = area[number % LeafAir::classes_per_component];
        own += areas_[j];
        if (own >= *std::ranges::max_element(area)) stratum.number = number;
    }
    std::vector<LeafLines::Stratum> strata;
    for (const auto& [stratum, area] : parts) {
        if (!(stratum.area > 0)) continue;
        strata.push_back(stratum);
        strata.back().ppfd /= stratum.area;
        strata.back().cosine /= stratum.area;
    }
    return strata;
}

//! Computes the changes of the step's fluxes if stomata close, in one of three
//! steps.
void WaterFluxes::close_stomata(std::size_t step, const StepLight* light) {
    if (closed_.empty() || !closes_in_[step]) return;
    const std::vector<LeafLines::Sums> all = lines_->close_stomata(
        air_.leaves().scene.water->openings, strata(light));
    for (std::size_t l = 0; l < closed_.size(); ++l)
        for (std::size_t k = 0; k < leaf_fluxes; ++k) {
            // Dew does not depend on stomata.
            constexpr double none = 1e-6;
            const double before = all.front()[k], after = all[l + 1][k];
            const auto flux = static_cast<LeafFlux>(k);
            if (!takes(flux, light)) {
                closed_[l][k][step] = changes_by_factor(flux) ? 1 : 0;
                continue;
            }
            closed_[l][k][step] = !changes_by_factor(flux) ? after - before
                                  : before > none
                                      ? std::clamp(after / before, 0., 2.)
                                      : 1;
        }
}

//! Completes the changes of other steps, by linear interpolation between days
//! at the same hour, by day or by night as they are.
void WaterFluxes::complete_closed() {
    if (closed_.empty()) return;
    const std::vector<TimeStep>& steps = light_.series.steps;
    for (const std::vector<std::size_t>& all : alike(steps)) {
        std::vector<std::size_t> known;
        for (const std::size_t i : all)
            if (closes_in_[i]) known.push_back(i);
        for (const std::size_t i : all) {
            if (closes_in_[i]) continue;
            const auto next = std::ranges::upper_bound(known, i);
            for (ClosedStomata& each : closed_)
                for (std::size_t k = 0; k < leaf_fluxes; ++k) {
                    const auto at = [&](auto place) { return each[k][*place]; };
                    each[k][i] =
                        next == known.begin() ? at(next)
                        : next == known.end()
                            ? at(next - 1)
                            : std::lerp(
                                  at(next - 1), at(next),
                                  static_cast<double>(i - *(next - 1)) /
                                      static_cast<double>(*next - *(next - 1)));
                }
        }
    }
}

//! Samples points of a step by systematic sampling along the leaves, shade
//! before sun. The starting point is random in each randomisation and advances
//! from step to step by the golden ratio, so that the samples of all steps are
//! evenly distributed.
void WaterFluxes::draw(std::size_t step, const StepLight* light) {
    constexpr double golden_ratio = 0.6180339887498949;
    const double all = chances_.empty() ? 0 : chances_.back();
    if (!(all > 0)) return;
    const double count = counts_[step];
    samples_.clear();
    batch_->clear();
    for (std::size_t r = 0; r < starts_.size(); ++r) {
        const double turns =
            starts_[r] + golden_ratio * static_cast<double>(step);
        for (double i = turns - std::floor(turns); i < count; ++i) {
            const auto found = std::upper_bound(
                chances_.begin(), chances_.end() - 1, all / count * i);
            const auto area =
                static_cast<std::size_t>(found - chances_.begin());
            const double own = *found - (area > 0 ? chances_[area - 1] : 0);
            if (!(own > 0)) continue;
            const LeafAir::Point at = point(light, area);
            samples_.push_back({r, area, all / (count * own), at});
            batch_->add(
                at, &lines_->solved(places_.group[at.place], at.cosine > 0));
        }
    }
    const std::span<const LeafExchange> solved = batch_->solve();
    for (std::size_t i = 0; i < solved.size(); ++i)
        add_drawn(step, light, samples_[i], solved[i]);
}

//! Adds the deviation of a sampled point from its lines.
void WaterFluxes::add_drawn(std::size_t step, const StepLight* light,
                            const Sample& sample, const LeafExchange& solved) {
    const auto& [randomisation, area, times, drawn] = sample;
    const std::uint32_t group = places_.group[drawn.place];
    const LeafAir::Fluxes found = air_.fluxes_of(solved, drawn);
    for (std::size_t k = 0; k < leaf_fluxes; ++k) {
        const auto flux = static_cast<LeafFlux>(k);
        if (!takes(flux, light)) continue;
        Expansion differs = found[k];
        const Expansion line = lines_->at(flux, group, drawn);
        differs.value -= line.value;
        double more = times * areas_[area] * differs.value;
        // Other fluxes are computed at the expected light.
        if (light && flux <= LeafFlux::transpiration) {
            differs.slope -= line.slope;
            differs.curvature -= line.curvature;
            more = times * amount(*light, area, differs);
        }
        drawn_sums_[k] += more / static_cast<double>(starts_.size());
        FluxTally& tally = drawn_[k][randomisation];
        tally.steps[step] += more;
        more *= amounts_[k];
        tally.groups[group] += more;
        for (const auto& [layer, share] : layers_[drawn.place])
            tally.layers[layer] += share * more;
        if (!tally.rows.empty()) tally.rows[places_.row[drawn.place]] += more;
    }
}

void WaterFluxes::add_drawn_to(FluxTallies& all) const {
    for (std::size_t k = 0; k < all.size(); ++k)
        for (std::size_t r = 0; r < all[k].size(); ++r)
            all[k][r] += drawn_[k][r];
}

//! Returns the contribution of one of areas_ to a flux, which is a function of
//! light.
double WaterFluxes::amount(const StepLight& light, std::size_t area,
                           const Expansion& at) const {
    const PairLight::Bins& bins = light.pair.bins();
    const auto of_bin = [&](std::size_t b, const Expansion& shaded,
                            const Expansion& lit) {
        return light.scales
            .weigh(gain(shaded, lit, light.beams[b]), light.scales.of_sun)
            .dot(bins.moments.at(b));
    };
    if (area >= places_.count()) return of_bin(area - places_.count(), {}, at);
    double sum = light.scales.weigh(at, 1).dot(light.pair.moments().at(area));
    const auto first = std::ranges::lower_bound(bins.place, area);
    for (auto b = static_cast<std::size_t>(first - bins.place.begin());
         b < bins.size() && bins.place[b] == area; ++b)
        sum += of_bin(b, at, {});
    return sum;
}

}  // namespace ideotype
