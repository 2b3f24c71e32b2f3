// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace faults {

//! Kinds of calls that are counted, and fail, together.
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

//! The treatment of a call.
struct Fault {
    int error = 0;            //!< errno of a call that fails, or 0
    bool is_short = false;    //!< the call transfers half of its bytes
    bool is_delayed = false;  //!< the call takes half a second longer
    explicit operator bool() const {
        return error != 0 || is_short || is_delayed;
    }
};

//! Records that main() begins. Allocations before main() are not counted: no
//! program can report that constructors of static objects lack memory.
void begin_main();

//! Counts a call of this kind and returns its treatment.
//! \param path path of the file of the call; null if it has none
Fault next(Kind kind, const char* path = nullptr);

//! Counts a call on an open file as next() does, and asks for the file's name
//! only if the plan needs it.
Fault next_of_file(Kind kind, int descriptor);

}  // namespace faults
