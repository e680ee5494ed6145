// SPDX-License-Identifier: Apache-2.0
// The fairway command, with every verb, that knows one method and one vehicle more.
#include "fairway/cli/command.hpp"
#include "keep_right.hpp"
#include "nomoto_boat.hpp"

int main(int argc, char** argv) {
  fairway::Catalogs catalogs = fairway::builtin_catalogs();
  catalogs.avoiders.add<KeepRight>();
  catalogs.vehicles.add<NomotoBoat>();
  return fairway::cli::run_command(argc, argv, catalogs);
}
