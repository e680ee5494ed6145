// SPDX-License-Identifier: Apache-2.0
// C++17. What the node of a simulated fleet does, whatever its middleware.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ros/bridge/fleet_host.hpp"
#include "ros/bridge/node_settings.hpp"

namespace fairway::bridge {

/// Where a fleet is shown: a middleware's publishers, and what arrives by it.
class FleetOutlet {
 public:
  virtual ~FleetOutlet() = default;
  virtual void show_clock(double time) = 0;
  /// Where `vehicle` goes from now on [m, NED].
  virtual void show_goal(std::size_t vehicle, const Triple& goal, double time) = 0;
  /// Returns when those who listen have the goals: they are to be known before the odometry of the instant.
  virtual void deliver_goals() = 0;
  virtual void show_navigation() = 0;  ///< everyone's odometry
  virtual void show_truth() = 0;       ///< everyone's true odometry and transforms
  virtual void show_state(const std::string& json) = 0;
  virtual void show_picture() = 0;
  /// Listeners of `vehicle`'s odometry, and whether somebody may command it.
  virtual std::size_t listeners(std::size_t vehicle) = 0;
  virtual bool is_steered(std::size_t vehicle) = 0;
  /// Waits for what arrives, no longer than this [s], and handles it.
  virtual void handle(double longest) = 0;
  virtual bool goes_on() = 0;  ///< false: the program is to end
  virtual void warn(const std::string& words) = 0;
};

/// A scenario as a live fleet: shows each instant, takes commands, and goes on with the wall clock, as fast
/// as it can, or in lockstep when everyone has answered.
class FleetDuty {
 public:
  /// Throws std::runtime_error, in one line, for a scenario that cannot be used.
  explicit FleetDuty(FleetNodeSettings settings);

  const FleetHost& fleet() const { return fleet_; }
  const FleetNodeSettings& settings() const { return settings_; }

  /// A command for `vehicle`, stamped with the time of the navigation that it answers [ns]; a stamp of 0 is
  /// of now, unless in lockstep.
  void command(std::size_t vehicle, const BodyVelocity& velocity, std::int64_t stamp);

  bool pause();
  bool resume();     ///< false: the run is over
  bool step_once();  ///< false: it is over, or not paused

  /// Until the run is done, if it is to end with it, or until the outlet ends it. The exit code of the
  /// program: 0 if all that the scenario expects is so, 1 if not, 130 if it was interrupted before its end.
  int run(FleetOutlet& outlet);

 private:
  using Steady = std::chrono::steady_clock;
  struct Port {
    std::optional<Triple> shown_goal;      // [m, NED]
    std::optional<std::int64_t> answered;  // stamp of the command last taken [ns]
  };

  void await_listeners();
  void show_instant();
  bool show_goals();
  void await_permission();
  void await_commands();
  void await_clock();
  bool has_answered(std::size_t vehicle) const;
  bool all_answered() const;
  std::string missing() const;
  void spin(double seconds);
  void tend();
  /// Wall time that it could not keep up with, what it may yet make up for included [s].
  double behind() const;
  std::string state_json() const;

  FleetNodeSettings settings_;
  FleetHost fleet_;
  FleetOutlet* outlet_{};
  std::vector<Port> ports_;   // by vehicle
  std::int64_t now_{};        // stamp of the instant [ns]
  std::string shown_;         // what of the state is reported at once when it changes
  Steady::time_point begin_;  // of the run, on the wall
  Steady::time_point anchor_{Steady::time_point::max()};  // where its clock began, or began anew
  double anchor_time_{};                                  // of the run, at anchor_ [s]
  double behind_s_{};                                     // wall time that is not made up for
  Steady::time_point tended_, drawn_;
  std::uint64_t missed_{};    // instants of lockstep that went on without a command
  std::uint64_t refused_{};   // commands that were not finite, or of another time
  std::uint64_t repeated_{};  // instants of lockstep that were shown again
  std::uint64_t steps_{};     // to be made though it is paused
  bool paused_{};
};

}  // namespace fairway::bridge
