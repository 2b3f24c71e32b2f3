// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <fmt/format.h>

#include "ideotype/campaign/campaign.hpp"
#include "ideotype/campaign/migration.hpp"
#include "ideotype/cli/verbs.hpp"

namespace ideotype {

namespace {

namespace fs = std::filesystem;

//! The file itself, where a link is named.
fs::path real_file(const fs::path& file) {
    return fs::is_symlink(file) ? fs::canonical(file) : file;
}

std::string copy_of(const fs::path& file) {
    return real_file(file).string() + ".bak";
}

void require_no_copy(const std::string& file) {
    if (fs::exists(copy_of(file)))
        throw Error(fmt::format("{}: exists already (an older text of {} would "
                                "be lost); move it away",
                                copy_of(file), file),
                    ExitCode::refused);
}

void synchronize(const fs::path& path) {
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_on_disk = descriptor >= 0 && fsync(descriptor) == 0;
    if (descriptor >= 0) close(descriptor);
    if (!is_on_disk) throw Error("cannot write " + path.string());
}

//! Whenever this is cut short, the file has its old text or its new one.
void replace(const fs::path& file, const std::string& text) {
    const fs::path unfinished = file.string() + ".migrating";
    // A copy has the same permissions.
    fs::copy_file(file, unfinished, fs::copy_options::overwrite_existing);
    std::ofstream stream(unfinished, std::ios::binary | std::ios::trunc);
    stream << text;
    stream.close();
    if (!stream) throw Error("cannot write " + unfinished.string());
    synchronize(unfinished);
    fs::copy_file(file, copy_of(file));
    synchronize(copy_of(file));
    fs::rename(unfinished, file);
    synchronize(fs::absolute(file).parent_path());
}

void apply(const Migration& migration) {
    const std::string& file = migration.file;
    if (migration.changes.empty())
        return fmt::print("{}: nothing to do\n", file);
    try {
        replace(real_file(file), migration.text);
    } catch (const fs::filesystem_error& error) {
        throw Error(
            fmt::format("cannot write {} ({})", file, error.code().message()));
    }
    for (const OldName& name : migration.changes)
        fmt::print("{}:{}:{}: {} is now '{}'\n", file, name.where.line,
                   name.where.column, name.what, name.is);
    fmt::print("{}: {} changed; the old text is in {}\n", file,
               migration.changes.size() == 1
                   ? "one name"
                   : fmt::format("{} names", migration.changes.size()),
               copy_of(file));
}

}  // namespace

ExitCode migrate(const std::string& path) {
    const std::vector<Migration> migrations = read_migrations(path);
    for (const Migration& each : migrations)
        if (!each.changes.empty()) require_no_copy(each.file);
    for (const Migration& each : migrations) apply(each);
    // Tells what else is wrong with the campaign or plant.
    read_plant(path);
    return ExitCode::ok;
}

}  // namespace ideotype
