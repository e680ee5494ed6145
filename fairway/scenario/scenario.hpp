// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "fairway/core/error.hpp"
#include "fairway/core/leg.hpp"
#include "fairway/core/limits.hpp"
#include "fairway/core/params.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/shared.hpp"
#include "fairway/core/state.hpp"
#include "fairway/scenario/water_spec.hpp"

namespace fairway {

/// Something chosen by name with parameters of its own: a vehicle model, an algorithm, a steering law.
/// Its catalog checks the parameters; `where` lets the error point at the line.
struct Choice {
  std::string name;
  ParamValues params;
  std::string path;                   ///< "vehicles[1].avoider"
  Location where;                     ///< of the name; of the file if built by a program
  std::vector<Location> param_where;  ///< of each parameter; may be empty
};

/// How what a method answers becomes what a vehicle is asked for.
enum class Tracking : std::uint8_t {
  automatic,  ///< as `trackable` where the vehicle cannot go sideways, unless the method follows by itself,
              ///< and `way_round` besides where something stands, unless the method finds its way by itself
  raw,        ///< as printed: the steering makes of the answer what it can
  trackable,  ///< the wrapper `trackable` on any vehicle
};

template <>
struct EnumNames<Tracking> {
  static constexpr std::array names{"auto", "raw", "trackable"};
};

/// What breaks on board of a vehicle that has set out.
enum class FailureKind : std::uint8_t {
  none,
  silent,  ///< it tells nobody anything any more, and knows nothing of that
  stops,   ///< its actuators get nothing any more
  leaves,  ///< it goes on as it went, whatever its method commands
};

template <>
struct EnumNames<FailureKind> {
  static constexpr std::array names{"none", "silent", "stops", "leaves"};
};

struct FailureSpec {
  FailureKind kind{};
  double under_way_s{};  ///< so long after it set out on its first transit

  friend bool operator==(const FailureSpec&, const FailureSpec&) = default;
};

/// An obstacle that owns its vertices. A sphere may drift: then it is perceived as a track, not as an
/// obstacle.
struct ObstacleSpec {
  Obstacle::Kind kind{};
  bool charted{true};            ///< known to everyone beforehand
  Vec3 velocity = Vec3::Zero();  ///< of a sphere that drifts [m/s, NED]
  Vec3 position = Vec3::Zero();
  double radius{};
  Vec3 from = Vec3::Zero();
  Vec3 to = Vec3::Zero();
  std::vector<Vec3> vertices;

  /// Valid while this lives and its vertices stay.
  Obstacle view() const { return {kind, position, radius, from, to, vertices, charted}; }
  bool moves() const { return !velocity.isZero(0.0); }
};

/// Where a vehicle's own things are written; of the file if built by a program.
struct VehiclePlaces {
  Location start;  ///< its position
  Location limits;
  std::vector<Location> mission;  ///< of each leg; may be empty
};

/// One vehicle, with everything that is its own. What it was copied with it has in common with the original
/// until it differs.
struct VehicleSpec {
  std::uint32_t id{};
  std::string name;
  Shared<Choice> model;              ///< of the vehicle catalog
  Shared<Choice> avoider;            ///< of the avoidance catalog
  Tracking tracking{Tracking::raw};  ///< a file that does not say it means `automatic`
  Shared<Choice> steering;    ///< how a velocity becomes a body request; name empty = the model's usual one
  Shared<Choice> allocation;  ///< how commanded forces are shared out among the thrusters; likewise bounded
  Shared<Choice> autopilot;   ///< what drives the thrusters to a velocity; likewise velocity_controller
  Vec3 position = Vec3::Zero();  ///< at the start [m, NED]
  double yaw{};                  ///< at the start [rad]
  double speed{};                ///< surge at the start [m/s]
  double start_delay_s{};        ///< before the mission begins
  double radius_m{1.0};          ///< of the sphere that others keep clear of
  std::int32_t priority{};       ///< the smaller number has the right of way; the id unless given
  bool cooperative{true};        ///< false: it tells nobody anything, and nobody may count on it to give way
  FailureSpec failure;
  Limits limits;
  std::vector<Leg> mission;
  Shared<VehiclePlaces> where;
};

/// How encounters are counted.
struct Exam {
  double crit_dist_m{6.0};              ///< a neighbour this near is detected
  double safety_distance_m{3.0};        ///< centres this near have collided
  double time_coefficient_ratio{10.0};  ///< stuck after this many times the straight-line time
  double progress_window_s{30.0};       ///< no progress for so long is a matter of its own
};

/// What a vehicle makes of what is round it.
struct PerceptionSpec {
  Choice kind{.name = "perfect"};
  double range_m{std::numeric_limits<double>::infinity()};
  double obstacle_range_m{std::numeric_limits<double>::infinity()};  ///< for what is not charted
};

/// A bound on a metric that a run must keep: `collision_count: 0`, `makespan_s: {max: 120}`.
struct Expectation {
  std::string metric;
  double min{-std::numeric_limits<double>::infinity()};
  double max{std::numeric_limits<double>::infinity()};
  Location where;
};

/// One concrete case: plain data, no distributions left, nothing to look up in a file.
struct Scenario {
  std::string name;
  std::string summary;
  double step_s{0.05};                 ///< the control period and the integration step
  std::int32_t steps_per_decision{1};  ///< avoiders decide at every so many steps
  double duration_s{600.0};            ///< the run ends here at the latest
  std::uint64_t seed{1};
  WaterSpec water;
  bool coincident_start{false};  ///< vehicles may start at one place, as in a deployment from one point
  bool stop_when_done{true};     ///< end when everyone has arrived or is stuck
  Exam exam;
  PerceptionSpec perception;
  Choice exchange{.name = "perfect", .path = "exchange"};      ///< what vehicles tell each other, and when
  Choice navigation{.name = "perfect", .path = "navigation"};  ///< how well a vehicle knows where it is
  std::vector<ObstacleSpec> obstacles;
  std::vector<VehicleSpec> vehicles;
  std::vector<Expectation> expect;
  Location step_where;  ///< of `step_s`; empty if it is not written
};

}  // namespace fairway
