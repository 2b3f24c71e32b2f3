// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "campaign/draft.hpp"
#include "campaign/problems.hpp"
#include "campaign/schema/schema.hpp"

namespace ideotype {

//! The kinds of text from which a plant may be read.
enum class PlantSource {
    file_or_table,  //!< form in which users write the plant
    table,          //!< form in resolved campaigns, without files
};

//! Reads the crop of a campaign or of a component into a draft, from a table or
//! a crop file.
class CropReader {
  public:
    //! @param file path of the campaign
    //! @param of_crop problems of the keys of the crop
    CropReader(const std::string& file, PlantSource source, Draft& draft,
               const Problems& problems, const Problems& of_crop)
        : file_(file),
          source_(source),
          draft_(draft),
          problems_(problems),
          of_crop_(of_crop) {}

    //! Reads the crop that a key contains or names.
    //! @param key such as "plant.baseline"
    void read_key(const toml::node& baseline, const std::string& key);

    //! Reads the tables of a crop file.
    void read_crop(const toml::table& table, const std::string& file);

    //! Returns whether a file is a table of measured leaves, and reports one.
    bool is_table_of_leaves(const std::string& file, const Location& named_at);

  protected:
    //! Notes the keys of [photosynthesis] that a file has.
    void note_leaves(const toml::table& top, const std::string& file);

    const std::string& file_;
    PlantSource source_;
    Draft& draft_;
    Problems problems_, of_crop_;

  private:
    void read_plant_file(const std::string& file, const std::string& named_by,
                         const Location& named_at);
    void read_crop(const std::string& text, const std::string& file);
};

//! Reads the text of a campaign, and the crop file that it names, into a draft,
//! without checks of values against each other.
//! @param settings settings from the command line, see apply_settings()
void read_draft(const std::string& text, const std::string& file,
                PlantSource source, const std::vector<std::string>& settings,
                Draft& draft, const Problems& problems);

//! Reads the text of a crop file into a draft, all else of which stays. Returns
//! false if the text is none.
bool read_crop_draft(const std::string& text, const std::string& file,
                     Draft& draft, const Problems& problems);

//! Reads the weather files of a campaign, for each site in each climate, unless
//! the draft has the weather already; resolved campaigns have all. Problems of
//! a file are reported with their line.
//! @param file path of the campaign, from which weather files are found
void read_weathers(const std::string& file, PlantSource source, Draft& draft,
                   const Problems& problems);

}  // namespace ideotype
