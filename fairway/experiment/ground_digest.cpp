// SPDX-License-Identifier: Apache-2.0
#include "fairway/experiment/ground_digest.hpp"

#include <cstdint>

#include "fairway/experiment/campaign.hpp"
#include "fairway/experiment/digest.hpp"
#include "fairway/scenario/load.hpp"

namespace fairway {

std::string ground_digest(std::string_view text, const std::string& file) {
  constexpr std::uint64_t any_seed = 1;
  return Digest::of(
      canonical_text(parse_scenario(text, file, {{"vehicles[*].avoider", "direct"}}, any_seed)));
}

}  // namespace fairway
