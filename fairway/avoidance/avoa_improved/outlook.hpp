// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fairway/avoidance/avoa_improved/capsule.hpp"
#include "fairway/avoidance/avoa_improved/vessel_response.hpp"

namespace fairway::avoa_improved {

/// Own ship where a prediction begins. [m, m/s, rad, NED]
struct OwnMotion {
  Vec2 position = Vec2::Zero();
  double yaw{};
  double yaw_rate{};          ///< [rad/s]
  double speed{};             ///< through the water, along the heading [m/s]
  Vec2 drift = Vec2::Zero();  ///< of the water, taken to last [m/s]
};

/// What is asked of a prediction.
struct Foresight {
  bool turn_aware{};  ///< false: the commanded velocity is there at once
  double window{};    ///< how far ahead [s]
  double hold{};      ///< how long a command is kept before it must be possible to stop [s]
  double near{};      ///< how far ahead what does not move costs [s]
  double margin{};    ///< kept to every surface, beyond own radius [m]
  double danger{};    ///< beyond the margin, clearance up to this costs [m]
};

/// A command, and what is to follow it.
struct Manoeuvre {
  double speed{};               ///< astern if negative [m/s]
  double heading{};             ///< [rad]
  std::size_t heading_index{};  ///< its place among the headings asked for: each turn is computed once
  double speed_after{};         ///< once the heading is nearly reached [m/s]
};

/// What a command would come to.
struct Prospect {
  bool is_clear{};    ///< the margin is kept
  bool touches{};     ///< hulls touch that did not at the beginning
  double danger{};    ///< cost of danger, 0 to 1
  double severity{};  ///< what is lost of the margin in all, less if later, most if hulls touch [m]
};

/// What commands would come to, from one instant on. The motion that each would bring about is compared
/// with everything near, moving at constant velocity.
class Outlook {
 public:
  static constexpr double step = 0.2;  ///< of the prediction [s]
  static constexpr std::size_t most_steps = 160;
  static constexpr std::size_t most_headings = 64;

  /// Only what can come within reach counts. `fixed` and `moving` must outlive the outlook. O(solids).
  Outlook(const VesselResponse& helm, const Foresight& foresight, const OwnMotion& own, double own_radius,
          double greatest_speed, std::span<const Capsule> fixed, std::span<const Capsule> moving) noexcept;

  /// True if nothing is within reach.
  bool is_open() const noexcept { return fixed_count_ == 0 && moving_count_ == 0; }

  /// What the motion of a manoeuvre comes to. No further than to where it is not clear, or its danger is
  /// beyond `bearable`: the prospect is then of the part before. O(window / step x solids near).
  Prospect of(const Manoeuvre& manoeuvre, double bearable) noexcept;

  /// The same to the end of the window, come what may; or, of one that loses as much as `too_severe`, to
  /// where it has [m].
  Prospect to_the_end_of(const Manoeuvre& manoeuvre, double too_severe = Limits::none) noexcept;

  /// The positions of that motion, one each `step`, the first one step from now. Valid until the next call.
  /// [m]
  std::span<const Vec2> path(const Manoeuvre& manoeuvre) noexcept;

 private:
  /// Something near, and what is kept from its middle line.
  struct Hazard {
    const Capsule* solid;
    double contact;  ///< own radius and its own [m]
    double keep;     ///< beyond contact; less than the margin where that is lost already [m]
    double far;      ///< at this distance it costs nothing [m]
    double gone;     ///< by itself in a step [m]
  };

  /// Hazards along a path.
  struct Watch {
    std::span<const Hazard> hazards;
    double gone;                                          ///< by own ship in a step, at most [m]
    std::array<std::uint8_t, Capsules::capacity> next{};  ///< the first step in which each may cost anything
  };

  /// The heading over time while turning.
  struct TurnAhead {
    bool is_known = false;
    std::size_t reached;                     ///< the step in which it is nearly the one asked for
    std::array<Vec2, most_steps> direction;  ///< unit, in the middle of each step
  };

  /// What the nearest of some hazards leaves.
  struct Room {
    double beyond{};  ///< what is to be kept, negative where it is not; exact where it costs anything [m]
    bool is_none{};   ///< hulls touch that did not at the beginning
  };

  /// Along a path at one instant.
  struct Advance {
    Vec2 position;
    double speed;
  };

  void add_if_near(const Capsule& solid, double reach, std::array<Hazard, Capsules::capacity>& to,
                   std::size_t& count) noexcept;
  const TurnAhead& turn_to(double heading, std::size_t index) noexcept;
  void advance(Advance& at, double speed, const Vec2& direction) const noexcept;
  /// In a step: where own ship is by then, and when that is.
  Room room(Watch& watch, std::size_t k, const Vec2& own, double t) const noexcept;
  void weigh(const Room& room, double t, double window, Prospect& prospect) const noexcept;
  /// `go_on(prospect)` before each step.
  template <class GoOn>
  Prospect foresee(const Manoeuvre& manoeuvre, GoOn go_on) noexcept;
  bool can_stop(Advance at, const TurnAhead& turn, std::size_t from, Watch watch) const noexcept;

  std::span<const Hazard> fixed() const noexcept { return {fixed_.data(), fixed_count_}; }
  std::span<const Hazard> moving() const noexcept { return {moving_.data(), moving_count_}; }

  VesselResponse helm_;
  Foresight foresight_;
  OwnMotion own_;
  double own_radius_;
  std::size_t steps_;
  std::size_t hold_steps_;
  double gone_;
  std::array<Hazard, Capsules::capacity> fixed_;
  std::size_t fixed_count_ = 0;
  std::array<Hazard, Capsules::capacity> moving_;
  std::size_t moving_count_ = 0;
  std::array<TurnAhead, most_headings> turns_;
  std::array<Vec2, most_steps> path_;
};

}  // namespace fairway::avoa_improved
