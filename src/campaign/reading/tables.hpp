// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "campaign/problems.hpp"
#include "campaign/schema/schema.hpp"

namespace ideotype {

//! Reads the tables of one file as their sections declare them, and reports
//! unknown and missing keys.
class TableReader {
  public:
    TableReader(const std::string& file, const Problems& problems)
        : file_(file), problems_(problems) {}

    //! Reads the keys of a table; children are read on their own.
    void read(const toml::table& table, const Section& section,
              const std::vector<Table>& children = {}) const;

    //! Reads a table, or every `[[name]]` into a record of its own. It may be
    //! left out if it has defaults.
    void read(const toml::table& parent, const Table& table) const;

    Location where(const toml::node& node) const;

  private:
    //! Returns the reader of a table in this one.
    TableReader in(const Table& table, std::size_t entry) const;
    std::vector<const toml::table*> entries(const toml::node& node,
                                            const Table& table) const;
    //! The values of a table that is left out are those of its parent.
    void locate(const Table& table, const Location& place) const;
    void report_missing(const toml::table& parent, const Table& table) const;
    //! Returns whether earlier versions had this key; an error unless it is
    //! switched off.
    bool is_gone(const std::string& section, const toml::key& key,
                 const toml::node& value) const;
    //! Returns the keys that unknown ones seem to have been meant for.
    std::set<std::string> report_unknown(
        const toml::table& table, const Section& section,
        const std::vector<Table>& children) const;

    std::string file_;
    Problems problems_;
};

}  // namespace ideotype
