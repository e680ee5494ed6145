// SPDX-License-Identifier: Apache-2.0
#include "fairway/embed/testing/interruptions.hpp"

#include <atomic>

#include "fairway/core/testing/sanitizers.hpp"

#if FAIRWAY_ADDRESS_SANITIZED || FAIRWAY_THREAD_SANITIZED

fairway::Interruptions fairway::interruptions() { return {}; }
bool fairway::counts_interruptions() { return false; }

#else

#include <dlfcn.h>
#include <pthread.h>
#include <semaphore.h>

#include <cerrno>
#include <cstddef>

namespace {

std::atomic<long> allocations{0};
std::atomic<long> throws{0};
std::atomic<long> locks{0};

/// What `name` would be without us. Not kept in a static variable: its guard is one of those counted.
template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// glibc's own, by the names that it keeps for those who stand in for malloc
extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
void* realloc(void* memory, std::size_t size) {
  ++allocations;
  return __libc_realloc(memory, size);
}
void* memalign(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t size) {
  ++allocations;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

int pthread_mutex_lock(pthread_mutex_t* mutex) {
  ++locks;
  return real<int(pthread_mutex_t*)>("pthread_mutex_lock")(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) {
  ++locks;
  return real<int(pthread_mutex_t*)>("pthread_mutex_trylock")(mutex);
}
int pthread_rwlock_rdlock(pthread_rwlock_t* lock) {
  ++locks;
  return real<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock")(lock);
}
int pthread_rwlock_wrlock(pthread_rwlock_t* lock) {
  ++locks;
  return real<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock")(lock);
}
int pthread_spin_lock(pthread_spinlock_t* lock) {
  ++locks;
  return real<int(pthread_spinlock_t*)>("pthread_spin_lock")(lock);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex) {
  ++locks;
  return real<int(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait")(condition, mutex);
}
int sem_wait(sem_t* semaphore) {
  ++locks;
  return real<int(sem_t*)>("sem_wait")(semaphore);
}

// named so in the object file only: compilers know these by declarations of their own
[[noreturn]] void counted_throw(void*, void*, void (*)(void*)) asm("__cxa_throw");
int counted_guard(void*) asm("__cxa_guard_acquire");

void counted_throw(void* thrown, void* type, void (*destroy)(void*)) {
  ++throws;
  real<void(void*, void*, void (*)(void*))>("__cxa_throw")(thrown, type, destroy);
  __builtin_unreachable();
}
int counted_guard(void* guard) {
  ++locks;
  return real<int(void*)>("__cxa_guard_acquire")(guard);
}

}  // extern "C"

fairway::Interruptions fairway::interruptions() { return {allocations, throws, locks}; }
bool fairway::counts_interruptions() { return true; }

#endif
