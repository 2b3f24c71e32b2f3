// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "checksum.hpp"
#include "columns.hpp"
#include "disk/file_lock.hpp"
#include "disk/open.hpp"
#include "generations.hpp"
#include "history.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "journal.hpp"

namespace ideotype {

//! Runs an action. A failure of HDF5 is converted to an Error that names the
//! file.
template <class Action>
auto add_path_to_errors(const std::string& path, Action action) {
    try {
        return action();
    } catch (const Hdf5Error& error) {
        throw Error(path + ": " + error.what());
    }
}

//! The open file, with the operations that History uses for both generations
//! and finalists.
struct History::File {
    //! Takes ownership of an open file. Readers pass no lock.
    File(std::string name, std::optional<FileLock> held, Handle opened);

    //! Returns the rows of a generation; an empty span before it is proposed.
    //! @throws Error if the file has no room for the generation.
    Span span(std::uint32_t generation) const;

    //! Returns a row of /evaluations. @throws Error if the slot does not exist.
    hsize_t row(std::uint32_t generation, std::uint32_t slot) const;

    [[noreturn]] void fail(const std::string& reason,
                           ExitCode exit_code = ExitCode::runtime) const {
        throw Error(path + ": " + reason, exit_code);
    }

    [[noreturn]] void fail_incomplete(std::uint32_t generation) const {
        fail(fmt::format("generation {} is not complete", generation));
    }

    //! Runs an action that reads, and discards its result if the file was
    //! truncated meanwhile.
    template <class Action>
    auto read(Action action) const {
        require_whole();
        auto result = add_path_to_errors(path, std::move(action));
        require_whole();
        return result;
    }

    template <class Action>
    void write(Action action) {
        if (!lock) fail("this history was opened for reading only");
        if (is_broken)
            fail(
                "this history cannot be continued, since an earlier write "
                "failed");
        require_in_place();
        // After a failed write, HDF5 would accept more data but store zeros.
        is_broken = true;
        try {
            action();
        } catch (const Hdf5Error& error) {
            fail_to_write(error);
        } catch (const ContractError&) {
            require_whole();  // zeros of a truncated file may be the cause
            throw;
        }
        is_broken = false;
    }

    //! @throws Error if a genome does not match the genes of this history.
    void require_genes(const std::vector<Candidate>& candidates) const;

    //! Stores candidates. Those that an interrupted session stored are verified
    //! instead; returns their number.
    //! @param label name of the rows in messages, which append the slot
    std::size_t propose(Columns& columns, const std::string& label,
                        std::uint32_t first_slot, hsize_t first,
                        const std::vector<Candidate>& candidates);

    //! Stores the outcome of a proposed row; `label` names the row in messages.
    void record(Columns& columns, const std::string& label, hsize_t row,
                const Outcome& outcome, std::uint32_t attempt);

    //! Synchronises the file with the disk, but at most once a second: it takes
    //! milliseconds, as long as a small generation.
    void synchronize_each_second();

    std::string path;
    std::optional<FileLock> lock;
    Handle id;
    std::unique_ptr<Mapping> mapping;  //!< memory mapping of a writer's file
    HistoryHeader header;
    Columns evaluations;
    Columns finals;
    Generations generations;
    Journal journal;
    GenerationChecksums checksums;
    std::uint32_t next_generation = 0;
    std::vector<Span> spans;  //!< rows of each generation, for a writer
    //! Time of the last synchronisation with the disk.
    std::chrono::steady_clock::time_point synchronized{};
    bool is_broken = false;
    std::uint64_t missing_bytes = 0;

    //! Checks that the file was not deleted or replaced, see History.
    void require_in_place() const;

  private:
    void require_whole() const;
    [[noreturn]] void fail_to_write(const Hdf5Error& error) const;
    void check(const std::string& label, const OutcomeSchema& schema,
               const Outcome& outcome) const;
};

}  // namespace ideotype
