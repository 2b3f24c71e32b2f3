// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

namespace ideotype {

//! Several values of a type that consists of doubles, as a structure of arrays:
//! one array for each double, with one element for each value (a lane). A loop
//! over lanes that reads, computes and writes values becomes vectors. Values
//! are read and written double by double, by for_each_double(value, function),
//! because copies of whole structures would prevent that.
template <class T>
class alignas(64) Lanes {
  public:
    //! The number of lanes: the doubles in the widest vectors of x86-64.
    static constexpr std::size_t count = 8;

    [[gnu::always_inline]] T operator[](std::size_t lane) const {
        T value;
        std::size_t i = 0;
        for_each_double(value, [&](double& x) { x = arrays_[i++][lane]; });
        return value;
    }

    [[gnu::always_inline]] void set(std::size_t lane, T value) {
        std::size_t i = 0;
        for_each_double(value, [&](double& x) { arrays_[i++][lane] = x; });
    }

    //! Sets a value, or leaves the present one.
    [[gnu::always_inline]] void set_unless(bool stays, std::size_t lane,
                                           T value) {
        // All values are chosen before one is written, or loops would need
        // masked writes, which SSE2 does not have.
        std::size_t i = 0;
        for_each_double(value, [&](double& x) {
            x = stays ? arrays_[i][lane] : x;
            ++i;
        });
        set(lane, value);
    }

  private:
    // Values are set before they are read.
    double arrays_[sizeof(T) / sizeof(double)][count];
};

}  // namespace ideotype
