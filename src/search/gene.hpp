// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/enum_names.hpp"

namespace ideotype {

//! The numbers that define a plant: one for each gene of a GeneSpace, in the
//! gene's unit.
using Genome = std::vector<double>;

//! The kinds of values of a gene.
enum class GeneKind {
    real,     //!< any number between the bounds
    integer,  //!< whole numbers between the bounds, in order
    choice,   //!< whole numbers of values without an order
};
template <>
inline constexpr std::array enum_names<GeneKind>{
    EnumName{"real", GeneKind::real}, EnumName{"integer", GeneKind::integer},
    EnumName{"choice", GeneKind::choice}};

//! A number that the search may vary, and its range: a trait value, or a key of
//! the campaign. All operators of searches derive from this declaration.
struct Gene {
    std::string name;  //!< name, for example "leaf03_length"
    std::string unit;  //!< unit, "m" or "deg"
    double lower = 0;
    double upper = 0;
    bool is_circular = false;  //!< whether upper means the same as lower
    bool is_free = true;       //!< otherwise the gene keeps the baseline value
    std::string trait{};       //!< trait, for example "length"
    int leaf = 0;  //!< rank from the lowest, 1; 0 for the whole plant
    GeneKind kind = GeneKind::real;
    //! Texts of the values lower, lower + 1, ... of a discrete gene. If empty,
    //! each number is the value itself.
    std::vector<std::string> values{};

    bool is_discrete() const { return kind != GeneKind::real; }
    bool is_choice() const { return kind == GeneKind::choice; }
    //! Returns whether a search can change the gene.
    bool can_vary() const { return is_free && upper > lower; }
    //! Returns the number of values of a discrete gene.
    std::size_t count() const;
};

using GeneSpace = std::vector<Gene>;

//! Returns the number of free genes.
std::size_t count_free(const GeneSpace& genes);

//! Returns the value at a share of the range, 0 to 1. Each value of a discrete
//! gene has an equal part of the range.
double value_at(const Gene& gene, double share);

//! Returns the share of the range at which a value lies: the middle of its part
//! for a discrete gene.
double share_of(const Gene& gene, double value);

//! Maps a value of a circular gene to [lower, upper).
double wrapped(const Gene& gene, double value);

//! Clamps a value to the range of a gene or, for a circular gene, maps it to
//! [lower, upper). Values of discrete genes are rounded.
double within(const Gene& gene, double value);

//! Returns another value of a discrete gene with two or more values: the next
//! lower or higher whole number, each with probability one half unless it is
//! out of range, or any other value of a choice with equal probability.
//! @param u random number in [0, 1)
double other_value(const Gene& gene, double value, double u);

//! Returns the text of a value: the number, or its entry in Gene::values.
std::string text_of(const Gene& gene, double value);

//! Returns the signed distance from a to b, along the shorter arc for a
//! circular gene.
double difference(const Gene& gene, double a, double b);

//! Distance from a bound, relative to the range of a gene, within which a value
//! counts as at the bound. Searches by CMA-ES approach a bound smoothly within
//! this distance; here they end if a gene is pushed beyond its range.
inline constexpr double bound_margin = 0.05;

enum class Bound { lower, upper };

//! Returns the name of a bound, for example "lower".
const char* name_of(Bound bound);

//! Returns the bound that a value has reached, if any. Genes that are circular,
//! not free, without range or choices have no bounds.
std::optional<Bound> find_bound(const Gene& gene, double value);

}  // namespace ideotype
