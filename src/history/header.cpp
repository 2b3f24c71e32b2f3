// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "columns.hpp"
#include "dataset.hpp"
#include "disk/open.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/enum_names.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/mapped.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

//! Writes kinds and values of genes; nothing if all genes are real.
void write_kinds(hid_t group, const GeneSpace& genes) {
    if (std::none_of(genes.begin(), genes.end(),
                     [](const Gene& gene) { return gene.is_discrete(); }))
        return;
    create_texts(group,
                 {.name = "kind",
                  .axes = {"gene"},
                  .meaning = "real, integer or choice"},
                 mapped(genes, [](const Gene& gene) -> std::string {
                     return name_of(gene.kind);
                 }));
    create_texts(group,
                 {.name = "values",
                  .axes = {"gene"},
                  .meaning = "values that lower, lower + 1, ... stand for, as "
                             "lines of TOML; empty if the number is the value"},
                 mapped(genes, [](const Gene& gene) {
                     return fmt::format("{}", fmt::join(gene.values, "\n"));
                 }));
}

void write_genes(hid_t file, const GeneSpace& genes) {
    for (const Gene& gene : genes) IDEOTYPE_EXPECT(gene.lower <= gene.upper);
    const Handle group = create_group(file, "genes");
    create_axis(group, gene_axis(genes));
    create_texts(
        group,
        {.name = "trait", .axes = {"gene"}, .meaning = "trait of the gene"},
        mapped(genes, &Gene::trait));
    create_texts(
        group,
        {.name = "unit", .axes = {"gene"}, .meaning = "unit of the gene"},
        mapped(genes, &Gene::unit));
    write_kinds(group, genes);
    // Adds a dataset with a number for each gene; `stored` has the type in the
    // file.
    const auto add = [&](const std::string& name, const std::string& meaning,
                         const std::string& unit, hid_t type, auto member,
                         auto stored) {
        create_dataset(group, {.name = name,
                               .type = type,
                               .axes = {"gene"},
                               .unit = unit,
                               .meaning = meaning});
        Dataset(group, name).write(0, mapped(genes, [&](const Gene& gene) {
                                       return static_cast<decltype(stored)>(
                                           gene.*member);
                                   }));
    };
    const std::string gene_unit = "/genes/unit";
    add("leaf", "leaf rank, 1 is the lowest, 0 the whole plant", "1",
        H5T_STD_I32LE, &Gene::leaf, std::int32_t{});
    add("lower", "lower bound", gene_unit, H5T_IEEE_F64LE, &Gene::lower,
        double{});
    add("upper", "upper bound", gene_unit, H5T_IEEE_F64LE, &Gene::upper,
        double{});
    add("is_circular", "whether the lower and upper bound are the same point",
        "1", bool_type(), &Gene::is_circular, std::int8_t{});
    add("is_free",
        "whether the gene is bred; others keep the value of the baseline", "1",
        bool_type(), &Gene::is_free, std::int8_t{});
}

std::vector<std::string> read_texts(hid_t file, const std::string& name) {
    const Dataset dataset(file, name);
    return dataset.read_text(0, dataset.rows());
}

GeneKind kind_of(const std::string& name) {
    if (const auto kind = value_named<GeneKind>(name)) return *kind;
    throw Error("genes/kind: there is no kind \"" + name + "\"");
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

GeneSpace read_genes(hid_t file) {
    const auto names = read_texts(file, "genes/gene");
    const auto traits = read_texts(file, "genes/trait");
    const auto units = read_texts(file, "/genes/unit");
    const auto numbers = [&]<class Number>(const std::string& name, Number) {
        return Dataset(file, "genes/" + name).read<Number>(0, names.size());
    };
    const auto leaves = numbers("leaf", std::int32_t{});
    const auto lower = numbers("lower", double{});
    const auto upper = numbers("upper", double{});
    const auto is_circular = numbers("is_circular", std::int8_t{});
    const auto is_free = numbers("is_free", std::int8_t{});
    GeneSpace genes;
    for (std::size_t i = 0; i < names.size(); ++i)
        genes.push_back({names[i], units[i], lower[i], upper[i],
                         is_circular[i] != 0, is_free[i] != 0, traits[i],
                         leaves[i]});
    // Files without kinds have only real genes.
    if (!exists(file, "genes/kind")) return genes;
    const auto kinds = read_texts(file, "genes/kind");
    const auto values = read_texts(file, "genes/values");
    for (std::size_t i = 0; i < genes.size(); ++i) {
        genes[i].kind = kind_of(kinds[i]);
        genes[i].values = lines_of(values[i]);
    }
    return genes;
}

std::string get_name(Sense sense) {
    return sense == Sense::maximise ? "maximise" : "minimise";
}

void write_objectives(hid_t file, const std::vector<Objective>& objectives) {
    const Handle group = create_group(file, "objectives");
    create_axis(group, objective_axis(objectives));
    create_texts(group,
                 {.name = "unit",
                  .axes = {"objective"},
                  .meaning = "unit of the objective"},
                 mapped(objectives, &Objective::unit));
    create_texts(group,
                 {.name = "sense",
                  .axes = {"objective"},
                  .meaning = "whether larger or smaller is better"},
                 mapped(objectives, [](const Objective& objective) {
                     return get_name(objective.sense);
                 }));
}

std::vector<Objective> read_objectives(hid_t file) {
    const auto names = read_texts(file, "objectives/objective");
    const auto units = read_texts(file, "objectives/unit");
    const auto senses = read_texts(file, "objectives/sense");
    std::vector<Objective> objectives;
    for (std::size_t i = 0; i < names.size(); ++i)
        objectives.push_back({names[i], units[i],
                              senses[i] == get_name(Sense::minimise)
                                  ? Sense::minimise
                                  : Sense::maximise});
    return objectives;
}

void create_campaign_text(hid_t group, const std::string& name,
                          const std::string& text) {
    const Handle type = string_type(text.size());
    create_dataset(group, {.name = name, .type = type, .unit = ""});
    Dataset(group, name).write_text(0, text);
}

void read_attributes(hid_t file, HistoryHeader& header) {
    for (const std::string& name : list_attributes(file)) {
        const H5T_class_t kind = H5Tget_class(Attribute(file, name).type);
        if (kind == H5T_STRING) header.text[name] = text_attribute(file, name);
        if (kind == H5T_FLOAT)
            header.numbers[name] =
                number_attribute<double>(file, name, H5T_NATIVE_DOUBLE);
    }
    header.seed =
        number_attribute<std::uint64_t>(file, "seed", H5T_NATIVE_UINT64);
    for (const auto& [name, number] :
         {std::pair{"population", &header.population},
          {"generations", &header.generations},
          {"finalists", &header.finalists}})
        *number = number_attribute<int>(file, name, H5T_NATIVE_INT);
}

}  // namespace

void write_header(hid_t file, const HistoryHeader& header) {
    IDEOTYPE_EXPECT(header.population > 0 && header.generations > 0);
    IDEOTYPE_EXPECT(header.finalists >= 0 && header.final_randomisations > 0);
    create_attribute(file, "format", format_name);
    create_attribute(file, "format_version", format_version);
    create_attribute(file, "seed", H5T_NATIVE_UINT64, &header.seed);
    const int rows = header.rows();
    for (const auto& [name, number] :
         {std::pair{"population", &header.population},
          {"generations", &header.generations},
          {"finalists", &header.finalists},
          {"rows", &rows}})
        create_attribute(file, name, H5T_NATIVE_INT, number);
    for (const auto& [name, text] : header.text)
        create_attribute(file, name, text);
    for (const auto& [name, number] : header.numbers)
        create_attribute(file, name, H5T_NATIVE_DOUBLE, &number);
    const Handle campaign = create_group(file, "campaign");
    create_campaign_text(campaign, "source", header.campaign_source);
    create_campaign_text(campaign, "resolved", header.campaign_resolved);
    write_genes(file, header.genes);
    write_objectives(file, header.schema.objectives);
}

HistoryHeader read_header(hid_t file) {
    HistoryHeader header;
    read_attributes(file, header);
    header.campaign_source = read_texts(file, "campaign/source")[0];
    header.campaign_resolved = read_texts(file, "campaign/resolved")[0];
    header.genes = read_genes(file);
    header.schema = Columns::read_schema(file, "evaluations");
    header.schema.objectives = read_objectives(file);
    header.final_randomisations =
        Columns::read_schema(file, "final").randomisations;
    return header;
}

}  // namespace ideotype
