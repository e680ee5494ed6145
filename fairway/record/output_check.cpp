// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/output_check.hpp"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "fairway/core/error.hpp"

namespace fairway {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const Output& output, const std::string& message) {
  throw InputError(output.flag + " " + output.path + ": " + message);
}

/// The same file, by whatever path, or the same name where there is none yet.
bool are_same(const std::string& a, const std::string& b) {
  std::error_code none;
  if (fs::equivalent(a, b, none)) return true;
  if (fs::exists(a, none) || fs::exists(b, none)) return false;
  return fs::weakly_canonical(fs::absolute(a, none), none) ==
         fs::weakly_canonical(fs::absolute(b, none), none);
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path{"."};
}

/// There is a folder to write in, and no folder in the way.
void check_place(const Output& output) {
  std::error_code none;
  const fs::path path{output.path};
  if (output.path == "-") refuse(output, "does not go to standard output; expected a file to write");
  if (fs::is_directory(path, none)) refuse(output, "is a folder; expected a file to write");
  if (!path.has_filename()) refuse(output, "cannot be written: there is no such folder");
  const fs::path folder = folder_of(path);
  if (fs::is_directory(folder, none)) return;
  refuse(output, "cannot be written: " + folder.string() +
                     (fs::exists(folder, none) ? " is no folder" : ": there is no such folder"));
}

void check_rights(const Output& output, bool is_there) {
  const bool writable = (!is_there || ::access(output.path.c_str(), W_OK) == 0) &&
                        ::access(folder_of(output.path).c_str(), W_OK | X_OK) == 0;
  if (!writable) refuse(output, "cannot be written: " + std::generic_category().message(errno));
}

void check_output(const Output& output, std::span<const std::string> inputs, bool force) {
  check_place(output);
  std::error_code none;
  const fs::file_status status = fs::status(output.path, none);
  if (fs::is_fifo(status) || fs::is_character_file(status)) return;
  if (fs::exists(status) && !fs::is_regular_file(status)) refuse(output, "is neither a file nor a pipe");
  for (const std::string& input : inputs) {
    if (are_same(output.path, input)) refuse(output, "is an input, too; expected another file");
  }
  check_rights(output, fs::exists(status));
  if (!force && fs::exists(status) && !is_of_kind(output.path, output.kind)) {
    const bool is_typed = output.flag.starts_with("--");
    refuse(output, "is there and is not " + std::string(output.kind.name) + "; expected another file" +
                       (is_typed ? ", or --force to replace it" : ""));
  }
}

}  // namespace

bool is_of_kind(const std::string& path, const FileKind& kind) {
  std::string head(kind.searched_bytes, '\0');
  std::ifstream file{path, std::ios::binary};
  if (!file) return false;
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head.empty() || (head.starts_with(kind.begins) && head.find(kind.holds) != std::string::npos);
}

void check_outputs(std::span<const Output> outputs, std::span<const std::string> inputs, bool force) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Output& output = outputs[i];
    if (output.path.empty() || (output.kind.is_table && output.path == "-")) continue;
    check_output(output, inputs, force);
    for (const Output& earlier : outputs.first(i)) {
      std::error_code none;
      if (are_same(output.path, earlier.path) && !fs::is_character_file(output.path, none))
        refuse(output, "is what " + earlier.flag + " writes; expected another file");
    }
  }
}

}  // namespace fairway
