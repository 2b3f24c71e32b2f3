// SPDX-License-Identifier: Apache-2.0
#include "mapping.hpp"

#include <sys/mman.h>
#include <sys/stat.h>

#include "open.hpp"
#include "space.hpp"

namespace ideotype {

namespace {

std::size_t size_of(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0
               ? static_cast<std::size_t>(status.st_size)
               : 0;
}

}  // namespace

std::unique_ptr<Mapping> Mapping::of(hid_t file) {
    if (!has_all_room(file)) return nullptr;
    const int descriptor = descriptor_of(file);
    // HDF5 1.14 cuts off what is behind the last block when it flushes.
    haddr_t size = 0;
    checked(H5Fget_eoa(file, &size), "map the file");
    void* begin =
        mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (begin == MAP_FAILED) return nullptr;
    return std::unique_ptr<Mapping>(
        new Mapping(descriptor, static_cast<char*>(begin), size));
}

char* Mapping::find(hid_t dataset) const {
    const haddr_t begin = H5Dget_offset(dataset);
    const bool is_block =
        begin != HADDR_UNDEF && begin + H5Dget_storage_size(dataset) <= size_;
    return is_block ? begin_ + begin : nullptr;
}

bool Mapping::is_whole() const {
    return size_of(descriptor_) >= size_;
}

Mapping::~Mapping() {
    munmap(begin_, size_);
}

}  // namespace ideotype
