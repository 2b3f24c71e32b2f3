// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ideotype {

//! What a dimension counts: numbers in the axis' unit, whole numbers or names.
using Coordinates = std::variant<std::vector<double>, std::vector<std::int64_t>,
                                 std::vector<std::string>>;

//! A dimension of quantities, such as leaf or hour, with the place of each of
//! its entries.
struct Axis {
    std::string name;
    std::string unit;  //!< "1" of whole numbers, "" of names
    std::string meaning;
    Coordinates coordinates;

    std::size_t size() const {
        return std::visit([](const auto& each) { return each.size(); },
                          coordinates);
    }
};

//! An axis that counts from a first number.
Axis counted(const std::string& name, const std::string& meaning,
             std::size_t size, std::int64_t first = 0);

//! Whether a quantity follows from the scene or is estimated.
enum class Certainty { estimated, exact };

//! Something that is measured: numbers along axes, in row-major order.
struct Quantity {
    std::string name;
    std::string unit;
    std::string meaning;
    std::vector<std::string> axes{};  //!< by name; none: a single number
    //! Of an exact quantity no standard error is kept.
    Certainty certainty = Certainty::estimated;
};

//! Quantities that belong together, and the axes that they share.
struct QuantitySet {
    std::vector<Axis> axes;
    std::vector<Quantity> quantities;

    //! @throws std::out_of_range if there is none of this name.
    const Axis& axis(const std::string& name) const;

    bool has(const std::string& quantity) const;

    //! Numbers of a quantity.
    std::size_t size(const Quantity& quantity) const;

    //! Numbers of all quantities.
    std::size_t size() const;

    //! Where the numbers of a quantity begin among those of all.
    //! @throws std::out_of_range if there is none of this name.
    std::size_t offset(const std::string& name) const;
};

}  // namespace ideotype
