// SPDX-License-Identifier: Apache-2.0
#include "genome_request.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/core/text.hpp"
#include "ideotype/core/version.hpp"
#include "spec/writer.hpp"
#include "stand/stand.hpp"

namespace ideotype {

namespace {

const std::vector<std::string> keys{
    "id", "genome", "seed", "generation", "tolerance", "final", "quantities"};

//! Returns a message such as "there is no 'x'; did you mean 'y'?".
std::string unknown(const std::string& kind, const std::string& word,
                    const std::vector<std::string>& names) {
    return fmt::format("there is no {} '{}'; {}", kind, word,
                       did_you_mean(word, names));
}

std::string beginning(const Json& json) {
    constexpr std::size_t enough = 60;
    const std::string text = to_line(json);
    return text.size() > enough ? first_bytes(text, enough) + " ..." : text;
}

[[noreturn]] void refuse(const std::string& subject,
                         const std::string& expected, const Json& value) {
    throw Error(fmt::format("{} must be {}, but it is {}", subject, expected,
                            beginning(value)));
}

std::uint64_t whole_number(const Json& json, const char* key,
                           std::uint64_t largest) {
    if (!json.is_number_unsigned() || json.get<std::uint64_t>() > largest)
        refuse(key, fmt::format("a whole number from 0 to {}", largest), json);
    return json.get<std::uint64_t>();
}

double number(const Json& json, const char* key) {
    if (!json.is_number()) refuse(key, "a number", json);
    return json.get<double>();
}

//! Reads the values of all genes. Missing genes that are not free get the value
//! of the baseline.
Genome read_genome(const Json& json, const ServedCase& served) {
    const GeneSpace& genes = served.genes;
    if (!json.is_array()) refuse("genome", "an array of numbers", json);
    const std::size_t free = count_free(genes);
    if (json.size() != genes.size() && json.size() != free)
        throw Error(fmt::format(
            "genome has {} numbers; it must have {} for all genes{}",
            json.size(), genes.size(),
            free == genes.size()
                ? std::string()
                : fmt::format(", or {} for the free genes only", free)));
    Genome genome = served.baseline;
    std::size_t next = 0;
    for (std::size_t i = 0; i < genes.size(); ++i) {
        if (json.size() != genes.size() && !genes[i].is_free) continue;
        const Json& value = json[next++];
        if (!value.is_number())
            refuse(fmt::format("number {} of genome ({})", next, genes[i].name),
                   "a number", value);
        genome[i] = value.get<double>();
    }
    return genome;
}

std::vector<std::string> read_quantities(const Json& json,
                                         const QuantitySet& measured) {
    std::vector<std::string> names, all;
    if (!json.is_array()) refuse("quantities", "an array of names", json);
    for (const Quantity& each : measured.quantities) all.push_back(each.name);
    for (const Json& name : json) {
        if (!name.is_string()) refuse("quantities", "names", name);
        names.push_back(name.get<std::string>());
        if (!measured.has(names.back()))
            throw Error(unknown("quantity", names.back(), all));
    }
    return names;
}

//! Arranges numbers along axes as nested arrays. Without axes, returns the
//! number itself.
//! @param next first number to use; advanced past the last number used
template <class Number>
Json along(const std::vector<std::size_t>& sizes, std::size_t axis,
           std::vector<Estimate>::const_iterator& next, Number number) {
    if (axis == sizes.size()) return number(*next++);
    Json list = Json::array();
    for (std::size_t i = 0; i < sizes[axis]; ++i)
        list.push_back(along(sizes, axis + 1, next, number));
    return list;
}

Json quantity_json(const std::string& name, const Outcome& outcome,
                   const QuantitySet& measured) {
    const Quantity& quantity =
        *std::ranges::find(measured.quantities, name, &Quantity::name);
    std::vector<std::size_t> sizes;
    for (const std::string& axis : quantity.axes)
        sizes.push_back(measured.axis(axis).size());
    const auto first = outcome.quantities.begin() +
                       static_cast<std::ptrdiff_t>(measured.offset(name));
    auto means = first, errors = first;
    return {{"mean",
             along(sizes, 0, means, [](const Estimate& x) { return x.mean; })},
            {"standard_error", along(sizes, 0, errors, [](const Estimate& x) {
                 return x.standard_error;
             })}};
}

Json head(const Json& id, std::uint64_t line, const char* status) {
    return {{"id", id}, {"line", line}, {"status", status}};
}

}  // namespace

ServedCase::ServedCase(const Campaign& served, int index,
                       const std::string& path)
    : campaign(served),
      chosen(case_at(served, index, path)),
      genes(gene_space(served, chosen)),
      baseline(baseline_genome(served)),
      schema(outcome_schema(served, chosen, served.sampling)) {
    schema.randomisations = 0;
}

Json hello(const ServedCase& served, int workers) {
    Json json{{"ideotype", build_info().version},
              {"campaign", served.campaign.spec.name},
              {"case", served.chosen.name},
              {"case_index", served.chosen.index},
              {"workers", workers}};
    json["genes"] = Json::array();
    for (std::size_t i = 0; i < served.genes.size(); ++i) {
        const Gene& gene = served.genes[i];
        json["genes"].push_back({{"name", gene.name},
                                 {"trait", gene.trait},
                                 {"leaf", gene.leaf},
                                 {"unit", gene.unit},
                                 {"lower", gene.lower},
                                 {"upper", gene.upper},
                                 {"baseline", served.baseline[i]},
                                 {"is_free", gene.is_free},
                                 {"is_circular", gene.is_circular}});
    }
    json["accuracy"] = Json::array();
    for (const AccuracyKey& key : accuracy_keys(served.campaign.spec))
        json["accuracy"].push_back(
            {{"key", key.path}, {"value", key.value}, {"values", key.values}});
    for (const Objective& objective : served.schema.objectives)
        json["objectives"].push_back(
            {{"name", objective.name},
             {"unit", objective.unit},
             {"sense",
              objective.sense == Sense::maximise ? "maximise" : "minimise"}});
    for (const Axis& axis : served.schema.measured.axes)
        json["axes"].push_back(
            {{"name", axis.name},
             {"unit", axis.unit},
             {"coordinates",
              std::visit([](const auto& all) { return Json(all); },
                         axis.coordinates)}});
    for (const Quantity& quantity : served.schema.measured.quantities)
        json["quantities"].push_back({{"name", quantity.name},
                                      {"unit", quantity.unit},
                                      {"meaning", quantity.meaning},
                                      {"axes", quantity.axes}});
    return json;
}

Json parse_line(const std::string& text) try {
    static constexpr int deepest = 8;
    return Json::parse(text, [](int depth, Json::parse_event_t, Json&) {
        if (depth > deepest)
            throw Error(
                fmt::format("brackets are nested more than {} deep", deepest));
        return true;
    });
} catch (const Json::exception& error) {
    // The message begins with "[json.exception.parse_error.101] parse error at
    // line 1, ...".
    const std::string reason = error.what();
    const std::size_t column = reason.find("column ");
    throw Error(fmt::format(
        "this line is not valid JSON ({})",
        reason.substr(column == std::string::npos ? reason.find("] ") + 2
                                                  : column)));
}

Json id_of(const Json& json) {
    return json.is_object() && json.contains("id") ? json["id"] : Json();
}

GenomeRequest read_request(const Json& json, const ServedCase& served) {
    if (!json.is_object())
        refuse("a line", "an object such as {\"id\": 1, \"genome\": [...]}",
               json);
    for (const auto& [key, value] : json.items())
        if (std::ranges::find(keys, key) == keys.end())
            throw Error(unknown("key", key, keys));
    if (!json.contains("genome"))
        throw Error("genome is missing; it is an array of numbers");
    GenomeRequest request{id_of(json), 0, read_genome(json["genome"], served)};
    Task& task = request.task;
    constexpr auto largest = std::numeric_limits<std::int64_t>::max();
    if (json.contains("seed"))
        task.seed = whole_number(json["seed"], "seed", largest);
    if (json.contains("generation"))
        task.generation = static_cast<std::uint32_t>(
            whole_number(json["generation"], "generation",
                         std::numeric_limits<std::uint32_t>::max()));
    if (json.contains("tolerance"))
        task.tolerance = number(json["tolerance"], "tolerance");
    if (json.contains("final")) {
        if (!json["final"].is_boolean())
            refuse("final", "true or false", json["final"]);
        task.is_final = json["final"].get<bool>();
    }
    if (json.contains("quantities"))
        request.quantities =
            read_quantities(json["quantities"], served.schema.measured);
    // This throws if the requested accuracy is impossible.
    static_cast<void>(accuracy_of(task, served.campaign));
    return request;
}

Json answer(const GenomeRequest& request, const Outcome& outcome,
            const OutcomeSchema& schema) {
    if (outcome.status != Status::done) {
        Json json = refusal(request.id, request.line, outcome.message);
        json["seconds"] = outcome.seconds;
        return json;
    }
    Json json = head(request.id, request.line, "done");
    for (std::size_t i = 0; i < schema.objectives.size(); ++i)
        json["objectives"][schema.objectives[i].name] =
            to_json(outcome.objectives[i]);
    json["violation"] = outcome.violation;
    json["quantities"] = Json::object();
    for (const std::string& each : request.quantities)
        json["quantities"][each] =
            quantity_json(each, outcome, schema.measured);
    json["rank"] = outcome.worker;
    json["seconds"] = outcome.seconds;
    return json;
}

Json refusal(const Json& id, std::uint64_t line, const std::string& message) {
    Json json = head(id, line, "failed");
    json["message"] = message;
    return json;
}

}  // namespace ideotype
