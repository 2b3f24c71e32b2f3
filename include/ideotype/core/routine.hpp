// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <coroutine>
#include <exception>
#include <optional>
#include <utility>

#include "ideotype/core/contract.hpp"

namespace ideotype {

//! A coroutine that returns a Result and pauses until awaited events occur. It
//! begins with start(), or when another routine awaits it; that routine resumes
//! after this one ends. All routines share one thread. Arguments by reference
//! must outlive the routine.
template <class Result>
class [[nodiscard]] Routine {
  public:
    struct promise_type;
    using Handle = std::coroutine_handle<promise_type>;

    Routine(Routine&& other) noexcept
        : handle_(std::exchange(other.handle_, nullptr)) {}
    Routine& operator=(Routine&& other) noexcept {
        std::swap(handle_, other.handle_);
        return *this;
    }
    //! Destroys the routine. A paused routine is unwound from its pause, as by
    //! an exception.
    ~Routine() {
        if (handle_) handle_.destroy();
    }

    //! Runs the routine until it pauses or returns. Call it once.
    void start() {
        IDEOTYPE_EXPECT(handle_ && !handle_.done());
        handle_.resume();
    }

    bool has_ended() const {
        IDEOTYPE_EXPECT(handle_);
        return handle_.done();
    }

    //! Returns the result of a routine that has ended, or rethrows its
    //! exception. Call it once.
    Result result() {
        IDEOTYPE_EXPECT(handle_ && handle_.done());
        promise_type& promise = handle_.promise();
        if (promise.failure) std::rethrow_exception(promise.failure);
        return std::move(*promise.value);
    }

    // The following functions allow other routines to co_await this one.
    bool await_ready() const noexcept { return false; }
    Handle await_suspend(std::coroutine_handle<> awaiting) noexcept {
        handle_.promise().awaiting = awaiting;
        return handle_;
    }
    Result await_resume() { return result(); }

  private:
    explicit Routine(Handle handle) : handle_(handle) {}

    Handle handle_;
};

//! The functions from which the compiler builds a Routine.
template <class Result>
struct Routine<Result>::promise_type {
    //! Resumes the routine that awaits this one when this one ends.
    struct Return {
        bool await_ready() const noexcept { return false; }
        std::coroutine_handle<> await_suspend(Handle handle) const noexcept {
            return handle.promise().awaiting;
        }
        void await_resume() const noexcept {}
    };

    Routine get_return_object() { return Routine(Handle::from_promise(*this)); }
    std::suspend_always initial_suspend() const noexcept { return {}; }
    Return final_suspend() const noexcept { return {}; }
    void return_value(Result result) { value.emplace(std::move(result)); }
    void unhandled_exception() { failure = std::current_exception(); }

    std::optional<Result> value;
    std::exception_ptr failure;
    std::coroutine_handle<> awaiting = std::noop_coroutine();
};

}  // namespace ideotype
