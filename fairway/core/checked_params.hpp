// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/core/params.hpp"

namespace fairway {

/// `params`, to be initialised with. Throws InputError as check_params().
template <Reflected P>
const P& checked_params(const P& params) {
  check_params(params);
  return params;
}

}  // namespace fairway
