// SPDX-License-Identifier: Apache-2.0
#include "start_plant.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "history/history.hpp"
#include "summary.hpp"

namespace ideotype {

namespace {

Genome best_of_history(const GeneSpace& genes, Genome start,
                       const std::string& path) {
    const History history = History::read(path);
    const HistoryHeader& header = history.header();
    const std::vector<Row> finalists = history.finalists();
    const std::size_t best =
        best_finalist(finalists, header.schema.objectives.front().sense);
    if (best == 0)
        throw Error(path +
                    ": has no plant that was evaluated again; let its "
                    "run end, or begin with a plant file");
    const Genome& found = finalists[best].candidate.genome;
    for (std::size_t i = 0; i < genes.size(); ++i)
        for (std::size_t j = 0; j < header.genes.size(); ++j)
            if (header.genes[j].name == genes[i].name) start[i] = found[j];
    return start;
}

}  // namespace

std::string start_setting(const Campaign& campaign, const std::string& path) {
    Genome start = baseline_numbers(campaign.crop);
    if (std::filesystem::path(path).extension() == ".h5") {
        const GeneSpace genes = gene_space(campaign, cases(campaign).front());
        start = best_of_history(genes, std::move(start), path);
    } else {
        Crop crop = campaign.crop;
        crop.baseline = read_plant(path);
        if (crop.baseline.leaves.size() != campaign.crop.baseline.leaves.size())
            throw Error(fmt::format(
                "{}: has {} leaves (the campaign's baseline has {}); begin "
                "with another plant",
                path, crop.baseline.leaves.size(),
                campaign.crop.baseline.leaves.size()));
        start = baseline_numbers(crop);
    }
    return fmt::format("search.start=[{}]", fmt::join(start, ", "));
}

}  // namespace ideotype
