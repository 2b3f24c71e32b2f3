#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ideotype/run/run.hpp"

namespace CLI {
class App;
}

namespace ideotype {

//! The verb `run` with its options. Must outlive the parsing.
class RunCommand {
  public:
    void add_to(CLI::App& app, int argc, char** argv);

    //! Starts the ranks of `--ranks` and waits for them, or is one of them.
    //! Returns the exit code.
    int start() const;

  private:
    std::vector<std::string> words_;  //!< of the command line
    RunOptions options_;
    std::optional<std::string> ranks_;
};

}  // namespace ideotype
