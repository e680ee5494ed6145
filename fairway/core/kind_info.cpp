// SPDX-License-Identifier: Apache-2.0
#include "fairway/core/kind_info.hpp"

#include <algorithm>
#include <string>

namespace fairway {

void require_known(std::string_view kind, std::string_view what, const std::vector<KindInfo>& kinds) {
  std::vector<std::string_view> names;
  for (const KindInfo& info : kinds) names.push_back(info.name);
  if (std::ranges::find(names, kind) == names.end())
    throw InputError({}, "kind", "unknown " + std::string(what) + suggestion(kind, names));
}

}  // namespace fairway
