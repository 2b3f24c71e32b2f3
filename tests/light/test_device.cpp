// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "ideotype/light/device.hpp"

namespace ideotype {
namespace {

TEST(Device, EverySupportedInstructionSetWorks) {
    const auto isas = Device::supported_isas();
    ASSERT_FALSE(isas.empty());
    for (const std::string& isa : isas) EXPECT_EQ(Device(isa).isa(), isa);
}

TEST(Device, RefusesAnUnknownInstructionSet) {
    EXPECT_THROW(Device("neon"), Error);
}

}  // namespace
}  // namespace ideotype
