// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/master_watch.hpp"

#include <ros/connection_manager.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <ros/xmlrpc_manager.h>
#include <xmlrpcpp/XmlRpcClient.h>
#include <xmlrpcpp/XmlRpcException.h>

#include <chrono>
#include <exception>
#include <set>
#include <utility>

namespace fairway::ros1 {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double watch_period_s = 1.0;
constexpr double patience_s = 2.0;     // for an answer
constexpr double others_need_s = 2.5;  // to see that the master is back: more than a watch period
constexpr int deaf_periods = 8;        // between looks for subscriptions without a connection

struct Endpoint {
  std::string host;
  int port;
};

Endpoint master_endpoint() { return {ros::master::getHost(), static_cast<int>(ros::master::getPort())}; }

/// This node's own interface, which knows its topics.
Endpoint own_endpoint() {
  std::string host;
  std::uint32_t port{};
  ros::network::splitURI(ros::XMLRPCManager::instance()->getServerURI(), host, port);
  return {host, static_cast<int>(port)};
}

/// The value that `method` answers, or none: nobody there, no answer in time, or refused.
template <class... Arguments>
std::optional<XmlRpcValue> ask(const Endpoint& whom, const std::atomic<bool>& stopping, const char* method,
                               const Arguments&... arguments) {
  XmlRpcValue parameters;
  int count = 0;
  parameters[count++] = ros::this_node::getName();
  ((parameters[count++] = arguments), ...);

  XmlRpc::XmlRpcClient client{whom.host.c_str(), whom.port, "/"};
  if (!client.executeNonBlock(method, parameters)) return {};
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::duration<double>(patience_s);
  XmlRpcValue answer;
  while (!client.executeCheckDone(answer)) {
    if (stopping || std::chrono::steady_clock::now() > give_up) return {};
    client._disp.work(0.05);
  }
  // [1 for success, words, value]
  const bool is_success = answer.getType() == XmlRpcValue::TypeArray && answer.size() == 3 &&
                          answer[0].getType() == XmlRpcValue::TypeInt && static_cast<int>(answer[0]) == 1;
  return is_success ? std::optional{answer[2]} : std::nullopt;
}

/// [[topic, type]...] of `getPublications` or `getSubscriptions`.
std::vector<std::pair<std::string, std::string>> topics(const std::atomic<bool>& stopping,
                                                        const char* method) {
  std::vector<std::pair<std::string, std::string>> found;
  std::optional<XmlRpcValue> listed = ask(own_endpoint(), stopping, method);
  if (!listed || listed->getType() != XmlRpcValue::TypeArray) return found;
  for (int i = 0; i < listed->size(); ++i)
    found.emplace_back(static_cast<std::string>((*listed)[i][0]), static_cast<std::string>((*listed)[i][1]));
  return found;
}

/// What this node hears: (topic, publisher).
using Connections = std::set<std::pair<std::string, std::string>>;

std::optional<Connections> connections(const std::atomic<bool>& stopping) {
  std::optional<XmlRpcValue> info = ask(own_endpoint(), stopping, "getBusInfo");
  if (!info || info->getType() != XmlRpcValue::TypeArray) return {};
  Connections found;
  for (int i = 0; i < info->size(); ++i) {
    XmlRpcValue& link = (*info)[i];  // [id, whom, direction, transport, topic...]
    if (static_cast<std::string>(link[2]) == "i")
      found.emplace(static_cast<std::string>(link[4]), static_cast<std::string>(link[1]));
  }
  return found;
}

/// The topics that the master knows publishers of: [[topic, [publisher...]]...] is the first it answers.
std::set<std::string> published(const std::atomic<bool>& stopping) {
  std::set<std::string> found;
  std::optional<XmlRpcValue> state = ask(master_endpoint(), stopping, "getSystemState");
  if (!state || state->getType() != XmlRpcValue::TypeArray || state->size() < 1) return found;
  XmlRpcValue& publishers = (*state)[0];
  for (int i = 0; i < publishers.size(); ++i) found.insert(static_cast<std::string>(publishers[i][0]));
  return found;
}

/// Tells this node of everyone it is connected with and everyone the master now knows of: connections to
/// publishers that do not come back to a new master by themselves live on.
void subscribe_anew(const std::atomic<bool>& stopping, const std::string& topic, const std::string& type) {
  const std::string& own = ros::XMLRPCManager::instance()->getServerURI();
  std::optional<XmlRpcValue> known = ask(master_endpoint(), stopping, "registerSubscriber", topic, type, own);
  if (!known || known->getType() != XmlRpcValue::TypeArray) return;
  std::set<std::string> publishers;
  for (const auto& [heard, publisher] : connections(stopping).value_or(Connections{}))
    if (heard == topic) publishers.insert(publisher);
  for (int i = 0; i < known->size(); ++i) publishers.insert(static_cast<std::string>((*known)[i]));
  publishers.erase(own);
  XmlRpcValue all;
  all.setSize(0);
  int count = 0;
  for (const std::string& publisher : publishers) all[count++] = publisher;
  ask(own_endpoint(), stopping, "publisherUpdate", topic, all);
}

}  // namespace

MasterWatch::MasterWatch(std::vector<std::string> services, std::function<void()> on_return)
    : services_{std::move(services)}, on_return_{std::move(on_return)}, thread_{[this] { watch(); }} {}

MasterWatch::~MasterWatch() {
  stopping_ = true;
  thread_.join();
}

void MasterWatch::rest(double seconds) const {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!stopping_ && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

void MasterWatch::watch() {
  for (int period = 1; !stopping_; rest(watch_period_s), ++period) {
    try {
      look(period % deaf_periods == 0);
    } catch (const XmlRpc::XmlRpcException& error) {
      ROS_WARN_STREAM("what the master answers is passed over: " << error.getMessage());
    } catch (const std::exception& error) {
      ROS_WARN_STREAM("what the master answers is passed over: " << error.what());
    }
  }
}

void MasterWatch::look(bool for_the_deaf) {
  std::optional<XmlRpcValue> answer = ask(master_endpoint(), stopping_, "getPid");
  if (stopping_) return;
  const bool answered = answer && answer->getType() == XmlRpcValue::TypeInt;
  if (!answered) {
    if (reachable_.exchange(false)) ROS_WARN("the master does not answer; what is connected goes on");
    return;
  }
  reachable_ = true;
  const int now = *answer;
  if (process_ && *process_ != now) register_anew();
  process_ = now;
  if (for_the_deaf) connect_the_deaf();
}

/// What is published and not heard at all.
void MasterWatch::connect_the_deaf() {
  const auto heard = connections(stopping_);
  if (!heard) return;
  const std::set<std::string> spoken = published(stopping_);
  for (const auto& [topic, type] : topics(stopping_, "getSubscriptions")) {
    const auto first = heard->lower_bound({topic, ""});
    const bool is_deaf = spoken.count(topic) > 0 && (first == heard->end() || first->first != topic);
    if (!is_deaf) {
      told_deaf_.erase(topic);
      continue;
    }
    if (told_deaf_.insert(topic).second)
      ROS_WARN_STREAM(topic << " is published and was not heard: it is subscribed to anew");
    subscribe_anew(stopping_, topic, type);
  }
}

void MasterWatch::register_anew() {
  const std::string& own = ros::XMLRPCManager::instance()->getServerURI();
  for (const auto& [topic, type] : topics(stopping_, "getPublications"))
    ask(master_endpoint(), stopping_, "registerPublisher", topic, type, own);
  const std::string service_api = "rosrpc://" + ros::network::getHost() + ":" +
                                  std::to_string(ros::ConnectionManager::instance()->getTCPPort());
  for (const std::string& service : services_)
    ask(master_endpoint(), stopping_, "registerService", service, service_api, own);
  if (on_return_) on_return_();
  rest(others_need_s);
  for (const auto& [topic, type] : topics(stopping_, "getSubscriptions"))
    subscribe_anew(stopping_, topic, type);
  ++returns_;
  ROS_WARN("the master is back, and knows this node again");
}

}  // namespace fairway::ros1
