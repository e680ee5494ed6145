// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "fairway/record/output_check.hpp"
#include "fairway/scenario/scenario.hpp"
#include "fairway/view/film.hpp"

namespace fairway {

namespace embedded {

/// fairway/view/template.html as it was when this library was built.
std::string view_template();

}  // namespace embedded

/// As write_playback() writes it.
inline constexpr FileKind playback_file{
    .name = "a playback of fairway", .begins = "<!doctype html>", .holds = "<title>fairway view</title>"};

/// What the page says about itself.
struct PlaybackInfo {
  std::string version;         ///< of fairway, that made the recording
  std::string command;         ///< as typed
  double period{};             ///< between frames of the run [s]
  nlohmann::json explanation;  ///< of one decision, or null
};

/// The page's document: the scene and, unless `film` is null, as live, all of the film, compressed. The
/// scenario is one that the catalogs accept. O(film).
nlohmann::json playback_document(const Scenario& scenario, const PlaybackInfo& info, const Film* film);

/// Writes the page that shows `document` to `path`, whole or not at all, and says how many bytes it has.
/// Throws InputError if it cannot be written.
std::size_t write_playback(const std::string& path, const nlohmann::json& document);

/// What stands still in a run: vehicles, obstacles, rules, water, sensors. The document's `scene`.
nlohmann::json scene_of(const Scenario& scenario);

}  // namespace fairway
