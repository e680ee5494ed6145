// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "fairway/avoidance/pledge/reference.hpp"
#include "fairway/core/speech.hpp"

namespace fairway::delay_check {

/// At a place until it departs, then evenly and straight on to another, where it stays for ever.
struct Trajectory {
  Vec3 from = Vec3::Zero();  ///< [m, NED]
  Vec3 to = Vec3::Zero();    ///< [m, NED]
  double departs{};          ///< [s]
  double ends{};             ///< [s]

  static Trajectory standing(const Vec3& place, double time) { return {place, place, time, time}; }

  pledge::Reference reference() const noexcept;

  friend bool operator==(const Trajectory&, const Trajectory&) = default;
};

/// What a vehicle says in its turn: what it has committed to, and what it will commit to if nothing speaks
/// against it.
struct Word {
  double radius{};  ///< of its sphere [m]
  Trajectory committed{};
  std::optional<Trajectory> next{};  ///< it begins on the committed one, at its `departs`
};

/// 25 bytes. Places are told relative to `datum`, +-163 m from it and down to 327 m, in steps of 2 cm, times
/// in steps of 0.1 s. What has ended by `now` [s] is told as standing. O(1).
Speech encode(const Word& word, const Vec2& datum, double now) noexcept;

/// The word that the bytes say, if it was sent within 204 s of `now` [s] and was not damaged. O(1).
std::optional<Word> decode(const Speech& speech, const Vec2& datum, double now) noexcept;

/// The word as everybody comes to know it.
Word as_told(const Word& word, const Vec2& datum, double now) noexcept;

}  // namespace fairway::delay_check
