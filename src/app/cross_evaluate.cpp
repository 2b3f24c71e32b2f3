#include <cstdio>
#include <unistd.h>

#include <fmt/format.h>

#include "ideotype/app/canopy.hpp"
#include "ideotype/app/choose_row.hpp"
#include "ideotype/app/progress.hpp"
#include "ideotype/app/verbs.hpp"
#include "json.hpp"

namespace ideotype {

namespace {

//! A plant and everything about it that is not bred.
struct NamedPlant {
    std::string name;
    PlantForm form;
    Genome genome;
};

NamedPlant named_plant(const std::string& path) {
    if (!is_history(path)) {
        const KnownPlant plant = read_plant(path);
        return {plant.form.name, plant.form, to_genome(plant.traits)};
    }
    RowChoice best;
    best.is_best = true;
    const ChosenRow found = choose_row(path, best);
    return {found.campaign.name + "/" + found.chosen.name, found.campaign.plant,
            found.row.candidate.genome};
}

//! The name of a case without its replicate.
std::string light_name(const Case& chosen) {
    return chosen.name.substr(0, chosen.name.rfind("_r"));
}

//! The campaign with this plant in place of its own.
Campaign with(const NamedPlant& plant, Campaign campaign) {
    campaign.plant = plant.form;
    campaign.baseline = to_traits(plant.genome);
    campaign.bounds.resize(campaign.baseline.size(), campaign.bounds.back());
    return campaign;
}

struct Column {
    Case chosen;
    DayIllumination light;
};

//! The cases without their replicates, which have the same light.
std::vector<Column> columns(const Campaign& campaign) {
    std::vector<Column> first;
    for (const Case& each : cases(campaign))
        if (each.replicate == 1)
            first.push_back({each, light_of(campaign, each)});
    return first;
}

Estimate objective(const Campaign& campaign, const Column& column,
                   const Device& device, const Genome& genome) {
    Task task;
    task.case_index = static_cast<std::uint32_t>(column.chosen.index);
    task.is_final = true;
    const CanopyReport report =
        study(campaign, column.chosen, column.light, device, genome,
              draws_of(task, campaign, column.chosen), Detail::history);
    return to_outcome(campaign, genome, report).objectives.front();
}

//! A column per case, a row per plant.
class Matrix {
  public:
    Matrix(std::vector<NamedPlant> plants, std::vector<Column> columns)
        : plants_(std::move(plants)), columns_(std::move(columns)) {}

    void fill(const Campaign& under) {
        const Device device(Device::supported_isas().back());
        for (const NamedPlant& plant : plants_) {
            show_progress();
            std::vector<Estimate>& row = rows_.emplace_back();
            const Campaign campaign = with(plant, under);
            for (const Column& column : columns_)
                row.push_back(
                    objective(campaign, column, device, plant.genome));
        }
        show_progress();
    }

    Json json(const Quantity& quantity) const {
        Json json{{"objective", quantity.name}, {"unit", quantity.unit}};
        for (const NamedPlant& plant : plants_)
            json["plants"].push_back(plant.name);
        for (const Column& column : columns_)
            json["cases"].push_back(light_name(column.chosen));
        for (const auto& row : rows_) {
            Json means = Json::array(), errors = Json::array();
            for (const Estimate& x : row) {
                means.push_back(x.mean);
                errors.push_back(x.standard_error);
            }
            json["mean"].push_back(means);
            json["standard_error"].push_back(errors);
        }
        return json;
    }

    void print(const Quantity& quantity) const {
        fmt::print("{} [{}] of each plant in each case\n", quantity.name,
                   quantity.unit);
        for (std::size_t c = 0; c < columns_.size(); ++c) {
            fmt::print("\n{}\n", light_name(columns_[c].chosen));
            for (std::size_t p = 0; p < plants_.size(); ++p)
                fmt::print("  {:<50} {:>24}\n", plants_[p].name,
                           format(rows_[p][c]));
        }
    }

  private:
    void show_progress() const {
        if (!isatty(STDERR_FILENO)) return;
        fmt::print(stderr, "\r{} of {} plants{}", rows_.size(), plants_.size(),
                   rows_.size() == plants_.size() ? "\n" : "");
    }

    std::vector<NamedPlant> plants_;
    std::vector<Column> columns_;
    std::vector<std::vector<Estimate>> rows_;  //!< by plant, then by case
};

}  // namespace

ExitCode cross_evaluate(const CrossOptions& options) {
    const Campaign under = read_campaign(options.under);
    std::vector<NamedPlant> plants;
    for (const std::string& path : options.plants)
        plants.push_back(named_plant(path));
    std::vector<Column> lit = columns(under);
    const Quantity quantity =
        outcome_schema(under, lit[0].light.day).objectives.front();
    Matrix matrix(std::move(plants), std::move(lit));
    matrix.fill(under);
    if (options.is_json)
        fmt::print("{}\n", to_text(matrix.json(quantity)));
    else
        matrix.print(quantity);
    return ExitCode::ok;
}

}  // namespace ideotype
