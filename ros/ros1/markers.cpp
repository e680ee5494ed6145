// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/markers.hpp"

#include <algorithm>

namespace fairway::ros1 {
namespace {

using visualization_msgs::Marker;

std_msgs::ColorRGBA rgba_of(const Colour& colour) {
  std_msgs::ColorRGBA rgba;
  rgba.r = colour[0], rgba.g = colour[1], rgba.b = colour[2], rgba.a = colour[3];
  return rgba;
}

constexpr double mark_line_width_m = 0.04;
constexpr double mark_point_size_m = 0.1;

}  // namespace

void MarkerSet::begin(double time) {
  stamp_ = stamp_of(time);
  markers_.markers.clear();
  for (auto& [name_space, count] : counts_) count = {count.now, 0};
}

Marker& MarkerSet::add(const std::string& name_space, std::int32_t type, const Colour& colour) {
  Marker& marker = markers_.markers.emplace_back();
  marker.header.frame_id = world_;
  marker.header.stamp = stamp_;
  marker.ns = name_space;
  marker.id = counts_[name_space].now++;
  marker.type = type;
  marker.action = Marker::ADD;
  marker.color = rgba_of(colour);
  marker.pose.orientation.w = 1.0;
  return marker;
}

Marker& MarkerSet::add_solid(const std::string& name_space, std::int32_t type, const Colour& colour,
                             const Motion& where, const Triple& size) {
  Marker& marker = add(name_space, type, colour);
  const Motion shown = motion_in(frame_, where);
  marker.pose.position = point_of(shown.position_n);
  marker.pose.orientation = orientation_of(shown.q_nb);
  marker.scale = vector_of(size);
  return marker;
}

void MarkerSet::add_sphere(const std::string& name_space, const Colour& colour, const Triple& centre_n,
                           double diameter) {
  Marker& marker = add(name_space, Marker::SPHERE, colour);
  marker.pose.position = place_of(centre_n, frame_);
  marker.scale = vector_of({diameter, diameter, diameter});
}

void MarkerSet::add_words(const std::string& name_space, const Colour& colour, const Triple& place_n,
                          double height, const std::string& words) {
  Marker& marker = add(name_space, Marker::TEXT_VIEW_FACING, colour);
  marker.pose.position = place_of(place_n, frame_);
  marker.scale.z = height;
  marker.text = words;
}

void MarkerSet::add_line(const std::string& name_space, const Colour& colour,
                         const std::vector<Triple>& points_n, double width) {
  if (points_n.size() < 2) return;  // viewers complain
  Marker& marker = add(name_space, Marker::LINE_STRIP, colour);
  marker.scale.x = width;
  for (const Triple& point : points_n) marker.points.push_back(place_of(point, frame_));
}

void MarkerSet::add_mark(const bridge::Mark& mark) {
  using Kind = bridge::Mark::Kind;
  if (mark.points.empty()) return;
  switch (mark.kind) {
    case Kind::line:
      add_line(mark.meaning, mark.colour, mark.points, mark_line_width_m);
      return;
    case Kind::sphere:
      add_sphere(mark.meaning, mark.colour, mark.points.front(), 2.0 * mark.radius);
      return;
    case Kind::points:
    case Kind::triangles:
      break;
  }
  const bool are_triangles = mark.kind == Kind::triangles;
  if (are_triangles && mark.points.size() < 3) return;
  Marker& marker = add(mark.meaning, are_triangles ? Marker::TRIANGLE_LIST : Marker::POINTS, mark.colour);
  const double size = are_triangles ? 1.0 : mark_point_size_m;
  marker.scale = vector_of({size, size, size});
  const std::size_t whole = are_triangles ? mark.points.size() - mark.points.size() % 3 : mark.points.size();
  for (std::size_t i = 0; i < whole; ++i) marker.points.push_back(place_of(mark.points[i], frame_));
}

const visualization_msgs::MarkerArray& MarkerSet::finish() {
  for (const auto& [name_space, count] : counts_) {
    for (int id = count.now; id < count.before; ++id) {
      Marker& marker = markers_.markers.emplace_back();
      marker.header.frame_id = world_;
      marker.header.stamp = stamp_;
      marker.ns = name_space;
      marker.id = id;
      marker.action = Marker::DELETE;
    }
  }
  return markers_;
}

}  // namespace fairway::ros1
