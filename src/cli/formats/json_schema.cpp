// SPDX-License-Identifier: Apache-2.0
#include "json_schema.hpp"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
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

//! Returns the schema of a list of items. If a key allows a single item instead
//! of a list, the schema allows it too.
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

//! Builds the schema of a key's value from its type.
struct TypeSchema {
    const Key& key;
    const Values& values = key.values;

    Json text() const {
        Json schema = {{"type", "string"}};
        // Names that a campaign file defines are unknown to the schema.
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
    Json operator()(const std::vector<TomlValue>*) const {
        return {{"type", "array"}, {"minItems", 1}};
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

//! Builds the schemas of tables. A table that occurs several times is written
//! once, as a definition; all occurrences refer to it.
class Tables {
  public:
    //! @param roots descriptions for which schemas are needed
    explicit Tables(std::span<const Description* const> roots) {
        for (const Description* root : roots) count(*root);
    }

    //! Returns the schema of objects that contain the keys and tables of a
    //! description.
    //! @param path path of this schema in the document
    Json object(const Description& description, const std::string& path) {
        Json schema = {{"type", "object"}, {"additionalProperties", false}};
        add(schema, description, path);
        return schema;
    }

    //! Adds the keys and tables of a description to a schema of objects.
    void add(Json& schema, const Description& description,
             const std::string& path) {
        Json& properties = schema["properties"];
        for (const Key& key : description.keys()) {
            properties[key.name] = key_schema(key, description.usual());
            // Trait sets may be empty if components are optimised.
            if (key.initial.is_required && !*key.unless &&
                key.values.names != Names::traits)
                schema["required"].push_back(key.name);
        }
        for (const Table& table : description.tables()) {
            if (table.entry_name) {
                schema["additionalProperties"] =
                    object(*table.description, path + "/additionalProperties");
                continue;
            }
            const auto key = properties.find(table.name);
            properties[table.name] =
                of(table, key == properties.end() ? nullptr : &*key,
                   path + "/properties/" + table.name);
            if (is_required(table, description))
                schema["required"].push_back(table.name);
        }
    }

    //! Returns the definitions to which schemas refer.
    const Json& definitions() const { return definitions_; }

  private:
    void count(const Description& description) {
        if (++uses_[&description] > 1) return;
        for (const Table& table : description.tables())
            count(*table.description);
    }

    static bool is_required(const Table& table, const Description& parent) {
        return !table.is_optional && !*table.unless && !table.text &&
               (!table.is_list || table.size(parent.usual()) == 0) &&
               std::ranges::any_of(
                   table.description->keys(),
                   [](const Key& each) { return each.initial.is_required; });
    }

    //! Returns the schema of one record of a table, or a reference to it.
    Json record(const Description& description, const std::string& path) {
        if (&description == &crop_table) return crop_reference;
        if (&description == &own_bounds_table)
            return {{"type", "object"},
                    {"additionalProperties",
                     key_schema(own_bounds_table.keys().front(),
                                own_bounds_table.usual())}};
        if (uses_.at(&description) == 1) return object(description, path);
        const std::string name(description.section);
        const auto [named, is_new] = named_.emplace(name, &description);
        if (named->second != &description)
            throw Error("two tables that stand at several places are called " +
                        name);
        const std::string place = "#/$defs/" + name;
        if (is_new) definitions_[name] = object(description, place);
        return {{"$ref", place}};
    }

    //! Returns the schema of a table or of a list of tables. If a text (a file
    //! or a rule) may replace the table, the schema allows it too.
    Json of(const Table& table, const Json* of_key, const std::string& path) {
        if (of_key && table.text)
            return {{"anyOf",
                     {*of_key, record(*table.description, path + "/anyOf/1")}},
                    {"description", (*of_key)["description"]}};
        if (!table.is_list || table.text)
            return record(*table.description, path);
        // A list with one table may be written as that table. Editors complete
        // keys in both forms only if a single schema describes them. Therefore
        // the schema of the items is the whole schema, restricted to objects.
        Json both = object(*table.description, path);
        both["type"] = {"array", "object"};
        both["items"] = {{"$ref", path}, {"type", "object"}};
        both["maxItems"] = table.most;
        return both;
    }

    std::map<const Description*, std::size_t> uses_;
    std::map<std::string, const Description*> named_;
    Json definitions_;
};

}  // namespace

Json campaign_schema() {
    Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                   {"title", title}};
    const std::array roots{&spec_table, &crop_table, &crop_leaves_table,
                           &crop_variation_table};
    Tables tables(roots);
    schema.update(tables.object(spec_table, "#"));
    const std::string path = crop_reference["$ref"];
    Json crop = tables.object(crop_table, path);
    tables.add(crop, crop_leaves_table, path);
    crop["properties"]["variation"] =
        tables.object(crop_variation_table, path + "/properties/variation");
    schema["$defs"] = tables.definitions();
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
