// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fairway/core/ids.hpp"

namespace fairway {

/// What a stroke of a Sketch means, with a number in it, without allocating: "allowed by vehicle 3". What
/// does not fit is cut off. O(length).
class Label {
 public:
  /// `what` and who `id` is: "vehicle 3", "contact 5" of a sensor, "drifter 0".
  Label(std::string_view what, TrackId id) noexcept {
    const std::uint32_t serial = number(id);
    append(what);
    if (serial >= first_drifter_id) {
      append(" drifter ", serial - first_drifter_id);
    } else if (serial >= first_tracker_id) {
      append(" contact ", serial - first_tracker_id);
    } else {
      append(" vehicle ", serial);
    }
  }

  /// "class 2".
  Label(std::string_view what, std::uint32_t count) noexcept {
    append(what);
    append(" ", count);
  }

  operator std::string_view() const noexcept {  // NOLINT(google-explicit-constructor): it is text
    return {text_.data(), size_};
  }

 private:
  void append(std::string_view text) noexcept {
    const std::size_t fitting = std::min(text.size(), text_.size() - size_);
    std::copy_n(text.begin(), fitting, text_.begin() + static_cast<std::ptrdiff_t>(size_));
    size_ += fitting;
  }

  void append(std::string_view text, std::uint32_t count) noexcept {
    append(text);
    std::array<char, 10> digits;
    const char* const end = std::to_chars(digits.data(), digits.data() + digits.size(), count).ptr;
    append({digits.data(), static_cast<std::size_t>(end - digits.data())});
  }

  std::array<char, 64> text_;
  std::size_t size_ = 0;
};

}  // namespace fairway
