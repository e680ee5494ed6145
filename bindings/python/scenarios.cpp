// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/scenarios.hpp"

#include <fstream>
#include <sstream>
#include <utility>

#include "bindings/python/bindings.hpp"
#include "bindings/python/value_class.hpp"
#include "fairway/core/text.hpp"

namespace fairway::python {
namespace {

/// A value as YAML, in one line.
std::string flow_yaml(const py::handle& value, const std::string& path, bool nested) {
  if (py::isinstance<py::array>(value)) return flow_yaml(value.attr("tolist")(), path, nested);
  if (value.is_none()) return "null";
  if (py::isinstance<py::bool_>(value)) return py::cast<bool>(value) ? "true" : "false";
  if (py::isinstance<py::str>(value)) {
    if (!nested) return py::cast<std::string>(value);
    return py::module_::import("json").attr("dumps")(value).cast<std::string>();
  }
  if (py::isinstance<py::int_>(value)) return py::str(value).cast<std::string>();
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value)) {
    std::string text;
    for (const py::handle item : value) text += (text.empty() ? "" : ", ") + flow_yaml(item, path, true);
    return "[" + text + "]";
  }
  if (py::isinstance<py::dict>(value)) {
    std::string text;
    for (const auto& [key, item] : py::reinterpret_borrow<py::dict>(value))
      text += (text.empty() ? "" : ", ") + flow_yaml(key, path, true) + ": " + flow_yaml(item, path, true);
    return "{" + text + "}";
  }
  return number_text(Read<double>::from(value, path));
}

py::dict params_dict(const Choice& choice) {
  py::dict all;
  for (const auto& [name, value] : choice.params) all[py::str(name)] = shown(value);
  return all;
}

std::optional<std::uint64_t> seed_of(const py::object& given) {
  if (given.is_none()) return std::nullopt;
  return Read<std::uint64_t>::from(given, "seed");
}

void bind_leg(py::module_& m) {
  ValueClass<Leg>(m, "Leg", "One leg of a mission.\n")
      .field("kind", &Leg::kind, "'go_to', 'keep_position', 'section', 'rendezvous' or 'transit'")
      .field("position", &Leg::position, "of the goal [m, NED]")
      .field("start", &Leg::from, "of a section [m, NED]")
      .field("speed_mps", &Leg::speed_mps, "along the leg [m/s]")
      .field("box_m", &Leg::box_m, "arrival when |error| <= box on every axis (go_to, section) [m]")
      .field("arrival_m", &Leg::arrival_m, "arrival when the distance is at most this [m]")
      .field("duration_s", &Leg::duration_s, "of keep_position [s]")
      .finish();
}

void bind_scenario_vehicle(py::module_& m) {
  using V = VehicleSpec;
  py::class_<V>(m, "ScenarioVehicle", "One vehicle of a scenario, as drawn.")
      .def_readonly("id", &V::id, "of the vehicle")
      .def_readonly("name", &V::name, "of the vehicle")
      .def_property_readonly(
          "model", [](const V& v) { return v.model->name; }, "of vehicles()")
      .def_property_readonly(
          "model_params", [](const V& v) { return params_dict(v.model); }, "as written")
      .def_property_readonly(
          "algorithm", [](const V& v) { return v.avoider->name; }, "of algorithms()")
      .def_property_readonly(
          "algorithm_params", [](const V& v) { return params_dict(v.avoider); }, "as written")
      .def_readonly("position", &V::position, "at the start [m, NED]")
      .def_readonly("yaw", &V::yaw, "at the start [rad]")
      .def_readonly("speed", &V::speed, "surge at the start [m/s]")
      .def_readonly("start_delay_s", &V::start_delay_s, "before the mission begins [s]")
      .def_readonly("radius_m", &V::radius_m, "of the sphere that others keep clear of [m]")
      .def_readonly("priority", &V::priority, "the smaller number has the right of way")
      .def_readonly("cooperative", &V::cooperative, "False: it tells nobody anything")
      .def_readonly("limits", &V::limits, "Limits")
      .def_property_readonly(
          "mission", [](const py::object& self) { return show(self.cast<const V&>().mission, self); },
          "of Leg")
      .def("__repr__", [](const V& v) {
        return "<ScenarioVehicle " + v.name + ": " + v.model->name + " under " + v.avoider->name + ">";
      });
}

void add_reading(py::class_<ScenarioText>& scenario) {
  scenario
      .def_static(
          "load",
          [](const py::object& file, const py::object& overrides, const py::object& seed) {
            return ScenarioText::load(path_of(file), overrides_of(overrides), seed_of(seed));
          },
          py::arg("file"), py::arg("overrides") = py::none(), py::arg("seed") = py::none(),
          "Reads a scenario file. Values that are distributions are drawn from seed, or else from the "
          "file's. overrides, {'vehicles[*].avoider.time_horizon_s': 8}, are put over what the file says, as "
          "by `fairway run --set`. Raises InputError with file, line, column and the nearest known name.")
      .def_static(
          "parse",
          [](const std::string& text, const py::object& overrides, const py::object& seed, std::string file) {
            return ScenarioText{text, std::move(file), overrides_of(overrides), seed_of(seed)};
          },
          py::arg("text"), py::arg("overrides") = py::none(), py::arg("seed") = py::none(),
          py::arg("file") = "<text>", "The same from YAML text; file is what messages call it.")
      .def_static("schema", &scenario_schema, "The JSON schema (draft 2020-12) of scenario files.")
      .def(
          "to_yaml", [](const ScenarioText& s) { return to_yaml(s.scenario()); },
          "The case as drawn, as YAML that reads back to the same bits.")
      .def(
          "with_seed",
          [](const ScenarioText& s, const py::object& seed) {
            return s.with_seed(Read<std::uint64_t>::from(seed, "seed"));
          },
          py::arg("seed"), "The case of another seed, distributions drawn anew.")
      .def(
          "with_overrides",
          [](const ScenarioText& s, const py::object& overrides) {
            return s.with_overrides(overrides_of(overrides));
          },
          py::arg("overrides"), "The same under further overrides: {'path': value}, as load takes them.")
      .def(
          "with_algorithm",
          [](const ScenarioText& s, const std::string& name, const py::kwargs& params) {
            return s.with_algorithm(name, param_values(params));
          },
          py::arg("name"),
          "Every vehicle under this algorithm, of algorithms() or one's own, with these parameters. What the "
          "file says of parameters stays where a vehicle has the same algorithm already.");
}

}  // namespace

std::string path_of(const py::object& given) {
  try {
    return py::cast<std::string>(py::module_::import("os").attr("fspath")(given));
  } catch (const py::error_already_set&) {
    refuse("file", "a path", given);
  } catch (const py::cast_error&) {
    refuse("file", "a path of text", given);
  }
}

Overrides overrides_of(const py::object& given) {
  Overrides all;
  if (given.is_none()) return all;
  if (!py::isinstance<py::dict>(given)) refuse("overrides", "a dict of paths and values", given);
  for (const auto& [key, value] : py::reinterpret_borrow<py::dict>(given)) {
    const std::string path = Read<std::string>::from(key, "overrides");
    all.emplace_back(path, flow_yaml(value, path, false));
  }
  return all;
}

ScenarioText scenario_of(const py::object& given) {
  if (py::isinstance<ScenarioText>(given)) return given.cast<ScenarioText>();
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"))
    return ScenarioText::load(path_of(given), {}, {});
  refuse("scenario", "a Scenario or the path of a file", given);
}

ScenarioText::ScenarioText(const std::string& yaml, std::string file, Overrides overrides,
                           std::optional<std::uint64_t> seed)
    : file_{std::move(file)},
      document_{yaml, file_},
      overrides_{std::move(overrides)},
      seed_{seed},
      scenario_{read(seed_)} {}

ScenarioText ScenarioText::load(const std::string& file, Overrides overrides,
                                std::optional<std::uint64_t> seed) {
  load_scenario(file, overrides, seed);  // says what is wrong with a file that is none
  std::ifstream stream{file, std::ios::binary};
  std::ostringstream text;
  text << stream.rdbuf();
  return {text.str(), file, std::move(overrides), seed};
}

Scenario ScenarioText::read(std::optional<std::uint64_t> seed) const {
  Scenario scenario = document_.scenario(overrides_, seed);
  if (algorithm_.empty()) return scenario;
  for (VehicleSpec& vehicle : scenario.vehicles) {
    if (vehicle.avoider->name == algorithm_) {
      vehicle.avoider.edit().params = merged(vehicle.avoider->params, params_);
      vehicle.avoider.edit().param_where.clear();
    } else {
      vehicle.avoider = Choice{
          .name = algorithm_, .params = params_, .path = "with_algorithm", .where = {}, .param_where = {}};
    }
  }
  return scenario;
}

Scenario ScenarioText::drawn(std::uint64_t seed) const { return read(seed); }

ScenarioText ScenarioText::with_seed(std::uint64_t seed) const {
  ScenarioText other = *this;
  other.seed_ = seed;
  other.scenario_ = other.read(other.seed_);
  return other;
}

ScenarioText ScenarioText::with_overrides(const Overrides& overrides) const {
  ScenarioText other = *this;
  other.overrides_.insert(other.overrides_.end(), overrides.begin(), overrides.end());
  other.scenario_ = other.read(other.seed_);
  return other;
}

ScenarioText ScenarioText::with_algorithm(const std::string& name, const ParamValues& params) const {
  ScenarioText other = *this;
  other.algorithm_ = name;
  other.params_ = params;
  other.scenario_ = other.read(other.seed_);
  return other;
}

void bind_scenarios(py::module_& m) {
  bind_leg(m);
  bind_scenario_vehicle(m);
  using S = ScenarioText;
  py::class_<S> scenario{m, "Scenario",
                         "One concrete case: vehicles, missions, obstacles and water, everything random "
                         "drawn. Made by load or parse; never changed."};
  add_reading(scenario);
  const auto read = [&scenario](const char* name, auto member, const char* doc) {
    scenario.def_property_readonly(
        name, [member](const S& s) { return s.scenario().*member; }, doc);
  };
  read("name", &Scenario::name, "of the scenario");
  read("summary", &Scenario::summary, "one line");
  read("seed", &Scenario::seed, "that everything random is drawn from");
  read("step_s", &Scenario::step_s, "the control period and the integration step [s]");
  read("steps_per_decision", &Scenario::steps_per_decision, "avoiders decide at every so many steps");
  read("duration_s", &Scenario::duration_s, "the run ends here at the latest [s]");
  scenario
      .def_property_readonly(
          "vehicles",
          [](const py::object& self) { return show(self.cast<const S&>().scenario().vehicles, self); },
          "of ScenarioVehicle, by index")
      .def_property_readonly(
          "obstacles",
          [](const py::object& self) { return show(self.cast<const S&>().scenario().obstacles, self); },
          "of Obstacle")
      .def_property_readonly(
          "crit_dist_m", [](const S& s) { return s.scenario().exam.crit_dist_m; },
          "a neighbour this near is detected [m]")
      .def_property_readonly(
          "safety_distance_m", [](const S& s) { return s.scenario().exam.safety_distance_m; },
          "centres this near have collided [m]")
      .def("__repr__", [](const S& s) {
        return "<Scenario " + s.scenario().name + ": " + std::to_string(s.scenario().vehicles.size()) +
               " vehicles, seed " + std::to_string(s.scenario().seed) + ">";
      });
}

}  // namespace fairway::python
