// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "ideotype/core/enum_names.hpp"

namespace ideotype {

//! The exit codes of the program.
enum class ExitCode {
    ok = 0,
    runtime = 1,           //!< something failed while running
    usage = 2,             //!< wrong command line
    invalid_campaign = 3,  //!< an input file has errors
    refused = 4,           //!< continuing would break the contract C1-C5
    stopped = 5,  //!< a run stopped early on request; it can be resumed
};

//! An error with a message for the user: problem, cause and remedy.
class Error : public std::runtime_error {
  public:
    explicit Error(const std::string& message,
                   ExitCode exit_code = ExitCode::runtime)
        : std::runtime_error(message), exit_code_(exit_code) {}

    ExitCode exit_code() const { return exit_code_; }

  private:
    ExitCode exit_code_;
};

//! Returns the message of an exception, or plain words for types without a
//! message.
std::string describe_exception(const std::exception& error);

//! A location in a text file. Lines and columns count from 1; 0 means unknown.
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
};

//! The kinds of problems, for programs that process them.
enum class ProblemCode {
    syntax,         //!< a text that is not TOML, or not a valid setting
    file,           //!< a file that is unreadable or of the wrong kind
    data,           //!< an error inside a weather table or a mesh
    unknown_key,    //!< a key or a table that would be ignored
    missing,        //!< a required key, table or entry
    wrong_type,     //!< a value of another type or length
    out_of_range,   //!< a value or a count outside its range
    unknown_name,   //!< a name of something that does not exist
    duplicate,      //!< a repeated name or entry
    contradiction,  //!< a value that contradicts other values
    doubt,          //!< a value that may be wrong; only in warnings
};

template <>
inline constexpr std::array enum_names<ProblemCode>{
    EnumName{"syntax", ProblemCode::syntax},
    EnumName{"file", ProblemCode::file},
    EnumName{"data", ProblemCode::data},
    EnumName{"unknown_key", ProblemCode::unknown_key},
    EnumName{"missing", ProblemCode::missing},
    EnumName{"wrong_type", ProblemCode::wrong_type},
    EnumName{"out_of_range", ProblemCode::out_of_range},
    EnumName{"unknown_name", ProblemCode::unknown_name},
    EnumName{"duplicate", ProblemCode::duplicate},
    EnumName{"contradiction", ProblemCode::contradiction},
    EnumName{"doubt", ProblemCode::doubt}};

//! One error in an input file.
struct Problem {
    Location where;
    std::string key;  //!< path of its key, such as "spacing.row"; "" if none
    ProblemCode code = ProblemCode::data;
    std::string what;  //!< "problem (why); remedy"
};

//! Formats a problem as `file:line:column: what`.
std::string to_string(const Problem& problem);

//! Shortens quoted texts, and words that are not paths, to about 80 characters,
//! because user input may contain megabytes.
std::string shorten_quotes(const std::string& message);

//! All problems of an input, found in one pass, in the order of the text.
class InputError : public Error {
  public:
    explicit InputError(std::vector<Problem> problems);

    const std::vector<Problem>& problems() const { return problems_; }

  private:
    std::vector<Problem> problems_;
};

//! Finds the candidate nearest to a misspelt word; returns "" if none is near.
std::string nearest_name(const std::string& word,
                         const std::vector<std::string>& candidates);

//! Returns "did you mean 'x'?", or "use one of x, y, z" if no candidate is
//! near.
std::string did_you_mean(const std::string& word,
                         const std::vector<std::string>& candidates);

}  // namespace ideotype
