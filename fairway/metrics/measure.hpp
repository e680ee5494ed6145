// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace fairway {

/// One number that a run produced.
struct Measure {
  static constexpr int fleet = -1;

  std::string quantity;  ///< ends in its unit: "navigation_time_s"
  int vehicle{fleet};    ///< index of the vehicle it belongs to, or `fleet`
  double value{};

  friend bool operator==(const Measure&, const Measure&) = default;
};

}  // namespace fairway
