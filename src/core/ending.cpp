// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/ending.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>
#include <unistd.h>

#include <fmt/format.h>

#include "ideotype/core/error.hpp"

namespace ideotype {

namespace {

std::atomic<bool> is_in_order = false;

void report(const char* reason) {
    std::array<char, 1024> text{};
    const auto [last, size] = fmt::format_to_n(
        text.data(), text.size(),
        "ideotype: a library ended the program ({}), usually for lack of "
        "memory or threads (see ulimit -a); recorded rows are kept, continue "
        "with --resume\n",
        reason);
    static_cast<void>(!write(STDERR_FILENO, text.data(),
                             static_cast<std::size_t>(last - text.data())));
}

[[noreturn]] void end(const char* reason) {
    report(reason);
    std::_Exit(static_cast<int>(ExitCode::runtime));
}

// Reports a segmentation fault. It may be a lack of memory: OpenSSL and HDF5
// use some null pointers that failed allocations returned. On return, the
// instruction is executed again, and the signal ends the process.
void report_segmentation_fault(int /*signal*/) {
    report("segmentation fault");
}

// Handles segmentation faults, unless a sanitizer already does: its report is
// more detailed.
void watch_for_segmentation_fault() {
    struct sigaction action {};
    sigaction(SIGSEGV, nullptr, &action);
    if (action.sa_handler != SIG_DFL) return;
    action.sa_handler = report_segmentation_fault;
    action.sa_flags = SA_RESETHAND;
    sigaction(SIGSEGV, &action, nullptr);
}

[[noreturn]] void end_with_reason() {
    try {
        if (const auto error = std::current_exception())
            std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        end("not enough memory");
    } catch (const std::exception& error) {
        end(error.what());
    } catch (...) {
        end("an exception of unknown type");
    }
    end("no reason given");
}

}  // namespace

void watch_for_foreign_end() {
    std::set_terminate(end_with_reason);
    watch_for_segmentation_fault();
    std::atexit([] {
        if (!is_in_order) end("no reason given");
    });
}

void end_in_order() {
    is_in_order = true;
}

}  // namespace ideotype
