// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

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

//! Collects the problems of a campaign, and remembers where each value was
//! written, for the messages of later checks. Values are known by the paths of
//! their keys, such as "site[1].latitude". Copies, and the parts that in()
//! returns, share all that is collected.
class Problems {
  public:
    Problems();
    //! Begins with the file from which all values come.
    explicit Problems(const std::string& file);

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
    bool usable(std::initializer_list<const char*> keys) const;
    bool usable(const std::string& key) const;

    //! Returns whether no problem has been reported so far.
    bool empty() const;

    void add(const Location& where, const std::string& what) const;

    //! Reports a problem of a value and spoils it.
    void add(const std::string& key, const std::string& what) const;

    //! Reports a problem of a place or a value, with a formatted text.
    template <class Place, class... Args>
    requires(sizeof...(Args) > 0) void add(const Place& place,
                                           fmt::format_string<Args...> text,
                                           Args&&... args) const {
        add(place, fmt::format(text, std::forward<Args>(args)...));
    }

    //! Reports only the first problem of its kind in a file, but spoils the
    //! values of all problems of this kind.
    void add_once(const std::string& key, const std::string& kind,
                  const std::string& what) const;

    //! Warns of a value that may be wrong but stays usable.
    void warn(const std::string& key, const std::string& what) const;
    template <class... Args>
    requires(sizeof...(Args) > 0) void warn(const std::string& key,
                                            fmt::format_string<Args...> text,
                                            Args&&... args) const {
        warn(key, fmt::format(text, std::forward<Args>(args)...));
    }
    void warn(const Problem& warning) const;

    //! Throws all problems, if there are any.
    //! @throws InputError with the problems of each file by position, files in
    //! the order in which they were opened.
    void throw_if_any() const;

    //! Returns the warnings in the order of files and lines.
    std::vector<Problem> warnings() const;
    std::vector<Problem> sorted(std::vector<Problem> problems) const;

    //! Notes that a file is read from now on. Problems are listed in the order
    //! in which files were opened.
    void open(const std::string& file) const;

  private:
    struct Collected;

    std::shared_ptr<Collected> all_;
    std::string prefix_;
};

}  // namespace ideotype
