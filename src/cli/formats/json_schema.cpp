// SPDX-License-Identifier: Apache-2.0
#include "json_schema.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "spec/tables.hpp"
#include "spec/writer.hpp"

namespace ideotype {

namespace {

constexpr const char* title = "Campaign of ideotype";

const Json crop_reference = {{"$ref", "#/$defs/crop"}};

Json number_schema(const Values& values, const char* type) {
    Json schema = {{"type", type}};
    if (values.lower == values.upper) return schema;
    schema["minimum"] = values.lower;
    schema["maximum"] = values.upper;
    return schema;
}

//! Returns a list of items, or one item where a key allows that.
Json list_schema(const Values& values, const Json& item) {
    Json list = {{"type", "array"}, {"items", item}};
    if (values.count == any_count) return {{"anyOf", {item, list}}};
    if (values.count > 0) list["minItems"] = list["maxItems"] = values.count;
    return list;
}

Json pair_schema(const Json& item) {
    return {
        {"type", "array"}, {"items", item}, {"minItems", 2}, {"maxItems", 2}};
}

//! Returns the schema of the type of a key's value.
struct TypeSchema {
    const Key& key;
    const Values& values = key.values;

    Json text() const {
        Json schema = {{"type", "string"}};
        // Texts that a file determines are not known here.
        if (values.names != Names::none && values.names != Names::objectives)
            return schema;
        const std::vector<std::string> allowed = allowed_texts(key);
        if (!allowed.empty() && values.names == Names::none)
            schema["enum"] = allowed;
        if (values.form == Form::name)
            schema["pattern"] = "^[A-Za-z0-9][A-Za-z0-9_-]{0,63}$";
        return schema;
    }
    Json date() const { return {{"type", "string"}, {"format", "date"}}; }

    Json operator()(std::monostate) const { return {{"type", "string"}}; }
    Json operator()(const std::string*) const { return text(); }
    Json operator()(const Choice&) const { return text(); }
    Json operator()(const bool*) const { return {{"type", "boolean"}}; }
    Json operator()(const Date*) const { return date(); }
    Json operator()(const std::vector<Date>*) const {
        return {
            {"anyOf",
             {date(),
              Json{{"type", "array"}, {"items", date()}, {"minItems", 1}}}}};
    }
    Json operator()(const double*) const {
        const Json number = number_schema(values, "number");
        if (values.form == Form::clock) return {{"type", "string"}};
        if (values.form == Form::duration)
            return {{"anyOf", {number, Json{{"type", "string"}}}}};
        return number;
    }
    Json operator()(const Range*) const {
        return pair_schema(number_schema(values, "number"));
    }
    Json operator()(const Column*) const {
        return pair_schema({{"type", "string"}});
    }
    Json operator()(const std::vector<glm::dvec2>*) const {
        return {{"type", "array"},
                {"items", pair_schema(number_schema(values, "number"))}};
    }
    Json operator()(const std::vector<double>*) const {
        return list_schema(values, number_schema(values, "number"));
    }
    Json operator()(const std::vector<std::string>*) const {
        return list_schema(values, text());
    }
    template <class Value>
    Json operator()(const std::optional<Value>*) const {
        return (*this)(static_cast<const Value*>(nullptr));
    }
    template <class Integer>
    Json operator()(const Integer*) const {
        Json number = number_schema(values, "integer");
        if (std::is_unsigned_v<Integer>) number.emplace("minimum", 0);
        return number;
    }
};

Json key_schema(const Key& key, const void* usual) {
    Json schema =
        std::visit(TypeSchema{key}, key.place(const_cast<void*>(usual)));
    std::string about = key.meaning;
    if (*key.values.unit) about += fmt::format(" [{}]", key.values.unit);
    if (!key.initial.is_required)
        about += "; default: " + default_text(key, usual);
    schema["description"] = about;
    return schema;
}

Json object_schema(const Description& description);

//! Returns the schema of a table, a list of tables, or a table that a key names
//! as a file or a rule.
Json table_schema(const Table& table, const Json* of_key) {
    Json one = table.description == &crop_table
                   ? crop_reference
                   : object_schema(*table.description);
    if (table.description == &own_bounds_table)
        one = {
            {"type", "object"},
            {"additionalProperties", key_schema(own_bounds_table.keys().front(),
                                                own_bounds_table.usual())}};
    if (of_key && table.text)
        return {{"anyOf", {*of_key, one}},
                {"description", (*of_key)["description"]}};
    if (!table.is_list || table.text) return one;
    // A list of one table may be written as that table. Editors complete keys
    // of both forms only where these stand side by side.
    Json both = one;
    both["type"] = {"array", "object"};
    both["items"] = one;
    both["maxItems"] = table.most;
    return both;
}

//! Adds the keys and tables of a description to a schema of objects.
void add(Json& schema, const Description& description) {
    Json& properties = schema["properties"];
    for (const Key& key : description.keys()) {
        properties[key.name] = key_schema(key, description.usual());
        // Sets of traits may be empty where components are bred.
        if (key.initial.is_required && !*key.unless &&
            key.values.names != Names::traits)
            schema["required"].push_back(key.name);
    }
    for (const Table& table : description.tables()) {
        if (table.entry_name) {
            schema["additionalProperties"] = object_schema(*table.description);
            continue;
        }
        const auto key = properties.find(table.name);
        properties[table.name] =
            table_schema(table, key == properties.end() ? nullptr : &*key);
        const auto keys = table.description->keys();
        if (!table.is_optional && !*table.unless && !table.text &&
            (!table.is_list || table.size(description.usual()) == 0) &&
            std::ranges::any_of(
                keys, [](const Key& each) { return each.initial.is_required; }))
            schema["required"].push_back(table.name);
    }
}

Json object_schema(const Description& description) {
    Json schema = {{"type", "object"}, {"additionalProperties", false}};
    add(schema, description);
    return schema;
}

}  // namespace

Json campaign_schema() {
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", title}};
    schema.update(object_schema(spec_table));
    Json crop = object_schema(crop_table);
    add(crop, crop_leaves_table);
    crop["properties"]["variation"] = object_schema(crop_variation_table);
    schema["$defs"]["crop"] = crop;
    return schema;
}

std::string campaign_schema_text() {
    return to_text(campaign_schema()) + '\n';
}

bool is_campaign_schema(const std::string& text) {
    const Json json = Json::parse(text, nullptr, false);
    return json.is_object() && json.contains("title") && json["title"] == title;
}

}  // namespace ideotype
