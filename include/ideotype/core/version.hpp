// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! Identifies the program that was built; every history records it.
struct BuildInfo {
    //! The version: "0.1.1" of a release; between releases the last one and the
    //! commit, "0.1.1+0123456789ab", and "-dirty" if sources have changed
    //! since.
    std::string version;
    std::string git_sha;    //!< commit, or "unknown" outside git
    std::string git_dirty;  //!< "yes", "no" or "unknown"
    std::string compiler;   //!< name and version
    std::string build_type;
};

const BuildInfo& build_info();

}  // namespace ideotype
