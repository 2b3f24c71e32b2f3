// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace faults {

//! Kinds of calls; the calls of a kind are counted together and fail together.
enum class Kind {
    write,
    reserve,
    sync,
    open,
    rename,
    read,
    map,
    allocate,
    grow,
    start,
    send,
    receive,
    count
};

//! The effect of the plan on one call.
struct Fault {
    int error = 0;            //!< errno of a call that fails, or 0
    bool is_short = false;    //!< the call transfers half of its bytes
    bool is_delayed = false;  //!< the call takes half a second longer
    explicit operator bool() const {
        return error != 0 || is_short || is_delayed;
    }
};

//! Records that main() begins. Earlier allocations are not counted, because no
//! program can report a lack of memory in constructors of static objects.
void begin_main();

//! Counts a call of the given kind and returns its effect.
//! \param path path of the file concerned; null if there is none
Fault next(Kind kind, const char* path = nullptr);

//! Counts a call on an open file, like next(). The file name is looked up only
//! if the plan depends on it.
Fault next_of_file(Kind kind, int descriptor);

}  // namespace faults
