// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/film_recording.hpp"

#include <array>

#include "fairway/experiment/recording_info.hpp"
#include "fairway/record/hash_checker.hpp"
#include "fairway/sim/simulation.hpp"

namespace fairway {
namespace {

bool is_stopped(const FilmWatch& watch) {
  return watch.stop != nullptr && watch.stop->load(std::memory_order_relaxed);
}

}  // namespace

bool show_recorded(const Recording& recording, Film& film, const FilmWatch& watch) {
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (is_stopped(watch)) return false;
    film.write(recording.frame(i));
    if (watch.tell) watch.tell();
  }
  return true;
}

bool show_again(const Recording& recording, const Scenario& scenario, const Catalogs& catalogs,
                const std::string& name, Film& film, const FilmWatch& watch) {
  check_methods(recording, scenario, catalogs, name);
  Simulation simulation{scenario, catalogs};
  simulation.show_thoughts(true);
  HashChecker checker{recording};
  const std::array<FrameSink*, 2> sinks{&checker, &film};
  while (!simulation.is_done() && !checker.is_over()) {
    if (is_stopped(watch)) return false;
    simulation.step(sinks);
    if (checker.first_mismatch()) break;
    if (watch.tell) watch.tell();
  }
  if (!checker.same()) {
    throw InputError(name + ": what was drawn (--sketch) comes of simulating it again, but the run " +
                     checker.describe());
  }
  return true;
}

bool holds_thoughts(const Recording& recording) {
  return recording.info().perception && recording.info().sketches;
}

}  // namespace fairway
