// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/cli/program.hpp"
#include "fairway/experiment/campaign.hpp"

namespace fairway::cli {

/// What this program has besides fairway's methods. The version of a method is its own constant `version`; of
/// one without, a digest of this program's own file, so that no run of another build is taken for one of
/// this.
OwnMethods own_methods(const Program& program);

}  // namespace fairway::cli
