// SPDX-License-Identifier: Apache-2.0
#include "columns.hpp"

#include <algorithm>
#include <atomic>
#include <limits>

#include "checksum.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/mapped.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int32_t no_worker = -1;
constexpr std::size_t failure_size = 160;

}  // namespace

Axis gene_axis(const GeneSpace& genes) {
    return {"gene", "", "gene of a genome", mapped(genes, &Gene::name)};
}

Axis objective_axis(const std::vector<Objective>& objectives) {
    return {"objective", "", "objective of the search",
            mapped(objectives, &Objective::name)};
}

void Columns::create(hid_t file, const GeneSpace& genes,
                     const OutcomeSchema& schema, const TableForm& form) {
    IDEOTYPE_EXPECT(!genes.empty() && !schema.objectives.empty());
    IDEOTYPE_EXPECT(schema.randomisations > 0);
    const Handle group = create_group(file, form.group);
    // Axes of the table.
    create_axis(group, form.rows);
    create_axis(group, gene_axis(genes));
    create_axis(group, counted("parent", "first or second", 2));
    create_axis(group, objective_axis(schema.objectives));
    create_axis(group, counted("randomisation", "independent repetition",
                               schema.randomisations));
    write_measured(group, schema.measured);
    const std::string rows = form.rows.name;
    const auto add =
        [&](const std::string& name, hid_t type, const std::string& meaning,
            const void* empty = nullptr, const std::string& unit = "1",
            const std::vector<std::string>& axes = {}) {
            DatasetForm dataset_form{.name = name,
                                     .type = type,
                                     .axes = {rows},
                                     .unit = unit,
                                     .meaning = meaning,
                                     .empty = empty,
                                     .room = form.room};
            dataset_form.axes.insert(dataset_form.axes.end(), axes.begin(),
                                     axes.end());
            create_dataset(group, dataset_form);
        };
    // The status determines which columns of a row are valid.
    create_dataset(group, {.name = "status",
                           .type = status_type(),
                           .axes = {rows},
                           .meaning = "status of the evaluation"});
    add("genome", H5T_IEEE_F64LE, "values of the genes", &nan, "/genes/unit",
        {"gene"});
    add("origin", origin_type(), "origin of the genome");
    const std::int64_t none = no_parent;
    add("parents", H5T_STD_I64LE,
        "rows of both parents in /evaluations, -1 for none", &none, "1",
        {"parent"});
    // Numbers of outcomes, and how they were obtained.
    std::size_t count = 0;
    const auto add_accounts = [&] {
        add("attempt", H5T_STD_U32LE,
            "number of the attempt from 1, or 0 for the copy of a row");
        add("seconds", H5T_IEEE_F64LE, "wall time of the evaluation", &nan,
            "s");
        add("worker", H5T_STD_I32LE, "rank that evaluated", &no_worker);
        add("message", string_type(failure_size),
            "reason of a failed evaluation", nullptr, "");
        if (form.has_checksums)
            add("checksum", string_type(checksum_size), "SHA-256 of the row",
                nullptr, "");
    };
    for (DatasetForm& number_form : number_forms(schema, rows)) {
        number_form.room = form.room;
        create_dataset(group, number_form);
        // Columns that selection needs come first, since they then survive
        // longest in a truncated file.
        if (++count == essential_numbers) add_accounts();
    }
}

OutcomeSchema Columns::read_schema(hid_t file, const std::string& name) {
    const Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose,
                       "open " + name);
    OutcomeSchema schema;
    schema.randomisations = Dataset(group, "randomisation").rows();
    schema.measured = read_measured(group);
    return schema;
}

Columns::Columns(hid_t file, const std::string& group,
                 const OutcomeSchema& schema)
    : schema_(schema),
      status_(file, group + "/status"),
      genome_(file, group + "/genome"),
      origin_(file, group + "/origin"),
      parents_(file, group + "/parents"),
      intact_rows_(status_.rows()),
      whole_rows_(status_.rows()),
      attempt_(file, group + "/attempt"),
      seconds_(file, group + "/seconds"),
      worker_(file, group + "/worker"),
      message_(file, group + "/message") {
    for (const DatasetForm& form : number_forms(schema, ""))
        numbers_.emplace_back(file, group + "/" + form.name);
    intact_.assign(numbers_.size(), status_.rows());
    if (exists(file, group + "/checksum"))
        checksum_ = Dataset(file, group + "/checksum");
}

void Columns::use(const Mapping& mapping) {
    for (Dataset* column : {&status_, &genome_, &origin_, &parents_, &attempt_,
                            &seconds_, &worker_, &message_})
        column->use(mapping);
    for (Dataset& column : numbers_) column.use(mapping);
    if (checksum_) checksum_->use(mapping);
}

void Columns::cut(haddr_t end) {
    IDEOTYPE_EXPECT(numbers_.size() >= essential_numbers);
    for (std::size_t i = 0; i < numbers_.size(); ++i)
        intact_[i] = numbers_[i].rows_before(end);
    for (const Dataset* column : {&status_, &genome_, &origin_, &parents_})
        intact_rows_ = std::min(intact_rows_, column->rows_before(end));
    for (std::size_t i = 0; i < essential_numbers; ++i)
        intact_rows_ = std::min(intact_rows_, intact_[i]);
    whole_rows_ = std::min(intact_rows_, std::ranges::min(intact_));
    for (const Dataset* column : {&attempt_, &seconds_, &worker_, &message_})
        whole_rows_ = std::min(whole_rows_, column->rows_before(end));
}

std::vector<Candidate> Columns::candidates(hsize_t first, hsize_t count) const {
    const auto genes = genome_.read<double>(first, count);
    const auto origins = origin_.read<Origin>(first, count);
    const auto parents = parents_.read<std::int64_t>(first, count);
    std::vector<Candidate> candidates(count);
    auto gene = genes.begin();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        const auto end = gene + static_cast<std::ptrdiff_t>(genome_.width());
        candidates[i].genome.assign(gene, end);
        candidates[i].origin = origins[i];
        for (std::size_t p = 0; p < 2; ++p)
            candidates[i].parents[p] = parents[2 * i + p];
        gene = end;
    }
    return candidates;
}

std::vector<Outcome> Columns::outcomes(hsize_t first, hsize_t count) const {
    std::vector<std::vector<double>> columns;
    for (std::size_t c = 0; c < numbers_.size(); ++c) {
        columns.push_back(numbers_[c].read<double>(first, count));
        const hsize_t intact =
            std::clamp<hsize_t>(intact_[c], first, first + count) - first;
        std::fill(columns[c].begin() +
                      static_cast<std::ptrdiff_t>(intact * numbers_[c].width()),
                  columns[c].end(), nan);
    }
    std::vector<Outcome> outcomes(count, unknown_outcome(schema_));
    for (std::size_t i = 0; i < count; ++i) {
        const auto numbers = collect_numbers(schema_, outcomes[i]);
        IDEOTYPE_ENSURE(numbers.size() == columns.size());
        for (std::size_t c = 0; c < numbers.size(); ++c)
            for (std::size_t k = 0; k < numbers[c].size(); ++k)
                *numbers[c][k] = columns[c][i * numbers[c].size() + k];
    }
    return outcomes;
}

std::vector<Row> Columns::read(hsize_t first, hsize_t count) const {
    const auto status = statuses(first, count);
    auto candidate = candidates(first, count);
    auto outcome = outcomes(first, count);
    const auto attempt = attempt_.read<std::uint32_t>(first, count);
    const auto seconds = seconds_.read<double>(first, count);
    const auto worker = worker_.read<std::int32_t>(first, count);
    const auto message = message_.read_text(first, count);
    std::vector<Row> rows(count);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Row& row = rows[i];
        row.candidate.genome.assign(genome_.width(), nan);
        row.outcome = unknown_outcome(schema_);
        row.outcome.seconds = nan;
        if (status[i] != Status::empty) row.candidate = std::move(candidate[i]);
        if (is_recorded(status[i])) {
            row.attempt = attempt[i];
            row.outcome = std::move(outcome[i]);
            row.outcome.seconds = seconds[i];
            row.outcome.message = message[i];
            row.outcome.worker = static_cast<std::uint32_t>(worker[i]);
        }
        row.outcome.status = status[i];
    }
    return rows;
}

Population Columns::population(hsize_t first, hsize_t count) const {
    const auto status = statuses(first, count);
    auto candidate = candidates(first, count);
    // Objectives are the first numbers of number_forms().
    const std::size_t width = numbers_[0].width();
    const auto means = numbers_[0].read<double>(first, count);
    const auto errors = numbers_[1].read<double>(first, count);
    const std::size_t draws = numbers_[2].width();
    const auto randomisations = numbers_[2].read<double>(first, count);
    const auto violations = numbers_[3].read<double>(first, count);
    Population population(count);
    for (std::size_t i = 0; i < population.size(); ++i) {
        Individual& individual = population[i];
        individual.candidate = std::move(candidate[i]);
        individual.status = status[i];
        for (std::size_t o = i * width; o < (i + 1) * width; ++o)
            individual.objectives.push_back({means[o], errors[o]});
        individual.violation = violations[i];
        const auto begin =
            randomisations.begin() + static_cast<std::ptrdiff_t>(i * draws);
        individual.randomisations.assign(
            begin, begin + static_cast<std::ptrdiff_t>(draws));
    }
    return population;
}

void Columns::write(hsize_t first, const std::vector<Candidate>& candidates) {
    std::vector<double> genes;
    std::vector<Origin> origins;
    std::vector<std::int64_t> parents;
    for (const Candidate& candidate : candidates) {
        IDEOTYPE_EXPECT(candidate.genome.size() == genome_.width());
        genes.insert(genes.end(), candidate.genome.begin(),
                     candidate.genome.end());
        origins.push_back(candidate.origin);
        parents.insert(parents.end(), candidate.parents.begin(),
                       candidate.parents.end());
    }
    genome_.write(first, genes);
    origin_.write(first, origins);
    parents_.write(first, parents);
    // New rows are zeros. Write NaN, so that readers of a single column do not
    // mistake them for outcomes.
    const auto clear = [&](Dataset& column) {
        column.write(first, std::vector<double>(
                                candidates.size() * column.width(), nan));
    };
    for (Dataset& column : numbers_) clear(column);
    clear(seconds_);
    worker_.write(first,
                  std::vector<std::int32_t>(candidates.size(), no_worker));
}

void Columns::write_outcomes(hsize_t first, const std::vector<Row>& rows) {
    std::vector<std::vector<double>> columns(numbers_.size());
    std::vector<std::uint32_t> attempts;
    std::vector<double> seconds;
    std::vector<std::int32_t> workers;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Outcome& outcome = rows[i].outcome;
        IDEOTYPE_EXPECT(is_recorded(outcome.status));
        Outcome known =
            outcome.status == Status::done ? outcome : unknown_outcome(schema_);
        const auto numbers = collect_numbers(schema_, known);
        for (std::size_t c = 0; c < columns.size(); ++c)
            for (const double* x : numbers[c]) columns[c].push_back(*x);
        attempts.push_back(rows[i].attempt);
        seconds.push_back(outcome.seconds);
        workers.push_back(static_cast<std::int32_t>(outcome.worker));
        message_.write_text(first + i, outcome.message);
    }
    for (std::size_t c = 0; c < columns.size(); ++c)
        numbers_[c].write(first, columns[c]);
    attempt_.write(first, attempts);
    seconds_.write(first, seconds);
    worker_.write(first, workers);
}

void Columns::set_checksum(hsize_t row, const std::string& checksum) {
    IDEOTYPE_EXPECT(checksum.size() == checksum_size);
    if (checksum_) checksum_->write_text(row, checksum);
}

void Columns::set_statuses(hsize_t first, const std::vector<Status>& statuses) {
    // Other processors must see all numbers of a row before its status.
    std::atomic_thread_fence(std::memory_order_release);
    status_.write(first, statuses);
}

}  // namespace ideotype
