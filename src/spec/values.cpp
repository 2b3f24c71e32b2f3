// SPDX-License-Identifier: Apache-2.0
#include "values.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "ideotype/core/clock.hpp"
#include "nodes.hpp"
#include "spelling.hpp"
#include "writer.hpp"

namespace ideotype {

namespace {

//! Reads a node into the value that a target points to. Functions that return
//! nothing have already reported the fault.
struct Reader : ValueFaults {
    const toml::node& node;
    std::vector<std::string> choices;  //!< allowed texts; none: any text
    bool is_needed = false;            //!< whether the key must be given

    //! Returns an integer or floating-point number, if it is in range.
    std::optional<double> number(const toml::node& source) const {
        double plain = 0;
        if (const auto* integer = source.as_integer())
            plain = static_cast<double>(integer->get());
        else if (const auto* decimal = source.as_floating_point())
            plain = decimal->get();
        else
            return fail_type(source), std::nullopt;
        // Adding zero turns -0 into 0, so that equal values have equal texts.
        const double value = plain + 0.0;
        if (!accepts(value)) return std::nullopt;
        return value;
    }

    std::optional<std::vector<std::string>> texts(std::size_t count) const {
        const toml::array* array = node.as_array();
        if (!array || array->size() != count)
            return fail_type(node), std::nullopt;
        std::vector<std::string> values;
        for (const toml::node& element : *array) {
            const auto text = element.value<std::string>();
            if (!text) return fail_type(element), std::nullopt;
            values.push_back(*text);
        }
        return values;
    }

    std::optional<std::vector<double>> numbers(std::size_t count) const {
        const toml::array* array = node.as_array();
        if (!array && count == any_count && node.is_number()) {
            const auto value = number(node);
            if (!value) return std::nullopt;
            return std::vector{*value};
        }
        if (!array || (array->empty() && key.values.is_filled))
            return fail_type(node), std::nullopt;
        std::vector<double> values;
        for (const toml::node& element : *array)
            if (const auto value = number(element)) values.push_back(*value);
        if (count == any_count || count == 0) count = array->size();
        if (array->size() != count)
            fail(wrong_type, "has {} values (expected: {}); give {} of them",
                 array->size(), key.values.type, count);
        if (values.size() != count) return std::nullopt;
        return values;
    }

    void operator()(std::monostate) const {}

    std::optional<std::string> one_of_choices() const {
        const auto text = node.value<std::string>();
        if (!text) return fail_type(node), std::nullopt;
        if (std::ranges::count(choices, *text) > 0) return text;
        fail(unknown_name, "is \"{}\" (not one of its values); {}", *text,
             nearest_name(*text, choices).empty()
                 ? fmt::format("use \"{}\"", fmt::join(choices, "\" or \""))
                 : did_you_mean(*text, choices));
        return std::nullopt;
    }

    void operator()(const Choice& choice) const {
        if (const auto found = one_of_choices())
            choice.set(choice.value, *found);
    }

    void operator()(std::string* value) const {
        // A rule that is given as a table is read separately.
        if (key.values.form == Form::rule && node.is_table()) return;
        if (!choices.empty()) {
            if (const auto found = one_of_choices()) *value = *found;
            return;
        }
        const auto text = node.value<std::string>();
        if (!text) return fail_type(node);
        if (key.values.form == Form::name && !is_name(*text))
            return fail(out_of_range,
                        "is \"{}\" (allowed: {}); use for example \"{}\"",
                        *text, range_text(key), make_name(*text));
        *value = *text;
    }

    void operator()(std::uint64_t* value) const {
        const toml::value<std::int64_t>* integer_node = node.as_integer();
        if (!integer_node) return fail_type(node);
        if (integer_node->get() < 0)
            return fail(out_of_range,
                        "is {} (below the range {}); use 0 or more",
                        integer_node->get(), range_text(key));
        *value = static_cast<std::uint64_t>(integer_node->get());
    }

    //! Returns an integer, if it is in range.
    std::optional<std::int64_t> integer() const {
        if (!node.is_integer()) return fail_type(node), std::nullopt;
        if (!number(node)) return std::nullopt;
        return node.as_integer()->get();
    }

    void operator()(int* value) const {
        if (const auto found = integer()) *value = static_cast<int>(*found);
    }
    void operator()(long long* value) const {
        if (const auto found = integer()) *value = *found;
    }
    void operator()(std::optional<int>* value) const {
        if (const auto found = integer()) *value = static_cast<int>(*found);
    }

    void operator()(double* value) const {
        if (key.values.form == Form::clock) return clock(value);
        if (key.values.form == Form::duration && node.is_string())
            return duration(value);
        if (const auto found = number(node)) *value = *found;
    }

    void operator()(std::optional<std::string>* value) const {
        if (const auto found = one_of_choices()) *value = *found;
    }

    void operator()(std::optional<double>* value) const {
        if (const auto found = number(node)) *value = *found;
    }

    void operator()(std::optional<Column>* value) const {
        if (const auto found = texts(2))
            *value = Column{(*found)[0], (*found)[1]};
    }

    void clock(double* value) const {
        if (is_midnight(node.value<std::string>().value_or(""))) {
            *value = 24;
            return;
        }
        const toml::value<toml::time>* time_node = node.as_time();
        if (!time_node) return fail_type(node);
        const toml::time time = time_node->get();
        const double seconds = time.hour * 3600.0 + time.minute * 60.0 +
                               time.second + time.nanosecond * 1e-9;
        *value = seconds / 3600;
    }

    void duration(double* value) const {
        const std::string text = *node.value<std::string>();
        const auto seconds = parse_duration(text);
        if (!seconds)
            return fail(wrong_type,
                        "is \"{}\" (not a duration); write for example {} = {}",
                        text, key.name, key.initial.example);
        if (accepts(*seconds)) *value = *seconds;
    }

    void operator()(bool* value) const {
        const auto truth = node.value<bool>();
        if (!node.is_boolean() || !truth) return fail_type(node);
        *value = *truth;
    }

    std::optional<Date> date(const toml::node& source) const {
        const toml::value<toml::date>* date_node = source.as_date();
        if (!date_node) return fail_type(source), std::nullopt;
        const Date date{date_node->get().year, date_node->get().month,
                        date_node->get().day};
        if (date.year >= 1950 && date.year <= 2100) return date;
        fail(out_of_range, "is {} (outside the range {}); use a year within",
             to_string(date), range_text(key));
        return std::nullopt;
    }

    void operator()(Date* value) const {
        if (const auto found = date(node)) *value = *found;
    }

    void operator()(std::vector<Date>* value) const {
        const toml::array* array = node.as_array();
        if (!array) {
            if (const auto found = date(node)) *value = {*found};
            return;
        }
        if (array->empty()) return fail_type(node);
        for (const toml::node& element : *array) {
            const auto next = date(element);
            if (!next) return;
            if (!value->empty() && !(value->back() < *next))
                return fail(contradiction,
                            "has {} after {} (not in order); give each date "
                            "once, the earliest first",
                            to_string(*next), to_string(value->back()));
            value->push_back(*next);
        }
    }

    void operator()(Range* value) const {
        const auto limits = numbers(2);
        if (!limits) return;
        const double lower = (*limits)[0], upper = (*limits)[1];
        if (lower >= upper)
            return fail(contradiction,
                        "is [{}, {}] (the lower bound is not below the upper); "
                        "write [lower, upper]",
                        lower, upper);
        *value = {lower, upper};
    }

    void operator()(std::vector<glm::dvec2>* value) const {
        const toml::array* array = node.as_array();
        if (!array) return fail_type(node);
        for (const toml::node& element : *array) {
            const toml::array* pair = element.as_array();
            if (!pair || pair->size() != 2) return fail_type(element);
            const auto first = number((*pair)[0]), second = number((*pair)[1]);
            if (first && second) value->emplace_back(*first, *second);
        }
    }

    void operator()(std::vector<double>* value) const {
        if (const auto found = numbers(key.values.count)) *value = *found;
    }

    void operator()(std::vector<TomlValue>* value) const {
        const toml::array* array = node.as_array();
        if (!array || array->empty()) return fail_type(node);
        value->clear();
        for (const toml::node& element : *array)
            value->push_back({toml_of(element)});
    }

    void operator()(std::vector<std::string>* value) const {
        const toml::array* array = node.as_array();
        std::vector<std::string> texts;
        if (!array && key.values.count == any_count && node.is_string()) {
            add(node, texts);
            *value = texts;
            return;
        }
        if (!array) return fail_type(node);
        for (const toml::node& element : *array) add(element, texts);
        if (array->empty() && is_needed)
            fail(missing, "is empty (no trait could vary); name any of {}",
                 fmt::join(choices, ", "));
        *value = texts;
    }

    void add(const toml::node& element, std::vector<std::string>& texts) const {
        const auto text = element.value<std::string>();
        if (!text) return fail_type(element);
        const auto is_in = [&](const std::vector<std::string>& list) {
            return std::ranges::count(list, *text) > 0;
        };
        if (is_in(texts))
            return fail(duplicate,
                        "has \"{}\" twice (once is enough); remove one", *text);
        texts.push_back(*text);
        if (choices.empty() || is_in(choices)) return;
        fail(unknown_name, "has \"{}\" (not one of its values); {}", *text,
             did_you_mean(*text, choices));
    }
};

}  // namespace

void read_value(const toml::node& node, const std::string& section,
                const BoundKey& key, const KnownNames& known,
                const Problems& problems) {
    std::visit(Reader{{section, key, problems},
                      node,
                      allowed_texts(key.key, known),
                      is_required(key.key, known)},
               key.value);
}

std::string fault_of(double value, const std::string& section, const Key& key) {
    double scratch = 0;
    const Problems problems(section);
    read_value(toml::value(value), section, {key, &scratch}, {}, problems);
    try {
        problems.throw_if_any();
    } catch (const InputError& error) {
        return error.problems().front().what;
    }
    return "";
}

}  // namespace ideotype
