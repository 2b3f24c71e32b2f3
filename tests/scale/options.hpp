// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace ideotype {

//! What is simulated. Times in seconds; those of rank 0 as measured by
//! tests/benchmark/master.cpp and tests/stress/master_cost.sh.
struct Options {
    int ranks = 64;
    int ranks_per_node = 64;
    int cases = 1;
    std::optional<int> masters;
    int population = 1000;
    int generations = 4;
    int window = 0;  //!< of the search; 0: generations as barriers
    double evaluation = 25e-3;
    double master_per_evaluation = 12e-6;  //!< messages and record
    double master_per_candidate = 6.5e-6;  //!< between generations
    double master_per_generation = 5e-3;   //!< to the disk
    double nap_slack = 55e-6;
    double least = 0;  //!< efficiency
    std::string folder;
};

inline Options read_options(int argc, char** argv) {
    Options options;
    CLI::App app("ideotype on a simulated cluster");
    app.option_defaults()->multi_option_policy(
        CLI::MultiOptionPolicy::TakeLast);
    app.add_option("--ranks", options.ranks);
    app.add_option("--ranks-per-node", options.ranks_per_node);
    app.add_option("--cases", options.cases);
    app.add_option("--masters", options.masters);
    app.add_option("--population", options.population);
    app.add_option("--generations", options.generations);
    app.add_option("--window", options.window);
    app.add_option("--evaluation", options.evaluation);
    app.add_option("--master-per-evaluation", options.master_per_evaluation);
    app.add_option("--master-per-candidate", options.master_per_candidate);
    app.add_option("--master-per-generation", options.master_per_generation);
    app.add_option("--nap-slack", options.nap_slack);
    app.add_option("--least", options.least, "fail below this efficiency");
    app.add_option("--folder", options.folder, "of the histories")->required();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Error& error) {
        std::exit(app.exit(error));
    }
    return options;
}

}  // namespace ideotype
