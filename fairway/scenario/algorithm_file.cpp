// SPDX-License-Identifier: Apache-2.0
#include "fairway/scenario/algorithm_file.hpp"

#include <optional>

#include "fairway/core/error.hpp"
#include "fairway/scenario/block.hpp"
#include "fairway/scenario/tree.hpp"

namespace fairway {

bool is_algorithm_file(const std::string& name) { return name.ends_with(".yaml"); }

Choice load_algorithm(const std::string& file) {
  const std::optional<std::string> text = yaml::document_in(file);
  if (!text) throw InputError(file + ": cannot be opened for reading");
  const yaml::Tree document = yaml::parse_tree(*text, file);
  yaml::Reading reading;
  return yaml::read_choice({document, "", reading}, "algorithm", yaml::Needed::yes);
}

}  // namespace fairway
