// SPDX-License-Identifier: Apache-2.0
#include "verify.hpp"

#include "columns.hpp"
#include "contents.hpp"
#include "history_file.hpp"
#include "open.hpp"

namespace ideotype {

namespace {

// Compressed blocks have checksums of their own, which reading looks at.
void read_everything(hid_t file) {
    for (const Object& each : objects_of(file)) {
        if (!each.is_dataset) continue;
        const Handle dataset = open_object(file, each);
        const Blocks blocks(dataset);
        blocks.for_each([&](hsize_t first, hsize_t count) {
            read_block(dataset, blocks, first, count);
        });
    }
}

}  // namespace

Verified verify_file(const std::string& path) {
    initialize_hdf5();
    return with_name_of(path, [&] {
        const Handle file = open_as_it_is(path);
        Verified verified;
        read_everything(file);
        const History history = History::read(path);
        verified.generations = history.next_generation();
        for (const Row& row : history.finalists())
            verified.finalists += is_recorded(row.outcome.status) ? 1 : 0;
        return verified;
    });
}

}  // namespace ideotype
