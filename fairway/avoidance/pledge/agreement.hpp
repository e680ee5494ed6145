// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string_view>

#include "fairway/avoidance/pledge/other_groups.hpp"
#include "fairway/avoidance/pledge/search.hpp"

namespace fairway::pledge {

/// What became of a word that came in.
enum class Hearing : std::uint8_t {
  taken,
  early,       ///< it was said later than it is by own clock, and may be heard again then
  unreadable,  ///< damaged, or of another version
};

/// One member's part of an agreement. It is held at its anchor until it has a plan that every member has
/// acknowledged, and then keeps to its reference. The rules, on which the safety argument of the README
/// rests:
///
/// 1. Acknowledgements go upwards: a member acknowledges no plan that is older than one that it has
///    acknowledged before, and none whose start has passed, or is so near that not all might hear of it.
/// 2. It acknowledges a plan only if what it may do itself, whether or not it departs, and wherever it may
///    still stop at a gate, is clear of what everybody does by the plan, and its own way of what stands.
/// 3. It departs at the plan's start, if by then it knows that every member has acknowledged, and if it has
///    acknowledged no newer one. Of who has told where it has arrived, it is enough that its own way is clear
///    of that place. Otherwise, and if it looks at its clock too late, it stays where it is, for ever or
///    until another plan.
///    Of who is lost and has said so within the last turn, its own way has to be clear likewise; nobody who
///    was lost departs sooner than a turn after it is held again.
/// 4. It passes a gate only if it knows that the one who stood there has departed; or else it stops there,
///    and that is its anchor from then on.
/// Where there are several groups a member also keeps to the rules of `Rounds`, and its way off the places at
/// which vehicles of other groups are held and the ways by which they go.
///
/// Nothing here depends on when a word arrives, or whether. A value; nothing allocates or throws.
class Agreement {
 public:
  Agreement() = default;
  /// Of the vehicle of that number.
  Agreement(std::size_t vehicle, const Terms& terms) noexcept;

  /// Own ship is held at an anchor, to go to a destination. To be called once, before anything else. Where
  /// that is only `aside`, and not where its mission leads, it is held there once it has come there.
  void hold(const Member& member, bool aside = false) noexcept;

  /// A word that was `sent` [s] and has come in, to be heard once. What it says is believed if it was made by
  /// a member, and is not older than any word may be.
  Hearing hear(const Speech& speech, double sent, double now) noexcept;

  /// Acknowledges, proposes, departs and stops as the rules say. To be called at every decision, `period` [s]
  /// apart. `patience` is how many turns more than the least it gives acknowledgements to come in; `chart` is
  /// what stands, and `headway` what it wants of the plans that it proposes where nothing stands.
  void go_on(double now, double period, const Link& link, double patience, const Chart& chart = {},
             const Headway& headway = {}) noexcept;

  /// Goes on to the next round of the groups when it may (`Rounds`) and has nothing to do in this one. To be
  /// called at every decision. `is_free`: its mission would let it depart; `rests`: it is where it says.
  void take_turns(double now, double period, double turn_period, bool is_free, bool rests) noexcept;

  /// What stands, where vehicles of other groups are held, which is written to `room`, and who of them is on
  /// its way. Good until the next word is heard.
  Chart chart(std::span<const Obstacle> standing, std::array<Obstacle, most_vehicles>& room) const noexcept {
    return {standing, others_.places(room), others_.passing()};
  }

  /// Own ship is within its arrival of its destination, and stays at `place`, the end of its reference.
  void arrive(const Vec3& place) noexcept;

  /// Own ship is off what it promised, at `place`, and moves with `velocity` over ground. It takes part in
  /// nothing until it is held again.
  void lose(const Vec3& place, const Vec3& velocity) noexcept;

  /// Whether somebody who is lost comes too near to own ship by `time`, if that goes so.
  bool meets_lost(const Reference& own, double now, double time) const noexcept;
  /// Whether own ship, which is on its way `own`, comes too near by `time` to somebody who is held, as nobody
  /// does who only keeps to plans.
  bool meets_held(const Reference& own, double now, double time) const noexcept;

  /// Whether somebody comes too near to own ship by `time` who goes as it has promised, or may do so.
  bool meets_moving(const Reference& own, double now, double time) const noexcept;

  /// Where a member is at what time, as far as is known here; without knots if it is not. Who departs by the
  /// plan by which own ship did, and has not been heard since, is on its way.
  Reference whereabouts(std::size_t i) const noexcept;
  bool is_lost(std::size_t i) const { return statuses_[i] == Status::lost; }
  /// How far from there own ship goes out of its way [m]: of who is lost the farther, the longer ago it told
  /// where it is, up to half a minute.
  double evades_by(std::size_t i, double now) const noexcept;

  /// What to say in a turn at `now`.
  Speech say(double now, double turn_period) const noexcept;

  Status status() const { return status_; }
  /// Own reference; null while it is held.
  const Reference* way() const { return status_ == Status::moving ? &way_ : nullptr; }
  /// When it stops on its way, if nothing that it hears lets it go on before [s].
  double stops() const noexcept { return next_gate(); }
  /// By which own ship departs at the start of the newest plan if nothing comes between: without knots unless
  /// it has acknowledged that and its start is to come.
  Reference promised(double now) const noexcept;
  bool has_promised(double now) const noexcept {
    return is_pending(now) && acknowledged_epoch_ == plan_.epoch && plan_.participants[self_];
  }
  bool is_aside() const { return aside_; }  ///< it is to go, or has gone, elsewhere than its mission leads
  const Member& member(std::size_t i) const { return members_[i]; }
  const Member& own() const { return members_[self_]; }
  std::size_t vehicle() const { return vehicle_; }  ///< its number among all
  std::size_t self() const { return self_; }        ///< which member it is
  std::size_t count() const { return count_; }      ///< members of its group
  const Terms& terms() const { return terms_; }
  const Rounds& rounds() const { return others_.rounds; }
  const OtherGroups& others() const { return others_; }
  const Plan& plan() const { return plan_; }
  /// What it waits for, in a few words.
  std::string_view reason(double now) const noexcept;

 private:
  /// How a member departed.
  struct Gone {
    Epoch by{};
    Reference way;
    bool may_stop{false};  ///< at a gate
  };

  static constexpr double a_turn = 1.02;  ///< with what is rounded [turns]

  static constexpr std::array<double, most_members> not_yet() {
    std::array<double, most_members> times{};
    times.fill(-std::numeric_limits<double>::infinity());
    return times;
  }

  void learn(const Header& header) noexcept;
  void learn(const PlanWord& word) noexcept;
  void acknowledge(double now, double ahead, const Chart& chart) noexcept;
  void depart(double now, double turn_period, const Chart& chart) noexcept;
  void stop_at_gate(double now) noexcept;
  bool is_as_told() const noexcept;
  bool is_clear(const Chart& chart) noexcept;
  bool accepts_own(const Clearance& scene, const Reference& way, const Chart& chart) const noexcept;
  void propose(double now, double period, const Link& link, double patience, const Chart& chart,
               const Headway& headway) noexcept;
  bool is_known() const noexcept;
  bool may_propose(double now, double turn_period) const noexcept;
  void begin_search(double now, const Link& link, double patience, const Chart& chart,
                    const Headway& headway) noexcept;
  double settled_before(double patience, double turn_period) const noexcept;
  double slowest_turn() const noexcept;
  Epoch soonest_plan(const Link& link, double patience) const noexcept;
  Epoch start_beside_others(const Link& link, double patience, const Chart& chart) const noexcept;
  std::optional<Epoch> start_of_found(const Link& link, double patience, const Chart& chart) const noexcept;
  double clear_of(std::size_t i) const noexcept;
  void assume(double now, double turn_period) noexcept;
  Members unneeded(double now, double turn_period) const noexcept;
  Reference adrift(std::size_t i) const noexcept;
  Members held() const noexcept;
  std::array<Reference, most_members> ways_of_others() const noexcept;
  void learn_way_of(std::size_t other) noexcept;
  Clearance scene_of(const Plan& plan) const noexcept;
  double next_gate() const noexcept;
  bool is_alarm(std::size_t from, const StateWord& word) const noexcept;
  const Speech* passed_on(double now, double turn_period) const noexcept;
  const Speech* passed_on_in_turn(double now, double turn_period) const noexcept;
  Members everyone() const noexcept { return Members{(1U << count_) - 1U}; }
  bool is_ahead(std::size_t i) const noexcept;
  bool is_done_here(std::size_t i) const noexcept;
  bool was_left_out() const noexcept;
  bool is_group_busy(double now, double turn_period) const noexcept;
  bool is_pending(double now) const noexcept { return plan_.epoch && now < plan_.start(); }
  /// Whether it is held elsewhere than before, and has had no turn yet to tell where.
  bool is_news(double now, double turn_period) const noexcept { return now < held_since_ + turn_period; }

  Terms terms_{};
  std::size_t vehicle_{}, self_{};   ///< its numbers among all, and in its group
  std::size_t count_{most_members};  ///< members of its group
  Status status_{Status::held};
  bool aside_{false};  ///< its destination is not that of its mission

  // of other groups, and of the round
  OtherGroups others_{};
  double entered_ = -std::numeric_limits<double>::infinity();  ///< when it came to this round [s]
  double used_ = -std::numeric_limits<double>::infinity();     ///< until when the round was of use [s]
  bool found_none_{false};                                     ///< it has found no way in this round

  // of everybody
  std::array<Member, most_members> members_{};
  Members known_{};                                          ///< whose states have been heard
  std::array<Status, most_members> statuses_{};              ///< as last heard
  Members settled_{};                                        ///< who have told where they have arrived
  std::array<Gone, most_members> gone_{};                    ///< by which way each departed last
  std::array<double, most_members> last_heard_ = not_yet();  ///< when what was heard last was said [s]
  std::array<Members, most_members> heard_by_{};             ///< whose states each of them has
  std::array<double, most_members> known_since_{};           ///< when its first state was heard [s]
  std::array<Said, most_members> said_{};                    ///< the last state that each told
  std::array<double, most_members> alarmed_ = not_yet();     ///< when its last alarm was heard [s]

  // the newest plan
  Plan plan_{};
  Members acknowledged_{};
  Members departed_{};
  Epoch newest_epoch_{};        ///< that anybody has spoken of
  Epoch acknowledged_epoch_{};  ///< the newest that own ship has acknowledged
  Epoch refused_epoch_{};       ///< the newest that it has looked at and not acknowledged
  Epoch judged_epoch_{};        ///< the newest whose start it has seen
  int attempts_{};              ///< plans that came to nothing
  int plans_{};                 ///< that it has known in this round

  // own way
  Reference way_{};
  Plan departed_by_{};                        ///< the plan by which it goes, or went last
  std::array<double, most_members> gates_{};  ///< by whom it has to know departed [s]
  Members left_{};                            ///< who is known to have left the anchor that a gate is about

  // a search under way
  std::size_t searches_{0};  ///< that own ship has made; every other one has the centre of the first
  std::optional<Search> search_;
  double search_began_{};                                     ///< [s]
  double looked_ = -std::numeric_limits<double>::infinity();  ///< when it was last asked to go on [s]
  double held_since_ =
      -std::numeric_limits<double>::infinity();  ///< where it is [s]; -infinity: since it began
};

}  // namespace fairway::pledge
