// SPDX-License-Identifier: Apache-2.0
#include "bindings/python/decide_batch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "bindings/python/in_parallel.hpp"
#include "bindings/python/parameters.hpp"
#include "bindings/python/values.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/scenario/scenario.hpp"

namespace fairway::python {
namespace {

/// Of what an array is made: only a number may stand for all of its rows.
enum class Of : std::uint8_t { numbers, vectors };

/// Numbers or vectors with as many rows as there are situations, or one number that is every row's.
class Rows {
 public:
  Rows(const py::object& given, std::vector<py::ssize_t> shape, const std::string& path, Of of) {
    const bool is_number = py::isinstance<py::float_>(given) || py::isinstance<py::int_>(given);
    const bool shared = is_number && of == Of::numbers;
    if (!shared) {
      stride_ = 1;
      for (std::size_t i = 1; i < shape.size(); ++i) stride_ *= static_cast<std::size_t>(shape[i]);
    }
    array_ = shared ? numbers(given, {}, path) : numbers(given, std::move(shape), path);
    data_ = array_.data();
  }
  const double* row(std::size_t i) const { return data_ + i * stride_; }
  double at(std::size_t i, std::size_t column = 0) const { return stride_ == 0 ? *data_ : row(i)[column]; }
  Vec3 vector(std::size_t i, std::size_t column = 0) const {
    return Eigen::Map<const Vec3>(row(i) + 3 * column);
  }

 private:
  DoubleArray array_;
  const double* data_{};
  std::size_t stride_{};
};

/// The situations of a batch as columns; reading a row needs nothing of Python.
struct SituationRows {
  std::size_t count;
  std::size_t neighbours;
  double period;
  Limits limits;
  Rows position, velocity, goal, cruise_speed, yaw, yaw_rate, radius, time;
  Rows track_position, track_velocity, track_radius;
  std::vector<ObstacleSpec> specs;
  std::vector<Obstacle> obstacles;

  /// Who is there, nearest first.
  void read_tracks(std::size_t i, const Vec3& own, std::vector<Track>& tracks) const {
    tracks.clear();
    for (std::size_t k = 0; k < neighbours; ++k) {
      Track track{.id = TrackId{static_cast<std::uint32_t>(k + 1)},
                  .position = track_position.vector(i, k),
                  .velocity = track_velocity.vector(i, k),
                  .radius = track_radius.at(i, k),
                  .priority = static_cast<std::int32_t>(k + 1)};
      if (!std::isnan(track.position.x())) tracks.push_back(std::move(track));
    }
    std::ranges::sort(tracks, {}, [&](const Track& t) {
      return std::tuple{(t.position - own).squaredNorm(), number(t.id)};
    });
  }

  Situation situation(std::size_t i, std::vector<Track>& tracks) const {
    const Vec3 own = position.vector(i);
    read_tracks(i, own, tracks);
    return {.time = time.at(i),
            .period = period,
            .own = {.id = VehicleId{0},
                    .position = own,
                    .velocity = velocity.vector(i),
                    .yaw = yaw.at(i),
                    .yaw_rate = yaw_rate.at(i),
                    .radius = radius.at(i)},
            .goal = {.position = goal.vector(i), .cruise_speed = cruise_speed.at(i)},
            .limits = limits,
            .tracks = tracks,
            .obstacles = obstacles};
  }
};

/// What was decided, by row.
struct CommandBatch {
  py::array velocity;
  py::array mode;
  py::array heading;
  py::array turn_rate;
};

CommandBatch decide_rows(const Avoider& avoider, const SituationRows& rows, unsigned jobs) {
  constexpr std::size_t block = 256;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> velocity(3 * rows.count);
  std::vector<std::uint8_t> mode(rows.count);
  std::vector<double> heading(rows.count), turn_rate(rows.count);
  const auto work = [&](std::size_t which) {
    std::vector<Track> tracks;
    tracks.reserve(rows.neighbours);
    for (std::size_t i = which * block; i < std::min(rows.count, (which + 1) * block); ++i) {
      const Command command = Avoider{avoider}.decide(rows.situation(i, tracks));
      std::copy_n(command.velocity.data(), 3, &velocity[3 * i]);
      mode[i] = static_cast<std::uint8_t>(command.mode);
      heading[i] = command.heading.value_or(none);
      turn_rate[i] = command.turn_rate.value_or(none);
    }
  };
  std::atomic<bool> stop{false};
  in_parallel((rows.count + block - 1) / block, jobs, stop, work);
  const auto count = static_cast<py::ssize_t>(rows.count);
  return {.velocity = owned_array(std::move(velocity), {count, 3}),
          .mode = owned_array(std::move(mode), {count}),
          .heading = owned_array(std::move(heading), {count}),
          .turn_rate = owned_array(std::move(turn_rate), {count})};
}

/// How many rows or neighbours an array of `dimensions` has at `axis`.
py::ssize_t extent(const py::object& given, int dimensions, int axis, const std::string& path) {
  const DoubleArray array = DoubleArray::ensure(given);
  if (!array) PyErr_Clear();
  if (!array || array.ndim() != dimensions)
    refuse(path, dimensions == 2 ? "rows of 3 numbers" : "rows of neighbours of 3 numbers", given);
  return array.shape(axis);
}

/// The arguments, or what stands for those that are not given.
class Arguments {
 public:
  explicit Arguments(py::dict given) : given_{std::move(given)} {}

  py::object take(const char* name, const py::object& usual) {
    names_.emplace_back(name);
    return given_.contains(name) ? py::object(given_[name]) : usual;
  }
  py::object require(const char* name) {
    names_.emplace_back(name);
    if (!given_.contains(name)) throw InputError(std::string("decide_batch: ") + name + " is missing");
    return given_[name];
  }
  bool has(const char* name) const { return given_.contains(name); }
  void refuse_others() const {
    for (const auto& [key, value] : given_) {
      const auto name = py::cast<std::string>(key);
      if (std::ranges::find(names_, name) == names_.end())
        throw InputError("decide_batch: there is no argument " + name + suggestion(name, names_));
    }
  }

 private:
  py::dict given_;
  std::vector<std::string_view> names_;
};

SituationRows rows_of(Arguments& given) {
  const py::object position = given.require("position");
  const py::object tracks = given.take(
      "track_position",
      py::module_::import("numpy").attr("empty")(py::make_tuple(extent(position, 2, 0, "position"), 0, 3)));
  const py::ssize_t count = extent(position, 2, 0, "position");
  const py::ssize_t neighbours = extent(tracks, 3, 1, "track_position");
  const auto rows = [&](const char* name, const py::object& usual) {
    return Rows{given.take(name, usual), {count}, name, Of::numbers};
  };
  const py::object zeros = py::module_::import("numpy").attr("zeros");
  const Limits limits = Read<Limits>::from(given.take("limits", py::cast(Limits{})), "limits");
  if (!given.has("cruise_speed") && !std::isfinite(limits.max_speed))
    throw InputError("decide_batch: cruise_speed is missing, and limits give no max_speed instead");
  const py::float_ top_speed{limits.max_speed};
  SituationRows all{
      .count = static_cast<std::size_t>(count),
      .neighbours = static_cast<std::size_t>(neighbours),
      .period = Read<double>::from(given.take("period", py::float_(0.1)), "period"),
      .limits = limits,
      .position = {position, {count, 3}, "position", Of::vectors},
      .velocity = {given.require("velocity"), {count, 3}, "velocity", Of::vectors},
      .goal = {given.require("goal"), {count, 3}, "goal", Of::vectors},
      .cruise_speed = rows("cruise_speed", top_speed),
      .yaw = rows("yaw", py::float_(0.0)),
      .yaw_rate = rows("yaw_rate", py::float_(0.0)),
      .radius = rows("radius", py::float_(1.0)),
      .time = rows("time", py::float_(0.0)),
      .track_position = {tracks, {count, neighbours, 3}, "track_position", Of::vectors},
      .track_velocity = {given.take("track_velocity", zeros(py::make_tuple(count, neighbours, 3))),
                         {count, neighbours, 3},
                         "track_velocity",
                         Of::vectors},
      .track_radius = {given.take("track_radius", py::float_(1.0)),
                       {count, neighbours},
                       "track_radius",
                       Of::numbers},
      .specs = Read<std::vector<ObstacleSpec>>::from(given.take("obstacles", py::tuple()), "obstacles"),
      .obstacles = {}};
  for (const ObstacleSpec& spec : all.specs) all.obstacles.push_back(spec.view());
  return all;
}

constexpr const char* decide_batch_doc =
    R"(Many situations at once, as arrays of one row each, on `jobs` threads (0: all cores), without the interpreter's
lock. Each is asked of a copy of this avoider as it is now, which itself does not change: the answers depend neither
on jobs nor on each other. All arguments by keyword; where numbers are asked for, one stands for all rows:

position, velocity, goal: n x 3 [m, m/s, m, NED] (required)
cruise_speed [m/s], yaw [rad], yaw_rate [rad/s], radius [m], time [s]: n; without, the limit of
speed, which must be given then, 0, 0, 1 and 0
track_position, track_velocity: n x k x 3 [m, m/s, NED]; a track whose first number is NaN is not there
track_radius [m]: n x k; 1 without
period: until the next decision [s]; 0.1 without
limits: Limits, of all; obstacles: of Obstacle, for all

Own id and priority are 0, those of the tracks 1, 2 ... as they stand. Returns CommandBatch.)";

}  // namespace

void add_decide_batch(py::module_& m, const py::object& avoider_class,
                      std::function<Avoider(const py::handle&)> avoider_of) {
  py::class_<CommandBatch>(m, "CommandBatch", "What Avoider.decide_batch decided, by row.")
      .def_readonly("velocity", &CommandBatch::velocity, "n x 3, desired, over ground [m/s, NED]")
      .def_readonly("mode", &CommandBatch::mode, "n, as numbers: Mode(n)")
      .def_readonly("heading", &CommandBatch::heading, "n, desired yaw [rad]; NaN where none is commanded")
      .def_readonly(
          "turn_rate", &CommandBatch::turn_rate,
          "n, desired yaw rate [rad/s, positive to starboard]; NaN where none is commanded. With one, "
          "the part of the velocity along the present heading is the surge")
      .def("__len__", [](const CommandBatch& self) { return self.mode.shape(0); });
  avoider_class.attr("decide_batch") = py::cpp_function(
      [avoider_of = std::move(avoider_of)](const py::object& self, int jobs, const py::kwargs& given) {
        Arguments arguments{given};
        const SituationRows rows = rows_of(arguments);
        arguments.refuse_others();
        return decide_rows(avoider_of(self), rows, jobs_of(jobs));
      },
      py::name("decide_batch"), py::is_method(avoider_class), py::arg("jobs") = 1, decide_batch_doc);
}

}  // namespace fairway::python
