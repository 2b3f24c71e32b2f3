// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <thread>

#include "mpi_fixture.hpp"
#include "parallel/session.hpp"

namespace ideotype {

class SessionOnAllRanks : public OnAllRanks {};

TEST_F(SessionOnAllRanks, RanksAreNumberedFromZero) {
    EXPECT_GE(session().rank(), 0);
    EXPECT_LT(session().rank(), session().size());
    EXPECT_EQ(session().largest(session().rank()), session().size() - 1);
}

TEST_F(SessionOnAllRanks, LargestIsTheMaximumOverAllRanks) {
    const bool is_last = session().rank() == session().size() - 1;
    EXPECT_EQ(session().largest(is_last ? 3 : 0), 3);
    EXPECT_EQ(session().largest(-2 - session().rank()), -2);
}

TEST_F(SessionOnAllRanks, TextOfRankZeroIsBroadcast) {
    const std::string long_text(3'000'000, 'x');
    for (const std::string& text :
         {std::string(), std::string("name = \"\0\xc3\xa4\"", 11), long_text}) {
        const std::string sent = is_master() ? text : "something else";
        EXPECT_TRUE(session().broadcast(sent) == text) << text.size();
    }
}

TEST_F(SessionOnAllRanks, TextsOfAllRanksAreGatheredOnRankZero) {
    const auto make_text = [](int rank) {
        return std::string(static_cast<std::size_t>(3 * rank), 'x') + '\0' +
               std::to_string(rank);
    };
    const auto texts = session().gather(make_text(session().rank()));
    if (!is_master()) {
        EXPECT_TRUE(texts.empty());
        return;
    }
    ASSERT_EQ(texts.size(), static_cast<std::size_t>(session().size()));
    for (int rank = 0; rank < session().size(); ++rank)
        EXPECT_EQ(texts[static_cast<std::size_t>(rank)], make_text(rank));
}

TEST_F(SessionOnAllRanks, PartsAreSeparateSessions) {
    const int part = session().rank() % 2;
    const Session half = session().split(part);
    EXPECT_EQ(half.size(), (session().size() + 1 - part) / 2);
    EXPECT_EQ(half.rank(), session().rank() / 2);
    for (int rank = 0; rank < half.size(); ++rank)
        EXPECT_EQ(half.rank_in_job(rank), 2 * rank + part);
    EXPECT_EQ(half.largest(session().rank()), 2 * (half.size() - 1) + part);
    const std::string text = "part " + std::to_string(part);
    EXPECT_EQ(half.broadcast(half.rank() == 0 ? text : ""), text);
}

TEST_F(SessionOnAllRanks, RanksSleepWhileTheyWaitForABroadcast) {
    const double before = cpu_seconds();
    if (is_master()) std::this_thread::sleep_for(std::chrono::seconds(1));
    session().broadcast("at last");
    EXPECT_LT(cpu_seconds() - before, 0.25);
}

TEST_F(SessionOnAllRanks, LibraryVersionIsReported) {
    const std::string version = Session::library_version();
    EXPECT_NE(version.find("MPI"), std::string::npos) << version;
    EXPECT_EQ(version.find_first_of("\n\t:"), std::string::npos) << version;
}

}  // namespace ideotype
