// SPDX-License-Identifier: GPL-3.0-or-later
#include "realtime/tick_guard.h"

#include <cerrno>
#include <cstddef>
#include <dlfcn.h>
#include <pthread.h>
#include <typeinfo>
#include <unistd.h>

// The C library's own entries, so that ours can pass on without looking anything up (glibc exports them).
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);
}

namespace chiron::tests {

namespace {
// Plain thread-locals of the program itself: reading them allocates nothing.
thread_local bool t_inTick = false;
thread_local std::array<std::uint64_t, kForbiddenNames.size()> t_counts{};

void note(Forbidden kind) noexcept {
    if (t_inTick)
        ++t_counts[static_cast<std::size_t>(kind)];
}

template <class Function> Function* next(const char* name) noexcept {
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
} // namespace

std::uint64_t ForbiddenCounts::total() const {
    std::uint64_t sum = 0;
    for (const auto c : count)
        sum += c;
    return sum;
}

TickGuard::TickGuard() noexcept {
    t_inTick = true;
}
TickGuard::~TickGuard() {
    t_inTick = false;
}

ForbiddenCounts forbiddenCounts() noexcept {
    return {t_counts};
}
void resetForbiddenCounts() noexcept {
    t_counts = {};
}

} // namespace chiron::tests

using chiron::tests::Forbidden;
using chiron::tests::next;
using chiron::tests::note;

extern "C" {

void* malloc(std::size_t size) {
    note(Forbidden::allocate);
    return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
    note(Forbidden::allocate);
    return __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) {
    note(Forbidden::allocate);
    return __libc_realloc(old, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
    note(Forbidden::allocate);
    return __libc_memalign(alignment, size);
}
int posix_memalign(void** result, std::size_t alignment, std::size_t size) {
    note(Forbidden::allocate);
    *result = __libc_memalign(alignment, size);
    return *result == nullptr ? ENOMEM : 0;
}
void free(void* old) {
    note(Forbidden::release);
    __libc_free(old);
}
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept {
    static int (*const original)(pthread_mutex_t*) = next<int(pthread_mutex_t*)>("pthread_mutex_lock");
    note(Forbidden::lock);
    return original(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept {
    static int (*const original)(pthread_mutex_t*) = next<int(pthread_mutex_t*)>("pthread_mutex_trylock");
    note(Forbidden::lock);
    return original(mutex);
}
int pthread_cond_signal(pthread_cond_t* condition) noexcept {
    static int (*const original)(pthread_cond_t*) = next<int(pthread_cond_t*)>("pthread_cond_signal");
    note(Forbidden::notify);
    return original(condition);
}
int pthread_cond_broadcast(pthread_cond_t* condition) noexcept {
    static int (*const original)(pthread_cond_t*) = next<int(pthread_cond_t*)>("pthread_cond_broadcast");
    note(Forbidden::notify);
    return original(condition);
}
ssize_t write(int file, const void* data, std::size_t size) {
    static ssize_t (*const original)(int, const void*, std::size_t) =
        next<ssize_t(int, const void*, std::size_t)>("write");
    note(Forbidden::write);
    return original(file, data, size);
}

} // extern "C"

namespace __cxxabiv1 {
extern "C" [[noreturn]] void __cxa_throw(void* thrown, std::type_info* type, void (*destructor)(void*)) {
    using Throw = void(void*, std::type_info*, void (*)(void*));
    static Throw* const original = next<Throw>("__cxa_throw");
    note(Forbidden::raise);
    original(thrown, type, destructor);
    __builtin_unreachable();
}
} // namespace __cxxabiv1
