// SPDX-License-Identifier: Apache-2.0
#include "fairway/cli/outputs.hpp"

#include "fairway/cli/paths.hpp"

namespace fairway::cli {

Outputs::Outputs(CLI::App& verb) : verb_{&verb} {
  verb.add_flag("--force", force_, "write over a file of another kind, too; never over an input");
}

CLI::Option* Outputs::add(const std::string& flag, std::string& path, const FileKind& kind,
                          const std::string& help) {
  declared_.push_back({flag, &path, kind});
  return verb_->add_option(flag, path, help)->check(not_empty())->type_name("FILE");
}

void Outputs::judge(const std::vector<std::string>& inputs, const std::vector<Output>& more) const {
  std::vector<Output> outputs;
  for (const Declared& declared : declared_)
    outputs.push_back({declared.flag, *declared.path, declared.kind});
  outputs.insert(outputs.end(), more.begin(), more.end());
  check_outputs(outputs, inputs, force_);
}

}  // namespace fairway::cli
