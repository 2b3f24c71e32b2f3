// SPDX-License-Identifier: Apache-2.0
//! Folders for the files of tests, which run at the same time.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace ideotype {

//! A new folder that is removed together with its files.
class Folder {
  public:
    Folder() {
        std::string name =
            (std::filesystem::temp_directory_path() / "ideotype-XXXXXX")
                .string();
        path_ = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    std::string operator/(const std::string& name) const {
        return (path_ / name).string();
    }

  private:
    std::filesystem::path path_;
};

//! Returns a path in a folder that belongs to this process.
inline std::string temporary_file(const std::string& name) {
    static const Folder folder;
    return folder / name;
}

}  // namespace ideotype
