// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/cross_flow.hpp"

#include <algorithm>
#include <span>

namespace fairway {
namespace {

struct Point {
  double x, y;
};

/// Straight lines between points that ascend in x; constant beyond them.
double interpolated(std::span<const Point> points, double x) noexcept {
  if (!(x > points.front().x)) return points.front().y;
  if (x >= points.back().x) return points.back().y;
  const auto after = std::ranges::upper_bound(points, x, {}, &Point::x);
  const Point a = *(after - 1), b = *after;
  return a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
}

// C_d over beam / (2 draft)
constexpr std::array<Point, 20> hoerner_curve{
    {{0.0108623, 1.96608}, {0.176606, 1.96573}, {0.353025, 1.89756},  {0.451863, 1.78718},
     {0.472838, 1.58374},  {0.492877, 1.27862}, {0.493252, 1.21082},  {0.558473, 1.08356},
     {0.646401, 0.998631}, {0.833589, 0.87959}, {0.988002, 0.828415}, {1.30807, 0.759941},
     {1.63918, 0.691442},  {1.85998, 0.657076}, {2.31288, 0.630693},  {2.59998, 0.596186},
     {3.00877, 0.586846},  {3.45075, 0.585909}, {3.7379, 0.559877},   {4.00309, 0.559315}}};

// C_d of an endless smooth cylinder over the Reynolds number
constexpr std::array<Point, 28> cylinder_curve{
    {{10211.04, 1.20769},  {15543.52, 1.20369},  {24434.87, 1.20823},  {35719.88, 1.21060},
     {60880.75, 1.21093},  {86174.74, 1.20901},  {118086.4, 1.21134},  {149262.3, 1.21148},
     {214708.9, 1.21171},  {230940.4, 1.20109},  {271581.4, 1.16918},  {297098.2, 1.11163},
     {325252.0, 1.00926},  {361942.8, 0.89411},  {409798.2, 0.70855},  {475302.4, 0.53155},
     {524735.0, 0.40785},  {578921.9, 0.32683},  {638292.9, 0.28422},  {744046.4, 0.29711},
     {853237.6, 0.32280},  {1068685.7, 0.38909}, {1393381.4, 0.47033}, {1831850.4, 0.53878},
     {2258395.5, 0.58372}, {2899011.9, 0.62868}, {3663279.0, 0.64803}, {4937305.5, 0.67808}}};

// reduction over length / diameter, below and above the critical Reynolds number
constexpr double critical_reynolds = 2e5;
constexpr std::array<Point, 7> subcritical_curve{
    {{2, 0.58}, {5, 0.62}, {10, 0.68}, {20, 0.74}, {40, 0.82}, {50, 0.87}, {100, 0.98}}};
constexpr std::array<Point, 7> supercritical_curve{
    {{2, 0.80}, {5, 0.80}, {10, 0.82}, {20, 0.90}, {40, 0.98}, {50, 0.99}, {100, 1.00}}};

constexpr int strip_count = 20;

}  // namespace

double hoerner_drag(double beam_m, double draft_m) {
  return interpolated(hoerner_curve, beam_m / (2.0 * draft_m));
}

CylinderDrag::CylinderDrag(double slenderness)
    : subcritical_reduction_{interpolated(subcritical_curve, slenderness)},
      supercritical_reduction_{interpolated(supercritical_curve, slenderness)} {}

double CylinderDrag::at(double reynolds) const noexcept {
  const double reduction = reynolds < critical_reynolds ? subcritical_reduction_ : supercritical_reduction_;
  return reduction * interpolated(cylinder_curve, reynolds);
}

CrossFlow::CrossFlow(double length_m, double depth_m, double density_kgpm3)
    : per_coefficient_{0.5 * density_kgpm3 * depth_m * length_m / strip_count} {
  for (std::size_t i = 0; i < x_.size(); ++i) {
    x_[i] = length_m * (static_cast<double>(i) / strip_count - 0.5);
  }
}

}  // namespace fairway
