// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "spec/problems.hpp"
#include "spec/section.hpp"

namespace ideotype {

inline const KnownNames nothing_known;

//! Reads the tables of one file according to their descriptions, and reports
//! unknown and missing keys.
class TableReader {
  public:
    //! @param known names that other parts of the file define; must outlive the
    //! reader
    TableReader(const std::string& file, const Problems& problems,
                const KnownNames& known)
        : file_(file), problems_(problems), known_(known) {}

    //! Reads a file: the keys before its first table, and its tables.
    void read(const toml::table& top, const Description& description,
              void* record) const;

    //! Reads the keys of a table. Tables inside it are read by separate calls.
    void read_keys(const toml::table& table, const Section& section,
                   const std::vector<std::string>& tables = {}) const;

    //! Reads a table with the tables inside it, or each `[[name]]` into a
    //! separate record. Tables with defaults may be missing.
    //! @param section name of the table for messages
    //! @param parent record that contains the table's record
    void read_table(const toml::table& top, const Table& table,
                    const std::string& section, void* parent) const;

    Location where(const toml::node& node) const;

    //! Returns the reader for a table inside this table, or for an entry of a
    //! list such as "site[1]".
    TableReader in(const std::string& name) const {
        return {file_, problems_.in(name), known_};
    }

  private:
    //! Reads a record, including the tables inside it.
    void read_record(const toml::table& table, const Description& description,
                     const std::string& section, void* record) const;
    TableReader in(const Table& table, std::size_t entry, void* record) const;
    std::vector<const toml::table*> entries(const toml::node& node,
                                            const Table& table,
                                            const std::string& section) const;
    //! Sets the source position of a missing table's keys to that of the
    //! parent.
    void locate(const Table& table, void* parent, const Location& place) const;
    void locate(const Description& description, void* record,
                const Location& place) const;
    void report_missing(const toml::table& top, const Table& table,
                        const void* parent) const;
    //! Reports unknown keys, and returns the known keys that they probably
    //! mean.
    std::set<std::string> report_unknown(
        const toml::table& table, const Section& section,
        const std::vector<std::string>& tables) const;

    std::string file_;
    Problems problems_;
    const KnownNames& known_;
};

}  // namespace ideotype
