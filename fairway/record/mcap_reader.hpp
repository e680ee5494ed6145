// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "fairway/record/bytes.hpp"
#include "fairway/record/mcap.hpp"

namespace fairway {

/// Reads an MCAP file from memory, which must outlive it. Checks every CRC and every length; throws
/// Malformed for what is truncated, damaged, of another major version or no MCAP file at all. Messages are
/// read in the order of the file, whether in chunks (zstd or not compressed) or not.
class McapReader {
 public:
  struct Schema {
    std::string name;
    std::string encoding;
    std::string text;
  };
  struct Channel {
    std::uint16_t schema{};
    std::string topic;
    std::string encoding;
  };
  struct Message {
    std::uint16_t channel{};
    std::uint64_t time{};  ///< log time [ns]
    ByteView data;         ///< valid during the call
  };
  using Map = std::map<std::string, std::string>;

  explicit McapReader(ByteView file);

  const std::string& profile() const { return profile_; }
  const std::string& library() const { return library_; }
  const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
  const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
  const std::map<std::string, Map>& metadata() const { return metadata_; }
  const std::map<std::string, std::string>& attachments() const { return attachments_; }

  void for_each_message(const std::function<void(const Message&)>& see) const;

 private:
  void collect(ByteView records);
  void collect(mcap::Opcode opcode, ByteView content);

  ByteView data_;  // records of the data section, after the header and before its end
  std::string profile_;
  std::string library_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::map<std::string, Map> metadata_;
  std::map<std::string, std::string> attachments_;
};

}  // namespace fairway
