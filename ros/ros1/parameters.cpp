// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/parameters.hpp"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace fairway::ros1 {
namespace {

using XmlRpc::XmlRpcValue;

std::string shown(XmlRpcValue value) {
  std::ostringstream text;
  if (value.getType() == XmlRpcValue::TypeString) {
    text << "'" << static_cast<std::string>(value) << "'";
  } else {
    text << value;
  }
  return text.str();
}

[[noreturn]] void refuse(const std::string& name, const XmlRpcValue& value, const std::string& expected) {
  throw std::runtime_error("~" + name + ": " + shown(value) + ": expected " + expected);
}

std::string short_text(double number) {
  std::ostringstream text;
  text << number;
  return text.str();
}

}  // namespace

double number_in(const std::string& name, XmlRpcValue value, double least, double most) {
  double number = std::nan("");
  if (value.getType() == XmlRpcValue::TypeInt) number = static_cast<int>(value);
  if (value.getType() == XmlRpcValue::TypeDouble) number = static_cast<double>(value);
  if (value.getType() == XmlRpcValue::TypeString) {
    const std::string text = value;
    char* end = nullptr;
    const double read = std::strtod(text.c_str(), &end);
    if (!text.empty() && *end == '\0') number = read;
  }
  if (!(number >= least && number <= most))
    refuse(name, value, "a number from " + short_text(least) + " to " + short_text(most));
  return number;
}

std::uint64_t count_in(const std::string& name, XmlRpcValue value) {
  constexpr double greatest_exact = 9007199254740992.0;
  const double number = number_in(name, value, 0.0, greatest_exact);
  if (number != std::floor(number)) refuse(name, value, "a whole number");
  return static_cast<std::uint64_t>(number);
}

bool truth_in(const std::string& name, XmlRpcValue value) {
  if (value.getType() == XmlRpcValue::TypeBoolean) return static_cast<bool>(value);
  if (value.getType() == XmlRpcValue::TypeString) {
    const std::string text = value;
    if (text == "true" || text == "false") return text == "true";
  }
  refuse(name, value, "true or false");
}

std::string words_in(const std::string& name, XmlRpcValue value) {
  if (value.getType() != XmlRpcValue::TypeString) refuse(name, value, "text");
  return value;
}

std::vector<std::string> list_in(const std::string& name, XmlRpcValue value) {
  std::vector<std::string> parts;
  if (value.getType() == XmlRpcValue::TypeArray) {
    for (int i = 0; i < value.size(); ++i) parts.push_back(words_in(name, value[i]));
    return parts;
  }
  std::istringstream text{words_in(name, value)};
  for (std::string part; std::getline(text, part, ';');) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

}  // namespace fairway::ros1
