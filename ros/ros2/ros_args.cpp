// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/ros_args.hpp"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>

namespace fairway::ros2 {
namespace {

using bridge::Settings;

std::pair<std::string, std::string> split(const std::string& text, const std::string& at) {
  const std::size_t place = text.find(at);
  if (place == std::string::npos || place == 0)
    throw std::runtime_error("'" + text + "': expected name" + at + "value");
  return {text.substr(0, place), text.substr(place + at.size())};
}

void flatten(const std::string& prefix, const YAML::Node& node, Settings& settings) {
  if (node.IsMap()) {
    for (const auto& entry : node) {
      const auto name = entry.first.as<std::string>();
      flatten(prefix.empty() ? name : prefix + "." + name, entry.second, settings);
    }
    return;
  }
  std::string text;
  if (node.IsSequence()) {
    for (const auto& entry : node) text += (text.empty() ? "" : " ") + entry.as<std::string>();
  } else {
    text = node.as<std::string>();
  }
  settings.emplace_back(prefix, text);
}

/// `/**`, `/space/node` or `node` above `ros__parameters`. What is for other nodes is left to them.
Settings settings_in(const std::string& file, const GraphOptions& options) {
  const std::string space = options.space == "/" ? "" : options.space;
  const std::array mine{std::string{"/**"}, options.node, space + "/" + options.node, "/**/" + options.node};
  Settings settings;
  try {
    for (const auto& entry : YAML::LoadFile(file)) {
      const auto name = entry.first.as<std::string>();
      if (std::find(mine.begin(), mine.end(), name) == mine.end()) continue;
      const YAML::Node parameters = entry.second["ros__parameters"];
      if (parameters) flatten("", parameters, settings);
    }
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(file + ": " + error.what());
  }
  return settings;
}

/// The words one after the other.
class Words {
 public:
  explicit Words(const std::vector<std::string>& words) : words_{words} {}
  bool is_over() const { return next_ == words_.size(); }
  const std::string& take() { return words_[next_++]; }
  const std::string& take_after(const std::string& flag) {
    if (is_over()) throw std::runtime_error(flag + ": expected a value after it");
    return take();
  }

 private:
  const std::vector<std::string>& words_;
  std::size_t next_{};
};

void read_of_ros(const std::string& word, Words& words, RosArguments& made, std::vector<std::string>& files) {
  if (word == "-p" || word == "--param") {
    made.settings.push_back(split(words.take_after(word), ":="));
  } else if (word == "-r" || word == "--remap") {
    const auto [from, to] = split(words.take_after(word), ":=");
    const std::string rule = from.substr(from.find(':') == std::string::npos ? 0 : from.find(':') + 1);
    if (rule == "__ns") {
      made.graph.space = to.starts_with('/') ? to : "/" + to;
    } else if (rule == "__node" || rule == "__name") {
      made.graph.node = to;
    } else {
      made.graph.remaps.emplace_back(rule, to);
    }
  } else if (word == "--params-file") {
    files.push_back(words.take_after(word));
  } else if (word == "--log-level" || word == "--log-config-file" || word == "-e" || word == "--enclave") {
    words.take_after(word);
  } else if (!word.starts_with("--enable-") && !word.starts_with("--disable-")) {
    throw std::runtime_error(word + ": not an argument of ROS; known: -p, -r, --params-file");
  }
}

void read_of_people(const std::string& word, Words& words, RosArguments& made) {
  if (word == "--set") {
    made.settings.push_back(split(words.take_after(word), "="));
  } else if (word.starts_with("--") && word.size() > 2) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(2, equals == std::string::npos ? equals : equals - 2);
    made.settings.emplace_back(
        name, equals == std::string::npos ? words.take_after(word) : word.substr(equals + 1));
  } else {
    made.words.push_back(word);
  }
}

}  // namespace

RosArguments ros_arguments(const std::vector<std::string>& arguments, const std::string& node) {
  RosArguments made;
  made.graph.node = node;
  made.graph.domain = domain_of_environment();
  made.graph.loopback_only = loopback_of_environment();

  Words words{arguments};
  std::vector<std::string> files;
  bool are_of_ros = false;
  while (!words.is_over()) {
    const std::string& word = words.take();
    if (word == "--ros-args") {
      are_of_ros = true;
    } else if (word == "--") {
      are_of_ros = false;
    } else if (are_of_ros) {
      read_of_ros(word, words, made, files);
    } else {
      read_of_people(word, words, made);
    }
  }

  Settings settings;
  for (const std::string& file : files) {
    const Settings some = settings_in(file, made.graph);
    settings.insert(settings.end(), some.begin(), some.end());
  }
  settings.insert(settings.end(), made.settings.begin(), made.settings.end());
  made.settings = std::move(settings);
  return made;
}

}  // namespace fairway::ros2
