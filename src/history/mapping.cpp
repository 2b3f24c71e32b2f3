// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <string_view>
#include <unistd.h>

#include <sys/mman.h>
#include <sys/stat.h>

#include "dataset.hpp"
#include "ideotype/core/error.hpp"
#include "open.hpp"

namespace ideotype {

namespace {

std::size_t size_of(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0
               ? static_cast<std::size_t>(status.st_size)
               : 0;
}

//! The file was cut short at the very moment of an access, or its disk fails:
//! says so, and ends the program as where it notices by itself.
extern "C" void end_without_file(int) {
    constexpr std::string_view text =
        "ideotype: a history was cut short while it was written, or its disk "
        "fails (nothing more can be saved in it); look at it with ideotype "
        "status, and begin again in another folder with --out\n";
    static_cast<void>(!write(STDERR_FILENO, text.data(), text.size()));
    _exit(static_cast<int>(ExitCode::refused));
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
    std::signal(SIGBUS, end_without_file);  // MPI has its own until here
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
