// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fairway/core/tick.hpp"
#include "fairway/record/recording.hpp"

namespace fairway {

/// How two recordings differ. Frames are compared at the ticks that both have.
struct Difference {
  struct First {
    Tick tick{};
    double time{};         ///< [s]
    std::string vehicle;   ///< name; none of messages under way
    std::string quantity;  ///< "x_m", "mode", "actuator_2", "tracks[0].x_m", "sketch[3].size"
    std::string a;         ///< its value in the first recording, to full precision
    std::string b;
  };
  struct Farthest {
    double distance{};  ///< between the two positions [m]
    Tick tick{};
    double time{};  ///< [s]
    std::string vehicle;
  };

  std::vector<std::string> setup;    ///< "seed: 1 against 2": how the runs were set up, one line each
  std::optional<First> first;        ///< where they first part, to the bit
  std::optional<Farthest> farthest;  ///< where the same vehicle is farthest apart, if it ever is apart
  std::size_t compared{};            ///< frames at common ticks
  std::size_t only_in_a{};           ///< frames at other ticks
  std::size_t only_in_b{};
  std::size_t vehicles_a{};
  std::size_t vehicles_b{};

  /// The same frames, to the bit. The setup may differ all the same: another version, say.
  bool same() const { return !first && only_in_a == 0 && only_in_b == 0 && vehicles_a == vehicles_b; }

  /// The above in words, several lines.
  std::string describe() const;
};

/// O(frames × vehicles). Vehicles are matched by index. What was perceived or drawn is compared
/// if both recorded it.
Difference diff(const Recording& a, const Recording& b);

}  // namespace fairway
