// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "fairway/avoidance/safety_filter/safety_filter.hpp"
#include "fairway/avoidance/wall_following/wall_following.hpp"
#include "fairway/planning/blend/finds.hpp"
#include "fairway/planning/rrt_star/plan.hpp"
#include "fairway/planning/rrt_star/pursuit.hpp"

namespace fairway {

/// A planned path, and a reaction to what the plan did not know (rehman2021, section V: "blend the offline
/// RRT* path-planning and wall-following methods to obtain a complete strategy which would be able to avoid
/// both stationary and moving obstacles"). It follows the trajectory of a plan over the charted obstacles;
/// goes round what blocks that trajectory by corrected wall following, and back to it as soon as the way is
/// free; lets what moves pass on a way through space and time; plans anew, over all that it has met, when
/// that is expected to be quicker; and passes everything through the safety filter. For any vehicle that can
/// go any way: it commands velocities.
///
/// A vehicle that must turn follows the path by looking ahead (Pursuit). It plans anew, at most every
/// `between_plans_s`, where something known lies on what is left of the path or that has come to nothing, and
/// goes round by wall following where there is no other plan. What moves, and the filter, are then the
/// business of the wrapper that has its envelope, `+trackable` or `+safety_filter`.
///
/// Following is O(obstacles + lookahead x tracks); going round as WallFollowing; a way through space and time
/// a few milliseconds, once a second with a mover near; planning as make_plan(), a few ten milliseconds, at
/// the first decision and when something uncharted is met.
struct Blend {
  static constexpr AlgorithmInfo info{
      .name = "blend",
      .title = "Planned path, wall following around what it did not know, safety filter",
      .source = "rehman2021, section V (named there as future work)",
      .planar = true,
      .allocates = true,
      .isotropic = false,
      .needs_sway = true,
      .needs_stopping = true,
      .finds_way = true,
  };

  struct Params : PlanParams {
    double lookahead_s = 20.0;
    double leash_m = 1.0;
    double position_bandwidth_radps = 0.3;
    double standoff_m = 0.8;
    double replan_gain_ratio = 0.1;
    bool replan = true;
    bool filter = true;
    double margin_m = 0.5;

    static consteval auto fields() {
      using P = Params;
      return std::tuple_cat(
          PlanParams::fields(),
          std::tuple{
              field<&P::lookahead_s>({0, 1000}, "how far ahead the trajectory is checked"),
              field<&P::leash_m>({0.01, 100}, "off the trajectory by more, its clock waits"),
              field<&P::position_bandwidth_radps>({0, 10}, "velocity command per position error"),
              field<&P::standoff_m>({0, 1000}, "kept from every surface while going round"),
              field<&P::replan_gain_ratio>({0, 10}, "a new plan has to be quicker by this share"),
              field<&P::replan>("whether it plans anew at all"),
              field<&P::filter>("whether commands pass the safety filter"),
              field<&P::margin_m>({0, 1000}, "of the safety filter, between own sphere and every surface"),
          });
    }
  };

  /// What it is about.
  enum class Stage {
    following,    ///< the trajectory
    going_round,  ///< what blocks it
  };

  struct Memory {
    std::shared_ptr<const Plan> plan;
    /// What was met, grown by own radius and margin; of a vehicle that must turn all that is known, grown by
    /// own radius and clearance.
    std::shared_ptr<const PlanarMap> met;
    Finds finds;
    Stage stage{Stage::following};
    double depth{};                   ///< where the plan was made [m], for who looks
    double progress_s{};              ///< along the trajectory
    Pursuit pursuit;                  ///< of the path, by a vehicle that must turn
    double planned_s{};               ///< when such a one looked for a plan last,
    double noted_s{};                 ///< and made the map of what is known
    std::optional<double> last_time;  ///< of the call before [s]
    WallFollowing::Memory wall;
    std::optional<Vec3> dodge;  ///< velocity that lets a mover pass, north and east
    double dodge_until_s{};     ///< when it is looked for again
  };

  Params params;

  /// Mode::cruise along the trajectory, Mode::avoid otherwise; without a plan it goes by wall following alone
  /// and says why in `Command::note`.
  Command decide(const Situation& s, Memory& memory, Context& context) const noexcept;
};

static_assert(AvoidanceAlgorithm<Blend>);

}  // namespace fairway
