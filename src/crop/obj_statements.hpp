// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace ideotype {

//! The number of times that a finding occurs in a file, and its first line.
struct Occurrences {
    int count = 0;
    int first_line = 0;

    void add(int line) {
        if (count++ == 0) first_line = line;
    }
};

//! The statements of an OBJ text that define surfaces: v, f, g and o.
struct ObjStatements {
    std::string text;  //!< statements, one per line, continuations joined
    std::vector<int> vertex_lines;  //!< line in the file, per vertex
    std::vector<int> face_lines;    //!< line in the file, per face
    Occurrences unknown;  //!< statements that the OBJ standard lacks; ignored
};

//! Extracts the statements that define surfaces, and checks their numbers,
//! because the library would read other words as zero.
//! @throws InputError with the location of the first word that is not a number.
ObjStatements pick_statements(const std::string& text, const std::string& file);

}  // namespace ideotype
