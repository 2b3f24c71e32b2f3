// SPDX-License-Identifier: Apache-2.0
#include "disk.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <string_view>
#include <unistd.h>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"
#include "run/provenance.hpp"
#include "run/run.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! The longest suffix that may be appended to the name of a history.
constexpr std::string_view longest_suffix = ".new";

//! Returns a folder if it exists, else its nearest existing parent.
fs::path existing(const fs::path& folder) {
    fs::path nearest = fs::absolute(folder).lexically_normal();
    std::error_code unknown;
    while (!fs::is_directory(nearest, unknown) && nearest.has_relative_path())
        nearest = nearest.parent_path();
    return nearest;
}

void require_length(const std::string& subject, const std::string& text,
                    std::size_t extra, long limit, const std::string& remedy) {
    // A limit of -1 means that there is none.
    if (limit < 0 || text.size() + extra <= static_cast<std::size_t>(limit))
        return;
    throw Error(
        fmt::format("{}: this {} is {} bytes long, including the suffix added "
                    "while writing (the file system allows {}); {}",
                    text, subject, text.size() + extra, limit, remedy),
        ExitCode::invalid_campaign);
}

}  // namespace

DiskRoom disk_room(const Campaign& campaign, const Cases& chosen) {
    DiskRoom room;
    // File sizes depend on the genes, the scenarios and the lengths of names.
    // Compute each combination once.
    std::map<std::array<std::size_t, 5>, std::uint64_t> known;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const CaseName case_name = chosen.name(i);
        std::uint64_t& bytes =
            known[{case_name.name.size(), case_name.site_name.size(),
                   case_name.day_name.size(), case_name.spacing_name.size(),
                   std::hash<std::string>()(case_name.trait_set_name)}];
        if (bytes == 0)
            bytes = history_bytes(header_of(campaign, chosen[i], "any"));
        room.largest = std::max(room.largest, bytes);
        room.all += bytes;
    }
    return room;
}

void require_names_fit(const Campaign& campaign, const Cases& chosen,
                       const std::string& out) {
    const fs::path folder = existing(path_of(out, campaign, chosen.name(0)));
    const long longest_name = pathconf(folder.c_str(), _PC_NAME_MAX);
    const long longest_path = pathconf(folder.c_str(), _PC_PATH_MAX);
    for (const CaseName& case_name : chosen.names()) {
        const fs::path path = path_of(out, campaign, case_name);
        require_length("name of a folder", campaign.spec.name, 0, longest_name,
                       "shorten the name of the campaign");
        require_length("name of a file", path.filename().string(),
                       longest_suffix.size(), longest_name,
                       "shorten the names of site, day, spacing or traits");
        // The limit includes the zero byte at the end of a path.
        require_length("path", path.string(), longest_suffix.size() + 1,
                       longest_path, "choose a shorter folder with --out");
    }
}

}  // namespace ideotype
