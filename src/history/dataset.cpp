// SPDX-License-Identifier: Apache-2.0
#include "dataset.hpp"

#include <algorithm>
#include <csignal>
#include <cstring>
#include <string_view>
#include <unistd.h>

#include <fmt/format.h>
#include <hdf5_hl.h>
#include <sys/mman.h>
#include <sys/stat.h>

#include "disk/open.hpp"
#include "ideotype/core/contract.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/text.hpp"
#include "layout.hpp"

namespace ideotype {

namespace {

std::vector<hsize_t> read_extents(hid_t space) {
    const int rank = checked(H5Sget_simple_extent_ndims(space), "read a rank");
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    checked(H5Sget_simple_extent_dims(space, sizes.data(), nullptr),
            "read a shape");
    return sizes;
}

std::size_t read_size(int descriptor) {
    struct stat status {};
    return fstat(descriptor, &status) == 0
               ? static_cast<std::size_t>(status.st_size)
               : 0;
}

//! Ends the program with a message that the file was truncated during an access
//! or that its disk fails.
extern "C" void end_without_file(int) {
    constexpr std::string_view text =
        "ideotype: a history was cut short while it was written, or its disk "
        "fails (nothing more can be saved in it); inspect it with ideotype "
        "status, and start again in another folder with --out\n";
    static_cast<void>(!write(STDERR_FILENO, text.data(), text.size()));
    _exit(static_cast<int>(ExitCode::refused));
}

}  // namespace

std::unique_ptr<Mapping> Mapping::create(hid_t file) {
    if (!has_all_room(file)) return nullptr;
    const int descriptor = get_descriptor(file);
    // When HDF5 1.14 flushes, it removes all bytes after the last block.
    haddr_t size = 0;
    checked(H5Fget_eoa(file, &size), "map the file");
    void* begin =
        mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, descriptor, 0);
    if (begin == MAP_FAILED) return nullptr;
    std::signal(SIGBUS, end_without_file);  // replaces a handler of MPI
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
    return read_size(descriptor_) >= size_;
}

Mapping::~Mapping() {
    munmap(begin_, size_);
}

Dataset::Dataset(hid_t location, const std::string& name) : name_(name) {
    id_ = Handle(H5Dopen2(location, name.c_str(), H5P_DEFAULT), H5Dclose,
                 "open " + name);
    const Handle type(H5Dget_type(id_), H5Tclose, "open " + name);
    memory_type_ = Handle(H5Tget_native_type(type, H5T_DIR_ASCEND), H5Tclose,
                          "open " + name);
    value_size_ = H5Tget_size(memory_type_);
    const Handle space(H5Dget_space(id_), H5Sclose, "open " + name);
    const std::vector<hsize_t> sizes = read_extents(space);
    for (std::size_t i = 1; i < sizes.size(); ++i) width_ *= sizes[i];
}

hsize_t Dataset::rows() const {
    const Handle space(H5Dget_space(id_), H5Sclose, "read " + name_);
    const std::vector<hsize_t> sizes = read_extents(space);
    return sizes.empty() ? 1 : sizes[0];
}

std::string Dataset::text(const std::string& attribute) const {
    return text_attribute(id_, attribute);
}

bool Dataset::is_scale() const {
    return checked(H5DSis_scale(id_), "find a scale") != 0;
}

hsize_t Dataset::rows_before(haddr_t end) const {
    const haddr_t begin = H5Dget_offset(id_);
    const hsize_t count = rows();
    if (begin == HADDR_UNDEF || end <= begin || count == 0) return 0;
    const hsize_t row_size = H5Dget_storage_size(id_) / count;
    return std::min<hsize_t>(count, (end - begin) / row_size);
}

void Dataset::use(const Mapping& mapping) {
    const Handle type(H5Dget_type(id_), H5Tclose, "read " + name_);
    if (!checked(H5Tequal(type, memory_type_), "read " + name_)) return;
    mapped_ = mapping.find(id_);
    mapped_values_ = H5Dget_storage_size(id_) / value_size_;
}

char* Dataset::locate(hsize_t first, std::size_t values) const {
    IDEOTYPE_EXPECT(mapped_ != nullptr);
    const hsize_t begin = first * width_;
    if (begin + values > mapped_values_)
        throw Hdf5Error(fmt::format("{} has no row {}", name_,
                                    (begin + values) / width_ - 1));
    return mapped_ + begin * value_size_;
}

void Dataset::write_text(hsize_t row, const std::string& text) {
    std::string padded = first_bytes(text, value_size_);
    padded.resize(value_size_, '\0');
    put(row, padded.data(), 1, value_size_);
}

std::vector<std::string> Dataset::read_text(hsize_t first,
                                            hsize_t count) const {
    IDEOTYPE_EXPECT(width_ == 1);
    std::vector<char> bytes(count * value_size_);
    get(first, bytes.data(), count, value_size_);
    std::vector<std::string> texts;
    texts.reserve(count);
    for (auto begin = bytes.begin(); begin != bytes.end();) {
        const auto end = begin + static_cast<std::ptrdiff_t>(value_size_);
        texts.emplace_back(begin, std::find(begin, end, '\0'));
        begin = end;
    }
    return texts;
}

void Dataset::check_value_size(std::size_t value_size) const {
    if (value_size != value_size_)
        throw Hdf5Error(fmt::format("{} has values of {} bytes, not {}", name_,
                                    value_size_, value_size));
}

Dataset::Selection Dataset::select(hsize_t first, std::size_t values) const {
    const std::string action = "select rows of " + name_;
    const hsize_t size = values;
    Handle memory(H5Screate_simple(1, &size, nullptr), H5Sclose, action);
    Handle file(H5Dget_space(id_), H5Sclose, action);
    std::vector<hsize_t> count = read_extents(file);
    if (!count.empty()) {
        count[0] = values / width_;
        std::vector<hsize_t> start(count.size(), 0);
        start[0] = first;
        checked(H5Sselect_hyperslab(file, H5S_SELECT_SET, start.data(), nullptr,
                                    count.data(), nullptr),
                action);
    }
    return {std::move(memory), std::move(file)};
}

void Dataset::put(hsize_t first, const void* values, std::size_t count,
                  std::size_t value_size) {
    check_value_size(value_size);
    IDEOTYPE_EXPECT(count % width_ == 0);
    if (count == 0) return;
    if (mapped_) {
        std::memcpy(locate(first, count), values, count * value_size);
        return;
    }
    const Selection selection = select(first, count);
    checked(H5Dwrite(id_, memory_type_, selection.memory, selection.file,
                     H5P_DEFAULT, values),
            "write " + name_);
}

void Dataset::get(hsize_t first, void* values, std::size_t count,
                  std::size_t value_size) const {
    check_value_size(value_size);
    fetch(memory_type_, first, values, count);
}

std::vector<char> Dataset::bytes(hsize_t first, hsize_t count) const {
    const Handle type(H5Dget_type(id_), H5Tclose, "read " + name_);
    std::vector<char> bytes(count * width_ * H5Tget_size(type));
    fetch(type, first, bytes.data(), count * width_);
    return bytes;
}

//! Reads values of a type. If the dataset is mapped, it must be the type in the
//! file.
void Dataset::fetch(hid_t type, hsize_t first, void* values,
                    std::size_t count) const {
    IDEOTYPE_EXPECT(count % width_ == 0);
    if (count == 0) return;
    if (mapped_) {
        std::memcpy(values, locate(first, count), count * value_size_);
        return;
    }
    const Selection selection = select(first, count);
    checked(H5Dread(id_, type, selection.memory, selection.file, H5P_DEFAULT,
                    values),
            "read " + name_);
}

}  // namespace ideotype
