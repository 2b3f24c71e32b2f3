// SPDX-License-Identifier: Apache-2.0
// Replaces functions of the C and C++ libraries if LD_PRELOAD names this
// library. Calls fail as plan.cpp decides.
#include <algorithm>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <new>
#include <pthread.h>
#include <unistd.h>

#include <sys/mman.h>
#include <sys/uio.h>

#include "plan.hpp"

using faults::Fault;
using faults::Kind;
using faults::next;
using faults::next_of_file;

namespace {

//! Returns the original function of this name, which the function in this file
//! replaces.
template <typename Function>
Function* hidden(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

std::size_t half(std::size_t size) {
    return std::max<std::size_t>(size / 2, std::min<std::size_t>(size, 1));
}

//! Calls a function that transfers bytes; as planned, the call fails or
//! transfers only half of the bytes.
template <typename Call>
ssize_t transfer(Kind kind, int file, std::size_t size, Call call) {
    const Fault fault = next_of_file(kind, file);
    if (fault.error != 0) {
        errno = fault.error;
        return -1;
    }
    return call(fault.is_short ? half(size) : size);
}

bool fails(const Fault& fault) {
    if (fault.error != 0) errno = fault.error;
    return fault.error != 0;
}

mode_t mode_of(int flags, va_list words) {
    return (flags & (O_CREAT | O_TMPFILE)) != 0
               ? static_cast<mode_t>(va_arg(words, int))
               : 0;
}

void* allocated(std::size_t size, std::size_t alignment) {
    if (fails(next(Kind::allocate))) return nullptr;
    void* memory = nullptr;
    const std::size_t bytes = std::max<std::size_t>(size, 1);
    if (alignment <= alignof(std::max_align_t)) {
        static auto* const real = hidden<decltype(malloc)>("malloc");
        return real(bytes);
    }
    static auto* const real =
        hidden<decltype(posix_memalign)>("posix_memalign");
    return real(&memory, alignment, bytes) == 0 ? memory : nullptr;
}

void* allocated_or_thrown(std::size_t size, std::size_t alignment) {
    if (void* memory = allocated(size, alignment)) return memory;
    throw std::bad_alloc();
}

using Main = int(int, char**, char**);
Main* real_main = nullptr;

int counted_main(int count, char** words, char** environment) {
    faults::begin_main();
    return real_main(count, words, environment);
}

}  // namespace

extern "C" {

// NOLINTBEGIN(readability-identifier-naming): names of the C library.
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
// NOLINTEND(readability-identifier-naming)

// NOLINTNEXTLINE(readability-identifier-naming): the entry point of the C
// library.
int __libc_start_main(Main* main_function, int count, char** words,
                      void (*first)(), void (*last)(), void (*loader)(),
                      void* stack) {
    static auto* const real =
        hidden<decltype(__libc_start_main)>("__libc_start_main");
    real_main = main_function;
    return real(counted_main, count, words, first, last, loader, stack);
}

ssize_t write(int file, const void* bytes, std::size_t size) {
    static auto* const real = hidden<decltype(write)>("write");
    return transfer(Kind::write, file, size,
                    [&](std::size_t n) { return real(file, bytes, n); });
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t at) {
    static auto* const real = hidden<decltype(pwrite)>("pwrite");
    return transfer(Kind::write, file, size,
                    [&](std::size_t n) { return real(file, bytes, n, at); });
}

ssize_t pwrite64(int file, const void* bytes, std::size_t size, off64_t at) {
    static auto* const real = hidden<decltype(pwrite64)>("pwrite64");
    return transfer(Kind::write, file, size,
                    [&](std::size_t n) { return real(file, bytes, n, at); });
}

// The C++ library writes files with writev; writing only the first part is a
// short write.
ssize_t writev(int file, const iovec* parts, int count) {
    static auto* const real = hidden<decltype(writev)>("writev");
    return transfer(
        Kind::write, file, static_cast<std::size_t>(count),
        [&](std::size_t n) { return real(file, parts, static_cast<int>(n)); });
}

ssize_t read(int file, void* bytes, std::size_t size) {
    static auto* const real = hidden<decltype(read)>("read");
    return transfer(Kind::read, file, size,
                    [&](std::size_t n) { return real(file, bytes, n); });
}

ssize_t pread(int file, void* bytes, std::size_t size, off_t at) {
    static auto* const real = hidden<decltype(pread)>("pread");
    return transfer(Kind::read, file, size,
                    [&](std::size_t n) { return real(file, bytes, n, at); });
}

ssize_t pread64(int file, void* bytes, std::size_t size, off64_t at) {
    static auto* const real = hidden<decltype(pread64)>("pread64");
    return transfer(Kind::read, file, size,
                    [&](std::size_t n) { return real(file, bytes, n, at); });
}

int fallocate(int file, int mode, off_t offset, off_t size) {
    static auto* const real = hidden<decltype(fallocate)>("fallocate");
    return fails(next_of_file(Kind::reserve, file))
               ? -1
               : real(file, mode, offset, size);
}

int fallocate64(int file, int mode, off64_t from, off64_t size) {
    return fallocate(file, mode, from, size);
}

int ftruncate(int file, off_t size) {
    static auto* const real = hidden<decltype(ftruncate)>("ftruncate");
    return fails(next_of_file(Kind::reserve, file)) ? -1 : real(file, size);
}

int ftruncate64(int file, off64_t size) {
    return ftruncate(file, size);
}

int fsync(int file) {
    static auto* const real = hidden<decltype(fsync)>("fsync");
    return fails(next_of_file(Kind::sync, file)) ? -1 : real(file);
}

int fdatasync(int file) {
    static auto* const real = hidden<decltype(fdatasync)>("fdatasync");
    return fails(next_of_file(Kind::sync, file)) ? -1 : real(file);
}

int open(const char* path, int flags, ...) {
    static auto* const real = hidden<decltype(open)>("open");
    va_list words;
    va_start(words, flags);
    const mode_t mode = mode_of(flags, words);
    va_end(words);
    return fails(next(Kind::open, path)) ? -1 : real(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
    va_list words;
    va_start(words, flags);
    const mode_t mode = mode_of(flags, words);
    va_end(words);
    return open(path, flags, mode);
}

int openat(int folder, const char* path, int flags, ...) {
    static auto* const real = hidden<decltype(openat)>("openat");
    va_list words;
    va_start(words, flags);
    const mode_t mode = mode_of(flags, words);
    va_end(words);
    return fails(next(Kind::open, path)) ? -1 : real(folder, path, flags, mode);
}

int openat64(int folder, const char* path, int flags, ...) {
    va_list words;
    va_start(words, flags);
    const mode_t mode = mode_of(flags, words);
    va_end(words);
    return openat(folder, path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
    static auto* const real = hidden<decltype(fopen)>("fopen");
    return fails(next(Kind::open, path)) ? nullptr : real(path, mode);
}

FILE* fopen64(const char* path, const char* mode) {
    return fopen(path, mode);
}

int rename(const char* old_path, const char* to) {
    static auto* const real = hidden<decltype(rename)>("rename");
    return fails(next(Kind::rename, to)) ? -1 : real(old_path, to);
}

int link(const char* old_path, const char* to) {
    static auto* const real = hidden<decltype(link)>("link");
    return fails(next(Kind::rename, to)) ? -1 : real(old_path, to);
}

int unlink(const char* path) {
    static auto* const real = hidden<decltype(unlink)>("unlink");
    return fails(next(Kind::rename, path)) ? -1 : real(path);
}

void* mmap(void* where, std::size_t size, int protection, int flags, int file,
           off_t offset) {
    static auto* const real = hidden<decltype(mmap)>("mmap");
    const Fault fault =
        file < 0 ? next(Kind::map, "") : next_of_file(Kind::map, file);
    return fails(fault) ? MAP_FAILED
                        : real(where, size, protection, flags, file, offset);
}

void* mmap64(void* where, std::size_t size, int protection, int flags, int file,
             off64_t from) {
    return mmap(where, size, protection, flags, file, from);
}

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes,
                   void* (*action)(void*), void* argument) {
    static auto* const real =
        hidden<decltype(pthread_create)>("pthread_create");
    const Fault fault = next(Kind::start);
    return fault.error != 0 ? fault.error
                            : real(thread, attributes, action, argument);
}

// Allocations of C; `operator new` is counted separately.
void* malloc(std::size_t size) {
    return fails(next(Kind::grow)) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) {
    return fails(next(Kind::grow)) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) {
    return fails(next(Kind::grow)) ? nullptr : __libc_realloc(memory, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
    static auto* const real =
        hidden<decltype(posix_memalign)>("posix_memalign");
    return fails(next(Kind::grow)) ? ENOMEM : real(memory, alignment, size);
}

}  // extern "C"

void* operator new(std::size_t size) {
    return allocated_or_thrown(size, 0);
}
void* operator new[](std::size_t size) {
    return allocated_or_thrown(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return allocated_or_thrown(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return allocated_or_thrown(size, static_cast<std::size_t>(alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return allocated(size, 0);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return allocated(size, 0);
}
