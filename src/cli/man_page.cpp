// SPDX-License-Identifier: Apache-2.0
#include <cctype>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "describe.hpp"
#include "ideotype/core/version.hpp"

namespace ideotype {

namespace {

//! Text that roff prints as it is. A dash is one that can be searched for.
std::string escape(const std::string& text) {
    std::string result;
    bool begins_line = true;
    for (const char each : text) {
        if (begins_line && (each == '.' || each == '\'')) result += "\\&";
        if (each == '\\' || each == '-')
            result += each == '-' ? "\\-" : "\\e";
        else
            result += each;
        begins_line = each == '\n';
    }
    return result;
}

std::string join(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}

//! A line of its own, which begins and ends as sentences do.
std::string sentence(std::string text) {
    if (text.empty()) return "\n";
    text.front() = static_cast<char>(
        std::toupper(static_cast<unsigned char>(text.front())));
    return escape(text) + ".\n";
}

std::string man_option(const DescribedOption& option) {
    std::string text = ".TP\n\\fB" + escape(join(option.names)) + "\\fR";
    if (!option.choices.empty())
        text += escape(fmt::format(" {}", fmt::join(option.choices, "|")));
    else if (!option.is_positional && !option.value.empty())
        text += " \\fI" + escape(option.value) + "\\fR";
    text += "\n" + sentence(option.about);
    if (!option.needs.empty()) text += sentence("needs " + join(option.needs));
    if (!option.excludes.empty())
        text += sentence("not with " + join(option.excludes));
    return text;
}

std::string man_options(const CLI::App& verb) {
    std::string text;
    for (const DescribedOption& each : describe_options(verb))
        text += man_option(each);
    return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
    std::string text = fmt::format(
        ".TH IDEOTYPE 1 \"\" \"ideotype {}\" \"User Commands\"\n"
        ".SH NAME\nideotype \\- light and breeding in crop canopies\n"
        ".SH SYNOPSIS\n.B ideotype\n\\fIVERB\\fR [\\fIOPTION\\fR ...]\n"
        ".SH DESCRIPTION\n{}\n.SH OPTIONS\n{}.SH VERBS\n",
        escape(build_info().version), escape(app.get_description()),
        man_options(app));
    for (const CLI::App* verb : app.get_subcommands({}))
        text += ".SS " + escape(verb->get_name()) + "\n" +
                sentence(verb->get_description()) + man_options(*verb) +
                ".PP\n" + escape(verb->get_footer()) + "\n";
    text.pop_back();  // the last line's end, which is printed too
    return text;
}

}  // namespace ideotype
