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

//! Collects what is wrong with a campaign, and remembers where each value was
//! written so that later checks can point at it. Values are known by the paths
//! of their keys, such as "site[1].latitude". Copies, and the parts that in()
//! returns, share all that they collect.
class Problems {
  public:
    Problems();
    //! Begins with a file that all values come from.
    explicit Problems(const std::string& file);

    //! Returns these problems as those of a table: its keys are told without
    //! its name then.
    Problems in(const std::string& table) const;
    //! Returns these problems as those of an entry of a list of tables.
    Problems in(const std::string& table, std::size_t entry) const;

    //! Notes the place that a value comes from.
    void locate(const std::string& key, const Location& where) const;

    //! Returns where a value was written, or else the table that lacks it.
    const Location& where(const std::string& key) const;

    //! Makes a value unusable for checks against other values.
    void spoil(const std::string& key) const;

    //! Returns whether checks may rely on these values.
    bool usable(std::initializer_list<const char*> keys) const;
    bool usable(const std::string& key) const;

    //! Returns whether nothing is wrong so far.
    bool empty() const;

    void add(const Location& where, const std::string& what) const;

    //! Reports a problem of a value and spoils it.
    void add(const std::string& key, const std::string& what) const;

    //! Reports a problem, of a place or a value, in a text for these arguments.
    template <class Place, class... Args>
    requires(sizeof...(Args) > 0) void add(const Place& place,
                                           fmt::format_string<Args...> text,
                                           Args&&... args) const {
        add(place, fmt::format(text, std::forward<Args>(args)...));
    }

    //! Reports only the first problem of a kind in a file, but spoils the
    //! values of all of them.
    void add_once(const std::string& key, const std::string& kind,
                  const std::string& what) const;

    //! Warns of a value that may be wrong. It stays usable.
    void warn(const std::string& key, const std::string& what) const;
    void warn(const Problem& warning) const;

    //! Throws all problems, if there are any.
    //! @throws InputError with the problems of each file by position, and files
    //! in the order in which they were opened.
    void throw_if_any() const;

    //! Returns the warnings in the order of files and lines.
    std::vector<Problem> warnings() const;
    std::vector<Problem> sorted(std::vector<Problem> problems) const;

    //! Notes that a file is read now. Problems are told in the order in which
    //! files were opened.
    void open(const std::string& file) const;

  private:
    struct Collected;

    std::shared_ptr<Collected> all_;
    std::string prefix_;
};

}  // namespace ideotype
