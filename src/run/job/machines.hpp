// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parallel/session.hpp"

namespace ideotype {

//! Program properties that, besides the campaign and the instruction set, must
//! agree for bit-identical results. Keys are attribute names in the history
//! file.
using ProgramFacts = std::map<std::string, std::string>;

//! Returns the version, compiler, Embree version and maths fingerprint of this
//! process.
ProgramFacts program_facts();

//! The hardware of one rank of a job, and the program that it runs.
struct Machine {
    std::string host;
    ProgramFacts program;
    std::vector<std::string>
        isas;  //!< supported instruction sets, narrowest first

    bool operator==(const Machine&) const = default;
};

Machine this_machine();

//! Converts a machine to a message between ranks, and back.
std::string to_text(const Machine& machine);
Machine machine_of(const std::string& text);

//! Gathers the machines of all ranks on rank 0. Collective.
//! @param own machine of this rank
std::vector<Machine> gather_machines(const Session& session,
                                     const Machine& own);

//! Returns the number of evaluation threads on each rank: the requested number
//! or, by default, all cores of a single rank and one on each of several.
//! Collective.
int threads_per_rank(const Session& session, const std::optional<int>& wanted);

//! Checks that all ranks run the same program.
//! @throws Error (refused) that names both hosts, and the difference from the
//! first rank
void require_same_program(const std::vector<Machine>& machines);

//! Returns the instruction set for all ranks: the requested one or, by default,
//! the widest that all ranks support.
//! @param remedy end of the error message
//! @throws Error (refused) that names a host that does not support the
//! instruction set
std::string choose_isa(const std::vector<Machine>& machines,
                       const std::optional<std::string>& wanted,
                       const std::string& remedy);

}  // namespace ideotype
