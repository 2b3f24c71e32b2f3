// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace ideotype {

//! The options of a simulation. Times are in seconds; those of rank 0 are
//! measured by tests/benchmark/master.cpp and tests/stress/master_cost.sh.
struct Options {
    int ranks = 64;
    int ranks_per_node = 64;
    int cases = 1;
    std::optional<int> masters;
    int population = 1000;
    int generations = 4;
    int streams = 1;
    std::string optimizer = "ga";
    double evaluation = 25e-3;
    double master_per_evaluation = 12e-6;  //!< messages and record of a row
    double master_per_proposal = 4e-6;     //!< proposal made and stored
    double master_per_candidate = 1.2e-6;  //!< learning between generations
    double master_per_row = 2e-6;          //!< summary and checksum
    double master_per_second = 5e-3;       //!< writing to the disk
    double nap_slack = 55e-6;
    double least = 0;  //!< least efficiency
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
    app.add_option("--streams", options.streams);
    app.add_option("--optimizer", options.optimizer);
    app.add_option("--evaluation", options.evaluation);
    app.add_option("--master-per-evaluation", options.master_per_evaluation);
    app.add_option("--master-per-proposal", options.master_per_proposal);
    app.add_option("--master-per-candidate", options.master_per_candidate);
    app.add_option("--master-per-row", options.master_per_row);
    app.add_option("--master-per-second", options.master_per_second);
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
