// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "fairway/core/limits.hpp"
#include "ros/bridge/avoider_parts.hpp"

namespace fairway::bridge {
namespace {

constexpr double way_of = 10.0;  // [s] that a velocity is drawn for

using Colour = std::array<float, 4>;

constexpr Colour colour(std::uint32_t rgb) {
  const auto part = [&](unsigned shift) { return static_cast<float>((rgb >> shift) & 0xffU) / 255.0F; };
  return {part(16), part(8), part(0), 1.0F};
}

// as the playback's page has them in the dark, which RViz is (viewer/src/common/tokens.css)
constexpr Colour ink = colour(0xe7edf1);
constexpr Colour faint_ink = colour(0x8c9aa6);
constexpr Colour bad = colour(0xff8a7a);
constexpr std::array series{colour(0x3d9be6), colour(0xff8b45), colour(0x48d6a4), colour(0xe39ad0),
                            colour(0xcfeeff), colour(0xd2405a), colour(0x9a6bff), colour(0xf2e24a)};

/// One colour per meaning, fixed for what every method draws, else by the words
/// (viewer/src/playback/meaning_colour.ts).
Colour colour_of(std::string_view meaning) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, meaning) != names.end();
  };
  const auto has = [&](std::string_view part) { return meaning.find(part) != std::string_view::npos; };
  if (is_one_of({"chosen", "after the safety filter", "force", "command", "commanded"})) return ink;
  if (is_one_of({"preferred", "desired", "before the safety filter", "attraction"})) return series[2];
  if (meaning == "repulsion" || has("velocity obstacle") || has("protective") || has("range")) return bad;
  if (meaning.starts_with("allowed")) return series[0];
  if (meaning == "particle") return series[3];
  if (has("tree")) return faint_ink;
  if (has("another class")) return series[7];
  if (is_one_of({"trajectory", "path", "band", "foreseen", "way round"})) return series[6];
  if (is_one_of({"velocity", "own velocity"})) return faint_ink;
  std::uint32_t hash = 0;
  for (const char c : meaning) hash = hash * 31 + static_cast<unsigned char>(c);
  return series[hash % series.size()];
}

Colour faint(Colour colour, float alpha) {
  colour[3] = alpha;
  return colour;
}

/// Draws strokes round a vehicle.
class Painter {
 public:
  Painter(const Ownship& own, double reach) : own_{own}, reach_{reach} {}

  void paint(const Stroke& stroke) {
    const Colour colour = colour_of(stroke.meaning);
    switch (stroke.kind) {
      case Stroke::Kind::velocity:
        return line(stroke.meaning, {own_.position, place(stroke.points[0])}, colour);
      case Stroke::Kind::half_space:
        return half_space(stroke, colour);
      case Stroke::Kind::region:
        return region(stroke, colour);
      case Stroke::Kind::path:
        return line(stroke.meaning, stroke.points, colour);
      case Stroke::Kind::tree:
        return tree(stroke, colour);
      case Stroke::Kind::sphere:
        marks_.push_back({.kind = Mark::Kind::sphere,
                          .meaning = stroke.meaning,
                          .points = {triple_of(stroke.points[0])},
                          .radius = stroke.size,
                          .colour = faint(colour, 0.15F)});
        return;
      case Stroke::Kind::image:
        return;
    }
  }

  std::vector<Mark> take() { return std::move(marks_); }

 private:
  Vec3 place(const Vec3& velocity) const { return own_.position + way_of * velocity; }

  void add(Mark::Kind kind, const std::string& meaning, const std::vector<Vec3>& points,
           const Colour& colour) {
    if (points.size() < 2) return;  // viewers complain of a line of one point
    Mark mark{.kind = kind, .meaning = meaning, .points = {}, .colour = colour};
    for (const Vec3& point : points) mark.points.push_back(triple_of(point));
    marks_.push_back(std::move(mark));
  }

  void line(const std::string& meaning, const std::vector<Vec3>& points, const Colour& colour) {
    add(Mark::Kind::line, meaning, points, colour);
  }

  /// A square of the plane where it is nearest to no velocity.
  void half_space(const Stroke& stroke, const Colour& colour) {
    const Vec3 normal = unit(stroke.points[1]);
    if (normal.isZero(0.0)) return;
    const Vec3 middle = place(stroke.points[0].dot(normal) * normal);
    const Vec3 aside = unit(std::fabs(normal.z()) < 0.9 ? Vec3{Vec3::UnitZ().cross(normal)}
                                                        : Vec3{Vec3::UnitX().cross(normal)});
    const double half = 0.5 * way_of * reach_;
    const Vec3 along = half * aside;
    const Vec3 across = half * normal.cross(aside);
    const Vec3 a = middle - along - across;
    const Vec3 b = middle + along - across;
    const Vec3 c = middle + along + across;
    const Vec3 d = middle - along + across;
    add(Mark::Kind::triangles, stroke.meaning, {a, b, c, a, c, d}, faint(colour, 0.12F));
    line(stroke.meaning, {a, b, c, d, a}, faint(colour, 0.7F));
  }

  void region(const Stroke& stroke, const Colour& colour) {
    std::vector<Vec3> outline;
    for (const Vec3& velocity : stroke.points) outline.push_back(place(velocity));
    if (!outline.empty()) outline.push_back(outline.front());
    line(stroke.meaning, outline, colour);
  }

  /// Edges that go on where the last one ended are one line.
  void tree(const Stroke& stroke, const Colour& colour) {
    std::vector<Vec3> run;
    for (std::size_t i = 0; i + 1 < stroke.points.size(); i += 2) {
      if (run.empty() || run.back() != stroke.points[i]) {
        if (!run.empty()) line(stroke.meaning, run, colour);
        run = {stroke.points[i]};
      }
      run.push_back(stroke.points[i + 1]);
    }
    if (!run.empty()) line(stroke.meaning, run, colour);
  }

  const Ownship& own_;
  double reach_;  // of velocities that are drawn [m/s]
  std::vector<Mark> marks_;
};

}  // namespace

std::vector<Mark> marks_of(const Drawing& drawing, const Ownship& own, double max_speed) {
  Painter painter{own, limit_or(max_speed, 1.0)};
  for (const Stroke& stroke : drawing.strokes()) painter.paint(stroke);
  return painter.take();
}

}  // namespace fairway::bridge
