// SPDX-License-Identifier: Apache-2.0
#include <csignal>
#include <cstdlib>
#include <exception>
#include <new>

#include <gtest/gtest.h>

#include "ideotype/core/ending.hpp"

namespace ideotype {
namespace {

using testing::ExitedWithCode;

TEST(Ending, ExitByALibraryIsReported) {
    EXPECT_EXIT(
        {
            watch_for_foreign_end();
            std::exit(255);
        },
        ExitedWithCode(1), "^ideotype: a library ended the program");
}

TEST(Ending, UncaughtExceptionIsReported) {
    EXPECT_EXIT(
        {
            watch_for_foreign_end();
            try {
                throw std::bad_alloc();
            } catch (...) {
                std::terminate();
            }
        },
        ExitedWithCode(1), "the program \\(not enough memory\\)");
}

TEST(Ending, SegmentationFaultIsReported) {
    EXPECT_EXIT(
        {
            std::signal(SIGSEGV, SIG_DFL);
            watch_for_foreign_end();
            raise(SIGSEGV);
            raise(SIGSEGV);
        },
        testing::KilledBySignal(SIGSEGV), "the program \\(segmentation fault");
}

TEST(Ending, RegularEndIsSilent) {
    EXPECT_EXIT(
        {
            watch_for_foreign_end();
            end_in_order();
            std::exit(3);
        },
        ExitedWithCode(3), "^$");
}

}  // namespace
}  // namespace ideotype
