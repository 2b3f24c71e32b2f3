// SPDX-License-Identifier: Apache-2.0
#pragma once

//! Compiles a function for several instruction sets, of which the program
//! selects one when it starts. Loops over arrays then use the widest vectors of
//! the processor. Results are bitwise the same, because sums, products,
//! quotients and square roots are rounded correctly everywhere and are never
//! contracted. A function of the C library, such as exp(), must not be called.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define IDEOTYPE_FOR_WIDE_VECTORS \
    __attribute__((               \
        target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define IDEOTYPE_FOR_WIDE_VECTORS
#endif
