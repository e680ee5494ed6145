// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_text.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ranges>

#include "fairway/view/film_bytes.hpp"

namespace fairway {
namespace {

/// Shortest text of a number to five places; null where it is not finite.
void put_rounded(std::string& out, double x) {
  if (!std::isfinite(x)) {
    out += "null";
    return;
  }
  constexpr double places = 1e5, too_large_to_round = 1e9;
  const double rounded = std::fabs(x) < too_large_to_round ? std::round(x * places) / places : x;
  fmt::format_to(std::back_inserter(out), "{}", rounded + 0.0);  // no negative zero
}

void put_point(std::string& out, const Vec3& v) {
  out += '[';
  put_rounded(out, v.x());
  out += ',';
  put_rounded(out, v.y());
  out += ',';
  put_rounded(out, v.z());
  out += ']';
}

void put_key(std::string& out, const char* key) {
  out += ",\"";
  out += key;
  out += "\":";
}

void put_keyed(std::string& out, const char* key, double x) {
  put_key(out, key);
  put_rounded(out, x);
}

void put_keyed(std::string& out, const char* key, const Vec3& v) {
  put_key(out, key);
  put_point(out, v);
}

std::string json_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// "[a,b,c]", each item put by `put`.
template <class Items, class Put>
std::string json_list(Items&& items, Put put) {
  std::string out = "[";
  for (const auto& item : items) {
    put(out, item);
    out += ',';
  }
  if (out.size() > 1) out.pop_back();
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

void put_stroke(std::string& out, const Stroke& stroke) {
  out += fmt::format(R"({{"kind":"{}","meaning":{})", enum_name(stroke.kind), json_text(stroke.meaning));
  if (stroke.kind == Stroke::Kind::image) {
    out += fmt::format(R"(,"side":{})", stroke.side);
    put_keyed(out, "reach", stroke.size);
    put_keyed(out, "yaw", stroke.yaw);
    out += fmt::format(R"(,"rgb":"{}")", base64_of(bytes_of_pixels(stroke.rgb)));
  } else {
    put_key(out, "points");
    out += json_list(stroke.points, put_point);
    if (stroke.kind == Stroke::Kind::sphere) put_keyed(out, "radius", stroke.size);
  }
  out += '}';
}

/// Standard deviation of a position along the direction in which it is known least [m].
double largest_deviation(const Mat3& covariance) {
  if (covariance.isZero(0.0)) return 0.0;
  const Eigen::SelfAdjointEigenSolver<Mat3> solver{covariance, Eigen::EigenvaluesOnly};
  return std::sqrt(std::fmax(solver.eigenvalues().maxCoeff(), 0.0));
}

void put_track(std::string& out, const Track& track) {
  out += fmt::format(R"({{"id":{})", number(track.id));
  put_keyed(out, "position", track.position);
  put_keyed(out, "velocity", track.velocity);
  put_keyed(out, "radius", track.radius);
  put_keyed(out, "age_s", track.age);
  put_keyed(out, "sigma_m", largest_deviation(track.position_covariance));
  put_key(out, "reacts");
  out += track.reacts ? "true}" : "false}";
}

void put_echo(std::string& out, const Echo& echo) {
  out += '[';
  put_rounded(out, echo.range);
  out += ',';
  put_rounded(out, echo.bearing);
  out += ']';
}

}  // namespace

std::string text_of(std::span<const Stroke> strokes) {
  return json_list(strokes | std::views::filter(is_showable), put_stroke);
}

std::string text_of(std::span<const Track> tracks) { return json_list(tracks, put_track); }

std::string text_of(std::span<const Echo> echoes) { return json_list(echoes, put_echo); }

std::string text_of(const MessageFlight& flight) {
  return fmt::format(R"({{"from":{},"to":{},"sent_s":{},"begins_s":{},"arrives_s":{},"drowned":{}}})",
                     flight.from, flight.to, flight.sent, flight.begins, flight.arrives, flight.drowned);
}

std::string text_of_place(double time, std::size_t vehicle) {
  return fmt::format(R"("time_s":{},"vehicle":{})", time, vehicle);
}

}  // namespace fairway
