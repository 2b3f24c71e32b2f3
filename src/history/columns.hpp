// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dataset.hpp"
#include "history.hpp"
#include "layout.hpp"

namespace ideotype {

Axis gene_axis(const GeneSpace& genes);
Axis objective_axis(const std::vector<Objective>& objectives);

//! Suffix of the names of columns with standard errors.
inline constexpr const char* error_suffix = "_standard_error";

//! The number of leading numeric columns that selection needs.
inline constexpr std::size_t essential_numbers = 4;

//! Returns the forms of the columns that store the numbers of outcomes.
//! @param rows name of the first axis
std::vector<DatasetForm> number_forms(const OutcomeSchema& schema,
                                      const std::string& rows);

//! Returns pointers to the numbers of an outcome, row-major, for each column of
//! number_forms(). Standard errors without a column are set to 0.
std::vector<std::vector<double*>> collect_numbers(const OutcomeSchema& schema,
                                                  Outcome& outcome);

//! Writes the names and axes of quantities as an attribute of a group, and
//! creates the axes.
void write_measured(hid_t group, const QuantitySet& measured);

//! Reads the quantities that write_measured() wrote, also from a truncated
//! file.
QuantitySet read_measured(hid_t group);

//! The shape of a table of rows.
struct TableForm {
    std::string group;  //!< name, "evaluations" or "final"
    Axis rows;
    Room room = Room::at_once;  //!< allocation of all columns except the status
    bool has_checksums = false;
};

//! A table of candidates and their outcomes, with one dataset per quantity. The
//! status of a row determines which of its columns are valid, so it is written
//! last and read first.
class Columns {
  public:
    //! Creates the group of a table with its axes and columns.
    static void create(hid_t file, const GeneSpace& genes,
                       const OutcomeSchema& schema, const TableForm& form);

    //! Reads the quantities and the number of randomisations of a table. The
    //! schema that is returned contains no objectives.
    static OutcomeSchema read_schema(hid_t file, const std::string& group);

    Columns(hid_t file, const std::string& group, const OutcomeSchema& schema);

    //! Makes all columns use a mapping of the file, see Dataset.
    void use(const Mapping& mapping);

    const OutcomeSchema& schema() const { return schema_; }

    hsize_t rows() const { return status_.rows(); }

    //! Limits the file to a length: numbers stored beyond it are read as NaN.
    void cut(haddr_t end);

    //! Returns the number of leading rows with intact candidates, objectives
    //! and violations.
    hsize_t intact_rows() const { return intact_rows_; }

    //! Returns the number of leading rows that are intact in all columns.
    hsize_t whole_rows() const { return whole_rows_; }

    std::vector<Status> statuses(hsize_t first, hsize_t count) const {
        return status_.read<Status>(first, count);
    }

    //! Returns the candidates of rows, none of which may be empty.
    std::vector<Candidate> candidates(hsize_t first, hsize_t count) const;

    //! Returns rows. Numbers that are not valid according to the row's status
    //! are NaN.
    std::vector<Row> read(hsize_t first, hsize_t count) const;

    //! Returns the columns that selection needs. All rows must have been
    //! evaluated.
    Population population(hsize_t first, hsize_t count) const;

    //! Writes candidates without their status, and clears the outcomes of their
    //! rows.
    void write(hsize_t first, const std::vector<Candidate>& candidates);

    //! Writes outcomes without their status. Numbers of failed outcomes become
    //! NaN.
    void write_outcomes(hsize_t first, const std::vector<Row>& rows);

    void set_statuses(hsize_t first, const std::vector<Status>& statuses);

    //! Writes the checksum of a row, unless the table has no checksums.
    void set_checksum(hsize_t row, const std::string& checksum);

  private:
    std::vector<Outcome> outcomes(hsize_t first, hsize_t count) const;

    OutcomeSchema schema_;
    Dataset status_;
    Dataset genome_;
    Dataset origin_;
    Dataset parents_;
    std::vector<Dataset> numbers_;  //!< columns of number_forms()
    //! Number of leading intact rows, by dataset.
    std::vector<hsize_t> intact_;
    hsize_t intact_rows_;
    hsize_t whole_rows_;
    Dataset attempt_;
    Dataset seconds_;
    Dataset worker_;
    Dataset message_;
    std::optional<Dataset> checksum_;
};

}  // namespace ideotype
