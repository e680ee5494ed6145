// SPDX-License-Identifier: Apache-2.0
#include "fairway/world/obstacle_field.hpp"

#include <utility>

namespace fairway {

ObstacleField::ObstacleField(std::vector<ObstacleSpec> specs) : specs_{std::move(specs)} {
  for (std::size_t i = 0; i < specs_.size(); ++i) {
    const ObstacleSpec& spec = specs_[i];
    if (spec.moves()) {
      drifters_.push_back({static_cast<std::uint32_t>(i), spec.position, spec.velocity, spec.radius});
    } else {
      fixed_.push_back(spec.view());
    }
  }
  if (indexes() == nullptr) return;
  const auto index_where = [&](bool charted) {
    return ObstacleIndex{fixed_.size(),
                         [&](std::size_t i) { return fixed_[i].charted == charted ? &fixed_[i] : nullptr; }};
  };
  indexes_ = {index_where(true), index_where(false)};
}

ObstacleField& ObstacleField::operator=(ObstacleField other) noexcept {
  std::swap(specs_, other.specs_);
  std::swap(fixed_, other.fixed_);
  std::swap(indexes_, other.indexes_);
  std::swap(drifters_, other.drifters_);
  return *this;
}

void ObstacleField::move_to(double time) noexcept {
  for (Drifter& drifter : drifters_)
    drifter.position = specs_[drifter.number].position + time * drifter.velocity;
}

}  // namespace fairway
