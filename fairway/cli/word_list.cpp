// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/word_list.hpp"

#include <algorithm>
#include <cstddef>

namespace fairway::cli {
namespace {

std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t from = 0;
  for (std::size_t comma = text.find(','); comma != std::string::npos; comma = text.find(',', from)) {
    parts.push_back(text.substr(from, comma - from));
    from = comma + 1;
  }
  parts.push_back(text.substr(from));
  return parts;
}

}  // namespace

CLI::Option* add_word_list(CLI::App& verb, const std::string& flag, std::vector<std::string>& words,
                           const std::string& help, const CLI::Validator& each) {
  const auto read = [&words, flag, each](const std::vector<std::string>& typed) {
    words.clear();
    for (const std::string& text : typed) {
      for (std::string part : parts_of(text)) {
        if (const std::string fault = each(part); !fault.empty()) throw CLI::ValidationError(flag, fault);
        if (part.empty())
          throw CLI::ValidationError(
              flag, "\"" + text + "\" has an empty part; expected names with a comma between them");
        if (std::ranges::find(words, part) != words.end())
          throw CLI::ValidationError(flag, part + " is given twice; expected each once");
        words.push_back(std::move(part));
      }
    }
  };
  return verb.add_option_function<std::vector<std::string>>(flag, read, help)->type_name("NAMES");
}

}  // namespace fairway::cli
