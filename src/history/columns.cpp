#include "columns.hpp"

#include <algorithm>
#include <limits>

#include "layout.hpp"
#include "types.hpp"

namespace ideotype {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int32_t no_worker = -1;
constexpr std::size_t message_size = 160;

// Creates the columns of one group, all with the same rows.
class Creator {
  public:
    Creator(hid_t file, const ColumnsForm& form)
        : file_(file), form_(form), group_(create_group(file, form.group)) {}

    //! A column of one value per row.
    void add(const std::string& name, hid_t type, const std::string& unit,
             const void* empty = nullptr) {
        create(name, type, {form_.rows}, unit, empty, form_.room);
    }

    //! The column that says which of the others mean something.
    void add_status() {
        create("status", status_type(), {form_.rows}, "1", nullptr,
               Room::at_once);
    }

    //! As many values per row as the group quantities has names, NaN if empty.
    void add_numbers(const std::string& name, const std::string& quantities,
                     std::size_t width) {
        const std::string names = "/" + quantities + "/name";
        const Handle scale(H5Dopen2(file_, names.c_str(), H5P_DEFAULT),
                           H5Dclose, "open " + names);
        const Handle column =
            create(name, H5T_IEEE_F64LE, {form_.rows, width},
                   "/" + quantities + "/unit", &nan, form_.room);
        attach_scale(column, 1, scale);
    }

    void add_parents() {
        const std::int32_t none = no_parent;
        const Handle column = create("parents", H5T_STD_I32LE, {form_.rows, 2},
                                     "1", &none, form_.room);
        label_dimension(column, 1, "parent");
    }

  private:
    Handle create(const std::string& name, hid_t type,
                  const std::vector<hsize_t>& sizes, const std::string& unit,
                  const void* empty, Room room) {
        Handle column = create_dataset(group_, {.name = name,
                                                .type = type,
                                                .sizes = sizes,
                                                .unit = unit,
                                                .empty = empty,
                                                .room = room});
        label_dimension(column, 0, form_.row_label);
        return column;
    }

    hid_t file_;
    ColumnsForm form_;
    Handle group_;
};

std::vector<double> means(const std::vector<Estimate>& estimates) {
    std::vector<double> values;
    for (const Estimate& x : estimates) values.push_back(x.mean);
    return values;
}

std::vector<double> standard_errors(const std::vector<Estimate>& estimates) {
    std::vector<double> values;
    for (const Estimate& x : estimates) values.push_back(x.standard_error);
    return values;
}

// Row i of two matrices that belong together.
std::vector<Estimate> estimates(const std::vector<double>& means,
                                const std::vector<double>& errors,
                                std::size_t width, std::size_t i) {
    std::vector<Estimate> row(width);
    for (std::size_t j = 0; j < width; ++j)
        row[j] = {means[i * width + j], errors[i * width + j]};
    return row;
}

std::vector<Estimate> stored(const std::vector<Estimate>& values,
                             std::size_t width, Status status) {
    if (status != Status::failed) return values;
    return std::vector<Estimate>(width, Estimate{nan, nan});
}

}  // namespace

void Columns::create(hid_t file, const HistoryHeader& header,
                     const ColumnsForm& form) {
    const OutcomeSchema& schema = header.schema;
    const std::string fitness_unit =
        schema.objectives.empty() ? "1" : schema.objectives[0].unit;
    Creator creator(file, form);
    creator.add_status();
    creator.add_numbers("genome", "traits", header.genes.size());
    creator.add("origin", origin_type(), "1");
    creator.add_parents();
    creator.add("fitness", H5T_IEEE_F64LE, fitness_unit, &nan);
    creator.add_numbers("objectives", "objectives", schema.objectives.size());
    creator.add_numbers("objectives_standard_error", "objectives",
                        schema.objectives.size());
    creator.add_numbers("diagnostics", "diagnostics",
                        schema.diagnostics.size());
    creator.add_numbers("diagnostics_standard_error", "diagnostics",
                        schema.diagnostics.size());
    creator.add("attempt", H5T_STD_U32LE, "1");
    creator.add("seconds", H5T_IEEE_F64LE, "s", &nan);
    creator.add("worker", H5T_STD_I32LE, "1", &no_worker);
    creator.add("message", string_type(message_size), "");
}

Columns::Columns(hid_t file, const std::string& group)
    : status_(file, group + "/status"),
      genome_(file, group + "/genome"),
      origin_(file, group + "/origin"),
      parents_(file, group + "/parents"),
      objectives_(file, group + "/objectives"),
      objectives_error_(file, group + "/objectives_standard_error"),
      diagnostics_(file, group + "/diagnostics"),
      diagnostics_error_(file, group + "/diagnostics_standard_error"),
      fitness_(file, group + "/fitness"),
      attempt_(file, group + "/attempt"),
      seconds_(file, group + "/seconds"),
      worker_(file, group + "/worker"),
      message_(file, group + "/message") {}

hsize_t Columns::rows_before(haddr_t end) const {
    hsize_t count = rows();
    for (const Dataset* column : {&status_, &genome_, &origin_, &parents_,
                                  &fitness_, &objectives_, &objectives_error_})
        count = std::min(count, column->rows_before(end));
    return count;
}

hsize_t Columns::diagnostics_before(haddr_t end) const {
    return std::min(diagnostics_.rows_before(end),
                    diagnostics_error_.rows_before(end));
}

std::vector<Status> Columns::statuses(hsize_t first, hsize_t count) const {
    return status_.read<Status>(first, count);
}

std::vector<Candidate> Columns::candidates(hsize_t first, hsize_t count) const {
    const auto genes = genome_.read<double>(first, count);
    const auto origins = origin_.read<Origin>(first, count);
    const auto parents = parents_.read<std::int32_t>(first, count);
    std::vector<Candidate> candidates(count);
    auto gene = genes.begin();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const auto end = gene + static_cast<std::ptrdiff_t>(genome_.width());
        candidates[i].genome.assign(gene, end);
        candidates[i].origin = origins[i];
        candidates[i].parents = {parents[2 * i], parents[2 * i + 1]};
        gene = end;
    }
    return candidates;
}

std::vector<Row> Columns::read(hsize_t first, hsize_t count) const {
    const auto status = statuses(first, count);
    const auto candidate = candidates(first, count);
    const auto objectives = objectives_.read<double>(first, count);
    const auto objectives_error = objectives_error_.read<double>(first, count);
    const auto diagnostics = diagnostics_.read<double>(first, count);
    const auto diagnostics_error =
        diagnostics_error_.read<double>(first, count);
    const auto fitness = fitness_.read<double>(first, count);
    const auto attempt = attempt_.read<std::uint32_t>(first, count);
    const auto seconds = seconds_.read<double>(first, count);
    const auto worker = worker_.read<std::int32_t>(first, count);
    const auto message = message_.read_text(first, count);
    std::vector<Row> rows(count, unknown_row());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Outcome& outcome = rows[i].outcome;
        outcome.status = status[i];
        if (status[i] != Status::empty) rows[i].candidate = candidate[i];
        if (!is_recorded(status[i])) continue;
        rows[i].fitness = fitness[i];
        rows[i].attempt = attempt[i];
        outcome.objectives =
            estimates(objectives, objectives_error, objectives_.width(), i);
        outcome.diagnostics =
            estimates(diagnostics, diagnostics_error, diagnostics_.width(), i);
        outcome.seconds = seconds[i];
        outcome.message = message[i];
        outcome.worker = static_cast<std::uint32_t>(worker[i]);
    }
    return rows;
}

void Columns::write(hsize_t first, const std::vector<Candidate>& candidates) {
    std::vector<double> genes;
    std::vector<Origin> origins;
    std::vector<std::int32_t> parents;
    for (const Candidate& candidate : candidates) {
        genes.insert(genes.end(), candidate.genome.begin(),
                     candidate.genome.end());
        origins.push_back(candidate.origin);
        parents.insert(parents.end(), candidate.parents.begin(),
                       candidate.parents.end());
    }
    genome_.write(first, genes);
    origin_.write(first, origins);
    parents_.write(first, parents);
    clear_outcomes(first, candidates.size());
}

void Columns::write(hsize_t row, const Outcome& outcome, double fitness,
                    std::uint32_t attempt) {
    const auto objectives =
        stored(outcome.objectives, objectives_.width(), outcome.status);
    const auto diagnostics =
        stored(outcome.diagnostics, diagnostics_.width(), outcome.status);
    objectives_.write(row, means(objectives));
    objectives_error_.write(row, standard_errors(objectives));
    diagnostics_.write(row, means(diagnostics));
    diagnostics_error_.write(row, standard_errors(diagnostics));
    fitness_.write_one(row, fitness);
    attempt_.write_one(row, attempt);
    seconds_.write_one(row, outcome.seconds);
    worker_.write_one(row, static_cast<std::int32_t>(outcome.worker));
    message_.write_text(row, outcome.message);
}

Row Columns::unknown_row() const {
    Row row;
    row.candidate.genome.assign(genome_.width(), nan);
    row.outcome.status = Status::empty;
    row.outcome.objectives.assign(objectives_.width(), {nan, nan});
    row.outcome.diagnostics.assign(diagnostics_.width(), {nan, nan});
    row.outcome.seconds = nan;
    row.fitness = nan;
    return row;
}

// Rows are zeros at first; a reader of this column alone shall not take them
// for outcomes.
void Columns::clear_outcomes(hsize_t first, std::size_t count) {
    for (Dataset* column : {&objectives_, &objectives_error_, &diagnostics_,
                            &diagnostics_error_, &fitness_, &seconds_})
        column->write(first, std::vector<double>(count * column->width(), nan));
    worker_.write(first, std::vector<std::int32_t>(count, no_worker));
}

void Columns::set_statuses(hsize_t first, const std::vector<Status>& statuses) {
    status_.write(first, statuses);
}

}  // namespace ideotype
