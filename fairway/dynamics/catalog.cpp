// SPDX-License-Identifier: Apache-2.0
#include "fairway/dynamics/catalog.hpp"

namespace fairway {

const VehicleCatalog::Entry& VehicleCatalog::find(std::string_view name) const {
  std::vector<std::string_view> known;
  for (const Entry& entry : entries_) {
    if (entry.info.name == name) return entry;
    known.push_back(entry.info.name);
  }
  throw InputError("unknown vehicle \"" + std::string(name) + "\"" + suggestion(name, known));
}

}  // namespace fairway
