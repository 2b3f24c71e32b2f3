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

//! Runs an action, and converts a failure of HDF5 to an Error with the file's
//! name.
template <class Action>
auto add_path_to_errors(const std::string& path, Action action) {
    try {
        return action();
    } catch (const Hdf5Error& error) {
        throw Error(path + ": " + error.what());
    }
}

//! The open file, with the operations that History applies to generations and
//! finalists alike.
struct History::File {
    //! Takes ownership of an open file. A reader holds no lock.
    File(std::string name, std::optional<FileLock> held, Handle opened);

    //! Returns the rows of a generation; none before it is proposed. @throws
    //! Error if the generation does not fit in the file.
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

    //! Reads; discards the result if the file is truncated meanwhile.
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
        // After a failed write HDF5 would accept more data and store zeros.
        is_broken = true;
        try {
            action();
        } catch (const Hdf5Error& error) {
            fail_to_write(error);
        } catch (const ContractError&) {
            require_whole();  // zeros of a truncated file break it
            throw;
        }
        is_broken = false;
    }

    //! @throws Error if genomes do not have the genes of this history.
    void require_genes(const std::vector<Candidate>& candidates) const;

    //! Stores candidates; verifies those stored by an interrupted session and
    //! returns their number.
    //! @param label name of the rows; messages append the slot
    std::size_t propose(Columns& columns, const std::string& label,
                        std::uint32_t first_slot, hsize_t first,
                        const std::vector<Candidate>& candidates);

    //! Stores an outcome of a proposed row; label is the name of the row.
    void record(Columns& columns, const std::string& label, hsize_t row,
                const Outcome& outcome, std::uint32_t attempt);

    //! Synchronises the file with the disk at most once a second, since this
    //! takes milliseconds, as long as a small generation.
    void synchronize_each_second();

    std::string path;
    std::optional<FileLock> lock;
    Handle id;
    std::unique_ptr<Mapping> mapping;  //!< file mapped to memory, for a writer
    HistoryHeader header;
    Columns evaluations;
    Columns finals;
    Generations generations;
    Journal journal;
    GenerationChecksums checksums;
    std::uint32_t next_generation = 0;
    std::vector<Span> spans;  //!< rows of generations, for a writer
    //! Time of the last synchronisation with the disk.
    std::chrono::steady_clock::time_point synchronized{};
    bool is_broken = false;
    std::uint64_t missing_bytes = 0;

    //! Refuses a file that was deleted or replaced, see History.
    void require_in_place() const;

  private:
    void require_whole() const;
    [[noreturn]] void fail_to_write(const Hdf5Error& error) const;
    void check(const std::string& label, const OutcomeSchema& schema,
               const Outcome& outcome) const;
};

}  // namespace ideotype
