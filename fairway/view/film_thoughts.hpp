// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fairway/record/frame.hpp"
#include "fairway/view/word_reader.hpp"

namespace fairway {

/// What vehicles drew, perceived, said and told in a run, as text for the page: a record of each only when
/// it has changed. Beyond its size it keeps at most one record of a vehicle and kind in every second frame,
/// then in every fourth, and so on, and the messages of every second transmission, and so on.
class FilmThoughts {
 public:
  /// `thinkers` are those whose records are kept, by index; nothing: all.
  /// Words are kept of all who speak.
  FilmThoughts(WordReader reader, std::size_t vehicles, std::size_t most_bytes,
               const std::optional<std::vector<std::size_t>>& thinkers = {});

  /// Times of frames ascend.
  void see(const Frame& frame);

  bool has_sketches() const { return has_sketches_; }
  /// In so many frames at most one record of a vehicle and kind was kept.
  std::size_t spacing() const { return spacing_; }
  /// One of so many transmissions was kept.
  std::size_t transmission_stride() const { return transmission_stride_; }

  /// Those at times in (after, until], as JSON text of the page's `Thoughts`; empty if there are none.
  std::string between(double after, double until) const;

 private:
  enum class Kind : std::uint8_t { sketch, tracks, echoes, word };
  static constexpr std::size_t kinds = 4;

  struct Record {
    double time;
    std::size_t frame;  // how many were seen before
    std::size_t vehicle;
    Kind kind;
    std::string text;
  };
  struct Told {
    double time;  // of the frame in which it was first seen
    std::size_t transmission;
    MessageFlight flight;
  };
  struct Memory {
    std::vector<Stroke> strokes;
    std::array<std::string, kinds> texts{"[]", "[]", "[]", ""};
    std::optional<SpokenWord> word;  // not kept yet
  };

  void see_vehicle(const Frame& frame, std::size_t index);
  void see_sketch(const Frame& frame, std::size_t index);
  void keep(const Frame& frame, std::size_t index, Kind kind, std::string text);
  void see_words(const Frame& frame);
  void see_flight(double time, const MessageFlight& flight);
  void correct(const MessageFlight& flight);
  void thin_records();
  void thin_messages();
  std::string records_text(Kind kind, double after, double until) const;

  WordReader reader_;
  std::size_t most_bytes_;
  std::vector<std::size_t> thinkers_;
  std::size_t frames_{};  // seen
  bool has_sketches_{false};

  std::vector<Memory> last_;           // by vehicle
  std::vector<std::size_t> speakers_;  // vehicles whose last word is not kept yet
  std::vector<Record> records_;
  std::size_t bytes_{};  // of their texts
  std::size_t spacing_{1};

  std::vector<Told> messages_;  // in the order in which they were sent
  double newest_{-std::numeric_limits<double>::infinity()};
  std::size_t transmissions_{};
  std::size_t transmission_stride_{1};
};

}  // namespace fairway
