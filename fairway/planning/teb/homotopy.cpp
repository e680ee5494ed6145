// SPDX-License-Identifier: Apache-2.0
#include "fairway/planning/teb/homotopy.hpp"

#include <algorithm>
#include <cmath>

#include "fairway/core/angles.hpp"
#include "fairway/core/math.hpp"
#include "fairway/planning/planar_map.hpp"

namespace fairway::teb {
namespace {

/// Adds the turns of one straight piece.
void add_turns(std::span<const BandObstacle> barriers, const Vec2& from, const Vec2& to, double begin,
               double end, Signature& turns) {
  for (std::size_t i = 0; i < barriers.size(); ++i) {
    const Vec2 a = from - barriers[i].centre(begin);
    const Vec2 b = to - barriers[i].centre(end);
    turns[i] += math::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) / (2.0 * pi);
  }
}

bool differ_by_a_turn(const Signature& a, const Signature& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::abs(a[i] - b[i]) >= 0.5) return true;
  }
  return false;
}

PlanarMap map_of(const TebParams& params, std::span<const BandObstacle> barriers) {
  std::vector<Obstacle> shapes;
  for (const BandObstacle& barrier : barriers) shapes.push_back(barrier.shape());
  return {shapes, params.min_obstacle_dist_m};
}

/// A graph of points whose edges all lead towards the end, and the search in it for ways of different
/// classes.
class Roadmap {
 public:
  Roadmap(const TebParams& params, std::span<const BandObstacle> barriers, const Vec2& start, const Vec2& end,
          Rng& rng)
      : params_{params}, barriers_{barriers}, map_{map_of(params, barriers)}, points_{start} {
    const Vec2 ahead = (end - start).normalized();
    scatter((end - start).norm(), ahead, rng);
    points_.push_back(end);
    connect(ahead);
    seen_.resize(points_.size());
  }

  std::vector<std::vector<Vec2>> search(std::size_t most, std::vector<Signature>& known) {
    visit(0, Signature(barriers_.size(), 0.0), 0.0, most, known);
    return std::move(found_);
  }

 private:
  /// Free points in the box between the ends; where there is hardly any room, fewer.
  void scatter(double length, const Vec2& ahead, Rng& rng) {
    constexpr int attempts = 10;
    const Vec2 abeam{-ahead.y(), ahead.x()};
    const double half_width = 0.5 * params_.roadmap_graph_area_width_m;
    const Vec2 start = points_.front();
    for (int left = attempts * params_.roadmap_graph_no_samples_count; left > 0; --left) {
      if (points_.size() > static_cast<std::size_t>(params_.roadmap_graph_no_samples_count)) return;
      const double along = rng.uniform(0.0, length);
      const Vec2 point = start + along * ahead + rng.uniform(-half_width, half_width) * abeam;
      if (map_.is_free(point)) points_.push_back(point);
    }
  }

  void connect(const Vec2& ahead) {
    edges_.resize(points_.size());
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
      for (std::size_t j = 1; j < points_.size(); ++j) {
        const Vec2 way = points_[j] - points_[i];
        if (i == j || way.dot(ahead) <= params_.obstacle_heading_threshold_ratio * way.norm()) continue;
        if (map_.is_free(points_[i], points_[j])) edges_[i].push_back(j);
      }
    }
  }

  /// Goes on from a point that was come to with these turns at this time. A second way to the same point with
  /// the same turns leads to no class that the first did not.
  void visit(std::size_t here, const Signature& turns, double time, std::size_t most,
             std::vector<Signature>& known) {
    if (found_.size() >= most) return;
    const auto same = [&](const Signature& other) { return !differ_by_a_turn(turns, other); };
    if (std::ranges::any_of(seen_[here], same)) return;
    seen_[here].push_back(turns);

    way_.push_back(points_[here]);
    const std::size_t end = points_.size() - 1;
    if (here == end) {
      keep(turns, known);
    } else {
      for (const std::size_t next : edges_[here]) {
        const double then = time + (points_[next] - points_[here]).norm() / params_.max_vel_x_mps;
        Signature further = turns;
        add_turns(barriers_, points_[here], points_[next], time, then, further);
        visit(next, further, then, most, known);
      }
    }
    way_.pop_back();
  }

  void keep(const Signature& turns, std::vector<Signature>& known) {
    if (is_among(params_, turns, known)) return;
    known.push_back(turns);
    found_.push_back(way_);
  }

  const TebParams& params_;
  std::span<const BandObstacle> barriers_;
  PlanarMap map_;
  std::vector<Vec2> points_;                     ///< the start first, the end last
  std::vector<std::vector<std::size_t>> edges_;  ///< of each point, where they lead
  std::vector<std::vector<Signature>> seen_;     ///< the turns with which each point was come to
  std::vector<Vec2> way_;                        ///< so far
  std::vector<std::vector<Vec2>> found_;
};

}  // namespace

Signature signature_of(std::span<const BandObstacle> barriers, const Vec2& from, const Vec2& to, double begin,
                       double end) {
  Signature turns(barriers.size(), 0.0);
  add_turns(barriers, from, to, begin, end, turns);
  return turns;
}

Signature signature_of(std::span<const BandObstacle> barriers, const Band& band) {
  Signature turns(barriers.size(), 0.0);
  double time = 0.0;
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    const double next = time + band.time(i);
    add_turns(barriers, band.position(i), band.position(i + 1), time, next, turns);
    time = next;
  }
  return turns;
}

bool are_alike(const TebParams& params, const Signature& a, const Signature& b) {
  if (!params.include_dynamic_obstacles) return !differ_by_a_turn(a, b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool both_count = math::fmin(std::abs(a[i]), std::abs(b[i])) >= params.h_signature_threshold_ratio;
    if (both_count && (a[i] > 0.0) != (b[i] > 0.0)) return false;
  }
  return true;
}

bool is_among(const TebParams& params, const Signature& turns, std::span<const Signature> classes) {
  return std::ranges::any_of(classes,
                             [&](const Signature& other) { return are_alike(params, turns, other); });
}

std::vector<std::vector<Vec2>> ways_of_new_classes(const TebParams& params,
                                                   std::span<const BandObstacle> barriers, const Vec2& start,
                                                   const Vec2& end, std::size_t most,
                                                   std::vector<Signature>& known, Rng& rng) {
  return Roadmap{params, barriers, start, end, rng}.search(most, known);
}

}  // namespace fairway::teb
