#pragma once

#include <cstdint>
#include <vector>

#include "ideotype/search/ga_settings.hpp"
#include "ideotype/search/genome.hpp"
#include "ideotype/search/population.hpp"

namespace ideotype {

//! The candidates of a generation, by slot: a pure function of its arguments.
//!
//! Generation 0 is the baseline in slot 0 and genomes uniform within their
//! bounds in all others. Every later generation begins with the elites, the
//! best distinct genomes of the parents, which are evaluated again; the rest
//! are children of couples chosen by tournament, recombined by simulated
//! binary crossover (Deb and Agrawal 1995) and varied by polynomial mutation
//! (Deb and Goyal 1996). On circular genes both act along the shorter arc.
//! Genes that are not free always keep the baseline's value.
//!
//! @param parents evaluated generation before this one; empty for the first
std::vector<Candidate> breed(const GaSettings& optimizer,
                             const GeneSpace& genes, const Genome& baseline,
                             std::uint64_t seed, std::uint32_t generation,
                             const Population& parents);

//! The value on the circle that a circular gene stands for, in
//! [lower, upper).
double wrapped(const Gene& gene, double value);

//! The signed way from a to b: along the shorter arc for a circular gene.
double difference(const Gene& gene, double a, double b);

}  // namespace ideotype
