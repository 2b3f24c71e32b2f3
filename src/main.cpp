// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>

#include "cli/commands.hpp"

namespace {

//! If standard files are closed, opens them as /dev/null, so that no history
//! gets one of their file descriptors. Reading and writing still fail, as with
//! closed files.
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
