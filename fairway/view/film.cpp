// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fairway/experiment/measure_run.hpp"
#include "fairway/metrics/progress.hpp"
#include "fairway/view/columns.hpp"
#include "fairway/view/film_bytes.hpp"
#include "fairway/view/film_events.hpp"
#include "fairway/view/film_thoughts.hpp"
#include "fairway/view/film_water.hpp"

namespace fairway {

struct Film::Contents {
  Contents(const Scenario& scenario, const FilmLimits& its_limits, const Catalog* avoiders)
      : limits{its_limits},
        surroundings{surroundings_of(scenario)},
        water{scenario},
        events{{scenario.exam.crit_dist_m, scenario.exam.safety_distance_m}, scenario.vehicles.size()},
        progress{scenario.exam.progress_window_s, surroundings},
        thoughts{{scenario, avoiders}, scenario.vehicles.size(), limits.thought_bytes, limits.thinkers},
        columns{scenario.vehicles.size(), current_depths(scenario.water).size()},
        stride{limits.every} {}

  void keep(const Frame& frame) {
    columns.append(frame, {water.currents(), events.alerts(), surroundings.limits, progress});
  }
  void remember(const Frame& frame);
  void thin();

  FilmLimits limits;
  Surroundings surroundings;
  FilmWater water;
  FilmEvents events;
  ProgressMetric progress;
  FilmThoughts thoughts;
  FilmColumns columns;
  std::size_t seen{};  // frames between from_s and to_s
  std::size_t stride;
  std::size_t generation{};
  std::vector<VehicleFrame> last_vehicles;
  Frame last;  // unless it was kept
  bool last_kept{true};
  std::string divergence;
};

void Film::Contents::remember(const Frame& frame) {
  last_vehicles.assign(frame.vehicles.begin(), frame.vehicles.end());
  last = frame;
  last.vehicles = last_vehicles;
}

void Film::Contents::thin() {
  last_kept = last_kept && columns.size() % 2 == 1;
  columns.halve();
  stride *= 2;
  ++generation;
}

Film::Film(const Scenario& scenario, const FilmLimits& limits, const Catalog* avoiders)
    : contents_{std::make_unique<Contents>(scenario, limits, avoiders)} {}
Film::~Film() = default;

void Film::write(const Frame& frame) {
  Contents& c = *contents_;
  if (frame.time > c.limits.to_s) return;
  c.water.move_to(frame.tick);
  c.events.see(frame);
  c.progress.see(frame);
  if (frame.time < c.limits.from_s) return;
  c.thoughts.see(frame);
  c.last_kept = c.seen++ % c.stride == 0;
  if (c.last_kept) c.keep(frame);
  if (c.columns.size() * frame.vehicles.size() > c.limits.vehicle_frames && c.columns.size() > 2) c.thin();
  if (!c.last_kept) c.remember(frame);
}

void Film::finish(std::string_view divergence) {
  Contents& c = *contents_;
  c.divergence = divergence;
  if (!c.last_kept) c.keep(c.last);
  c.last_kept = true;
}

std::size_t Film::size() const { return contents_->columns.size(); }
std::size_t Film::stride() const { return contents_->stride; }
std::size_t Film::generation() const { return contents_->generation; }
bool Film::has_sketches() const { return contents_->thoughts.has_sketches(); }

std::string Film::column_bytes(std::size_t first, std::size_t count) const {
  return contents_->columns.bytes(first, count);
}

std::string Film::thoughts_before(std::size_t end) const {
  const Contents& c = *contents_;
  if (end == 0) return {};
  return base64_of(c.thoughts.between(std::nextafter(c.limits.from_s, -1.0), c.columns.time(end - 1)));
}

nlohmann::json Film::part(std::size_t first, std::size_t most, Packing packing) const {
  const Contents& c = *contents_;
  first = std::min(first, size());
  const std::size_t count = std::min(most, size() - first);
  const bool compress = packing == Packing::compressed;
  const auto packed = [compress](const std::string& bytes) {
    return bytes.empty() ? "" : base64_of(compress ? zstd_of(bytes) : bytes);
  };
  nlohmann::json part{{"first", first},
                      {"count", count},
                      {"stride", c.stride},
                      {"generation", c.generation},
                      {"data", packing == Packing::apart ? "" : packed(c.columns.bytes(first, count))},
                      {"compression", compress ? "zstd" : "none"},
                      {"events", nlohmann::json::array()},
                      {"thoughts", ""}};
  if (count == 0) return part;
  const double after = first == 0 ? std::nextafter(c.limits.from_s, -1.0) : c.columns.time(first - 1);
  const double until = c.columns.time(first + count - 1);
  part["events"] = c.events.between(after, until);
  part["thoughts"] = packed(c.thoughts.between(after, until));
  return part;
}

const std::string& Film::divergence() const { return contents_->divergence; }

std::string Film::notice() const {
  const Contents& c = *contents_;
  std::string text;
  if (!c.divergence.empty())
    text += fmt::format("The run {}. It ends before that, and has no results. ", c.divergence);
  if (c.stride > 1)
    text += fmt::format("Of {} frames one in {} is shown; colours and events are those of every frame. ",
                        c.seen, c.stride);
  if (c.thoughts.spacing() > 1)
    text += fmt::format("What each vehicle drew, knew and heard is shown at most once in {} frames. ",
                        c.thoughts.spacing());
  if (c.thoughts.transmission_stride() > 1)
    text += fmt::format("Of the transmissions one in {} is shown. ", c.thoughts.transmission_stride());
  if (!text.empty()) text.pop_back();
  return text;
}

}  // namespace fairway
