#include "checksum.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "attributes.hpp"
#include "columns.hpp"
#include "contents.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/hash.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

bool contains(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

void append(std::string& text, const std::string& name,
            const std::vector<char>& bytes) {
    text += name;
    text += '\0';
    text.append(bytes.begin(), bytes.end());
}

// All datasets of a table but its scales, by name.
class Table {
  public:
    Table(hid_t file, const std::string& name,
          const std::vector<std::string>& left_out) {
        const Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose,
                           "open " + name);
        for (const Object& each : objects_of(group)) {
            if (!each.is_dataset || contains(left_out, each.path)) continue;
            Handle data = open_object(group, each);
            if (is_scale(data)) continue;
            Blocks blocks(data);
            columns_.push_back({each.path, std::move(data), std::move(blocks)});
        }
    }

    //! @param status stands in for that in the file
    void append_rows(std::string& text, const Span& rows,
                     std::optional<Status> status = {}) const {
        for (const auto& [name, data, blocks] : columns_)
            append(text, name,
                   status && name == "status"
                       ? std::vector<char>{static_cast<char>(*status)}
                       : read_block(data, blocks, rows.first, rows.count));
    }

  private:
    struct Column {
        std::string name;
        Handle data;
        Blocks blocks;
    };
    std::vector<Column> columns_;
};

// Opening all datasets takes longer than reading a generation.
class GenerationChecksums {
  public:
    explicit GenerationChecksums(hid_t file)
        : rows_(file, "evaluations", {}),
          summaries_(file, "generations", {"checksum", "committed"}) {}

    std::string of(std::uint32_t generation, const Span& rows) const {
        std::string text;
        rows_.append_rows(text, rows);
        summaries_.append_rows(text, {generation, 1});
        return sha256(text);
    }

  private:
    Table rows_, summaries_;
};

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
    throw Error(path + ": damaged: " + what +
                    " does not have its checksum; copy the file again, or "
                    "take a backup",
                ExitCode::refused);
}

}  // namespace

bool has_checksums(hid_t file) {
    return !text_attribute(file, "format_version").starts_with("1.");
}

std::string header_checksum(hid_t file) {
    std::string text;
    for (const std::string& name : attributes_of(file))
        if (name != "checksum")
            append(text, name, read_attribute(file, name).values);
    for (const Object& each : objects_of(file)) {
        if (!each.is_dataset) continue;
        const Handle data = open_object(file, each);
        const std::string group = each.path.substr(0, each.path.find('/'));
        const bool is_description =
            contains({"campaign", "genes", "objectives"}, group);
        const bool is_table = contains({"evaluations", "final"}, group);
        if (!is_description && !(is_table && is_scale(data))) continue;
        const Blocks blocks(data);
        append(text, "/" + each.path, read_block(data, blocks, 0, blocks.rows));
    }
    return sha256(text);
}

std::string generation_checksum(hid_t file, std::uint32_t generation,
                                const Span& rows) {
    return GenerationChecksums(file).of(generation, rows);
}

std::string finalist_checksum(hid_t file, hsize_t row, Status status) {
    std::string text;
    Table(file, "final", {"checksum"}).append_rows(text, {row, 1}, status);
    return sha256(text);
}

void require_intact(hid_t file, const std::string& path) {
    if (text_attribute(file, "checksum") != header_checksum(file))
        refuse(path, "the header");
    const Generations generations(file);
    const GenerationChecksums found(file);
    const std::uint32_t committed = generations.committed();
    for (std::uint32_t g = 0; g < committed; ++g)
        if (generations.checksum(g) != found.of(g, generations.span(g)))
            refuse(path, fmt::format("generation {}", g));
    const Dataset status(file, "final/status"),
        checksum(file, "final/checksum");
    const auto statuses = status.read<Status>(0, status.rows());
    const auto expected = checksum.read_text(0, status.rows());
    for (std::size_t row = 0; row < statuses.size(); ++row)
        if (is_recorded(statuses[row]) &&
            expected[row] != finalist_checksum(file, row, statuses[row]))
            refuse(path, fmt::format("finalist {}", row));
}

}  // namespace ideotype
