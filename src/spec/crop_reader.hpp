// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <toml++/toml.h>

#include "spec/reader.hpp"

namespace ideotype {

//! Reads a crop from a table or from a crop file.
class CropReader {
  public:
    //! @param file path of the file that contains or names the crop
    //! @param problems problems of tables that campaigns may contain too
    //! @param of_crop problems of keys that only crops contain
    CropReader(const std::string& file, TextSource source, CropSpec& crop,
               const Problems& problems, const Problems& of_crop)
        : file_(file),
          source_(source),
          crop_(crop),
          problems_(problems),
          of_crop_(of_crop) {}

    //! Reads the crop that a key contains or names.
    //! @param key key such as "plant.baseline"
    void read_key(const toml::node& baseline, const std::string& key);

    //! Reads the tables of a crop file.
    void read(const toml::table& table, const std::string& file);

  private:
    void read_file(const std::string& file, const std::string& named_by,
                   const Location& named_at);

    const std::string& file_;
    TextSource source_;
    CropSpec& crop_;
    Problems problems_, of_crop_;
};

//! Records which file states each key of [photosynthesis].
void note_leaves(const toml::table& top, const std::string& file,
                 CropSpec& crop);

//! Reports an error if a file is a CSV table of measured leaves, which
//! `ideotype fit` converts to crop files. Returns whether the file name is that
//! of a CSV table.
//! @param named_by key that names the file; "" if none
bool is_table_of_leaves(const std::string& file, const std::string& named_by,
                        const Location& named_at, const Problems& problems);

}  // namespace ideotype
