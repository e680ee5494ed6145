// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <concepts>
#include <cstddef>
#include <initializer_list>
#include <memory>
#include <type_traits>
#include <utility>

namespace fairway {

template <class T>
class Shared;

/// What a T can be made of, and is not shared yet.
template <class U, class T>
concept MakesShared = !std::same_as<std::remove_cvref_t<U>, Shared<T>> && std::constructible_from<T, U&&>;

/// A path is made of such texts.
template <class P, class T>
concept PathOf = std::same_as<typename P::string_type, T>;

/// A text or a list that many have and nobody changes: its copies share it, and each takes as much room as a
/// pointer. Empty ones take nothing else. Copies may be on several threads.
template <class T>
class Shared {
 public:
  using Item = typename T::value_type;

  Shared() = default;
  template <MakesShared<T> U>
  Shared(U&& all) {
    T value(std::forward<U>(all));
    if (!value.empty()) held_ = new Held{{1}, std::move(value)};
  }
  Shared(std::initializer_list<Item> all) : Shared{T(all)} {}
  Shared(const std::shared_ptr<const T>& all) {
    if (all != nullptr) *this = Shared{*all};
  }
  Shared(const Shared& other) noexcept : held_{other.held_} {
    if (held_ != nullptr) held_->users.fetch_add(1, std::memory_order_relaxed);
  }
  Shared(Shared&& other) noexcept : held_{std::exchange(other.held_, nullptr)} {}
  Shared& operator=(Shared other) noexcept {
    std::swap(held_, other.held_);
    return *this;
  }
  ~Shared() {
    if (held_ != nullptr && held_->users.fetch_sub(1, std::memory_order_acq_rel) == 1) delete held_;
  }

  const T& operator*() const noexcept {
    static const T nothing;
    return held_ != nullptr ? held_->value : nothing;
  }
  const T* operator->() const noexcept { return &**this; }
  operator const T&() const noexcept { return **this; }

  template <PathOf<T> Path>
  explicit operator Path() const {
    return Path(**this);
  }

  bool empty() const noexcept { return held_ == nullptr; }
  std::size_t size() const noexcept { return (**this).size(); }
  const Item& operator[](std::size_t i) const noexcept { return (**this)[i]; }
  const Item& at(std::size_t i) const { return (**this).at(i); }
  void clear() noexcept { *this = Shared{}; }

  friend bool operator==(const Shared& a, const Shared& b) { return a.held_ == b.held_ || *a == *b; }

 private:
  struct Held {
    std::atomic<std::size_t> users;
    T value;
  };
  Held* held_{nullptr};
};

}  // namespace fairway
