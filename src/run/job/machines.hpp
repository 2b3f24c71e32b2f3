// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parallel/session.hpp"

namespace ideotype {

//! Properties of the program on which the bits of results depend, in addition
//! to campaign and instruction set; by attribute name of a history.
using ProgramFacts = std::map<std::string, std::string>;

//! Returns version, compiler, Embree version and maths fingerprint of this
//! process.
ProgramFacts program_facts();

//! The hardware and program of one rank of a job.
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
//! @param own the machine of this rank
std::vector<Machine> gather_machines(const Session& session,
                                     const Machine& own);

//! Returns the number of evaluation threads on each rank: the wanted number,
//! else one, or all cores if there is a single rank. Collective.
int threads_per_rank(const Session& session, const std::optional<int>& wanted);

//! Checks that all ranks run the same program. @throws Error (refused) that
//! names the difference from the first rank, and both hosts.
void require_same_program(const std::vector<Machine>& machines);

//! Returns the instruction set for all ranks: the wanted one, or the widest
//! that all ranks support.
//! @param remedy end of the message
//! @throws Error (refused) that names a host without the instruction set
std::string choose_isa(const std::vector<Machine>& machines,
                       const std::optional<std::string>& wanted,
                       const std::string& remedy);

}  // namespace ideotype
