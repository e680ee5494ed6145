// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include "fairway/avoidance/pledge/clashes.hpp"
#include "fairway/avoidance/pledge/clearance.hpp"
#include "fairway/avoidance/pledge/headway.hpp"
#include "fairway/avoidance/pledge/other_groups.hpp"

namespace fairway::pledge {

/// Looks for a plan by which all of those who are held get to their destinations, soonest in the mean, where
/// each second of headway that a plan lacks counts as half a second. First a carousel: those who dive by one
/// ring, those who climb by another. Where none is clear, one member after the other takes the soonest code
/// that is clear of those before it. Where that leaves somebody behind, it takes one by which it dives where
/// it is held and climbs where it ends, and is in the way of few; whoever has none stays, and all begin again
/// round it. Then each looks for a sooner code. Where something stands in the way and not all can go, it does
/// the same with rings round that; where nobody can, with those alone who lie at each other's destinations. A
/// value: it goes on from where it was, a few codes at a time. Nothing allocates.
class Search {
 public:
  Search() = default;

  /// So many centres and widths of rings are tried where something stands in the way.
  static constexpr std::size_t most_hubs = 6;
  /// Rings have so many centres, one for each attempt.
  static constexpr std::size_t centres = 2 + most_members;

  /// Plans are looked for as if they began then, where nobody is on its way.
  static constexpr Epoch at_zero{.tenths = 0};

  /// Of a plan that begins at `start`. `others` are the references of those who do not take part, as far as
  /// they are known; the rest of them have no knots. `attempt` counts from 0: every one has another centre,
  /// and another who is first. All that is asked keeps off what stands. Where somebody is on its way nobody
  /// goes a way that takes a minute longer than to wait until all such have come to their ends, and to go
  /// straight then; nor by the first attempt where it would be so beside all who are asked, on straight ways.
  Search(const std::array<Member, most_members>& members, const Members& participants,
         const std::array<Reference, most_members>& others, const Terms& terms, std::size_t attempt,
         const Chart& chart, const Headway& wanted = {}, const Epoch& start = at_zero) noexcept;

  /// Tries so many codes, or carousels, more, on the chart that it was made with. True when it has ended.
  bool go_on(int count, const Chart& chart) noexcept;

  /// Whether all who were asked can go.
  bool found_all() const { return found() && best_.plan.participants == asked_; }
  /// Whether somebody can go. Those who cannot are left out of the participants.
  bool found() const { return best_.is_any(); }
  const Plan& best() const { return best_.plan; }
  const Epoch& start() const { return start_; }
  /// Whether the best keeps clear of those who are on their ways if it begins then instead.
  bool holds_from(const Epoch& start, std::span<const Passing> passing) const noexcept;

 private:
  enum class Stage { carousel, one_by_one, on_the_spot, improve, done };

  /// What the rings go round, and how wide they are.
  struct Hub {
    Vec2 centre = Vec2::Zero();
    std::uint8_t scale{};
  };

  std::array<Reference, most_members> straight_ways() const noexcept;
  void find_limits(const Chart& chart) noexcept;
  void find_hubs(const Chart& chart, const Vec2& datum) noexcept;
  void begin() noexcept;
  void begin_hub() noexcept;
  void begin_with(Stage stage, const Plan& plan) noexcept;
  Plan empty_plan() const noexcept;
  Clearance scene_beside(const std::array<Reference, most_members>& others, const Members& participants,
                         const Epoch& start) const noexcept;
  std::optional<std::size_t> hindrance_to(std::size_t member, const Reference& reference,
                                          const Clearance& scene, const Chart& chart) const noexcept;
  bool are_any_level() const noexcept;
  bool goes_on_the_spot() const noexcept;
  bool is_to_be_tried() const noexcept;
  bool is_first_of_ring() const noexcept;
  int carousel_count() const noexcept;
  double cost_of(const Reference& reference) noexcept;
  template <class HeadwayTowards>
  double lack_of(const HeadwayTowards& headway_towards) const noexcept;
  void try_carousel(int number, const Chart& chart) noexcept;
  void end_carousels() noexcept;
  void try_code(double limit, const Chart& chart) noexcept;
  void try_next_code(const Chart& chart) noexcept;
  void improve_next(const Chart& chart) noexcept;
  void end_hub() noexcept;
  bool next_chain() noexcept;
  void stay(const Members& who) noexcept;
  Members chain_from(std::size_t head) const noexcept;

  /// A plan, and how long it takes them to their ends, in the mean, with what its headway lacks [s].
  struct Option {
    Plan plan{};
    double cost{};
    bool is_any() const { return plan.participants.any(); }
    bool is_better_than(const Option& other) const;
  };

  void keep(const Clearance& scene, const Plan& plan) noexcept;
  std::size_t numbered(std::size_t turn) const noexcept { return (turn + attempt_) % most_members; }
  bool next_member() noexcept;

  std::array<Member, most_members> members_{};
  Members asked_{};         ///< to take part
  Members company_{};       ///< those of them who are tried now; the others stay
  std::size_t chain_{0};    ///< the next company is that of the member of this number
  Members participants_{};  ///< who can, as far as has been tried
  Members went_{};          ///< of these, one by one, at first
  std::array<Reference, most_members> others_{};
  std::array<Reference, most_members> ways_{};  ///< the same, and of who stays where it is
  Tubes tubes_{};
  std::size_t attempt_{};
  Headway wanted_{};
  Epoch start_{};                              ///< of the plans that are looked for
  std::array<double, most_members> latest_{};  ///< at its end; who would be later stays [s]
  std::array<Hub, most_hubs> hubs_{};
  std::size_t hub_count_{0}, hub_{0};

  Stage stage_{Stage::done};
  int number_{0};             ///< of the next carousel, or code
  int spent_{0};              ///< on headway, in codes
  Clashes clashes_{};         ///< of carousels of the side and width that are tried
  std::size_t suspected_{0};  ///< who hindered the last of the codes that were tried
  bool improved_{false};
  Code code_{};            ///< that the member may take
  std::size_t turn_{0};    ///< of the member that takes a code now
  std::size_t member_{0};  ///< that member
  Clearance scene_{};
  Plan plan_{};
  Passage passage_{};  ///< of that member by the ring of its code
  std::array<double, 2 * most_levels + 1>
      undelayed_{};      ///< when it is there by that ring, by how it dives [s]
  double least_cost_{};  ///< of the member's codes that were tried [s]
  double cost_{};        ///< of the code that the member has [s]

  Option of_hub_{}, best_{};
};

}  // namespace fairway::pledge
