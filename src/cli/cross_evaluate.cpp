// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <list>
#include <optional>

#include <fmt/format.h>

#include "ideotype/canopy/quantities.hpp"
#include "ideotype/cli/choose_row.hpp"
#include "ideotype/cli/ranks.hpp"
#include "ideotype/cli/verbs.hpp"
#include "ideotype/core/routine.hpp"
#include "ideotype/parallel/dispatcher.hpp"
#include "ideotype/run/progress.hpp"
#include "ideotype/stand/stand.hpp"
#include "json.hpp"

namespace ideotype {

namespace {

struct NamedPlant {
    std::string name;
    Plant plant;
};

NamedPlant named_plant(const std::string& path) {
    if (!is_history(path)) {
        const Plant plant = read_plant(path);
        return {plant.name, plant};
    }
    RowChoice best;
    best.is_best = true;
    const ChosenRow found = choose_row(path, best);
    return {found.campaign.name + "/" + found.chosen.name,
            grow(found.campaign.crop, found.row.candidate.genome)};
}

//! The name of a case without its replicate.
std::string light_name(const Case& chosen) {
    return chosen.name.substr(0, chosen.name.rfind("_r"));
}

struct Column {
    Case chosen;
    Scenario scenario;
};

//! The cases, or their scenarios, without their replicates, which have the same
//! light.
std::vector<Column> columns(const Campaign& campaign) {
    std::vector<Column> first;
    for (const Case& each : cases(campaign))
        if (each.replicate == 1)
            for (const Case& scenario : scenarios(each))
                first.push_back({scenario, scenario_of(campaign, scenario)});
    return first;
}

//! What is to be evaluated; the same on all ranks.
struct Cross {
    Campaign under;
    std::vector<NamedPlant> plants;
    std::vector<Column> columns;
    OutcomeSchema schema;  //!< of quantities only single numbers

    std::size_t size() const { return plants.size() * columns.size(); }
};

Cross read(const CrossOptions& options) {
    Cross cross{read_campaign(options.under, options.settings), {}, {}, {}};
    for (const std::string& path : options.plants)
        cross.plants.push_back(named_plant(path));
    cross.columns = columns(cross.under);
    cross.schema = outcome_schema(cross.under, cross.columns[0].chosen,
                                  cross.under.final_rule.sampling);
    cross.schema.measured.axes.clear();
    std::erase_if(cross.schema.measured.quantities,
                  [](const Quantity& each) { return !each.axes.empty(); });
    return cross;
}

//! A task's generation is the column, its slot the plant.
class CrossEvaluator : public Evaluator {
  public:
    CrossEvaluator(const Cross& cross, const std::string& isa)
        : cross_(cross), device_(isa) {}

    const OutcomeSchema& schema(const Task&) const override {
        return cross_.schema;
    }

    //! All ranks have the plants: no genome is needed.
    Outcome evaluate(const Task& task, const Genome&) override {
        const Column& column = cross_.columns.at(task.generation);
        Task shared;  // all plants of a case share their random numbers
        shared.case_index = task.case_index;
        shared.is_final = true;
        const Plant& plant = cross_.plants.at(task.slot).plant;
        const CanopyReport report = ideotype::evaluate(
            request_of(sampling_of(shared, cross_.under, column.chosen),
                       cross_.under, column.scenario, plant),
            device_);
        Outcome outcome = to_outcome(cross_.under, plant, report);
        outcome.quantities.clear();
        for (const Measured& each : measure_numbers(report))
            outcome.quantities.push_back(each.estimate);
        return outcome;
    }

  private:
    const Cross& cross_;
    Device device_;
};

//! A column per case, a row per plant.
class Matrix : public Director {
  public:
    explicit Matrix(const Cross& cross)
        : cross_(cross),
          rows_(cross.plants.size(),
                std::vector<Outcome>(cross.columns.size())) {}

    //! @throws Error if one cannot be evaluated, or a stop is requested.
    void fill(Dispatcher& dispatcher) {
        dispatcher_ = &dispatcher;
        dispatcher.run(*this);
        for (auto& each : running_) each.result();
        if (done_ < cross_.size())
            throw Error(fmt::format("stopped; {} of {} evaluations were done",
                                    done_, cross_.size()));
    }

    bool start_next() override {
        if (running_.size() == cross_.columns.size()) return false;
        running_.push_back(fill_column(running_.size()));
        running_.back().start();
        return true;
    }
    void on_silence(const Task&, const std::string& what) override {
        fmt::print(stderr, "{}\n", what);
    }
    void on_stop(int) override {}

    Json json() const {
        const Objective& objective = cross_.schema.objectives.front();
        Json json{{"objective", objective.name}, {"unit", objective.unit}};
        for (const NamedPlant& plant : cross_.plants)
            json["plants"].push_back(plant.name);
        for (const Column& column : cross_.columns)
            json["cases"].push_back(light_name(column.chosen));
        add_matrix(json, [](const Outcome& outcome) {
            return outcome.objectives.front();
        });
        for (const auto& row : rows_) {
            Json randomisations = Json::array();
            for (const Outcome& outcome : row)
                randomisations.push_back(outcome.randomisations);
            // Common to all plants of a case: differences are paired.
            json["by_randomisation"].push_back(randomisations);
        }
        const auto& quantities = cross_.schema.measured.quantities;
        for (std::size_t q = 0; q < quantities.size(); ++q) {
            Json& one = json["quantities"][quantities[q].name];
            one["unit"] = quantities[q].unit;
            add_matrix(one, [q](const Outcome& outcome) {
                return outcome.quantities[q];
            });
        }
        return json;
    }

    void print() const {
        const auto& [under, plants, columns, schema] = cross_;
        fmt::print("{} [{}] of each plant in each case\n",
                   schema.objectives.front().name,
                   schema.objectives.front().unit);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            fmt::print("\n{}\n", light_name(columns[c].chosen));
            for (std::size_t p = 0; p < plants.size(); ++p)
                fmt::print("  {:<50} {:>24}\n", plants[p].name,
                           format(rows_[p][c].objectives.front()));
        }
    }

  private:
    //! Of a figure, a row per plant.
    void add_matrix(Json& json, const auto& figure) const {
        for (const auto& row : rows_) {
            Json means = Json::array(), errors = Json::array();
            for (const Outcome& outcome : row) {
                means.push_back(figure(outcome).mean);
                errors.push_back(figure(outcome).standard_error);
            }
            json["mean"].push_back(means);
            json["standard_error"].push_back(errors);
        }
    }

    Routine<bool> fill_column(std::size_t c) {
        std::vector<Work> work;
        for (std::size_t p = 0; p < cross_.plants.size(); ++p) {
            Task task;
            task.case_index =
                static_cast<std::uint32_t>(cross_.columns[c].chosen.index);
            task.generation = static_cast<std::uint32_t>(c);
            task.slot = static_cast<std::uint32_t>(p);
            task.is_final = true;
            work.push_back({task, {}});
        }
        co_await dispatcher_->evaluate(
            std::move(work), [this](const Work& done, const Outcome& outcome) {
                record(done.task, outcome);
            });
        co_return true;
    }

    void record(const Task& task, const Outcome& outcome) {
        if (outcome.status != Status::done)
            throw Error(
                fmt::format("{} in {}: {}", cross_.plants[task.slot].name,
                            light_name(cross_.columns[task.generation].chosen),
                            outcome.message));
        rows_[task.slot][task.generation] = outcome;
        live_.show(fmt::format("{} of {} evaluated", ++done_, cross_.size()));
    }

    const Cross& cross_;
    std::vector<std::vector<Outcome>> rows_;  //!< by plant, then by case
    std::size_t done_ = 0;
    LiveLine live_;
    Dispatcher* dispatcher_ = nullptr;  //!< while filling
    std::list<Routine<bool>> running_;
};

void fill_and_tell(const Cross& cross, std::unique_ptr<Dispatcher> dispatcher,
                   bool is_json) {
    Matrix matrix(cross);
    matrix.fill(*dispatcher);
    if (is_json)
        fmt::print("{}\n", to_text(matrix.json()));
    else
        matrix.print();
}

//! What this rank reads, if all could read theirs.
//! @throws Error of what could not be read, on rank 0 if it could not.
std::optional<Cross> read_on_all(const Session& session,
                                 const CrossOptions& options) {
    std::optional<Cross> cross;
    std::exception_ptr failure;
    try {
        cross = read(options);
        if (cross->size() == 1)
            throw Error(
                fmt::format("evaluate: one plant in one case is one "
                            "evaluation, which {} ranks cannot share; start "
                            "it without mpirun or srun",
                            session.size()),
                ExitCode::usage);
    } catch (...) {
        failure = std::current_exception();
    }
    const bool has_any_failed = session.largest(failure ? 1 : 0) != 0;
    const bool has_first_failed =
        !session.broadcast(failure ? "failed" : "").empty();
    if (failure && (session.rank() == 0 || !has_first_failed))
        std::rethrow_exception(failure);
    if (has_any_failed) return std::nullopt;
    return cross;
}

//! Collective over all ranks, which share plants and cases.
void share(const CrossOptions& options, const Session& session,
           StopFlag& stop) {
    const auto cross = read_on_all(session, options);
    if (!cross) return;
    CrossEvaluator evaluator(
        *cross, session.broadcast(Device::supported_isas().back()));
    if (session.rank() != 0) return serve(session, evaluator);
    const Campaign& under = cross->under;
    fill_and_tell(
        *cross,
        make_dispatcher(session, evaluator, stop,
                        {under.answer_limits.deadline,
                         under.answer_limits.attempts, final_effort(under)}),
        options.is_json);
}

}  // namespace

ExitCode cross_evaluate(const CrossOptions& options) {
    StopFlag stop;
    if (launch_of_this_process().size > 1) {
        const Session session;
        share(options, session, stop);
        return ExitCode::ok;
    }
    const Cross cross = read(options);
    CrossEvaluator evaluator(cross, Device::supported_isas().back());
    fill_and_tell(cross, make_dispatcher(evaluator, stop), options.is_json);
    return ExitCode::ok;
}

}  // namespace ideotype
