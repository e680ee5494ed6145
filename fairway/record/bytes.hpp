// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "fairway/core/text.hpp"

namespace fairway {

static_assert(std::endian::native == std::endian::little, "MCAP and our CDR are little-endian");

using Bytes = std::vector<std::byte>;
using ByteView = std::span<const std::byte>;

inline ByteView bytes_of(std::string_view text) { return std::as_bytes(std::span{text}); }

/// Bytes that are not what the format says. what() is a sentence without the file's name, which whoever
/// opened the file puts before it.
class Malformed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void damaged(const std::string& what) { throw Malformed{"damaged recording: " + what}; }

/// Throws Malformed for bytes that are not UTF-8, which are no text.
inline void expect_text(std::string_view bytes) {
  if (not_utf8(bytes)) damaged("a text is not UTF-8");
}

/// Appends a block.
inline void put(Bytes& out, ByteView block) {
  const std::size_t before = out.size();
  out.resize(before + block.size());
  if (!block.empty()) std::memcpy(out.data() + before, block.data(), block.size());
}

/// Appends a number, little-endian.
template <class T>
  requires std::is_arithmetic_v<T>
void put(Bytes& out, T value) {
  put(out, std::as_bytes(std::span{&value, 1}));
}

/// Appends text behind its length as 4 bytes: MCAP's String.
inline void put_string(Bytes& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  put(out, bytes_of(text));
}

/// Reads from the front of a block. Nothing is ever read, or allocated, beyond its end.
class ByteReader {
 public:
  explicit ByteReader(ByteView bytes) : bytes_{bytes} {}

  std::size_t remaining() const { return bytes_.size(); }

  /// The next `count` bytes; throws Malformed if there are fewer.
  ByteView take(std::uint64_t count) {
    if (count > bytes_.size()) {
      throw Malformed{"damaged recording: a field of " + std::to_string(count) + " bytes where " +
                      std::to_string(bytes_.size()) + " are left"};
    }
    const ByteView taken = bytes_.first(static_cast<std::size_t>(count));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(count));
    return taken;
  }

  template <class T>
    requires std::is_arithmetic_v<T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    return value;
  }

  /// MCAP's String.
  std::string string() {
    std::string value = text(take(number<std::uint32_t>()));
    expect_text(value);
    return value;
  }

  static std::string text(ByteView bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

 private:
  ByteView bytes_;
};

}  // namespace fairway
