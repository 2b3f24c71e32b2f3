// SPDX-License-Identifier: Apache-2.0
//! `run` on ranks of which some lack instruction sets, as on a cluster of
//! different nodes: only rank 0 has all of this machine.
//! Usage: mpirun -n RANKS mixed_cluster CAMPAIGN OUT ISAS
//! where all ranks but the first have the first ISAS instruction sets.
#include <cstdlib>

#include <fmt/format.h>

#include "run/run.hpp"

int main(int argc, char** argv) {
    using namespace ideotype;
    if (argc != 4) return static_cast<int>(ExitCode::usage);
    RunOptions options;
    options.campaign_path = argv[1];
    options.out = argv[2];
    options.is_resumed = true;
    options.command = "mixed_cluster";
    StopFlag stop;
    const Session session;
    Machine machine = this_machine();
    if (session.rank() > 0) {
        machine.host = "narrow";
        machine.isas.resize(std::strtoul(argv[3], nullptr, 10));
    }
    try {
        return static_cast<int>(run(options, session, stop, machine));
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.exit_code());
    }
}
