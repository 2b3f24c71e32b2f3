// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "history.hpp"
#include "layout.hpp"

namespace ideotype {

//! Does a row with this status have an outcome?
inline bool is_recorded(Status status) {
    return status == Status::done || status == Status::failed;
}

Axis gene_axis(const GeneSpace& genes);
Axis objective_axis(const std::vector<Objective>& objectives);

//! The end of the name of a column of standard errors.
inline constexpr const char* error_suffix = "_standard_error";

//! Of the columns, the first ones, all that selection needs is made.
inline constexpr std::size_t essential_numbers = 4;

//! The columns of an outcome's numbers.
//! @param rows name of their first axis
std::vector<DatasetForm> number_forms(const OutcomeSchema& schema,
                                      const std::string& rows);

//! The numbers of an outcome of this form for each of number_forms(),
//! row-major. Standard errors that have no column become 0.
std::vector<std::vector<double*>> columns_of(const OutcomeSchema& schema,
                                             Outcome& outcome);

//! Writes what is measured as an attribute of a group, and its axes.
void write_measured(hid_t group, const QuantitySet& measured);

//! Reads it again, also from a file that is cut short.
QuantitySet read_measured(hid_t group);

//! The shape of a table of rows.
struct TableForm {
    std::string group;  //!< "evaluations" or "final"
    Axis rows;
    Room room = Room::at_once;  //!< of all columns but the status
    bool has_checksums = false;
};

//! Candidates and their outcomes, one dataset per quantity. What a row holds is
//! decided by its status alone, which is written last and read first.
class Columns {
  public:
    //! Creates the group with its axes.
    static void create(hid_t file, const GeneSpace& genes,
                       const OutcomeSchema& schema, const TableForm& form);

    //! What is measured, and in how many randomisations; no objectives.
    static OutcomeSchema read_schema(hid_t file, const std::string& group);

    Columns(hid_t file, const std::string& group, const OutcomeSchema& schema);

    //! See Dataset.
    void use(const Mapping& mapping);

    const OutcomeSchema& schema() const { return schema_; }

    hsize_t rows() const { return status_.rows(); }

    //! From now on only what lies before this position in the file is there;
    //! other numbers are NaN.
    void cut(haddr_t end);

    //! Leading rows of which candidate, objectives and violation are there.
    hsize_t intact_rows() const { return intact_rows_; }

    //! Leading rows of which all is there.
    hsize_t whole_rows() const { return whole_rows_; }

    std::vector<Status> statuses(hsize_t first, hsize_t count) const {
        return status_.read<Status>(first, count);
    }

    //! Of rows that are not empty.
    std::vector<Candidate> candidates(hsize_t first, hsize_t count) const;

    //! Rows with NaN in everything that their status does not vouch for.
    std::vector<Row> read(hsize_t first, hsize_t count) const;

    //! What selection needs of rows of which all have an outcome.
    Population population(hsize_t first, hsize_t count) const;

    //! Everything of candidates but their status; no outcome is known then.
    void write(hsize_t first, const std::vector<Candidate>& candidates);

    //! Everything of the outcomes of some rows but their status. Numbers of
    //! failed ones are stored as NaN, whatever they are.
    void write_outcomes(hsize_t first, const std::vector<Row>& rows);

    void set_statuses(hsize_t first, const std::vector<Status>& statuses);

    //! Of one row; nothing happens if the table has none.
    void set_checksum(hsize_t row, const std::string& checksum) {
        if (checksum_) checksum_->write_text(row, checksum);
    }

  private:
    std::vector<Outcome> outcomes(hsize_t first, hsize_t count) const;

    OutcomeSchema schema_;
    Dataset status_;
    Dataset genome_;
    Dataset origin_;
    Dataset parents_;
    std::vector<Dataset> numbers_;  //!< of outcomes, see number_forms()
    std::vector<hsize_t> intact_;   //!< leading rows that are there, of each
    hsize_t intact_rows_;
    hsize_t whole_rows_;
    Dataset attempt_;
    Dataset seconds_;
    Dataset worker_;
    Dataset message_;
    std::optional<Dataset> checksum_;
};

}  // namespace ideotype
