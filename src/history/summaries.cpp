#include "summaries.hpp"

#include <limits>

#include "layout.hpp"
#include "types.hpp"

namespace ideotype {

namespace {

const std::string group_name = "generations";

}  // namespace

void Summaries::create(hid_t file, const HistoryHeader& header) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const auto rows = static_cast<hsize_t>(header.generations);
    const std::string fitness_unit = header.schema.objectives[0].unit;
    const Handle group = create_group(file, group_name);
    const auto add = [&](const std::string& name, hid_t type,
                         const std::string& unit, const void* empty) {
        const Handle dataset = create_dataset(group, {.name = name,
                                                      .type = type,
                                                      .sizes = {rows},
                                                      .unit = unit,
                                                      .empty = empty});
        label_dimension(dataset, 0, "generation");
    };
    add("committed", bool_type(), "1", nullptr);
    add("best_slot", H5T_STD_U32LE, "1", nullptr);
    add("best", H5T_IEEE_F64LE, fitness_unit, &nan);
    add("best_standard_error", H5T_IEEE_F64LE, fitness_unit, &nan);
    add("mean", H5T_IEEE_F64LE, fitness_unit, &nan);
    add("spread", H5T_IEEE_F64LE, fitness_unit, &nan);
    add("diversity", H5T_IEEE_F64LE, "1", &nan);
    add("failures", H5T_STD_U32LE, "1", nullptr);
    add("evaluations", H5T_STD_U32LE, "1", nullptr);
    add("wall_time", H5T_IEEE_F64LE, "s", &nan);
}

Summaries::Summaries(hid_t file)
    : committed_(file, group_name + "/committed"),
      best_slot_(file, group_name + "/best_slot"),
      best_(file, group_name + "/best"),
      best_error_(file, group_name + "/best_standard_error"),
      mean_(file, group_name + "/mean"),
      spread_(file, group_name + "/spread"),
      diversity_(file, group_name + "/diversity"),
      failures_(file, group_name + "/failures"),
      evaluations_(file, group_name + "/evaluations"),
      wall_time_(file, group_name + "/wall_time") {}

std::uint32_t Summaries::committed() const {
    const auto flags = committed_.read<std::int8_t>(0, committed_.rows());
    std::uint32_t count = 0;
    while (count < flags.size() && flags[count] != 0) ++count;
    return count;
}

std::vector<GenerationSummary> Summaries::read() const {
    const std::uint32_t count = committed();
    const auto best_slot = best_slot_.read<std::uint32_t>(0, count);
    const auto best = best_.read<double>(0, count);
    const auto best_error = best_error_.read<double>(0, count);
    const auto mean = mean_.read<double>(0, count);
    const auto spread = spread_.read<double>(0, count);
    const auto diversity = diversity_.read<double>(0, count);
    const auto failures = failures_.read<std::uint32_t>(0, count);
    const auto evaluations = evaluations_.read<std::uint32_t>(0, count);
    const auto wall_time = wall_time_.read<double>(0, count);
    std::vector<GenerationSummary> summaries;
    for (std::size_t g = 0; g < count; ++g)
        summaries.push_back({.best_slot = best_slot[g],
                             .best = best[g],
                             .best_standard_error = best_error[g],
                             .mean = mean[g],
                             .spread = spread[g],
                             .diversity = diversity[g],
                             .failures = failures[g],
                             .evaluations = evaluations[g],
                             .wall_time = wall_time[g]});
    return summaries;
}

void Summaries::write(std::uint32_t generation,
                      const GenerationSummary& summary) {
    best_slot_.write_one(generation, summary.best_slot);
    best_.write_one(generation, summary.best);
    best_error_.write_one(generation, summary.best_standard_error);
    mean_.write_one(generation, summary.mean);
    spread_.write_one(generation, summary.spread);
    diversity_.write_one(generation, summary.diversity);
    failures_.write_one(generation, summary.failures);
    evaluations_.write_one(generation, summary.evaluations);
    wall_time_.write_one(generation, summary.wall_time);
}

void Summaries::set_committed(std::uint32_t generation) {
    committed_.write_one(generation, std::int8_t{1});
}

}  // namespace ideotype
