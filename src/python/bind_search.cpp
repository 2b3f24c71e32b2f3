// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <ranges>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bindings.hpp"
#include "ideotype/core/error.hpp"
#include "search/optimizer.hpp"
#include "search/stop_rules.hpp"

namespace ideotype::python {

namespace {

using Matrix = std::vector<std::vector<double>>;

//! A search with functions ask and tell: the caller evaluates one generation of
//! rows at a time.
class Search {
  public:
    Search(const SearchSettings& settings, const SearchSpace& space,
           std::uint64_t seed)
        : optimizer_(make_optimizer(settings, space, seed)) {}

    const std::vector<Genome>& ask() {
        const std::size_t size = optimizer_->size(generation_);
        while (asked_.size() < size) {
            const auto slot = static_cast<std::uint32_t>(asked_.size());
            candidates_.push_back(optimizer_->propose(generation_, slot));
            asked_.push_back(candidates_.back().genome);
        }
        return asked_;
    }

    //! @param objectives values [row, objective]; NaN marks failed rows
    //! @param violations constraint violation of each row
    //! @param features values [row, axis] for the axes of an atlas
    void tell(const Matrix& objectives, const std::vector<double>& violations,
              const Matrix& features) {
        ask();
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            Individual row{candidates_[i], Status::done, {}, violations[i]};
            for (const double x : objectives[i]) {
                if (!std::isfinite(x)) row.status = Status::failed;
                row.objectives.push_back({x, 0});
            }
            if (!features.empty()) row.features = features[i];
            optimizer_->learn(std::move(row));
        }
        asked_.clear();
        candidates_.clear();
        ++generation_;
    }

    std::vector<Genome> best(std::size_t count) const {
        std::vector<Genome> genomes;
        for (Candidate& each : optimizer_->best(count))
            genomes.push_back(std::move(each.genome));
        return genomes;
    }

  private:
    std::unique_ptr<Optimizer> optimizer_;
    std::uint32_t generation_ = 0;
    std::vector<Genome> asked_;
    std::vector<Candidate> candidates_;
};

template <class Enum>
Enum find_named(const std::string& what, const std::string& name) {
    if (const auto value = value_named<Enum>(name)) return *value;
    std::vector<std::string> names;
    for (const auto& each : enum_names<Enum>) names.emplace_back(each.name);
    throw Error(fmt::format("there is no {} \"{}\"; use one of {}", what, name,
                            fmt::join(names, ", ")));
}

std::unique_ptr<Search> make_search(
    const std::string& optimizer, int population, std::uint64_t seed,
    const Genome& start, const std::vector<double>& lower,
    const std::vector<double>& upper, const std::vector<bool>& circular,
    const std::vector<std::string>& traits,
    const std::vector<std::string>& kinds, const std::vector<bool>& maximise,
    const std::vector<std::tuple<double, double, int>>& axes) {
    SearchSettings settings;
    settings.optimizer = find_named<OptimizerKind>("optimizer", optimizer);
    settings.population =
        population > 0 ? population
                       : usual_population(settings.optimizer, start.size());
    for (const auto& [from, to, cells] : axes)
        settings.axes.push_back({"", {from, to}, cells});
    SearchSpace space{{}, start, {}};
    for (std::size_t i = 0; i < start.size(); ++i)
        space.genes.push_back(
            {"", "", lower[i], upper[i], circular[i], true, traits[i], 0,
             find_named<GeneKind>("kind of genes", kinds[i])});
    for (const bool each : maximise)
        space.senses.push_back(each ? Sense::maximise : Sense::minimise);
    return std::make_unique<Search>(settings, space, seed);
}

//! Returns GainLeft::most of generations, if it is known.
std::optional<double> most_gain_left(
    const std::vector<std::uint32_t>& evaluations,
    const std::vector<double>& means, bool maximise) {
    std::vector<GenerationSummary> generations(evaluations.size());
    for (std::size_t g = 0; g < generations.size(); ++g) {
        generations[g].evaluations = evaluations[g];
        generations[g].mean = means.at(g);
    }
    const auto found =
        gain_left(generations, 0, maximise ? Sense::maximise : Sense::minimise);
    return found ? std::optional(found->most) : std::nullopt;
}

}  // namespace

void bind_search(nb::module_& module) {
    nb::class_<Search>(module, "Search")
        .def("ask", &Search::ask)
        .def("tell", &Search::tell)
        .def("best", &Search::best);
    module.def("make_search", &make_search);
    module.def("most_gain_left", &most_gain_left);
}

}  // namespace ideotype::python
