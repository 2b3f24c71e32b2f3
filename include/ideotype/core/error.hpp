// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace ideotype {

//! The numbers that the program returns to the shell.
enum class ExitCode {
    ok = 0,
    runtime = 1,           //!< something failed while running
    usage = 2,             //!< wrong command line
    invalid_campaign = 3,  //!< an input file has errors
    refused = 4,           //!< going on would break the contract C1-C5
    stopped = 5,  //!< a run stopped early on request; it can be resumed
};

//! An error whose message tells the user the problem, its cause and the remedy.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message,
                   ExitCode exit_code = ExitCode::runtime)
        : std::runtime_error(message), exit_code_(exit_code) {}

    ExitCode exit_code() const { return exit_code_; }

  private:
    ExitCode exit_code_;
};

//! Returns the message of an exception, in plain words where its type has none.
std::string reason_of(const std::exception& error);

//! A place in a text file; line and column count from 1, and 0 means unknown.
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
};

//! One fault of an input file.
struct Problem {
    Location where;
    std::string what;  //!< "problem (why); remedy"
};

//! Returns `file:line:column: what`.
std::string to_string(const Problem& problem);

//! Returns a message whose texts between double quotes, and words that are no
//! paths, are cut to some 80 characters, since a user's text may have
//! megabytes.
std::string with_short_quotes(const std::string& message);

//! All problems of an input, found in one pass, in the order of the text.
class InputError : public Error {
  public:
    explicit InputError(std::vector<Problem> problems);

    const std::vector<Problem>& problems() const { return problems_; }

  private:
    std::vector<Problem> problems_;
};

//! Returns the candidate nearest to a misspelt word, or "" if none is near.
std::string nearest_name(const std::string& word,
                         const std::vector<std::string>& candidates);

//! Returns "did you mean 'x'?", or "use one of x, y, z" if no candidate is
//! near.
std::string did_you_mean(const std::string& word,
                         const std::vector<std::string>& candidates);

}  // namespace ideotype
