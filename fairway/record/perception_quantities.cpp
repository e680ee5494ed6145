// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/perception_quantities.hpp"

#include <algorithm>
#include <array>

#include "fairway/core/text.hpp"
#include "fairway/record/record_text.hpp"

namespace fairway {

namespace {

std::string element(const char* list, std::size_t i, std::string_view quantity) {
  return std::string(list) + "[" + std::to_string(i) + "]." + std::string(quantity);
}

std::optional<QuantityDifference> differing_texts(std::string what, std::string in_a, std::string in_b) {
  if (in_a == in_b) return std::nullopt;
  return QuantityDifference{std::move(what), std::move(in_a), std::move(in_b)};
}

std::optional<QuantityDifference> first_track_difference(std::span<const Track> a, std::span<const Track> b) {
  static const std::vector<std::string> columns = record_columns<Track>();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const std::vector<std::string> in_a = record_texts(a[i]), in_b = record_texts(b[i]);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (auto found = differing_texts(element("tracks", i, columns[k]), in_a[k], in_b[k])) return found;
    }
  }
  return differing_texts("track_count", std::to_string(a.size()), std::to_string(b.size()));
}

std::optional<QuantityDifference> first_echo_difference(std::span<const Echo> a, std::span<const Echo> b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    for (const auto& [name, value] :
         {std::pair{"range_m", &Echo::range}, std::pair{"bearing_rad", &Echo::bearing}}) {
      if (auto found = differing_texts(element("echoes", i, name), number_text(a[i].*value),
                                       number_text(b[i].*value))) {
        return found;
      }
    }
  }
  return differing_texts("echo_count", std::to_string(a.size()), std::to_string(b.size()));
}

}  // namespace

std::optional<QuantityDifference> first_perception_difference(const VehicleFrame& a, const VehicleFrame& b) {
  if (auto tracks = first_track_difference(a.tracks, b.tracks)) return tracks;
  return first_echo_difference(a.echoes, b.echoes);
}

}  // namespace fairway
