// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "ideotype/core/mesh.hpp"

namespace ideotype {

//! Returns a direction tilted just enough not to cross the stand almost
//! endlessly. The change is far smaller than any measurable angle.
glm::dvec3 not_level(glm::dvec3 d);

//! Returns a direction around a unit normal with density cos / pi (Lambert's
//! law). u and v are uniform in [0, 1). The basis is that of Duff et al. 2017
//! (jcgt.org/published/0006/01/01).
glm::dvec3 lambertian(const glm::dvec3& normal, double u, double v);

}  // namespace ideotype
