// SPDX-License-Identifier: Apache-2.0
// Collision avoidance for a program that does not compile C++20: this header is C++17 and includes nothing
// but the standard library. Its types mirror those of fairway/avoidance in plain numbers, so that C or
// another language is easily put around them.
//
// Positions and velocities are in local NED (north, east, down), bodies forward, starboard, down, angles in
// radians, all in SI.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fairway::embed {

using Triple = std::array<double, 3>;   ///< north, east, down
using SixAxes = std::array<double, 6>;  ///< surge, sway, heave, roll, pitch, yaw
using Matrix3 = std::array<double, 9>;  ///< row by row

/// A limit that does not bind.
constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Own state as estimated on board.
struct Ownship {
  Triple position{};        ///< [m, NED]
  Triple velocity{};        ///< over ground [m/s, NED]
  double yaw{};             ///< [rad], 0 north, positive to starboard
  double yaw_rate{};        ///< [rad/s]
  double radius{1.0};       ///< of the enclosing sphere [m]
  std::uint32_t id{};       ///< unlike that of every track
  std::int32_t priority{};  ///< the smaller number has the right of way
  double position_sigma{};  ///< deviation of its error of position, to the worst side; 0: not stated [m]
};

/// Another vehicle, or anything else that moves, as perceived.
struct Track {
  Triple position{};              ///< extrapolated to the situation's time [m, NED]
  Triple velocity{};              ///< over ground [m/s, NED]
  Triple destination{};           ///< where it says it is going, if `has_destination` [m, NED]
  Matrix3 position_covariance{};  ///< of the error of `position` [m2, NED]
  Matrix3 velocity_covariance{};  ///< of the error of `velocity` [m2/s2, NED]
  double yaw{};                   ///< as reported [rad]
  double radius{1.0};             ///< of the enclosing sphere [m]
  double age{};                   ///< since the last measurement or message [s]
  std::uint32_t id{};
  std::int32_t priority{};  ///< the smaller number has the right of way
  bool has_destination{false};
  bool reacts{true};  ///< false: it keeps its course whatever comes
};

enum class ObstacleKind : std::uint8_t {
  sphere,   ///< `position`, `radius`
  segment,  ///< a thin wall from `from` to `to`
  polygon,  ///< solid vertical prism through every depth; vertices counter-clockwise, north as x and east as
            ///< y
};

/// Something solid that does not move. Only the members of its kind mean anything.
struct Obstacle {
  Triple position{};                ///< [m, NED]
  Triple from{};                    ///< [m, NED]
  Triple to{};                      ///< [m, NED]
  double radius{};                  ///< [m]
  const Triple* vertices{nullptr};  ///< at least three [m, NED]
  std::size_t vertex_count{};
  ObstacleKind kind{ObstacleKind::sphere};
  bool charted{true};  ///< known before the mission; else met on the way
};

/// Where the mission wants to be, and how fast.
struct Goal {
  Triple position{};  ///< [m, NED]
  Triple velocity{};  ///< wanted instead of heading straight for the position, if `has_velocity` [m/s, NED]
  double cruise_speed{};  ///< [m/s]
  bool has_velocity{false};
  double arrival{};  ///< this near to the position the mission has arrived [m]
};

/// What the vehicle can or may do.
struct Limits {
  double max_speed{unlimited};         ///< over ground [m/s]
  double max_climb_rate{unlimited};    ///< vertical, either way [m/s]; zero for a surface vehicle
  double max_acceleration{unlimited};  ///< [m/s2]
  double max_turn_rate{unlimited};     ///< [rad/s]
  double min_depth{-unlimited};        ///< ceiling: no command leads above it [m]
  double max_depth{unlimited};         ///< floor: no command leads below it [m]
  double min_speed{0.0};               ///< through the water; slower than this it does not steer [m/s]
  bool sternway{true};                 ///< it can go astern
  bool sway{true};                     ///< it can go sideways
};

/// How the vehicle answers to forces, one axis at a time: m nu' = tau - (d_l + d_q |nu|) nu - g, least <= tau
/// <= greatest.
struct OnboardModel {
  SixAxes mass{};               ///< rigid body and added mass m [kg, kg m2]
  SixAxes linear_damping{};     ///< d_l >= 0 [kg/s, kg m2/s]
  SixAxes quadratic_damping{};  ///< d_q >= 0 [kg/m, kg m2]
  SixAxes restoring{};          ///< g when level [N, N m]
  SixAxes least{};              ///< what the actuators give on an axis, the others at zero [N, N m]
  SixAxes greatest{};           ///< likewise
};

/// What the vehicle under its autopilot does in still water, where a method asks for it, as `+trackable`
/// does. `fairway describe VEHICLE` shows those of the simulated ones; envelope_of() makes one of such
/// numbers.
struct Envelope {
  double ahead{};              ///< greatest speed ahead [m/s]
  double astern{};             ///< greatest speed astern [m/s]
  double sideways{};           ///< greatest speed to either side [m/s]
  double up{};                 ///< fastest up, while going ahead [m/s]
  double down{};               ///< fastest down, while going ahead [m/s]
  double least{};              ///< it can go no slower and steer [m/s]
  double acceleration{};       ///< mean from the least speed to four fifths of the greatest [m/s2]
  double deceleration{};       ///< constant, of the same stopping distance as from the greatest speed [m/s2]
  double surge_lag{};          ///< in which 63 % of a small change of speed is made [s]
  double turn_acceleration{};  ///< greatest change of the turn rate [rad/s2]
  double turn_lag{};           ///< in which 63 % of a small change of the turn rate is made [s]
  double pivot{};     ///< ahead of the origin, where the hull does not slip in its fastest steady turn [m]
  double sway_lag{};  ///< time constant with which a slip as in that turn dies away at first [s]
  std::array<double, 4> turn_rates{};        ///< greatest, at 0, 1/3, 2/3 and 1 of the greatest speed [rad/s]
  std::array<double, 6> following_errors{};  ///< bound on the distance from a point that takes up a course at
                                             ///< once, for changes by 30, 60, ... 180 degrees [m]
  double deceleration_lost{};  ///< of the deceleration, while it takes up its greatest turn rate [m/s2]
  double turn_tail{};        ///< by which the heading in a long turn is later than the lag alone makes it [s]
  double slip_square{};      ///< share of what resists that slip which grows with its square
  double turn_plateau{1.0};  ///< of a turn rate, to which it comes by the lag; to the rest by the tail
  double foresight_error{};  ///< by which it gets farther than these numbers foresee, while it stops; of who
                             ///< cannot stop, elsewhere, in the first 8 s of a turn [m]
};

/// Of numbers by the names that `fairway describe VEHICLE` shows: "ahead_mps=1.6", "turn_rates_radps=0.2 0.3
/// 0.4 0.5". Those that are not given are zero; the greatest speed ahead, the accelerations and the turn
/// rates have to be. Throws std::runtime_error with what is wrong and the nearest valid name; std::bad_alloc.
Envelope envelope_of(const std::vector<std::string>& numbers);

/// All that an avoider may know at one instant, but for what others say: methods that agree by words (`needs
/// link` in `fairway describe`) are not offered here. What it points to must live until decide() returns.
struct Situation {
  Ownship own;
  Goal goal;
  Limits limits;
  double time{};                       ///< since the start of the mission [s]
  double period{};                     ///< until the next decision [s], > 0
  const OnboardModel* model{nullptr};  ///< null where nothing is known of forces
  const Envelope* envelope{nullptr};   ///< null where it is not known what the vehicle can do
  const Track* tracks{nullptr};        ///< in any order
  std::size_t track_count{};
  const Obstacle* obstacles{nullptr};  ///< in any order
  std::size_t obstacle_count{};
  Triple current{};  ///< of the water, as estimated on board, 0 if unknown [m/s, NED]
};

/// Why the command is what it is.
enum class Mode : std::uint8_t {
  cruise,      ///< nothing in the way
  avoid,       ///< deviating from the preferred velocity, or someone close enough that it might
  hold,        ///< waiting on purpose: keep the present position
  infeasible,  ///< no safe choice was found, or the input made no sense; the velocity is the least bad one
};

/// What the vehicle should do until the next decision.
struct Command {
  Triple velocity{};   ///< desired, over ground [m/s, NED]
  SixAxes wrench{};    ///< desired force and moment, if `has_wrench` [N, N m, body]
  double heading{};    ///< desired yaw, if `has_heading` [rad]
  double turn_rate{};  ///< desired, if `has_turn_rate`; then surge is the part of `velocity` along the
                       ///< heading [rad/s]
  std::string_view
      note;  ///< why, in a few words for people, where `mode` does not say it; lives as long as the program
  std::size_t left_out{};  ///< tracks and obstacles that did not fit into the Capacity; where the method
                           ///< itself has no room for all that is near, the nearest count and `note` says so
  Mode mode{Mode::cruise};
  bool astern{false};  ///< the vehicle may go stern first rather than turn round
  bool has_heading{false};
  bool has_turn_rate{false};
  bool has_wrench{false};
};

/// How much a situation may hold; room for it is made once, at construction.
struct Capacity {
  std::size_t tracks{32};
  std::size_t obstacles{32};
  std::size_t vertices{256};  ///< of all polygons together
};

/// A method by its name, with its memory and its randomness, as fairway/avoidance has it: shown the same, it
/// decides the same, to the bit. A value: a copy is a snapshot, and decides as the original does for ever.
/// One thread at a time may use one.
class Avoider {
 public:
  /// `algorithm` as algorithms() lists it, wrappers behind it: "orca3d", "apf+stop_and_wait". `settings` are
  /// its parameters, "time_horizon_s=10", by the names that `fairway describe` shows; the others keep their
  /// defaults. Throws std::runtime_error with what is wrong and the nearest valid name, also for a method
  /// that needs a link; std::bad_alloc.
  explicit Avoider(std::string_view algorithm, const std::vector<std::string>& settings = {},
                   const Capacity& capacity = {}, std::uint64_t seed = 0);
  Avoider(const Avoider& other);
  Avoider& operator=(const Avoider& other);
  Avoider(Avoider&& other) noexcept;             ///< `other` is then good for assignment only
  Avoider& operator=(Avoider&& other) noexcept;  ///< likewise
  ~Avoider();

  /// Decides, and holds the decision to the limits. A situation that is not usable (NaN, no period, a null
  /// pointer with a count, an envelope without speed) is answered with zero velocity and Mode::infeasible.
  /// Where there is more than the capacity the nearest are kept, of a polygon's vertices all or none;
  /// `Command::left_out` counts the others. Does not throw, allocate or lock, the first time no more than
  /// later. O(n log n) for n tracks and obstacles, besides the method's own cost.
  [[nodiscard]] Command decide(const Situation& situation) noexcept;

 private:
  struct Self;
  std::unique_ptr<Self> self_;
};

/// Names that an Avoider can be made by; wrappers stand alone too, and are then around `direct`.
std::vector<std::string> algorithms();

}  // namespace fairway::embed
