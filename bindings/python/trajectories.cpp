// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/trajectories.hpp"

#include <utility>

#include "bindings/python/values.hpp"

namespace fairway::python {
namespace {

/// `fairway.Trajectories`.
struct Trajectories {
  py::array times, positions, velocities, quaternions, yaws, commands, goals, powers, modes, phases;
};

void append(std::vector<double>& column, const Vec3& v) {
  column.insert(column.end(), v.data(), v.data() + 3);
}

}  // namespace

void TrajectoryColumns::write(const Frame& frame) {
  vehicles_ = frame.vehicles.size();
  times_.push_back(frame.time);
  for (const VehicleFrame& vehicle : frame.vehicles) {
    const VehicleState& x = vehicle.state;
    append(positions_, x.p_n);
    append(velocities_, x.v_n());
    quaternions_.insert(quaternions_.end(), {x.q_nb.w(), x.q_nb.x(), x.q_nb.y(), x.q_nb.z()});
    yaws_.push_back(yaw_of(x.q_nb));
    append(commands_, vehicle.command.velocity);
    append(goals_, vehicle.goal);
    powers_.push_back(vehicle.power);
    modes_.push_back(static_cast<std::uint8_t>(vehicle.command.mode));
    phases_.push_back(static_cast<std::uint8_t>(vehicle.phase));
  }
}

py::object TrajectoryColumns::take() {
  const auto frames = static_cast<py::ssize_t>(times_.size());
  const auto vehicles = static_cast<py::ssize_t>(vehicles_);
  return py::cast(Trajectories{.times = owned_array(std::move(times_), {frames}),
                               .positions = owned_array(std::move(positions_), {frames, vehicles, 3}),
                               .velocities = owned_array(std::move(velocities_), {frames, vehicles, 3}),
                               .quaternions = owned_array(std::move(quaternions_), {frames, vehicles, 4}),
                               .yaws = owned_array(std::move(yaws_), {frames, vehicles}),
                               .commands = owned_array(std::move(commands_), {frames, vehicles, 3}),
                               .goals = owned_array(std::move(goals_), {frames, vehicles, 3}),
                               .powers = owned_array(std::move(powers_), {frames, vehicles}),
                               .modes = owned_array(std::move(modes_), {frames, vehicles}),
                               .phases = owned_array(std::move(phases_), {frames, vehicles})});
}

void bind_trajectories(py::module_& m) {
  py::enum_<Phase>(m, "Phase", "Where a vehicle is in its mission.")
      .value("deploying", Phase::deploying, "on its way to its rendezvous, or on a leg without avoidance")
      .value("waiting", Phase::waiting, "at the rendezvous, for the others")
      .value("under_way", Phase::under_way, "on a transit, avoiding")
      .value("stuck", Phase::stuck, "under way for longer than the exam allows, and still trying")
      .value("arrived", Phase::arrived, "mission done; holds its position");
  using T = Trajectories;
  py::class_<T>(m, "Trajectories", "What moved, as arrays of frames x vehicles that cannot be written.")
      .def_readonly("times", &T::times, "of the frames [s]")
      .def_readonly("positions", &T::positions, "frames x vehicles x 3 [m, NED]")
      .def_readonly("velocities", &T::velocities, "over ground, frames x vehicles x 3 [m/s, NED]")
      .def_readonly("quaternions", &T::quaternions, "body to NED: w, x, y, z, frames x vehicles x 4")
      .def_readonly("yaws", &T::yaws, "frames x vehicles [rad], 0 north, positive to east")
      .def_readonly("commands", &T::commands, "velocities decided, frames x vehicles x 3 [m/s, NED]")
      .def_readonly("goals", &T::goals, "of the present legs, frames x vehicles x 3 [m, NED]")
      .def_readonly("powers", &T::powers, "drawn by the actuators, frames x vehicles [W]")
      .def_readonly("modes", &T::modes, "of the commands, frames x vehicles, as numbers: Mode(n)")
      .def_readonly("phases", &T::phases, "of the missions, frames x vehicles, as numbers: Phase(n)")
      .def("__len__", [](const T& self) { return self.times.shape(0); })
      .def("__repr__", [](const T& self) {
        return "<Trajectories: " + std::to_string(self.times.shape(0)) + " frames of " +
               std::to_string(self.yaws.shape(1)) + " vehicles>";
      });
}

}  // namespace fairway::python
