// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "fairway/avoidance/avoa/swarm.hpp"
#include "fairway/avoidance/avoa/velocity_space.hpp"
#include "fairway/avoidance/avoider.hpp"

namespace fairway {

/// How the best velocity is found.
enum class VelocitySearch {
  swarm,       ///< particle swarm optimisation, as published
  exhaustive,  ///< every cell of the grid
};

template <>
struct EnumNames<VelocitySearch> {
  static constexpr std::array names{"swarm", "exhaustive"};
};

/// Adaptive velocity obstacle avoidance for surface vessels (campos2019, section III): over a picture of the
/// velocities, zones that lead to a collision within a time and zones that the thrusters cannot make are
/// forbidden; of the rest, a swarm of particles finds the one with the least deviation in speed and heading
/// and the least danger. Others are taken to keep their course. Where the envelope is known, a wrapper
/// foresees what the vehicle makes of the answer: what is desired is then feasible whatever the thrusters can
/// make, what lies beside it as if the bow were there, what leads away from it costs more, and t_H of what
/// stands is 30 s at least. O(side^2 + discs * side + particles * iterations).
///
///     paper              here
///     [v, theta]         PolarVelocity, in own body axes
///     PZ, PZ_H, t_H      ProtectiveZones; forbidden is PZ without PZ_H; window_s
///     PZ^K, alpha, beta  KinematicZone; alpha_ratio, beta_m, thruster_speed_mps
///     h, psi, nabla      VelocityMetric; the three weights; cost_of_danger()
///     F, phi, v_ini, a_e VelocitySpace; Swarm::Settings
struct Avoa {
  static constexpr AlgorithmInfo info{
      .name = "avoa",
      .title = "Adaptive velocity obstacle avoidance with a particle swarm",
      .source =
          "campos2019, eqs. 1-10, Algorithms 1 and 2; what they leave open: fairway/avoidance/avoa/README.md",
      .planar = true,
      .handed = true,
      .steers_by_heading = true,
  };

  struct Params {
    VelocitySearch search = VelocitySearch::swarm;
    TimeToContact time_to_contact = TimeToContact::bound;
    int grid_count = 101;
    double window_s = 7.7;
    double margin_m = 0.25;
    double circle_spacing_m = 0.5;
    double thruster_speed_mps = 1.5;
    double alpha_ratio = 1.0;
    double beta_m = 3.0;
    double turn_gain_hz = 0.5;
    double max_speed_mps = 1.5;
    double max_turn_rate_radps = 0.3751;
    double least_speed_mps = 0.2;
    double danger_threshold_mps = 0.3;
    double speed_weight_ratio = 0.4;
    double heading_weight_ratio = 0.2;
    double danger_weight_ratio = 0.4;
    int particle_count = 30;
    int iteration_count = 60;
    double accepted_cost_ratio = 0.001;
    double inertia_ratio = 0.7;
    double personal_ratio = 1.4;
    double common_ratio = 1.4;
    double shake_mps = 0.05;
    double shake_rad = 0.05 * pi;
    double start_mps = 0.3;
    double start_rad = 0.3 * pi;

    static consteval auto fields() {
      using P = Params;
      return std::tuple{
          field<&P::search>("swarm, or exhaustive: the best cell, to compare with"),
          field<&P::time_to_contact>("bound: gap by closing speed (eq. 2), or exact"),
          field<&P::grid_count>({2, 401}, "velocities along each side of the picture"),
          field<&P::window_s>(
              {0.01, 10000},
              "t_H: a collision this far off is allowed; 30 s at least with obstacles under trackable"),
          field<&P::margin_m>({0, 1000}, "kept besides the radii"),
          field<&P::circle_spacing_m>({0.01, 1000}, "between the circles that cover a wall, at most"),
          field<&P::thruster_speed_mps>({0, 100}, "v_max^t: what a thruster can do"),
          field<&P::alpha_ratio>({0, 100}, "alpha: thruster speed per speed"),
          field<&P::beta_m>({0, 1000}, "beta: thruster speed per turn rate"),
          field<&P::turn_gain_hz>({0, 100}, "turn rate per angle to the heading"),
          field<&P::max_speed_mps>({0.001, 100}, "v_max where the mission sets no limit"),
          field<&P::max_turn_rate_radps>({0, 100}, "largest turn rate where the mission sets no limit"),
          field<&P::least_speed_mps>({0, 100}, "slower is not feasible, unless desired"),
          field<&P::danger_threshold_mps>({0, 100}, "danger begins this near to a zone, in velocity space"),
          field<&P::speed_weight_ratio>({0, 1000},
                                        "psi of the deviation in speed; the three are scaled to 1"),
          field<&P::heading_weight_ratio>({0, 1000}, "psi of the deviation in heading"),
          field<&P::danger_weight_ratio>({0, 1000}, "psi of the danger"),
          field<&P::particle_count>({1, 10000}, "npart: particles"),
          field<&P::iteration_count>({1, 10000}, "maxit: iterations at most"),
          field<&P::accepted_cost_ratio>({0, 1}, "a_e: a velocity that costs no more ends the search"),
          field<&P::inertia_ratio>({0, 1}, "phi_1: of the last step"),
          field<&P::personal_ratio>({0, 4}, "phi_2: towards the particle's best"),
          field<&P::common_ratio>({0, 4}, "phi_3: towards the swarm's best"),
          field<&P::shake_mps>({0, 100}, "phi_4: largest speed step of a particle that rests"),
          field<&P::shake_rad>({0, 7}, "phi_4: and heading step"),
          field<&P::start_mps>({0, 100}, "v_ini: largest speed step at the start"),
          field<&P::start_rad>({0, 7}, "v_ini: and heading step"),
      };
    }
  };

  /// Scratch: no decision depends on what it holds.
  struct Memory {
    avoa::VelocitySpace space;
    avoa::Swarm swarm;
    std::vector<std::uint32_t> picture;
  };

  Params params;

  /// Mode::cruise if no obstacle forbids any velocity: the preferred one, or the best on the way round to it;
  /// Mode::avoid if one does; Mode::infeasible with no velocity if none is left, or own ship may not move.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<Avoa>);

}  // namespace fairway
