// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "fairway/avoidance/catalog.hpp"
#include "fairway/avoidance/stop_and_wait/stop_and_wait.hpp"

namespace fairway::cubes {

/// At most this many vehicles in the published experiments.
inline constexpr std::size_t max_team = 8;

/// The order in which a robot handles its neighbours' messages: each robot publishes at its own phase,
/// so the order is one of chance, and stays for the run.
class MessageOrder {
 public:
  /// Indices into `tracks` in that order. Draws the order from `rng` the first time.
  std::span<const std::size_t> of(std::span<const Track> tracks, Rng& rng);

 private:
  bool drawn_{false};
  std::array<double, 2 * max_team> phase_{};  ///< by id
  std::array<std::size_t, max_team> order_{};
};

/// The potential field that made the published data. It differs from Algorithm 1 in one thing: V_obs is
/// not zeroed at every step. Each neighbour's message, one a tick, adds its V_i, and the sum is
/// zeroed only when a neighbour leaves and nobody is left within CRIT_DIST. The published data are from
/// October and November 2023, when the code clamped the speeds; the bang-bang law that is printed
/// came in December.
struct ApfAsCoded {
  static constexpr AlgorithmInfo info{
      .name = "apf_as_coded",
      .title = "Artificial potential fields as coded for raja2024",
      .source = "raja2024, published code: accumulating repulsion",
  };

  struct Params {
    double crit_dist_m = 6.0;
    double w1_ratio = 1.0;
    double w2_ratio = 0.5;
    bool bang_bang = false;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::crit_dist_m>({0.1, 1000}, "CRIT_DIST"),
          field<&Params::w1_ratio>({0, 1000}, "W1"),
          field<&Params::w2_ratio>({0, 1000}, "W2"),
          field<&Params::bang_bang>("full speed along each axis, as printed, instead of clamped"),
      };
    }
  };

  struct Memory {
    Vec3 v_obs = Vec3::Zero();
    std::array<bool, 2 * max_team> near{};  ///< by id
  };

  Params params;

  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

/// ORCA as the published code drives its library: body velocities handed in as if they were NED; one
/// step of the library per neighbour's message, which moves every agent inside the library by
/// time_step at its own new velocity until its next message arrives; the answer of the last step counts.
struct OrcaAsCoded {
  static constexpr AlgorithmInfo info{
      .name = "orca3d_as_coded",
      .title = "ORCA as coded for raja2024",
      .source = "raja2024, published code: body velocities as NED, one library step per message",
      .isotropic = false,
  };

  struct Params {
    double crit_dist_m = 20.0;
    double time_horizon_s = 5.0;
    double time_step_s = 1.0;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::crit_dist_m>({0.1, 10000}, "CRIT_DIST, the library's neighborDist"),
          field<&Params::time_horizon_s>({0.01, 10000}, "time_horizon"),
          field<&Params::time_step_s>({0.001, 100}, "time_step of the library"),
      };
    }
  };

  /// One agent inside the library.
  struct LibraryAgent {
    Vec3 position = Vec3::Zero();
    Vec3 velocity = Vec3::Zero();
    Vec3 preferred = Vec3::Zero();
    bool known{false};
  };

  struct Memory {
    MessageOrder order;
    std::array<LibraryAgent, 2 * max_team> agents{};  ///< by id
  };

  Params params;

  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;

 private:
  void step_library(Memory& memory, const Situation& s) const noexcept;
};

/// Stop-and-wait as coded: the rule of `StopAndWait`, but going on takes a service call to the vehicle's
/// software, which releases the hold only after a while. How long is not published; the default is
/// the value at which the published times of APF with stop-and-wait come out best.
struct StopAndWaitAsCoded {
  static constexpr AlgorithmInfo info{
      .name = "stop_and_wait_as_coded",
      .title = "Stop-and-wait as coded for raja2024",
      .source = "raja2024, published code: keep-position service calls",
  };

  struct Params {
    double crit_dist_m = 6.0;
    double release_s = 1.0;

    static consteval auto fields() {
      return std::tuple{
          field<&Params::crit_dist_m>({0.1, 10000}, "CRIT_DIST"),
          field<&Params::release_s>({0, 60}, "from the decision to go on until the hold is released"),
      };
    }
  };

  struct Memory {
    StopAndWait::Memory rule;
    bool waiting{false};
    double released{};  ///< [s]
  };

  Params params;

  Command decide(const Situation& s, Avoider& inner, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceWrapper<StopAndWaitAsCoded>);
static_assert(AvoidanceAlgorithm<ApfAsCoded> && AvoidanceAlgorithm<OrcaAsCoded>);

}  // namespace fairway::cubes
