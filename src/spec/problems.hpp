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

//! Returns a text in lower case, in which names are compared.
std::string lower_case(std::string text);

//! Returns an error of wrong usage with a formatted message.
template <class... Args>
Error wrong_usage(fmt::format_string<Args...> text, Args&&... args) {
    return Error(fmt::format(text, std::forward<Args>(args)...),
                 ExitCode::usage);
}

//! Paths of keys, relative to a table.
using Keys = std::vector<std::string>;

//! Returns the name by which users know a key or a table such as "soil_albedo":
//! that of an option of the command line or of an argument of Python.
using KeyNaming = std::string (*)(const std::string& key);

//! Names keys by themselves.
inline std::string key_itself(const std::string& key) {
    return key;
}

//! Collects the problems of a campaign, and remembers where each value was
//! written, for the messages of later checks. Values are known by the paths of
//! their keys, such as "site[1].latitude". Copies, and the parts that in()
//! returns, share all that is collected.
//!
//! Values are checked against each other by rules: problems that are reported
//! at the first of some keys, and only if all of these values are sound, so
//! that no problem follows from another. Whether a rule is broken is a bool, or
//! a function that is called for sound values only.
class Problems {
  public:
    Problems();
    //! Begins with the file from which all values come.
    explicit Problems(const std::string& file);

    //! Begins with values that come from no file.
    explicit Problems(KeyNaming naming);

    //! Returns the name by which users know a key; nothing if that is the name
    //! of the key in a file.
    std::optional<std::string> name_of(const std::string& key) const;

    //! Returns these problems for one table, whose keys are then given without
    //! the name of the table.
    Problems in(const std::string& table) const;
    //! Returns these problems for one entry of a list of tables.
    Problems in(const std::string& table, std::size_t entry) const;

    //! Notes the place from which a value comes.
    void locate(const std::string& key, const Location& where) const;

    //! Returns where a value was written, or else where its table was.
    const Location& where(const std::string& key) const;

    //! Makes a value unusable for checks against other values.
    void spoil(const std::string& key) const;

    //! Returns whether checks may rely on these values.
    bool usable(const Keys& keys) const;

    //! Returns whether no problem has been reported so far.
    bool empty() const;

    //! Returns a problem of a value, without reporting it.
    Problem problem(const std::string& key, ProblemCode code,
                    const std::string& what) const;

    //! Returns a problem inside a file that a value names, with the value's
    //! key.
    Problem named_by(const std::string& key, Problem problem) const;

    //! Reports a problem of a value and spoils the value.
    template <class... Args>
    void add(const std::string& key, ProblemCode code,
             fmt::format_string<Args...> text, Args&&... args) const {
        spoil(key);
        add_at(where(key), key, code, text, std::forward<Args>(args)...);
    }

    //! Reports a problem at a place of its own, which spoils no value.
    template <class... Args>
    void add_at(const Location& where, const std::string& key, ProblemCode code,
                fmt::format_string<Args...> text, Args&&... args) const {
        add({where, written(key), code,
             fmt::format(text, std::forward<Args>(args)...)});
    }
    void add(const Problem& problem) const;

    //! Reports only the first problem of its kind in a file, but spoils the
    //! values of all problems of this kind.
    void add_once(const std::string& key, const std::string& kind,
                  ProblemCode code, const std::string& what) const;

    //! Reports that the first of some values breaks a rule, unless any of them
    //! is unusable.
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
    //! Reports the fault that a function finds in sound values; "": none.
    void rule(const Keys& keys, const std::function<std::string()>& fault,
              ProblemCode code = ProblemCode::contradiction) const;

    //! Reports a broken rule by a text in which {0}, {1} ... stand for the
    //! names by which users know the keys, and then for other values.
    template <class... Args>
    void named_rule(const Keys& keys, bool is_broken, const char* text,
                    const Args&... args) const {
        if (!is_broken) return;
        fmt::dynamic_format_arg_store<fmt::format_context> all;
        for (const std::string& key : keys)
            all.push_back(name_of(key).value_or(key));
        (all.push_back(args), ...);
        rule(keys, true, "{}", fmt::vformat(text, all));
    }

    //! Warns that the first of some values may be wrong, unless any of them is
    //! unusable; it stays usable.
    template <class Doubtful, class... Args>
    void doubt(const Keys& keys, const Doubtful& is_doubtful,
               fmt::format_string<Args...> text, Args&&... args) const {
        if (usable(keys) && holds(is_doubtful))
            warn(problem(keys.front(), ProblemCode::doubt,
                         fmt::format(text, std::forward<Args>(args)...)));
    }
    void warn(Problem warning) const;

    //! Notes a key of a history that this version does not have.
    void pass_over(const std::string& key) const;
    const std::set<std::string>& passed_over() const;

    //! Throws all problems, if there are any.
    //! @throws InputError with the problems of each file by position, files in
    //! the order in which they were opened.
    void throw_if_any() const;

    //! Throws all problems of values that come from no file, if there are any.
    //! @throws Error of wrong usage
    void throw_wrong_usage() const;

    //! Returns the warnings in the order of files and lines.
    std::vector<Problem> warnings() const;
    std::vector<Problem> sorted(std::vector<Problem> problems) const;

    //! Notes that a file is read from now on. Problems are listed in the order
    //! in which files were opened.
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

    //! Returns the path of a key as users write it, without numbers of entries.
    std::string written(const std::string& key) const;

    std::shared_ptr<Collected> all_;
    std::string prefix_;
};

}  // namespace ideotype
