// SPDX-License-Identifier: Apache-2.0
// The fairway command, with every verb, that knows one method more.
#include "fairway/cli/command.hpp"
#include "keep_right.hpp"

int main(int argc, char** argv) {
  fairway::Catalogs catalogs = fairway::builtin_catalogs();
  catalogs.avoiders.add<KeepRight>();
  return fairway::cli::run_command(argc, argv, catalogs);
}
