// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/playback.hpp"

#include "fairway/record/output_file.hpp"
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
          {"film", film != nullptr ? film->part(0, film->size(), Packing::compressed) : nlohmann::json()},
          {"divergence", film != nullptr ? film->divergence() : ""},
          {"notice", film != nullptr ? film->notice() : ""},
          {"explanation", info.explanation}};
}

std::size_t write_playback(const std::string& path, const nlohmann::json& document) {
  const std::string text = document.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::string page = filled(embedded::view_template(), text);
  write_file(path, page);
  return page.size();
}

}  // namespace fairway
