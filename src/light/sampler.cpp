#include "ideotype/light/sampler.hpp"

#include <bit>

namespace ideotype {

namespace {

//! A primitive polynomial and the initial direction integers of a dimension.
struct Dimension {
    unsigned degree;
    unsigned coefficients;
    std::array<std::uint32_t, 6> initial;
};

//! Dimensions 2 to 16 of the set new-joe-kuo-6.
constexpr std::array<Dimension, sobol_dimensions - 1> joe_kuo{{
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
}};

using Directions = std::array<std::uint32_t, 32>;

constexpr std::array<Directions, sobol_dimensions> make_directions() {
    std::array<Directions, sobol_dimensions> all{};
    for (unsigned bit = 0; bit < 32; ++bit) all[0][bit] = 1u << (31 - bit);
    for (std::size_t d = 1; d < sobol_dimensions; ++d) {
        const auto& [degree, coefficients, initial] = joe_kuo[d - 1];
        Directions& v = all[d];
        for (unsigned i = 0; i < degree; ++i) v[i] = initial[i] << (31 - i);
        for (unsigned i = degree; i < 32; ++i) {
            v[i] = v[i - degree] ^ (v[i - degree] >> degree);
            for (unsigned k = 1; k < degree; ++k)
                if (coefficients >> (degree - 1 - k) & 1) v[i] ^= v[i - k];
        }
    }
    return all;
}

constexpr auto directions = make_directions();

constexpr std::uint32_t reversed(std::uint32_t x) {
    x = (x & 0x55555555u) << 1 | (x >> 1 & 0x55555555u);
    x = (x & 0x33333333u) << 2 | (x >> 2 & 0x33333333u);
    x = (x & 0x0F0F0F0Fu) << 4 | (x >> 4 & 0x0F0F0F0Fu);
    return __builtin_bswap32(x);
}

}  // namespace

std::uint32_t sobol(std::uint32_t index, std::size_t dimension) {
    std::uint32_t x = 0;
    for (; index; index &= index - 1)
        x ^= directions[dimension]
                       [static_cast<unsigned>(std::countr_zero(index))];
    return x;
}

std::uint32_t scrambled(std::uint32_t x, std::uint32_t seed) {
    // Every step lets a bit act only on higher bits; with the bits reversed
    // that means on lower bits, as nested scrambling asks for.
    x = reversed(x);
    x ^= x * 0x3D20ADEAu;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526C56u;
    x ^= x * 0x53A22864u;
    return reversed(x);
}

PathSampler::PathSampler(std::uint64_t seed, std::uint32_t generation,
                         std::uint32_t randomisation, std::uint32_t source)
    : generation_(generation) {
    RandomStream of_randomisation(seed, Purpose::scramble, generation,
                                  randomisation);
    RandomStream stream(of_randomisation.bits64(), Purpose::scramble, source);
    for (std::uint32_t& s : scramble_seeds_) s = stream.bits();
    tail_seed_ = stream.bits64();
}

void PathSampler::begin(std::uint32_t path, std::size_t dimension) {
    path_ = path;
    dimension_ = dimension;
    tail_.reset();
}

double PathSampler::next() {
    if (dimension_ < sobol_dimensions) {
        const std::uint32_t x =
            scrambled(sobol(path_, dimension_), scramble_seeds_[dimension_]);
        ++dimension_;
        return x * 0x1p-32;
    }
    if (!tail_)
        tail_.emplace(tail_seed_, Purpose::scattering, generation_, path_);
    return tail_->uniform();
}

}  // namespace ideotype
