// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <sstream>

#include "bindings/python/bindings.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/value_class.hpp"
#include "fairway/core/text.hpp"
#include "fairway/dynamics/catalog.hpp"
#include "fairway/sim/trial.hpp"

namespace fairway::python {
namespace {

const VehicleCatalog& offered_vehicles() {
  static const VehicleCatalog catalog = builtin_vehicles();
  return catalog;
}

/// `fairway.State`: plain members, so that it may be made by keywords.
struct StateValue {
  Vec3 position = Vec3::Zero();
  Eigen::Vector4d quaternion{1, 0, 0, 0};  ///< w, x, y, z
  Vec3 velocity = Vec3::Zero();
  Vec3 angular_velocity = Vec3::Zero();

  static StateValue of(const VehicleState& x) {
    return {x.p_n, {x.q_nb.w(), x.q_nb.x(), x.q_nb.y(), x.q_nb.z()}, x.v_b, x.omega_b};
  }
  VehicleState state() const {
    return {
        position, {quaternion[0], quaternion[1], quaternion[2], quaternion[3]}, velocity, angular_velocity};
  }
};

void check_finite(const StateValue& s) {
  for (const auto& [name, part] : {std::pair{"position", s.position}, std::pair{"velocity", s.velocity},
                                   std::pair{"angular_velocity", s.angular_velocity}}) {
    if (!is_finite(part)) throw InputError(std::string("State.") + name + ": is not finite");
  }
}

void bind_state(py::module_& m) {
  using S = StateValue;
  const auto settle = [](S& s, const py::dict&) {
    if (!(std::abs(s.quaternion.norm() - 1.0) < 1e-6))
      throw InputError("State.quaternion: expected length 1, got " + number_text(s.quaternion.norm()));
    check_finite(s);
  };
  ValueClass<S>(m, "State", "Where a vehicle is and how it moves: Fossen's eta and nu.\n")
      .field("position", &S::position, "of the body origin [m, NED]")
      .field("quaternion", &S::quaternion, "body to NED: w, x, y, z, of length 1")
      .field("velocity", &S::velocity, "u, v, w over ground [m/s, body]")
      .field("angular_velocity", &S::angular_velocity, "p, q, r [rad/s, body]")
      .finish(settle)
      .def_property_readonly(
          "roll", [](const S& s) { return euler_of(s.state().q_nb).roll; }, "[rad]")
      .def_property_readonly(
          "pitch", [](const S& s) { return euler_of(s.state().q_nb).pitch; }, "[rad], positive nose up")
      .def_property_readonly(
          "yaw", [](const S& s) { return yaw_of(s.state().q_nb); }, "[rad], 0 north, positive to east")
      .def_property_readonly(
          "velocity_ned", [](const S& s) { return s.state().v_n(); }, "over ground [m/s, NED]")
      .def_static(
          "level",
          [](const py::object& position, double yaw, double surge) {
            if (!std::isfinite(yaw))
              throw InputError("yaw: expected a finite number, got " + number_text(yaw));
            S level;
            level.position = Read<Vec3>::from(position, "position");
            const Eigen::Quaterniond q = quaternion_of({.yaw = yaw});
            level.quaternion = {q.w(), q.x(), q.y(), q.z()};
            level.velocity.x() = surge;
            check_finite(level);
            return level;
          },
          py::arg("position"), py::arg("yaw") = 0.0, py::arg("surge") = 0.0,
          "Level at position [m, NED], heading for yaw [rad], moving ahead by surge [m/s].");
}

void bind_infos(py::module_& m) {
  using A = ActuatorInfo;
  py::class_<A>(m, "Actuator", "A thruster, rudder or setpoint that a vehicle is driven by.")
      .def_readonly("name", &A::name, "ends in its unit: 'surge_port_n'")
      .def_readonly("meaning", &A::meaning, "what it does")
      .def_property_readonly(
          "low", [](const A& a) { return a.range.lo; }, "hard limit")
      .def_property_readonly(
          "high", [](const A& a) { return a.range.hi; }, "hard limit")
      .def_readonly("time_constant_s", &A::time_constant_s, "of the lag from command to state [s]; 0: none")
      .def("__repr__", [](const A& a) { return "<Actuator " + a.name + ": " + a.meaning + ">"; });
  using E = VehicleCatalog::Entry;
  py::class_<E>(m, "VehicleInfo", "What there is to say of a vehicle.")
      .def_property_readonly(
          "name", [](const E& e) { return e.info.name; }, "as written in a scenario, and for Vehicle")
      .def_property_readonly(
          "title", [](const E& e) { return e.info.title; }, "in full")
      .def_property_readonly(
          "source", [](const E& e) { return e.info.source; }, "where its numbers are from")
      .def_property_readonly(
          "parameters", [](const E& e) { return parameters(e.params); }, "of Parameter")
      .def("__repr__", [](const E& e) {
        return "<VehicleInfo " + std::string(e.info.name) + ": " + std::string(e.info.title) + ">";
      });
  m.def(
      "vehicles",
      [] {
        const auto entries = offered_vehicles().entries();
        return std::vector<E>{entries.begin(), entries.end()};
      },
      "Every vehicle that comes with fairway, as a list of VehicleInfo.");
}

/// By name, what is not named staying where it is; or one number each.
ActuatorValues actuator_values(const Vehicle& vehicle, const py::object& given) {
  const auto actuators = vehicle.actuators();
  const auto count = static_cast<py::ssize_t>(actuators.size());
  ActuatorValues values =
      ActuatorValues::Constant(static_cast<Eigen::Index>(count), std::numeric_limits<double>::quiet_NaN());
  if (!py::isinstance<py::dict>(given)) {
    const DoubleArray array = numbers(given, {count}, "actuators");
    std::copy_n(array.data(), count, values.data());
    return values;
  }
  for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given)) {
    const std::string name = Read<std::string>::from(key, "actuators");
    std::vector<std::string_view> known;
    for (const ActuatorInfo& actuator : actuators) known.emplace_back(actuator.name);
    const auto found = std::ranges::find(known, name);
    if (found == known.end()) throw InputError({}, name, "unknown actuator" + suggestion(name, known));
    values[found - known.begin()] = Read<double>::from(value, name);
  }
  return values;
}

Water water_of(const py::object& current, double density) {
  const Vec3 current_n = Read<Vec3>::from(current, "current");
  if (!is_finite(current_n)) refuse("current", "three finite numbers", current);
  if (!(density > 0.0 && std::isfinite(density)))
    throw InputError("density: expected kg/m3 above 0, got " + number_text(density));
  return {.current_n = current_n, .density = density};
}

void check_period(double period) {
  if (!(period > 0.0 && std::isfinite(period)))
    throw InputError("period: expected seconds above 0, got " + number_text(period));
}

constexpr py::ssize_t state_columns = 13;

/// A step for every row of commands; the states, the first before any, as rows.
py::array drive(Vehicle& vehicle, const py::object& commands, double period, const Water& water) {
  check_period(period);
  const auto columns = static_cast<py::ssize_t>(vehicle.actuators().size());
  const DoubleArray array = DoubleArray::ensure(commands);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != 2 || array.shape(1) != columns)
    refuse("commands", "rows of " + std::to_string(columns) + " numbers, one for each actuator", commands);
  const py::ssize_t steps = array.shape(0);
  std::vector<double> states;
  states.reserve(static_cast<std::size_t>((steps + 1) * state_columns));
  const auto keep = [&] {
    const VehicleState& x = vehicle.state();
    const StateValue s = StateValue::of(x);
    for (const auto& part : {Eigen::VectorXd{s.position}, Eigen::VectorXd{s.quaternion},
                             Eigen::VectorXd{s.velocity}, Eigen::VectorXd{s.angular_velocity}})
      states.insert(states.end(), part.data(), part.data() + part.size());
  };
  keep();
  for (py::ssize_t i = 0; i < steps; ++i) {
    vehicle.step(Eigen::Map<const Eigen::VectorXd>(array.data() + i * columns, columns), water, period);
    keep();
  }
  return owned_array(std::move(states), {steps + 1, state_columns});
}

void bind_vehicle(py::module_& m) {
  using V = Vehicle;
  py::class_<V>(m, "Vehicle",
                "A vehicle model with its state and that of its actuators. copy.copy is a snapshot.")
      .def(py::init([](const std::string& name, const py::kwargs& params) {
             return offered_vehicles().make(name, param_values(params));
           }),
           py::arg("name"),
           "name as vehicles() has it, parameters by keyword. Raises InputError with the nearest name.")
      .def_property_readonly(
          "name", [](const V& v) { return v.info().name; }, "of the model")
      .def_property_readonly(
          "actuators",
          [](const V& v) {
            return std::vector<ActuatorInfo>{v.actuators().begin(), v.actuators().end()};
          },
          "of Actuator, in order")
      .def_property(
          "state", [](const V& v) { return StateValue::of(v.state()); },
          [](V& v, const StateValue& s) {
            check_finite(s);
            v.set_state(s.state());
          },
          "State")
      .def_property(
          "actuator_state", [](const V& v) { return Eigen::VectorXd{v.actuator_state()}; },
          [](V& v, const py::object& given) { v.set_actuator_state(actuator_values(v, given)); },
          "One number for each actuator. Set, also from a dict, it is there at once, within limits, without "
          "lag.")
      .def_property_readonly("power", &V::power, "drawn by the actuators at their present state [W]")
      .def(
          "step",
          [](V& v, const py::object& actuators, double period, const py::object& current, double density) {
            check_period(period);
            v.step(actuator_values(v, actuators), water_of(current, density), period);
            return StateValue::of(v.state());
          },
          py::arg("actuators"), py::arg("period"), py::arg("current") = py::make_tuple(0.0, 0.0, 0.0),
          py::arg("density") = 1000.0,
          "Lets the actuators follow these, a dict by name or one number each (NaN or not named: stays), and "
          "moves by period [s] in water that flows with current [m/s, NED]: one step of fourth order. The "
          "new State.")
      .def(
          "drive",
          [](V& v, const py::object& commands, double period, const py::object& current, double density) {
            return drive(v, commands, period, water_of(current, density));
          },
          py::arg("commands"), py::arg("period"), py::arg("current") = py::make_tuple(0.0, 0.0, 0.0),
          py::arg("density") = 1000.0,
          "A step for every row of commands (n x actuators). The states before and after each, (n + 1) x 13: "
          "position [m, NED], quaternion w x y z, velocity [m/s, body], angular velocity [rad/s, body].")
      .def("__copy__", [](const V& v) { return V{v}; })
      .def("__deepcopy__", [](const V& v, const py::object&) { return V{v}; })
      .def("__repr__", [](const V& v) { return "<Vehicle " + std::string(v.info().name) + ">"; });
}

// ---- trials: through the text of the command, whose numbers read back to the same bits

std::string trial_inputs(const py::object& times, const py::dict& inputs) {
  const DoubleArray time = DoubleArray::ensure(times);
  if (!time) PyErr_Clear();
  if (!time || time.ndim() != 1) refuse("times", "a row of numbers", times);
  std::vector<DoubleArray> columns{time};
  std::string text = "time_s";
  for (const auto& [key, value] : inputs) {
    const std::string name = Read<std::string>::from(key, "inputs");
    text += "," + name;
    columns.push_back(numbers(value, {time.shape(0)}, name));
  }
  text += "\n";
  for (py::ssize_t i = 0; i < time.shape(0); ++i) {
    for (std::size_t column = 0; column < columns.size(); ++column)
      text += (column == 0 ? "" : ",") + number_text(columns[column].at(i));
    text += "\n";
  }
  return text;
}

py::dict trial_outputs(std::istream& text) {
  std::string line, cell;
  std::getline(text, line);
  std::vector<std::string> names;
  std::istringstream header{line};
  while (std::getline(header, cell, ',')) names.push_back(cell);
  std::vector<std::vector<double>> columns(names.size());
  while (std::getline(text, line)) {
    std::istringstream row{line};
    for (auto& column : columns) {
      std::getline(row, cell, ',');
      column.push_back(std::get<double>(parse_value(cell)));
    }
  }
  py::dict all;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto rows = static_cast<py::ssize_t>(columns[i].size());
    all[py::str(names[i])] = owned_array(std::move(columns[i]), {rows});
  }
  return all;
}

}  // namespace

void bind_vehicles(py::module_& m) {
  bind_state(m);
  bind_infos(m);
  bind_vehicle(m);
  m.def(
      "trial",
      [](const std::string& vehicle, const py::object& times, const py::dict& inputs,
         const py::dict& settings) {
        std::istringstream in{trial_inputs(times, inputs)};
        std::stringstream out;
        run_trial(offered_vehicles(), vehicle, in, "inputs", out, param_values(settings));
        return trial_outputs(out);
      },
      py::arg("vehicle"), py::arg("times"), py::arg("inputs"), py::arg("settings") = py::dict(),
      "An open-loop manoeuvre, the same bits as `fairway trial`: times [s] ascending, inputs {actuator: "
      "values}, each held until the next time; settings {'state.u_mps': 0.5, 'current.north_mps': 0.2, "
      "'actuator_dynamics': True, ...}. Arrays by column: time_s, x_m, y_m, z_m, roll_rad, pitch_rad, "
      "yaw_rad, u_mps, v_mps, w_mps, p_radps, q_radps, r_radps, the state at each time. Raises InputError "
      "with the nearest name.");
}

}  // namespace fairway::python
