// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "fairway/scenario/load.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway::yaml {

/// The document with `--set` applied, its `fleet` written out, with `seed` if that is given, and with
/// `defaults` copied to every vehicle that does not say. Overrides reach values that come from the defaults,
/// as "vehicles[*].avoider.time_horizon_s" must; whether a key exists is for the reader to say. Throws
/// InputError naming the override.
void apply(Tree& document, const Overrides& overrides, std::optional<std::uint64_t> seed = {});

}  // namespace fairway::yaml
