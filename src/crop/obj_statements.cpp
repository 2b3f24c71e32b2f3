// SPDX-License-Identifier: Apache-2.0
#include "obj_statements.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "ideotype/crop/obj_reader.hpp"

namespace ideotype {

namespace {

constexpr std::string_view blanks = " \t";

//! Keywords that any OBJ file may contain and that describe no surface.
constexpr std::string_view harmless[] = {
    "vt",       "vn",       "vp",         "p",         "l",      "s",
    "mg",       "cstype",   "deg",        "bmat",      "step",   "curv",
    "curv2",    "surf",     "parm",       "trim",      "hole",   "scrv",
    "sp",       "end",      "con",        "bevel",     "usemtl", "mtllib",
    "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech",  "stech",
    "lod",      "call",     "csh",        "usemap",    "maplib", "res",
    "cdc",      "cdp",      "bzp",        "bsp"};

//! Splits a text into logical lines. Lines end with LF, CR LF or CR; a line
//! that ends with a backslash continues on the next.
class Lines {
  public:
    explicit Lines(std::string_view text) : rest_(text) {
        constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
        if (rest_.starts_with(byte_order_mark))
            rest_.remove_prefix(byte_order_mark.size());
    }

    //! Reads the next line; returns false at the end of the text.
    bool next(std::string& line) {
        line.clear();
        if (rest_.empty()) return false;
        number_ = next_number_;
        for (bool continues = true; continues && !rest_.empty();) {
            std::string_view part = take_line();
            continues = part.ends_with('\\');
            if (continues) part.remove_suffix(1);
            line += part;
            if (continues) line += ' ';
        }
        return true;
    }

    //! Returns the number of the line where the last statement began.
    int number() const { return number_; }

  private:
    std::string_view take_line() {
        const std::size_t end =
            std::min(rest_.find_first_of("\r\n"), rest_.size());
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end);
        rest_.remove_prefix(rest_.starts_with("\r\n") ? 2
                            : rest_.empty()           ? 0
                                                      : 1);
        ++next_number_;
        return line;
    }

    std::string_view rest_;
    int number_ = 0;
    int next_number_ = 1;
};

struct Word {
    std::string_view text;
    int column = 1;
};

std::vector<Word> split(std::string_view line) {
    std::vector<Word> words;
    for (std::size_t at = line.find_first_not_of(blanks); at != line.npos;) {
        const std::size_t end =
            std::min(line.find_first_of(blanks, at), line.size());
        words.push_back({line.substr(at, end - at), static_cast<int>(at) + 1});
        at = line.find_first_not_of(blanks, end);
    }
    return words;
}

//! Quotes a word for a message: shortened, with ? for bytes that do not print.
std::string quote(std::string_view word) {
    std::string text(word.substr(0, 20));
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return fmt::format("'{}{}'", text, word.size() > 20 ? "..." : "");
}

//! Checks the numbers of statements before the library reads them.
class Checker {
  public:
    explicit Checker(const std::string& file) : file_(file) {}

    void check_vertex(int line, const std::vector<Word>& words) const {
        if (words.size() < 4)
            fail(line, words.front(),
                 "a vertex has fewer than three coordinates; give x, y and z");
        for (std::size_t i = 1; i <= 3; ++i) check_number(line, words[i]);
    }

    void check_face(int line, const std::vector<Word>& words) const {
        if (words.size() < 4)
            fail(line, words.front(),
                 "a face has fewer than three corners; give three or more");
        for (std::size_t i = 1; i < words.size(); ++i)
            check_index(line, words[i]);
    }

    void check_count(int line, const std::vector<Word>& words,
                     std::size_t faces) const {
        if (faces == most_obj_faces)
            fail(line, words.front(),
                 fmt::format("there are more than {} faces (too many for the "
                             "memory); leave out what is not needed",
                             most_obj_faces));
    }

  private:
    [[noreturn]] void fail(int line, const Word& word, std::string text) const {
        throw InputError({{{file_, line, word.column},
                           "",
                           ProblemCode::data,
                           std::move(text)}});
    }

    void check_number(int line, const Word& word) const {
        std::string_view text = word.text;
        if (text.starts_with('+') && !text.starts_with("+-"))
            text.remove_prefix(1);
        double value = 0;
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc::invalid_argument ||
            end != text.data() + text.size())
            fail(
                line, word,
                quote(word.text) +
                    " is not a number; write coordinates with a decimal point");
        if (error != std::errc{} || !std::isfinite(value))
            fail(line, word,
                 quote(word.text) + " is not a finite coordinate; correct it");
    }

    //! Checks "vertex", "vertex/texture", "vertex//normal" ...
    void check_index(int line, const Word& word) const {
        const std::string_view text = word.text.substr(0, word.text.find('/'));
        int index = 0;
        const auto [end, error] =
            std::from_chars(text.data(), text.data() + text.size(), index);
        if (error != std::errc{} || end != text.data() + text.size())
            fail(line, word,
                 quote(word.text) +
                     " is not the number of a vertex; write a whole number");
    }

    const std::string& file_;
};

}  // namespace

ObjStatements pick_statements(const std::string& text,
                              const std::string& file) {
    ObjStatements result;
    result.text.reserve(text.size());
    const Checker checker(file);
    Lines lines(text);
    for (std::string line; lines.next(line);) {
        const std::vector<Word> words = split(line);
        if (words.empty() || words.front().text.starts_with('#')) continue;
        const std::string_view keyword = words.front().text;
        if (keyword == "v") {
            checker.check_vertex(lines.number(), words);
            result.vertex_lines.push_back(lines.number());
        } else if (keyword == "f" || keyword == "fo") {
            checker.check_face(lines.number(), words);
            checker.check_count(lines.number(), words,
                                result.face_lines.size());
            result.face_lines.push_back(lines.number());
        } else if (keyword != "g" && keyword != "o") {
            if (std::ranges::find(harmless, keyword) == std::end(harmless))
                result.unknown.add(lines.number());
            continue;
        }
        // The library accepts a keyword only if a blank follows it.
        result.text += keyword == "fo" ? "f" : keyword;
        for (std::size_t i = 1; i < words.size(); ++i) {
            result.text += ' ';
            result.text += words[i].text;
        }
        result.text += words.size() == 1 ? " \n" : "\n";
    }
    return result;
}

}  // namespace ideotype
