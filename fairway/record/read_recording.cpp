// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

#include "fairway/core/error.hpp"
#include "fairway/record/recording.hpp"

namespace fairway {

Recording Recording::read(const std::string& file) {
  const auto refuse = [&](const std::string& reason) {
    throw InputError{{.file = file}, "", "cannot be read: " + reason + "; expected a recording (MCAP)"};
  };
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) refuse(error.message());
  Bytes bytes(static_cast<std::size_t>(size));
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream{std::fopen(file.c_str(), "rb"), std::fclose};
  if (!stream || std::fread(bytes.data(), 1, bytes.size(), stream.get()) != bytes.size()) {
    refuse(std::generic_category().message(errno));
  }
  return parse(bytes, file);
}

}  // namespace fairway
