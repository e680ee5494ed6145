// SPDX-License-Identifier: Apache-2.0
// C++17: included by ROS nodes, whose message headers are not C++20.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ros/bridge/plain.hpp"

namespace fairway::bridge {

/// How an avoider is set up: a vehicle of a scenario file, or everything by settings; settings win.
struct AvoiderOptions {
  std::string scenario;  ///< file, or empty
  std::string vehicle;   ///< of the scenario, or the name of a vehicle that is set up by settings
  /// `algorithm`, `radius_m`, `priority`, `period_s`, `arrival_m`, `max_speed_mps` and the other limits,
  /// `params.NAME`, `model`, `model.NAME`, `steering`, `steering.NAME`, `envelope.NAME`, `policy.NAME`,
  /// `team` ("auv_2 auv_3"), `team.NAME.radius_m`, `team.NAME.priority`; all of them in words on
  /// docs/onboard.md.
  Settings settings;
  std::optional<std::uint64_t> seed;      ///< the scenario's own, or 1, unless given
  std::vector<std::string> also_known{};  ///< settings that the program takes itself: for suggestions
  bool wall_clock{false};                 ///< its time is the world's, and no simulation's
};

/// What a vehicle shall do, in plain words.
struct Order {
  double time{};
  bool in_charge{};
  bool decided{};
  BodyVelocity request;
  Triple velocity_n{};  ///< what the avoider wants, over ground [m/s, NED]
  std::string mode;     ///< cruise, avoid, hold, infeasible
  std::string state;    ///< HelmState
  std::string reason;
};

/// One line of diagnostics.
struct Diagnosis {
  enum class Level { ok, warning, error, stale };
  Level level{Level::ok};
  std::string summary;
  std::vector<std::pair<std::string, std::string>> values;
};

/// The helm of one vehicle for a program that cannot include C++20. Throws std::runtime_error, with what is
/// wrong and the nearest valid name, on construction only.
class AvoiderHost {
 public:
  explicit AvoiderHost(const AvoiderOptions& options);
  AvoiderHost(AvoiderHost&&) noexcept;
  AvoiderHost& operator=(AvoiderHost&&) noexcept;
  ~AvoiderHost();

  const std::vector<std::string>& team() const;  ///< names of the others
  double period() const;                         ///< between decisions [s]
  double watchdog_period() const;                ///< [s]
  std::string algorithm() const;
  bool speaks() const;  ///< whether its method may

  // as of Helm; the verdict's name comes back
  const char* own_motion(const Motion& motion, double now);
  const char* neighbour_motion(std::size_t mate, const Motion& motion, double now);
  void neighbour_goal(std::size_t mate, const std::optional<Triple>& goal);
  const char* team_record(const std::uint8_t* bytes, std::size_t size, double now);
  bool speech(std::size_t mate, const std::uint8_t* bytes, std::size_t size, double now);
  void turns(double next, double period);

  bool go_to(const Triple& position_n, double speed_mps);
  bool follow(const Triple& from_n, const Triple& to_n, double speed_mps);
  /// Along all these points, one after the other, avoiding. [m, NED]
  bool follow_path(const std::vector<Triple>& points_n, double speed_mps);
  void keep_position();
  void stand_by();

  /// Whether everyone's motion of `time` is there: for a simulation that waits for its fleet.
  bool is_complete(double time) const;
  const Order& update(double now, bool draw = false);
  const Order& order() const;
  /// Empty before the first motion, and where it is too far to tell.
  std::vector<std::uint8_t> own_record(double now) const;
  bool is_too_far_to_tell() const;               ///< from the origin of the frame, for a team record
  std::vector<std::uint8_t> own_speech() const;  ///< empty unless its method has something to say instead
  Diagnosis diagnosis(double now) const;
  std::vector<Mark> marks() const;  ///< what the last decision drew; empty unless `draw`
  /// Where it goes; none while it goes nowhere. [m, NED]
  std::optional<Triple> goal() const;

 private:
  struct Self;
  std::unique_ptr<Self> self_;
};

}  // namespace fairway::bridge
