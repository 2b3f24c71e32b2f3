// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

#include <gtest/gtest.h>

#include "parallel/session.hpp"

namespace ideotype {

//! The session that all tests share; every rank runs every test.
class OnAllRanks : public testing::Test {
  public:
    static void share(const Session& session) { shared_ = &session; }

  protected:
    static const Session& session() { return *shared_; }
    static bool is_master() { return session().rank() == 0; }

  private:
    static inline const Session* shared_ = nullptr;
};

//! Returns the processor time that this process has used [s].
inline double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

}  // namespace ideotype
