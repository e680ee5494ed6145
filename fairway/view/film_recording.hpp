// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <functional>
#include <string>

#include "fairway/record/recording.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/sim/catalogs.hpp"
#include "fairway/view/film.hpp"

namespace fairway {

/// Whoever waits for a recording to be shown.
struct FilmWatch {
  const std::atomic<bool>* stop{nullptr};  ///< ends it early; may be null
  std::function<void()> tell;              ///< called after each frame; may be empty
};

/// Plays the recording into `film`; false if stopped. O(recording).
bool show_recorded(const Recording& recording, Film& film, const FilmWatch& watch = {});

/// Simulates `scenario`, the recorded one, again into `film`, with what its vehicles thought; false if
/// stopped. Throws InputError, about the recording `name`, where `catalogs` lack a method of it or another
/// run comes of it. O(run).
bool show_again(const Recording& recording, const Scenario& scenario, const Catalogs& catalogs,
                const std::string& name, Film& film, const FilmWatch& watch = {});

/// Whether the recording itself holds what its vehicles thought.
bool holds_thoughts(const Recording& recording);

}  // namespace fairway
