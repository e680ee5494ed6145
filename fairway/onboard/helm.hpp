// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/progress.hpp"
#include "fairway/comms/team_record.hpp"
#include "fairway/control/pilot.hpp"
#include "fairway/onboard/fix.hpp"
#include "fairway/onboard/fix_watch.hpp"
#include "fairway/onboard/policy.hpp"

namespace fairway {

/// Another vehicle of the team, as known before it is heard.
struct TeamMate {
  VehicleId id{};
  std::string name;
  double radius{1.0};       ///< of the sphere to keep clear of [m]
  std::int32_t priority{};  ///< the smaller number has the right of way
  bool reacts{true};        ///< whether it can be counted on to give way
  double arrival{};  ///< it has arrived when this near to the goal that it told [m]; 0: it says so itself
};

/// A helm's constants, besides those of its pilot.
struct HelmSetup {
  double record_period{0.05};  ///< of the ticks that team records are stamped with [s]
  double arrival{1.0};         ///< arrived when this near to the goal [m]
  double range{std::numeric_limits<double>::infinity()};  ///< neighbours beyond it are left out [m]
  std::vector<Obstacle> chart;  ///< obstacles known beforehand; their vertices must outlive the helm
  std::vector<TeamMate> team;
  OnboardPolicy policy;
  /// Whether the clock is the world's, which is set right now and then, and not a simulation's.
  bool wall_clock{false};
};

/// What a helm is about.
enum class HelmState : std::uint8_t {
  waiting,      ///< no own navigation yet
  idle,         ///< nothing to do: the vehicle is left to others
  under_way,    ///< going to its goal, avoiding
  arrived,      ///< at its goal, holding there
  keeping,      ///< holding because it was told to
  holding,      ///< holding because of its data: `HelmOrder::reason` says which
  handed_back,  ///< own navigation is lost: it has let go of the vehicle
};

template <>
struct EnumNames<HelmState> {
  static constexpr std::array names{"waiting", "idle",    "under_way",  "arrived",
                                    "keeping", "holding", "handed_back"};
};

/// What the vehicle shall do now.
struct HelmOrder {
  double time{};        ///< [s]
  bool in_charge{};     ///< false: there is nothing to send; the vehicle is left to others
  bool decided{};       ///< the avoider was asked in this update
  BodyRequest request;  ///< over ground, or through the water for a vehicle that cannot stop (`crab`)
  Command command;      ///< that the request carries out
  HelmState state{HelmState::waiting};
  std::string_view
      reason;  ///< of `holding` and `handed_back`, in words. Text that outlives the program's run.

  /// How it gets on, as of the last decision, by where it and the team are taken to be; `with` is whose
  /// number the track has. While it is not under way it is `holding`.
  ProgressReport progress;
};

/// What a helm has seen and done, to report.
struct HelmReport {
  HelmOrder order;
  double own_age{};  ///< [s]
  FixVerdict own_verdict{};
  double own_position_sigma{};  ///< of the last fix that was believed; 0: it stated none [m]
  std::array<std::int64_t, EnumNames<FixVerdict>::names.size()> own_counts{};
  std::int64_t decisions{};
  std::int64_t infeasible{};
  std::int64_t clock_restarts{};
  std::int64_t records_refused{};  ///< no team records, or of nobody of the team
  double refused_at{};             ///< the last fix of anyone [s]; minus infinity if none was
  struct Neighbour {
    const TeamMate* mate{};
    double age{std::numeric_limits<double>::infinity()};       ///< [s]
    double distance{std::numeric_limits<double>::infinity()};  ///< between centres, as predicted [m]
    double growth{};                                           ///< of its sphere [m]
    bool heard{}, stale{}, lost{}, shown{};                    ///< shown to the method at the last decision
    FixVerdict verdict{};
    std::array<std::int64_t, EnumNames<FixVerdict>::names.size()> counts{};
  };
  std::vector<Neighbour> neighbours;  ///< as in `HelmSetup::team`
};

/// An avoider as it runs on board: told of fixes and goals as they come, asked for an order again and again.
/// It judges what it is told (`OnboardPolicy`), predicts what is late, and steers. It reads no clock: `now`
/// [s] must not run backwards by itself, and if it does by more than `max_ahead_s`, because a simulation has
/// begun again, everything heard is forgotten, goals included, and the method begins afresh (which copies it,
/// and so allocates). A wall clock that is set back makes it forget likewise, but for its own goal: it holds
/// until own navigation has been good for `recovery_s` by the new time, and goes on. By a clock that runs
/// back, or says no time, nothing grows old: after ten such updates the vehicle holds, and likewise once own
/// fixes have gained `own_stale_s` on a clock that stands. A value: a copy is a snapshot. Otherwise
/// nothing throws, allocates or locks after construction, unless the method does.
class Helm {
 public:
  /// Throws InputError for a parameter of steering or policy outside its range.
  Helm(Pilot pilot, HelmSetup setup, Avoider avoider);

  // what it is told

  FixVerdict own_fix(const Fix& fix, double now) noexcept;
  /// A fix of a vehicle that is not of the team is `invalid`, and is not counted.
  FixVerdict neighbour_fix(VehicleId id, const Fix& fix, double now) noexcept;
  /// Where a neighbour says that it is going [m, NED]; none: nowhere. What is not a position is nowhere.
  void neighbour_goal(VehicleId id, const std::optional<Vec3>& goal) noexcept;
  /// A neighbour's own words; its radius, priority and goal replace what was known, but for a radius of the
  /// most that a record can tell, which may be larger. `invalid` for a length that is not a record's, a
  /// sender that is not of the team, or a place at the end of what a record can tell.
  FixVerdict team_record(std::span<const std::uint8_t> bytes, double now) noexcept;
  /// What the method of a neighbour said at `sent` [s], for a method that speaks. False for somebody who is
  /// not of the team, for more bytes than a speech has, and for a time that is more than `max_ahead_s` ahead
  /// of the clock.
  bool speech(VehicleId from, std::span<const std::uint8_t> bytes, double sent, double now) noexcept;
  /// When this vehicle's next turn to speak begins and how far apart its turns are [s].
  void turns(double next, double period) noexcept;

  // what it shall do

  /// To `position` [m, NED] at `speed` [m/s], avoiding. False, and nothing changes, for what is not a
  /// position, a speed that is not positive, or a depth farther outside the limits than arrival reaches.
  bool go_to(const Vec3& position, double speed) noexcept;
  /// Along the line from `leg.from` to `leg.position`, avoiding, until within `leg.arrival_m` of its end.
  /// Refused likewise, and if the line has no length.
  bool follow(const Leg& leg) noexcept;
  /// Hold here. A method that speaks is asked on, so that the others hear that it has stopped.
  void keep_position() noexcept;
  /// Nothing: leave the vehicle to others. Its method falls silent: the others of a method that speaks go on
  /// as was agreed.
  void stand_by() noexcept;

  /// The order for `now`. Asks the avoider when a decision is due, which is at the update nearest to the
  /// pilot's period after the last one; steers always. O(what deciding costs + team log team).
  const HelmOrder& update(double now, Sketch* sketch = nullptr) noexcept;

  const HelmOrder& order() const { return order_; }
  const Pilot& pilot() const { return pilot_; }
  const HelmSetup& setup() const { return setup_; }
  const AlgorithmInfo& algorithm() const { return avoider_.info(); }
  /// Whether its method may say something of its own.
  bool speaks() const { return avoider_.speaks(); }
  /// Where it goes [m, NED]; none while it goes nowhere.
  std::optional<Vec3> goal() const noexcept;
  /// Where it was taken to be at the last update [m, NED].
  const Ownship& own() const { return own_; }
  /// The time of the oldest last fix of own vehicle and all team mates [s]; minus infinity while one is
  /// missing: to wait for everyone's fix of one instant.
  double common_time() const noexcept;
  /// What this vehicle tells the team: its last fix, stamped with that fix's time. Nothing before the first
  /// one, and nothing of one that is lost by now, or at a place that a record cannot tell.
  std::optional<TeamRecord> own_record(double now) const noexcept;
  /// What its method says in this vehicle's turn, instead of that; empty unless the method speaks and was
  /// asked at the last update.
  Speech own_speech() const noexcept;
  /// Allocates: for reporting, now and then.
  HelmReport report(double now) const;

 private:
  enum class Task : std::uint8_t { none, go, keep };
  enum class Health : std::uint8_t { good, stale, lost };

  struct Neighbour {
    FixWatch watch;
    std::optional<Vec3> goal;
    double radius{};
    std::int32_t priority{};
    std::optional<Vec3> arrived_at;  ///< the goal that it had come to, and has not left since [m, NED]
    bool shown{};
    Trail trail;  ///< as predicted
  };

  struct Near {
    double distance2;
    VehicleId id;
    std::size_t index;  ///< of the team
  };

  void see_clock(double now) noexcept;
  void begin_again() noexcept;
  void forget_what_was_heard() noexcept;
  std::optional<std::size_t> index_of(std::uint32_t id, std::uint32_t modulus) const noexcept;
  FixVerdict see_neighbour(std::size_t index, const Fix& fix) noexcept;
  void see_arrival_of(std::size_t index) noexcept;
  void see_departure_of(std::size_t index) noexcept;
  bool set_out(const Leg& leg) noexcept;
  void see_current(const Fix& fix) noexcept;
  void see_lead(const Fix& fix, FixVerdict verdict) noexcept;

  void see_health() noexcept;
  void see_arrival() noexcept;
  Ownship own_at(const Fix& fix) const noexcept;
  bool is_lost(const Neighbour& neighbour) const noexcept;
  double growth_of(double age) const noexcept;
  Track track_of(std::size_t index) const noexcept;
  void look_round() noexcept;
  bool is_due() const noexcept;
  void decide(Sketch* sketch) noexcept;
  void see_progress(const Situation& situation) noexcept;
  void stop_watching_progress() noexcept;
  void lead_back(Command& command) const noexcept;
  bool is_blind() const noexcept;
  bool is_outrun() const noexcept;
  bool has_clock() const noexcept;
  std::string_view why_stale() const noexcept;
  bool waits_for_neighbour() const noexcept;
  void let_go(HelmState state, std::string_view reason = {}) noexcept;
  void hold_because(HelmState state, std::string_view reason = {},
                    const Command& how = {.mode = Mode::hold}) noexcept;
  Command how_to_stay(Attendance attendance) noexcept;
  void show_link(Situation& situation) noexcept;
  Ownship within_depths() const noexcept;
  const Limits& limits() const noexcept { return pilot_.ship().limits; }

  Pilot pilot_;
  HelmSetup setup_;
  Avoider avoider_;
  Avoider fresh_;  ///< as it was before its first decision
  FixWatch own_watch_;
  std::vector<Neighbour> neighbours_;  ///< as in `HelmSetup::team`
  std::vector<Near> near_;
  std::vector<Track> tracks_;
  std::vector<Bystander> bystanders_;
  std::vector<Heard> heard_;  ///< by vehicle; room for all
  Link link_;
  double next_turn_{};       // [s]
  double turn_period_{1.0};  // [s]
  ProgressWatch progress_watch_;

  Leg leg_;
  Ownship own_;
  Vec3 current_ = Vec3::Zero();         ///< as own fixes tell it [m/s, NED]
  std::optional<double> current_time_;  ///< of the last fix that told it [s]
  ProgressReport progress_;
  double now_{-std::numeric_limits<double>::infinity()};
  double updated_{-std::numeric_limits<double>::infinity()};  ///< when it was asked before this [s]
  std::int64_t decisions_{};
  std::int64_t infeasible_{};
  std::int64_t clock_restarts_{};
  std::int64_t records_refused_{};
  HelmOrder order_;
  int standing_{};                    ///< updates by a time that was past, or none
  bool set_back_{};                   ///< a wall clock was, and no own fix has been accepted since
  std::optional<double> ahead_from_;  ///< by how much the first of own fixes that are `ahead` was [s]
  double ahead_by_{};                 ///< by how much the last of them was [s]
  Task task_{Task::none};
  Health health_{Health::good};
  bool arrived_{};
};

}  // namespace fairway
