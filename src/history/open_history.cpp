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
    FileLock lock = FileLock::of_new(path);
    if (history_exists(path)) {
        const FileLock held(path);  // fails if another program has begun it
        throw Error(
            path +
                ": this history exists already; add --resume to go on with it",
            ExitCode::refused);
    }
    return with_name_of(path, [&] {
        create_file(path, header, lock);
        return History(
            std::make_unique<File>(path, std::move(lock), open_to_write(path)));
    });
}

History History::resume(const std::string& path) {
    if (!history_exists(path)) throw Error(path + ": there is no such file");
    FileLock lock(path);
    return with_name_of(path, [&] {
        Handle file = open_to_write(path);
        require_intact(file, path);
        return History(
            std::make_unique<File>(path, std::move(lock), std::move(file)));
    });
}

History History::read(const std::string& path) {
    return with_name_of(path, [&] {
        Handle file = open_as_it_is(path);
        require_intact(file, path);
        return History(
            std::make_unique<File>(path, std::nullopt, std::move(file)));
    });
}

HistoryHeader History::header_of(const std::string& path) {
    return with_name_of(path, [&] {
        const Handle file = open_as_it_is(path);
        require_header_intact(file, path);
        return read_header(file);
    });
}

Verified verify_file(const std::string& path) {
    const History history = History::read(path);
    // Compressed blocks have checksums of their own, which are checked at
    // reading.
    with_name_of(path, [&] {
        constexpr hsize_t most = 1000;
        const Handle file = open_as_it_is(path);
        for (const std::string& each : datasets_of(file)) {
            const Dataset data(file, each);
            const hsize_t rows = data.rows();
            for (hsize_t first = 0; first < rows; first += most)
                data.bytes(first, std::min(most, rows - first));
        }
    });
    Verified verified{history.next_generation()};
    for (const Row& row : history.finalists())
        verified.finalists += is_recorded(row.outcome.status) ? 1 : 0;
    return verified;
}

History History::salvage(const std::string& path) {
    return with_name_of(path, [&] {
        Remains remains = open_remains(path);
        auto file =
            std::make_unique<File>(path, std::nullopt, std::move(remains.file));
        file->missing_bytes = remains.missing;
        if (remains.missing == 0) return History(std::move(file));
        file->evaluations.cut(remains.bytes);
        History history(std::move(file));
        // The header need not be whole if no generation is left.
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
            fmt::format("{}: {}; all that was recorded is safe; go on with "
                        "--resume when the disk takes it",
                        path, error.what()));
    }
}

}  // namespace ideotype
