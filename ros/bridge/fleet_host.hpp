// SPDX-License-Identifier: Apache-2.0
// C++17: included by ROS nodes, whose message headers are not C++20.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/plain.hpp"

namespace fairway::bridge {

struct FleetOptions {
  std::string scenario;
  Settings overrides;  ///< as of `fairway run --set`
  std::optional<std::uint64_t> seed;
  double command_timeout_s{0.5};  ///< a vehicle that is not told anything for so long holds
  std::string record;             ///< recording to write, or empty
};

/// A vehicle of the fleet.
struct FleetVehicle {
  std::string name;
  double radius_m{};
  Motion truth;                  ///< where it is
  Motion estimate;               ///< where it believes to be: what it publishes
  std::string phase;             ///< deploying, waiting, under_way, stuck, arrived
  std::optional<Triple> goal_n;  ///< of a transit under way [m, NED]
  double goal_speed_mps{};
  bool wants_command{};  ///< it is under way: somebody must steer it
  bool holding{};        ///< under way without a command: it holds
};

/// A scenario whose vehicles are steered from outside while under way. Legs without avoidance, the way to a
/// rendezvous and the hold at the end are the vehicles' own, as in a run of the command. Throws
/// std::runtime_error for what the scenario or the overrides have wrong.
class FleetHost {
 public:
  explicit FleetHost(const FleetOptions& options);
  FleetHost(FleetHost&&) noexcept;
  FleetHost& operator=(FleetHost&&) noexcept;
  ~FleetHost();

  std::size_t size() const;
  double step_period() const;  ///< [s]
  std::int64_t steps_per_decision() const;
  double time() const;      ///< of the instant that is seen [s]
  double duration() const;  ///< [s]
  bool is_done() const;
  std::string name() const;

  double crit_dist_m() const;        ///< of the spheres to draw
  double safety_distance_m() const;  ///< likewise

  /// As it is now, before it moves.
  const FleetVehicle& vehicle(std::size_t index) const;
  /// Told at time() and carried out from now on, until the timeout.
  void command(std::size_t index, const BodyVelocity& over_ground);
  /// Moves everything by a step, and looks again.
  void step();

  /// What stands in the water, to draw.
  std::vector<Mark> obstacles() const;
  /// How it went, as `fairway run --json` prints it; the measures so far.
  std::string summary_json() const;
  /// Completes the recording.
  void finish();

 private:
  struct Self;
  std::unique_ptr<Self> self_;
};

}  // namespace fairway::bridge
