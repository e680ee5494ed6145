// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/diff.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/text.hpp"
#include "fairway/record/quantities.hpp"

namespace fairway {

namespace {

const char* recorded_or_not(bool is_recorded) { return is_recorded ? "recorded" : "not recorded"; }

/// What both recordings have besides the frames themselves.
struct InBoth {
  bool perception;
  bool sketches;
};

std::vector<std::string> compare_setup(const Recording& a, const Recording& b) {
  std::vector<std::string> lines;
  const auto compare = [&](const std::string& what, const std::string& in_a, const std::string& in_b) {
    if (in_a != in_b) lines.push_back(what + ": " + in_a + " against " + in_b);
  };
  const RecordingInfo& x = a.info();
  const RecordingInfo& y = b.info();
  compare("version", x.version, y.version);
  compare("scenario", x.scenario_name, y.scenario_name);
  compare("seed", std::to_string(x.seed), std::to_string(y.seed));
  compare("period_s", number_text(x.period), number_text(y.period));
  compare("stride", std::to_string(a.stride()), std::to_string(b.stride()));
  compare("perception", recorded_or_not(x.perception), recorded_or_not(y.perception));
  compare("sketches", recorded_or_not(x.sketches), recorded_or_not(y.sketches));
  compare("word_count", std::to_string(a.words().size()), std::to_string(b.words().size()));
  compare("vehicle_count", std::to_string(x.vehicles.size()), std::to_string(y.vehicles.size()));
  for (std::size_t i = 0; i < std::min(x.vehicles.size(), y.vehicles.size()); ++i) {
    const std::string vehicle = "vehicles[" + std::to_string(i) + "].";
    compare(vehicle + "name", x.vehicles[i].name, y.vehicles[i].name);
    compare(vehicle + "model", x.vehicles[i].model, y.vehicles[i].model);
  }
  if (x.scenario_yaml != y.scenario_yaml) lines.emplace_back("the resolved scenarios are not the same text");
  return lines;
}

void compare_frames(const Frame& a, const Frame& b, const RecordingInfo& info, InBoth in_both,
                    Difference& difference) {
  for (std::size_t i = 0; i < std::min(a.vehicles.size(), b.vehicles.size()); ++i) {
    const VehicleFrame& x = a.vehicles[i];
    const VehicleFrame& y = b.vehicles[i];
    const double distance = (x.state.p_n - y.state.p_n).norm();
    if (distance > (difference.farthest ? difference.farthest->distance : 0.0)) {
      difference.farthest = {distance, a.tick, a.time, info.vehicles[i].name};
    }
    if (difference.first) continue;
    auto q = first_difference(x, y);
    if (!q && in_both.perception) q = first_perception_difference(x, y);
    if (!q && in_both.sketches) q = first_sketch_difference(x.strokes, y.strokes);
    if (q) {
      difference.first = {a.tick,          a.time,         info.vehicles[i].name, std::move(q->quantity),
                          std::move(q->a), std::move(q->b)};
    }
  }
  if (difference.first || !in_both.sketches) return;
  if (auto q = first_flight_difference(a.flights, b.flights)) {
    difference.first = {a.tick, a.time, "", std::move(q->quantity), std::move(q->a), std::move(q->b)};
  }
}

/// Words are compared one by one, since each recording has all of them, whichever frames it has.
void compare_words(const Recording& a, const Recording& b, Difference& difference) {
  const std::span<const SpokenWord> in_a = a.words(), in_b = b.words();
  if (in_a.empty() || in_b.empty()) return;
  const auto differs = [&](const SpokenWord& word, const std::string& quantity, std::string x,
                           std::string y) {
    if (difference.first && difference.first->time <= word.sent) return;
    difference.first = {
        Tick{std::llround(word.sent / a.info().period)}, word.sent, "", quantity, std::move(x), std::move(y)};
  };
  const std::size_t both = std::min(in_a.size(), in_b.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (auto q = first_word_difference(in_a[i], in_b[i])) {
      const SpokenWord& first = in_a[i].sent <= in_b[i].sent ? in_a[i] : in_b[i];
      return differs(first, "words[" + std::to_string(i) + "]." + q->quantity, std::move(q->a),
                     std::move(q->b));
    }
  }
  if (in_a.size() != in_b.size())
    differs((in_a.size() > both ? in_a : in_b)[both], "word_count", std::to_string(in_a.size()),
            std::to_string(in_b.size()));
}

}  // namespace

Difference diff(const Recording& a, const Recording& b) {
  Difference difference;
  difference.setup = compare_setup(a, b);
  difference.vehicles_a = a.info().vehicles.size();
  difference.vehicles_b = b.info().vehicles.size();

  const InBoth in_both{a.info().perception && b.info().perception, a.info().sketches && b.info().sketches};
  const auto same = [&](std::size_t i, std::size_t j) {
    return a.hashes()[i] == b.hashes()[j] &&
           (!in_both.perception || a.perception_hashes()[i] == b.perception_hashes()[j]) &&
           (!in_both.sketches || same_sketches(a.frame(i), b.frame(j)));
  };

  // merge by tick
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const Frame x = a.frame(i);
    const Frame y = b.frame(j);
    if (x.tick < y.tick) {
      ++difference.only_in_a;
      ++i;
    } else if (y.tick < x.tick) {
      ++difference.only_in_b;
      ++j;
    } else {
      if (!same(i, j)) compare_frames(x, y, a.info(), in_both, difference);
      ++difference.compared;
      ++i;
      ++j;
    }
  }
  difference.only_in_a += a.size() - i;
  difference.only_in_b += b.size() - j;
  compare_words(a, b, difference);
  return difference;
}

std::string Difference::describe() const {
  std::string text;
  for (const std::string& line : setup) text += line + '\n';
  if (first) {
    text += "first difference at " + instant_text(first->tick, first->time) + ": " + first->vehicle +
            (first->vehicle.empty() ? "" : " ") + first->quantity + ": " + first->a + " against " + first->b +
            '\n';
  }
  if (farthest) {
    text += "farthest apart at " + instant_text(farthest->tick, farthest->time) + ": " + farthest->vehicle +
            " by " + number_text(farthest->distance) + " m\n";
  }
  const auto lone = [&](const char* which, std::size_t frames) {
    if (frames > 0) text += std::string("only in the ") + which + ": " + std::to_string(frames) + " frames\n";
  };
  lone("first", only_in_a);
  lone("second", only_in_b);
  return text + std::to_string(compared) + " common frames" + (same() ? ", the same to the bit\n" : "\n");
}

}  // namespace fairway
