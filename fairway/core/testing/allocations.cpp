// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/testing/allocations.hpp"

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "fairway/core/testing/sanitizers.hpp"

namespace {
std::atomic<long> count{0};
}

#if FAIRWAY_THREAD_SANITIZED

// It brings its own `new`, which cannot be replaced, and calls this for every allocation.
extern "C" void __sanitizer_malloc_hook(const volatile void*, std::size_t) {
  count.fetch_add(1, std::memory_order_relaxed);
}

#else

namespace {
void* counted(std::size_t size, std::size_t alignment) {
  count.fetch_add(1, std::memory_order_relaxed);
  const std::size_t rounded = (size + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, rounded > 0 ? rounded : alignment)) return memory;
  throw std::bad_alloc{};
}
}  // namespace

// Replaced here and nowhere else: in its own file, so that the compiler cannot inline a `delete`
// next to somebody else's `new` and warn about the pair.
void* operator new(std::size_t size) { return counted(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
// The library's would come to the first of these, a sanitizer's own would not.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return operator new(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

#endif

long fairway::allocation_count() { return count.load(std::memory_order_relaxed); }
