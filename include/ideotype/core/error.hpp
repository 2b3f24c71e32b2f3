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
    stopped = 5,           //!< a run stopped early on request; can be resumed
};

//! An error whose message is meant for the user: what, why, what to do.
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

//! A place in a text file; line and column start at 1, 0 means unknown.
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
};

//! One thing that is wrong with an input file.
struct Problem {
    Location where;
    std::string what;  //!< "problem (why); remedy"
};

//! Returns `file:line:column: what`.
std::string to_string(const Problem& problem);

//! Returns a message in which texts between double quotes, and words that are
//! no paths, have some 80 characters at most, since a text of a user may be
//! megabytes long.
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
