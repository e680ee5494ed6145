// SPDX-License-Identifier: Apache-2.0
// A node's parameters as they are on the parameter server. C++17.
#pragma once

#include <xmlrpcpp/XmlRpcValue.h>

#include <cstdint>
#include <string>
#include <vector>

namespace fairway::ros1 {

// Each throws std::runtime_error that says "~name: what is wrong and what is expected".

/// A number from `least` to `most`; digits in text count as one, as roslaunch may hold them.
double number_in(const std::string& name, XmlRpc::XmlRpcValue value, double least, double most);
std::uint64_t count_in(const std::string& name, XmlRpc::XmlRpcValue value);
bool truth_in(const std::string& name, XmlRpc::XmlRpcValue value);
std::string words_in(const std::string& name, XmlRpc::XmlRpcValue value);
/// A list of texts, or one text whose parts stand between semicolons.
std::vector<std::string> list_in(const std::string& name, XmlRpc::XmlRpcValue value);

}  // namespace fairway::ros1
