// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <utility>

namespace fairway {

/// A value or nothing, as std::optional, but kept elsewhere: whoever may have one and has none is small. A
/// copy copies the value.
template <class T>
class Boxed {
 public:
  Boxed() = default;
  Boxed(const std::optional<T>& value) : value_{value ? std::make_unique<T>(*value) : nullptr} {}
  Boxed(const Boxed& other) : value_{other.value_ ? std::make_unique<T>(*other.value_) : nullptr} {}
  Boxed(Boxed&&) noexcept = default;
  Boxed& operator=(Boxed other) noexcept {
    value_ = std::move(other.value_);
    return *this;
  }
  ~Boxed() = default;

  template <class... Args>
  void emplace(Args&&... args) {
    value_ = std::make_unique<T>(std::forward<Args>(args)...);
  }

  explicit operator bool() const { return value_ != nullptr; }
  T* get() { return value_.get(); }  ///< null for nothing
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace fairway
