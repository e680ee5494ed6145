// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>

#include "fairway/core/envelope.hpp"
#include "fairway/core/ids.hpp"
#include "fairway/core/limits.hpp"
#include "fairway/core/onboard_model.hpp"
#include "fairway/core/record.hpp"
#include "fairway/core/shapes.hpp"
#include "fairway/core/speech.hpp"
#include "fairway/core/vec.hpp"

namespace fairway {

/// Own state as estimated on board. Never the simulator's truth.
struct Ownship {
  VehicleId id{};
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  double yaw{};
  double yaw_rate{};
  double radius{1.0};
  std::int32_t priority{};
  double position_sigma{};

  /// It is mostly within this of where it believes to be: two deviations, in which a bell in the plane has 86
  /// of 100. Own methods keep it beside their margins. [m]
  double position_error() const noexcept { return 2.0 * position_sigma; }

  static consteval auto members() {
    using R = Ownship;
    return std::tuple{
        member<&R::id>("", "of the vehicle").required(),
        member<&R::position>("m", "[m, NED]").required(),
        member<&R::velocity>("mps", "over ground [m/s, NED]").required(),
        member<&R::yaw>("rad", "[rad], 0 north, positive to starboard").required(),
        member<&R::yaw_rate>("radps", "[rad/s]"),
        member<&R::radius>("m", "of the enclosing sphere [m]").required().not_negative(),
        member<&R::priority>("", "the smaller number has the right of way; the id unless given"),
        member<&R::position_sigma>("m",
                                   "deviation of its error of position, to the worst side, as its navigation "
                                   "states it [m]; 0 where it does not")
            .not_negative(),
    };
  }
};

/// Another vehicle, or anything else that moves, as perceived: possibly late, noisy, or no longer there.
struct Track {
  TrackId id{};
  Vec3 position = Vec3::Zero();
  Vec3 velocity = Vec3::Zero();
  double yaw{};
  double radius{1.0};
  double age{};
  std::int32_t priority{};
  std::optional<Vec3> destination;
  bool reacts{true};
  Mat3 position_covariance = Mat3::Zero();
  Mat3 velocity_covariance = Mat3::Zero();

  static consteval auto members() {
    using R = Track;
    return std::tuple{
        member<&R::id>("", "of the track").required(),
        member<&R::position>("m", "extrapolated to the situation's time [m, NED]").required(),
        member<&R::velocity>("mps", "over ground [m/s, NED]").required(),
        member<&R::yaw>("rad", "as reported [rad]"),
        member<&R::radius>("m", "of the enclosing sphere [m]").required().not_negative(),
        member<&R::age>("s", "since the last measurement or message [s]").not_negative(),
        member<&R::priority>("", "the smaller number has the right of way; the id unless given"),
        member<&R::destination>("m", "where it says it is going [m, NED], or none"),
        member<&R::reacts>("", "false: it keeps its course whatever comes, as a drifting object does"),
        member<&R::position_covariance>("m2", "of the error of position, row by row [m2, NED]"),
        member<&R::velocity_covariance>("m2ps2", "of the error of velocity, row by row [m2/s2, NED]"),
    };
  }
};

/// Where the mission wants to be, and how fast.
struct Goal {
  Vec3 position = Vec3::Zero();
  double cruise_speed{};
  double arrival{};
  std::optional<Vec3> velocity;

  static consteval auto members() {
    using R = Goal;
    return std::tuple{
        member<&R::position>("m", "[m, NED]").required(),
        member<&R::cruise_speed>("mps", "[m/s]").not_negative(),
        member<&R::arrival>("m", "this near to the position the mission has arrived [m]").not_negative(),
        member<&R::velocity>("mps",
                             "wanted instead of heading straight for the position [m/s, NED], or none"),
    };
  }
};

/// What the mission does meanwhile. A method that speaks is asked before it sets out, after it has arrived,
/// and while it is kept.
enum class Attendance : std::uint8_t {
  under_way,  ///< the answer is carried out
  waiting,    ///< at a rendezvous; the goal is the next one, and of the answer only a hold is carried out
  ready,      ///< the same, where the mission goes on as soon as the answer is none to hold
  arrived,    ///< held for ever; of the answer only a hold is carried out
  kept,       ///< stopped where it is, for as long as whoever commands it likes; likewise
};

template <>
struct EnumNames<Attendance> {
  static constexpr std::array names{"under_way", "waiting", "ready", "arrived", "kept"};
};

/// All that an avoider may know at one instant. Immutable; the spans are valid only during the call
/// to decide().
struct Situation {
  double time{};    ///< since the start of the mission [s]
  double period{};  ///< until the next decision [s], > 0
  Ownship own;
  Goal goal;
  Limits limits;                        ///< `Avoider` holds commands to speed, climb and depth of these
  const OnboardModel* model{nullptr};   ///< null where nothing is known of forces
  const Envelope* envelope{nullptr};    ///< null unless a method asks for it (`needs_envelope`)
  const Link* link{nullptr};            ///< null unless the method speaks and has somebody to hear
  Vec3 current = Vec3::Zero();          ///< of the water, as estimated on board, 0 if unknown [m/s, NED]
  std::span<const Track> tracks;        ///< nearest first; equal ranges by id
  std::span<const Obstacle> obstacles;  ///< what does not move
  Attendance attendance{};
  bool is_led{false};  ///< the goal's velocity, or where it has none the straight way, leads past what stands

  /// Whether the method, which was asked last at that time [s], has not been asked for so long that the
  /// vehicle has done something else meanwhile.
  bool comes_after_pause(double last) const {
    constexpr double longest = 1.0;  // beyond a period [s]
    return time - last > period + longest;
  }

  /// The velocity that ignores everyone: as the mission wants it, or straight to the goal, slowing
  /// down to stop on it; never above the speed limit. [m/s, NED]
  Vec3 preferred_velocity() const {
    if (goal.velocity) return clamp_norm(*goal.velocity, limits.max_speed);
    const Vec3 to_goal = goal.position - own.position;
    const double distance = to_goal.norm();
    const double wanted = std::min({goal.cruise_speed, limits.max_speed, distance / period});
    return distance > 0.0 ? Vec3{(wanted / distance) * to_goal} : Vec3{Vec3::Zero()};
  }
};

/// What of the situation cannot be decided on, in a few words: a number that is NaN or infinite where it
/// must not be, a period that is not positive, a negative radius, an envelope that says of no motion how it
/// is made. Empty if it is usable. `Avoider` answers anything else with `Mode::infeasible` and these words as
/// its note. O(tracks + vertices of obstacles).
std::string_view why_unusable(const Situation& situation) noexcept;

inline bool is_usable(const Situation& situation) noexcept { return why_unusable(situation).empty(); }

}  // namespace fairway
