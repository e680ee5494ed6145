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
#include "fairway/comms/team_record.hpp"
#include "fairway/control/body_request.hpp"
#include "fairway/control/guidance.hpp"
#include "fairway/control/steering.hpp"
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
};

/// A helm's constants.
struct HelmSetup {
  VehicleId id{};
  std::string name;
  double radius{1.0};  ///< [m]
  std::int32_t priority{};
  double period{0.05};         ///< between decisions [s]
  double record_period{0.05};  ///< of the ticks that team records are stamped with [s]
  double arrival{1.0};         ///< arrived when this near to the goal [m]
  Limits limits;
  SteeringParams steering;
  std::optional<OnboardModel> model;
  std::vector<Obstacle> chart;  ///< obstacles known beforehand; their vertices must outlive the helm
  std::vector<TeamMate> team;
  OnboardPolicy policy;
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
  BodyRequest request;  ///< over ground
  Command command;      ///< that the request carries out
  HelmState state{HelmState::waiting};
  std::string_view
      reason;  ///< of `holding` and `handed_back`, in words. Text that outlives the program's run.
};

/// What a helm has seen and done, to report.
struct HelmReport {
  HelmOrder order;
  double own_age{};  ///< [s]
  FixVerdict own_verdict{};
  std::array<std::int64_t, EnumNames<FixVerdict>::names.size()> own_counts{};
  std::int64_t decisions{};
  std::int64_t infeasible{};
  struct Neighbour {
    const TeamMate* mate{};
    double age{std::numeric_limits<double>::infinity()};       ///< [s]
    double distance{std::numeric_limits<double>::infinity()};  ///< between centres, as predicted [m]
    double growth{};                                           ///< of its sphere [m]
    bool stale{}, lost{};
    FixVerdict verdict{};
    std::array<std::int64_t, EnumNames<FixVerdict>::names.size()> counts{};
  };
  std::vector<Neighbour> neighbours;  ///< as in `HelmSetup::team`
};

/// An avoider as it runs on board: told of fixes and goals as they come, asked for an order again and again.
/// It judges what it is told (`OnboardPolicy`), predicts what is late, and steers. It reads no clock: `now`
/// [s] must not run backwards by itself, and if it does, because a simulation has begun again, everything
/// heard is forgotten. A value; nothing throws, allocates or locks after construction, unless its
/// method does.
class Helm {
 public:
  Helm(HelmSetup setup, Avoider avoider);

  // what it is told

  FixVerdict own_fix(const Fix& fix, double now) noexcept;
  /// Of a vehicle that is not of the team: ignored.
  FixVerdict neighbour_fix(VehicleId id, const Fix& fix, double now) noexcept;
  /// Where a neighbour says that it is going [m, NED]; none: nowhere.
  void neighbour_goal(VehicleId id, const std::optional<Vec3>& goal) noexcept;
  /// A neighbour's own words; its radius and priority replace those of the setup. `invalid` for a length that
  /// is not a record's or a sender that is not of the team.
  FixVerdict team_record(std::span<const std::uint8_t> bytes, double now) noexcept;

  // what it shall do

  /// To `position` [m, NED] at `speed` [m/s], avoiding. Not usable values are refused with false.
  bool go_to(const Vec3& position, double speed) noexcept;
  /// Along the line to `leg.position`, avoiding; `leg.kind` is section.
  bool follow(const Leg& leg) noexcept;
  /// Hold here.
  void keep_position() noexcept;
  /// Nothing: leave the vehicle to others.
  void stand_by() noexcept;

  /// The order for `now`. Asks the avoider when a decision is due, steers always. O(what deciding costs).
  const HelmOrder& update(double now, Sketch* sketch = nullptr) noexcept;

  const HelmOrder& order() const { return order_; }
  const HelmSetup& setup() const { return setup_; }
  const AlgorithmInfo& algorithm() const { return avoider_.info(); }
  /// The next decision [s].
  double next_decision() const { return next_decision_; }
  /// The time of the oldest last fix of own vehicle and all team mates [s]; minus infinity while one is
  /// missing: to wait for everyone's fix of one instant.
  double common_time() const noexcept;
  /// What this vehicle tells the team now; nothing before its first fix.
  std::optional<TeamRecord> own_record(double now) const noexcept;
  /// Allocates: for reporting, now and then.
  HelmReport report(double now) const;

 private:
  struct Neighbour;
  // implementation below the line is the implementer's

  HelmSetup setup_;
  Avoider avoider_;
  double next_decision_{};
  HelmOrder order_;
};

}  // namespace fairway
