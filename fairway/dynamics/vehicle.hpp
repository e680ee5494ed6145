// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "fairway/dynamics/actuators.hpp"
#include "fairway/dynamics/fin_drive.hpp"
#include "fairway/dynamics/integrate.hpp"
#include "fairway/dynamics/lanes/side_by_side.hpp"
#include "fairway/dynamics/propulsion.hpp"
#include "fairway/dynamics/submerged_body.hpp"
#include "fairway/dynamics/vehicle_model.hpp"

namespace fairway {

/// A model that is a submerged body under a wrench of its actuators alone.
template <class M>
concept PushedBody = requires(const M& model, const ActuatorValues& u) {
  { model.body() } -> std::convertible_to<const SubmergedBody&>;
  { model.push(u) } -> std::same_as<lanes::PushOf<double>>;
};

/// Any vehicle model together with its state and the state of its actuators. A value: a copy is a snapshot,
/// which shares the model and how actuators lag in a step, since these are constant. step() neither throws
/// nor allocates, but the first one of another length that a copy makes.
class Vehicle {
 public:
  template <VehicleModel M>
  explicit Vehicle(M model)
      : self_{std::make_shared<const Model<M>>(std::move(model))}, actuators_{self_->actuators()} {}

  const VehicleInfo& info() const { return self_->info(); }
  std::span<const ActuatorInfo> actuators() const { return self_->actuators(); }

  /// How actuators push, for controllers; null where the actuators are setpoints (kinematic models) or push
  /// by the speed of the vehicle.
  const Propulsion* propulsion() const { return self_->propulsion(); }

  /// What steers a body with fins, for controllers; null for any other.
  const FinDrive* fin_drive() const { return self_->fin_drive(); }

  const VehicleState& state() const { return state_; }
  void set_state(const VehicleState& state) { state_ = state; }

  const Eigen::VectorXd& actuator_state() const { return actuators_.now(); }
  /// Puts the actuators there at once, within their limits, without lag. NaN leaves an actuator where it is.
  void set_actuator_state(const ActuatorValues& values) noexcept { actuators_.set(values); }

  /// Steps are `h` [s] from now on; copies made after that need nothing of their own for them.
  void prepare(double h) noexcept { actuators_.prepare(h); }

  /// Lets the actuators follow `command` (limits, first-order lag, exact over h; NaN leaves one where it
  /// is) and moves the vehicle by `h` [s] in `water`: one RK4 step with the actuators at their mean over h.
  void step(const ActuatorValues& command, const Water& water, double h) noexcept {
    self_->advance(state_, actuators_.follow(command, h), water, h);
  }

  /// What `step` is told, of one of several vehicles.
  struct Errand {
    Vehicle* vehicle;
    const Eigen::VectorXd* command;  ///< of its actuators
    Water water;
  };

  /// `step` of each, to the same bits: side by side those that come one after another, share their model, and
  /// whose model can (lanes/kernel.hpp).
  static void step_many(std::span<const Errand> errands, double h) noexcept {
    while (!errands.empty()) {
      const auto& [vehicle, command, water] = errands.front();
      const Interface& model = *vehicle->self_;
      const auto other =
          std::ranges::find_if(errands, [&](const Errand& e) { return e.vehicle->self_.get() != &model; });
      const auto alike = static_cast<std::size_t>(other - errands.begin());
      if (alike == 1) {  // in a lane it would take longer
        vehicle->step(*command, water, h);
      } else {
        model.advance_many(errands.first(alike), h);
      }
      errands = errands.subspan(alike);
    }
  }

  /// Moves the vehicle with the actuators held where they are.
  void drift(const Water& water, double h) noexcept { self_->advance(state_, actuators_.now(), water, h); }

  /// How fast `x` would change with the actuators at `u`: the model's equations, of any state.
  StateRate rate(const VehicleState& x, const ActuatorValues& u, const Water& water) const noexcept {
    return self_->rate(x, u, water);
  }

  /// Drawn by the actuators at their present state [W].
  double power() const noexcept { return self_->power(actuators_.now()); }

 private:
  struct Interface {
    virtual ~Interface() = default;
    virtual const VehicleInfo& info() const = 0;
    virtual std::span<const ActuatorInfo> actuators() const = 0;
    virtual const Propulsion* propulsion() const = 0;
    virtual const FinDrive* fin_drive() const = 0;
    virtual void advance(VehicleState&, const ActuatorValues&, const Water&, double h) const noexcept = 0;
    virtual void advance_many(std::span<const Errand>, double h) const noexcept = 0;
    virtual StateRate rate(const VehicleState&, const ActuatorValues&, const Water&) const noexcept = 0;
    virtual double power(const ActuatorValues&) const noexcept = 0;
  };

  template <VehicleModel M>
  struct Model final : Interface {
    explicit Model(M m) : model{std::move(m)} {}
    const VehicleInfo& info() const override { return M::info; }
    std::span<const ActuatorInfo> actuators() const override { return model.actuators(); }
    const Propulsion* propulsion() const override {
      if constexpr (requires { model.propulsion(); }) return &model.propulsion();
      return nullptr;
    }
    const FinDrive* fin_drive() const override {
      if constexpr (requires { model.fin_drive(); }) return &model.fin_drive();
      return nullptr;
    }
    void advance(VehicleState& x, const ActuatorValues& u, const Water& water,
                 double h) const noexcept override {
      if constexpr (requires { model.advanced(x, u, water, h); }) {
        x = model.advanced(x, u, water, h);
      } else if constexpr (PushedBody<M>) {
        x = model.body().advanced(x, model.push(u), water, h);
      } else {
        x = rk4(model, x, u, water, h);
      }
    }
    void advance_many(std::span<const Errand> errands, double h) const noexcept override {
      const lanes::MotionKernel& kernel = lanes::motion_kernel_for(errands.size());
      if constexpr (PushedBody<M>) {
        go(errands, h, SideBySide{model.body(), h, kernel},
           [&](const ActuatorValues& u) { return model.push(u); });
      } else if constexpr (requires { typename M::SideBySide; }) {
        go(errands, h, typename M::SideBySide{model, h, kernel}, std::identity{});
      } else {
        for (const Errand& errand : errands) errand.vehicle->step(*errand.command, errand.water, h);
      }
    }
    static void go(std::span<const Errand> errands, double h, auto&& side_by_side,
                   const auto& under) noexcept {
      for (const Errand& errand : errands) {
        Vehicle& vehicle = *errand.vehicle;
        side_by_side.add(vehicle.state_, under(vehicle.actuators_.follow(*errand.command, h)), errand.water);
      }
      side_by_side.finish();
    }
    StateRate rate(const VehicleState& x, const ActuatorValues& u,
                   const Water& water) const noexcept override {
      return model.derivative(x, u, water);
    }
    double power(const ActuatorValues& u) const noexcept override { return model.power(u); }

    M model;
  };

  std::shared_ptr<const Interface> self_;
  VehicleState state_;
  Actuators actuators_;
};

}  // namespace fairway
