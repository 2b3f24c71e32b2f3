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

    Accuracy accuracy;  //!< in each field
    int fields = 1;
    //! Each field is one of many randomisations, with several of its own.
    bool is_one_of_many = false;

  private:
    Randomness of_field(int field, int times) const;

    Randomness randomness_;
};

}  // namespace ideotype
