// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <toml++/toml.h>

#include "spec/problems.hpp"
#include "spec/section.hpp"

namespace ideotype {

//! Reports faults in the value of one key.
struct ValueFaults {
    using enum ProblemCode;

    const std::string& section;
    const BoundKey& bound;
    const Problems& problems;
    const Key& key = bound.key;

    //! Returns the name of the key for messages.
    std::string name() const;
    //! Reports a fault, described by a text that follows the name of the key.
    template <class... Args>
    void fail(ProblemCode code, fmt::format_string<Args...> text,
              Args&&... args) const {
        problems.add(key.name, code, "{} {}", name(),
                     fmt::format(text, std::forward<Args>(args)...));
    }
    //! Reports a value of the wrong type. If removing quotes would help,
    //! suggests this.
    void fail_type(const toml::node& found) const;
    //! Returns whether a number is in range, and reports it if not.
    bool accepts(double value) const;

  private:
    std::string fault(double value) const;
    bool is_mistaken(double value) const;
};

//! Reads one value and checks its type and range. Record the position of the
//! value in `problems` before the call.
//! @param section name of the table for messages
void read_value(const toml::node& node, const std::string& section,
                const BoundKey& key, const KnownNames& known,
                const Problems& problems);

}  // namespace ideotype
