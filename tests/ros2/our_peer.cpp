// SPDX-License-Identifier: Apache-2.0
// As fastdds_peer, with what the nodes are made of.
//   our_peer listen SECONDS VEHICLE...         counts the numbered odometry that comes
//   our_peer talk SECONDS RATE_HZ LISTENERS VEHICLE...   sends SECONDS x RATE_HZ times numbered odometry,
//   once each topic has so many listeners
#include <cmath>
#include <iostream>
#include <thread>

#include "ros/ros2/graph.hpp"
#include "ros/ros2/memory.hpp"
#include "tests/ros2/counting.hpp"

namespace fairway::ros2 {
namespace {

using SteadyClock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

GraphOptions options(const std::string& node) {
  GraphOptions made;
  made.node = node;
  made.domain = domain_of_environment();
  made.loopback_only = true;
  return made;
}

void listen(double seconds, const std::vector<std::string>& vehicles) {
  Graph graph{options("listener")};
  std::map<std::string, testing::Count> counts;
  for (const auto& vehicle : vehicles)
    graph.subscribe<Odometry>("/" + vehicle + "/odometry", Keep::many,
                              [&counts, vehicle](const Odometry& odometry) {
                                counts[vehicle].see(std::lround(odometry.pose.covariance[0]));
                              });
  graph.announce();
  for (const auto start = SteadyClock::now(); Seconds(SteadyClock::now() - start).count() < seconds;) {
    graph.handle(0.1);
  }
  std::cout << testing::told(counts) << '\n';
}

void talk(double seconds, double rate, std::size_t listeners, const std::vector<std::string>& vehicles) {
  Graph graph{options("talker")};
  std::vector<Publisher<Odometry>> publishers;
  for (const auto& vehicle : vehicles)
    publishers.push_back(graph.advertise<Odometry>("/" + vehicle + "/odometry", Keep::many));
  graph.announce();
  for (const auto& publisher : publishers)
    for (int i = 0; i < 200 && publisher.listeners() < listeners; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds{50});
  std::this_thread::sleep_for(
      std::chrono::milliseconds{500});  // they know of us a little later than we of them

  const auto start = SteadyClock::now();
  std::int64_t sent = 0, unsent = 0;
  for (const auto all = std::llround(seconds * rate); sent < all; ++sent) {
    for (std::size_t i = 0; i < publishers.size(); ++i) {
      Memory memory;
      Odometry odometry{};
      odometry.header.frame_id = memory.text("world");
      odometry.child_frame_id = memory.text(vehicles[i]);
      odometry.pose.covariance[0] = static_cast<double>(sent);
      unsent += publishers[i].publish(odometry) ? 0 : 1;
    }
    std::this_thread::sleep_until(start + std::chrono::duration_cast<SteadyClock::duration>(
                                              Seconds(static_cast<double>(sent + 1) / rate)));
  }
  for (const auto& publisher : publishers) publisher.wait_until_delivered(std::chrono::seconds{3});
  std::cout << nlohmann::json{{"sent", sent}, {"unsent", unsent}} << '\n';
}

int run(const std::vector<std::string>& words) {
  if (words.size() >= 3 && words[0] == "listen")
    return listen(std::stod(words[1]), {words.begin() + 2, words.end()}), 0;
  if (words.size() >= 5 && words[0] == "talk")
    return talk(std::stod(words[1]), std::stod(words[2]), std::stoul(words[3]),
                {words.begin() + 4, words.end()}),
           0;
  throw std::invalid_argument("see the first lines of its source");
}

}  // namespace
}  // namespace fairway::ros2

int main(int argc, char** argv) {
  try {
    return fairway::ros2::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "our_peer: " << error.what() << '\n';
    return 2;
  }
}
