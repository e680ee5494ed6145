// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/own_methods.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "fairway/experiment/digest.hpp"

namespace fairway::cli {
namespace {

std::string digest_of_this_program() {
  std::ifstream file{"/proc/self/exe", std::ios::binary};
  const std::string bytes{std::istreambuf_iterator<char>{file}, {}};
  if (!file || bytes.empty()) {
    throw InputError(
        "this program's own file cannot be read, so stored runs of its methods could go stale: give each a "
        "constant `version`");
  }
  return Digest::of(bytes);
}

/// "mine is of version 2".
std::string version_text(std::string_view name, std::string_view version) {
  if (!version.empty()) return std::string(name) + " is of version " + std::string(version);
  static const std::string program = digest_of_this_program();
  return std::string(name) + " is of the program " + program;
}

}  // namespace

OwnMethods own_methods(const Program& program) {
  const auto version = [&own = program.catalogs, known = builtin_catalogs()](const Scenario& scenario) {
    const auto is_known_vehicle = [&](const std::string& name) {
      return std::ranges::any_of(known.vehicles.entries(),
                                 [&](const VehicleCatalog::Entry& entry) { return entry.info.name == name; });
    };
    std::set<std::string> versions;
    for (const VehicleSpec& vehicle : scenario.vehicles) {
      for (const std::string_view layer : layer_names(vehicle.avoider->name)) {
        if (!known.avoiders.has(layer))
          versions.insert(version_text(layer, own.avoiders.find(layer).version));
      }
      if (!is_known_vehicle(vehicle.model->name)) versions.insert(version_text(vehicle.model->name, {}));
    }
    std::string all;
    for (const std::string& text : versions) all += text + "\n";
    return all;
  };
  return {.version = version, .program = program.name};
}

}  // namespace fairway::cli
