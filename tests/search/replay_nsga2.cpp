// SPDX-License-Identifier: Apache-2.0
// `sort`: reads the numbers of points and objectives, and the points, which are
// minimised; prints the front of each point and its crowding distance in it.
// `volume`: reads the same; prints the hypervolume relative to the last point.
// `search PROBLEM POPULATION GENERATIONS SEED`: prints the objectives of the
// first front that NSGA-II finds on zdt1, zdt2 or dtlz2 (three objectives).

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numbers>
#include <string>

#include "search/optimizer.hpp"
#include "search/order.hpp"
#include "search/summary.hpp"

namespace {

using namespace ideotype;

Individual make_individual(Candidate candidate,
                           const std::vector<double>& values) {
    Individual result{std::move(candidate), Status::done, {}, 0};
    for (const double x : values) result.objectives.push_back({x, 0});
    return result;
}

std::vector<Sense> make_senses(std::size_t count) {
    return std::vector<Sense>(count, Sense::minimise);
}

std::vector<std::vector<double>> read_points() {
    std::size_t count = 0, objectives = 0;
    std::cin >> count >> objectives;
    std::vector points(count, std::vector<double>(objectives));
    for (std::vector<double>& point : points)
        for (double& x : point) std::cin >> x;
    return points;
}

int volume() {
    std::vector<std::vector<double>> points = read_points();
    const std::vector<double> reference = points.back();
    points.pop_back();
    std::printf("%.17g\n",
                hypervolume(points, reference, make_senses(reference.size())));
    return std::cin ? 0 : 1;
}

int sort() {
    const std::vector<std::vector<double>> points = read_points();
    const std::size_t count = points.size();
    const std::size_t objectives = points.front().size();
    Population population;
    for (const std::vector<double>& values : points)
        population.push_back(make_individual({}, values));
    const auto front = fronts(population, make_senses(objectives));
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<std::size_t> members;
        std::size_t position = 0;
        for (std::size_t j = 0; j < count; ++j) {
            if (front[j] != front[i]) continue;
            if (j == i) position = members.size();
            members.push_back(j);
        }
        std::printf("%zu %.17g\n", front[i],
                    crowding(population, members, objectives)[position]);
    }
    return std::cin ? 0 : 1;
}

std::vector<double> values(const std::string& problem, const Genome& x) {
    double g = 0;
    if (problem == "dtlz2") {
        for (std::size_t i = 2; i < x.size(); ++i) g += std::pow(x[i] - 0.5, 2);
        const double a = x[0] * std::numbers::pi / 2;
        const double b = x[1] * std::numbers::pi / 2;
        return {(1 + g) * std::cos(a) * std::cos(b),
                (1 + g) * std::cos(a) * std::sin(b), (1 + g) * std::sin(a)};
    }
    for (std::size_t i = 1; i < x.size(); ++i) g += x[i];
    g = 1 + 9 * g / static_cast<double>(x.size() - 1);
    const double share = x[0] / g;
    return {x[0],
            g * (problem == "zdt1" ? 1 - std::sqrt(share) : 1 - share * share)};
}

int search(const std::string& problem, int population, int generations,
           std::uint64_t seed) {
    const std::size_t objectives = problem == "dtlz2" ? 3 : 2;
    const std::size_t dimension = problem == "dtlz2" ? 12 : 30;
    SearchSettings settings;
    settings.optimizer = OptimizerKind::nsga2;
    settings.population = population;
    const auto optimizer = make_genetic_algorithm(
        settings,
        SearchSpace{GeneSpace(dimension, {"x", "1", 0, 1, false, true}),
                    Genome(dimension, 0.5), make_senses(objectives)},
        seed);
    const auto evaluate = [&](const Candidate& candidate) {
        return make_individual(candidate, values(problem, candidate.genome));
    };
    for (int g = 0; g < generations; ++g) {
        Population rows;
        for (const Candidate& candidate : optimizer->ask())
            rows.push_back(evaluate(candidate));
        optimizer->tell(rows);
    }
    Population parents;
    for (const Candidate& candidate :
         optimizer->best(static_cast<std::size_t>(population)))
        parents.push_back(evaluate(candidate));
    const auto front = fronts(parents, make_senses(objectives));
    for (std::size_t i = 0; i < parents.size(); ++i) {
        if (front[i] != 0) continue;
        for (const Estimate& objective : parents[i].objectives)
            std::printf("%.17g ", objective.mean);
        std::printf("\n");
    }
    return 0;
}

}  // namespace

int main(int count, char** words) {
    if (count == 2 && words[1] == std::string("sort")) return sort();
    if (count == 2 && words[1] == std::string("volume")) return volume();
    if (count != 6) return 1;
    return search(words[2], std::atoi(words[3]), std::atoi(words[4]),
                  std::strtoull(words[5], nullptr, 10));
}
