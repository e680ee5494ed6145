// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "fairway/record/frame.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

/// How much a page holds before it is thinned.
struct FilmLimits {
  std::size_t vehicle_frames = 400'000;               ///< frames times vehicles
  std::size_t thought_bytes = std::size_t{1} << 25U;  ///< of sketches, tracks and echoes, as text
};

/// A run as the page plays it: the frames, and what is worked out from each as it is seen: who is near whom
/// (by the rules that the metrics count with), events, how the water runs. Beyond its limits it keeps every
/// second frame, and again, so that memory stays bounded however long a run is; colours and events are those
/// of all frames. viewer/README.md describes what it writes.
class Film final : public FrameSink {
 public:
  /// The scenario must outlive it.
  explicit Film(const Scenario& scenario, FilmLimits limits = {});
  ~Film() override;

  void write(const Frame& frame) override;

  /// Frames kept.
  std::size_t size() const;
  /// One in so many of the frames seen was kept.
  std::size_t stride() const;
  /// Grows each time that frames which were kept are dropped: whoever asked for parts asks anew.
  std::size_t generation() const;

  /// Frames [first, first + most) and what belongs to them, as a `part` of the page's document. O(part).
  nlohmann::json part(std::size_t first, std::size_t most, bool compress) const;

  /// Empty, or what had to be left out, for the reader of the page.
  std::string notice() const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

}  // namespace fairway
