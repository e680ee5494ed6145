// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "fairway/core/error.hpp"

namespace fairway {

/// What `action` is refused with; "accepted" if it is not.
template <class Action>
std::string refusal_by(Action&& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace fairway
