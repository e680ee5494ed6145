// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/sketch_quantities.hpp"

#include <algorithm>
#include <initializer_list>

#include "fairway/core/text.hpp"

namespace fairway {

namespace {

using Found = std::optional<QuantityDifference>;

bool same_point(const Vec3& a, const Vec3& b) {
  return same_bits(a.x(), b.x()) && same_bits(a.y(), b.y()) && same_bits(a.z(), b.z());
}

bool same_stroke(const Stroke& a, const Stroke& b) {
  return a.kind == b.kind && a.meaning == b.meaning && same_bits(a.size, b.size) && same_bits(a.yaw, b.yaw) &&
         a.side == b.side && a.rgb == b.rgb && std::ranges::equal(a.points, b.points, same_point);
}

/// A quantity by its name and its texts in both.
struct Named {
  const char* name;
  std::string a;
  std::string b;
};

Found first_of(const std::string& prefix, std::initializer_list<Named> all) {
  for (const auto& [name, a, b] : all) {
    if (a != b) return QuantityDifference{prefix + name, a, b};
  }
  return {};
}

std::string point_text(const Vec3& p) {
  return number_text(p.x()) + " " + number_text(p.y()) + " " + number_text(p.z());
}

std::string kind_text(const Stroke& stroke) {
  return EnumNames<Stroke::Kind>::names[static_cast<std::size_t>(stroke.kind)];
}

/// The first difference of two that are not the same to the bit.
QuantityDifference difference_between(const Stroke& a, const Stroke& b, const std::string& prefix) {
  const Found of_members =
      first_of(prefix, {{".kind", kind_text(a), kind_text(b)},
                        {".meaning", a.meaning, b.meaning},
                        {".size", number_text(a.size), number_text(b.size)},
                        {".yaw_rad", number_text(a.yaw), number_text(b.yaw)},
                        {".side_count", std::to_string(a.side), std::to_string(b.side)},
                        {".point_count", std::to_string(a.points.size()), std::to_string(b.points.size())},
                        {".pixel_count", std::to_string(a.rgb.size()), std::to_string(b.rgb.size())}});
  if (of_members) return *of_members;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    if (same_point(a.points[i], b.points[i])) continue;
    return {prefix + ".points[" + std::to_string(i) + "]", point_text(a.points[i]), point_text(b.points[i])};
  }
  const auto pixel = std::ranges::mismatch(a.rgb, b.rgb);
  if (pixel.in1 == a.rgb.end()) return {prefix, "a NaN", "another NaN"};
  return {prefix + ".rgb[" + std::to_string(pixel.in1 - a.rgb.begin()) + "]", std::to_string(*pixel.in1),
          std::to_string(*pixel.in2)};
}

}  // namespace

bool same_sketches(const Frame& a, const Frame& b) {
  const auto drew_the_same = [](const VehicleFrame& x, const VehicleFrame& y) {
    return !first_sketch_difference(x.strokes, y.strokes);
  };
  return std::ranges::equal(a.vehicles, b.vehicles, drew_the_same) &&
         !first_flight_difference(a.flights, b.flights);
}

Found first_sketch_difference(std::span<const Stroke> a, std::span<const Stroke> b) {
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!same_stroke(a[i], b[i])) return difference_between(a[i], b[i], "sketch[" + std::to_string(i) + "]");
  }
  return first_of("", {{"stroke_count", std::to_string(a.size()), std::to_string(b.size())}});
}

Found first_flight_difference(std::span<const MessageFlight> a, std::span<const MessageFlight> b) {
  const auto word = [](bool value) { return std::string(value ? "true" : "false"); };
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const MessageFlight& x = a[i];
    const MessageFlight& y = b[i];
    if (x == y) continue;
    Found found = first_of("flights[" + std::to_string(i) + "]",
                           {{".from_index", std::to_string(x.from), std::to_string(y.from)},
                            {".to_index", std::to_string(x.to), std::to_string(y.to)},
                            {".sent_s", number_text(x.sent), number_text(y.sent)},
                            {".begins_s", number_text(x.begins), number_text(y.begins)},
                            {".arrives_s", number_text(x.arrives), number_text(y.arrives)},
                            {".drowned", word(x.drowned), word(y.drowned)}});
    if (found) return found;
  }
  return first_of("", {{"flight_count", std::to_string(a.size()), std::to_string(b.size())}});
}

}  // namespace fairway
