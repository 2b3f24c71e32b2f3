// SPDX-License-Identifier: Apache-2.0
#include "ideotype/cli/ranks.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sched.h>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/parallel/session.hpp"

namespace ideotype {

namespace {

int number_in(const char* text, int otherwise) {
    return text != nullptr ? std::atoi(text) : otherwise;
}

//! The variables in which launchers tell rank and size. PMIx tells no size;
//! under srun SLURM does.
struct Variables {
    const char *rank, *size;
};
constexpr std::array<Variables, 3> variables{{
    {"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
    {"PMI_RANK", "PMI_SIZE"},
    {"PMIX_RANK", "SLURM_STEP_NUM_TASKS"},
}};

}  // namespace

int available_cores() {
    cpu_set_t set;
    int cores = 1;
    if (sched_getaffinity(0, sizeof set, &set) == 0) cores = CPU_COUNT(&set);
    // "max 100000" without a quota
    std::ifstream file("/sys/fs/cgroup/cpu.max");
    double quota = 0, period = 0;
    if (file >> quota >> period && quota > 0 && period > 0)
        cores = std::min(cores, static_cast<int>(std::ceil(quota / period)));
    return std::max(cores, 1);
}

int parse_ranks(const std::string& text) {
    const int automatic = ranks_for(available_cores());
    if (text == "auto") return automatic;
    int ranks = 0;
    const char* end = text.data() + text.size();
    const auto [rest, failure] = std::from_chars(text.data(), end, ranks);
    if (failure != std::errc() || rest != end || ranks < 1 ||
        ranks > most_ranks)
        throw Error(fmt::format("--ranks: '{}' is no number of ranks; give 1 "
                                "to {}, or auto, which is {} here",
                                text, most_ranks, automatic),
                    ExitCode::usage);
    return ranks;
}

Launch launch_of_this_process() {
    for (const Variables& each : variables)
        if (const char* rank = std::getenv(each.rank))
            return {true, number_in(rank, 0),
                    number_in(std::getenv(each.size), 1)};
    return {};
}

void require_all_ranks(int found) {
    const int started = launch_of_this_process().size;
    if (found >= started) return;
    throw Error(
        fmt::format("{} ranks were started, but do not find each other: the "
                    "launcher is not that of {}, which this program is built "
                    "with; start it with {}, or srun with another --mpi (srun "
                    "--mpi=list)",
                    started, Session::library_version(), IDEOTYPE_MPIEXEC),
        ExitCode::usage);
}

}  // namespace ideotype
