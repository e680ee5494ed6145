// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>
#include <vector>

namespace fairway {

/// A value that whoever copies it has in common with the original, so that of many alike there is one in
/// memory. A value like any other: what is changed of one is not seen by another. Nothing is kept of a plain
/// T{}. It is read as a T by itself; a copy costs as much as one of std::shared_ptr.
template <class T>
class Shared {
 public:
  Shared() = default;
  Shared(T value) : value_{std::make_shared<const T>(std::move(value))} {}

  const T& operator*() const { return value_ ? *value_ : plain(); }
  const T* operator->() const { return &**this; }
  operator const T&() const { return **this; }  // NOLINT(google-explicit-constructor): it is a T

  /// To be changed: a copy of its own. Valid until this is assigned to or edited again.
  T& edit() {
    auto own = std::make_shared<T>(**this);
    T& value = *own;
    value_ = std::move(own);
    return value;
  }

  friend bool operator==(const Shared& a, const Shared& b) { return a.value_ == b.value_ || *a == *b; }

 private:
  static const T& plain() {
    static const T value{};
    return value;
  }

  std::shared_ptr<const T> value_;
};

/// Has `value` in common with `other` if both are the same.
template <class T>
void share_if_same(Shared<T>& value, const Shared<T>& other) {
  if (value == other) value = other;
}

}  // namespace fairway
