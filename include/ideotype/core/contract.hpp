// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace ideotype {

//! A bug in the program: a caller or a function has violated its contract. The
//! type does not derive from Error, so it is not mistaken for an input error.
//! If thrown in a `noexcept` function, it ends the program with its message.
class ContractError : public std::logic_error {
  public:
    using std::logic_error::logic_error;
};

//! Throws a ContractError with the file, the line and the text of a condition.
//! @param kind "precondition" or "promise"
[[noreturn]] void fail_contract(const char* kind, const char* condition,
                                const char* file, int line);

}  // namespace ideotype

// The build option IDEOTYPE_CONTRACTS decides whether contracts are checked.
// Unchecked conditions are still compiled, so that they stay valid, but never
// evaluated.
#ifdef IDEOTYPE_CONTRACTS
#define IDEOTYPE_CONTRACT(kind, condition, text) \
    ((condition)                                 \
         ? static_cast<void>(0)                  \
         : ::ideotype::fail_contract(kind, text, __FILE_NAME__, __LINE__))
#else
#define IDEOTYPE_CONTRACT(kind, condition, text) \
    static_cast<void>(false && (condition))
#endif

//! Checks a condition that the caller of a function must meet.
#define IDEOTYPE_EXPECT(...) \
    IDEOTYPE_CONTRACT("precondition", (__VA_ARGS__), #__VA_ARGS__)

//! Checks a promise about a result, or about the state of an object.
#define IDEOTYPE_ENSURE(...) \
    IDEOTYPE_CONTRACT("promise", (__VA_ARGS__), #__VA_ARGS__)
