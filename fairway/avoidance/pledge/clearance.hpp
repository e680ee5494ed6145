// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>

#include "fairway/avoidance/pledge/reference.hpp"
#include "fairway/core/shapes.hpp"

namespace fairway::pledge {

/// How far members may be off what they promised [m].
struct Tubes {
  double radius{};  ///< from the reference at its time, or from the anchor
  double told{};    ///< of all that is rounded, and of clocks that differ, for a pair
};

/// How far the centres of two have to be from each other [m].
inline double least_apart(double radius_a, double radius_b, const Tubes& tubes) noexcept {
  return radius_a + radius_b + 2.0 * tubes.radius + tubes.told;
}
inline double least_apart(const Member& a, const Member& b, const Tubes& tubes) noexcept {
  return least_apart(a.radius, b.radius, tubes);
}

/// How far the centres of two have to be from each other of whom one has stopped on its way [m]: both radii,
/// what is told roughly, and one tube, for what the stopped one runs on and both are off their ways. Not both
/// tubes: here nobody promises anything, and members are mostly half a metre off.
inline double least_beside(const Member& a, const Member& b, const Tubes& tubes) noexcept {
  return a.radius + b.radius + tubes.radius + tubes.told;
}

/// A place where somebody may stay for ever from a time on.
struct Stop {
  double time{};  ///< [s]
  Vec3 place = Vec3::Zero();
};
struct Stops {
  std::array<Stop, most_members + 2> all{};
  std::size_t count{0};
  void add(double time, const Vec3& place) noexcept { all[count++] = {time, place}; }
};

/// A vehicle of another group that is on its way: it keeps to that, or stays at one of its stops.
struct Passing {
  std::size_t vehicle{};
  double radius{};  ///< of its sphere [m]
  Reference way;
  Stops stops;
};

/// Members with the references that they have been given, and whether these keep clear of each other whatever
/// words are lost:
///
/// - V1: two references are never closer than both radii, both tubes and what is told roughly;
/// - V2: a reference keeps as clear of every other anchor until its gate, the instant before which the member
///   has to know that the other has departed, or else stops there;
/// - V3: wherever a gate may stop a member, or it may have arrived, it is clear of all other references from
///   then on.
///
/// Two whose references begin nearer to each other than that come no nearer.
class Clearance {
 public:
  /// Of a member, by whom it has to know departed [s]; infinity where it never comes near.
  using Gates = std::array<double, most_members>;

  Clearance() = default;
  Clearance(const std::array<Member, most_members>& members, const Members& participants, const Tubes& tubes,
            double start)
      : members_{members}, participants_{participants}, tubes_{tubes}, start_{start} {}

  /// Who of the others that have been placed keeps the member from going so, or the member itself, if it
  /// would have to know of somebody before anybody departs; nobody if it may. Who is `suspected` is asked
  /// first, the others by number. O(placed^2 knots) at worst, O(placed knots) where few gates bind.
  std::optional<std::size_t> hindered_by(std::size_t member, const Reference& reference,
                                         std::size_t suspected = 0) const noexcept;
  bool accepts(std::size_t member, const Reference& reference) const noexcept {
    return !hindered_by(member, reference);
  }

  /// Whether a member that goes so keeps as clear (V1, V3) of those of other groups who are on their ways.
  /// O(passing knots).
  bool passes(std::size_t member, const Reference& reference,
              std::span<const Passing> passing) const noexcept;
  /// The member that goes so, as others see it.
  Passing passing(std::size_t member, const Reference& reference) const noexcept;

  void place(std::size_t member, const Reference& reference) noexcept;
  void take_away(std::size_t member) noexcept { placed_.reset(member); }

  /// What two need of whom one has stopped (least_beside) [m].
  double beside(std::size_t a, std::size_t b) const noexcept {
    return least_beside(members_[a], members_[b], tubes_);
  }
  const Members& placed() const { return placed_; }
  const Reference& reference(std::size_t member) const { return references_[member]; }

  /// Of a member that goes so, placed or not. O(members knots).
  Gates gates_of(std::size_t member, const Reference& reference) const noexcept;
  double gate(std::size_t member, std::size_t other) const noexcept { return gates_[member][other]; }

 private:
  double apart(std::size_t a, std::size_t b, const Vec3& from, const Vec3& to,
               double beyond = 0.0) const noexcept;
  Stops stops_of(std::size_t member, const Reference& reference, const Gates& gates) const noexcept;
  static bool are_clear(const Stops& stops, const Reference& of_other, double apart) noexcept;

  std::array<Member, most_members> members_{};
  Members participants_{};
  Tubes tubes_{};
  double start_{};
  Members placed_{};
  std::array<Reference, most_members> references_{};
  std::array<Gates, most_members> gates_{};
  std::array<Stops, most_members> stops_{};
};

/// What stands, as far as a member knows it, the places at which vehicles of other groups are held, and those
/// of them who are on their ways.
class Chart {
 public:
  Chart() = default;
  template <class Obstacles>
    requires std::convertible_to<const Obstacles&, std::span<const Obstacle>>
  Chart(const Obstacles& standing, std::span<const Obstacle> held = {}, std::span<const Passing> passing = {})
      : parts_{standing, held}, passing_{passing} {}

  bool empty() const { return parts_[0].empty() && !has_others(); }
  bool has_others() const { return !parts_[1].empty() || !passing_.empty(); }
  std::span<const Obstacle> standing() const { return parts_[0]; }
  std::span<const Obstacle> held() const { return parts_[1]; }
  std::span<const Passing> passing() const { return passing_; }
  /// What stays where it is.
  std::span<const std::span<const Obstacle>> parts() const { return parts_; }

 private:
  std::array<std::span<const Obstacle>, 2> parts_{};
  std::span<const Passing> passing_;
};

/// Whether a reference is never nearer than `distance` [m] to what stands between two times, or, where it is
/// nearer at the first of them, comes no nearer. To 3 cm. O(obstacles x length) at worst, few steps for each
/// obstacle that is far off.
bool keeps_off(const Reference& reference, const Obstacle& obstacle, double distance, double from = -never,
               double to = never) noexcept;
bool keeps_off(const Reference& reference, const Chart& chart, double distance, double from = -never,
               double to = never) noexcept;

/// From what stands, for the centre of a member: its sphere, its tube, and its half of what is told roughly
/// [m].
inline double berth(const Member& member, const Tubes& tubes) noexcept {
  return member.radius + tubes.radius + 0.5 * tubes.told;
}

}  // namespace fairway::pledge
