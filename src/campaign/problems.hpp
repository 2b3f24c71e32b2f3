// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ideotype/core/error.hpp"

namespace ideotype {

//! Collects what is wrong, and remembers where each value was written so that
//! later checks can point at it. Values are identified by their address.
class Problems {
  public:
    Problems() = default;
    //! All values come from this file.
    explicit Problems(const std::string& file) : all_(Location{file}) {}

    //! The value comes from this place.
    void locate(const void* value, const Location& where);

    //! Where a value was written, or else the table that lacks it.
    const Location& where(const void* value) const;

    void add(const Location& where, const std::string& what);

    //! Makes a value unusable for checks against other values.
    void spoil(const void* value);

    //! Reports a problem of a value and spoils it.
    void add(const void* value, const std::string& what);

    //! Whether checks may rely on these values.
    bool usable(std::initializer_list<const void*> values) const;

    //! Whether nothing is wrong so far.
    bool empty() const { return problems_.empty(); }

    //! Reports the first problem of this kind in a file and spoils the values
    //! of all.
    void add_once(const void* value, const std::string& kind,
                  const std::string& what);

    //! Notes what may be wrong with a value; it stays usable.
    void warn(const void* value, const std::string& what);
    void warn(const Problem& warning) { warnings_.push_back(warning); }

    //! @throws InputError if there is any problem: file by file in the order
    //! in which they were read, by position in each.
    void throw_if_any() const;

    //! Returns the warnings in the order of files and lines.
    std::vector<Problem> warnings() const { return sorted(warnings_); }
    std::vector<Problem> sorted(std::vector<Problem> problems) const;

    //! Fixes the order of files.
    void open(const std::string& file);

  private:
    std::vector<std::string> files_;
    std::optional<Location> all_;
    std::map<const void*, Location> places_;
    std::set<const void*> unusable_;
    std::set<std::pair<std::string, std::string>> once_;
    std::vector<Problem> problems_;
    std::vector<Problem> warnings_;
};

}  // namespace ideotype
