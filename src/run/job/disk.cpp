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

//! The longest suffix that is added to the name of a history.
constexpr std::string_view longest_suffix = ".new";

//! Returns a folder, or the nearest existing folder above.
fs::path existing(const fs::path& folder) {
    fs::path nearest = fs::absolute(folder).lexically_normal();
    std::error_code unknown;
    while (!fs::is_directory(nearest, unknown) && nearest.has_relative_path())
        nearest = nearest.parent_path();
    return nearest;
}

void require_length(const std::string& what, const std::string& text,
                    std::size_t extra, long limit, const std::string& remedy) {
    // A limit of -1 means that there is none.
    if (limit < 0 || text.size() + extra <= static_cast<std::size_t>(limit))
        return;
    throw Error(fmt::format("{}: this {} is {} bytes long with what is added "
                            "while it is written (its file system allows {}); "
                            "{}",
                            text, what, text.size() + extra, limit, remedy),
                ExitCode::invalid_campaign);
}

}  // namespace

DiskRoom disk_room(const Campaign& campaign, const Cases& chosen) {
    DiskRoom room;
    // Sizes of files depend on genes, scenarios and lengths of names.
    std::map<std::array<std::size_t, 5>, std::uint64_t> known;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const CaseName each = chosen.name(i);
        std::uint64_t& bytes =
            known[{each.name.size(), each.site_name.size(),
                   each.day_name.size(), each.spacing_name.size(),
                   std::hash<std::string>()(each.trait_set_name)}];
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
    for (const CaseName& each : chosen.names()) {
        const fs::path path = path_of(out, campaign, each);
        require_length("name of a folder", campaign.spec.name, 0, longest_name,
                       "shorten the name of the campaign");
        require_length("name of a file", path.filename().string(),
                       longest_suffix.size(), longest_name,
                       "shorten the names of site, day, spacing or traits");
        // The limit counts the byte that ends a path.
        require_length("path", path.string(), longest_suffix.size() + 1,
                       longest_path, "choose a shorter folder with --out");
    }
}

}  // namespace ideotype
