// SPDX-License-Identifier: Apache-2.0
#include "checksum.hpp"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "attributes.hpp"
#include "columns.hpp"
#include "contents.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"
#include "journal.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void add(Sha256& sum, const std::string& name, std::string_view bytes) {
    sum.add(name);
    sum.add(std::string_view("\0", 1));
    sum.add(bytes);
}

void add(Sha256& sum, const std::string& name, const std::vector<char>& bytes) {
    add(sum, name, std::string_view(bytes.data(), bytes.size()));
}

}  // namespace

//! All datasets of a table but its scales, by name.
class HashedTable {
  public:
    //! @param mapping of the file, if there is one
    HashedTable(hid_t file, const std::string& name,
                const std::vector<std::string>& left_out,
                const Mapping* mapping = nullptr) {
        const Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose,
                           "open " + name);
        for (const Object& each : objects_of(group)) {
            if (!each.is_dataset || contains(left_out, each.path)) continue;
            Handle data = open_object(group, each);
            if (is_scale(data)) continue;
            Blocks blocks(data);
            const char* memory = mapping ? mapping->find(data) : nullptr;
            columns_.push_back(
                {each.path, std::move(data), std::move(blocks), memory});
        }
    }

    //! @param status stands in for that in the file
    void add_rows(Sha256& sum, const Span& rows,
                  std::optional<Status> status = {}) const {
        for (const auto& [name, data, blocks, memory] : columns_)
            if (status && name == "status")
                add(sum, name, std::vector<char>{static_cast<char>(*status)});
            else if (memory)
                add(sum, name,
                    std::string_view(memory + rows.first * blocks.row_bytes,
                                     rows.count * blocks.row_bytes));
            else
                add(sum, name,
                    read_block(data, blocks, rows.first, rows.count));
    }

  private:
    struct Column {
        std::string name;
        Handle data;
        Blocks blocks;
        const char* memory;  //!< all rows; null: HDF5 reads them
    };
    std::vector<Column> columns_;
};

namespace {

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error(path + ": damaged: " + what +
                    " does not have its checksum; copy the file again, or "
                    "take a backup",
                ExitCode::refused);
}

}  // namespace

std::string header_checksum(hid_t file) {
    Sha256 sum;
    for (const std::string& name : attributes_of(file))
        if (name != "checksum")
            add(sum, name, read_attribute(file, name).values);
    for (const Object& each : objects_of(file)) {
        if (!each.is_dataset) continue;
        const Handle data = open_object(file, each);
        const std::string group = each.path.substr(0, each.path.find('/'));
        const bool is_description =
            contains({"campaign", "genes", "objectives"}, group);
        // Studies of version 0.2.0 have the indices themselves.
        const bool is_table =
            contains({"evaluations", "final", "sensitivity"}, group);
        if (!is_description && !(is_table && is_scale(data))) continue;
        const Blocks blocks(data);
        add(sum, "/" + each.path, read_block(data, blocks, 0, blocks.rows));
    }
    return sum.finish();
}

struct GenerationChecksums::Tables {
    HashedTable rows, summaries;
};

GenerationChecksums::GenerationChecksums(hid_t file, const Mapping* mapping)
    : file_(file), mapping_(mapping) {}
GenerationChecksums::~GenerationChecksums() = default;

std::string GenerationChecksums::of(std::uint32_t generation,
                                    const Span& rows) {
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
    Sha256 sum;
    HashedTable(file, "final", {"checksum"}).add_rows(sum, {row, 1}, status);
    return sum.finish();
}

void require_header_intact(hid_t file, const std::string& path) {
    if (text_attribute(file, "checksum") != header_checksum(file))
        refuse(path, "the header");
}

void require_intact(GenerationChecksums& found, const Generations& generations,
                    std::uint32_t generation, const std::string& path) {
    if (generations.checksum(generation) !=
        found.of(generation, generations.span(generation)))
        refuse(path, fmt::format("generation {}", generation));
}

void require_intact(hid_t file, const std::string& path) {
    require_header_intact(file, path);
    const Generations generations(file);
    GenerationChecksums found(file, nullptr);
    const std::uint32_t committed = generations.committed();
    for (std::uint32_t g = 0; g < committed; ++g)
        require_intact(found, generations, g, path);
    const Dataset status(file, "final/status"),
        checksum(file, "final/checksum");
    const auto statuses = status.read<Status>(0, status.rows());
    const auto expected = checksum.read_text(0, status.rows());
    const bool is_finished = Journal(file).finished().has_value();
    // A case that is over has no checksum of what is not recorded.
    if (is_finished && committed < generations.most() &&
        !generations.checksum(committed).empty())
        refuse(path, fmt::format("the mark of generation {}", committed));
    for (std::size_t row = 0; row < statuses.size(); ++row)
        if (is_recorded(statuses[row])
                ? expected[row] != finalist_checksum(file, row, statuses[row])
                : is_finished && !expected[row].empty())
            refuse(path, fmt::format("finalist {}", row));
}

}  // namespace ideotype
