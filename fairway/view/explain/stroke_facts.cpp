// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/explain/stroke_facts.hpp"

#include <algorithm>

namespace fairway {
namespace {

double length_of(const Stroke& stroke) {
  // a tree's points are pairs, a line's each begin where the last one ended
  const bool is_tree = stroke.kind == Stroke::Kind::tree;
  if (!is_tree && stroke.kind != Stroke::Kind::path) return 0.0;
  double length = 0.0;
  for (std::size_t i = 1; i < stroke.points.size(); i += is_tree ? 2 : 1) {
    length += (stroke.points[i] - stroke.points[i - 1]).norm();
  }
  return length;
}

bool forbids(const Stroke& stroke, const Vec3& v) {
  if (stroke.kind == Stroke::Kind::half_space) return margin_of(stroke, v) < -on_plane_mps;
  return stroke.kind == Stroke::Kind::region && contains(stroke, v);
}

bool is_active(const Stroke& stroke, const Vec3& v) {
  return stroke.kind == Stroke::Kind::half_space && std::abs(margin_of(stroke, v)) <= on_plane_mps;
}

}  // namespace

double margin_of(const Stroke& half_space, const Vec3& v) noexcept {
  return (v - half_space.points[0]).dot(half_space.points[1]);
}

bool contains(const Stroke& region, const Vec3& v) noexcept {
  // a ray to the north crosses the outline of what it begins in an odd number of times
  bool inside = false;
  const std::size_t n = region.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& a = region.points[i];
    const Vec3& b = region.points[(i + 1) % n];
    if ((a.y() > v.y()) == (b.y() > v.y())) continue;
    const double north = a.x() + (b.x() - a.x()) * (v.y() - a.y()) / (b.y() - a.y());
    if (north > v.x()) inside = !inside;
  }
  return inside;
}

std::vector<StrokeFacts> facts_of(std::span<const Stroke> strokes, const Vec3& preferred,
                                  const Vec3& commanded) {
  std::vector<StrokeFacts> all;
  for (const Stroke& stroke : strokes) {
    auto facts = std::ranges::find_if(
        all, [&](const StrokeFacts& f) { return f.kind == stroke.kind && f.meaning == stroke.meaning; });
    if (facts == all.end()) {
      all.push_back({.kind = stroke.kind, .meaning = stroke.meaning});
      facts = all.end() - 1;
    }
    ++facts->count;
    facts->points += stroke.points.size();
    facts->length += length_of(stroke);
    facts->forbids_preferred += forbids(stroke, preferred) ? 1 : 0;
    facts->forbids_commanded += forbids(stroke, commanded) ? 1 : 0;
    facts->active += is_active(stroke, commanded) ? 1 : 0;
    facts->strokes.push_back(&stroke);
  }
  return all;
}

}  // namespace fairway
