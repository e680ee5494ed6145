// SPDX-License-Identifier: Apache-2.0
#include "fairway/view/playback.hpp"

namespace fairway {

nlohmann::json playback_document(const Scenario&, const PlaybackInfo&, const Film*) { return {}; }
nlohmann::json scene_of(const Scenario&) { return {}; }

}  // namespace fairway
