// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/args.h>
#include <fmt/format.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Returns a text in lower case; names are compared in this form.
std::string lower_case(std::string text);

//! Returns an error of wrong usage with a formatted message.
template <class... Args>
Error wrong_usage(fmt::format_string<Args...> text, Args&&... args) {
    return Error(fmt::format(text, std::forward<Args>(args)...),
                 ExitCode::usage);
}

//! Paths of keys, relative to a table.
using Keys = std::vector<std::string>;

//! Returns the name of a key or table, such as "soil_albedo", as users know it:
//! a command-line option or a Python argument.
using KeyNaming = std::string (*)(const std::string& key);

//! Returns the key unchanged, for users who write keys themselves.
inline std::string key_itself(const std::string& key) {
    return key;
}

//! Collects the problems of a campaign, with the source position of each value
//! for messages of later checks. Values are identified by the paths of their
//! keys, such as "site[1].latitude". Copies, and the views that in() returns,
//! share the collection.
//!
//! Rules check values against each other. A broken rule is reported at the
//! first of its keys, and only if all these values are valid, so that no
//! problem follows from another. The condition of a rule is a bool, or a
//! function that is called for valid values only.
class Problems {
  public:
    Problems();
    //! Makes a collection for values that all come from one file.
    explicit Problems(const std::string& file);

    //! Makes a collection for values that come from no file.
    explicit Problems(KeyNaming naming);

    //! Returns the name of a key as users know it, or nothing if they write the
    //! key in a file.
    std::optional<std::string> name_of(const std::string& key) const;

    //! Returns a view for one table, in which keys are relative to the table.
    Problems in(const std::string& table) const;
    //! Returns a view for one entry of a list of tables.
    Problems in(const std::string& table, std::size_t entry) const;

    //! Records the source position of a value.
    void locate(const std::string& key, const Location& where) const;

    //! Returns the source position of a value or, if it is unknown, of its
    //! table.
    const Location& where(const std::string& key) const;

    //! Excludes a value from checks against other values.
    void spoil(const std::string& key) const;

    //! Returns whether checks may rely on these values.
    bool usable(const Keys& keys) const;

    //! Returns whether no problem has been reported so far.
    bool empty() const;

    //! Returns a problem of a value, without reporting it.
    Problem problem(const std::string& key, ProblemCode code,
                    const std::string& what) const;

    //! Adds the key that names a file to a problem inside this file.
    Problem named_by(const std::string& key, Problem problem) const;

    //! Reports a problem of a value, and excludes the value from further
    //! checks.
    template <class... Args>
    void add(const std::string& key, ProblemCode code,
             fmt::format_string<Args...> text, Args&&... args) const {
        spoil(key);
        add_at(where(key), key, code, text, std::forward<Args>(args)...);
    }

    //! Reports a problem at a given position, without excluding any value.
    template <class... Args>
    void add_at(const Location& where, const std::string& key, ProblemCode code,
                fmt::format_string<Args...> text, Args&&... args) const {
        add({where, written(key), code,
             fmt::format(text, std::forward<Args>(args)...)});
    }
    void add(const Problem& problem) const;

    //! Reports only the first problem of its kind in a file, but excludes the
    //! values of all such problems from checks.
    void add_once(const std::string& key, const std::string& kind,
                  ProblemCode code, const std::string& what) const;

    //! Reports that the first of some values breaks a rule. Does nothing if any
    //! of the values is excluded.
    template <class Broken, class... Args>
    void rule(const Keys& keys, const Broken& is_broken,
              fmt::format_string<Args...> text, Args&&... args) const {
        rule(ProblemCode::contradiction, keys, is_broken, text,
             std::forward<Args>(args)...);
    }
    template <class Broken, class... Args>
    void rule(ProblemCode code, const Keys& keys, const Broken& is_broken,
              fmt::format_string<Args...> text, Args&&... args) const {
        if (usable(keys) && holds(is_broken))
            add(keys.front(), code, text, std::forward<Args>(args)...);
    }
    //! Calls a function with valid values, and reports the fault that it
    //! returns; "" means none.
    void rule(const Keys& keys, const std::function<std::string()>& fault,
              ProblemCode code = ProblemCode::contradiction) const;

    //! Reports a broken rule. In the text, {0}, {1} ... stand for the names of
    //! keys as users know them, followed by other values.
    template <class... Args>
    void named_rule(const Keys& keys, bool is_broken, const char* text,
                    const Args&... args) const {
        if (!is_broken) return;
        fmt::dynamic_format_arg_store<fmt::format_context> arguments;
        for (const std::string& key : keys)
            arguments.push_back(name_of(key).value_or(key));
        (arguments.push_back(args), ...);
        rule(keys, true, "{}", fmt::vformat(text, arguments));
    }

    //! Warns that the first of some values may be wrong, unless any of them is
    //! excluded. The value stays usable.
    template <class Doubtful, class... Args>
    void doubt(const Keys& keys, const Doubtful& is_doubtful,
               fmt::format_string<Args...> text, Args&&... args) const {
        if (usable(keys) && holds(is_doubtful))
            warn(problem(keys.front(), ProblemCode::doubt,
                         fmt::format(text, std::forward<Args>(args)...)));
    }
    void warn(Problem warning) const;

    //! Records a key of a history that this version does not know.
    void pass_over(const std::string& key) const;
    const std::set<std::string>& passed_over() const;

    //! Throws if any problem has been reported.
    //! @throws InputError with the problems of each file by position. Files are
    //! listed in the order in which they were opened.
    void throw_if_any() const;

    //! Throws if any problem has been reported for a value that comes from no
    //! file.
    //! @throws Error of wrong usage
    void throw_wrong_usage() const;

    //! Returns the warnings, sorted by file and line.
    std::vector<Problem> warnings() const;
    std::vector<Problem> sorted(std::vector<Problem> problems) const;

    //! Records that a file was opened. Problems are listed in the order in
    //! which files were opened.
    void open(const std::string& file) const;

  private:
    struct Collected;

    template <class Condition>
    static bool holds(const Condition& condition) {
        if constexpr (std::is_invocable_v<Condition>)
            return condition();
        else
            return condition;
    }

    //! Returns the path of a key without indices of list entries, as users
    //! write it.
    std::string written(const std::string& key) const;

    std::shared_ptr<Collected> all_;
    std::string prefix_;
};

}  // namespace ideotype
