// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "disk/open.hpp"
#include "history.hpp"
#include "history_file.hpp"
#include "ideotype/core/contract.hpp"
#include "layout.hpp"

namespace ideotype {

History History::create(const std::string& path, const HistoryHeader& header) {
    FileLock lock = FileLock::create_new(path);
    if (history_exists(path)) {
        const FileLock other(path);  // throws if another program is creating it
        throw Error(
            path + ": this history exists already; add --resume to continue it",
            ExitCode::refused);
    }
    return add_path_to_errors(path, [&] {
        create_file(path, header, lock);
        return History(
            std::make_unique<File>(path, std::move(lock), open_to_write(path)));
    });
}

History History::resume(const std::string& path) {
    if (!history_exists(path)) throw Error(path + ": there is no such file");
    FileLock lock(path);
    return add_path_to_errors(path, [&] {
        Handle file = open_to_write(path);
        require_intact(file, path);
        return History(
            std::make_unique<File>(path, std::move(lock), std::move(file)));
    });
}

History History::read(const std::string& path) {
    return add_path_to_errors(path, [&] {
        Handle file = open_as_it_is(path);
        require_intact(file, path);
        return History(
            std::make_unique<File>(path, std::nullopt, std::move(file)));
    });
}

HistoryHeader History::header_of(const std::string& path) {
    return add_path_to_errors(path, [&] {
        const Handle file = open_as_it_is(path);
        require_header_intact(file, path);
        return read_header(file);
    });
}

bool History::is_finished(const std::string& path) {
    return add_path_to_errors(path, [&] {
        return Journal(open_as_it_is(path)).finished().has_value();
    });
}

Verified verify_file(const std::string& path) {
    const History history = History::read(path);
    // Verify the checksums of compressed blocks by reading them.
    add_path_to_errors(path, [&] {
        constexpr hsize_t chunk = 1000;
        const Handle file = open_as_it_is(path);
        for (const std::string& path_of_dataset : list_datasets(file)) {
            const Dataset data(file, path_of_dataset);
            const hsize_t rows = data.rows();
            for (hsize_t first = 0; first < rows; first += chunk)
                data.bytes(first, std::min(chunk, rows - first));
        }
    });
    Verified verified{history.next_generation()};
    for (const Row& row : history.finalists())
        verified.finalists += is_recorded(row.outcome.status) ? 1 : 0;
    return verified;
}

History History::salvage(const std::string& path) {
    return add_path_to_errors(path, [&] {
        Remains remains = open_remains(path);
        auto file =
            std::make_unique<File>(path, std::nullopt, std::move(remains.file));
        file->missing_bytes = remains.missing;
        if (remains.missing == 0) return History(std::move(file));
        file->evaluations.cut(remains.bytes);
        History history(std::move(file));
        // If no generation is left, the header may be incomplete.
        if (history.next_generation() > 0)
            require_header_intact(history.file_->id, path);
        for (std::uint32_t g = 0; g < history.whole_generations(); ++g)
            require_intact(history.file_->checksums, history.file_->generations,
                           g, path);
        return history;
    });
}

void History::close() {
    IDEOTYPE_EXPECT(file_->lock);
    const std::string path = file_->path;
    const std::optional<FileLock> lock = std::move(file_->lock);
    Handle id = std::move(file_->id);
    file_.reset();
    try {
        id.close("close it");
    } catch (const Hdf5Error& error) {
        throw Error(
            fmt::format("{}: {}; all recorded rows are safe; continue with "
                        "--resume when the disk accepts writes",
                        path, error.what()));
    }
}

}  // namespace ideotype
