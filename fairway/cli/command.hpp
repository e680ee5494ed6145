// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "fairway/sim/catalogs.hpp"

namespace fairway::cli {

/// The whole command, with every verb, over what `catalogs` offer: parses, runs the verb, turns InputError
/// into one line on stderr and exit code 2. A program with methods of its own adds them to builtin_catalogs()
/// and calls this from its main (examples/own_method). Studies keep to fairway's own methods.
int run_command(int argc, const char* const* argv, const Catalogs& catalogs = builtin_catalogs());

}  // namespace fairway::cli
