// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/studies/cubes/as_coded.hpp"

namespace fairway::cubes {

/// The published code among other processes: what its topics and its navigator may have done to what a robot
/// hears, knows of itself and commands, around any of the methods as coded. By default nothing.
struct AsHeard {
  static constexpr AlgorithmInfo info{
      .name = "as_heard",
      .title = "Messages and odometry of the published runs that are late, lost, noisy or out of step",
      .source = "raja2024, published code: topics with queues of one message, each robot with its own clock",
  };

  struct Params {
    double late_s = 0.0;
    double jitter_s = 0.0;
    double lost_ratio = 0.0;
    double noise_m = 0.0;
    double own_period_s = 0.0;
    double command_late_s = 0.0;
    bool out_of_step = false;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::late_s>({0, 1.5}, "every message is so old when it is handled"),
          field<&Params::jitter_s>({0, 1.5}, "and up to so much older, drawn for each message"),
          field<&Params::lost_ratio>({0, 1}, "share of messages that are never handled"),
          field<&Params::noise_m>({0, 100}, "white, on each axis of each position, own and told"),
          field<&Params::own_period_s>({0, 10}, "own position and velocity are renewed so often; 0: always"),
          field<&Params::command_late_s>({0, 1.5}, "from a decision until the vehicle has it"),
          field<&Params::out_of_step>("each robot speaks at an instant of its own within the period"),
      };
    }
  };

  /// What was said and decided in the last ticks.
  static constexpr std::size_t ticks_kept = 64;
  static constexpr std::size_t most_robots = 2 * max_team;
  struct Said {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    double yaw{};
  };
  struct Memory {
    std::int64_t tick{};
    std::array<std::array<Said, ticks_kept>, most_robots> said{};  ///< by id, then tick
    std::array<std::int64_t, most_robots> first{};                 ///< tick of the first, by id; -1 before
    std::array<double, most_robots> phase{};                       ///< of each robot, in periods
    std::array<Command, ticks_kept> decided{};
    Ownship own;
    double own_due{};  ///< when `own` is renewed [s]
    bool begun{};
  };

  Params params;

  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;

 private:
  void begin(const Situation& s, Memory& memory, Rng& rng) const noexcept;
  Track heard(const Track& track, const Situation& s, const Memory& memory, Rng& rng) const noexcept;
};

static_assert(AvoidanceWrapper<AsHeard>);

}  // namespace fairway::cubes
