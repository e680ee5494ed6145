// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fairway/core/record.hpp"
#include "fairway/core/rng.hpp"
#include "fairway/core/speech.hpp"

namespace fairway {

/// What modems measure of distances: nothing; the way of each word, by the sender's clock and the receiver's;
/// or the way there and back of a word and its answer, by which clocks need not go alike.
enum class RangingKind { none, one_way, two_way };

template <>
struct EnumNames<RangingKind> {
  static constexpr std::array names{"none", "one_way", "two_way"};
};

/// Distances by the time that sound takes, as every vehicle measures them to every other. A value: a copy is
/// a snapshot. Nothing is drawn or kept where nothing is measured.
class Ranging {
 public:
  struct Settings {
    RangingKind kind{};
    double sound_speed{};  ///< as the modems take it [m/s]
    double deviation{};    ///< standard, of one measurement [m]
  };

  /// A word on its way, or one that it answers: when it began to be sent and to be heard, each by the clock
  /// on board of who did [s].
  struct Way {
    double sent{};
    double heard{};
  };

  Ranging(const Settings& settings, std::size_t vehicle_count, const Rng& rng);

  /// What a word of `from` to `to` answers: the latest that `from` has heard of `to`, if any.
  std::optional<Way> answered(std::size_t from, std::size_t to) const;

  /// A word of `from` has come in at `to`; `answered` is what it was when it was sent. O(1), allocates
  /// nothing.
  void take(std::size_t from, std::size_t to, const Way& way, const std::optional<Way>& answered);

  /// The last of each of the others that `receiver` has measured, by vehicle, which is also what it is `to`;
  /// empty where nothing is.
  std::span<const std::optional<AcousticRange>> by(std::size_t receiver) const;

 private:
  struct Pair {
    Rng noise;
    std::optional<Way> latest{};
  };

  Settings settings_;
  std::size_t vehicle_count_;
  std::vector<Pair> pairs_;  // by receiver, then sender
  std::vector<std::optional<AcousticRange>> ranges_;
};

}  // namespace fairway
