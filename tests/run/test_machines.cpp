// SPDX-License-Identifier: Apache-2.0
#include <functional>

#include <gtest/gtest.h>

#include "ideotype/core/error.hpp"
#include "run/job/machines.hpp"

namespace ideotype {
namespace {

const std::vector<std::string> wide{"sse2", "sse4.2", "avx", "avx2", "avx512"};
const std::vector<std::string> usual{"sse2", "sse4.2", "avx", "avx2"};
const std::vector<std::string> odd{"sse2", "avx"};

Machine machine(const std::string& host, const std::vector<std::string>& isas) {
    return {host, {{"maths", "1"}, {"program_version", "0.1.1"}}, isas};
}

std::string refusal(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        EXPECT_EQ(error.exit_code(), ExitCode::refused);
        return error.what();
    }
    return "";
}

TEST(Machines, RoundTripThroughText) {
    EXPECT_EQ(machine_of(to_text(this_machine())), this_machine());
}

TEST(Machines, UseTheWidestCommonInstructionSet) {
    const auto choose = [](std::vector<Machine> machines) {
        return choose_isa(machines, {}, "");
    };
    EXPECT_EQ(choose({machine("a", wide)}), "avx512");
    EXPECT_EQ(choose({machine("a", wide), machine("b", usual)}), "avx2");
    EXPECT_EQ(choose({machine("a", usual), machine("b", wide)}), "avx2");
    EXPECT_EQ(
        choose({machine("a", wide), machine("b", usual), machine("c", odd)}),
        "avx");
}

TEST(Machines, UseTheRequestedInstructionSet) {
    EXPECT_EQ(choose_isa({machine("a", wide), machine("b", usual)}, "avx", ""),
              "avx");
}

TEST(Machines, NameTheHostThatLacksAnInstructionSet) {
    EXPECT_EQ(refusal([] {
                  choose_isa({machine("a", wide), machine("b", usual)},
                             "avx512", "take another");
              }),
              "b has no instruction set avx512 (it has sse2, sse4.2, avx, "
              "avx2); take another");
}

TEST(Machines, MustRunTheSameProgramAndMathsLibrary) {
    std::vector<Machine> machines{machine("a", wide), machine("b", usual)};
    EXPECT_EQ(refusal([&] { require_same_program(machines); }), "");
    machines[1].program["maths"] = "2";
    const std::string text = refusal([&] { require_same_program(machines); });
    EXPECT_NE(text.find("maths is 1 on a, but 2 on b"), std::string::npos)
        << text;
}

}  // namespace
}  // namespace ideotype
