// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <sched.h>

#include <gtest/gtest.h>

#include "cli/ranks.hpp"
#include "ideotype/core/error.hpp"
#include "ideotype/core/host.hpp"

namespace ideotype {
namespace {

TEST(Threads, DefaultToTheCoresThatThisProcessMayUse) {
    cpu_set_t allowed, one;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    EXPECT_LE(available_cores(), CPU_COUNT(&allowed));
    CPU_ZERO(&one);
    for (int core = 0; core < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++core)
        if (CPU_ISSET(core, &allowed)) CPU_SET(core, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(available_cores(), 1);
    EXPECT_EQ(parse_threads("auto"), 1);
    sched_setaffinity(0, sizeof allowed, &allowed);
}

TEST(Threads, AreAWholeNumber) {
    EXPECT_EQ(parse_threads("3"), 3);
    for (const char* text :
         {"", "0", "-1", "2.5", "3x", " 3", "4097", "99999999999999"})
        EXPECT_THROW(parse_threads(text), Error) << text;
}

TEST(Ranks, KnowTheLauncher) {
    for (const char* name : {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"})
        unsetenv(name);
    EXPECT_FALSE(launch_of_this_process().is_launched);
    EXPECT_EQ(start_session().size(), 1);
    setenv("PMI_RANK", "2", 1);
    setenv("PMI_SIZE", "5", 1);
    const Launch launch = launch_of_this_process();
    EXPECT_TRUE(launch.is_launched);
    EXPECT_EQ(launch.rank, 2);
    EXPECT_EQ(launch.size, 5);
    unsetenv("PMI_RANK");
}

}  // namespace
}  // namespace ideotype
