// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "ideotype/core/random.hpp"
#include "ideotype/physiology/leaf.hpp"
#include "leaf_kernels.hpp"

namespace ideotype {
namespace {

struct Arrays {
    explicit Arrays(std::size_t count)
        : value(count), slope(count), curvature(count) {}

    std::vector<double> value, slope, curvature;
};

// The kernel, compiled for one instruction set each.
template <class Response>
void plain(const Response& response, const std::vector<double>& light,
           Arrays& all) {
    expand_all(response, light.size(), light.data(), all.value.data(),
               all.slope.data(), all.curvature.data());
}

#if defined(__x86_64__)
template <class Response>
__attribute__((target("arch=x86-64-v3"))) void avx2(
    const Response& response, const std::vector<double>& light, Arrays& all) {
    expand_all(response, light.size(), light.data(), all.value.data(),
               all.slope.data(), all.curvature.data());
}

template <class Response>
__attribute__((target("arch=x86-64-v4"))) void avx512(
    const Response& response, const std::vector<double>& light, Arrays& all) {
    expand_all(response, light.size(), light.data(), all.value.data(),
               all.slope.data(), all.curvature.data());
}
#endif

std::uint64_t bits(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

//! Expects the bits of the response at each light, which is computed alone.
template <class Response>
void expect_bits(const char* kernel, const Response& response,
                 const std::vector<double>& light, const Arrays& all) {
    for (std::size_t i = 0; i < light.size(); ++i) {
        const Expansion at = response.expand(light[i]);
        ASSERT_EQ(bits(all.value[i]), bits(at.value)) << kernel << light[i];
        ASSERT_EQ(bits(all.slope[i]), bits(at.slope)) << kernel << light[i];
        ASSERT_EQ(bits(all.curvature[i]), bits(at.curvature))
            << kernel << light[i];
    }
}

template <class Response>
void expect_same_on_all_instruction_sets(const Response& response,
                                         const std::vector<double>& light) {
    Arrays all(light.size());
    expand(response, light, all.value.data(), all.slope.data(),
           all.curvature.data());
    expect_bits("as chosen ", response, light, all);
    plain(response, light, all);
    expect_bits("sse2 ", response, light, all);
#if defined(__x86_64__)
    __builtin_cpu_init();
    if (__builtin_cpu_supports("avx2")) {
        avx2(response, light, all);
        expect_bits("avx2 ", response, light, all);
    }
    if (__builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq")) {
        avx512(response, light, all);
        expect_bits("avx512 ", response, light, all);
    }
#endif
}

//! Light from darkness to far above the sun's, in a number of points that fills
//! no vector.
std::vector<double> levels(RandomStream& stream) {
    std::vector<double> light{0, 1e-310, 1e-200, 1e-12, 1e-3, 1e3, 1e9, 1e150};
    for (int i = 0; i < 95; ++i) light.push_back(stream.uniform(0, 3000));
    return light;
}

TEST(LeafKernels, GiveTheBitsOfTheHyperbolaOnEachInstructionSet) {
    RandomStream stream(1, Purpose::stream, 0, 0);
    for (int i = 0; i < 300; ++i) {
        Hyperbola leaf{stream.uniform(.02, .1), stream.uniform(),
                       stream.uniform(0, 80)};
        if (i % 10 == 0) leaf.theta = i % 20 == 0 ? 0 : 1;
        if (i % 15 == 0) leaf.amax = 0;
        expect_same_on_all_instruction_sets(leaf, levels(stream));
    }
}

TEST(LeafKernels, GiveTheBitsOfColimitationOnEachInstructionSet) {
    RandomStream stream(2, Purpose::stream, 0, 0);
    for (int i = 0; i < 300; ++i) {
        Colimitation leaf{stream.uniform(.02, .1), stream.uniform(0, 80),
                          stream.uniform(), stream.uniform(),
                          stream.uniform(0, 80)};
        if (i % 10 == 0) leaf.theta = leaf.beta = i % 20 == 0 ? 0 : 1;
        if (i % 15 == 0) leaf.limit = 0;
        expect_same_on_all_instruction_sets(leaf, levels(stream));
    }
}

}  // namespace
}  // namespace ideotype
