// SPDX-License-Identifier: Apache-2.0
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "bindings/python/bindings.hpp"
#include "bindings/python/fleet_environments.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/situations.hpp"
#include "bindings/python/values.hpp"

namespace fairway::python {
namespace {

using Actions = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Environments = FleetEnvironments;

RewardWeights reward_of(const py::dict& given) {
  RewardWeights weights;
  std::vector<std::string_view> known;
  for (const auto& member : RewardWeights::members) known.push_back(member.first);
  for (const auto& [key, value] : given) {
    const std::string name = py::str(key);
    const auto* const found = std::ranges::find(RewardWeights::members, std::string_view{name},
                                                [](const auto& member) { return member.first; });
    if (found == RewardWeights::members.end())
      throw InputError({}, "reward", "unknown weight \"" + name + "\"" + suggestion(name, known));
    const double weight =
        PyNumber_Check(value.ptr()) != 0 ? Read<double>::from(value, "reward." + name) : std::nan("");
    if (!std::isfinite(weight)) refuse("reward." + name, "a number that is finite", value);
    weights.*(found->second) = weight;
  }
  return weights;
}

Axes axes_of(const std::string& name) {
  if (name == "ned") return Axes::ned;
  if (name == "heading") return Axes::heading;
  throw InputError({}, "axes", "unknown \"" + name + "\"" + suggestion(name, {"ned", "heading"}));
}

/// Runs `work` without the interpreter's lock; what a user's algorithm raised comes out as itself.
template <class Work>
void released(Environments& self, Work work) {
  try {
    const py::gil_scoped_release unlocked;
    work();
  } catch (...) {
    self.rethrow();
    throw;
  }
}

/// A view of what the environments show, which is overwritten by the next step.
template <class V>
py::array view(const py::object& self, const std::vector<V>& values, std::vector<py::ssize_t> shape) {
  using Seen = std::conditional_t<std::is_same_v<V, std::uint8_t>, bool, V>;
  static_assert(sizeof(Seen) == sizeof(V));
  return py::array{py::dtype::of<Seen>(), std::move(shape), {}, values.data(), self};
}

enum class Dimensions : std::uint8_t { environments, learners, observations, actions };

std::vector<py::ssize_t> shape_of(const Environments& all, Dimensions dimensions) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(all.count())};
  if (dimensions != Dimensions::environments) shape.push_back(static_cast<py::ssize_t>(all.learner_count()));
  if (dimensions == Dimensions::observations)
    shape.push_back(static_cast<py::ssize_t>(all.observation_size()));
  if (dimensions == Dimensions::actions) shape.push_back(3);
  return shape;
}

template <class V>
void add_view(py::class_<Environments>& c, const char* name, std::vector<V> Environments::Shown::*member,
              Dimensions dimensions, const char* doc) {
  c.def_property_readonly(
      name,
      [member, dimensions](const py::object& self) {
        const auto& all = self.cast<const Environments&>();
        return view(self, all.shown().*member, shape_of(all, dimensions));
      },
      doc);
}

std::size_t checked(const Environments& all, std::size_t index) {
  if (index >= all.count())
    throw py::index_error("there are " + std::to_string(all.count()) + " environments, no number " +
                          std::to_string(index));
  return index;
}

py::object situation(Environments& all, std::size_t index, std::size_t row) {
  if (row >= all.learner_count())
    throw py::index_error("there are " + std::to_string(all.learner_count()) + " learners, no number " +
                          std::to_string(row));
  const std::optional<Situation> shown = all.at(checked(all, index)).situation(row);
  return shown ? py::cast(OwnedSituation{*shown}) : py::none();
}

py::dict measures(Environments& all, std::size_t index) {
  const FleetEnvironment& environment = all.at(checked(all, index));
  if (!environment.has_begun()) throw std::logic_error("no episode has begun: reset() begins one");
  const std::vector<Measure> list = environment.measures();
  const auto vehicles = static_cast<py::ssize_t>(environment.scenario().vehicles.size());
  py::dict found;
  for (const Measure& measure : list) {
    if (measure.vehicle == Measure::fleet) {
      found[py::str(measure.quantity)] = measure.value;
      continue;
    }
    if (!found.contains(measure.quantity)) found[py::str(measure.quantity)] = py::array_t<double>(vehicles);
    py::cast<py::array_t<double>>(found[py::str(measure.quantity)]).mutable_at(measure.vehicle) =
        measure.value;
  }
  return found;
}

/// Where vehicles are and want to be, and their radii.
py::tuple outline(Environments& all, std::size_t index) {
  const FleetEnvironment& environment = all.at(checked(all, index));
  if (!environment.has_begun()) throw std::logic_error("no episode has begun: reset() begins one");
  const std::span<const Agent> vehicles = environment.vehicles();
  const auto rows = static_cast<py::ssize_t>(vehicles.size());
  py::array_t<double> positions{{rows, py::ssize_t{3}}}, goals{{rows, py::ssize_t{3}}}, radii{rows};
  for (py::ssize_t i = 0; i < rows; ++i) {
    const Agent& vehicle = vehicles[static_cast<std::size_t>(i)];
    const Vec3& position = vehicle.vehicle.state().p_n;
    const Leg* leg = vehicle.mission.leg();
    const Vec3 goal = leg != nullptr ? leg->position : position;
    for (int axis = 0; axis < 3; ++axis) {
      positions.mutable_at(i, axis) = position[axis];
      goals.mutable_at(i, axis) = goal[axis];
    }
    radii.mutable_at(i) = vehicle.ship().radius;
  }
  return py::make_tuple(positions, goals, radii);
}

void reset(Environments& all, const std::optional<py::array_t<bool>>& chosen,
           const std::vector<std::optional<std::uint64_t>>& seeds) {
  std::vector<std::uint8_t> flags;
  if (chosen) {
    if (chosen->ndim() != 1 || static_cast<std::size_t>(chosen->size()) != all.count())
      throw InputError("reset: expected one flag for each of " + std::to_string(all.count()) +
                       " environments");
    for (py::ssize_t i = 0; i < chosen->size(); ++i) flags.push_back(chosen->at(i) ? 1 : 0);
  }
  if (!seeds.empty() && seeds.size() != all.count())
    throw InputError("reset: expected one seed for each of " + std::to_string(all.count()) +
                     " environments, got " + std::to_string(seeds.size()));
  released(all, [&] { all.reset(flags, seeds); });
}

void step(Environments& all, const Actions& actions) {
  const std::size_t expected = all.count() * all.learner_count() * 3;
  if (static_cast<std::size_t>(actions.size()) != expected) {
    throw InputError("step: expected " + std::to_string(all.count()) + " x " +
                     std::to_string(all.learner_count()) + " x 3 numbers, got " +
                     std::to_string(actions.size()));
  }
  const std::span<const double> numbers{actions.data(), expected};
  released(all, [&] { all.step(numbers); });
}

void step_commands(Environments& all, const std::vector<Command>& commands) {
  if (commands.size() != all.count() * all.learner_count()) {
    throw InputError("step_commands: expected " + std::to_string(all.count() * all.learner_count()) +
                     " commands, got " + std::to_string(commands.size()));
  }
  for (std::size_t i = 0; i < commands.size(); ++i) {
    if (!is_finite(commands[i]))
      throw InputError("step_commands: command " + std::to_string(i) + " holds NaN or an infinity");
  }
  released(all, [&] { all.step(commands); });
}

std::unique_ptr<Environments> make(const py::object& given, std::size_t count,
                                   const std::vector<std::string>& learners, std::optional<int> tracks,
                                   std::optional<int> obstacles, const std::string& axes,
                                   const py::dict& reward, int action_repeat, const std::string& actions,
                                   bool end_on_collision, bool skip_deployment, const py::object& overrides,
                                   unsigned threads, bool autoreset, const py::object& algorithms) {
  for (const auto& [name, number] : {std::pair{"tracks", tracks}, std::pair{"obstacles", obstacles}}) {
    if (number && *number < 0)
      throw InputError({}, name, "expected at least 0, got " + std::to_string(*number));
  }
  if (actions != "scaled" && actions != "mps")
    throw InputError({}, "actions", "unknown \"" + actions + "\"" + suggestion(actions, {"scaled", "mps"}));
  const EnvironmentOptions options{.learners = learners,
                                   .observation = {.tracks = tracks.value_or(-1),
                                                   .obstacles = obstacles.value_or(-1),
                                                   .axes = axes_of(axes)},
                                   .reward = reward_of(reward),
                                   .action_repeat = action_repeat,
                                   .scaled_actions = actions == "scaled",
                                   .end_on_collision = end_on_collision,
                                   .skip_deployment = skip_deployment};
  ScenarioText source = scenario_of(given);
  if (!overrides.is_none()) source = source.with_overrides(overrides_of(overrides));
  const Scenario scenario = source.scenario();
  const DrawScenario draw = [source = std::move(source)](std::uint64_t seed) { return source.drawn(seed); };
  return std::make_unique<Environments>(scenario, draw, options, count, threads, autoreset, algorithms);
}

void add_views(py::class_<Environments>& c) {
  using Shown = Environments::Shown;
  add_view(c, "observations", &Shown::observations, Dimensions::observations, "as observation_names says");
  add_view(c, "rewards", &Shown::rewards, Dimensions::learners, "of the last step, by learner");
  add_view(c, "returns", &Shown::returns, Dimensions::environments,
           "of the last step, all learners together");
  add_view(c, "terminated", &Shown::terminated, Dimensions::environments, "all arrived, or one collided");
  add_view(c, "truncated", &Shown::truncated, Dimensions::environments, "time is up, or nobody goes on");
  add_view(c, "time", &Shown::time, Dimensions::environments, "[s]");
  add_view(c, "seed", &Shown::seed, Dimensions::environments, "of the episode");
  add_view(c, "goal_distance", &Shown::goal_distance, Dimensions::learners, "to the end of the leg [m]");
  add_view(c, "separation", &Shown::separation, Dimensions::learners,
           "least in the step, between centres [m]");
  add_view(c, "clearance", &Shown::clearance, Dimensions::learners, "least in the step, to an obstacle [m]");
  add_view(c, "deciding", &Shown::deciding, Dimensions::learners, "whether the next action is heeded");
  add_view(c, "arrived", &Shown::arrived, Dimensions::learners, "at the end of its mission");
  add_view(c, "stuck", &Shown::stuck, Dimensions::learners, "under way for longer than the exam allows");
  add_view(c, "collided", &Shown::collided, Dimensions::learners, "in this episode");
}

}  // namespace

void bind_environments(py::module_& m) {
  py::class_<Environments> c(m, "FleetEnvironments",
                             "Environments of one scenario side by side, as arrays: what fairway.gym is made "
                             "of. Attributes are views that the next step overwrites.");
  c.def(py::init(&make), py::arg("scenario"), py::kw_only(), py::arg("count") = 1,
        py::arg("learners") = std::vector<std::string>{}, py::arg("tracks") = py::none(),
        py::arg("obstacles") = py::none(), py::arg("axes") = "ned", py::arg("reward") = py::dict(),
        py::arg("action_repeat") = 1, py::arg("actions") = "scaled", py::arg("end_on_collision") = true,
        py::arg("skip_deployment") = true, py::arg("overrides") = py::none(), py::arg("threads") = 0,
        py::arg("autoreset") = false, py::arg("algorithms") = py::none());
  c.def("reset", &reset, py::arg("chosen") = py::none(),
        py::arg("seeds") = std::vector<std::optional<std::uint64_t>>{},
        "Begins episodes, in all environments or where chosen is true.");
  c.def("step", &step, py::arg("actions"),
        "One decision of every learner: environments x learners x 3 numbers.");
  c.def("step_commands", &step_commands, py::arg("commands"),
        "The same with a Command for each learner of each environment.");
  c.def(
      "advise",
      [](const py::object& self) {
        auto& all = self.cast<Environments&>();
        released(all, [&] { all.advise(); });
        return view(self, all.shown().advice, shape_of(all, Dimensions::actions));
      },
      "What the learners' own avoiders would do, as actions. Ask at every step of an episode or at none. "
      "Raises InputError where one commands a heading or a turn rate that the velocity does not say.");
  c.def(
      "advised_commands",
      [](Environments& all) {
        std::vector<Command> commands(all.count() * all.learner_count());
        released(all, [&] { all.advise(commands); });
        return commands;
      },
      "The same as commands.");
  c.def("situation", &situation, py::arg("environment") = 0, py::arg("learner") = 0,
        "The Situation that a learner is to decide on, or None if it is not to decide.");
  c.def("measures", &measures, py::arg("environment") = 0,
        "What a run is measured by, of the present episode: a number of the fleet, or an array by vehicle.");
  c.def("outline", &outline, py::arg("environment") = 0,
        "Positions and goals of all vehicles, as rows [m, NED], and their radii [m].");
  c.def_property_readonly("count", &Environments::count);
  c.def_property_readonly("learners", [](Environments& all) { return all.at(0).options().learners; });
  c.def_property_readonly("vehicles", [](Environments& all) {
    std::vector<std::string> names;
    for (const VehicleSpec& spec : all.at(0).scenario().vehicles) names.push_back(spec.name);
    return names;
  });
  c.def_property_readonly(
      "max_speeds",
      [](Environments& all) {
        std::vector<double> speeds;
        for (const auto& learner : all.at(0).learners()) speeds.push_back(learner.max_speed);
        return speeds;
      },
      "[m/s], by learner");
  c.def_property_readonly(
      "period",
      [](Environments& all) {
        const Scenario& scenario = all.at(0).scenario();
        return scenario.step_s * scenario.steps_per_decision * all.at(0).options().action_repeat;
      },
      "of a step [s]");
  c.def_property_readonly("observation_names",
                          [](Environments& all) { return all.at(0).options().observation.names(); });
  add_views(c);
}

}  // namespace fairway::python
