// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/situations.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "bindings/python/bindings.hpp"
#include "bindings/python/value_class.hpp"
#include "fairway/core/envelope_numbers.hpp"
#include "fairway/scenario/polygon.hpp"

namespace fairway::python {
namespace {

/// The id decides who has the right of way, where nothing is said.
template <class T>
void give_priority(T& vehicle, const py::dict& given) {
  if (given.contains("priority")) return;
  constexpr std::int32_t last = std::numeric_limits<std::int32_t>::max();
  if (number(vehicle.id) > static_cast<std::uint32_t>(last))
    throw InputError({}, "id",
                     "is " + std::to_string(number(vehicle.id)) + ", and no priority can be that; expected " +
                         std::to_string(last) + " at most, or a priority");
  vehicle.priority = static_cast<std::int32_t>(number(vehicle.id));
}

void check_limits(Limits& limits, const py::dict&) {
  if (limits.min_depth > limits.max_depth)
    throw InputError("Limits: min_depth is below max_depth; depth counts downwards");
  if (!(limits.min_speed >= 0.0 && limits.min_speed < Limits::none))
    throw InputError("Limits.min_speed: expected a finite number that is not negative");
}

void check_obstacle(ObstacleSpec& obstacle, const py::dict&) {
  if (!(obstacle.radius >= 0.0)) throw InputError("Obstacle.radius: expected a number that is not negative");
  if (obstacle.kind != Obstacle::Kind::polygon) return;
  if (obstacle.vertices.size() < 3)
    throw InputError("Obstacle.vertices: expected at least three, got " +
                     std::to_string(obstacle.vertices.size()));
  const double area = signed_area(obstacle.vertices);
  if (area < 0.0)
    throw InputError(
        "Obstacle.vertices: they run clockwise; write them counter-clockwise with n as x and e as y");
  if (!(area > 0.0)) throw InputError("Obstacle.vertices: they lie on one line; a polygon needs an area");
}

/// Vertices of two or three numbers each.
std::vector<Vec3> vertices_of(const py::iterable& given) {
  std::vector<Vec3> vertices;
  for (const py::handle item : given) {
    const std::string path = "Obstacle.vertices[" + std::to_string(vertices.size()) + "]";
    const bool flat = py::isinstance<py::sequence>(item) && py::len(item) == 2;
    const DoubleArray values = numbers(item, {flat ? 2 : 3}, path);
    vertices.emplace_back(values.at(0), values.at(1), flat ? 0.0 : values.at(2));
  }
  return vertices;
}

/// One number or vector of every track, as rows.
template <class V>
py::array track_rows(const py::object& self, V Track::*member) {
  const std::vector<Track>& tracks = made<OwnedSituation>(self).tracks;
  static const Track none;
  const Track& first = tracks.empty() ? none : tracks.front();
  const auto rows = static_cast<py::ssize_t>(tracks.size());
  constexpr py::ssize_t row = sizeof(Track), step = sizeof(double);
  if constexpr (std::is_same_v<V, Vec3>) {
    return frozen_view((first.*member).data(), {rows, 3}, {row, step}, self);
  } else {
    return frozen_view(&(first.*member), {rows}, {row}, self);
  }
}

void bind_own_and_tracks(py::module_& m) {
  ValueClass<Ownship>(m, "Ownship", "Own state as estimated on board.\n")
      .members({"position"})
      .finish(give_priority<Ownship>);
  ValueClass<Track>(m, "Track", "Another vehicle, or anything else that moves, as perceived.\n")
      .members({"position"})
      .finish(give_priority<Track>);
}

void bind_obstacle(py::module_& m) {
  py::class_<ObstacleSpec> obstacle =
      ValueClass<ObstacleSpec>(m, "Obstacle",
                               "Something solid: made by sphere, segment, polygon or prism. Only the fields "
                               "of its kind mean anything.\n")
          .field("kind", &ObstacleSpec::kind, "'sphere', 'segment' or 'polygon'")
          .field("position", &ObstacleSpec::position, "of a sphere's centre [m, NED]")
          .field("radius", &ObstacleSpec::radius, "of a sphere [m]")
          .field("start", &ObstacleSpec::from, "of a segment [m, NED]")
          .field("end", &ObstacleSpec::to, "of a segment [m, NED]")
          .field("vertices", &ObstacleSpec::vertices,
                 "of a polygon, counter-clockwise with n as x and e as y [m, NED]")
          .field("charted", &ObstacleSpec::charted, "known before the mission; else met on the way")
          .field("velocity", &ObstacleSpec::velocity, "of a sphere that drifts, in a scenario [m/s, NED]")
          .finish(check_obstacle);
  obstacle.def_static(
      "sphere",
      [](const py::object& position, double radius, bool charted) {
        ObstacleSpec made{.kind = Obstacle::Kind::sphere, .charted = charted, .radius = radius};
        made.position = Read<Vec3>::from(position, "Obstacle.position");
        check_obstacle(made, {});
        return made;
      },
      py::arg("position"), py::arg("radius"), py::arg("charted") = true,
      "A ball: its centre [m, NED] and radius [m].");
  obstacle.def_static(
      "segment",
      [](const py::object& start, const py::object& end, bool charted) {
        ObstacleSpec made{.kind = Obstacle::Kind::segment, .charted = charted};
        made.from = Read<Vec3>::from(start, "Obstacle.start");
        made.to = Read<Vec3>::from(end, "Obstacle.end");
        return made;
      },
      py::arg("start"), py::arg("end"), py::arg("charted") = true, "A thin wall from start to end [m, NED].");
  const auto polygon = [](const py::iterable& vertices, bool charted) {
    ObstacleSpec made{.kind = Obstacle::Kind::polygon, .charted = charted};
    made.vertices = vertices_of(vertices);
    check_obstacle(made, {});
    return made;
  };
  for (const char* name : {"polygon", "prism"}) {
    obstacle.def_static(name, polygon, py::arg("vertices"), py::arg("charted") = true,
                        "A solid vertical prism through every depth over a polygon: at least three vertices "
                        "of two or three numbers, counter-clockwise with n as x and e as y [m, NED].");
  }
  obstacle.def(
      "nearest_point",
      [](const ObstacleSpec& self, const py::object& position) {
        const SurfacePoint nearest = nearest_point(self.view(), Read<Vec3>::from(position, "position"));
        return py::make_tuple(py::cast(nearest.point), nearest.distance);
      },
      py::arg("position"),
      "The surface point nearest to position [m, NED], and how far away it is [m], negative inside a solid.");
}

void bind_goal_and_limits(py::module_& m) {
  ValueClass<Goal>(m, "Goal", "Where the mission wants to be, and how fast.\n")
      .members({"position", "cruise_speed"})
      .finish();
  ValueClass<Limits>(m, "Limits", "What a vehicle can or may do. A limit that is not set does not bind.\n")
      .members()
      .finish(check_limits);

  ValueClass<OnboardModel>(m, "OnboardModel",
                           "How a vehicle answers to forces, as known on board, an axis at a time: surge, "
                           "sway, heave, roll, pitch, yaw.\n")
      .field("mass", &OnboardModel::mass, "rigid body and added mass [kg, kg m2]")
      .field("linear_damping", &OnboardModel::linear_damping, "[kg/s, kg m2/s]")
      .field("quadratic_damping", &OnboardModel::quadratic_damping, "[kg/m, kg m2]")
      .field("restoring", &OnboardModel::restoring, "when level [N, N m]")
      .field("least", &OnboardModel::least, "what the actuators give on an axis, the others at zero [N, N m]")
      .field("greatest", &OnboardModel::greatest, "likewise [N, N m]")
      .finish();
}

void check_envelope(Envelope& envelope, const py::dict&) {
  const std::string_view why = why_unusable(envelope);
  if (!why.empty()) throw InputError("Envelope: " + std::string(why));
}

void bind_envelope(py::module_& m) {
  ValueClass<Envelope>(
      m, "Envelope",
      "What a vehicle under its autopilot can do in still water, as `fairway describe VEHICLE` "
      "shows it.\n")
      .members({"ahead", "acceleration", "deceleration", "turn_acceleration", "turn_rates"})
      .finish(check_envelope);
}

void bind_command(py::module_& m) {
  constexpr std::size_t mode_count = EnumNames<Mode>::names.size();
  py::enum_<Mode> modes{m, "Mode", "Why a command is what it is."};
  modes.def(py::init([](std::int64_t value) {
              if (value < 0 || value >= static_cast<std::int64_t>(mode_count))
                refuse("Mode", "0 to " + std::to_string(mode_count - 1), py::int_(value));
              return static_cast<Mode>(value);
            }),
            py::arg("value"), py::prepend());
  modes.value("cruise", Mode::cruise, "nothing in the way")
      .value("avoid", Mode::avoid,
             "deviating from the preferred velocity, or someone close enough that it might")
      .value("hold", Mode::hold, "waiting on purpose: keep the present position")
      .value("infeasible", Mode::infeasible, "no safe choice was found, or the input made no sense");

  ValueClass<Command>(m, "Command", "What the vehicle should do until the next decision.\n")
      .members()
      .finish();
}

void check_link(OwnedLink& link, const py::dict&) {
  if (!(link.turn_period >= 0.0 && std::isfinite(link.turn_period) && std::isfinite(link.next_turn)))
    throw InputError("Link: expected a finite next_turn, and a finite turn_period that is not negative");
}

void bind_link(py::module_& m) {
  ValueClass<HeardSpeech>(m, "Heard", "What the method of another vehicle said.\n")
      .required("sender", &HeardSpeech::from, "id of its vehicle")
      .required("sent", &HeardSpeech::sent, "when it was said [s], by the mission's time")
      .required("speech", &HeardSpeech::speech, "25 bytes at most")
      .finish();
  ValueClass<AcousticRange>(
      m, "AcousticRange",
      "A distance that a modem has measured by the time that sound took: by one word that of its "
      "way, with the clocks' difference in it; by a word and its answer the mean of two ways.\n")
      .required("to", &AcousticRange::to, "id of the other vehicle")
      .required("distance", &AcousticRange::distance, "[m]")
      .field("deviation", &AcousticRange::deviation, "standard, of the measurement alone [m]")
      .field("out", &AcousticRange::out, "when the own word went out, if there was one, else `back` [s]")
      .field("back", &AcousticRange::back, "when the other's came in [s], by the clock on board")
      .finish();
  ValueClass<OwnedLink>(m, "Link", "What a vehicle's modem offers a method that speaks.\n")
      .field("heard", &OwnedLink::heard, "of Heard: the last speech of each of the others, by vehicle")
      .field("turn_period", &OwnedLink::turn_period, "from one own turn to the next [s]")
      .field("next_turn", &OwnedLink::next_turn, "when the next one begins [s], by the mission's time")
      .field("ranges", &OwnedLink::ranges,
             "of AcousticRange: the last of each of the others, where modems measure")
      .finish(check_link);
}

void bind_situation(py::module_& m) {
  const auto settle = [](OwnedSituation& s, const py::dict&) {
    std::ranges::sort(s.tracks, {}, [&](const Track& t) {
      return std::tuple{(t.position - s.own.position).squaredNorm(), number(t.id)};
    });
  };
  ValueClass<OwnedSituation>(
      m, "Situation",
      "All that an avoider may know at one instant. It owns its tracks and obstacles, which nobody can "
      "change: it may be kept, and arrays that it gives are views that cannot be written.\n")
      .required("own", &OwnedSituation::own, "Ownship")
      .required("goal", &OwnedSituation::goal, "Goal")
      .required("period", &OwnedSituation::period, "until the next decision [s], above 0")
      .field("time", &OwnedSituation::time, "since the start of the mission [s]")
      .field("limits", &OwnedSituation::limits, "Limits; an Avoider holds every command to these")
      .field("tracks", &OwnedSituation::tracks, "of Track, nearest first, whatever order they are given in")
      .field("obstacles", &OwnedSituation::obstacles, "of Obstacle: what does not move")
      .field("model", &OwnedSituation::model, "OnboardModel, or None where nothing is known of forces")
      .field("envelope", &OwnedSituation::envelope,
             "Envelope: what the vehicle can do, or None. A method that has to turn a vehicle asks for it: "
             "without, `trackable` and `safety_filter` do not foresee turns, and say so")
      .field("link", &OwnedSituation::link, "Link, or None unless the method speaks and has somebody to hear")
      .field("current", &OwnedSituation::current,
             "of the water, as estimated on board, 0 if unknown [m/s, NED]")
      .field("attendance", &OwnedSituation::attendance,
             "of a method that speaks: \"waiting\" and \"ready\" at a rendezvous, \"arrived\" after the "
             "mission, "
             "\"kept\" while it is stopped")
      .finish(settle)
      .def_property_readonly(
          "preferred_velocity",
          [](const OwnedSituation& self) {
            SituationRoom room;
            return self.view(room).preferred_velocity();
          },
          "The velocity that ignores everyone: as the mission wants it, or straight to the goal, slowing "
          "down to stop on it; never above the speed limit [m/s, NED].")
      .def_property_readonly(
          "track_positions", [](const py::object& self) { return track_rows(self, &Track::position); },
          "Of all tracks, as rows [m, NED]. No copy.")
      .def_property_readonly(
          "track_velocities", [](const py::object& self) { return track_rows(self, &Track::velocity); },
          "Of all tracks, as rows [m/s, NED]. No copy.")
      .def_property_readonly(
          "track_radii", [](const py::object& self) { return track_rows(self, &Track::radius); },
          "Of all tracks [m]. No copy.");
}

OwnedLink owned(const Link& link) {
  OwnedLink own{.turn_period = link.turn_period,
                .next_turn = link.next_turn,
                .ranges = {link.ranges.begin(), link.ranges.end()}};
  for (const Heard& each : link.heard) own.heard.push_back({each.from, each.sent, each.speech});
  return own;
}

}  // namespace

OwnedSituation::OwnedSituation(const Situation& s)
    : time{s.time},
      period{s.period},
      own{s.own},
      goal{s.goal},
      limits{s.limits},
      model{s.model == nullptr ? std::nullopt : std::optional{*s.model}},
      envelope{s.envelope == nullptr ? std::nullopt : std::optional{*s.envelope}},
      link{s.link == nullptr ? std::nullopt : std::optional{owned(*s.link)}},
      current{s.current},
      attendance{s.attendance},
      tracks{s.tracks.begin(), s.tracks.end()} {
  obstacles.reserve(s.obstacles.size());
  for (const Obstacle& o : s.obstacles) {
    obstacles.push_back({.kind = o.kind,
                         .charted = o.charted,
                         .position = o.position,
                         .radius = o.radius,
                         .from = o.from,
                         .to = o.to,
                         .vertices = {o.vertices.begin(), o.vertices.end()}});
  }
}

Situation OwnedSituation::view(SituationRoom& room) const {
  room.solids.clear();
  for (const ObstacleSpec& spec : obstacles) room.solids.push_back(spec.view());
  room.heard.clear();
  if (link) {
    for (const HeardSpeech& each : link->heard) room.heard.push_back({each.from, each.sent, each.speech});
    room.link = {.heard = room.heard,
                 .turn_period = link->turn_period,
                 .next_turn = link->next_turn,
                 .ranges = link->ranges};
  }
  return {.time = time,
          .period = period,
          .own = own,
          .goal = goal,
          .limits = limits,
          .model = model ? &*model : nullptr,
          .envelope = envelope ? &*envelope : nullptr,
          .link = link ? &room.link : nullptr,
          .current = current,
          .tracks = tracks,
          .obstacles = room.solids,
          .attendance = attendance};
}

Command command_of(py::handle answer, const std::string& who) {
  if (py::isinstance<Command>(answer)) return py::cast<Command>(answer);
  if (!py::isinstance<py::sequence>(answer) && !py::isinstance<py::array>(answer))
    refuse(who, "a Command or three numbers", answer);
  return {.velocity = Read<Vec3>::from(answer, who)};
}

void bind_situations(py::module_& m) {
  bind_own_and_tracks(m);
  bind_obstacle(m);
  bind_goal_and_limits(m);
  bind_envelope(m);
  bind_command(m);
  bind_link(m);
  bind_situation(m);
}

}  // namespace fairway::python
