// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "ideotype/climate/site.hpp"
#include "ideotype/crop/crop.hpp"

namespace ideotype {

//! What a new campaign is for.
struct NewCampaign {
    std::string name;
    Site site;
    Date date;
    double row = 0;          //!< distance of rows [m]
    double plant = 0;        //!< distance of plants in a row [m]
    std::string plant_file;  //!< relative to the campaign
    Crop crop;               //!< in it
    std::string objective;
};

//! The text of a campaign file: all that matters, each key with its unit and
//! meaning. Light from sunrise to sunset; bounds are those of the traits, wider
//! where the baseline is beyond them.
//! @throws Error if the sun does not rise.
std::string text_of(const NewCampaign& campaign);

}  // namespace ideotype
