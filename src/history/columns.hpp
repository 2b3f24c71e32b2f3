#pragma once

#include <string>
#include <vector>

#include "dataset.hpp"
#include "ideotype/history/history.hpp"
#include "layout.hpp"

namespace ideotype {

//! Does a row with this status have an outcome?
inline bool is_recorded(Status status) {
    return status == Status::done || status == Status::failed;
}

//! The shape of a group of rows.
struct ColumnsForm {
    std::string group;  //!< "evaluations" or "final"
    hsize_t rows = 0;
    Room room = Room::at_once;  //!< of all columns but the status
    std::string row_label;
};

//! Candidates and their outcomes, one dataset per column. What a row holds is
//! decided by its status alone, which is written last and read first.
class Columns {
  public:
    //! Creates the group; /traits, /objectives and /diagnostics exist.
    static void create(hid_t file, const HistoryHeader& header,
                       const ColumnsForm& form);

    Columns(hid_t file, const std::string& group);

    hsize_t rows() const { return status_.rows(); }

    //! Leading rows of which candidate, fitness and objectives lie before this
    //! position in the file.
    hsize_t rows_before(haddr_t end) const;

    //! Leading rows of which the diagnostics do too.
    hsize_t diagnostics_before(haddr_t end) const;

    std::vector<Status> statuses(hsize_t first, hsize_t count) const;

    //! Rows with NaN in everything that their status does not vouch for.
    std::vector<Row> read(hsize_t first, hsize_t count) const;

    //! Everything of candidates but their status; no outcome is known then.
    void write(hsize_t first, const std::vector<Candidate>& candidates);

    //! Everything of an outcome but its status. Numbers of a failed one are
    //! stored as NaN, whatever they are.
    void write(hsize_t row, const Outcome& outcome, double fitness,
               std::uint32_t attempt);

    void set_statuses(hsize_t first, const std::vector<Status>& statuses);

  private:
    std::vector<Candidate> candidates(hsize_t first, hsize_t count) const;
    Row unknown_row() const;
    void clear_outcomes(hsize_t first, std::size_t count);

    Dataset status_;
    Dataset genome_;
    Dataset origin_;
    Dataset parents_;
    Dataset objectives_;
    Dataset objectives_error_;
    Dataset diagnostics_;
    Dataset diagnostics_error_;
    Dataset fitness_;
    Dataset attempt_;
    Dataset seconds_;
    Dataset worker_;
    Dataset message_;
};

}  // namespace ideotype
