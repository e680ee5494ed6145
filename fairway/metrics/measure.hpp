// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>

namespace fairway {

/// Where in a run a number comes from: the instant of its extreme or of the first event that it counts, and
/// who was there. What is not known, or has no meaning, is `none` or NaN.
struct Occasion {
  static constexpr int none = -1;

  int vehicle{none};                                      ///< index; also of a quantity of the fleet
  int other{none};                                        ///< index of the vehicle that it was with
  int obstacle{none};                                     ///< index of the obstacle that it was with
  double time{std::numeric_limits<double>::quiet_NaN()};  ///< [s]
};

/// One number that a run produced.
struct Measure {
  static constexpr int fleet = -1;

  std::string quantity;  ///< ends in its unit: "navigation_time_s"
  int vehicle{fleet};    ///< index of the vehicle it belongs to, or `fleet`
  double value{};
  Occasion occasion{};  ///< only of a run that was just made: stores do not keep it

  /// Whether both are the same number, wherever it comes from.
  friend bool operator==(const Measure& a, const Measure& b) {
    return a.quantity == b.quantity && a.vehicle == b.vehicle && a.value == b.value;
  }
};

}  // namespace fairway
