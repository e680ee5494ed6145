// SPDX-License-Identifier: Apache-2.0
// Messages as Cyclone DDS serialises them, for an independent reader, and what Cyclone makes of another's
// bytes.
//   ros2_samples write SEED COUNT   COUNT messages of each type with odd values: a line of JSON each, `type`,
//                                   `bytes` (hexadecimal, as on the wire) and `value` by member
//   ros2_samples read               lines `TYPE BYTES` in; the same lines of JSON out, with bytes serialised
//   anew
#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <functional>
#include <iostream>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <tuple>

#include "ros/ros2/memory.hpp"
#include "tests/ros2/fields.hpp"

namespace fairway::ros2 {
namespace {

using Json = nlohmann::ordered_json;

/// Fills every member with values that something could stumble over.
class Filling {
 public:
  Filling(std::mt19937_64& random, Memory& memory) : random_{random}, memory_{memory} {}

  template <class Member>
  Filling& operator()(const char*, Member& member) {
    fill(member);
    return *this;
  }

  template <class Message>
  void fill(Message& message) {
    if constexpr (requires { message._buffer; }) {
      for (auto& element : memory_.room(message, random_() % 4)) fill(element);
    } else {
      visit(message, *this);
    }
  }
  void fill(bool& value) { value = random_() % 2 == 1; }
  void fill(std::uint8_t& value) { value = static_cast<std::uint8_t>(random_()); }
  void fill(std::int32_t& value) { value = static_cast<std::int32_t>(random_()); }
  void fill(std::uint32_t& value) { value = static_cast<std::uint32_t>(random_()); }
  void fill(float& value) { value = odd<float, std::uint32_t>(); }
  void fill(double& value) { value = odd<double, std::uint64_t>(); }
  void fill(char*& value) { value = random_() % 8 == 0 ? nullptr : memory_.text(words()); }
  template <std::size_t n>
  void fill(char (&value)[n]) {
    const std::string text = words().substr(0, n - 1);
    std::memcpy(value, text.c_str(), text.size() + 1);
  }
  template <class Element, std::size_t n>
  void fill(Element (&values)[n]) {
    for (Element& value : values) fill(value);
  }

 private:
  template <class Number, class Bits>
  Number odd() {
    using Limits = std::numeric_limits<Number>;
    const std::array special{Number{0},     -Number{0},           Limits::infinity(), -Limits::infinity(),
                             Limits::max(), Limits::denorm_min(), Limits::epsilon(),  Number{1} / 3};
    const auto choice = random_() % 24;
    if (choice < special.size()) return special[choice];
    if (choice == special.size()) return Limits::quiet_NaN();
    const auto number = std::bit_cast<Number>(static_cast<Bits>(random_()));
    return std::isnan(number) ? Number{1.5} : number;
  }

  std::string words() {
    static const std::array<std::string, 8> some{
        "", "a", "ab", "abc", "world", "\"q\"\n\t\\", "Größe ≈ 3 m", "/long/name/of/a/thing/_0123456789"};
    return some[random_() % some.size()];
  }

  std::mt19937_64& random_;
  Memory& memory_;
};

/// The value by member; numbers that JSON does not have are texts.
class Telling {
 public:
  template <class Member>
  Telling& operator()(const char* name, Member& member) {
    json[name] = told(member);
    return *this;
  }

  template <class Message>
  static Json told(Message& message) {
    if constexpr (requires { message._buffer; }) {
      Json list = Json::array();
      for (std::uint32_t i = 0; i < message._length; ++i) list.push_back(told(message._buffer[i]));
      return list;
    } else {
      Telling telling;
      visit(message, telling);
      return telling.json;
    }
  }
  static Json told(bool& value) { return value; }
  static Json told(std::uint8_t& value) { return value; }
  static Json told(std::int32_t& value) { return value; }
  static Json told(std::uint32_t& value) { return value; }
  static Json told(float& value) {
    double wide = value;
    return told(wide);
  }
  static Json told(double& value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "NaN" : value > 0 ? "Infinity" : "-Infinity";
  }
  static Json told(char*& value) { return value == nullptr ? "" : value; }
  template <std::size_t n>
  static Json told(char (&value)[n]) {
    return std::string{value};
  }
  template <class Element, std::size_t n>
  static Json told(Element (&values)[n]) {
    Json list = Json::array();
    for (Element& value : values) list.push_back(told(value));
    return list;
  }

  Json json = Json::object();
};

std::string hexadecimal(const ddsi_serdata* data) {
  std::vector<unsigned char> bytes(ddsi_serdata_size(data));
  ddsi_serdata_to_ser(data, 0, bytes.size(), bytes.data());
  std::string text;
  for (const unsigned char byte : bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    text += {digits[byte >> 4], digits[byte & 15]};
  }
  return text;
}

std::vector<unsigned char> bytes_of(std::string_view text) {
  std::vector<unsigned char> bytes(text.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); ++i)
    std::from_chars(text.data() + 2 * i, text.data() + 2 * i + 2, bytes[i], 16);
  return bytes;
}

/// Takes the serialised form of what was written on `writer`.
ddsi_serdata* serialised(dds_entity_t reader) {
  ddsi_serdata* data = nullptr;
  dds_sample_info_t info{};
  if (dds_takecdr(reader, &data, 1, &info, DDS_ANY_STATE) != 1) throw std::runtime_error("nothing arrived");
  return data;
}

/// A writer of one type, and the reader that gets its serialised messages.
template <class Message>
class Loop {
 public:
  explicit Loop(dds_entity_t participant) {
    const auto& type = descriptor<Message>();
    std::string name = type.m_typename;
    std::replace(name.begin(), name.end(), ':', '_');
    const dds_entity_t topic = dds_create_topic(participant, &type, name.c_str(), nullptr, nullptr);
    dds_qos_t* const qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(10));
    reader_ = dds_create_reader(participant, topic, qos, nullptr);
    writer_ = dds_create_writer(participant, topic, qos, nullptr);
    dds_delete_qos(qos);
  }

  void print(Message& message) const {
    if (dds_write(writer_, &message) != DDS_RETCODE_OK) throw std::runtime_error("not written");
    ddsi_serdata* const data = serialised(reader_);
    std::cout << Json{{"type", descriptor<Message>().m_typename},
                      {"bytes", hexadecimal(data)},
                      {"value", Telling::told(message)}}
                     .dump()
              << '\n';
    ddsi_serdata_unref(data);
  }

  /// Cyclone's own description of the type, as its writers and readers use it.
  const ddsi_sertype* type() const {
    const Message message{};
    dds_write(writer_, &message);
    ddsi_serdata* const data = serialised(reader_);
    const ddsi_sertype* const type = data->type;
    ddsi_serdata_unref(data);
    return type;
  }

 private:
  dds_entity_t reader_{}, writer_{};
};

void write(dds_entity_t participant, std::uint64_t seed, int count) {
  std::mt19937_64 random{seed};
  for_each_message([&]<class Message>(Message) {
    const Loop<Message> loop{participant};
    for (int i = 0; i < count; ++i) {
      Memory memory;
      Message message{};
      Filling{random, memory}.fill(message);
      loop.print(message);
    }
  });
}

void read(dds_entity_t participant) {
  std::map<std::string, std::function<void(const std::vector<unsigned char>&)>> readers;
  for_each_message([&]<class Message>(Message) {
    const Loop<Message> loop{participant};
    readers[descriptor<Message>().m_typename] =
        [loop, type = loop.type()](const std::vector<unsigned char>& bytes) {
          // padded to whole words, as the protocol carries it
          std::vector<unsigned char> padded = bytes;
          padded.resize((padded.size() + 3) / 4 * 4);
          const ddsrt_iovec_t part{padded.data(), padded.size()};
          ddsi_serdata* const data = ddsi_serdata_from_ser_iov(type, SDK_DATA, 1, &part, padded.size());
          Message message{};
          if (data == nullptr || !ddsi_serdata_to_sample(data, &message, nullptr, nullptr))
            throw std::runtime_error(std::string{"not understood: "} + descriptor<Message>().m_typename);
          ddsi_serdata_unref(data);
          loop.print(message);
          dds_sample_free(&message, &descriptor<Message>(), DDS_FREE_CONTENTS);
        };
  });
  for (std::string type, text; std::cin >> type >> text;) readers.at(type)(bytes_of(text));
}

}  // namespace
}  // namespace fairway::ros2

int main(int argc, char** argv) {
  const std::vector<std::string> words{argv + 1, argv + argc};
  const dds_entity_t participant = dds_create_participant(DDS_DOMAIN_DEFAULT, nullptr, nullptr);
  if (words.size() == 3 && words[0] == "write")
    fairway::ros2::write(participant, std::stoull(words[1]), std::stoi(words[2]));
  else if (words.size() == 1 && words[0] == "read")
    fairway::ros2::read(participant);
  else
    return std::cerr << "usage: ros2_samples write SEED COUNT | ros2_samples read\n", 2;
  dds_delete(participant);
}
