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
  bool autonomous{false};         ///< the scenario's own avoiders steer, and commands are not taken
};

/// Who is near a vehicle, as the metric counts it: the colour of its spheres.
enum class Alert : std::uint8_t {
  clear,     ///< nobody within crit_dist, or it is not under way: green
  detected,  ///< somebody is: orange
  collided,  ///< somebody was within safety_distance and has not left crit_dist since: red
};

/// A vehicle of the fleet.
struct FleetVehicle {
  std::string name;
  std::string topic;  ///< the name as topics and frames have it: as in a recording
  std::string shape;  ///< auv, torpedo, rov, catamaran, transport, or point for a kinematic vehicle
  double length_m{};
  double beam_m{};
  Motion truth;                  ///< where it is
  Motion estimate;               ///< where it believes to be: what it publishes
  std::string phase;             ///< deploying, waiting, under_way, stuck, arrived
  std::optional<Triple> goal_n;  ///< of a transit under way [m, NED]
  bool wants_command{};          ///< it is under way: somebody must steer it
  bool holding{};                ///< under way without a command: it holds
  Alert alert{Alert::clear};
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
  double time() const;         ///< of the instant that is seen [s]
  double duration() const;     ///< [s]
  bool is_done() const;        ///< the run of the command would have ended before this instant
  std::string name() const;

  double crit_dist_m() const;        ///< diameter of the detection spheres to draw
  double safety_distance_m() const;  ///< likewise of the safety spheres

  /// As it is now, before it moves.
  const FleetVehicle& vehicle(std::size_t index) const;
  /// Told at time() and carried out from now on, until the timeout. False, and nothing changes, for a vehicle
  /// that is not under way, for what is not finite, and in an autonomous fleet.
  bool command(std::size_t index, const BodyVelocity& over_ground);
  /// Moves everything by a step, and looks again. Throws std::runtime_error if it cannot be recorded.
  void step();

  /// What stands or drifts in the water, to draw. Walls reach from the surface down to below every vehicle's
  /// mission.
  std::vector<Mark> obstacles() const;
  /// How it went, as `fairway run --json` prints it; the measures so far.
  std::string summary_json() const;
  /// The same as `fairway run` prints it, with the time [s] that it took.
  std::string summary(double wall_s) const;
  /// Pairs that came within the safety distance of each other so far.
  int collisions() const;
  /// Whether all that the scenario expects is so, as of now.
  bool expectations_kept() const;
  /// Completes the recording. Throws std::runtime_error if that fails.
  void finish();

 private:
  struct Self;
  std::unique_ptr<Self> self_;
};

}  // namespace fairway::bridge
