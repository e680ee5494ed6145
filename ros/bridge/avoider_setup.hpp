// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fairway/onboard/helm.hpp"
#include "fairway/scenario/scenario.hpp"
#include "ros/bridge/avoider_host.hpp"

namespace fairway::bridge {

/// What a helm is made of.
struct AvoiderSetup {
  std::vector<ObstacleSpec> obstacles;  ///< hold the vertices of the helm's chart
  std::string algorithm;                ///< as it was chosen, wrappers included
  Pilot pilot;
  HelmSetup helm;
  Avoider avoider;
};

/// The options, carried out. Throws InputError: one line that says what is wrong and the nearest valid name.
AvoiderSetup avoider_setup(const AvoiderOptions& options);

/// The settings that there are, but for those of `params.`, `model.`, `steering.`, `policy.` and `team.`.
std::vector<std::string_view> setting_names();

}  // namespace fairway::bridge
