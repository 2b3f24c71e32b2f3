// SPDX-License-Identifier: Apache-2.0
#include "checksum.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "columns.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"
#include "journal.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void add(Sha256& sum, const std::string& name, const std::vector<char>& bytes) {
    sum.add(name);
    sum.add(std::string_view("\0", 1));
    sum.add({bytes.data(), bytes.size()});
}

}  // namespace

//! The datasets of a table, sorted by name and without dimension scales.
class HashedTable {
  public:
    HashedTable(hid_t file, const std::string& name,
                const std::vector<std::string>& excluded,
                const Mapping* mapping = nullptr) {
        const Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose,
                           "open " + name);
        for (const std::string& dataset : list_datasets(group)) {
            if (contains(excluded, dataset)) continue;
            Dataset column(group, dataset);
            if (column.is_scale()) continue;
            if (mapping) column.use(*mapping);
            columns_.emplace_back(dataset, std::move(column));
        }
    }

    //! Adds rows to a checksum, dataset by dataset.
    //! @param status status that replaces the one in the file
    void add_rows(Sha256& sum, const Span& rows,
                  std::optional<Status> status = {}) const {
        for (const auto& [name, column] : columns_)
            if (status && name == "status")
                add(sum, name, {static_cast<char>(*status)});
            else
                add(sum, name, column.bytes(rows.first, rows.count));
    }

  private:
    std::vector<std::pair<std::string, Dataset>> columns_;
};

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& part) {
    throw Error(path + ": damaged: " + part +
                    " does not have its checksum; copy the file again, or "
                    "take a backup",
                ExitCode::refused);
}

}  // namespace

std::string header_checksum(hid_t file) {
    Sha256 sum;
    for (const std::string& name : list_attributes(file))
        if (name != "checksum") add(sum, name, Attribute(file, name).bytes);
    for (const std::string& path : list_datasets(file)) {
        const Dataset data(file, path);
        const std::string group = path.substr(0, path.find('/'));
        const bool is_description =
            contains({"campaign", "genes", "objectives"}, group);
        // Version 0.2.0 stores the indices of a sensitivity study as
        // attributes, not as a table.
        const bool is_table =
            contains({"evaluations", "final", "sensitivity"}, group);
        if (is_description || (is_table && data.is_scale()))
            add(sum, "/" + path, data.bytes(0, data.rows()));
    }
    return sum.finish();
}

struct GenerationChecksums::Tables {
    HashedTable rows, summaries;
};

GenerationChecksums::GenerationChecksums(hid_t file, const Mapping* mapping)
    : file_(file), mapping_(mapping) {}
GenerationChecksums::~GenerationChecksums() = default;

std::string GenerationChecksums::compute(std::uint32_t generation,
                                         const Span& rows) {
    IDEOTYPE_EXPECT(rows.count > 0);
    if (!tables_)
        tables_ = std::make_unique<Tables>(Tables{
            HashedTable(file_, "evaluations", {}, mapping_),
            HashedTable(file_, "generations", {"checksum", "committed"})});
    Sha256 sum;
    tables_->rows.add_rows(sum, rows);
    tables_->summaries.add_rows(sum, {generation, 1});
    return sum.finish();
}

std::string finalist_checksum(hid_t file, hsize_t row, Status status) {
    IDEOTYPE_EXPECT(is_recorded(status));
    Sha256 sum;
    HashedTable(file, "final", {"checksum"}).add_rows(sum, {row, 1}, status);
    return sum.finish();
}

void require_header_intact(hid_t file, const std::string& path) {
    if (text_attribute(file, "checksum") != header_checksum(file))
        refuse(path, "the header");
}

void require_intact(GenerationChecksums& checksums,
                    const Generations& generations, std::uint32_t generation,
                    const std::string& path) {
    if (generations.checksum(generation) !=
        checksums.compute(generation, generations.span(generation)))
        refuse(path, fmt::format("generation {}", generation));
}

void require_intact(hid_t file, const std::string& path) {
    require_header_intact(file, path);
    // Read whether the case has ended before reading the rows, because a
    // running case may end in between.
    const bool is_finished = Journal(file).finished().has_value();
    const Generations generations(file);
    GenerationChecksums checksums(file, nullptr);
    const std::uint32_t committed = generations.committed();
    for (std::uint32_t g = 0; g < committed; ++g)
        require_intact(checksums, generations, g, path);
    const Dataset status(file, "final/status"),
        checksum(file, "final/checksum");
    const auto statuses = status.read<Status>(0, status.rows());
    const auto expected = checksum.read_text(0, status.rows());
    IDEOTYPE_ENSURE(expected.size() == statuses.size());
    // In a finished case, only recorded rows have checksums.
    if (is_finished && committed < generations.capacity() &&
        !generations.checksum(committed).empty())
        refuse(path, fmt::format("the mark of generation {}", committed));
    for (std::size_t row = 0; row < statuses.size(); ++row)
        if (is_recorded(statuses[row])
                ? expected[row] != finalist_checksum(file, row, statuses[row])
                : is_finished && !expected[row].empty())
            refuse(path, fmt::format("finalist {}", row));
}

}  // namespace ideotype
