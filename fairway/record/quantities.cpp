// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/quantities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "fairway/core/text.hpp"
#include "fairway/record/record_text.hpp"
#include "fairway/record/word_messages.hpp"

namespace fairway {

namespace {

using V = const VehicleFrame&;

/// Quantities that come together: the columns of a vector, or a single one.
struct Group {
  std::vector<std::string_view> names;
  std::string (*text)(V, int index);
};

std::string real_text(const std::optional<double>& value) { return value ? number_text(*value) : ""; }

const std::vector<Quantity>& list() {
  static const std::vector<Quantity> all = [] {
    const std::vector<Group> groups{
        {{"id"}, [](V v, int) { return std::to_string(number(v.id)); }},
        {{"phase"}, [](V v, int) { return std::string(enum_name(v.phase)); }},
        {{"x_m", "y_m", "z_m"}, [](V v, int i) { return number_text(v.state.p_n[i]); }},
        {{"qw_ratio"}, [](V v, int) { return number_text(v.state.q_nb.w()); }},
        {{"qx_ratio", "qy_ratio", "qz_ratio"}, [](V v, int i) { return number_text(v.state.q_nb.vec()[i]); }},
        {{"roll_rad"}, [](V v, int) { return number_text(euler_of(v.state.q_nb).roll); }},
        {{"pitch_rad"}, [](V v, int) { return number_text(euler_of(v.state.q_nb).pitch); }},
        {{"yaw_rad"}, [](V v, int) { return number_text(euler_of(v.state.q_nb).yaw); }},
        {{"u_mps", "v_mps", "w_mps"}, [](V v, int i) { return number_text(v.state.v_b[i]); }},
        {{"p_radps", "q_radps", "r_radps"}, [](V v, int i) { return number_text(v.state.omega_b[i]); }},
        {{"goal_n_m", "goal_e_m", "goal_d_m"}, [](V v, int i) { return number_text(v.goal[i]); }},
        {{"goal_speed_mps"}, [](V v, int) { return number_text(v.goal_speed); }},
        {{"command_n_mps", "command_e_mps", "command_d_mps"},
         [](V v, int i) { return number_text(v.command.velocity[i]); }},
        {{"command_heading_rad"}, [](V v, int) { return real_text(v.command.heading); }},
        {{"command_turn_rate_radps"}, [](V v, int) { return real_text(v.command.turn_rate); }},
        {{"command_force_x_n", "command_force_y_n", "command_force_z_n", "command_moment_k_nm",
          "command_moment_m_nm", "command_moment_n_nm"},
         [](V v, int i) { return v.command.wrench ? number_text((*v.command.wrench)[i]) : ""; }},
        {{"mode"}, [](V v, int) { return std::string(enum_name(v.command.mode)); }},
        {{"astern"}, [](V v, int) { return std::string(v.command.astern ? "true" : "false"); }},
        {{"power_w"}, [](V v, int) { return number_text(v.power); }},
        {{"force_x_n", "force_y_n", "force_z_n", "moment_k_nm", "moment_m_nm", "moment_n_nm"},
         [](V v, int i) { return number_text(v.wrench[i]); }},
    };
    std::vector<Quantity> flat;
    for (const auto& [names, text] : groups) {
      for (int i = 0; const std::string_view name : names) flat.push_back({name, text, i++});
    }
    return flat;
  }();
  return all;
}

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

/// The first difference of two lists of records: "tracks[2].x_m", or their lengths.
template <RecordType R>
Found first_of_records(const std::string& list, const char* count, std::span<const R> a,
                       std::span<const R> b) {
  static const std::vector<std::string> columns = record_columns<R>();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    const std::vector<std::string> in_a = record_texts(a[i]), in_b = record_texts(b[i]);
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (in_a[k] != in_b[k])
        return QuantityDifference{list + "[" + std::to_string(i) + "]." + columns[k], in_a[k], in_b[k]};
    }
  }
  return first_of("", {{count, std::to_string(a.size()), std::to_string(b.size())}});
}

}  // namespace

std::span<const Quantity> quantities() { return list(); }

std::string instant_text(Tick tick, double time) {
  return fmt::format("tick {} ({:.10g} s)", count(tick), time);
}

std::optional<QuantityDifference> first_difference(const VehicleFrame& a, const VehicleFrame& b) {
  for (const Quantity& quantity : list()) {
    std::string in_a = quantity.of(a);
    std::string in_b = quantity.of(b);
    if (in_a != in_b) return QuantityDifference{std::string(quantity.name), std::move(in_a), std::move(in_b)};
  }
  const std::size_t both = std::min(a.actuators.size(), b.actuators.size());
  for (std::size_t i = 0; i < both; ++i) {
    if (same_bits(a.actuators[i], b.actuators[i])) continue;
    return QuantityDifference{"actuator_" + std::to_string(i), number_text(a.actuators[i]),
                              number_text(b.actuators[i])};
  }
  if (a.actuators.size() != b.actuators.size()) {
    return QuantityDifference{"actuator_count", std::to_string(a.actuators.size()),
                              std::to_string(b.actuators.size())};
  }
  return std::nullopt;
}

Found first_perception_difference(const VehicleFrame& a, const VehicleFrame& b) {
  if (auto tracks = first_of_records("tracks", "track_count", a.tracks, b.tracks)) return tracks;
  return first_of_records("echoes", "echo_count", a.echoes, b.echoes);
}

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

Found first_word_difference(const SpokenWord& a, const SpokenWord& b) {
  if (a == b) return {};
  return first_of("", {{"from_index", std::to_string(a.from), std::to_string(b.from)},
                       {"sent_s", number_text(a.sent), number_text(b.sent)},
                       {"bytes", hexadecimal(a.speech), hexadecimal(b.speech)}});
}

Found first_flight_difference(std::span<const MessageFlight> a, std::span<const MessageFlight> b) {
  if (std::ranges::equal(a, b)) return {};
  return first_of_records("flights", "flight_count", a, b);
}

}  // namespace fairway
