// SPDX-License-Identifier: Apache-2.0
#include "machines.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"
#include "ideotype/core/mapped.hpp"
#include "ideotype/core/version.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {

namespace {

bool has(const Machine& machine, const std::string& isa) {
    return std::find(machine.isas.begin(), machine.isas.end(), isa) !=
           machine.isas.end();
}

}  // namespace

ProgramFacts program_facts() {
    const BuildInfo& build = build_info();
    return {{"program_version", build.version},
            {"compiler", build.compiler},
            {"embree_version", Device::library_version()},
            {"maths", maths_fingerprint()}};
}

Machine this_machine() {
    return {host_name(), program_facts(), Device::supported_isas()};
}

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Machine, host, program, isas)

std::string to_text(const Machine& machine) {
    return nlohmann::json(machine).dump();
}

Machine machine_of(const std::string& text) {
    return nlohmann::json::parse(text).get<Machine>();
}

std::vector<Machine> gather_machines(const Session& session,
                                     const Machine& own) {
    return mapped(session.gather(to_text(own)), machine_of);
}

int threads_per_rank(const Session& session, const std::optional<int>& wanted) {
    return session.largest(
        wanted.value_or(session.size() > 1 ? 1 : available_cores()));
}

void require_same_program(const std::vector<Machine>& machines) {
    const Machine& first = machines.front();
    for (const Machine& other : machines)
        for (const auto& [name, value] : first.program)
            if (other.program.at(name) != value)
                throw Error(
                    fmt::format("the ranks of this job would not compute the "
                                "same bits ({} is {} on {}, but {} on {}); "
                                "start the same program everywhere, on "
                                "machines with the same C library",
                                name, value, first.host, other.program.at(name),
                                other.host),
                    ExitCode::refused);
}

std::string choose_isa(const std::vector<Machine>& machines,
                       const std::optional<std::string>& wanted,
                       const std::string& remedy) {
    const auto is_common = [&](const std::string& isa) {
        return std::all_of(
            machines.begin(), machines.end(),
            [&](const Machine& machine) { return has(machine, isa); });
    };
    if (!wanted) {
        const auto& isas = machines.front().isas;
        return *std::find_if(isas.rbegin(), isas.rend(), is_common);
    }
    for (const Machine& machine : machines)
        if (!has(machine, *wanted))
            throw Error(fmt::format("{} has no instruction set {} (it has {}); "
                                    "{}",
                                    machine.host, *wanted,
                                    fmt::join(machine.isas, ", "), remedy),
                        ExitCode::refused);
    return *wanted;
}

}  // namespace ideotype
