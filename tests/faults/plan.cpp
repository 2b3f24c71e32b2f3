// SPDX-License-Identifier: Apache-2.0
// Decides which call fails, from the environment:
//
//     FAULT=KIND:MODE:N[+]  the N-th call of a kind, from 1; with + all later
//                           ones too. MODE is the name of an errno, short or
//                           delay.
//     FAULT_RANK=R          only in this rank of an MPI job
//     FAULT_FILE=TEXT       only calls on files whose path has this in it
//     FAULT_NOTE=FILE       lists the calls hit, and at the end of the
//                           process how many calls there were of each kind
#include "plan.hpp"

#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

#include <sys/syscall.h>

namespace faults {

namespace {

constexpr std::array<const char*, static_cast<std::size_t>(Kind::count)> names{
    "write", "reserve",  "sync", "open",  "rename", "read",
    "map",   "allocate", "grow", "start", "send",   "receive"};

struct NamedError {
    const char* name;
    int error;
};
constexpr std::array<NamedError, 7> errors{{{"EIO", EIO},
                                            {"ENOSPC", ENOSPC},
                                            {"EINTR", EINTR},
                                            {"EMFILE", EMFILE},
                                            {"ENOMEM", ENOMEM},
                                            {"EACCES", EACCES},
                                            {"EAGAIN", EAGAIN}}};

struct Plan {
    int kind = -1;
    Fault fault;
    long at = 0;
    bool is_lasting = false;
    const char* file = nullptr;
    const char* note = nullptr;
    bool counts = false;
};

// These variables are initialised before any constructor runs, because
// constructors of libraries allocate memory.
std::array<std::atomic<long>, names.size()> calls;
std::atomic<bool> has_begun;
std::atomic<int> state;  // 0: plan not read, 1: being read, 2: read
Plan plan;

// Appends to the note by direct system calls, which never fail on purpose.
void note(const char* text) {
    if (plan.note == nullptr) return;
    const long file = syscall(SYS_openat, AT_FDCWD, plan.note,
                              O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (file < 0) return;
    static_cast<void>(syscall(SYS_write, file, text, std::strlen(text)));
    syscall(SYS_close, file);
}

void read_fault(const char* text) {
    std::array<char, 16> kind{}, mode{};
    if (std::sscanf(text, "%15[a-z]:%15[A-Za-z]:%ld", kind.data(), mode.data(),
                    &plan.at) != 3)
        _exit(99);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (std::strcmp(names[i], kind.data()) == 0)
            plan.kind = static_cast<int>(i);
    for (const NamedError& each : errors)
        if (std::strcmp(each.name, mode.data()) == 0)
            plan.fault.error = each.error;
    plan.fault.is_short = std::strcmp(mode.data(), "short") == 0;
    plan.fault.is_delayed = std::strcmp(mode.data(), "delay") == 0;
    plan.is_lasting = text[std::strlen(text) - 1] == '+';
    if (plan.kind < 0 || !plan.fault) _exit(99);
}

bool is_chosen_rank() {
    const char* wanted = std::getenv("FAULT_RANK");
    if (wanted == nullptr) return true;
    const char* own = std::getenv("OMPI_COMM_WORLD_RANK");
    return own != nullptr && std::strcmp(own, wanted) == 0;
}

void read_plan() {
    if (is_chosen_rank()) {
        plan.counts = true;
        plan.file = std::getenv("FAULT_FILE");
        plan.note = std::getenv("FAULT_NOTE");
        if (const char* text = std::getenv("FAULT")) read_fault(text);
    }
    state = 2;
}

bool is_ready() {
    int fresh = 0;
    if (state == 2) return true;
    if (!state.compare_exchange_strong(fresh, 1)) return false;
    // The environment is complete only after the C library has started, but its
    // constructors run before.
    read_plan();
    return true;
}

struct Counts {
    ~Counts() {
        if (!plan.counts) return;
        std::array<char, 64> line{};
        for (std::size_t i = 0; i < names.size(); ++i) {
            std::snprintf(line.data(), line.size(), "count %s %ld\n", names[i],
                          calls[i].load());
            note(line.data());
        }
    }
} counts;

}  // namespace

void begin_main() {
    has_begun = true;
}

Fault next(Kind kind, const char* path) {
    if (!is_ready() || !plan.counts) return {};
    const bool is_memory = kind == Kind::allocate || kind == Kind::grow;
    if (is_memory && !has_begun) return {};
    if (plan.file != nullptr &&
        (path == nullptr || std::strstr(path, plan.file) == nullptr))
        return {};
    const auto index = static_cast<std::size_t>(kind);
    const long n = ++calls[index];
    const bool is_hit = static_cast<int>(index) == plan.kind &&
                        (n == plan.at || (plan.is_lasting && n > plan.at));
    if (!is_hit) return {};
    if (n == plan.at) {
        note("hit ");
        note(path == nullptr ? "" : path);
        note("\n");
    }
    return plan.fault;
}

Fault next_of_file(Kind kind, int descriptor) {
    if (!is_ready() || !plan.counts) return {};
    std::array<char, 32> link{};
    std::array<char, 4096> path{};
    std::snprintf(link.data(), link.size(), "/proc/self/fd/%d", descriptor);
    const long length = syscall(SYS_readlinkat, AT_FDCWD, link.data(),
                                path.data(), path.size() - 1);
    return next(kind, length < 0 ? "" : path.data());
}

}  // namespace faults
