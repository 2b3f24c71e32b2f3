#pragma once

#include <vector>

#include "ideotype/crop/plant.hpp"

namespace ideotype {

//! Three unlike leaves on a stalk.
struct SamplePlant {
    BladeForm blade{
        {0.28, 0.885870, 0.895017, 1.149943, 0.379696, 0.0}, 10, 1.5};
    PlantForm form{"sample", {{90, 0.1}, {40, 0.9}, {0, 1.6}}, blade, {}};
    std::vector<LeafTraits> traits{{0.651, 0.073, 34, 90},
                                   {0.822, 0.085, 24.5, 270},
                                   {0.484, 0.0545, 80, 15}};
};

}  // namespace ideotype
