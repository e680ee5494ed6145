// SPDX-License-Identifier: Apache-2.0
// What a page calls. Texts go in through room() and come out where text() points; both are UTF-8. Nothing
// that is thrown leaves the module: what failed returns 0 or less, and its reason is the text. What is asked
// of a run before one has begun fails so.
#include <charconv>
#include <cstdint>
#include <limits>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "bindings/web/absent.hpp"
#include "bindings/web/session.hpp"
#include "fairway/core/error.hpp"

#define FAIRWAY_EXPORT(name) extern "C" __attribute__((export_name(#name)))

namespace fairway::web {
namespace {

using nlohmann::json;

std::string input;
std::string output;
std::unique_ptr<Session> session;

/// Calls `work`, which returns a number, and tells what went wrong.
template <class Work>
int tried(const Work& work) {
  try {
    return work();
  } catch (const std::exception& error) {
    output = error.what();
    return -1;
  }
}

/// The run that has begun.
Session& running() {
  if (session == nullptr) throw InputError("no run has begun");
  return *session;
}

/// What `work` comes to of the run; `otherwise`, and the reason as the text, where none has begun.
template <class T, class Work>
T of_run(T otherwise, const Work& work) {
  tried([&] {
    otherwise = work(running());
    return 1;
  });
  return otherwise;
}

/// Begins the run of the order that `make` makes. Where it is refused, the one before goes on.
template <class Make>
int begin(const Make& make) {
  const int begun = tried([&] {
    session = std::make_unique<Session>(make());
    return 1;
  });
  absent_library_was_wanted();  // what a refused one wanted is not what the one that goes on wants
  return begun;
}

int told(const json& document) {
  output = document.dump(-1, ' ', false, json::error_handler_t::replace);
  return 1;
}

std::uint64_t seed_in(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc{} || stop != text.data() + text.size())
    throw InputError("seed: expected a whole number from 0, got " + text);
  return seed;
}

Overrides overrides_in(const json& asked) {
  Overrides set;
  for (const json& one : asked.value("set", json::array())) set.emplace_back(one.at(0), one.at(1));
  return set;
}

Order order_of(const json& asked) {
  Order order{.yaml = asked.at("yaml"),
              .file = asked.at("file"),
              .set = {},
              .seed = {},
              .recording = nullptr,
              .filmed = asked.value("filmed", true),
              .thinkers = asked.value("thinkers", std::vector<std::size_t>{}),
              .changes = {}};
  order.set = overrides_in(asked);
  for (const json& change : asked.value("changes", json::array()))
    order.changes.push_back({change.at("at_s"), overrides_in(change)});
  if (asked.contains("seed") && !asked["seed"].is_null()) order.seed = seed_in(asked["seed"]);
  return order;
}

}  // namespace
}  // namespace fairway::web

using namespace fairway::web;

/// Where `size` bytes of the next input are to be written.
FAIRWAY_EXPORT(room) char* fairway_room(std::size_t size) {
  input.assign(size, '\0');
  return input.data();
}

/// The last text, and how long it is.
FAIRWAY_EXPORT(text) const char* fairway_text() { return output.data(); }
FAIRWAY_EXPORT(text_size) std::size_t fairway_text_size() { return output.size(); }

/// Begins the run that the input asks for: {"yaml", "file", "set": [[path, value]], "seed": text or null,
/// "filmed", "thinkers": [index], "changes": [{"at_s", "set"}]}. Where it is refused, the one before goes on.
FAIRWAY_EXPORT(load) int fairway_load() {
  return begin([] { return order_of(json::parse(input)); });
}

/// Begins the run of the recording whose bytes are the input, to be compared with it; `name_size` of these,
/// at the end, are its name. Where it is refused, the one before goes on.
FAIRWAY_EXPORT(load_recording) int fairway_load_recording(std::size_t name_size) {
  return begin([name_size] {
    const std::string name = input.substr(input.size() - name_size);
    input.resize(input.size() - name_size);
    return order_of_recording(std::exchange(input, {}), name);
  });
}

/// The bytes of this run's recording, as the text.
FAIRWAY_EXPORT(recording) int fairway_recording() {
  return tried([] {
    output = running().recording();
    return 1;
  });
}

/// Why the vehicle that the input names decided as it did at `time` [s].
FAIRWAY_EXPORT(explain) int fairway_explain(double time) {
  return tried([time] { return told(running().explanation(input, time)); });
}

/// So many steps more, or up to the end: how many were made. Afterwards done() says whether it is over.
FAIRWAY_EXPORT(run) int fairway_run(int steps) {
  return tried([steps] { return static_cast<int>(running().run(static_cast<std::size_t>(steps))); });
}
FAIRWAY_EXPORT(done) int fairway_done() {
  return tried([] { return running().is_done() ? 1 : 0; });
}
FAIRWAY_EXPORT(time) double fairway_time() {
  return of_run(std::numeric_limits<double>::quiet_NaN(), [](const Session& run) { return run.time(); });
}

/// The playback's document, a part of its film, what was measured, the names of methods and vehicles: as
/// JSON.
FAIRWAY_EXPORT(document) int fairway_document() {
  return tried([] { return told(running().document()); });
}
FAIRWAY_EXPORT(layout) int fairway_layout() {
  return tried([] { return told(running().layout()); });
}

/// The columns of the last part.
FAIRWAY_EXPORT(bytes) const char* fairway_bytes() {
  return of_run<const char*>(nullptr, [](const Session& run) { return run.bytes().data(); });
}
FAIRWAY_EXPORT(bytes_size) std::size_t fairway_bytes_size() {
  return of_run(std::size_t{0}, [](const Session& run) { return run.bytes().size(); });
}

/// From now on the film has what the vehicles think whose indices are the input, a list.
FAIRWAY_EXPORT(think) int fairway_think() {
  return tried([] {
    running().think(json::parse(input));
    return 1;
  });
}

FAIRWAY_EXPORT(part) int fairway_part(std::size_t first, std::size_t generation) {
  return tried([=] { return told(running().part(first, generation)); });
}
FAIRWAY_EXPORT(outcome) int fairway_outcome() {
  return tried([] { return told(running().outcome()); });
}
FAIRWAY_EXPORT(names) int fairway_names() {
  return tried([] { return told(names()); });
}

/// Of the name that is the input, as `fairway describe --json`.
FAIRWAY_EXPORT(describe) int fairway_describe() {
  return tried([] { return told(described(input)); });
}

/// Of all frames so far.
FAIRWAY_EXPORT(run_hash) std::uint64_t fairway_run_hash() {
  return of_run(std::uint64_t{0}, [](const Session& run) { return run.run_hash(); });
}

/// Of each frame so far, and how many frames there are.
FAIRWAY_EXPORT(hashes) const std::uint64_t* fairway_hashes() {
  return of_run<const std::uint64_t*>(nullptr, [](const Session& run) { return run.frame_hashes().data(); });
}
FAIRWAY_EXPORT(hash_count) std::size_t fairway_hash_count() {
  return of_run(std::size_t{0}, [](const Session& run) { return run.frame_hashes().size(); });
}
