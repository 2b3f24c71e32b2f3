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

//! The part of a history that is known before its first evaluation.
struct HistoryHeader {
    //! The root attributes by name: program, provenance, case, site...; see
    //! analysis/FORMAT.md. The format, its version and the checksum are added
    //! when they are written.
    std::map<std::string, std::string> text;
    std::map<std::string, double> numbers;
    std::string campaign_source;
    std::string campaign_resolved;
    GeneSpace genes;
    OutcomeSchema schema;  //!< form of the outcomes in /evaluations
    //! The number of randomisations that finalists' objectives are the means
    //! of; all else is as in schema.
    std::size_t final_randomisations = 2;
    std::uint64_t seed = 0;  //!< seed of the case
    int population = 0;      //!< rows of a generation, on average at most
    int generations = 0;     //!< at most
    int finalists = 0;       //!< rows of /final

    //! Returns the room of /evaluations.
    int rows() const { return population * generations; }
    OutcomeSchema final_schema() const;
};

//! An evaluation as it is stored.
struct Row {
    Candidate candidate;
    Outcome outcome;
    std::uint32_t attempt = 0;
};

//! The most characters of a command that a history keeps.
inline constexpr std::size_t longest_command = 512;

//! A start of the program on a history.
struct SessionRecord {
    std::string started;  //!< UTC, ISO 8601
    std::string host;
    std::string command;
    int ranks = 0;
    std::string program{};    //!< name and version
    std::string compiler{};   //!< compiler that built the program
    std::string libraries{};  //!< name and version of each
};

//! Tells what became of the program that writes a history.
enum class Writer {
    alive,   //!< holds the file on this or another host
    closed,  //!< ended in order
    killed,  //!< was killed, or its machine stopped
};

//! Looks at the lock of a history and tells what became of its writer. Never
//! changes anything. Where the file system has no locks, a living writer on
//! another host looks killed.
Writer writer_of(const std::string& path);

//! Returns whether there is a file at this path. Never waits, as opening a pipe
//! would. @throws Error if there is something else, or if that cannot be known.
bool history_exists(const std::string& path);

//! Returns the bytes that the file of such a history reserves on the disk.
std::uint64_t history_bytes(const HistoryHeader& header);

//! The error that another program writes this history at this moment.
class InUseError : public Error {
  public:
    explicit InUseError(const std::string& message)
        : Error(message, ExitCode::refused) {}
};

//! The file of one case: written by rank 0 as the evolution goes, in SWMR
//! mode, and its only checkpoint. Every function throws Error with the file's
//! name if HDF5 fails.
class History {
  public:
    //! Creates the file with everything in it that will ever be there, only
    //! empty. @throws Error (refused) if it exists.
    static History create(const std::string& path, const HistoryHeader& header);

    //! Opens the file of a killed, drained or finished run to go on.
    //! @throws InUseError if another process writes it, Error (refused) if it
    //! is not a history, of another format version, or if something in it does
    //! not have its checksum.
    static History resume(const std::string& path);

    //! Opens to read only, also while another process writes.
    //! @throws Error (refused) if something in it does not have its checksum.
    //! Rows of a generation that is not complete have none.
    static History read(const std::string& path);

    //! Reads the header alone and compares its checksum.
    static HistoryHeader header_of(const std::string& path);

    //! As read(), but opens also what is left of a file that was cut short.
    //! Then only header(), next_generation(), rows(), generation() and
    //! summaries() mean something: a generation counts if candidates,
    //! objectives and violations of its rows are left.
    //! @throws Error (refused) if the header, or a generation of which all is
    //! left, does not have its checksum.
    static History salvage(const std::string& path);

    History(History&&) noexcept;
    History& operator=(History&&) noexcept;
    ~History();

    //! Returns the name and version of the HDF5 library.
    static std::string library_version();

    const HistoryHeader& header() const;

    //! Returns how many bytes the end of the file lacks; 0 unless salvaged.
    std::uint64_t missing_bytes() const;

    //! Returns the number of complete generations of which nothing is lost, and
    //! which so could be compared with their checksums.
    std::uint32_t whole_generations() const;

    //! Adds an entry to /sessions. To be called once per start.
    void begin_session(const SessionRecord& session);

    //! Returns the last start of the program; none for a new file.
    std::optional<SessionRecord> last_session() const;

    //! Returns the number of recorded evaluations, finalists and incomplete
    //! generations included.
    std::uint64_t evaluated() const;

    //! Returns the next generation to breed or complete: 0 for a new file.
    std::uint32_t next_generation() const;

    //! Writes candidates from this slot of a generation of `size` rows on
    //! before any is sent out, and returns how many of them are there already:
    //! these are verified instead. Generations may differ in size, and the next
    //! may be proposed before one is complete.
    //! @throws Error (refused) if a genome, origin or parent differs in any
    //! bit, naming the slot, or if there is no room for them.
    std::size_t propose(std::uint32_t generation, std::size_t size,
                        std::uint32_t slot,
                        const std::vector<Candidate>& candidates);

    //! Returns whether the rows of one more generation can be written.
    bool has_room(std::uint32_t generation, std::size_t size) const;

    //! Stores an outcome, status last, and makes it durable.
    void record(std::uint32_t generation, std::uint32_t slot,
                const Outcome& outcome, std::uint32_t attempt);

    //! Returns one row, complete or not.
    Row row(std::uint32_t generation, std::uint32_t slot) const;

    //! Returns the rows of a complete generation, with NaN in what a file that
    //! was cut short has lost.
    std::vector<Row> rows(std::uint32_t generation) const;

    //! Returns the number of slots of a proposed generation; 0 before.
    std::uint32_t size(std::uint32_t generation) const;

    //! Returns what selection needs of the rows of a complete generation.
    Population generation(std::uint32_t generation) const;

    //! Marks a generation complete. It is in the file at once, and on the disk
    //! within a second and the next commit.
    void commit(std::uint32_t generation, const GenerationSummary& summary);

    //! Returns the summaries of all committed generations.
    std::vector<GenerationSummary> summaries() const;

    //! These functions do for finalists, in /final, what propose, record and
    //! row do for generations. pending_final() returns slots that are proposed,
    //! and not done or failed yet. Slot 0 is the baseline.
    void propose_final(const std::vector<Candidate>& candidates);
    std::vector<std::uint32_t> pending_final() const;
    void record_final(std::uint32_t slot, const Outcome& outcome);
    std::vector<Row> finalists() const;

    //! Refuses a file that was deleted or replaced, since nobody could ever
    //! read what is written to it. Every write looks at this too. @throws Error
    //! (refused)
    void require_in_place() const;

    //! Returns the seconds that all sessions together spent.
    double wall_time() const;
    void set_wall_time(double seconds);

    //! Adds a line to /messages, which keeps the oldest when it is full.
    void message(const std::string& text);

    //! Marks the case finished with a reason such as "generations".
    void finish(const std::string& reason);

    //! Closes the file of a writer, after which nothing else may be asked.
    //! @throws Error if the last of it cannot be written; rows are safe then.
    void close();

    //! Returns why the case finished, if it did.
    std::optional<std::string> finished() const;

  private:
    struct File;
    explicit History(std::unique_ptr<File> file);
    std::unique_ptr<File> file_;
};

//! The numbers of parts of a history that were compared with their checksums.
struct Verified {
    std::uint32_t generations = 0;
    std::uint32_t finalists = 0;
};

//! Reads all of a history, also while it is written, and compares header,
//! complete generations and finalists with their checksums.
//! @throws Error (refused) that names what is damaged.
Verified verify_file(const std::string& path);

}  // namespace ideotype
