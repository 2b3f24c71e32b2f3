// SPDX-License-Identifier: Apache-2.0
// front SEED... : breeds a front of absorbed light against leaf area at Ames by
// NSGA-II in two ways: parents are evaluated again in each generation, under
// the random numbers of their children, or keep their outcomes; both take as
// many evaluations. Evaluates the last front again with much light, and prints
// how many of its plants stay in it, and its hypervolume.

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

#include "run/evaluator.hpp"
#include "run/evolve_case.hpp"
#include "search/optimizer.hpp"
#include "search/order.hpp"
#include "search/summary.hpp"

namespace {

using namespace ideotype;

constexpr std::size_t all_evaluations = 2500;
const std::vector<double> reference{5, 7};  // units: MJ m-2 day-1, m2 m-2

Campaign campaign_of_seed(const std::string& seed) {
    return read_campaign(
        IDEOTYPE_CAMPAIGNS "/ames_quick.toml",
        {"seed=" + seed, "search.optimizer=nsga2", "objective.minimise=lai",
         "search.population=80", "final.candidates=80", "final.paths=4096",
         "stop.generations=100"});
}

class Search {
  public:
    Search(const Campaign& campaign, bool keeps)
        : campaign_(campaign),
          chosen_(cases(campaign).front()),
          space_(search_space(campaign, chosen_)),
          keeps_(keeps),
          evaluator_(campaign, Device::supported_isas().back()) {}

    void print(const std::string& seed) {
        const Population members = last_front();
        Population again;
        for (const Individual& each : members)
            again.push_back(evaluated(each.candidate, {0, 0, 0, 1, true}));
        const auto level = fronts(again, space_.senses);
        const auto left = std::count(level.begin(), level.end(), 0u);
        const Estimate was = hypervolume(members, reference, space_.senses);
        const Estimate is = hypervolume(again, reference, space_.senses);
        std::printf("%s  %-15s %4u %5zu %6ld  %7.3f %6.3f  %7.3f %6.3f\n",
                    seed.c_str(), keeps_ ? "kept" : "evaluated again",
                    generations_, members.size(), left, was.mean,
                    was.standard_error, is.mean, is.standard_error);
        std::fflush(stdout);
    }

  private:
    Individual evaluated(const Candidate& candidate, const Task& task) {
        const Outcome outcome = evaluator_.evaluate(task, candidate.genome);
        return {candidate, outcome.status, outcome.objectives,
                outcome.violation, outcome.randomisations};
    }

    Population last_front() {
        const auto search =
            make_genetic_algorithm(campaign_.search, space_, chosen_.seed);
        std::map<Genome, Individual> known;
        Population rows;
        std::size_t evaluations = 0;
        for (; evaluations < all_evaluations; ++generations_) {
            std::map<Genome, Individual> now;
            rows.clear();
            Task task;
            task.generation = generations_;
            for (const Candidate& each : search->ask()) {
                Individual row;
                const bool is_kept = keeps_ && known.contains(each.genome);
                if (is_kept) row = known.at(each.genome);
                if (!is_kept) row = evaluated(each, task), ++evaluations;
                row.candidate = each;
                now[each.genome] = row;
                rows.push_back(row);
            }
            known = now;
            search->tell(rows);
        }
        const auto level = fronts(rows, space_.senses);
        Population front;
        for (const std::uint32_t slot :
             best_distinct(rows, rows.size(), space_.senses))
            if (level[slot] == 0) front.push_back(rows[slot]);
        return front;
    }

    const Campaign& campaign_;
    const Case chosen_;
    const SearchSpace space_;
    const bool keeps_;
    CanopyEvaluator evaluator_;
    std::uint32_t generations_ = 0;
};

}  // namespace

int main(int count, char** words) {
    std::printf(
        "seed parents    generations front stay  hypervolume      evaluated "
        "again\n");
    for (int i = 1; i < count; ++i)
        for (const bool keeps : {false, true}) {
            const Campaign campaign = campaign_of_seed(words[i]);
            Search(campaign, keeps).print(words[i]);
        }
    return 0;
}
