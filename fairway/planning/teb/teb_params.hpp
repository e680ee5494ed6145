// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/params.hpp"

namespace fairway {

/// What way to the goal the bands follow.
enum class TebGlobalPlan {
  automatic,  ///< `rrt_star` to a place where the envelope of the vehicle is known, else `straight`
  straight,   ///< a straight line, as a global planner gives it that knows of no obstacle
  rrt_star,   ///< a way round what is known, planned anew where that is blocked or no band could be followed
};

template <>
struct EnumNames<TebGlobalPlan> {
  static constexpr std::array names{"automatic", "straight", "rrt_star"};
};

/// The parameters of teb_local_planner under its names, with its defaults.
struct TebParams {
  double max_vel_x_mps = 0.4;
  double max_vel_x_backwards_mps = 0.2;
  double max_vel_theta_radps = 0.3;
  double acc_lim_x_mps2 = 0.5;
  double acc_lim_theta_radps2 = 0.5;
  double penalty_epsilon_ratio = 0.1;

  double dt_ref_s = 0.3;
  double dt_hysteresis_s = 0.1;
  int min_samples_count = 3;
  int max_samples_count = 500;
  TebGlobalPlan global_plan = TebGlobalPlan::automatic;
  double max_global_plan_lookahead_dist_m = 3.0;
  double force_reinit_new_goal_dist_m = 1.0;
  double force_reinit_new_goal_angular_rad = 0.78;
  int feasibility_check_no_poses_count = 5;
  double xy_goal_tolerance_m = 0.2;

  double min_obstacle_dist_m = 0.5;
  double inflation_dist_m = 0.6;
  double dynamic_obstacle_inflation_dist_m = 0.6;
  bool include_dynamic_obstacles = true;
  double obstacle_association_force_inclusion_factor_ratio = 1.5;
  double obstacle_association_cutoff_factor_ratio = 5.0;

  int no_inner_iterations_count = 5;
  int no_outer_iterations_count = 4;
  double weight_max_vel_x_ratio = 2.0;
  double weight_max_vel_theta_ratio = 1.0;
  double weight_acc_lim_x_ratio = 1.0;
  double weight_acc_lim_theta_ratio = 1.0;
  double weight_kinematics_nh_ratio = 1000.0;
  double weight_kinematics_forward_drive_ratio = 1.0;
  double weight_optimaltime_ratio = 1.0;
  double weight_obstacle_ratio = 50.0;
  double weight_inflation_ratio = 0.1;
  double weight_dynamic_obstacle_ratio = 50.0;
  double weight_dynamic_obstacle_inflation_ratio = 0.1;
  double weight_adapt_factor_ratio = 2.0;

  bool enable_homotopy_class_planning = true;
  int max_number_classes_count = 5;
  int roadmap_graph_no_samples_count = 15;
  double roadmap_graph_area_width_m = 5.0;
  double obstacle_heading_threshold_ratio = 0.45;
  double h_signature_threshold_ratio = 0.1;
  double selection_cost_hysteresis_ratio = 1.0;
  double selection_prefer_initial_plan_ratio = 0.95;
  double selection_obst_cost_scale_ratio = 2.0;

  bool robust = false;

  static consteval auto fields() {
    using P = TebParams;
    return std::tuple{
        field<&P::max_vel_x_mps>({0.01, 100}, "largest speed ahead"),
        field<&P::max_vel_x_backwards_mps>({0.01, 100}, "largest speed astern"),
        field<&P::max_vel_theta_radps>({0.01, 100}, "largest yaw rate"),
        field<&P::acc_lim_x_mps2>({0.01, 100}, "largest acceleration ahead or astern"),
        field<&P::acc_lim_theta_radps2>({0.01, 100}, "largest yaw acceleration"),
        field<&P::penalty_epsilon_ratio>({0, 10}, "every limit is kept with this margin, in its own unit"),
        field<&P::dt_ref_s>({0.01, 10}, "wanted time between poses"),
        field<&P::dt_hysteresis_s>({0.002, 10}, "poses are added and removed beyond this deviation"),
        field<&P::min_samples_count>({3, 500}, "poses of a band at least"),
        field<&P::max_samples_count>({3, 500}, "poses of a band at most"),
        field<&P::global_plan>("the way to the goal that the bands begin along and follow"),
        field<&P::max_global_plan_lookahead_dist_m>({0.1, 1000}, "how far along the way the band reaches"),
        field<&P::force_reinit_new_goal_dist_m>({0, 1e6}, "the end moved more: the bands are begun anew"),
        field<&P::force_reinit_new_goal_angular_rad>({0, 7}, "the end turned more: likewise"),
        field<&P::feasibility_check_no_poses_count>({0, 500}, "first poses that must not touch anything"),
        field<&P::xy_goal_tolerance_m>({0, 1000}, "this near to the goal nothing is commanded"),
        field<&P::min_obstacle_dist_m>({0, 1000}, "wanted between own sphere and every surface"),
        field<&P::inflation_dist_m>({0, 1000}, "within it a surface costs a little"),
        field<&P::dynamic_obstacle_inflation_dist_m>({0, 1000}, "likewise of what moves"),
        field<&P::include_dynamic_obstacles>("tracks move on; else they stand where they are now"),
        field<&P::obstacle_association_force_inclusion_factor_ratio>(
            {0, 100}, "all obstacles within this many times min_obstacle_dist_m of a pose count for it"),
        field<&P::obstacle_association_cutoff_factor_ratio>(
            {0, 100}, "beyond, the nearest to port and to starboard within this many times it"),
        field<&P::no_inner_iterations_count>({1, 100}, "of the solver per adaptation of the poses"),
        field<&P::no_outer_iterations_count>({1, 100}, "adaptations of the poses per decision"),
        field<&P::weight_max_vel_x_ratio>({0, 1e6}, "of the speed limits"),
        field<&P::weight_max_vel_theta_ratio>({0, 1e6}, "of the yaw rate limit"),
        field<&P::weight_acc_lim_x_ratio>({0, 1e6}, "of the acceleration limit"),
        field<&P::weight_acc_lim_theta_ratio>({0, 1e6}, "of the yaw acceleration limit"),
        field<&P::weight_kinematics_nh_ratio>({0, 1e6}, "of going along arcs"),
        field<&P::weight_kinematics_forward_drive_ratio>({0, 1e6}, "of going ahead"),
        field<&P::weight_optimaltime_ratio>({0, 1e6}, "of the time"),
        field<&P::weight_obstacle_ratio>({0, 1e6}, "of min_obstacle_dist_m"),
        field<&P::weight_inflation_ratio>({0, 1e6}, "of inflation_dist_m"),
        field<&P::weight_dynamic_obstacle_ratio>({0, 1e6}, "of min_obstacle_dist_m from what moves"),
        field<&P::weight_dynamic_obstacle_inflation_ratio>({0, 1e6}, "of the inflation of what moves"),
        field<&P::weight_adapt_factor_ratio>({1, 100},
                                             "grows weight_obstacle_ratio, adaptation by adaptation"),
        field<&P::enable_homotopy_class_planning>("bands on several sides of the obstacles at once"),
        field<&P::max_number_classes_count>({1, 50}, "bands at most"),
        field<&P::roadmap_graph_no_samples_count>({0, 100}, "points of the graph that looks for classes"),
        field<&P::roadmap_graph_area_width_m>({0.1, 1000}, "of the box they are drawn in"),
        field<&P::obstacle_heading_threshold_ratio>({0, 1}, "cosine to the goal that its edges exceed"),
        field<&P::h_signature_threshold_ratio>({0, 1}, "turns about what moves that count as a side"),
        field<&P::selection_cost_hysteresis_ratio>({0, 10}, "the last choice's cost counts this much"),
        field<&P::selection_prefer_initial_plan_ratio>({0, 10}, "that of the plan's own class this much"),
        field<&P::selection_obst_cost_scale_ratio>({0, 1e4}, "cost of obstacles in the choice of a band"),
        field<&P::robust>("no time between poses is allowed to vanish; not so in the original"),
    };
  }
};

}  // namespace fairway
