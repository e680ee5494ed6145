// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <vector>

#include "fairway/control/autopilot.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/dynamics/kinematic/kinematic.hpp"
#include "fairway/dynamics/sparus2/sparus2.hpp"

namespace fairway {
namespace {

constexpr double h = 0.05;  // [s]
const Water sea{.current_n = {0.1, -0.2, 0.0}, .density = 1000.0};

/// One RK4 step of the equations alone.
template <class M>
void rk4_step(benchmark::State& bench) {
  const M model{typename M::Params{}};
  VehicleState x;
  ActuatorValues u(3);
  u << 2.0, 3.0, 1.0;
  for (auto _ : bench) {
    x = rk4(model, x, u, sea, h);
    benchmark::DoNotOptimize(x);
  }
}
BENCHMARK(rk4_step<Sparus2>);
BENCHMARK(rk4_step<Kinematic>);

/// One step of a vehicle of the catalog: limits, lag and RK4.
void vehicle_step(benchmark::State& bench, std::string_view name) {
  Vehicle vehicle = builtin_vehicles().make(name);
  const ActuatorValues command =
      ActuatorValues::Constant(static_cast<Eigen::Index>(vehicle.actuators().size()), 2.0);
  for (auto _ : bench) {
    vehicle.step(command, sea, h);
    benchmark::DoNotOptimize(vehicle);
  }
}
BENCHMARK_CAPTURE(vehicle_step, sparus2, "sparus2");
BENCHMARK_CAPTURE(vehicle_step, kinematic, "kinematic");
BENCHMARK_CAPTURE(vehicle_step, minerva, "minerva");
BENCHMARK_CAPTURE(vehicle_step, minerva_transport, "minerva_transport");
BENCHMARK_CAPTURE(vehicle_step, otter, "otter");
BENCHMARK_CAPTURE(vehicle_step, remus100, "remus100");

/// The same of so many vehicles together, in lanes where it is more than one: still water; the time is of all
/// of them.
void together(benchmark::State& bench, std::string_view name) {
  std::vector<Vehicle> vehicles(static_cast<std::size_t>(bench.range(0)), builtin_vehicles().make(name));
  const Eigen::VectorXd command =
      Eigen::VectorXd::Constant(static_cast<Eigen::Index>(vehicles[0].actuators().size()), 2.0);
  std::vector<Vehicle::Errand> errands;
  for (Vehicle& vehicle : vehicles) errands.push_back({&vehicle, &command, Water{}});
  for (auto _ : bench) {
    Vehicle::step_many(errands, h);
    benchmark::DoNotOptimize(vehicles.data());
  }
}
BENCHMARK_CAPTURE(together, sparus2, "sparus2")->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(together, kinematic, "kinematic")->Arg(1)->Arg(2)->Arg(4)->Arg(8);
BENCHMARK_CAPTURE(together, otter, "otter")->Arg(1)->Arg(2)->Arg(4)->Arg(8);

/// One call of the autopilot, the request below (0.5 m/s) or far above (5 m/s) what thrusters give.
void autopilot_call(benchmark::State& bench, std::string_view name, double surge_mps) {
  const Vehicle vehicle = builtin_vehicles().make(name);
  Autopilot autopilot{vehicle};
  const BodyRequest request{.surge_mps = surge_mps, .heave_mps = 0.2, .yaw_rate_radps = 0.2};
  const Vec3 v_b{0.3, 0.01, 0.1}, omega_b{0.0, 0.0, 0.1};
  for (auto _ : bench) benchmark::DoNotOptimize(autopilot.control(request, v_b, omega_b, h));
}
BENCHMARK_CAPTURE(autopilot_call, sparus2, "sparus2", 0.5);
BENCHMARK_CAPTURE(autopilot_call, sparus2_saturated, "sparus2", 5.0);
BENCHMARK_CAPTURE(autopilot_call, minerva_transport, "minerva_transport", 0.5);
BENCHMARK_CAPTURE(autopilot_call, minerva_transport_saturated, "minerva_transport", 5.0);
BENCHMARK_CAPTURE(autopilot_call, kinematic, "kinematic", 0.5);

}  // namespace
}  // namespace fairway
