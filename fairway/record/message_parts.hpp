// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "fairway/core/params.hpp"
#include "fairway/core/vec.hpp"
#include "fairway/record/cdr.hpp"
#include "fairway/record/messages.hpp"

// What the encodings of all messages have in common.

namespace fairway {

inline std::span<const double> values(const Vec3& v) { return {v.data(), 3}; }
inline std::span<double> values(Vec3& v) { return {v.data(), 3}; }
inline std::span<const double> values(const Wrench& w) { return {w.data(), 6}; }
inline std::span<double> values(Wrench& w) { return {w.data(), 6}; }

// Eigen keeps x, y, z, w, which is the order of geometry_msgs/Quaternion
inline std::span<const double> values(const Eigen::Quaterniond& q) { return {q.coeffs().data(), 4}; }
inline std::span<double> values(Eigen::Quaterniond& q) { return {q.coeffs().data(), 4}; }

/// std_msgs/Header.
inline void put_header(CdrWriter& cdr, Stamp stamp, std::string_view frame = world_frame) {
  constexpr std::uint64_t second = 1'000'000'000;
  cdr.number(static_cast<std::int32_t>(stamp.nanoseconds / second));
  cdr.number(static_cast<std::uint32_t>(stamp.nanoseconds % second));
  cdr.text(frame);
}

inline void skip_header(CdrReader& cdr) {
  cdr.number<std::int32_t>();
  cdr.number<std::uint32_t>();
  cdr.skip_text();
}

/// Throws Malformed for a number that no enumerator has.
template <class E>
E enumerator(std::uint8_t value, std::string_view what) {
  if (value >= EnumNames<E>::names.size()) {
    damaged("a " + std::string(what) + " is " + std::to_string(value) + "; expected 0 to " +
            std::to_string(EnumNames<E>::names.size() - 1));
  }
  return static_cast<E>(value);
}

}  // namespace fairway
