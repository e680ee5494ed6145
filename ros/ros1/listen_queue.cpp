// SPDX-License-Identifier: Apache-2.0
#include "ros/ros1/listen_queue.hpp"

#include <netinet/in.h>
#include <ros/network.h>
#include <ros/xmlrpc_manager.h>
#include <sys/socket.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace fairway::ros1 {
namespace {

bool listens_at(int file, std::uint32_t port) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  int is_listening{};
  socklen_t flag_size = sizeof is_listening;
  return getsockopt(file, SOL_SOCKET, SO_ACCEPTCONN, &is_listening, &flag_size) == 0 && is_listening != 0 &&
         getsockname(file, reinterpret_cast<sockaddr*>(&address), &size) == 0 &&
         ntohs(address.sin_port) == port;
}

}  // namespace

void lengthen_listen_queue() {
  std::string host;
  std::uint32_t port{};
  ros::network::splitURI(ros::XMLRPCManager::instance()->getServerURI(), host, port);
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator{"/proc/self/fd", none}) {
    const int file = std::stoi(entry.path().filename());
    // to listen again is to change the length
    if (listens_at(file, port)) listen(file, SOMAXCONN);
  }
}

}  // namespace fairway::ros1
