// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <toml++/toml.h>

#include "campaign/problems.hpp"
#include "campaign/schema/schema.hpp"

namespace ideotype {

//! Reports what is wrong with the value of one key.
struct ValueFaults {
    const std::string& section;
    const Key& key;
    const Problems& problems;

    //! Returns the name of the key in messages.
    std::string name() const;
    //! Reports a fault, which follows the name of the key.
    void fail(const std::string& what) const;
    //! Reports a value of another type, and a text that would be of the right
    //! type without its quotes.
    void fail_type(const toml::node& found) const;
    //! Returns whether a number is in the range; otherwise reports it.
    bool accepts(double value) const;

  private:
    std::string fault(double value) const;
    bool is_mistaken(double value) const;
};

}  // namespace ideotype
