// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <sstream>

#include "bindings/python/bindings.hpp"
#include "bindings/python/measures.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/trajectories.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/csv.hpp"
#include "fairway/record/output_file.hpp"
#include "fairway/record/recording.hpp"
#include "fairway/sim/divergence.hpp"

namespace fairway::python {
namespace {

/// `fairway.Recording`.
class ReadRecording {
 public:
  explicit ReadRecording(std::string file) : file_{std::move(file)}, recording_{Recording::read(file_)} {}

  const Recording& recording() const { return recording_; }
  const RecordingInfo& info() const { return recording_.info(); }
  const std::string& file() const { return file_; }

  /// Made when first asked for.
  py::object trajectories() {
    if (!trajectories_) {
      TrajectoryColumns columns;
      recording_.play(columns);
      trajectories_ = columns.take();
    }
    return trajectories_;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const RecordingInfo::Vehicle& vehicle : info().vehicles) all.push_back(vehicle.name);
    return all;
  }

  py::list words() const {
    py::list all;
    for (const SpokenWord& word : recording_.words()) {
      const std::span<const std::uint8_t> bytes = word.speech.view();
      all.append(
          py::dict{py::arg("time_s") = word.sent, py::arg("vehicle") = word.from,
                   py::arg("bytes") = py::bytes{reinterpret_cast<const char*>(bytes.data()), bytes.size()}});
    }
    return all;
  }

  /// As the run was measured.
  std::vector<Measure> measures() const {
    const Scenario scenario = recorded_scenario(recording_, file_);
    if (!recording_.divergence().empty()) throw RunDiverged{recording_.divergence()};
    RunMetrics metrics = metrics_for(scenario);
    recording_.play(metrics);
    return metrics.measures();
  }

 private:
  std::string file_;
  Recording recording_;
  py::object trajectories_;
};

/// The text, or what was written to `file`.
py::object csv(const ReadRecording& self, const py::object& file,
               void (*write)(const Recording&, std::ostream&)) {
  if (file.is_none()) {
    std::ostringstream text;
    write(self.recording(), text);
    return py::str(text.str());
  }
  const std::string path = path_of(file);
  const std::array outputs{Output{"file", path, recording_table}};
  check_outputs(outputs, std::array{self.file()}, false);
  OutputFile out{path};
  write(self.recording(), out.stream());
  out.commit();
  return py::none();
}

}  // namespace

void bind_recordings(py::module_& m) {
  bind_trajectories(m);
  using R = ReadRecording;
  py::class_<R> recording{m, "Recording", "A recorded run, read from its file; every checksum was verified."};
  recording
      .def_static(
          "read",
          [](const py::object& file) {
            const std::string path = path_of(file);
            const py::gil_scoped_release unlocked;
            return std::make_unique<R>(path);
          },
          py::arg("file"),
          "Raises InputError for a file that is missing, damaged or no recording of fairway.")
      .def_property_readonly("file", &R::file, "that it was read from")
      .def_property_readonly(
          "version", [](const R& r) { return r.info().version; }, "of fairway that wrote it")
      .def_property_readonly(
          "scenario_name", [](const R& r) { return r.info().scenario_name; }, "of the run")
      .def_property_readonly(
          "scenario_yaml", [](const R& r) { return r.info().scenario_yaml; },
          "the case as drawn: Scenario.parse(...) is the run again")
      .def_property_readonly(
          "seed", [](const R& r) { return r.info().seed; }, "of the scenario")
      .def_property_readonly(
          "period_s", [](const R& r) { return r.info().period; }, "between frames of the run [s]")
      .def_property_readonly("names", &R::names, "of the vehicles, by index")
      .def_property_readonly(
          "models",
          [](const R& r) {
            std::vector<std::string> all;
            for (const RecordingInfo::Vehicle& vehicle : r.info().vehicles) all.push_back(vehicle.model);
            return all;
          },
          "of the vehicles, by index")
      .def_property_readonly(
          "divergence", [](const R& r) { return r.recording().divergence(); },
          "how the run broke behind the last frame, in a line; empty if it is whole")
      .def_property_readonly(
          "stopped", [](const R& r) { return r.recording().stopped(); },
          "the run was stopped before its end: what it would have come to is not recorded")
      .def_property_readonly(
          "perception", [](const R& r) { return r.info().perception; }, "tracks are kept, too")
      .def_property_readonly(
          "sketches", [](const R& r) { return r.info().sketches; }, "drawings are kept, too")
      .def_property_readonly(
          "words", &R::words,
          "what methods said of their own, in order: time_s, vehicle (its index) and bytes of each")
      .def("__len__", [](const R& r) { return r.recording().size(); });
  for (const char* name : {"times", "positions", "velocities", "quaternions", "yaws", "commands", "goals",
                           "powers", "modes", "phases"}) {
    recording.def_property_readonly(
        name, [name](R& r) { return r.trajectories().attr(name); }, "as in Trajectories");
  }
  recording.def_property_readonly("trajectories", &R::trajectories, "Trajectories: all of these arrays")
      .def_property_readonly(
          "fleet", [](const R& r) { return fleet_dict(r.measures()); },
          "measured again from its frames, as Run.fleet; raises RunDiverged where the run broke")
      .def_property_readonly(
          "vehicles", [](const R& r) { return vehicle_dicts(r.measures(), r.names()); },
          "likewise, as Run.vehicles")
      .def(
          "csv", [](const R& r, const py::object& file) { return csv(r, file, export_csv); },
          py::arg("file") = py::none(),
          "One row per vehicle and frame, as `fairway replay --csv`: written to file, or else returned as "
          "text.")
      .def(
          "tracks_csv", [](const R& r, const py::object& file) { return csv(r, file, export_tracks_csv); },
          py::arg("file") = py::none(), "Likewise one row per track, where perception was recorded.")
      .def("__repr__", [](const R& r) {
        return "<Recording of " + r.info().scenario_name + ", seed " + std::to_string(r.info().seed) + ": " +
               std::to_string(r.recording().size()) + " frames>";
      });
}

}  // namespace fairway::python
