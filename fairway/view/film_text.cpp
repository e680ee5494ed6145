// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_text.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ranges>

#include "fairway/core/math.hpp"
#include "fairway/view/film_bytes.hpp"

namespace fairway {
namespace {

/// Shortest text of a number to five places; null where it is not finite.
std::string rounded(double x) {
  if (!std::isfinite(x)) return "null";
  constexpr double places = 1e5, too_large_to_round = 1e9;
  const double value = std::fabs(x) < too_large_to_round ? std::round(x * places) / places : x;
  return fmt::format("{}", value + 0.0);  // no negative zero
}

std::string point_text(const Vec3& v) {
  return fmt::format("[{},{},{}]", rounded(v.x()), rounded(v.y()), rounded(v.z()));
}

std::string json_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// "[a,b,c]", each item by its `text`.
template <class Items, class Text>
std::string json_list(Items&& items, Text text) {
  std::string out = "[";
  for (const auto& item : items) out.append(out.size() > 1 ? "," : "").append(text(item));
  return out += ']';
}

std::string bytes_of_pixels(std::span<const std::uint32_t> rgb) {
  std::string bytes;
  bytes.reserve(3 * rgb.size());
  for (const std::uint32_t pixel : rgb) {
    for (const std::uint32_t shift : {16U, 8U, 0U}) bytes += static_cast<char>(pixel >> shift & 255U);
  }
  return bytes;
}

bool is_showable(const Stroke& stroke) {
  return std::isfinite(stroke.size) && std::isfinite(stroke.yaw) &&
         std::ranges::all_of(stroke.points, [](const Vec3& p) { return is_finite(p); });
}

std::string stroke_text(const Stroke& stroke) {
  std::string drawn;
  if (stroke.kind == Stroke::Kind::image) {
    drawn = fmt::format(R"("side":{},"reach":{},"yaw":{},"rgb":"{}")", stroke.side, rounded(stroke.size),
                        rounded(stroke.yaw), base64_of(bytes_of_pixels(stroke.rgb)));
  } else {
    drawn = R"("points":)" + json_list(stroke.points, point_text);
    if (stroke.kind == Stroke::Kind::sphere) drawn += R"(,"radius":)" + rounded(stroke.size);
  }
  return fmt::format(R"({{"kind":"{}","meaning":{},{}}})", enum_name(stroke.kind), json_text(stroke.meaning),
                     drawn);
}

/// Standard deviation of a position along the direction in which it is known least [m].
double largest_deviation(const Mat3& covariance) {
  if (covariance.isZero(0.0)) return 0.0;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver{covariance, Eigen::EigenvaluesOnly};
  return std::sqrt(math::fmax(solver.eigenvalues().maxCoeff(), 0.0));
}

std::string track_text(const Track& track) {
  return fmt::format(
      R"({{"id":{},"position":{},"velocity":{},"radius":{},"age_s":{},"sigma_m":{},"reacts":{}}})",
      number(track.id), point_text(track.position), point_text(track.velocity), rounded(track.radius),
      rounded(track.age), rounded(largest_deviation(track.position_covariance)), track.reacts);
}

std::string echo_text(const Echo& echo) {
  return fmt::format("[{},{}]", rounded(echo.range), rounded(echo.bearing));
}

}  // namespace

std::string text_of(std::span<const Stroke> strokes) {
  return json_list(strokes | std::views::filter(is_showable), stroke_text);
}

std::string text_of(std::span<const Track> tracks) { return json_list(tracks, track_text); }

std::string text_of(std::span<const Echo> echoes) { return json_list(echoes, echo_text); }

std::string text_of(const MessageFlight& flight) {
  return fmt::format(R"({{"from":{},"to":{},"sent_s":{},"begins_s":{},"arrives_s":{},"unheard":{}}})",
                     flight.from, flight.to, flight.sent, flight.begins, flight.arrives, flight.unheard);
}

std::string text_of(const SpokenWord& word, const ReadWord& read) {
  return fmt::format(R"({{"sent_s":{},"text":{},"awaited":{}}})", word.sent, json_text(read.text),
                     json_list(read.awaited, [](std::size_t vehicle) { return std::to_string(vehicle); }));
}

std::string text_of_place(double time, std::size_t vehicle) {
  return fmt::format(R"("time_s":{},"vehicle":{})", time, vehicle);
}

}  // namespace fairway
