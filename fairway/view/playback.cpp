// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/playback.hpp"

#include "fairway/report/page.hpp"
#include "fairway/view/columns.hpp"
#include "fairway/view/film_water.hpp"

namespace fairway {

nlohmann::json playback_document(const Scenario& scenario, const PlaybackInfo& info, const Film* film) {
  return {{"title", scenario.name},
          {"summary", scenario.summary},
          {"version", info.version},
          {"command", info.command},
          {"seed", std::to_string(scenario.seed)},
          {"period_s", info.period},
          {"duration_s", scenario.duration_s},
          {"scene", scene_of(scenario)},
          {"columns", FilmColumns::specs(current_depths(scenario.water).size())},
          {"film", film != nullptr ? film->part(0, film->size(), true) : nlohmann::json()},
          {"notice", film != nullptr ? film->notice() : ""},
          {"explanation", info.explanation}};
}

void write_playback(const std::string& path, const nlohmann::json& document) {
  const std::string text = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  write_whole(filled(embedded::view_template(), text), path, "the playback");
}

}  // namespace fairway
