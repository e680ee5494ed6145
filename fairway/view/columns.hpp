// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "fairway/core/limits.hpp"
#include "fairway/metrics/progress.hpp"
#include "fairway/record/frame.hpp"

namespace fairway {

/// What a film's frames are made of that the frames of a run do not say themselves.
struct FrameExtras {
  std::span<const Vec3> currents;          ///< at each of the film's depths [m/s, NED]
  std::span<const std::uint8_t> alerts;    ///< of each vehicle, as the page numbers them
  std::span<const Shared<Limits>> limits;  ///< of each vehicle
  const ProgressMetric& progress;          ///< that has seen this frame
};

/// The numbers of a film, a column after the other, each frame after frame, little-endian. Memory is the
/// page's: positions and times as doubles, to the bit, the rest as floats.
class FilmColumns {
 public:
  FilmColumns(std::size_t vehicles, std::size_t current_depths);

  /// Name, type, width of each, in their order in a part: `columns` of the page's document.
  static nlohmann::json specs(std::size_t current_depths);

  void append(const Frame& frame, const FrameExtras& extras);

  std::size_t size() const { return size_; }
  /// The time of a frame < size() [s].
  double time(std::size_t frame) const;

  /// Drops every second frame; the first stays. O(size).
  void halve();

  /// The bytes of frames [first, first + count), column after column. O(count).
  std::string bytes(std::size_t first, std::size_t count) const;

 private:
  struct Column {
    std::size_t row;  ///< bytes per frame
    std::string bytes;
  };

  std::vector<Column> columns_;
  std::size_t size_{};
};

}  // namespace fairway
