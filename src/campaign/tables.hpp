#pragma once

#include <set>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "report.hpp"
#include "schema.hpp"

namespace ideotype {

//! Reads the tables of one file as their sections declare them, and reports
//! unknown and missing keys.
class TableReader {
  public:
    TableReader(const std::string& file, Report& report)
        : file_(file), report_(report) {}

    //! Reads the keys of a table; children are the names of its sub-tables,
    //! which are read on their own.
    void read(const toml::table& table, const Section& section,
              const std::vector<std::string>& children = {});

    //! Reads a table that may be given once, or left out if it has defaults
    //! only.
    void read_child(const toml::table& parent, const std::string& name,
                    const Section& section);

    //! Reads `[name]` or every `[[name]]` into a record of its own.
    template <class Record>
    void read_entries(const toml::table& parent, const std::string& name,
                      Section (*section_of)(Record&),
                      std::vector<Record>& records) {
        const std::vector<const toml::table*> tables = entries(parent, name);
        // All at once: values are known by their addresses from here on.
        records.assign(tables.size(), Record{});
        for (std::size_t i = 0; i < tables.size(); ++i)
            read(*tables[i], section_of(records[i]));
    }

    //! Reports a table that has to be there.
    void report_missing(const toml::table& parent, const std::string& name,
                        const Section& section);

    Location where(const toml::node& node) const;

  private:
    std::vector<const toml::table*> entries(const toml::table& parent,
                                            const std::string& name);
    //! Returns the keys that unknown ones seem to have been meant for.
    std::set<std::string> report_unknown(
        const toml::table& table, const Section& section,
        const std::vector<std::string>& children);

    std::string file_;
    Report& report_;
};

}  // namespace ideotype
