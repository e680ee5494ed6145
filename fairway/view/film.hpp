// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fairway/record/frame.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway {

class Catalog;

/// How much of a run a page holds, and how much of that before it is thinned.
struct FilmLimits {
  std::size_t vehicle_frames = 400'000;               ///< frames times vehicles
  std::size_t thought_bytes = std::size_t{1} << 25U;  ///< of sketches, tracks, echoes and messages, as text
  double from_s = 0.0;                                ///< what is earlier is not kept [s]
  double to_s = std::numeric_limits<double>::infinity();  ///< nor what is later [s]
  std::size_t every = 1;                                  ///< one in so many frames is kept to begin with
  std::optional<std::vector<std::size_t>>
      thinkers;  ///< of whom is kept what they drew, perceived and heard, by index; nothing: of everyone
};

/// How the columns of a part are written.
enum class Packing : std::uint8_t {
  plain,       ///< in base64
  compressed,  ///< by zstd, in base64
  apart,       ///< not in the part: whoever takes it asks for column_bytes()
};

/// A run as the page plays it: the frames, and what is worked out from each as it is seen: who is near whom
/// (by the metric that counts encounters itself), events, how the water runs. Beyond its limits it keeps
/// every second frame, and again, so that memory stays bounded however long a run is; colours and events are
/// those of all frames. viewer/README.md describes what it writes.
class Film final : public FrameSink {
 public:
  /// The scenario must outlive it, and `avoiders`, by which words are read (WordReader). Its names and
  /// parameters were accepted before, by whoever ran it.
  explicit Film(const Scenario& scenario, const FilmLimits& limits = {}, const Catalog* avoiders = nullptr);
  ~Film() override;
  Film(const Film&) = delete;
  Film& operator=(const Film&) = delete;

  /// Frames come in order, all of them: those that are not kept count, too. O(vehicles^2 + what is thought).
  void write(const Frame& frame) override;
  bool wants_thoughts() const override { return true; }

  /// No more frames come: the last one is kept too, whatever the stride, and with it what happened up to it.
  /// `divergence` is how the run broke behind it, in a line; empty if it is whole.
  void finish(std::string_view divergence = {});

  /// Frames kept.
  std::size_t size() const;
  /// One in so many of the frames seen was kept.
  std::size_t stride() const;
  /// Grows each time that frames which were kept are dropped: whoever asked for parts asks anew.
  std::size_t generation() const;
  /// True if any vehicle drew anything.
  bool has_sketches() const;

  /// Frames [first, first + most) and what happened after frame first - 1 up to the last of them, as a `part`
  /// of the page's document: parts that follow on each other give everything once. O(part).
  nlohmann::json part(std::size_t first, std::size_t most, Packing packing) const;

  /// The columns of frames [first, first + count), one after the other, little-endian. O(count * vehicles).
  std::string column_bytes(std::size_t first, std::size_t count) const;

  /// What was thought up to frame `end`, which is not included, as a part has it: for a page whose thoughts
  /// are of somebody else.
  std::string thoughts_before(std::size_t end) const;

  /// Empty, or how the run broke, in a line.
  const std::string& divergence() const;

  /// Empty, or how the run broke and what had to be left out, for the reader of the page.
  std::string notice() const;

 private:
  struct Contents;
  std::unique_ptr<Contents> contents_;
};

}  // namespace fairway
