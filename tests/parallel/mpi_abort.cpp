// SPDX-License-Identifier: Apache-2.0
#include <chrono>
#include <iostream>
#include <thread>

#include "parallel/session.hpp"

//! Ends one rank by an error while the other ranks still run.
int main() {
    const ideotype::Session session;
    if (session.rank() != 1) {
        std::this_thread::sleep_for(std::chrono::minutes(1));
        return 0;
    }
    std::cout << "last words";
    session.abort(4);
}
