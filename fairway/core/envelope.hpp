// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>

#include "fairway/core/angles.hpp"
#include "fairway/core/lanes/number.hpp"
#include "fairway/core/math.hpp"
#include "fairway/core/record.hpp"

namespace fairway {

/// How a hull moves sideways through the water over a step of time: a turn sets it outwards by its momentum,
/// and what resists that grows in proportion to the sway, part of it with the square. `Real` is a number or a
/// pack of them (lanes/number.hpp), to the same bits.
struct Slip {
  double by_turn;  ///< in a steady turn, by turn rate and speed, were all resistance in proportion [s]
  double share;    ///< of the way there, gone in the step
  double linear;   ///< resistance of what is left after it, in proportion
  double square;   ///< four times that by the square; 0: none [s/m]

  /// To starboard positive [m/s], by an implicit step of Euler. O(1).
  template <class Real>
  Real after(const Real& sway, const Real& speed, const Real& turn_rate) const {
    using lanes::magnitude, lanes::square_root;
    const Real even = sway - share * (by_turn * turn_rate * magnitude(speed) + sway);
    if (!(square > 0.0)) return even;
    const Real resistance = linear + square_root(linear * linear + square * magnitude(even));
    return 2.0 * even / lanes::larger<Real>(resistance, std::numeric_limits<double>::min());
  }
};

/// What a vehicle under its autopilot can do in still water: the envelope of the closed loop that a method
/// commands. Plain numbers, so that on board they can be given instead of measured.
struct Envelope {
  static constexpr std::size_t turn_rate_count = 4;
  static constexpr std::size_t change_count = 6;

  double ahead{};
  double astern{};
  double sideways{};
  double up{};
  double down{};
  double least{};
  double acceleration{};
  double deceleration{};
  double surge_lag{};
  double turn_acceleration{};
  double turn_lag{};
  double pivot{};
  double sway_lag{};
  std::array<double, turn_rate_count> turn_rates{};
  std::array<double, change_count> following_errors{};
  double deceleration_lost{};
  double turn_tail{};
  double slip_square{};
  double turn_plateau{1.0};
  double foresight_error{};

  static consteval auto members() {
    using R = Envelope;
    return std::tuple{
        member<&R::ahead>("mps", "greatest speed ahead").required().not_negative(),
        member<&R::astern>("mps", "greatest speed astern").not_negative(),
        member<&R::sideways>("mps", "greatest speed to either side").not_negative(),
        member<&R::up>("mps", "fastest up, while going ahead").not_negative(),
        member<&R::down>("mps", "fastest down, while going ahead").not_negative(),
        member<&R::least>("mps", "it can go no slower and steer").not_negative(),
        member<&R::acceleration>("mps2", "mean from the least speed to four fifths of the greatest")
            .required()
            .not_negative(),
        member<&R::deceleration>("mps2", "constant, of the same stopping distance as from the greatest speed")
            .required()
            .not_negative(),
        member<&R::deceleration_lost>("mps2", "of the deceleration, while it takes up its greatest turn rate")
            .not_negative(),
        member<&R::surge_lag>("s", "in which 63 % of a small change of speed is made").not_negative(),
        member<&R::turn_acceleration>("radps2", "greatest change of the turn rate").required().not_negative(),
        member<&R::turn_lag>("s", "in which 63 % of a small change of the turn rate is made").not_negative(),
        member<&R::turn_tail>("s", "by which the heading in a long turn is later than the lag alone makes it")
            .not_negative(),
        member<&R::turn_plateau>("ratio",
                                 "of a turn rate, to which it comes by the lag; to the rest by the tail")
            .not_negative(),
        member<&R::foresight_error>("m",
                                    "by which it gets farther than these numbers foresee, while it stops; of "
                                    "who cannot stop, elsewhere, in the first 8 s of a turn")
            .not_negative(),
        member<&R::pivot>(
            "m",
            "ahead of the origin, where the hull does not slip sideways in a steady turn at the "
            "greatest speed and turn rate"),
        member<&R::slip_square>("ratio",
                                "of what resists the slip in that turn: so much grows with its square, the "
                                "rest in proportion")
            .not_negative(),
        member<&R::sway_lag>("s", "time constant with which a slip as in that turn dies away at first")
            .not_negative(),
        member<&R::turn_rates>("radps", "greatest, at 0, 1/3, 2/3 and 1 of the greatest speed"),
        member<&R::following_errors>(
            "m",
            "bound on the distance from a point that takes up a commanded velocity at once, for courses "
            "that change by 30, 60, 90, 120, 150 and 180 degrees at nine tenths of the greatest speed"),
    };
  }

  /// The greatest turn rate at a speed [rad/s], between those of the table by straight lines. O(1).
  double turn_rate(double speed) const noexcept {
    return between(turn_rates, ahead > 0.0 ? std::abs(speed) / ahead * (turn_rate_count - 1) : 0.0);
  }

  /// Its slip over a step of time. [s]
  Slip slip(double step) const noexcept {
    const double share = 1.0 - math::exp(-step / std::max(sway_lag, 1e-3));
    const double greatest = std::abs(pivot * turn_rates.back());  // in the turn of which `slip_square` tells
    const double square = greatest > 0.0 ? share * slip_square : 0.0;
    return {.by_turn = ahead > 0.0 ? pivot / ahead : 0.0,
            .share = share,
            .linear = 1.0 - square,
            .square = square > 0.0 ? 4.0 * square / greatest : 0.0};
  }

  /// Sideways through the water in a steady turn, to starboard positive [m/s]. O(1).
  double steady_sway(double speed, double turn_rate) const noexcept {
    return slip(std::numeric_limits<double>::infinity()).after(0.0, speed, turn_rate);
  }

  /// The bound on the error of following a velocity whose course changes by `change` [rad, either way]: none
  /// for no change. [m] O(1).
  double following_error(double change) const noexcept {
    const double place = std::abs(change) / (pi / change_count);
    return place < 1.0 ? place * following_errors[0] : between(following_errors, place - 1.0);
  }

  friend bool operator==(const Envelope&, const Envelope&) = default;

 private:
  template <std::size_t N>
  static double between(const std::array<double, N>& values, double place) noexcept {
    const auto i = std::min(static_cast<std::size_t>(std::max(0.0, place)), N - 1);
    if (i + 1 == N) return values[N - 1];
    return values[i] + (place - static_cast<double>(i)) * (values[i + 1] - values[i]);
  }
};

}  // namespace fairway
