// SPDX-License-Identifier: Apache-2.0
#include "fairway/studies/run_list.hpp"

#include <cmath>

#include "fairway/core/text.hpp"

namespace fairway::page {

using nlohmann::json;

std::size_t RunList::add(const std::string& label, const RunSpec& spec, const std::string& playback) {
  if (entries_.empty() || entries_.back().label != label || entries_.back().command != spec.command)
    entries_.push_back({label, spec.command, {}});
  Entry& entry = entries_.back();
  if (!playback.empty()) entry.playbacks[std::to_string(entry.seeds.size())] = playback;
  entry.seeds.push_back(spec.seed);
  return size_++;
}

json RunList::document() const {
  constexpr std::uint64_t largest_exact = std::uint64_t{1} << 53U;  // of a number in a browser
  json list = json::array();
  for (const Entry& entry : entries_) {
    json seeds = json::array();
    for (const std::uint64_t seed : entry.seeds)
      seeds.push_back(seed <= largest_exact ? json(seed) : json(std::to_string(seed)));
    json written{{"label", entry.label}, {"command", entry.command}, {"seeds", std::move(seeds)}};
    if (!entry.playbacks.empty()) written["playbacks"] = entry.playbacks;
    list.push_back(std::move(written));
  }
  return list;
}

json references(std::span<const std::size_t> places) {
  json list = json::array();
  for (std::size_t i = 0; i < places.size();) {
    std::size_t end = i + 1;
    while (end < places.size() && places[end] == places[end - 1] + 1) ++end;
    list.push_back(end == i + 1 ? json(places[i]) : json{places[i], places[end - 1]});
    i = end;
  }
  return list;
}

json shown_values(std::span<const double> values) {
  json list = json::array();
  for (const double value : values)
    list.push_back(std::isfinite(value) ? json(to_six_digits(value)) : json());
  return list;
}

json linked(json mark, json runs, json values) {
  if (mark.is_null() || runs.is_null()) return mark;
  mark["runs"] = std::move(runs);
  if (!values.is_null()) mark["values"] = std::move(values);
  return mark;
}

}  // namespace fairway::page
