// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "fairway/avoidance/pledge/words.hpp"

namespace fairway::pledge {

/// Of the rings by number [m]; 0 is straight on. Two neighbours of a kind are no closer than a vehicle's own
/// length, and inner and outer ones as far apart as two that pass have to be.
inline constexpr std::array<double, 8> ring_radius{0.0, 3.6, 4.2, 5.0, 6.0, 7.0, 8.0, 9.5};
inline constexpr std::array<double, 4> ring_scale{1.0, 1.5, 2.5, 4.0};    ///< of all rings of a plan
inline constexpr double never = std::numeric_limits<double>::infinity();  ///< as a time [s]
inline constexpr double delay_step = 3.0;                                 ///< [s]
inline constexpr double set_off = 1.0;       ///< from a plan's start until who has turned before leaves [s]
inline constexpr int most_levels = 3;        ///< below a member's own way, if that is level
inline constexpr double level_within = 1.0;  ///< a way is level whose ends differ by less in depth [m]
/// Who tells that it dives no faster stays on its way; a step of what is told [m/s].
inline constexpr double level_keeping = 0.05;

struct Knot {
  double time{};                 ///< [s]
  Vec3 position = Vec3::Zero();  ///< [m, NED]
};

/// Where a member is at what time: held at the first knot before it, straight on from one to the next, and
/// held at the last one for ever.
class Reference {
 public:
  static constexpr std::size_t most_knots = 32;

  Reference() = default;
  /// Held at `place` for ever.
  explicit Reference(const Vec3& place) : count_{1} { knots_[0] = {0.0, place}; }

  void add(const Knot& knot) noexcept {
    if (count_ < most_knots) knots_[count_++] = knot;
  }
  std::span<const Knot> knots() const { return {knots_.data(), count_}; }
  operator std::span<const Knot>() const { return knots(); }

  Vec3 at(double time) const noexcept;
  Vec3 velocity(double time) const noexcept;
  double end() const { return knots_[count_ - 1].time; }
  bool empty() const { return count_ == 0; }

  /// The same up to `time`, and held there for ever.
  Reference until(double time) const noexcept;
  /// The same so much later [s], and so far off [m].
  Reference moved(double seconds, const Vec3& off) const noexcept;
  Reference later(double seconds) const noexcept { return moved(seconds, Vec3::Zero()); }

 private:
  std::array<Knot, most_knots> knots_{};
  std::size_t count_{0};
};

/// The horizontal way of one member by a ring of a plan, from 0 on: straight on at its constant speed, and at
/// sharp corners a halt in which it turns.
class Passage {
 public:
  Passage() = default;
  Passage(const Member& member, const Plan& plan, std::uint8_t ring) noexcept;

  std::span<const double> times() const { return {times_.data(), count_}; }  ///< of its corners [s]
  double duration() const { return times_[count_ - 1]; }                     ///< [s]
  Vec2 at(double time) const noexcept;                                       ///< [m, north and east]

 private:
  void add(double time, const Vec2& place) noexcept {
    if (count_ == times_.size()) return;
    times_[count_] = time;
    places_[count_++] = place;
  }

  std::array<double, 24> times_{};
  std::array<Vec2, 24> places_{};
  std::size_t count_{0};
};

/// The way of one member by a plan: it waits for its delay, turns if it has not done so before, and goes by
/// the tangents of its ring, while it climbs or dives, each at its constant rate; where its way is level, so
/// many levels below that. It ends as far from the destination as the member arrives for certain. O(1).
Reference reference_of(const Member& member, const Plan& plan, const Code& code) noexcept;
/// The same, where its passage by that ring is known.
Reference reference_of(const Member& member, const Plan& plan, const Code& code,
                       const Passage& passage) noexcept;

/// Whether its way is level and it tells that it can dive and climb: then it may go below others.
bool has_levels(const Member& member) noexcept;
/// Whether it goes below its way by this code, where it has levels.
bool is_below(const Member& member, const Code& code) noexcept;
/// Whether it does so by diving where it is held and climbing where it ends, and not while it goes along.
bool is_on_the_spot(const Member& member, const Code& code) noexcept;
/// How long it turns where it is held, before it goes along [s].
double turns_for(const Member& member) noexcept;
/// How long before a plan's start it begins to turn to its way at the latest [s].
double turns_ahead_by(const Member& member) noexcept;
/// How long it waits from the plan's start on, by its code [s].
double delay_of(const Member& member, const Code& code) noexcept;
/// From a member's way to its next level below it [m].
double level_step(const Member& member) noexcept;

/// So far from its destination it ends [m].
double ends_before(const Member& member) noexcept;

/// How close two references ever come, given by their knots, between two times; or, where that is less than
/// `enough`, anything that is less [m]. O(knots), exact.
double least_distance(std::span<const Knot> a, std::span<const Knot> b, double from, double to = never,
                      double enough = -never) noexcept;

/// The first time at which the reference comes within `distance` of a place, or never. O(knots), exact.
double first_within(const Reference& reference, const Vec3& place, double distance) noexcept;

}  // namespace fairway::pledge
