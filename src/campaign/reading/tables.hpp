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

    //! Reads the keys of a table; tables in it are read by separate calls.
    void read(const toml::table& table, const Section& section,
              const std::vector<Table>& children = {}) const;

    //! Reads a table, or every `[[name]]` into a record of its own. Tables with
    //! defaults may be missing.
    void read(const toml::table& parent, const Table& table) const;

    Location where(const toml::node& node) const;

  private:
    //! Returns the reader of a table inside this table.
    TableReader in(const Table& table, std::size_t entry) const;
    std::vector<const toml::table*> entries(const toml::node& node,
                                            const Table& table) const;
    //! Gives the keys of a missing table the place of its parent.
    void locate(const Table& table, const Location& place) const;
    void report_missing(const toml::table& parent, const Table& table) const;
    //! Returns whether only earlier versions had a key; reports the key unless
    //! it is switched off.
    bool is_gone(const std::string& section, const toml::key& key,
                 const toml::node& value) const;
    //! Returns the known keys that unknown keys seem to stand for.
    std::set<std::string> report_unknown(
        const toml::table& table, const Section& section,
        const std::vector<Table>& children) const;

    std::string file_;
    Problems problems_;
};

}  // namespace ideotype
