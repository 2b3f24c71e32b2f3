#pragma once

#include <string>

namespace ideotype {

//! Which program this is, recorded in every history.
struct BuildInfo {
    std::string version;    //!< major.minor.patch
    std::string git_sha;    //!< commit, or "unknown" outside git
    std::string git_dirty;  //!< "yes", "no" or "unknown"
    std::string compiler;   //!< name and version
    std::string build_type;
};

const BuildInfo& build_info();

}  // namespace ideotype
