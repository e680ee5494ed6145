// SPDX-License-Identifier: Apache-2.0
#include "fairway/avoidance/velocity_obstacle/choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "fairway/avoidance/lanes/kernel.hpp"
#include "fairway/avoidance/velocity_obstacle/cone.hpp"
#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"

namespace fairway::velocity_obstacle {
namespace {

/// A boundary, and where it is nearest to v_d.
struct Candidate {
  Boundary boundary;
  Vec2 nearest;
  double distance;  ///< of `nearest` from v_d [m/s]
  std::size_t order;
};

constexpr std::size_t max_candidates =
    VelocityObstacle::max_boundaries * max_obstacles + ReachableSet::max_boundaries + 1;

/// Rings of samples over what is reachable.
constexpr int rings = 8;
constexpr int spokes = 32;

const std::array<math::SinCos, spokes> spoke_angles = [] {
  std::array<math::SinCos, spokes> all;
  for (int spoke = 0; spoke < spokes; ++spoke) all[spoke] = math::sin_cos(2.0 * pi * spoke / spokes);
  return all;
}();

/// Rounding, as part of the largest speed that matters.
constexpr double rounding = 1e-9;

/// What is this much deeper in an obstacle than the slack is in it whatever rounding does, as part of the
/// lengths that enter.
constexpr double certain = 1e-6;

/// By more than rounding.
bool is_to_port(const Wish& wish, const Vec2& v) {
  const double across = cross(wish.ahead, v);
  return across < 0.0 && across < -rounding * (v.norm() + wish.velocity.norm());
}

/// When a velocity has its turn to be tried: by the distance from v_d of what it comes from, then as listed.
struct Turn {
  double distance;
  std::size_t order;
  std::size_t part;
  friend auto operator<=>(const Turn&, const Turn&) = default;
};

constexpr std::size_t nobody = max_obstacles;

/// One decision: what is tried, and the best of it so far.
class Search {
 public:
  Search(std::span<const VelocityObstacle> obstacles, const ReachableSet& reachable, const Wish& wish)
      : obstacles_{obstacles}, reachable_{reachable}, wish_{wish} {
    const double fastest =
        std::min(reachable.max_speed(), reachable.middle().norm() + reachable.max_change());
    scale_ = std::min(2.0 * std::max({wish.velocity.norm(), reachable.middle().norm(), 0.5}), fastest);
    slack_ = rounding * scale_;
    for (std::size_t k = 0; k < obstacles.size(); ++k) cones_[k] = &obstacles[k].cone();
  }

  /// Tries v_d and all that can be nearest to it. False if nothing keeps clear of all.
  bool find_nearest() {
    try_clear(wish_.velocity);
    try_clear(reachable_.middle());
    try_clear(Vec2::Zero());
    try_all();
    if (best_cost_ == 0.0) return true;

    collect_boundaries();
    for (const Candidate& candidate : candidates()) {
      if (candidate.distance <= best_cost_) try_clear(candidate.nearest);
    }
    try_all();
    collect_seen();
    for (std::size_t i = 0; i < seen_count_ && seen_[i]->distance <= best_cost_; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (const Vec2& v : crossings(seen_[i]->boundary, seen_[j]->boundary)) try_clear(v);
      }
      try_all();
    }
    return is_found();
  }

  /// Tries samples, and where the boundaries are nearest to v_d or leave what is reachable.
  void find_least_bad() {
    const std::size_t worst = consider_any(reachable_.middle(), {-2.0, 0, 0});
    consider_any(Vec2::Zero(), {-2.0, 1, 0});
    std::array<Boundary, ReachableSet::max_boundaries> rim;
    const std::size_t rim_count = reachable_.boundaries(rim);
    for (const Candidate& candidate : candidates()) {
      Turn turn{candidate.distance, candidate.order, 0};
      consider_any(candidate.nearest, turn);
      for (std::size_t k = 0; k < rim_count; ++k) {
        for (const Vec2& v : crossings(candidate.boundary, rim[k])) {
          ++turn.part;
          consider_any(v, turn);
        }
      }
    }
    consider_rings(worst);
  }

  const Vec2& best() const { return best_; }

 private:
  bool is_found() const { return best_cost_ < std::numeric_limits<double>::infinity(); }

  std::span<const Candidate> candidates() const { return {candidates_.data(), count_}; }

  void collect_boundaries() {
    std::array<Boundary, VelocityObstacle::max_boundaries> own;
    for (const VelocityObstacle& obstacle : obstacles_) add(own, obstacle.boundaries(own));
    std::array<Boundary, ReachableSet::max_boundaries> rim;
    add(rim, reachable_.boundaries(rim));
    // on either side of the course wanted, costs differ
    const std::array<Boundary, 1> course{Boundary::line(Vec2::Zero(), wish_.ahead)};
    add(course, course.size());
  }

  void add(std::span<const Boundary> boundaries, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) {
      const Vec2 point = nearest(boundaries[k], wish_.velocity);
      candidates_[count_] = {boundaries[k], point, (point - wish_.velocity).norm(), count_};
      ++count_;
    }
  }

  /// The boundaries on which something may be better than the best so far, nearest to v_d first.
  void collect_seen() {
    for (const Candidate& candidate : candidates()) {
      if (candidate.distance <= best_cost_ && !is_hidden(candidate.boundary))
        seen_[seen_count_++] = &candidate;
    }
    std::sort(seen_.begin(), seen_.begin() + static_cast<std::ptrdiff_t>(seen_count_),
              [](const Candidate* a, const Candidate* b) {
                return std::tie(a->distance, a->order) < std::tie(b->distance, b->order);
              });
  }

  /// Whether all of it that can be reached, and is not farther from v_d than the best so far, is in velocity
  /// obstacles, rounding apart.
  bool is_hidden(const Boundary& boundary) {
    const double margin = slack_ + certain * (1.0 + boundary.point.lpNorm<1>() + boundary.radius);
    if (!boundary.is_line()) {
      return std::ranges::any_of(obstacles_, [&](const VelocityObstacle& obstacle) {
        return obstacle.holds_disc(boundary.point,
                                   boundary.radius + margin + certain * obstacle.apex().lpNorm<1>());
      });
    }
    const Boundary line = Boundary::line(nearest(boundary, Vec2::Zero()), boundary.direction);
    Stretch rest = reachable_.stretch(line, margin);
    if (is_found()) rest.keep_disc(line, wish_.velocity, best_cost_ + margin);
    if (rest.is_empty()) return true;

    return is_covered(line, rest, margin);
  }

  /// Whether the obstacles hold a stretch together: from one end of what is left of it to where it comes out
  /// of the obstacle that it is in. What covered something before is looked at first.
  bool is_covered(const Boundary& line, Stretch rest, double margin) {
    const std::size_t count = obstacles_.size();
    for (std::size_t looked_at = 0; looked_at < count; ++looked_at) {
      const VelocityObstacle& obstacle = obstacles_[coverer_];
      const Vec2 end = line.point + rest.from * line.direction;
      const double deep = margin + certain * obstacle.apex().lpNorm<1>();
      if (obstacle.depth(end) > deep) {
        const Stretch held = obstacle.stretch(line, deep);
        if (held.from <= rest.from && held.to > rest.from) {
          rest.from = held.to;
          if (rest.is_empty()) return true;
          looked_at = 0;  // this one: of all others any may hold the new end
        }
      }
      coverer_ = coverer_ + 1 < count ? coverer_ + 1 : 0;
    }
    return false;
  }

  /// `worst` is what keeps the middle from being the best.
  void consider_rings(std::size_t worst) {
    const double reach = std::min(reachable_.max_change(),
                                  limit_or(reachable_.max_speed(), scale_) + reachable_.middle().norm());
    for (std::size_t spoke = 0; spoke < spoke_angles.size(); ++spoke) {
      const auto& [sine, cosine] = spoke_angles[spoke];
      const Vec2 out = reach * turned(reachable_.bow(), cosine, sine);
      consider_between(out, spoke, {0, worst}, {rings, consider_ring(out, spoke, rings)});
    }
  }

  Vec2 on_ring(const Vec2& out, int ring) const { return reachable_.middle() + ring * out / rings; }

  std::size_t consider_ring(const Vec2& out, std::size_t spoke, int ring) {
    return consider_any(on_ring(out, ring), {-1.0, spoke, static_cast<std::size_t>(ring)});
  }

  /// A sample of a spoke, and the obstacle that keeps it from being the best.
  struct Sample {
    int ring;
    std::size_t worst;
  };

  /// All samples of a spoke between two that were tried. The velocities that lead into an obstacle before a
  /// certain time are convex: where it is too urgent at both ends it is so in between.
  void consider_between(const Vec2& out, std::size_t spoke, const Sample& a, const Sample& b) {
    if (b.ring - a.ring < 2 || is_too_urgent(a.worst, on_ring(out, b.ring)) ||
        is_too_urgent(b.worst, on_ring(out, a.ring))) {
      return;
    }
    const int ring = (a.ring + b.ring) / 2;
    const Sample middle{ring, consider_ring(out, spoke, ring)};
    consider_between(out, spoke, a, middle);
    consider_between(out, spoke, middle, b);
  }

  bool is_too_urgent(std::size_t k, const Vec2& v) const {
    if (k >= obstacles_.size()) return false;
    const VelocityObstacle& obstacle = obstacles_[k];
    return obstacle.depth(v) > slack_ + certain * (1.0 + obstacle.apex().lpNorm<1>()) &&
           wish_.collision_weight * obstacle.urgency(v) > (1.0 + certain) * best_cost_;
  }

  /// Together with others, in their order.
  void try_clear(const Vec2& v) {
    if ((v - wish_.velocity).norm() > best_cost_) return;
    tried_north_[tried_count_] = v.x();
    tried_east_[tried_count_] = v.y();
    if (++tried_count_ == most_together_) try_all();
  }

  void try_all() {
    if (tried_count_ == 0) return;
    const Tried tried{cones_.data(), obstacles_.size(), slack_, tried_north_.data(), tried_east_.data()};
    const unsigned outside = lanes::kernel_for(tried_count_).outside(tried);
    for (std::size_t i = 0; i < tried_count_; ++i) {
      if ((outside >> i & 1U) != 0) take_if_better({tried_north_[i], tried_east_[i]});
    }
    tried_count_ = 0;
  }

  void take_if_better(const Vec2& v) {
    if ((v - wish_.velocity).norm() > best_cost_) return;
    const double cost = wish_.cost(v);
    if (precedes(v, cost) && reachable_.contains(v, slack_)) take(v, cost);
  }

  /// Answers with an obstacle that is by itself too urgent for this to be the best, or nobody.
  std::size_t consider_any(const Vec2& v, const Turn& turn) {
    if (is_too_urgent(last_in_, v)) return last_in_;
    if ((v - wish_.velocity).norm() > best_cost_) return nobody;
    const double deviation = wish_.cost(v);
    if (!precedes(v, deviation, turn) || !reachable_.contains(v, slack_)) return nobody;
    double cost = deviation;
    for (std::size_t k = 0; k < obstacles_.size(); ++k) {
      if (!is_in(k, v)) continue;
      cost = std::max(cost, deviation + wish_.collision_weight * obstacles_[k].urgency(v));
      if (cost <= best_cost_) continue;
      last_in_ = k;
      return is_too_urgent(k, v) ? k : nobody;
    }
    if (precedes(v, cost, turn)) {
      take(v, cost);
      turn_ = turn;
    }
    return nobody;
  }

  bool is_in(std::size_t obstacle, const Vec2& v) const { return obstacles_[obstacle].depth(v) > slack_; }

  /// Less cost; of equal cost the one more to starboard, then the one more ahead.
  bool precedes(const Vec2& v, double cost) const {
    return cost < best_cost_ || (cost == best_cost_ && rank(v) > rank(best_));
  }
  /// Then the one whose turn is first.
  bool precedes(const Vec2& v, double cost, const Turn& turn) const {
    return precedes(v, cost) || (cost == best_cost_ && rank(v) == rank(best_) && turn < turn_);
  }

  std::pair<double, double> rank(const Vec2& v) const { return {cross(wish_.ahead, v), wish_.ahead.dot(v)}; }

  void take(const Vec2& v, double cost) {
    best_ = v;
    best_cost_ = cost;
  }

  alignas(64) std::array<double, lanes::most_lanes> tried_north_{};
  alignas(64) std::array<double, lanes::most_lanes> tried_east_{};
  std::span<const VelocityObstacle> obstacles_;
  const ReachableSet& reachable_;
  const Wish& wish_;
  double scale_;  ///< the largest speed that matters [m/s]
  double slack_;  ///< [m/s]
  std::array<Candidate, max_candidates> candidates_;
  std::size_t count_ = 0;
  std::array<const Candidate*, max_candidates> seen_;
  std::size_t seen_count_ = 0;
  const std::size_t most_together_ = lanes::kernel_for(lanes::most_lanes).lanes;
  std::array<const Cone*, max_obstacles> cones_;
  std::size_t tried_count_ = 0;
  std::size_t coverer_ = 0;  ///< the obstacle that covered something last
  std::size_t last_in_ = 0;  ///< of the obstacles; likely to be in the way of what is tried next too
  Vec2 best_ = Vec2::Zero();
  Turn turn_{};  ///< of the best
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
