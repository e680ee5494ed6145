// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "fairway/dynamics/vehicle.hpp"

namespace fairway {

/// The vehicles a program offers, by name. An ordinary value: nothing registers itself.
class VehicleCatalog {
 public:
  struct Entry {
    VehicleInfo info;
    std::vector<ParamInfo> params;
    std::function<Vehicle(const ParamValues&)> make;
  };

  template <VehicleModel M>
  VehicleCatalog& add() {
    entries_.push_back({M::info, describe_params<typename M::Params>(), [](const ParamValues& values) {
                          return Vehicle{M{params_of<typename M::Params>(values)}};
                        }});
    return *this;
  }

  /// Throws InputError for an unknown vehicle or parameter, with the nearest known name.
  Vehicle make(std::string_view name, const ParamValues& values = {}) const {
    return find(name).make(values);
  }
  const Entry& find(std::string_view name) const;
  std::span<const Entry> entries() const { return entries_; }

 private:
  std::vector<Entry> entries_;
};

/// Every vehicle that comes with fairway.
VehicleCatalog builtin_vehicles();

}  // namespace fairway
