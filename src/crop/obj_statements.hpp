// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! The number of occurrences of something in a file, and the first place.
struct Occurrences {
    int count = 0;
    int first_line = 0;

    void add(int line) {
        if (count++ == 0) first_line = line;
    }
};

//! The statements of an OBJ text that make surfaces: v, f, g and o.
struct ObjStatements {
    std::string text;  //!< statements, one per line, continuations joined
    std::vector<int> vertex_lines;  //!< line in the file, per vertex
    std::vector<int> face_lines;    //!< line in the file, per face
    Occurrences unknown;  //!< statements not in the OBJ standard, left out
};

//! Picks the statements out of an OBJ text and checks for words that are no
//! numbers, which the library would read as zero.
//! @throws InputError with the place of the first such word.
ObjStatements pick_statements(const std::string& text, const std::string& file);

}  // namespace ideotype
