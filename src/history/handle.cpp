// SPDX-License-Identifier: Apache-2.0
#include "handle.hpp"

#include <fmt/format.h>

namespace ideotype {

namespace {

herr_t keep_first(unsigned, const H5E_error2_t* entry, void* text) {
    auto& first = *static_cast<std::string*>(text);
    if (first.empty() && entry->desc) first = entry->desc;
    return 0;
}

// Extracts the operating system's message from HDF5's description of a failed
// system call, which also contains addresses and offsets.
std::string extract_system_message(const std::string& description) {
    const std::string opening = "error message = '";
    const std::size_t begin = description.find(opening);
    if (begin == std::string::npos) return description;
    const std::size_t start = begin + opening.size();
    return description.substr(start, description.find('\'', start) - start);
}

}  // namespace

void initialize_hdf5() {
    H5dont_atexit();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

void throw_hdf5_error(const std::string& action) {
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_first, &reason);
    throw Hdf5Error(fmt::format("cannot {}: {}", action,
                                reason.empty()
                                    ? "HDF5 gives no reason"
                                    : extract_system_message(reason)));
}

}  // namespace ideotype
