// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "parallel/session.hpp"

namespace ideotype {

//! The facts, by attributes of a history, on which the bits of results depend
//! besides the campaign and the instruction set.
using ProgramFacts = std::map<std::string, std::string>;

//! Returns version, compiler, Embree and maths of this process by name.
ProgramFacts program_facts();

//! The hardware and program of one rank of a job.
struct Machine {
    std::string host;
    ProgramFacts program;
    std::vector<std::string> isas;  //!< its instruction sets, narrowest first

    bool operator==(const Machine&) const = default;
};

Machine this_machine();

//! Returns a machine as a message between ranks, and back.
std::string to_text(const Machine& machine);
Machine machine_of(const std::string& text);

//! Gathers the machines of all ranks on rank 0. All ranks must call this.
//! @param own the machine of this rank
std::vector<Machine> gather_machines(const Session& session,
                                     const Machine& own);

//! Returns the number of threads that evaluate on each rank: the wanted number,
//! or else one, or all cores for a single rank. All ranks must call this.
int threads_per_rank(const Session& session, const std::optional<int>& wanted);

//! Checks that all ranks run the same program. @throws Error (refused) that
//! names the difference from the first rank, and both hosts.
void require_same_program(const std::vector<Machine>& machines);

//! Returns the instruction set for all ranks: the wanted one, or the widest
//! that all ranks have.
//! @param remedy end of the message
//! @throws Error (refused) that names a host without the instruction set
std::string choose_isa(const std::vector<Machine>& machines,
                       const std::optional<std::string>& wanted,
                       const std::string& remedy);

}  // namespace ideotype
