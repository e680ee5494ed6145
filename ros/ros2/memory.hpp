// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <string_view>
#include <type_traits>

namespace fairway::ros2 {

/// Owns the texts and sequences of messages that are being written, which Cyclone's C structs only point to,
/// as long as it lives. A text that is left null is written as the empty one.
class Memory {
 public:
  char* text(std::string_view words) {
    auto* text = static_cast<char*>(resource_.allocate(words.size() + 1, 1));
    std::copy(words.begin(), words.end(), text);
    text[words.size()] = '\0';
    return text;
  }

  /// Gives `sequence` room for `count` elements, all zero, and returns them.
  template <class Sequence>
  auto room(Sequence& sequence, std::size_t count) {
    using Element = std::remove_pointer_t<decltype(sequence._buffer)>;
    static_assert(std::is_trivially_copyable_v<Element>);
    auto* elements = static_cast<Element*>(
        resource_.allocate(std::max<std::size_t>(count, 1) * sizeof(Element), alignof(Element)));
    std::fill_n(elements, count, Element{});
    sequence._buffer = elements;
    sequence._length = sequence._maximum = static_cast<std::uint32_t>(count);
    sequence._release = false;
    return std::span{elements, count};
  }

 private:
  std::pmr::monotonic_buffer_resource resource_;
};

/// The elements of a sequence that was received.
template <class Sequence>
auto elements(const Sequence& sequence) {
  using Element = std::remove_pointer_t<decltype(sequence._buffer)>;
  return std::span<const Element>{sequence._buffer, sequence._length};
}

}  // namespace fairway::ros2
