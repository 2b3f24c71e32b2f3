#include "columns.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "attributes.hpp"
#include "contents.hpp"
#include "types.hpp"

namespace ideotype {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::int32_t no_worker = -1;
constexpr std::size_t message_size = 160;
constexpr std::size_t checksum_size = 64;
constexpr auto error_suffix = "_standard_error";

// Of these columns, the first ones, all that selection needs is made.
constexpr std::size_t essential_numbers = 4;

// The columns of an outcome's numbers, in the order of numbers_of().
std::vector<DatasetForm> number_forms(const OutcomeSchema& schema,
                                      const std::string& rows) {
    std::vector<DatasetForm> forms;
    const auto add = [&](const std::string& name,
                         const std::vector<std::string>& axes,
                         const std::string& unit, const std::string& meaning) {
        forms.push_back({.name = name,
                         .type = H5T_IEEE_F64LE,
                         .axes = {rows},
                         .unit = unit,
                         .meaning = meaning,
                         .empty = &nan});
        forms.back().axes.insert(forms.back().axes.end(), axes.begin(),
                                 axes.end());
    };
    const std::string unit = "/objectives/unit";
    add("objectives", {"objective"}, unit, "what is searched for");
    add("objectives_standard_error", {"objective"}, unit,
        "of the mean over randomisations");
    add("objectives_by_randomisation", {"objective", "randomisation"}, unit,
        "independent randomisations, common to rows that are compared");
    add("violation", {}, "1",
        "how far constraints are failed, relative to their limits");
    for (const Quantity& each : schema.measured.quantities) {
        add(each.name, each.axes, each.unit, each.meaning);
        if (each.certainty == Certainty::estimated)
            add(each.name + error_suffix, each.axes, each.unit,
                "standard error: " + each.meaning);
    }
    return forms;
}

// Row-major numbers of one row for each of number_forms().
using Numbers = std::vector<std::vector<double>>;

std::vector<double> part(std::span<const Estimate> estimates,
                         double Estimate::*member) {
    std::vector<double> values;
    for (const Estimate& x : estimates) values.push_back(x.*member);
    return values;
}

Numbers numbers_of(const OutcomeSchema& schema, const Outcome& outcome) {
    Numbers numbers{part(outcome.objectives, &Estimate::mean),
                    part(outcome.objectives, &Estimate::standard_error),
                    outcome.randomisations,
                    {outcome.violation}};
    std::span<const Estimate> left(outcome.quantities);
    for (const Quantity& each : schema.measured.quantities) {
        const std::size_t size = schema.measured.size(each);
        const auto own = left.first(size);
        left = left.subspan(size);
        numbers.push_back(part(own, &Estimate::mean));
        if (each.certainty == Certainty::estimated)
            numbers.push_back(part(own, &Estimate::standard_error));
    }
    return numbers;
}

// Takes the numbers of an outcome, one after the other, in the order of
// numbers_of(); next gives those of the next column.
template <class Next>
Outcome outcome_of(const OutcomeSchema& schema, Next next) {
    Outcome outcome = unknown_outcome(schema);
    const auto fill = [&](std::span<Estimate> target, double Estimate::*member,
                          std::span<const double> values) {
        for (std::size_t i = 0; i < target.size(); ++i)
            target[i].*member = values[i];
    };
    fill(outcome.objectives, &Estimate::mean, next());
    fill(outcome.objectives, &Estimate::standard_error, next());
    const std::span<const double> randomisations = next();
    outcome.randomisations.assign(randomisations.begin(), randomisations.end());
    outcome.violation = next()[0];
    std::span<Estimate> left(outcome.quantities);
    for (const Quantity& each : schema.measured.quantities) {
        const std::size_t size = schema.measured.size(each);
        const auto own = left.first(size);
        left = left.subspan(size);
        fill(own, &Estimate::mean, next());
        if (each.certainty == Certainty::estimated)
            fill(own, &Estimate::standard_error, next());
        else
            for (Estimate& x : own) x.standard_error = 0;
    }
    return outcome;
}

// "lai absorbed_by_leaf[leaf]": names and axes in the order of a schema. In
// a file that is cut short this is there when the scales' references are not.
std::string text_of(const std::vector<Quantity>& quantities) {
    std::string text;
    for (const Quantity& each : quantities)
        text += fmt::format(
            "{}{}{}", text.empty() ? "" : " ", each.name,
            each.axes.empty() ? ""
                              : fmt::format("[{}]", fmt::join(each.axes, ",")));
    return text;
}

std::vector<std::string> parts(const std::string& text, char separator) {
    std::istringstream from(text);
    std::vector<std::string> found;
    for (std::string part; std::getline(from, part, separator);)
        found.push_back(part);
    return found;
}

bool has(hid_t group, const std::string& name) {
    return checked(H5Lexists(group, name.c_str(), H5P_DEFAULT),
                   "look for " + name) != 0;
}

Quantity read_quantity(hid_t group, const std::string& text) {
    const std::size_t bracket = std::min(text.find('['), text.size());
    const std::string name = text.substr(0, bracket);
    const Dataset dataset(group, name);
    Quantity quantity{name, dataset.text("units"), dataset.text("long_name")};
    if (bracket < text.size())
        quantity.axes =
            parts(text.substr(bracket + 1, text.size() - bracket - 2), ',');
    if (!has(group, name + error_suffix)) quantity.certainty = Certainty::exact;
    return quantity;
}

}  // namespace

Axis gene_axis(const GeneSpace& genes) {
    std::vector<std::string> names;
    for (const Gene& gene : genes) names.push_back(gene.name);
    return {"gene", "", "gene of a genome", std::move(names)};
}

Axis objective_axis(const std::vector<Objective>& objectives) {
    std::vector<std::string> names;
    for (const Objective& each : objectives) names.push_back(each.name);
    return {"objective", "", "quantity that is searched for", std::move(names)};
}

void Columns::create(hid_t file, const GeneSpace& genes,
                     const OutcomeSchema& schema, const TableForm& form) {
    const Handle group = create_group(file, form.group);
    create_attribute(group, "quantities", text_of(schema.measured.quantities));
    create_axis(group, form.rows);
    create_axis(group, gene_axis(genes));
    create_axis(group, counted("parent", "first or second", 2));
    create_axis(group, objective_axis(schema.objectives));
    create_axis(group, counted("randomisation", "independent repetition",
                               schema.randomisations));
    for (const Axis& axis : schema.measured.axes) create_axis(group, axis);
    const std::string rows = form.rows.name;
    const auto add =
        [&](const std::string& name, hid_t type, const std::string& meaning,
            const void* empty = nullptr, const std::string& unit = "1",
            const std::vector<std::string>& axes = {}) {
            DatasetForm its{.name = name,
                            .type = type,
                            .axes = {rows},
                            .unit = unit,
                            .meaning = meaning,
                            .empty = empty,
                            .room = form.room};
            its.axes.insert(its.axes.end(), axes.begin(), axes.end());
            create_dataset(group, its);
        };
    // The status says which of the others mean something.
    create_dataset(group, {.name = "status",
                           .type = status_type(),
                           .axes = {rows},
                           .meaning = "how far the evaluation has come"});
    add("genome", H5T_IEEE_F64LE, "values of the genes", &nan, "/genes/unit",
        {"gene"});
    add("origin", origin_type(), "where the genome came from");
    const std::int64_t none = no_parent;
    add("parents", H5T_STD_I64LE, "rows of /evaluations, -1: none", &none, "1",
        {"parent"});
    std::size_t count = 0;
    const auto add_book = [&] {
        add("attempt", H5T_STD_U32LE, "from 1; 0: copied from an equal genome");
        add("seconds", H5T_IEEE_F64LE, "wall time of the evaluation", &nan,
            "s");
        add("worker", H5T_STD_I32LE, "rank that evaluated", &no_worker);
        add("message", string_type(message_size), "why it failed", nullptr, "");
        if (form.has_checksums)
            add("checksum", string_type(checksum_size), "SHA-256 of the row",
                nullptr, "");
    };
    for (DatasetForm& each : number_forms(schema, rows)) {
        each.room = form.room;
        create_dataset(group, each);
        // A file that is cut short keeps what selection needs for longest.
        if (++count == essential_numbers) add_book();
    }
}

OutcomeSchema Columns::read_schema(hid_t file, const std::string& name) {
    const Handle group(H5Gopen2(file, name.c_str(), H5P_DEFAULT), H5Gclose,
                       "open " + name);
    OutcomeSchema schema;
    schema.randomisations = Dataset(group, "randomisation").rows();
    auto& [axes, quantities] = schema.measured;
    for (const std::string& each :
         parts(text_attribute(group, "quantities"), ' '))
        quantities.push_back(read_quantity(group, each));
    for (const Quantity& quantity : quantities)
        for (const std::string& axis : quantity.axes)
            if (std::none_of(axes.begin(), axes.end(), [&](const Axis& known) {
                    return known.name == axis;
                }))
                axes.push_back(read_axis(group, axis));
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
      attempt_(file, group + "/attempt"),
      seconds_(file, group + "/seconds"),
      worker_(file, group + "/worker"),
      message_(file, group + "/message") {
    for (const DatasetForm& form : number_forms(schema, ""))
        numbers_.emplace_back(file, group + "/" + form.name);
    intact_.assign(numbers_.size(), status_.rows());
    if (has(file, group + "/checksum"))
        checksum_ = Dataset(file, group + "/checksum");
}

void Columns::cut(haddr_t end) {
    for (std::size_t i = 0; i < numbers_.size(); ++i)
        intact_[i] = numbers_[i].rows_before(end);
    for (const Dataset* column : {&status_, &genome_, &origin_, &parents_})
        intact_rows_ = std::min(intact_rows_, column->rows_before(end));
    for (std::size_t i = 0; i < essential_numbers; ++i)
        intact_rows_ = std::min(intact_rows_, intact_[i]);
}

std::vector<Status> Columns::statuses(hsize_t first, hsize_t count) const {
    return status_.read<Status>(first, count);
}

std::vector<Candidate> Columns::candidates(hsize_t first, hsize_t count,
                                           hsize_t base) const {
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
            if (const std::int64_t row = parents[2 * i + p]; row >= 0)
                candidates[i].parents[p] = static_cast<std::int32_t>(
                    row - static_cast<std::int64_t>(base));
        gene = end;
    }
    return candidates;
}

std::vector<Outcome> Columns::outcomes(hsize_t first, hsize_t count) const {
    Numbers columns;
    for (std::size_t c = 0; c < numbers_.size(); ++c) {
        columns.push_back(numbers_[c].read<double>(first, count));
        const hsize_t there =
            std::clamp<hsize_t>(intact_[c], first, first + count) - first;
        std::fill(columns[c].begin() +
                      static_cast<std::ptrdiff_t>(there * numbers_[c].width()),
                  columns[c].end(), nan);
    }
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t c = 0;
        outcomes.push_back(outcome_of(schema_, [&] {
            const std::size_t width = numbers_[c].width();
            return std::span<const double>(columns[c++])
                .subspan(i * width, width);
        }));
    }
    return outcomes;
}

std::vector<Row> Columns::read(hsize_t first, hsize_t count,
                               hsize_t parents) const {
    const auto status = statuses(first, count);
    auto candidate = candidates(first, count, parents);
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

void Columns::write(hsize_t first, const std::vector<Candidate>& candidates,
                    hsize_t base) {
    std::vector<double> genes;
    std::vector<Origin> origins;
    std::vector<std::int64_t> parents;
    for (const Candidate& candidate : candidates) {
        genes.insert(genes.end(), candidate.genome.begin(),
                     candidate.genome.end());
        origins.push_back(candidate.origin);
        for (const std::int32_t slot : candidate.parents)
            parents.push_back(slot == no_parent
                                  ? no_parent
                                  : static_cast<std::int64_t>(base) + slot);
    }
    genome_.write(first, genes);
    origin_.write(first, origins);
    parents_.write(first, parents);
    // Rows are zeros at first; a reader of a column alone shall not take them
    // for outcomes.
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
    Numbers columns(numbers_.size());
    std::vector<std::uint32_t> attempts;
    std::vector<double> seconds;
    std::vector<std::int32_t> workers;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Outcome& outcome = rows[i].outcome;
        const Numbers own = numbers_of(schema_, outcome.status == Status::done
                                                    ? outcome
                                                    : unknown_outcome(schema_));
        for (std::size_t c = 0; c < columns.size(); ++c)
            columns[c].insert(columns[c].end(), own[c].begin(), own[c].end());
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

void Columns::set_statuses(hsize_t first, const std::vector<Status>& statuses) {
    status_.write(first, statuses);
}

std::string Columns::checksum(hsize_t row) const {
    return checksum_ ? checksum_->read_text(row, 1)[0] : "";
}

void Columns::set_checksum(hsize_t row, const std::string& checksum) {
    if (checksum_) checksum_->write_text(row, checksum);
}

}  // namespace ideotype
