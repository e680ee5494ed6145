// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/cli/program.hpp"

namespace fairway::cli {

/// The command as a test calls its parts: nothing was typed, and nobody stops it. Refers to `catalogs`.
inline Program program_of(const Catalogs& catalogs) {
  return {.typed = "",
          .chosen = {},
          .stop = nullptr,
          .name = "fairway",
          .catalogs = catalogs,
          .terminated = nullptr};
}

}  // namespace fairway::cli
