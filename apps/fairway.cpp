// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/command.hpp"

int main(int argc, char** argv) { return fairway::cli::run_command(argc, argv); }
