// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/ros_args.hpp"

#include <yaml-cpp/yaml.h>

#include <span>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace fairway::ros2 {
namespace {

using bridge::Settings;

std::pair<std::string, std::string> split(const std::string& text, const std::string& at) {
  const std::size_t place = text.find(at);
  if (place == std::string::npos || place == 0)
    throw std::runtime_error("'" + text + "': expected name" + at + "value");
  return {text.substr(0, place), text.substr(place + at.size())};
}

/// What is said of one node, "NODE:NAME:=VALUE", or, with an empty `node`, of whichever is started.
struct Rule {
  std::string node, name, value;
};

Rule rule_of(const std::string& text) {
  auto [name, value] = split(text, ":=");
  const std::size_t colon = name.find(':');
  if (colon == std::string::npos) return {"", name, value};
  return {name.substr(0, colon), name.substr(colon + 1), value};
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

/// The value of `-p`, which is YAML: a list, a text in quotes.
void add_parameter(const Rule& rule, Settings& settings) {
  try {
    const YAML::Node value = YAML::Load(rule.value);
    if (value.IsNull()) {
      settings.emplace_back(rule.name, rule.value);
    } else {
      flatten(rule.name, value, settings);
    }
  } catch (const YAML::Exception& error) {
    throw std::runtime_error(rule.name + ":=" + rule.value + ": " + error.what());
  }
}

using Parts = std::vector<std::string>;

/// "/fleet/auv_1/pilot" is fleet, auv_1, pilot.
Parts parts_of(const std::string& name) {
  Parts parts;
  std::istringstream rest{name};
  for (std::string part; std::getline(rest, part, '/');)
    if (!part.empty()) parts.push_back(part);
  return parts;
}

/// `*` stands for one part, `**` for any number of them.
bool matches(std::span<const std::string> pattern, std::span<const std::string> name) {
  if (pattern.empty()) return name.empty();
  if (pattern.front() == "**")
    return matches(pattern.subspan(1), name) || (!name.empty() && matches(pattern, name.subspan(1)));
  return !name.empty() && (pattern.front() == "*" || pattern.front() == name.front()) &&
         matches(pattern.subspan(1), name.subspan(1));
}

/// What a file says of one node: below its name, which may stand in parts, one above the other, and have
/// wildcards. What is for other nodes is left to them.
class ParametersOf {
 public:
  explicit ParametersOf(const GraphOptions& options)
      : name_{parts_of(options.space + "/" + options.node)}, node_{options.node} {}

  /// Whether it says anything.
  bool read(const std::string& file, Settings& settings) {
    bool any = false;
    try {
      walk("", YAML::LoadFile(file), settings, any);
    } catch (const YAML::Exception& error) {
      throw std::runtime_error(file + ": " + error.what());
    }
    return any;
  }

 private:
  void walk(const std::string& above, const YAML::Node& map, Settings& settings, bool& any) const {
    if (!map.IsMap()) return;
    for (const auto& entry : map) {
      const auto key = entry.first.as<std::string>();
      if (key != "ros__parameters") {
        walk(above.empty() ? key : above + "/" + key, entry.second, settings, any);
      } else if (above == node_ || matches(parts_of(above), name_)) {  // a bare name: in whatever namespace
        any = true;
        if (entry.second.IsMap()) flatten("", entry.second, settings);
      }
    }
  }

  Parts name_;
  std::string node_;
};

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

/// What is said, of this node and others, in order.
struct Said {
  std::vector<Rule> remaps;
  std::vector<std::pair<std::string, Settings>> settings;  // of which node, as of a Rule
};

void read_of_ros(const std::string& word, Words& words, RosArguments& made, Said& said) {
  if (word == "-p" || word == "--param") {
    const Rule rule = rule_of(words.take_after(word));
    add_parameter(rule, said.settings.emplace_back(rule.node, Settings{}).second);
  } else if (word == "-r" || word == "--remap") {
    said.remaps.push_back(rule_of(words.take_after(word)));
  } else if (word == "--params-file") {
    made.files.push_back(words.take_after(word));
  } else if (word == "--log-level" || word == "--log-config-file" || word == "-e" || word == "--enclave") {
    words.take_after(word);
  } else if (!word.starts_with("--enable-") && !word.starts_with("--disable-")) {
    throw std::runtime_error(word + ": not an argument of ROS; known: -p, -r, --params-file");
  }
}

void read_of_people(const std::string& word, Words& words, RosArguments& made, Said& said) {
  const auto set = [&](const std::string& name, const std::string& text) {
    said.settings.emplace_back("", Settings{{name, text}});
  };
  if (word == "--set") {
    const auto [name, text] = split(words.take_after(word), "=");
    set(name, text);
  } else if (word.starts_with("--") && word.size() > 2) {
    const std::size_t equals = word.find('=');
    const std::string name = word.substr(2, equals == std::string::npos ? equals : equals - 2);
    set(name, equals == std::string::npos ? words.take_after(word) : word.substr(equals + 1));
  } else {
    made.words.push_back(word);
  }
}

bool names_node(const std::string& rule) { return rule == "__node" || rule == "__name"; }

/// Takes what is said of this node: by the name that it has by itself, or by the one that it is given.
void take_own(const Said& said, RosArguments& made) {
  const std::string usual = made.graph.node;
  for (const Rule& rule : said.remaps)
    if (names_node(rule.name) && (rule.node.empty() || rule.node == usual)) made.graph.node = rule.value;
  const auto is_own = [&](const std::string& node) {
    return node.empty() || node == usual || node == made.graph.node;
  };
  for (const Rule& rule : said.remaps) {
    if (!is_own(rule.node) || names_node(rule.name)) continue;
    if (rule.name == "__ns") {
      made.graph.space = rule.value.starts_with('/') ? rule.value : "/" + rule.value;
    } else {
      made.graph.remaps.emplace_back(rule.name, rule.value);
    }
  }
  for (const auto& [node, settings] : said.settings)
    if (is_own(node)) made.given.insert(made.given.end(), settings.begin(), settings.end());
}

}  // namespace

RosArguments ros_arguments(const std::vector<std::string>& arguments, const std::string& node) {
  RosArguments made;
  made.graph.node = node;
  made.graph.domain = domain_of_environment();
  made.graph.loopback_only = loopback_of_environment();

  Words words{arguments};
  Said said;
  bool are_of_ros = false;
  while (!words.is_over()) {
    const std::string& word = words.take();
    if (word == "--ros-args") {
      are_of_ros = true;
    } else if (word == "--") {
      are_of_ros = false;
    } else if (are_of_ros) {
      read_of_ros(word, words, made, said);
    } else {
      read_of_people(word, words, made, said);
    }
  }
  take_own(said, made);
  return made;
}

bridge::Settings settings_of(const RosArguments& arguments,
                             const std::function<void(const std::string&)>& warn) {
  ParametersOf parameters{arguments.graph};
  Settings settings;
  for (const std::string& file : arguments.files) {
    if (parameters.read(file, settings) || !warn) continue;
    const std::string& space = arguments.graph.space;
    warn(file + ": has no parameters for " + (space == "/" ? "" : space) + "/" + arguments.graph.node);
  }
  settings.insert(settings.end(), arguments.given.begin(), arguments.given.end());
  return settings;
}

}  // namespace fairway::ros2
