// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "fairway/record/bytes.hpp"

namespace fairway {

/// Writes one ROS 2 message as plain CDR, little-endian (OMG DDSI-RTPS 2.2, clause 10: encapsulation
/// 0x0001; CORBA 3.3, part 2, clause 9.3): every number is aligned to its size, counted from behind the
/// 4-byte encapsulation header.
class CdrWriter {
 public:
  /// Empties `out` and starts the message in it; its capacity is kept.
  explicit CdrWriter(Bytes& out) : out_{out} {
    out_.clear();
    put(out_, std::uint32_t{0x00000100});  // 00 01 00 00
  }

  template <class T>
    requires std::is_arithmetic_v<T>
  void number(T value) {
    align(sizeof(T));
    put(out_, value);
  }

  void boolean(bool value) { number(static_cast<std::uint8_t>(value)); }

  /// Length with the terminating zero, bytes, zero.
  void text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    put(out_, bytes_of(value));
    out_.push_back(std::byte{0});
  }

  /// An array of fixed length: no count before it.
  void array(std::span<const double> values) {
    if (values.empty()) return;
    align(sizeof(double));
    put(out_, std::as_bytes(values));
  }

  /// A fixed array of `count` zeros.
  void zeros(std::size_t count) {
    align(sizeof(double));
    out_.resize(out_.size() + count * sizeof(double));
  }

  /// A sequence: its count, then its elements.
  void sequence(std::span<const double> values) {
    number(static_cast<std::uint32_t>(values.size()));
    array(values);
  }

 private:
  void align(std::size_t size) { out_.resize(out_.size() + (size - (out_.size() - 4) % size) % size); }

  Bytes& out_;
};

/// Reads what CdrWriter writes. Throws Malformed at the end of the message or on another encapsulation.
class CdrReader {
 public:
  explicit CdrReader(ByteView message) : size_{message.size()}, reader_{message} {
    if (reader_.number<std::uint32_t>() != 0x00000100) {
      damaged("a message is not little-endian CDR");
    }
  }

  template <class T>
    requires std::is_arithmetic_v<T>
  T number() {
    align(sizeof(T));
    return reader_.number<T>();
  }

  bool boolean() { return number<std::uint8_t>() != 0; }

  /// A sequence of bytes; valid as long as the message.
  ByteView bytes() { return reader_.take(number<std::uint32_t>()); }

  /// Text; valid as long as the message.
  std::string_view text() {
    const ByteView with_zero = bytes();
    if (with_zero.empty() || with_zero.back() != std::byte{0}) {
      damaged("a text does not end");
    }
    const std::string_view value{reinterpret_cast<const char*>(with_zero.data()), with_zero.size() - 1};
    expect_text(value);
    return value;
  }

  void skip_text() { reader_.take(number<std::uint32_t>()); }

  void array(std::span<double> values) {
    if (values.empty()) return;
    align(sizeof(double));
    std::memcpy(values.data(), reader_.take(values.size_bytes()).data(), values.size_bytes());
  }

  void skip_array(std::size_t count) {
    align(sizeof(double));
    reader_.take(count * sizeof(double));
  }

  /// Appends a sequence to `values` and returns its count.
  std::uint32_t sequence(std::vector<double>& values) {
    const auto count = number<std::uint32_t>();
    if (count == 0) return 0;
    align(sizeof(double));
    const ByteView elements = reader_.take(std::uint64_t{count} * sizeof(double));
    const std::size_t before = values.size();
    values.resize(before + count);
    std::memcpy(values.data() + before, elements.data(), elements.size());
    return count;
  }

  /// Throws Malformed if something is left.
  void finish() const {
    if (reader_.remaining() > 0) damaged("a message is longer than its schema");
  }

 private:
  void align(std::size_t size) {
    const std::size_t offset = size_ - reader_.remaining() - 4;
    reader_.take((size - offset % size) % size);
  }

  std::size_t size_;
  ByteReader reader_;
};

}  // namespace fairway
