// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ideotype/core/error.hpp"
#include "search/outcome.hpp"
#include "search/population.hpp"
#include "search/summary.hpp"

namespace ideotype {

//! The part of a history that is written before its first evaluation.
struct HistoryHeader {
    //! The root attributes by name, such as program, provenance, case and site;
    //! see analysis/FORMAT.md. Format, version and checksum are added when the
    //! file is written.
    std::map<std::string, std::string> text;
    std::map<std::string, double> numbers;
    std::string campaign_source;
    std::string campaign_resolved;
    GeneSpace genes;
    OutcomeSchema schema;  //!< numbers in each outcome of /evaluations
    //! The number of randomisations of finalists. Otherwise their outcomes use
    //! the same schema.
    std::size_t final_randomisations = 2;
    std::uint64_t seed = 0;  //!< seed of the case
    int population = 0;      //!< largest mean number of rows per generation
    int generations = 0;     //!< largest number of generations
    int finalists = 0;       //!< number of rows of /final

    //! Returns the number of rows of /evaluations.
    int rows() const { return population * generations; }
    OutcomeSchema final_schema() const;
};

//! A stored evaluation.
struct Row {
    Candidate candidate;
    Outcome outcome;
    std::uint32_t attempt = 0;
};

//! Longest command, in characters, that a history stores.
inline constexpr std::size_t longest_command = 512;

//! A start of the program on a history.
struct SessionRecord {
    std::string started;  //!< time in UTC, ISO 8601
    std::string host;
    std::string command;
    int ranks = 0;
    std::string program{};    //!< name and version of the program
    std::string compiler{};   //!< compiler that built the program
    std::string libraries{};  //!< names and versions of libraries
};

//! The state of the program that writes or wrote a history.
enum class Writer {
    alive,   //!< is writing the file, on this or another host
    closed,  //!< ended regularly
    killed,  //!< was killed, or its machine stopped
};

//! Determines the state of a history's writer from its lock, without changing
//! the file. If the file system has no locks, a living writer on another host
//! appears as killed.
Writer find_writer(const std::string& path);

//! Returns whether a file exists at a path, without opening it.
//! @throws Error if the path is not a regular file or cannot be examined.
bool history_exists(const std::string& path);

//! Returns the disk space that is reserved for a history with this header
//! [bytes].
std::uint64_t history_bytes(const HistoryHeader& header);

//! Thrown if another program is writing the history.
class InUseError : public Error {
  public:
    explicit InUseError(const std::string& message)
        : Error(message, ExitCode::refused) {}
};

//! The file of one case, which is also its only checkpoint. Rank 0 writes it
//! during the evolution, in the SWMR mode of HDF5. If HDF5 fails, every
//! function throws an Error that names the file.
class History {
  public:
    //! Creates the file with all its datasets, which are still empty.
    //! @throws Error (refused) if the file exists.
    static History create(const std::string& path, const HistoryHeader& header);

    //! Opens the file of a killed, drained or finished run to continue it.
    //! @throws InUseError if another process is writing the file, Error
    //! (refused) if it is not a history, has another format version, or does
    //! not agree with its checksums.
    static History resume(const std::string& path);

    //! Opens a file for reading, also while another process writes it. Rows of
    //! an incomplete generation have no checksum.
    //! @throws Error (refused) if any part does not agree with its checksum.
    static History read(const std::string& path);

    //! Reads only the header, and verifies its checksum.
    static HistoryHeader header_of(const std::string& path);

    //! Reads only whether the case is finished.
    static bool is_finished(const std::string& path);

    //! Opens a file like read(), even if it was truncated. In that case only
    //! header(), next_generation(), rows(), generation() and summaries() are
    //! valid, and a generation counts if candidates, objectives and violations
    //! of its rows are left.
    //! @throws Error (refused) if the header or an intact generation does not
    //! agree with its checksum.
    static History salvage(const std::string& path);

    History(History&&) noexcept;
    History& operator=(History&&) noexcept;
    ~History();

    //! Returns the name and version of the HDF5 library.
    static std::string library_version();

    const HistoryHeader& header() const;

    //! Returns the number of bytes lost at the end of the file; 0 unless
    //! salvaged.
    std::uint64_t missing_bytes() const;

    //! Returns the number of complete generations that are intact in all
    //! columns and agree with their checksums.
    std::uint32_t whole_generations() const;

    //! Adds an entry to /sessions. Call it once per start.
    void begin_session(const SessionRecord& session);

    //! Returns the last start of the program, or nothing for a new file.
    std::optional<SessionRecord> last_session() const;

    //! Returns the number of stored evaluations, including finalists and
    //! incomplete generations.
    std::uint64_t evaluated() const;

    //! Returns the next generation to propose or complete, 0 for a new file.
    std::uint32_t next_generation() const;

    //! Writes candidates of a generation of `size` rows, beginning at a slot,
    //! before any of them is evaluated. Candidates that are already stored are
    //! verified instead; returns their number. Generations may differ in size,
    //! and the next may be proposed before one is complete.
    //! @throws Error (refused) if a genome, origin or parent differs in any
    //! bit, naming the slot, or if the file has no room for the candidates.
    std::size_t propose(std::uint32_t generation, std::size_t size,
                        std::uint32_t slot,
                        const std::vector<Candidate>& candidates);

    //! Returns whether the file has room for the rows of another generation.
    bool has_room(std::uint32_t generation, std::size_t size) const;

    //! Stores an outcome durably; its status is written last.
    void record(std::uint32_t generation, std::uint32_t slot,
                const Outcome& outcome, std::uint32_t attempt);

    //! Returns one row, evaluated or not.
    Row row(std::uint32_t generation, std::uint32_t slot) const;

    //! Returns the rows of a complete generation. Lost numbers are NaN.
    std::vector<Row> rows(std::uint32_t generation) const;

    //! Returns the number of slots of a generation; 0 before it is proposed.
    std::uint32_t size(std::uint32_t generation) const;

    //! Returns the number of rows of all complete generations.
    std::uint64_t plants() const;

    //! Returns a complete generation, with only the columns that selection
    //! needs.
    Population generation(std::uint32_t generation) const;

    //! Marks a generation complete. The mark is in the file at once. It reaches
    //! the disk with the first commit after a second has passed.
    void commit(std::uint32_t generation, const GenerationSummary& summary);

    //! Returns the summaries of all committed generations.
    std::vector<GenerationSummary> summaries() const;

    //! The following functions propose, record and return finalists in /final,
    //! like their namesakes for generations. Slot 0 is the baseline.
    //! pending_final() returns the slots that are proposed but neither done nor
    //! failed.
    void propose_final(const std::vector<Candidate>& candidates);
    std::vector<std::uint32_t> pending_final() const;
    void record_final(std::uint32_t slot, const Outcome& outcome);
    std::vector<Row> finalists() const;

    //! Checks that the file was not deleted or replaced, since new rows would
    //! then be lost. Every write checks this too.
    //! @throws Error (refused)
    void require_in_place() const;

    //! Returns the sum of the wall times of all sessions [s].
    double wall_time() const;
    void set_wall_time(double seconds);

    //! Adds a line to /messages. When the dataset is full, the oldest lines
    //! remain.
    void message(const std::string& text);

    //! Marks the case as finished, with a reason such as "generations".
    void finish(const std::string& reason);

    //! Closes the file of a writer; no other function may be called afterwards.
    //! All rows are already safe.
    //! @throws Error if the last data cannot be written.
    void close();

    //! Returns the reason why the case finished, or nothing if it has not.
    std::optional<std::string> finished() const;

  private:
    struct File;
    explicit History(std::unique_ptr<File> file);
    std::unique_ptr<File> file_;
};

//! The numbers of verified parts of a history.
struct Verified {
    std::uint32_t generations = 0;
    std::uint32_t finalists = 0;
};

//! Verifies the checksums of the header, complete generations and finalists of
//! a history, which may be live.
//! @throws Error (refused) that names the damaged part.
Verified verify_file(const std::string& path);

}  // namespace ideotype
