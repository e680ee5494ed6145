// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_thoughts.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <ranges>
#include <utility>

#include "fairway/view/film_text.hpp"

namespace fairway {
namespace {

constexpr std::size_t record_frame_bytes = 48;   // of a record's text besides what was thought
constexpr std::size_t message_text_bytes = 110;  // about as much as one message takes
constexpr std::size_t message_share = 4;         // messages may take one part in so many

constexpr std::array<const char*, 4> list_names{"sketches", "tracks", "echoes", "words"};
constexpr std::array<const char*, 4> content_names{"strokes", "tracks", "echoes", "word"};

}  // namespace

FilmThoughts::FilmThoughts(WordReader reader, std::size_t vehicles, std::size_t most_bytes,
                           const std::optional<std::vector<std::size_t>>& thinkers)
    : reader_{std::move(reader)}, most_bytes_{most_bytes}, last_(vehicles) {
  if (thinkers) {
    std::ranges::copy_if(*thinkers, std::back_inserter(thinkers_),
                         [&](std::size_t i) { return i < vehicles; });
  } else {
    thinkers_.resize(vehicles);
    std::iota(thinkers_.begin(), thinkers_.end(), std::size_t{0});
  }
}

void FilmThoughts::see(const Frame& frame) {
  for (const MessageFlight& flight : frame.flights) see_flight(frame.time, flight);
  see_words(frame);
  if (frames_ % spacing_ == 0) {
    for (const std::size_t i : thinkers_) see_vehicle(frame, i);
  }
  ++frames_;
  // doubled until everything seen lies in one span, it can shorten nothing more
  while (bytes_ > most_bytes_ && spacing_ < 2 * frames_) thin_records();
}

void FilmThoughts::see_vehicle(const Frame& frame, std::size_t index) {
  see_sketch(frame, index);
  keep(frame, index, Kind::tracks, text_of(frame.vehicles[index].tracks));
  keep(frame, index, Kind::echoes, text_of(frame.vehicles[index].echoes));
}

void FilmThoughts::see_sketch(const Frame& frame, std::size_t index) {
  const std::span<const Stroke> strokes = frame.vehicles[index].strokes;
  std::vector<Stroke>& last = last_[index].strokes;
  if (std::ranges::equal(strokes, last)) return;
  has_sketches_ = true;
  last.assign(strokes.begin(), strokes.end());
  keep(frame, index, Kind::sketch, text_of(strokes));
}

void FilmThoughts::keep(const Frame& frame, std::size_t index, Kind kind, std::string text) {
  std::string& last = last_[index].texts[static_cast<std::size_t>(kind)];
  if (text == last) return;
  last = text;
  bytes_ += text.size() + record_frame_bytes;
  records_.push_back({frame.time, frames_, index, kind, std::move(text)});
}

/// Of a vehicle that spoke more than once since words were kept, the last one stays.
void FilmThoughts::see_words(const Frame& frame) {
  for (const SpokenWord& word : frame.words) {
    std::optional<SpokenWord>& last = last_[word.from].word;
    if (!last) speakers_.push_back(word.from);
    last = word;
  }
  if (frames_ % spacing_ != 0) return;
  for (const std::size_t i : speakers_) {
    const SpokenWord word = *std::exchange(last_[i].word, {});
    keep(frame, i, Kind::word, text_of(word, reader_.read(word)));
  }
  speakers_.clear();
}

void FilmThoughts::see_flight(double time, const MessageFlight& flight) {
  if (flight.sent < newest_) {
    correct(flight);
    return;
  }
  if (flight.sent > newest_) {
    newest_ = flight.sent;
    ++transmissions_;
  } else if (messages_.empty() || messages_.back().time < time) {
    correct(flight);
    return;
  }
  if ((transmissions_ - 1) % transmission_stride_ != 0) return;
  messages_.push_back({time, transmissions_ - 1, flight});
  if (messages_.size() * message_text_bytes > most_bytes_ / message_share) thin_messages();
}

/// Whether a message will be heard may change while it is under way.
void FilmThoughts::correct(const MessageFlight& flight) {
  const auto sent = [](const Told& told) { return told.flight.sent; };
  for (Told& told : std::ranges::equal_range(messages_, flight.sent, {}, sent)) {
    if (told.flight.from == flight.from && told.flight.to == flight.to) told.flight.unheard = flight.unheard;
  }
}

void FilmThoughts::thin_messages() {
  transmission_stride_ *= 2;
  std::erase_if(messages_, [&](const Told& told) { return told.transmission % transmission_stride_ != 0; });
}

/// In each span of `spacing_` frames the last record of a vehicle and kind stays: what stands at the span's
/// end.
void FilmThoughts::thin_records() {
  spacing_ *= 2;
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::array<std::size_t, kinds>> taken(last_.size(), {none, none, none});
  std::vector<Record> kept;
  bytes_ = 0;
  for (Record& record : records_ | std::views::reverse) {
    const std::size_t span = (record.frame + spacing_ - 1) / spacing_;
    std::size_t& last = taken[record.vehicle][static_cast<std::size_t>(record.kind)];
    if (last == span) continue;
    last = span;
    bytes_ += record.text.size() + record_frame_bytes;
    kept.push_back(std::move(record));
  }
  std::ranges::reverse(kept);
  records_ = std::move(kept);
}

std::string FilmThoughts::records_text(Kind kind, double after, double until) const {
  const auto k = static_cast<std::size_t>(kind);
  std::string all;
  const auto begin = std::ranges::upper_bound(records_, after, {}, &Record::time);
  const auto end = std::ranges::upper_bound(begin, records_.end(), until, {}, &Record::time);
  for (const Record& record : std::span{begin, end}) {
    if (record.kind != kind) continue;
    all.append(all.empty() ? "{" : ",{").append(text_of_place(record.time, record.vehicle));
    all.append(",\"").append(content_names[k]).append("\":").append(record.text).append("}");
  }
  return std::string{"\""}.append(list_names[k]).append("\":[").append(all).append("]");
}

std::string FilmThoughts::between(double after, double until) const {
  const auto time = [](const auto& item) { return item.time; };
  std::string flights;
  for (const Told& told : messages_) {
    if (told.time <= after || told.time > until) continue;
    flights.append(flights.empty() ? "" : ",").append(text_of(told.flight));
  }
  const bool anything = !flights.empty() || std::ranges::upper_bound(records_, after, {}, time) !=
                                                std::ranges::upper_bound(records_, until, {}, time);
  if (!anything) return {};
  std::string all = "{";
  for (const Kind kind : {Kind::sketch, Kind::tracks, Kind::echoes, Kind::word})
    all.append(records_text(kind, after, until)).append(",");
  return all.append("\"flights\":[").append(flights).append("]}");
}

}  // namespace fairway
