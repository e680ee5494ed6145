// SPDX-License-Identifier: Apache-2.0
// Debian's libc++abi for WebAssembly throws nothing. This is what compiled code asks for when it throws and
// catches: the Itanium C++ ABI, level II (https://itanium-cxx-abi.github.io/cxx-abi/abi-eh.html), for one
// thread. WebAssembly itself unwinds; what is left to do is to keep the object, and to find the handler of
// its type in the table of a function.
#include <cstdint>
#include <cstdlib>
#include <new>
#include <typeinfo>

namespace {

/// In front of what was thrown.
struct alignas(16) Thrown {
  const std::type_info* type;
  void* (*destroy)(void*);  // here a destructor returns what it destroyed
  void* seen;               // what was thrown, as its handler sees it
  int handlers;             // that hold it
  bool rethrown;            // by one of them
  Thrown* before;           // caught before this one and not yet let go
};

Thrown* caught = nullptr;  // the last one

void* object_of(Thrown* thrown) { return thrown + 1; }
Thrown* of_object(void* object) { return static_cast<Thrown*>(object) - 1; }

void let_go(Thrown* thrown) {
  if (thrown->destroy != nullptr) thrown->destroy(object_of(thrown));
  std::free(thrown);
}

std::uint32_t read_unsigned(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const std::uint8_t byte = *at++;
    value |= (byte & 0x7FU) << shift;
    if ((byte & 0x80U) == 0) return value;
  }
}

std::int32_t read_signed(const std::uint8_t*& at) {
  std::uint32_t value = 0;
  for (unsigned shift = 0;;) {
    const std::uint8_t byte = *at++;
    value |= (byte & 0x7FU) << shift;
    shift += 7;
    if ((byte & 0x80U) != 0) continue;
    if ((byte & 0x40U) != 0 && shift < 32) value |= ~std::uint32_t{0} << shift;
    return static_cast<std::int32_t>(value);
  }
}

/// The order of virtual functions in libc++abi's description of a type (private_typeinfo.h), which knows what
/// catches what.
class CatchingType : public std::type_info {
 public:
  ~CatchingType() override;
  virtual void noop1() const;
  virtual void noop2() const;
  virtual bool can_catch(const std::type_info* thrown, void*& object) const = 0;
};

constexpr std::uint8_t left_out = 0xFF;

/// The number, in a function's table of types, of the first handler that catches `thrown` at its landing pad
/// `pad`; 0 if none does, so that it flies on.
std::int32_t handler_of(Thrown* thrown, const std::uint8_t* table, std::uint32_t pad) {
  if (table == nullptr) return 0;
  if (*table++ != left_out) std::abort();  // pads are numbers, they begin nowhere
  const std::uint8_t* types = nullptr;
  if (*table++ != left_out) {
    const std::uint32_t length = read_unsigned(table);
    types = table + length;
  }
  ++table;  // pads are written as unsigned numbers
  const std::uint32_t length = read_unsigned(table);
  const std::uint8_t* const actions = table + length;
  std::uint32_t first = 0;
  for (std::uint32_t i = 0; i <= pad; ++i) {
    if (table >= actions) std::abort();
    read_unsigned(table);
    first = read_unsigned(table);
  }
  if (first == 0) return 0;

  for (const std::uint8_t* action = actions + first - 1;;) {
    const std::int32_t index = read_signed(action);
    if (index > 0) {
      const auto* type = reinterpret_cast<const CatchingType* const*>(types)[-index];
      void* seen = object_of(thrown);
      if (type == nullptr || type->can_catch(thrown->type, seen)) {
        thrown->seen = seen;
        return index;
      }
    }
    const std::uint8_t* const here = action;
    const std::int32_t next = read_signed(action);
    if (next == 0) return 0;
    action = here + next;
  }
}

}  // namespace

extern "C" {

/// What a landing pad tells the personality, and is told.
struct LandingPad {
  std::uint32_t index;
  const std::uint8_t* table;
  std::int32_t selector;
};
thread_local LandingPad __wasm_lpad_context;

int __gxx_wasm_personality_v0(...) { return 0; }

int _Unwind_CallPersonality(void* thrown) {
  __wasm_lpad_context.selector =
      handler_of(static_cast<Thrown*>(thrown), __wasm_lpad_context.table, __wasm_lpad_context.index);
  return 0;
}

void* __cxa_allocate_exception(std::size_t size) noexcept {
  void* memory = std::calloc(1, sizeof(Thrown) + size);
  if (memory == nullptr) std::abort();
  return object_of(static_cast<Thrown*>(memory));
}

void __cxa_free_exception(void* object) noexcept { std::free(of_object(object)); }

[[noreturn]] void __cxa_throw(void* object, std::type_info* type, void* (*destroy)(void*)) {
  Thrown* thrown = of_object(object);
  thrown->type = type;
  thrown->destroy = destroy;
  thrown->seen = object;
  __builtin_wasm_throw(0, thrown);
}

void* __cxa_get_exception_ptr(void* thrown) noexcept { return static_cast<Thrown*>(thrown)->seen; }

void* __cxa_begin_catch(void* flying) noexcept {
  auto* thrown = static_cast<Thrown*>(flying);
  thrown->rethrown = false;
  if (++thrown->handlers == 1) {
    thrown->before = caught;
    caught = thrown;
  }
  return thrown->seen;
}

void __cxa_end_catch() {
  Thrown* thrown = caught;
  if (thrown == nullptr || --thrown->handlers > 0) return;
  caught = thrown->before;
  if (!thrown->rethrown) let_go(thrown);
}

[[noreturn]] void __cxa_rethrow() {
  if (caught == nullptr) std::abort();
  caught->rethrown = true;
  __builtin_wasm_throw(0, caught);
}

}  // extern "C"
