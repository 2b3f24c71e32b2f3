// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/canopy/request.hpp"

namespace ideotype {

//! The fields of an evaluation, and how light is traced in each.
struct Plan {
    explicit Plan(const CanopyRequest& request);

    //! Returns the random numbers of the plants of a field.
    Randomness of_plants(int field) const;

    //! Returns the random numbers of the light in a field.
    Randomness of_light(int field) const;

    Accuracy accuracy;  //!< accuracy in each field
    int fields = 1;
    //! Whether each field counts as a single randomisation of the result,
    //! although its light is traced in several randomisations.
    bool is_one_of_many = false;

  private:
    Randomness of_field(int field, int times) const;

    Randomness randomness_;
};

}  // namespace ideotype
