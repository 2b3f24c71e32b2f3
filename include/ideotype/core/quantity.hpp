// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ideotype {

//! The entries of an axis: numbers in the unit of the axis, whole numbers or
//! names.
using Coordinates = std::variant<std::vector<double>, std::vector<std::int64_t>,
                                 std::vector<std::string>>;

//! A dimension of quantities, such as leaf or hour, with the coordinates of its
//! entries.
struct Axis {
    std::string name;
    std::string unit;  //!< "1" for whole numbers, "" for names
    std::string meaning;
    Coordinates coordinates;

    std::size_t size() const {
        return std::visit([](const auto& values) { return values.size(); },
                          coordinates);
    }
};

//! Makes an axis that counts from a first number.
Axis counted(const std::string& name, const std::string& meaning,
             std::size_t size, std::int64_t first = 0);

//! Whether a quantity is estimated or follows exactly from the scene.
enum class Certainty { estimated, exact };

//! A measured quantity: numbers along axes, in row-major order.
struct Quantity {
    std::string name;
    std::string unit;
    std::string meaning;
    //! Names of the axes; none for a single number.
    std::vector<std::string> axes{};
    //! Exact quantities have no standard error.
    Certainty certainty = Certainty::estimated;
    //! Names that the values refer to by number, from 1. Empty: the values are
    //! measurements.
    std::vector<std::string> names{};
};

//! Related quantities and their axes.
struct QuantitySet {
    std::vector<Axis> axes;
    std::vector<Quantity> quantities;

    //! Returns the axis with this name. @throws std::out_of_range if there is
    //! none.
    const Axis& axis(const std::string& name) const;

    bool has(const std::string& quantity) const;

    //! Returns the number of values of a quantity.
    std::size_t size(const Quantity& quantity) const;

    //! Returns the number of values of all quantities together.
    std::size_t size() const;

    //! Returns the index of the first value of a quantity among the values of
    //! all quantities. @throws std::out_of_range if no quantity has this name.
    std::size_t offset(const std::string& name) const;
};

//! Returns whether two sets have a quantity along the same axes, with the same
//! coordinates.
//! @param quantity quantity of the first set
bool has_same_axes(const Quantity& quantity, const QuantitySet& first,
                   const QuantitySet& second);

}  // namespace ideotype
