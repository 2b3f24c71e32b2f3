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

//! Suffix of the names of columns of standard errors.
inline constexpr const char* error_suffix = "_standard_error";

//! The number of leading columns that selection needs.
inline constexpr std::size_t essential_numbers = 4;

//! Returns the forms of the columns of an outcome's numbers.
//! @param rows name of the first axis
std::vector<DatasetForm> number_forms(const OutcomeSchema& schema,
                                      const std::string& rows);

//! Returns pointers to the numbers of an outcome for each of number_forms(),
//! row-major. Standard errors without a column are set to 0.
std::vector<std::vector<double*>> collect_numbers(const OutcomeSchema& schema,
                                                  Outcome& outcome);

//! Writes the names and axes of quantities as an attribute of a group, and the
//! axes themselves.
void write_measured(hid_t group, const QuantitySet& measured);

//! Reads the quantities from write_measured(), also from a truncated file.
QuantitySet read_measured(hid_t group);

//! The shape of a table of rows.
struct TableForm {
    std::string group;  //!< name, "evaluations" or "final"
    Axis rows;
    Room room = Room::at_once;  //!< allocation of all columns but the status
    bool has_checksums = false;
};

//! Candidates and their outcomes, one dataset per quantity. The status of a
//! row, written last and read first, determines which of its columns are valid.
class Columns {
  public:
    //! Creates the group of a table with its axes and columns.
    static void create(hid_t file, const GeneSpace& genes,
                       const OutcomeSchema& schema, const TableForm& form);

    //! Reads the quantities and the number of randomisations of a table; the
    //! returned schema has no objectives.
    static OutcomeSchema read_schema(hid_t file, const std::string& group);

    Columns(hid_t file, const std::string& group, const OutcomeSchema& schema);

    //! Makes all columns use a mapping of the file, see Dataset.
    void use(const Mapping& mapping);

    const OutcomeSchema& schema() const { return schema_; }

    hsize_t rows() const { return status_.rows(); }

    //! Makes later reads return NaN for numbers beyond a position in the file.
    void cut(haddr_t end);

    //! Returns the number of leading rows with intact candidate, objectives and
    //! violation.
    hsize_t intact_rows() const { return intact_rows_; }

    //! Returns the number of leading rows with all columns intact.
    hsize_t whole_rows() const { return whole_rows_; }

    std::vector<Status> statuses(hsize_t first, hsize_t count) const {
        return status_.read<Status>(first, count);
    }

    //! Returns the candidates of rows, none of which may be empty.
    std::vector<Candidate> candidates(hsize_t first, hsize_t count) const;

    //! Returns rows, with NaN for all numbers that are not valid by their
    //! status.
    std::vector<Row> read(hsize_t first, hsize_t count) const;

    //! Returns the columns that selection needs; all rows must have an outcome.
    Population population(hsize_t first, hsize_t count) const;

    //! Writes candidates without their status, and clears the rows' outcomes.
    void write(hsize_t first, const std::vector<Candidate>& candidates);

    //! Writes outcomes without their status; numbers of failed ones become NaN.
    void write_outcomes(hsize_t first, const std::vector<Row>& rows);

    void set_statuses(hsize_t first, const std::vector<Status>& statuses);

    //! Writes the checksum of a row; does nothing if the table has none.
    void set_checksum(hsize_t row, const std::string& checksum);

  private:
    std::vector<Outcome> outcomes(hsize_t first, hsize_t count) const;

    OutcomeSchema schema_;
    Dataset status_;
    Dataset genome_;
    Dataset origin_;
    Dataset parents_;
    std::vector<Dataset> numbers_;  //!< numbers of outcomes, see number_forms()
    std::vector<hsize_t> intact_;   //!< leading intact rows of each dataset
    hsize_t intact_rows_;
    hsize_t whole_rows_;
    Dataset attempt_;
    Dataset seconds_;
    Dataset worker_;
    Dataset message_;
    std::optional<Dataset> checksum_;
};

}  // namespace ideotype
