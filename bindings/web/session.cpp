// SPDX-License-Identifier: Apache-2.0
#include "bindings/web/session.hpp"

#include <cmath>
#include <utility>

#include "bindings/web/absent.hpp"
#include "bindings/web/layout.hpp"
#include "bindings/web/output_file.hpp"
#include "fairway/comms/exchange.hpp"
#include "fairway/core/names.hpp"
#include "fairway/core/text.hpp"
#include "fairway/experiment/measure_run.hpp"
#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/frame_hash.hpp"
#include "fairway/record/recording_writer.hpp"
#include "fairway/view/description.hpp"
#include "fairway/view/explain/explanation.hpp"
#include "fairway/view/explain/instant.hpp"
#include "fairway/view/playback.hpp"

namespace fairway::web {
namespace {

using nlohmann::json;

constexpr std::size_t most_frames = 500;  // of a part

const Catalogs& catalogs() {
  static const Catalogs all = builtin_catalogs();
  return all;
}

json finite(double value) { return std::isfinite(value) ? json(value) : json(); }

}  // namespace

Order order_of_recording(std::string_view bytes, const std::string& file) {
  auto recording = std::make_shared<const Recording>(Recording::parse(std::as_bytes(std::span{bytes}), file));
  check_methods(*recording, recorded_scenario(*recording, file), catalogs(), file);
  return {.yaml = {}, .file = file, .set = {}, .seed = {}, .recording = recording};
}

Session::Session(Order order)
    : order_{std::move(order)},
      stretches_{stretches()},
      run_{stretches_, catalogs()},
      metrics_{metrics_for(scenario(), catalogs().vehicles)},
      sinks_{this, &metrics_} {
  run_.simulation().show_thoughts(order_.filmed);
  if (order_.filmed) sinks_.push_back(&begin_film());
  if (order_.recording) {
    sinks_.push_back(&checker_.emplace(*order_.recording));
    run_.simulation().show_thoughts(order_.filmed || order_.recording->info().sketches);
  }
  absent_library_was_wanted();
}

/// Each has the changes of those before it.
std::vector<Stretch> Session::stretches() const {
  if (order_.recording) return {{Tick{0}, recorded_scenario(*order_.recording, order_.file)}};
  Overrides set = order_.set;
  std::vector<Stretch> all{{Tick{0}, parse_scenario(order_.yaml, order_.file, set, order_.seed)}};
  const double period = all.front().scenario.step_s;
  for (const ChangeOnTheWay& change : order_.changes) {
    set.insert(set.end(), change.set.begin(), change.set.end());
    all.push_back({Tick{std::llround(change.at_s / period)},
                   parse_scenario(order_.yaml, order_.file, set, order_.seed)});
    const Scenario& before = all[all.size() - 2].scenario;
    Simulation{before, catalogs()}.change(before, all.back().scenario, catalogs());
  }
  return all;
}

json Session::layout() const {
  if (order_.recording) return {{"handles", json::array()}, {"fleet_count", nullptr}};
  Overrides set = order_.set;
  for (const ChangeOnTheWay& change : order_.changes)
    set.insert(set.end(), change.set.begin(), change.set.end());
  return web::layout(order_.yaml, order_.file, set, order_.seed, stretches_.back().scenario);
}

Film& Session::begin_film() {
  return film_.emplace(scenario(), FilmLimits{.thinkers = order_.thinkers}, &catalogs().avoiders);
}

void Session::think(std::vector<std::size_t> vehicles) {
  order_.thinkers = std::move(vehicles);
  if (!film_) return;
  Film& film = begin_film();
  ChangingRun again{stretches_, catalogs()};
  again.simulation().show_thoughts(true);
  FrameSink* sink = &film;
  while (again.simulation().tick() < run_.simulation().tick()) again.step({&sink, 1});
  if (done_) film.finish(divergence_text(run_.simulation()));
  thoughts_anew_ = true;
}

std::string Session::recording() const {
  if (stretches_.size() > 1)
    throw InputError("a run that is changed on its way has no recording: no scenario makes it again");
  return recorded();
}

std::string Session::recorded() const {
  RecordingWriter writer{"run.mcap", recording_info(scenario())};
  Simulation again{scenario(), catalogs()};
  FrameSink* sink = &writer;
  while (!again.is_done()) again.step({&sink, 1});
  refuse_absent();
  writer.close({.divergence = divergence_text(again), .stopped = false});
  return taken_file();
}

json Session::explanation(std::string_view vehicle, double time) const {
  if (stretches_.size() > 1 && time >= seconds(stretches_[1].from, scenario().step_s))
    throw InputError("decisions are explained up to the first change on the way, which was before");
  std::optional<Recording> made;
  if (!order_.recording) {
    const std::string bytes = recorded();
    made = Recording::parse(std::as_bytes(std::span{bytes}), order_.file);
  }
  const Recording& run = made ? *made : *order_.recording;
  const Instant instant{vehicle_called(run.info(), vehicle), frame_at(run, time)};
  return page_json(explain(scenario(), *find_decision(run, scenario(), catalogs(), instant, {}, nullptr),
                           catalogs().avoiders));
}

std::string Session::command() const {
  if (order_.recording) return "fairway replay " + shell_word(order_.file) + " --verify";
  std::string text = "fairway run " + shell_word(order_.file);
  for (const auto& [path, value] : order_.set) text += " --set " + shell_word(path + "=" + value);
  if (order_.seed) text += " --seed " + std::to_string(*order_.seed);
  return text;
}

json Session::document() const {
  return playback_document(
      scenario(),
      {.version = FAIRWAY_VERSION, .command = command(), .period = scenario().step_s, .explanation = {}},
      nullptr);
}

void Session::write(const Frame& frame) {
  frame_hashes_.push_back(frame_hash(frame));
  run_hash_ = mix_hash(run_hash_, frame_hashes_.back());
  last_time_ = frame.time;
}

void Session::refuse_absent() const {
  if (!absent_library_was_wanted()) return;
  throw InputError(
      "a method of this run searches a path by OMPL, which is not in the browser; natively it is: " +
      command());
}

std::size_t Session::run(std::size_t steps) {
  std::size_t made = 0;
  const auto is_over = [this] { return run_.simulation().is_done() || (checker_ && checker_->is_over()); };
  for (; made < steps && !is_over(); ++made) run_.step(sinks_);
  refuse_absent();
  if (is_over() && !done_) {
    done_ = true;
    if (film_) film_->finish(divergence_text(run_.simulation()));
  }
  return made;
}

std::string Session::divergence_text(const Simulation& simulation) const {
  const auto& broke = simulation.divergence();
  return broke ? text_of(*broke, scenario().vehicles[broke->vehicle].name) : "";
}

json Session::part(std::size_t first, std::size_t generation) {
  json part;
  bytes_.clear();
  if (film_) {
    if (generation != film_->generation() || first > film_->size()) first = 0;
    if (first < film_->size() || thoughts_anew_) {
      part = film_->part(first, most_frames, Packing::apart);
      const std::size_t count = part["count"];
      bytes_ = film_->column_bytes(first, count);
      part["thoughts_anew"] = thoughts_anew_;
      if (std::exchange(thoughts_anew_, false)) part["thoughts"] = film_->thoughts_before(first + count);
    }
  }
  return {{"part", std::move(part)},
          {"state",
           {{"paused", false},
            {"done", done_},
            {"time_s", last_time_},
            {"speed", 0},
            {"divergence", divergence_text(run_.simulation())}}}};
}

json Session::outcome() const {
  json document{{"scenario", scenario().name},
                {"seed", std::to_string(scenario().seed)},
                {"simulated_s", run_.simulation().time()},
                {"outcome", run_.simulation().divergence() ? "diverged" : "finished"},
                {"fleet", json::object()},
                {"vehicles", json::array()}};
  for (const VehicleSpec& vehicle : scenario().vehicles)
    document["vehicles"].push_back({{"name", vehicle.name}});
  if (checker_) {
    document["same"] = checker_->same();
    document["verdict"] = checker_->describe();
  }
  if (run_.simulation().divergence()) {
    document["diverged"] = divergence_text(run_.simulation());
    return document;
  }
  for (const Measure& measure : metrics_.measures()) {
    json& of = measure.vehicle == Measure::fleet
                   ? document["fleet"]
                   : document["vehicles"][static_cast<std::size_t>(measure.vehicle)];
    of[measure.quantity] = finite(measure.value);
  }
  return document;
}

json names() {
  json all{{"algorithms", json::array()},
           {"vehicles", json::array()},
           {"exchanges", json::array()},
           {"schema", json::parse(scenario_schema())}};
  for (const Catalog::Entry& entry : catalogs().avoiders.entries())
    all["algorithms"].push_back(
        {{"name", entry.info.name}, {"title", entry.info.title}, {"wraps", entry.wraps}});
  for (const VehicleCatalog::Entry& entry : catalogs().vehicles.entries())
    all["vehicles"].push_back({{"name", entry.info.name}, {"title", entry.info.title}});
  for (const KindInfo& kind : exchange_kinds())
    all["exchanges"].push_back({{"name", kind.name}, {"title", kind.title}});
  return all;
}

json described(const std::string& name) {
  std::vector<std::string_view> known;
  if (std::optional<json> found = description(name, catalogs(), known)) return *std::move(found);
  throw InputError("nothing is called \"" + name + "\"" + suggestion(name, known));
}

}  // namespace fairway::web
