// SPDX-License-Identifier: Apache-2.0
#include "ideotype/core/version.hpp"

namespace ideotype {

const BuildInfo& build_info() {
    static const BuildInfo info{IDEOTYPE_VERSION, IDEOTYPE_GIT_SHA,
                                IDEOTYPE_GIT_DIRTY, IDEOTYPE_COMPILER,
                                IDEOTYPE_BUILD_TYPE};
    return info;
}

}  // namespace ideotype
