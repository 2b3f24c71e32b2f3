// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>

#include "cli/verbs.hpp"

namespace {

//! Opens the standard files that are closed, so that no history gets the number
//! of one of them. Reads and writes fail as if they were closed.
void reserve_standard_files() {
    for (const int file : {0, 1, 2})
        if (fcntl(file, F_GETFD) == -1)
            open("/dev/null", file == 0 ? O_WRONLY : O_RDONLY);
}

}  // namespace

int main(int argc, char** argv) {
    reserve_standard_files();
    return ideotype::run_command_line(argc, argv);
}
