// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "fairway/avoidance/avoider.hpp"
#include "fairway/avoidance/testing/encounters.hpp"
#include "fairway/core/angles.hpp"

/// The transport of rehman2021 in the horizontal plane, small enough to hold printed numbers against: four
/// vehicles set radially round a payload, about the payload's centre.
namespace fairway::transport {

/// North, east, yaw, surge, sway, yaw rate [m, rad, m/s, rad/s].
using State = Eigen::Matrix<double, 6, 1>;

struct Plant {
  double mass = 4800.0;      ///< rigid body and added, surge and sway alike [kg]
  double inertia = 16285.0;  ///< [kg m2]
  double damping = 140.0;    ///< linear, surge and sway alike [kg/s]
  double yaw_damping = 1018.0;
  bool coriolis = false;  ///< C(nu) nu of the mass above

  State derivative(const State& x, const Wrench& tau) const {
    const double u = x[3], v = x[4], r = x[5];
    const double c = std::cos(x[2]), s = std::sin(x[2]);
    const double turning = coriolis ? mass * r : 0.0;
    State rate;
    rate << c * u - s * v, s * u + c * v, r, (tau[0] - damping * u + turning * v) / mass,
        (tau[1] - damping * v - turning * u) / mass, (tau[5] - yaw_damping * r) / inertia;
    return rate;
  }

  State after(const State& x, const Wrench& tau, double h) const {
    const State a = derivative(x, tau);
    const State b = derivative(x + h / 2 * a, tau);
    const State c = derivative(x + h / 2 * b, tau);
    const State d = derivative(x + h * c, tau);
    return x + h / 6 * (a + 2 * b + 2 * c + d);
  }

  OnboardModel onboard() const {
    OnboardModel model;
    model.mass << mass, mass, mass, inertia, inertia, inertia;
    model.linear_damping << damping, damping, damping, yaw_damping, yaw_damping, yaw_damping;
    model.least << -770.0, -770.0, 0.0, 0.0, 0.0, -865.0;  // at 1200 rpm
    model.greatest << 770.0, 770.0, 0.0, 0.0, 0.0, 1351.0;
    return model;
  }
};

using encounters::sphere;

/// One obstacle of 20 m at (50, 40), to (100, 100) (section IV-A).
struct Course {
  Plant plant;
  std::vector<Obstacle> obstacles{sphere(50, 40, 20)};
  Vec3 goal{100, 100, 0};
  double step = 0.02;
  double duration = 350.0;

  /// Four obstacles of 1 m, to (22, 35) (section IV-B, Table 5).
  static Course of_four(Plant plant) {
    return {plant,
            {sphere(10, 12, 1), sphere(20, 20, 1), sphere(10, 33, 1), sphere(20, 30, 1)},
            {22, 35, 0},
            0.02,
            400.0};
  }

  Situation situation(const State& x, double time, const OnboardModel& model) const {
    const Eigen::Vector2d v = Eigen::Rotation2Dd(x[2]) * x.segment<2>(3);
    return {.time = time,
            .period = step,
            .own = {.position = {x[0], x[1], 0.0},
                    .velocity = {v.x(), v.y(), 0.0},
                    .yaw = wrap_angle(x[2]),
                    .yaw_rate = x[5],
                    .radius = 3.2},
            .goal = {.position = goal, .cruise_speed = 1.0, .velocity = {}},
            .limits = {},
            .model = &model,
            .tracks = {},
            .obstacles = obstacles};
  }

  /// How far the centre is from the centre of the nearest obstacle, less its radius [m].
  double clearance(const State& x) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Obstacle& o : obstacles)
      least = std::fmin(least, (o.position - Vec3{x[0], x[1], 0.0}).norm() - o.radius);
    return least;
  }
};

/// What a run came to.
struct Voyage {
  State end;
  Wrench first = Wrench::Zero();  ///< the first wrench
  Wrench greatest = Wrench::Constant(-1e9);
  Wrench least = Wrench::Constant(1e9);
  State at_first_avoidance = State::Constant(-1e9);
  double clearance = 1e9;  ///< of the centre, see Course::clearance [m]
  double energy = 0.0;     ///< integral of |tau . nu| [J]
  double arrival = -1.0;   ///< first within 1 m of the goal [s]
  int avoided = 0;         ///< decisions that were not Mode::cruise
  int infeasible = 0;

  double displacement() const { return end.head<2>().norm(); }
};

/// The wrench that carries out a command in a state.
using Helmsman = Wrench (*)(const Command&, const Course&, const State&);

inline Wrench wrench_of(const Command& command, const Course&, const State&) {
  return command.wrench.value_or(Wrench::Zero());
}

inline Voyage run(Avoider avoider, const Course& course, Helmsman helmsman = wrench_of) {
  Voyage run;
  const OnboardModel model = course.plant.onboard();
  State x = State::Zero();
  const int steps = static_cast<int>(std::lround(course.duration / course.step));
  for (int k = 0; k < steps; ++k) {
    const double time = k * course.step;
    const Command command = avoider.decide(course.situation(x, time, model));
    const Wrench tau = helmsman(command, course, x);
    if (k == 0) run.first = tau;
    if (command.mode != Mode::cruise && run.avoided++ == 0) run.at_first_avoidance = x;
    run.infeasible += command.mode == Mode::infeasible ? 1 : 0;
    run.greatest = run.greatest.cwiseMax(tau);
    run.least = run.least.cwiseMin(tau);
    run.clearance = std::fmin(run.clearance, course.clearance(x));
    run.energy += course.step * (std::abs(tau[0] * x[3]) + std::abs(tau[1] * x[4]) + std::abs(tau[5] * x[5]));
    const double to_goal = (course.goal.head<2>() - x.head<2>()).norm();
    if (run.arrival < 0.0 && to_goal <= 1.0) run.arrival = time;
    x = course.plant.after(x, tau, course.step);
  }
  run.end = x;
  return run;
}

}  // namespace fairway::transport
