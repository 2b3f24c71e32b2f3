// SPDX-License-Identifier: Apache-2.0
#include "request_evaluator.hpp"

#include <utility>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

//! In the place of a number that was not given.
constexpr double none = -1;

//! Numbers behind the genes: tolerance, and the seed in halves, since not every
//! one is a double.
constexpr std::size_t extra = 3;

double take_last(Genome& genome) {
    const double last = genome.back();
    genome.pop_back();
    return last;
}

SamplingRequest take_sampling(const Task& task, Genome& genome) {
    if (genome.size() < extra)
        throw Error("too few numbers; all ranks must run the same ideotype");
    SamplingRequest sampling{task.generation, task.is_final};
    const double lower = take_last(genome), upper = take_last(genome);
    const double tolerance = take_last(genome);
    if (upper != none)
        sampling.seed = static_cast<std::uint64_t>(upper) << 32 |
                        static_cast<std::uint64_t>(lower);
    if (tolerance != none) sampling.tolerance = tolerance;
    return sampling;
}

}  // namespace

Work to_work(const GenomeRequest& request) {
    Work work{{}, request.genome};
    work.task.generation = request.sampling.generation;
    work.task.slot = static_cast<std::uint32_t>(request.line);
    work.task.is_final = request.sampling.is_final;
    work.genome.push_back(request.sampling.tolerance.value_or(none));
    const std::uint64_t seed = request.sampling.seed.value_or(0);
    work.genome.push_back(
        request.sampling.seed ? static_cast<double>(seed >> 32) : none);
    work.genome.push_back(static_cast<double>(seed & 0xffffffffu));
    return work;
}

RequestEvaluator::RequestEvaluator(const ServedCase& served,
                                   const std::string& isa)
    : served_(served), stand_(served.campaign, served.chosen), device_(isa) {}

Outcome RequestEvaluator::evaluate(const Task& task, const Genome& genome) {
    Genome plain = genome;
    const SamplingRequest sampling = take_sampling(task, plain);
    Outcome outcome = stand_.evaluate(
        grow(served_.campaign, plain),
        sampling_of(sampling, served_.campaign, served_.chosen), device_);
    outcome.randomisations.clear();
    return outcome;
}

}  // namespace ideotype
