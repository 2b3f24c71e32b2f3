// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace faults {

//! Calls that are counted, and fail, together.
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
    int error = 0;            //!< errno of the call that fails; 0 if it is cut
    bool is_short = false;    //!< it transfers half of its bytes
    bool is_delayed = false;  //!< it takes half a second longer
    explicit operator bool() const {
        return error != 0 || is_short || is_delayed;
    }
};

//! Tells that main() begins, before which no allocation is counted: of what
//! constructors of libraries and static objects lack, nobody can tell.
void begin_main();

//! Counts a call of this kind and returns what is to be done to it.
//! \param what the file, if any; null otherwise
Fault next(Kind kind, const char* what = nullptr);

//! As next(), for an open file: its name is asked only if somebody wants it.
Fault next_of_file(Kind kind, int descriptor);

}  // namespace faults
