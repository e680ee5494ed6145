// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "bindings/python/bindings.hpp"
#include "bindings/python/in_parallel.hpp"
#include "bindings/python/json.hpp"
#include "bindings/python/scenarios.hpp"
#include "bindings/python/user_algorithms.hpp"
#include "bindings/python/values.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/view/explain/explain_recording.hpp"
#include "fairway/view/film_recording.hpp"
#include "fairway/view/playback.hpp"

namespace fairway::python {
namespace {

/// The file of a Recording, or a path.
std::string recording_path(const py::object& given) {
  const py::object known = py::module_::import("fairway._core").attr("Recording");
  return path_of(py::isinstance(given, known) ? given.attr("file") : given);
}

/// Where a page goes: never over the recording, nor over a file that is no such page.
std::string page_of(const py::object& given, const std::string& otherwise, const std::string& recording) {
  std::string page = given.is_none() ? otherwise : path_of(given);
  check_outputs(std::array{Output{"out", page, playback_file}}, std::array{recording}, false);
  return page;
}

py::object explained(const ExplainQuestion& question, const py::object& algorithms) {
  std::atomic<bool> stop{false};
  nlohmann::json document;
  // one thread that works, so that this one can look for Ctrl-C
  in_parallel(1, 1, stop, [&](std::size_t) {
    with_algorithms(algorithms, [&](const Catalogs& catalogs, FrameSink&) {
      const Recording recording = Recording::read(question.recording);
      const auto answer = explain_recording(recording, question, catalogs, &stop);
      if (answer) document = exact_json(answer->scenario, answer->found, answer->explanation);
    });
  });
  return shown(document);
}

struct ViewChoice {
  std::string recording;
  std::string page;
  bool sketch{};
  FilmLimits limits;
};

void write_view(const ViewChoice& choice, const Catalogs& catalogs, const std::atomic<bool>& stop) {
  const Recording recording = Recording::read(choice.recording);
  const Scenario scenario = recorded_scenario(recording, choice.recording);
  Film film{scenario, choice.limits, &catalogs.avoiders};
  const FilmWatch watch{&stop, {}};
  const bool complete = choice.sketch && !holds_thoughts(recording)
                            ? show_again(recording, scenario, catalogs, choice.recording, film, watch)
                            : show_recorded(recording, film, watch);
  if (!complete) return;
  film.finish(recording.divergence());
  if (film.size() == 0) throw InputError(choice.recording + ": no frame in the time from from_s to to_s");
  const PlaybackInfo info{
      recording.info().version, "fairway.view(\"" + choice.recording + "\")", recording.info().period, {}};
  write_playback(choice.page, playback_document(scenario, info, &film));
}

std::string view(const ViewChoice& choice, const py::object& algorithms) {
  if (!(choice.limits.from_s >= 0.0) || !(choice.limits.to_s >= choice.limits.from_s))
    throw InputError("view: expected seconds, 0 or more, as from_s, and no fewer as to_s");
  std::atomic<bool> stop{false};
  in_parallel(1, 1, stop, [&](std::size_t) {
    with_algorithms(algorithms,
                    [&](const Catalogs& catalogs, FrameSink&) { write_view(choice, catalogs, stop); });
  });
  return choice.page;
}

constexpr const char* explain_doc =
    R"(Why a vehicle did what it did: the run is simulated again until `time` [s], and the decision in force then is asked
again. The document of `fairway explain --json`: `headline` and `sections` in words, `decision` in numbers, and
`recorded_command_to_the_bit`. recording: a Recording or its file. vehicle: its name, id or index. algorithms: those in
Python that the run had. out: an HTML page of the 30 s before and after. Raises InputError, and whatever an algorithm
in Python raises.)";

constexpr const char* view_doc =
    R"(A page that plays a recorded run in three dimensions in any browser, as `fairway view` writes it; gives its path,
beside the recording unless `out` says where. sketch: with what methods drew of their thinking, for which the run is
simulated again where that is not recorded, with its algorithms in Python. every: one in so many frames. Raises
InputError, and whatever an algorithm in Python raises.)";

}  // namespace

void bind_explanations(py::module_& m) {
  m.def(
      "explain",
      [](const py::object& recording, const py::object& vehicle, double time, const py::object& algorithms,
         const py::object& out) {
        const std::string file = recording_path(recording);
        const std::string asked = py::str(vehicle);
        return explained({.recording = file,
                          .vehicle = asked,
                          .time = time,
                          .page = page_of(out, "", file),
                          .command = "fairway.explain(\"" + file + "\")"},
                         algorithms);
      },
      py::arg("recording"), py::arg("vehicle"), py::arg("time"), py::arg("algorithms") = py::none(),
      py::arg("out") = py::none(), explain_doc);
  m.def(
      "view",
      [](const py::object& recording, const py::object& out, bool sketch, const py::object& algorithms,
         double from_s, double to_s, int every) {
        if (every < 1) throw InputError("every: expected 1 or more, got " + std::to_string(every));
        const std::string file = recording_path(recording);
        FilmLimits limits;
        limits.from_s = from_s;
        limits.to_s = to_s;
        limits.every = static_cast<std::size_t>(every);
        const std::string beside = std::filesystem::path{file}.replace_extension(".html").string();
        return view(
            {.recording = file, .page = page_of(out, beside, file), .sketch = sketch, .limits = limits},
            algorithms);
      },
      py::arg("recording"), py::arg("out") = py::none(), py::arg("sketch") = false,
      py::arg("algorithms") = py::none(), py::arg("from_s") = 0.0,
      py::arg("to_s") = std::numeric_limits<double>::infinity(), py::arg("every") = 1, view_doc);
}

}  // namespace fairway::python
