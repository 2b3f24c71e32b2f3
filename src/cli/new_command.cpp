// SPDX-License-Identifier: Apache-2.0
#include <cctype>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/campaign/known_crops.hpp"
#include "ideotype/cli/verbs.hpp"
#include "new_answers.hpp"
#include "new_text.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& what) {
    throw Error(what, ExitCode::usage);
}

//! Writes files that are not there yet; without keep() they are gone again.
class NewFiles {
  public:
    NewFiles() = default;
    NewFiles(const NewFiles&) = delete;
    NewFiles& operator=(const NewFiles&) = delete;
    ~NewFiles() {
        std::error_code none;
        for (const std::string& path : written_) fs::remove(path, none);
    }

    void write(const std::string& path, const std::string& text) {
        std::FILE* const file = std::fopen(path.c_str(), "wbx");
        if (!file)
            throw Error(
                fmt::format("{}: cannot be written (it exists, or its "
                            "folder does not)",
                            path));
        written_.push_back(path);
        const bool is_written =
            std::fwrite(text.data(), 1, text.size(), file) == text.size();
        if (std::fclose(file) != 0 || !is_written)
            throw Error(path + ": cannot be written");
    }

    void keep() {
        for (const std::string& path : written_) fmt::print("{}\n", path);
        written_.clear();
    }

  private:
    std::vector<std::string> written_;
};

//! The path of the plant's file: a crop of the program is copied beside the
//! campaign, to be changed there.
std::string place_plant(const std::string& plant, const fs::path& folder,
                        NewFiles& files) {
    if (is_file(plant)) return plant;
    const std::string path = (folder / (plant + ".toml")).string();
    const std::string text = known_crop(plant).value();
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        files.write(path, text);
        return path;
    }
    const std::string there{std::istreambuf_iterator<char>(stream), {}};
    if (there != text)
        throw Error(
            fmt::format("{0}: exists already and is not overwritten (it "
                        "is not the {1} of the program); take it as it "
                        "is by --plant {0}, or give it another name",
                        path, plant),
            ExitCode::refused);
    return path;
}

//! Letters that names may have.
std::string to_name(std::string text) {
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-') c = '_';
    return text;
}

}  // namespace

ExitCode write_new_campaign(const NewOptions& given) {
    NewOptions options = given;
    const fs::path path = options.path;
    if (fs::exists(path))
        throw Error(fmt::format("{}: exists already and is not overwritten",
                                options.path),
                    ExitCode::refused);
    const fs::path beside = path.parent_path();
    if (!beside.empty() && !fs::is_directory(beside))
        refuse(fmt::format("new: there is no folder {}; make it first",
                           beside.string()));
    complete(options);
    if (options.name.empty()) options.name = to_name(path.stem().string());

    NewCampaign campaign;
    campaign.name = options.name;
    Site& site = campaign.site;
    site.name = campaign.name;
    site.latitude = to_number(options.latitude, "site", "latitude");
    site.longitude = to_number(options.longitude, "site", "longitude");
    site.utc_offset = options.utc_offset.empty()
                          ? std::round(site.longitude / 15)  // degrees per hour
                          : to_number(options.utc_offset, "site", "utc_offset");
    campaign.date = to_date(options.date);
    campaign.row = to_number(options.row, "spacing", "row");
    campaign.plant = to_number(options.plant_spacing, "spacing", "plant");
    campaign.objective = options.objective;

    NewFiles files;
    const std::string plant = place_plant(options.plant, beside, files);
    campaign.crop = read_crop(plant);
    const fs::path folder = fs::absolute(path).parent_path();
    campaign.plant_file = fs::proximate(plant, folder).generic_string();
    files.write(options.path, text_of(campaign));
    read_campaign(options.path);
    files.keep();
    fmt::print("next: ideotype check {}\n", options.path);
    return ExitCode::ok;
}

}  // namespace ideotype
