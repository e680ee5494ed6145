// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/drawing.hpp"

namespace fairway {

Stroke& Drawing::add(Stroke::Kind kind, std::string_view meaning) {
  Stroke& stroke = strokes_.emplace_back();
  stroke.kind = kind;
  stroke.meaning = meaning;
  return stroke;
}

void Drawing::velocity(const Vec3& v, std::string_view meaning) {
  add(Stroke::Kind::velocity, meaning).points = {v};
}

void Drawing::half_space(const Vec3& point, const Vec3& normal, std::string_view meaning) {
  add(Stroke::Kind::half_space, meaning).points = {point, normal};
}

void Drawing::region(std::span<const Vec3> outline, std::string_view meaning) {
  add(Stroke::Kind::region, meaning).points.assign(outline.begin(), outline.end());
}

void Drawing::path(std::span<const Vec3> points, std::string_view meaning) {
  add(Stroke::Kind::path, meaning).points.assign(points.begin(), points.end());
}

void Drawing::tree(std::span<const Vec3> edges, std::string_view meaning) {
  add(Stroke::Kind::tree, meaning).points.assign(edges.begin(), edges.end());
}

void Drawing::sphere(const Vec3& centre, double radius, std::string_view meaning) {
  Stroke& stroke = add(Stroke::Kind::sphere, meaning);
  stroke.points = {centre};
  stroke.size = radius;
}

void Drawing::image(const VelocityImage& image, std::string_view meaning) {
  Stroke& stroke = add(Stroke::Kind::image, meaning);
  stroke.rgb.assign(image.rgb.begin(), image.rgb.end());
  stroke.side = image.side;
  stroke.size = image.reach;
  stroke.yaw = image.yaw;
}

}  // namespace fairway
