// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "fairway/core/params.hpp"

namespace fairway {

/// One kind of exchange, perception or navigation that a scenario may choose, as `fairway describe` tells it.
struct KindInfo {
  std::string_view name;
  std::string_view title;
  std::string_view source;
  std::vector<ParamInfo> params;
};

/// Throws InputError, with the nearest known name, unless `kind` is one of `kinds`; `what` is chosen.
void require_known(std::string_view kind, std::string_view what, const std::vector<KindInfo>& kinds);

}  // namespace fairway
