// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "fairway/core/angles.hpp"

namespace fairway::velocity_obstacle {
namespace {

/// A boundary, and how far v_d is from it.
struct Candidate {
  Boundary boundary;
  double distance;
  std::size_t order;
};

constexpr std::size_t max_candidates =
    VelocityObstacle::max_boundaries * max_obstacles + ReachableSet::max_boundaries + 1;

/// Rings of samples over what is reachable.
constexpr int rings = 8;
constexpr int spokes = 32;

/// Rounding, as part of the largest speed that matters.
constexpr double rounding = 1e-9;

/// By more than rounding.
bool is_to_port(const Wish& wish, const Vec2& v) {
  return cross(wish.ahead, v) < -rounding * (v.norm() + wish.velocity.norm());
}

/// One decision: what is tried, and the best of it so far.
class Search {
 public:
  Search(std::span<const VelocityObstacle> obstacles, const ReachableSet& reachable, const Wish& wish)
      : obstacles_{obstacles}, reachable_{reachable}, wish_{wish} {
    const double fastest =
        std::min(reachable.max_speed(), reachable.middle().norm() + reachable.max_change());
    scale_ = std::min(2.0 * std::max({wish.velocity.norm(), reachable.middle().norm(), 0.5}), fastest);
    slack_ = rounding * scale_;
  }

  /// Tries v_d and all that can be nearest to it. False if nothing keeps clear of all.
  bool find_nearest() {
    const auto consider = [&](const Vec2& v) { consider_clear(v); };
    consider(wish_.velocity);
    if (is_found()) return true;

    collect_boundaries();
    consider(reachable_.middle());
    consider(Vec2::Zero());
    for (const Candidate& candidate : candidates()) consider(nearest(candidate.boundary, wish_.velocity));
    for (std::size_t i = 0; i < count_ && candidates_[i].distance <= best_cost_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const Vec2& v : crossings(candidates_[i].boundary, candidates_[j].boundary)) consider(v);
      }
    }
    return is_found();
  }

  /// Tries samples, and where the boundaries are nearest to v_d or leave what is reachable.
  void find_least_bad() {
    const auto consider = [&](const Vec2& v) { consider_any(v); };
    consider(reachable_.middle());
    consider(Vec2::Zero());
    consider_rings();
    std::array<Boundary, ReachableSet::max_boundaries> rim;
    const std::size_t rim_count = reachable_.boundaries(rim);
    for (const Candidate& candidate : candidates()) {
      consider(nearest(candidate.boundary, wish_.velocity));
      for (std::size_t k = 0; k < rim_count; ++k) {
        for (const Vec2& v : crossings(candidate.boundary, rim[k])) consider(v);
      }
    }
  }

  const Vec2& best() const { return best_; }

 private:
  bool is_found() const { return best_cost_ < std::numeric_limits<double>::infinity(); }

  std::span<const Candidate> candidates() const { return {candidates_.data(), count_}; }

  /// Nearest to v_d first.
  void collect_boundaries() {
    std::array<Boundary, VelocityObstacle::max_boundaries> own;
    for (const VelocityObstacle& obstacle : obstacles_) add(own, obstacle.boundaries(own));
    std::array<Boundary, ReachableSet::max_boundaries> rim;
    add(rim, reachable_.boundaries(rim));
    // on either side of the course wanted, costs differ
    const std::array<Boundary, 1> course{Boundary::line(Vec2::Zero(), wish_.ahead)};
    add(course, course.size());
    std::sort(candidates_.begin(), candidates_.begin() + static_cast<std::ptrdiff_t>(count_),
              [](const Candidate& a, const Candidate& b) {
                return std::tie(a.distance, a.order) < std::tie(b.distance, b.order);
              });
  }

  void add(std::span<const Boundary> boundaries, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const double distance = (nearest(boundaries[k], wish_.velocity) - wish_.velocity).norm();
      candidates_[count_] = {boundaries[k], distance, count_};
      ++count_;
    }
  }

  void consider_rings() {
    const double reach = std::min(reachable_.max_change(),
                                  limit_or(reachable_.max_speed(), scale_) + reachable_.middle().norm());
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double angle = 2.0 * pi * spoke / spokes;
      const Vec2 out = reach * fairway::turned(reachable_.bow(), angle);
      for (int ring = 1; ring <= rings; ++ring) consider_any(reachable_.middle() + ring * out / rings);
    }
  }

  void consider_clear(const Vec2& v) {
    const double cost = wish_.cost(v);
    if (!precedes(v, cost) || !reachable_.contains(v, slack_)) return;
    if (!obstacles_.empty() && is_in(last_in_, v)) return;
    for (std::size_t k = 0; k < obstacles_.size(); ++k) {
      if (is_in(k, v)) {
        last_in_ = k;
        return;
      }
    }
    take(v, cost);
  }

  void consider_any(const Vec2& v) {
    const double deviation = wish_.cost(v);
    if (!precedes(v, deviation) || !reachable_.contains(v, slack_)) return;
    double cost = deviation;
    for (std::size_t k = 0; k < obstacles_.size() && cost <= best_cost_; ++k) {
      if (is_in(k, v)) cost = std::max(cost, deviation + wish_.collision_weight * obstacles_[k].urgency(v));
    }
    if (precedes(v, cost)) take(v, cost);
  }

  bool is_in(std::size_t obstacle, const Vec2& v) const { return obstacles_[obstacle].depth(v) > slack_; }

  /// Less cost; of equal cost the one more to starboard, then the one more ahead.
  bool precedes(const Vec2& v, double cost) const {
    if (cost != best_cost_) return cost < best_cost_;
    const auto rank = [&](const Vec2& u) { return std::pair{cross(wish_.ahead, u), wish_.ahead.dot(u)}; };
    return rank(v) > rank(best_);
  }

  void take(const Vec2& v, double cost) {
    best_ = v;
    best_cost_ = cost;
  }

  std::span<const VelocityObstacle> obstacles_;
  const ReachableSet& reachable_;
  const Wish& wish_;
  double scale_;  ///< the largest speed that matters [m/s]
  double slack_;  ///< [m/s]
  std::array<Candidate, max_candidates> candidates_;
  std::size_t count_ = 0;
  std::size_t last_in_ = 0;  ///< of the obstacles; likely to be in the way of what is tried next too
  Vec2 best_ = Vec2::Zero();
  double best_cost_ = std::numeric_limits<double>::infinity();
};

}  // namespace

double Wish::cost(const Vec2& v) const {
  return (v - velocity).norm() * (is_to_port(*this, v) ? 1.0 + starboard_bias : 1.0);
}

ChosenVelocity choose(std::span<const VelocityObstacle> obstacles, const ReachableSet& reachable,
                      const Wish& wish) noexcept {
  Search search(obstacles, reachable, wish);
  const bool is_feasible = search.find_nearest();
  if (!is_feasible) search.find_least_bad();
  return {search.best(), is_feasible};
}

}  // namespace fairway::velocity_obstacle
