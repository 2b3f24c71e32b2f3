// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"

namespace ideotype {

//! The kinds of text that may give the plant.
enum class PlantSource {
    file_or_table,  //!< as users write it
    table,          //!< as in resolved campaigns, which stand alone
};

//! Reads the crop of a campaign or of a component into a draft: from a table,
//! a crop file, or a table of measured leaves.
class CropReader {
  public:
    //! @param file of the campaign
    //! @param of_crop the problems of the keys of the crop
    CropReader(const std::string& file, PlantSource source, Draft& draft,
               const Problems& problems, const Problems& of_crop)
        : file_(file),
          source_(source),
          draft_(draft),
          problems_(problems),
          of_crop_(of_crop) {}

    //! Reads the crop that a key has or names.
    //! @param key such as "plant.baseline"
    void read_key(const toml::node& baseline, const std::string& key);

    //! Reads the tables of a crop.
    //! @param file that they are in
    void read_plant(const toml::table& table, const std::string& file);

    //! Reads a table of measured leaves. What it does not tell is as in the
    //! crop that it names, or, if it names none, in the plant that the draft
    //! has.
    void read_measured(const std::string& text, const std::string& file);

  private:
    void read_plant_file(const std::string& file, const std::string& named_by,
                         const Location& named_at);
    void read_crop_of_table(const std::string& file, const Location& named_at);
    void read_crop(const std::string& text, const std::string& file);

    const std::string& file_;
    PlantSource source_;
    Draft& draft_;
    Problems problems_, of_crop_;
    std::vector<std::string> tables_above_;  //!< each names the next as crop
};

}  // namespace ideotype
