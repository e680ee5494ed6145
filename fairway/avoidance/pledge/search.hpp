// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/avoidance/pledge/clearance.hpp"

namespace fairway::pledge {

/// What all members of a group have to have in common.
struct Terms {
  std::size_t count{most_members};  ///< members are 0 to count - 1
  Vec2 datum = Vec2::Zero();        ///< to which places are told [m, north and east]
  Tubes tubes{};
};

/// Looks for a plan by which all of those who are held get to their destinations, soonest in the mean. First
/// a carousel: those who dive by one ring, those who climb by another. Where none is clear, one member after
/// the other takes the soonest code that is clear of those before it; whoever has none stays, and all begin
/// again round it. Then each looks for a sooner one. A value: it goes on from where it was, a few codes at a
/// time. Nothing allocates.
class Search {
 public:
  Search() = default;

  /// Of a plan that begins at time 0. `others` are the references of those who do not take part and stay
  /// where they are, as far as they are known; the rest of them have no knots. `attempt` counts from 0: every
  /// one has another centre, and another who is first.
  Search(const std::array<Member, most_members>& members, const Members& participants,
         const std::array<Reference, most_members>& others, const Terms& terms, std::size_t attempt) noexcept;

  /// Tries so many codes, or carousels, more. True when it has ended.
  bool go_on(int count) noexcept;

  /// Whether somebody can go. Those who cannot are left out of the participants.
  bool found() const { return best_.participants.any(); }
  const Plan& best() const { return best_; }

 private:
  enum class Stage { carousel, one_by_one, improve, done };

  void begin() noexcept;
  Clearance empty() const noexcept;
  void try_carousel(int number) noexcept;
  void end_carousels() noexcept;
  void try_next_code() noexcept;
  void improve_next() noexcept;
  void keep(const Clearance& scene, const Plan& plan) noexcept;
  std::size_t numbered(std::size_t turn) const noexcept { return (turn + attempt_) % most_members; }
  bool next_member() noexcept;

  std::array<Member, most_members> members_{};
  Members participants_{};
  std::array<Reference, most_members> others_{};
  Tubes tubes_{};
  std::size_t attempt_{};
  Vec2 centre_ = Vec2::Zero();

  Stage stage_{Stage::done};
  bool improved_{false};
  int number_{0};          ///< of the next carousel, or code
  std::size_t turn_{0};    ///< of the member that takes a code now
  std::size_t member_{0};  ///< that member
  Clearance scene_{};
  Plan plan_{};
  double soonest_{};  ///< of the member's codes that were tried
  Code code_{};

  Plan best_{};
  double best_time_{};  ///< until they are at their ends, in the mean [s]
};

}  // namespace fairway::pledge
