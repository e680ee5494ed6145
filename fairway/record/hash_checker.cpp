// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/hash_checker.hpp"

#include "fairway/core/text.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/quantities.hpp"

namespace fairway {

namespace {

std::string text_of(const QuantityDifference& q) {
  return q.quantity + ": " + q.a + " was recorded, now " + q.b;
}

/// When the frame is, and how long until the next that is kept: what its hash does not say.
std::optional<QuantityDifference> first_clock_difference(const Recording& recording, const Frame& recorded,
                                                         const Frame& now) {
  const double period = now.period * static_cast<double>(recording.stride());
  if (recorded.time != now.time)
    return QuantityDifference{"time_s", number_text(recorded.time), number_text(now.time)};
  if (recorded.period != period)
    return QuantityDifference{"period_s", number_text(recorded.period), number_text(period)};
  return {};
}

std::string explain(const Recording& recording, const Frame& recorded, const Frame& now) {
  if (const auto q = first_clock_difference(recording, recorded, now)) return text_of(*q);
  if (recorded.vehicles.size() != now.vehicles.size()) {
    return std::to_string(recorded.vehicles.size()) + " vehicles were recorded, now " +
           std::to_string(now.vehicles.size());
  }
  for (std::size_t i = 0; i < now.vehicles.size(); ++i) {
    auto q = first_difference(recorded.vehicles[i], now.vehicles[i]);
    if (!q && recording.info().perception) {
      q = first_perception_difference(recorded.vehicles[i], now.vehicles[i]);
    }
    if (!q && recording.info().sketches) {
      q = first_sketch_difference(recorded.vehicles[i].strokes, now.vehicles[i].strokes);
    }
    if (q) return recording.info().vehicles[i].name + " " + text_of(*q);
  }
  if (recording.info().sketches) {
    if (const auto q = first_flight_difference(recorded.flights, now.flights)) return text_of(*q);
  }
  return "the bits of a NaN";
}

}  // namespace

void HashChecker::write(const Frame& frame) {
  const std::uint64_t hash = frame_hash(frame);
  run_hash_ = mix_hash(run_hash_, hash);
  const bool perception = recording_.info().perception;
  const std::uint64_t perceived = perception ? perception_hash(frame) : 0;
  if (perception) run_perception_hash_ = mix_hash(run_perception_hash_, perceived);
  ++seen_;
  check_words(frame);

  // ticks that this run left out were not matched
  while (next_ < recording_.size() && recording_.frame(next_).tick < frame.tick) ++next_;
  if (next_ == recording_.size()) return;
  const Frame recorded = recording_.frame(next_);
  if (recorded.tick != frame.tick) return;
  const std::size_t i = next_++;
  const std::uint64_t expected = recording_.hashes()[i];
  if (expected == hash && !first_clock_difference(recording_, recorded, frame) &&
      (!perception || recording_.perception_hashes()[i] == perceived) &&
      (!recording_.info().sketches || same_sketches(recorded, frame))) {
    ++matched_;
  } else if (!mismatch_) {
    mismatch_ = {frame.tick, frame.time, expected, hash, explain(recording_, recorded, frame)};
  }
}

/// Of a recording without any nothing is known: they may have been left out.
void HashChecker::check_words(const Frame& frame) {
  const std::span<const SpokenWord> recorded = recording_.words();
  if (recorded.empty()) return;
  for (const SpokenWord& word : frame.words) {
    const std::size_t i = next_word_++;
    if (mismatch_ || i >= recorded.size()) continue;
    if (const auto q = first_word_difference(recorded[i], word))
      mismatch_ = {frame.tick, frame.time, 0, 0, "words[" + std::to_string(i) + "]." + text_of(*q)};
  }
}

bool HashChecker::same() const {
  return !mismatch_ && matched_ == recording_.size() && seen_ == recording_.run_frame_count() &&
         next_word_ == recording_.words().size() && run_hash_ == recording_.run_hash() &&
         run_perception_hash_ == recording_.run_perception_hash();
}

std::string HashChecker::describe() const {
  const std::string frames = std::to_string(recording_.size());
  if (same()) {
    const RecordingInfo& info = recording_.info();
    return "the same to the bit: " + frames + " of " + frames + " recorded frames" +
           (info.perception ? ", and what was perceived" : "") +
           (info.sketches ? ", and what was drawn" : "") +
           (recording_.words().empty() ? "" : ", and what was said") +
           (recording_.stopped() ? "; the recorded run was stopped there" : "");
  }
  if (mismatch_) {
    return "differs from " + instant_text(mismatch_->tick, mismatch_->time) + ": " + mismatch_->what;
  }
  if (seen_ != recording_.run_frame_count()) {
    return "another length: " + std::to_string(recording_.run_frame_count()) + " frames were run, now " +
           std::to_string(seen_);
  }
  if (next_word_ != recording_.words().size()) {
    return "another number of words: " + std::to_string(recording_.words().size()) + " were said, now " +
           std::to_string(next_word_);
  }
  return "differs between the recorded frames, of which " + std::to_string(matched_) + " of " + frames +
         " match";
}

}  // namespace fairway
