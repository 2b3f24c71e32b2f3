// SPDX-License-Identifier: Apache-2.0
#include "files.hpp"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "ideotype/core/file.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! Returns advice on a missing file: a file with a similar name in the same
//! folder or, if there is none, the given text.
std::string remedy_for(const fs::path& missing, const std::string& otherwise) {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry :
         fs::directory_iterator(fs::absolute(missing).parent_path(), none))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().stem().string());
    // Advice must not depend on the order of files in a folder.
    std::sort(names.begin(), names.end());
    const std::string near = nearest_name(missing.stem().string(), names);
    return near.empty() ? otherwise : "did you mean '" + near + ".toml'?";
}

}  // namespace

std::string path_from(const std::string& file, const std::string& path) {
    return (fs::path(file).parent_path() / path)
        .lexically_normal()
        .generic_string();
}

std::string read_text(const std::string& path) {
    FileText file = read_file(path, most_input_bytes);
    if (!file.is_there)
        throw Error(file.refusal(path) + "; " +
                    remedy_for(path, "name a file that can be read"));
    return std::move(file.text);
}

std::optional<std::string> text_of(const std::string& file,
                                   const std::string& named_by,
                                   const Location& named_at,
                                   const Problems& problems) {
    FileText read = read_file(file, most_input_bytes);
    if (read.is_there) return std::move(read.text);
    problems.add(
        {named_at, named_by, ProblemCode::file,
         fmt::format("{} (named by {}); {}", read.refusal(file), named_by,
                     remedy_for(file, "give a path relative to this file"))});
    return std::nullopt;
}

}  // namespace ideotype
