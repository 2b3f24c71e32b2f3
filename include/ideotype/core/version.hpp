// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace ideotype {

//! The identity of the build, which every history records.
struct BuildInfo {
    //! The version. For a release: "0.1.1". Between releases: the last release
    //! and the commit, "0.1.1+0123456789ab", followed by "-dirty" if sources
    //! differ from the commit.
    std::string version;
    std::string git_sha;    //!< commit, or "unknown" outside git
    std::string git_dirty;  //!< "yes", "no" or "unknown"
    std::string compiler;   //!< name and version of the compiler
    std::string build_type;
};

const BuildInfo& build_info();

}  // namespace ideotype
