// SPDX-License-Identifier: Apache-2.0
#include "season.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"

namespace ideotype {

namespace {

//! Depth of roots at emergence [m]: the smallest in FAO-56, table 22 and
//! equation 8.5.
constexpr double first_roots = 0.15;

//! Returns how far stomata close until transpiration falls to an amount.
//! @param at transpiration at closures 0, 1, ...; the last is 0
Closure closure_at(const std::vector<double>& at, double transpiration) {
    for (std::size_t i = 0; i + 1 < at.size(); ++i)
        if (at[i + 1] <= transpiration && at[i] > at[i + 1])
            return static_cast<double>(i) +
                   std::clamp((at[i] - transpiration) / (at[i] - at[i + 1]), 0.,
                              1.);
    return static_cast<double>(at.size() - 1);
}

//! Returns the part of the season's soil and grain that a stage reports: the
//! last one reports all, so that the sum over stages has their errors.
double part_of(std::size_t stage, std::size_t stages) {
    return stage + 1 == stages ? 1 : 0;
}

}  // namespace

//! The days of the season at one stage.
struct Season::StageDays {
    //! Steps of each day of the season, and the part of each day that the stage
    //! represents.
    std::vector<std::vector<std::size_t>> steps{};
    std::vector<double> share{};
    //! Whether the stage represents more of a day than any other: it reports
    //! what belongs to the day as a whole.
    std::vector<bool> owns{};
    //! Index of each day of the season among the dates of the stage; none: the
    //! stage does not represent any of it.
    std::vector<std::optional<std::size_t>> date{};
    //! Transpiration [mm] [place, day, closure], of the mean over
    //! randomisations and of each.
    std::vector<std::vector<std::vector<double>>> transpiration{};
    //! Light on the soil over that above, times the share [place, day].
    std::vector<std::vector<double>> light{};
    std::size_t dates = 0;  //!< number of dates of the stage
};

Season::Season(const Campaign& campaign, const Case& scenario)
    : campaign_(campaign), has_grain_(fills_grain(campaign)) {
    if (campaign.spec.soil) soil_ = campaign.spec.soil->soil();
    if ((soil_ || has_grain_) && !scenario.stages.empty())
        days_ = season_days(campaign, scenario);
}

std::vector<Season::StageDays> Season::days_of(
    const std::vector<LitCanopy>& stages) const {
    std::vector<StageDays> result;
    std::vector<double> seconds(days_.size());
    for (const LitCanopy& stage : stages) {
        StageDays& of_stage = result.emplace_back();
        const LightSeries& series = stage.scene().light().series;
        const std::vector<Date> dates = series.dates();
        const auto steps_of_dates = series.steps_of_dates();
        of_stage.dates = dates.size();
        for (std::size_t d = 0; d < days_.size(); ++d) {
            const auto found = std::ranges::find(dates, days_[d].date);
            double length = 0;
            if (found == dates.end()) {
                of_stage.date.emplace_back();
                of_stage.steps.emplace_back();
            } else {
                of_stage.date.emplace_back(
                    static_cast<std::size_t>(found - dates.begin()));
                of_stage.steps.push_back(steps_of_dates[*of_stage.date.back()]);
                for (const std::size_t i : of_stage.steps.back())
                    length += series.steps[i].seconds;
            }
            of_stage.share.push_back(length);
            seconds[d] += length;
        }
    }
    std::vector<std::size_t> owner(days_.size());
    for (std::size_t d = 0; d < days_.size(); ++d)
        for (std::size_t s = 0; s < stages.size(); ++s) {
            result[s].share[d] /= seconds[d];
            if (result[s].share[d] > result[owner[d]].share[d]) owner[d] = s;
        }
    for (std::size_t s = 0; s < stages.size(); ++s)
        for (std::size_t d = 0; d < days_.size(); ++d)
            result[s].owns.push_back(owner[d] == s);
    return result;
}

//! Adds the transpiration of each day at each closure of stomata, and the light
//! on the soil.
void Season::add_demand(const std::vector<LitCanopy>& stages,
                        std::vector<StageDays>& days) const {
    for (std::size_t s = 0; s < stages.size(); ++s) {
        StageDays& of_stage = days[s];
        const CanopyFluxes& fluxes = stages[s].fluxes();
        const LightSeries& series = stages[s].scene().light().series;
        const std::size_t levels = fluxes.closed.size() + 2;
        constexpr auto flux = LeafFlux::transpiration;
        const auto light = stages[s].light_on_soil();
        const std::vector<FluxTally>& tallies =
            fluxes.tallies[static_cast<std::size_t>(flux)];
        const auto count = static_cast<double>(tallies.size());
        std::vector<std::vector<double>> mean(days_.size(),
                                              std::vector<double>(levels));
        std::vector<double> mean_light(days_.size());
        of_stage.transpiration.assign(1, {});
        of_stage.light.assign(1, {});
        for (std::size_t r = 0; r < tallies.size(); ++r) {
            auto& of_days = of_stage.transpiration.emplace_back();
            auto& light_of_days = of_stage.light.emplace_back();
            for (std::size_t d = 0; d < days_.size(); ++d) {
                std::vector<double>& at = of_days.emplace_back(levels);
                for (const std::size_t i : of_stage.steps[d]) {
                    const double open =
                        amount_of(flux, series.steps[i]) * tallies[r].steps[i];
                    for (std::size_t l = 0; l < levels; ++l)
                        at[l] += open * change_of(fluxes.closed, flux, i,
                                                  static_cast<double>(l));
                }
                for (std::size_t l = 0; l < levels; ++l)
                    mean[d][l] += at[l] / count;
                light_of_days.push_back(of_stage.date[d]
                                            ? of_stage.share[d] *
                                                  light[r][*of_stage.date[d]]
                                            : 0);
                mean_light[d] += light_of_days.back() / count;
            }
        }
        of_stage.transpiration.front() = std::move(mean);
        of_stage.light.front() = std::move(mean_light);
    }
}

//! Returns the irrigation of a morning [mm].
//! @param by_depletion irrigation by depletion so far in the season [mm]; the
//! morning's is added
double Season::irrigate(const SeasonState& state, double& by_depletion) const {
    if (!campaign_.spec.irrigation) return 0;
    const IrrigationSpec& plan = *campaign_.spec.irrigation;
    double sum = 0;
    for (std::size_t i = 0; i < plan.dates.size(); ++i)
        if (plan.dates[i] == state.day.date)
            sum += plan.amounts.size() == 1 ? plan.amounts[0] : plan.amounts[i];
    const double missing =
        state.water.depletion -
        (state.day.rain - runoff(soil_->curve_number, state.day.rain)) - sum;
    if (plan.depletion < 1 && missing > plan.depletion * state.available) {
        double more = plan.amount > 0 ? plan.amount : missing;
        if (plan.limit > 0)
            more = std::clamp(plan.limit - by_depletion, 0., more);
        by_depletion += more;
        sum += more;
    }
    return sum;
}

std::vector<SeasonState> Season::run(const std::vector<StageDays>& stages,
                                     std::size_t place,
                                     const ControlDay& control) const {
    const SoilSpec& spec = *campaign_.spec.soil;
    const std::size_t levels =
        stages.front().transpiration.front().front().size();
    std::vector<SeasonState> states;
    SoilWater water;
    double by_depletion = 0;
    for (std::size_t d = 0; d < days_.size(); ++d) {
        // The demand for water of all stages that represent the day.
        std::vector<double> at(levels);
        double light = 0;
        for (const StageDays& stage : stages) {
            for (std::size_t l = 0; l < levels; ++l)
                at[l] += stage.transpiration[place][d][l];
            light += stage.light[place][d];
        }
        SeasonState state{days_[d]};
        state.root_depth =
            std::min(spec.root_depth,
                     first_roots + spec.root_rate * days_[d].thermal_time);
        state.potential_transpiration = std::max(at.front(), 0.);
        state.potential_evaporation =
            bare_soil_coefficient * light * days_[d].reference;
        state.available = soil_->available(state.root_depth);
        state.water = water;
        state.soil_water = state.available - water.depletion;
        const double before = by_depletion;
        state.irrigation = irrigate(state, by_depletion);
        const DayControl wanted = control ? control(state) : DayControl{};
        if (wanted.irrigation) {
            state.irrigation = *wanted.irrigation;
            by_depletion = before;
        }
        // The balance of the day.
        Soil soil = *soil_;
        SoilDay day{state.potential_transpiration, state.potential_evaporation,
                    days_[d].rain, state.irrigation, state.root_depth};
        if (wanted.stress) {
            // The demand that another soil supplies meets no further stress.
            day.potential_transpiration *= *wanted.stress;
            soil.depletion_fraction = 1;
        }
        state.fluxes = pass_day(soil, day, water);
        state.water = water;
        state.soil_water = state.available - water.depletion;
        // Stomata close until leaves transpire what the soil supplies.
        if (state.fluxes.transpiration < state.potential_transpiration)
            state.closure = closure_at(at, state.fluxes.transpiration);
        states.push_back(state);
    }
    return states;
}

std::vector<SeasonState> Season::run(const std::vector<LitCanopy>& stages,
                                     const ControlDay& control) const {
    std::vector<StageDays> days = days_of(stages);
    add_demand(stages, days);
    return run(days, 0, control);
}

Season::Soils Season::dry(std::vector<LitCanopy>& stages) const {
    Soils soils;
    if (!soil_) return soils;
    std::vector<StageDays> days = days_of(stages);
    add_demand(stages, days);
    soils.mean = run(days, 0, {});
    for (std::size_t r = 1; r < days.front().transpiration.size(); ++r)
        soils.by_randomisation.push_back(run(days, r, {}));
    // Stages without stress keep every bit of their fluxes.
    for (std::size_t s = 0; s < stages.size(); ++s) {
        std::vector<Closure> closures(
            stages[s].scene().light().series.steps.size());
        for (std::size_t d = 0; d < days_.size(); ++d)
            for (const std::size_t i : days[s].steps[d])
                closures[i] = soils.mean[d].closure;
        if (std::ranges::any_of(closures, [](Closure x) { return x > 0; }))
            stages[s].close_stomata(closures);
    }
    return soils;
}

void Season::add_to(const Soils& soils, const std::vector<LitCanopy>& stages,
                    std::vector<CanopyReport>& reports) const {
    const std::vector<StageDays> days = days_of(stages);
    if (soil_) add_water(soils, days, reports);
    if (!has_grain_) return;
    if (campaign_.spec.prices)
        for (std::size_t s = 0; s < stages.size(); ++s) {
            const double share = part_of(s, stages.size());
            reports[s].season_prices = {
                *campaign_.spec.prices, static_cast<double>(days_.size()),
                share / reports[s].components.front().ground_per_plant, share};
        }
    const Plant& plant = *stages.back().scene().components.front().full_grown;
    add_grain(days, list_organs(plant).front().mass, reports);
}

void Season::add_water(const Soils& soils, const std::vector<StageDays>& stages,
                       std::vector<CanopyReport>& reports) const {
    const auto count = static_cast<double>(days_.size());
    const auto randomisations =
        static_cast<double>(soils.by_randomisation.size());
    // A number of each randomisation: that of the mean run, times the number of
    // the randomisation over the mean of all.
    const auto spread = [&](const auto& number) {
        ByRandomisation values = mapped(soils.by_randomisation, number);
        const double mean =
            std::reduce(values.begin(), values.end()) / randomisations;
        const double own = number(soils.mean);
        for (double& x : values) x = mean > 0 ? x * own / mean : own;
        return values;
    };
    for (std::size_t s = 0; s < stages.size(); ++s) {
        const StageDays& stage = stages[s];
        SeasonWater& result = reports[s].season_water.emplace();
        const double share = part_of(s, stages.size());
        const auto sum = [&](const auto& of_day) {
            return spread([&](const std::vector<SeasonState>& states) {
                double all = 0;
                for (std::size_t d = 0; d < days_.size(); ++d)
                    all += of_day(states[d]);
                return share * all;
            });
        };
        using State = SeasonState;
        const auto soil_water = [](const State& x) { return x.soil_water; };
        const auto evaporation = [](const State& x) {
            return x.fluxes.evaporation;
        };
        result.evaporation = sum(evaporation);
        result.drainage = sum([](const State& x) { return x.fluxes.drainage; });
        result.runoff = sum([](const State& x) { return x.fluxes.runoff; });
        result.irrigation = sum([](const State& x) { return x.irrigation; });
        result.rain = sum([](const State& x) { return x.day.rain; });
        result.soil_water =
            sum([&](const State& x) { return x.soil_water / count; });
        // The share that plants transpire is at least 0 in each randomisation,
        // so that stress is at most 1.
        result.stress = spread([&](const std::vector<SeasonState>& states) {
            double transpired = 0, potential = 0;
            for (const State& x : states) {
                transpired += x.fluxes.transpiration;
                potential += x.potential_transpiration;
            }
            return potential > 0 ? transpired / potential : 1;
        });
        for (double& x : result.stress) x = share * (1 - x);
        const std::size_t all = soils.by_randomisation.size();
        result.evaporation_of_dates.assign(all,
                                           std::vector<double>(stage.dates));
        result.soil_water_of_dates = result.evaporation_of_dates;
        const auto by_date = [&](const auto& of_day, ByDate& into) {
            for (std::size_t d = 0; d < days_.size(); ++d) {
                if (!stage.owns[d]) continue;
                const ByRandomisation values =
                    spread([&](const std::vector<SeasonState>& states) {
                        return of_day(states[d]);
                    });
                for (std::size_t r = 0; r < all; ++r)
                    into[r][*stage.date[d]] = values[r];
            }
        };
        by_date(evaporation, result.evaporation_of_dates);
        by_date(soil_water, result.soil_water_of_dates);
    }
}

namespace {

//! The grain of a season.
struct Harvest {
    double kernels = 0;                  //!< [m-2]
    std::vector<double> grain, shoot{};  //!< in the evening of each day [g m-2]
};

//! Returns the growth of a plant in the period that sets kernels [g d-1].
//! @param silks index of the day of silking
double growth_around_silking(const Grain& grain, double silking,
                             const std::vector<SeasonDay>& days,
                             std::size_t silks,
                             const std::vector<double>& growth, double plants) {
    double sum = 0;
    int length = 0;
    for (std::size_t d = 0; d < days.size(); ++d) {
        const bool sets = grain.rule == KernelRule::andrade
                              ? d + days_around_silking >= silks &&
                                    d < silks + days_around_silking
                              : d >= silks && days[d].thermal_time <=
                                                  silking + filling_begins;
        if (!sets) continue;
        sum += growth[d];
        ++length;
    }
    return length > 0 ? sum / length / plants : 0;
}

//! Fills the grain of a season.
//! @param growth dry matter that plants produce on each day [g m-2]
//! @param plants plants per ground area [m-2]
//! @param stalk dry mass of the stalks at silking [g m-2]
//! @param roots dry mass of roots at silking [g m-2]
Harvest harvest(const Grain& grain, const Growth& growing,
                const std::vector<SeasonDay>& days,
                const std::vector<double>& growth, double plants, double stalk,
                double roots) {
    const double silking = silking_time(growing);
    std::size_t silks = 0;
    double before = 0;  // growth before silking
    for (; silks < days.size() && days[silks].thermal_time < silking; ++silks)
        before += growth[silks];
    Harvest result;
    if (silks < days.size())
        result.kernels =
            plants * kernels_per_plant(
                         grain, growth_around_silking(grain, silking, days,
                                                      silks, growth, plants));
    // Kernels fill after silking. Roots grow before it.
    const double of_shoot = before > 0 ? 1 - std::min(roots / before, 1.) : 1;
    constexpr double grams = 1e-3;  // from mg
    Filling filling{0, grain.reserves * stalk};
    double shoot = 0;
    for (std::size_t d = 0; d < days.size(); ++d) {
        const double time = days[d].thermal_time;
        if (d < silks) {
            shoot += growth[d] * of_shoot;
        } else {
            const bool fills =
                time >= silking + filling_begins &&
                time <= silking + filling_ends * growing.maturity;
            const double gain =
                growth[d] - days[d].ear_maintenance * filling.grain;
            fill(fills ? grams * grain.rate * days[d].filling * result.kernels
                       : 0,
                 gain, filling);
            shoot += gain;
        }
        result.grain.push_back(filling.grain);
        result.shoot.push_back(shoot - filling.surplus);
    }
    return result;
}

}  // namespace

//! @param stalk dry mass of the stalk of a plant [kg]
void Season::add_grain(const std::vector<StageDays>& stages, double stalk,
                       std::vector<CanopyReport>& reports) const {
    constexpr double grams = 1e3;  // from kg
    const Growth& growing = *campaign_.crop.growth;
    double roots = 0;
    for (const CanopyReport& report : reports)
        for (const double mass : report.assimilation->dry_mass)
            roots += grams * growing.root_share * mass;
    const double plants =
        1 / reports.front().components.front().ground_per_plant;
    const std::size_t count = reports.front().randomisations();
    std::vector<Harvest> harvests;
    for (std::size_t r = 0; r < count; ++r) {
        std::vector<double> growth(days_.size());
        for (std::size_t s = 0; s < stages.size(); ++s)
            for (std::size_t d = 0; d < days_.size(); ++d)
                if (stages[s].date[d])
                    growth[d] +=
                        grams * dry_matter_per_carbon *
                        reports[s]
                            .assimilation->net_of_dates[r][*stages[s].date[d]];
        harvests.push_back(harvest(*campaign_.crop.grain, growing, days_,
                                   growth, plants, grams * stalk * plants,
                                   roots));
    }
    for (std::size_t s = 0; s < stages.size(); ++s) {
        const StageDays& stage = stages[s];
        const double share = part_of(s, stages.size());
        SeasonGrain& result = reports[s].season_grain.emplace();
        for (const Harvest& one : harvests) {
            const double mass = one.grain.back(), shoot = one.shoot.back();
            result.kernels.push_back(share * one.kernels);
            result.mass.push_back(share * mass / grams);
            result.harvest_index.push_back(shoot > 0 ? share * mass / shoot
                                                     : 0);
            const auto of_dates = [&](const std::vector<double>& values) {
                std::vector<double> by_date(stage.dates);
                for (std::size_t d = 0; d < days_.size(); ++d)
                    if (stage.owns[d])
                        by_date[*stage.date[d]] = values[d] / grams;
                return by_date;
            };
            result.mass_of_dates.push_back(of_dates(one.grain));
            result.shoot_of_dates.push_back(of_dates(one.shoot));
        }
    }
}

}  // namespace ideotype
