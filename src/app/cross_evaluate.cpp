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

//! The cases without their replicates, which have the same light.
std::vector<Case> lights(const Campaign& campaign) {
    std::vector<Case> first;
    for (Case& each : cases(campaign))
        if (each.replicate == 1) first.push_back(std::move(each));
    return first;
}

//! The name of a case without its replicate.
std::string light_name(const Case& chosen) {
    return chosen.name.substr(0, chosen.name.rfind("_r"));
}

Estimate objective(const Campaign& under, const Case& chosen, const Day& day,
                   const Device& device, const NamedPlant& plant) {
    Campaign campaign = under;
    campaign.plant = plant.form;
    campaign.baseline = to_traits(plant.genome);
    campaign.bounds.resize(campaign.baseline.size(), campaign.bounds.back());
    Task task;
    task.case_index = static_cast<std::uint32_t>(chosen.index);
    task.is_final = true;
    const CanopyReport report =
        study(campaign, chosen, day, device, plant.genome,
              draws_of(task, campaign, chosen), Detail::history);
    return to_outcome(campaign, plant.genome, report).objectives.front();
}

//! A column per case, a row per plant.
class Matrix {
  public:
    Matrix(std::vector<NamedPlant> plants, std::vector<Case> columns)
        : plants_(std::move(plants)), columns_(std::move(columns)) {}

    void fill(const Campaign& under) {
        const Device device(Device::supported_isas().back());
        for (const NamedPlant& plant : plants_) {
            show_progress();
            std::vector<Estimate>& row = rows_.emplace_back();
            for (const Case& chosen : columns_)
                row.push_back(objective(
                    under, chosen,
                    clear_day(chosen.site, chosen.day, under.par_fraction),
                    device, plant));
        }
        show_progress();
    }

    Json json(const Quantity& quantity) const {
        Json json{{"objective", quantity.name}, {"unit", quantity.unit}};
        for (const NamedPlant& plant : plants_)
            json["plants"].push_back(plant.name);
        for (const Case& chosen : columns_)
            json["cases"].push_back(light_name(chosen));
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
            fmt::print("\n{}\n", light_name(columns_[c]));
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
    std::vector<Case> columns_;
    std::vector<std::vector<Estimate>> rows_;  //!< by plant, then by case
};

}  // namespace

ExitCode cross_evaluate(const CrossOptions& options) {
    const Campaign under = read_campaign(options.under);
    std::vector<NamedPlant> plants;
    for (const std::string& path : options.plants)
        plants.push_back(named_plant(path));
    const std::vector<Case> columns = lights(under);
    const Day day =
        clear_day(columns[0].site, columns[0].day, under.par_fraction);
    const Quantity quantity = outcome_schema(under, day).objectives.front();
    Matrix matrix(std::move(plants), columns);
    matrix.fill(under);
    if (options.is_json)
        fmt::print("{}\n", to_text(matrix.json(quantity)));
    else
        matrix.print(quantity);
    return ExitCode::ok;
}

}  // namespace ideotype
