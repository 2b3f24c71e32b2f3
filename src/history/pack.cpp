// SPDX-License-Identifier: Apache-2.0
#include "ideotype/history/pack.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>

#include <hdf5_hl.h>
#include <sys/stat.h>

#include "attributes.hpp"
#include "checksum.hpp"
#include "contents.hpp"
#include "dataset.hpp"
#include "file_lock.hpp"
#include "history_file.hpp"
#include "layout.hpp"
#include "open.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

// Less than this is not worth an index of chunks [bytes].
constexpr hsize_t smallest_packed = 4096;
constexpr unsigned effort = 6;

bool is_packed(hid_t file) {
    const Handle genome(H5Dopen2(file, "evaluations/genome", H5P_DEFAULT),
                        H5Dclose, "open the genomes");
    const Handle properties(H5Dget_create_plist(genome), H5Pclose,
                            "read a layout");
    return H5Pget_nfilters(properties) > 0;
}

Handle packed_form(hid_t dataset, const Blocks& blocks) {
    const std::string action = "prepare a dataset";
    Handle form(H5Dget_create_plist(dataset), H5Pclose, action);
    if (blocks.sizes.empty() ||
        blocks.rows * blocks.row_bytes < smallest_packed)
        return form;
    std::vector<hsize_t> chunk = blocks.sizes;
    chunk[0] = blocks.rows_per_block;
    checked(H5Pset_chunk(form, static_cast<int>(chunk.size()), chunk.data()),
            action);
    checked(H5Pset_alloc_time(form, H5D_ALLOC_TIME_INCR), action);
    checked(H5Pset_fill_time(form, H5D_FILL_TIME_ALLOC), action);
    checked(H5Pset_shuffle(form), action);
    checked(H5Pset_deflate(form, effort), action);
    checked(H5Pset_fletcher32(form), action);
    return form;
}

// Rows that were never written are zeros: as chunks that are not there, they
// read as zeros again.
bool can_be_left_out(hid_t form, const std::vector<char>& bytes) {
    H5D_fill_value_t fill = H5D_FILL_VALUE_ERROR;
    checked(H5Pfill_value_defined(form, &fill), "read a fill value");
    return fill != H5D_FILL_VALUE_USER_DEFINED &&
           std::all_of(bytes.begin(), bytes.end(),
                       [](char byte) { return byte == 0; });
}

Handle copy_dataset(hid_t from, hid_t target, const std::string& path) {
    const Blocks blocks(from);
    const Handle form = packed_form(from, blocks);
    const Handle space(H5Dget_space(from), H5Sclose, "read a shape");
    Handle to(H5Dcreate2(target, path.c_str(), blocks.type, space, H5P_DEFAULT,
                         form, H5P_DEFAULT),
              H5Dclose, "create " + path);
    blocks.for_each([&](hsize_t first, hsize_t count) {
        const auto bytes = read_block(from, blocks, first, count);
        if (!can_be_left_out(form, bytes))
            write_block(to, blocks, first, count, bytes);
    });
    return to;
}

void copy_objects(hid_t source, hid_t target) {
    for (const Object& object : objects_of(source)) {
        const Handle from = open_object(source, object);
        const Handle to =
            object.is_dataset    ? copy_dataset(from, target, object.path)
            : object.path == "." ? open_object(target, object)
                                 : create_group(target, object.path);
        for (const std::string& name : attributes_of(from)) {
            const StoredValue bytes = read_attribute(from, name);
            create_attribute(to, name, bytes.type, bytes.values.data());
        }
    }
}

// After all objects: a scale may come after what it describes.
void copy_dimensions(hid_t source, hid_t target) {
    for (const Object& object : objects_of(source)) {
        if (!object.is_dataset) continue;
        const auto dimensions = dimensions_of(open_object(source, object));
        const Handle to = open_object(target, object);
        for (unsigned i = 0; i < dimensions.size(); ++i) {
            if (!dimensions[i].label.empty())
                checked(H5DSset_label(to, i, dimensions[i].label.c_str()),
                        "label a dimension");
            for (const std::string& path : dimensions[i].scales) {
                const Handle scale = open_object(target, {path, true});
                const std::string name = path.substr(path.rfind('/') + 1);
                if (!is_scale(scale))
                    checked(H5DSset_scale(scale, name.c_str()),
                            "create a scale");
                checked(H5DSattach_scale(to, scale, i), "attach a scale");
            }
        }
    }
}

void compare_datasets(hid_t a, hid_t b, const std::string& path) {
    const Blocks blocks(a);
    const Blocks others(b);
    if (blocks.sizes != others.sizes || H5Tequal(blocks.type, others.type) <= 0)
        throw Hdf5Error(path + " has changed its shape or type");
    blocks.for_each([&](hsize_t first, hsize_t count) {
        if (read_block(a, blocks, first, count) !=
            read_block(b, blocks, first, count))
            throw Hdf5Error(path + " has changed");
    });
    if (dimensions_of(a) != dimensions_of(b))
        throw Hdf5Error(path + " has changed its dimension scales");
}

void compare(hid_t source, hid_t packed) {
    const auto objects = objects_of(source);
    if (objects_of(packed) != objects)
        throw Hdf5Error("the objects have changed");
    for (const Object& object : objects) {
        const Handle a = open_object(source, object);
        const Handle b = open_object(packed, object);
        const auto names = attributes_of(a);
        if (attributes_of(b) != names)
            throw Hdf5Error(object.path + " has changed its attributes");
        for (const std::string& name : names) {
            const StoredValue x = read_attribute(a, name);
            const StoredValue y = read_attribute(b, name);
            if (H5Tequal(x.type, y.type) <= 0 || x.values != y.values)
                throw Hdf5Error(object.path + " has changed its " + name);
        }
        if (object.is_dataset) compare_datasets(a, b, object.path);
    }
}

std::uintmax_t room_of(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return 0;
    return static_cast<std::uintmax_t>(status.st_blocks) * 512;
}

void write_packed(hid_t source, const std::string& path) {
    Handle target = create_empty(path);
    copy_objects(source, target);
    copy_dimensions(source, target);
    flush(target);
    target.close("write the packed file");
    synchronize_path(path);
}

}  // namespace

PackedSize pack_file(const std::string& path) {
    initialize_hdf5();
    if (!history_exists(path)) throw Error(path + ": there is no such file");
    const FileLock lock(path);
    const std::string packed = path + ".packed";
    const std::uintmax_t before = room_of(path);
    try {
        const Handle source = open_as_it_is(path);
        if (Dataset(source, "state/finished").read<std::int8_t>(0, 1)[0] == 0)
            throw Error(path +
                            ": is not finished; only a finished history is "
                            "packed (go on with ideotype run --resume)",
                        ExitCode::refused);
        if (is_packed(source)) return {before, before};
        if (has_checksums(source)) require_intact(source, path);
        write_packed(source, packed);
        compare(source, open_as_it_is(packed));
        fs::permissions(packed, fs::status(path).permissions());
    } catch (const Hdf5Error& error) {
        fs::remove(packed);
        throw Error(path +
                    ": cannot pack, it is left as it was: " + error.what());
    } catch (...) {
        std::error_code failure;
        fs::remove(packed, failure);
        throw;
    }
    put_in_place(packed, path);
    return {before, room_of(path)};
}

}  // namespace ideotype
