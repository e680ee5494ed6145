// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/core/error.hpp"

namespace fairway {

/// What the InputError says that `use` throws, or "accepted".
template <class Use>
std::string refusal_by(const Use& use) {
  try {
    use();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace fairway
