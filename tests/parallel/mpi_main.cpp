// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include "mpi_fixture.hpp"

namespace {

//! Reports failures on ranks that are otherwise silent.
class FailuresOnly : public testing::EmptyTestEventListener {
  public:
    explicit FailuresOnly(int rank) : rank_(rank) {}

    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (result.failed())
            std::cerr << "rank " << rank_ << ": " << result.file_name() << ":"
                      << result.line_number() << ": " << result.message()
                      << std::endl;
    }

  private:
    int rank_;
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const ideotype::Session session;
    ideotype::OnAllRanks::share(session);
    if (session.rank() != 0) {
        auto& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailuresOnly(session.rank()));
    }
    return session.largest(RUN_ALL_TESTS());
}
