// SPDX-License-Identifier: Apache-2.0
// C++17.
#pragma once

namespace fairway::ros1 {

/// Lets as many callers wait for this node's XML-RPC interface as the system allows. roscpp lets five: where
/// eight avoiders begin at once, each asks a simulator for sixteen topics, and whom the system turns away
/// tries again after 1, 3, 7, ... seconds. After ros::start(), that is after the first NodeHandle. Changes
/// nothing where sockets are not in /proc/self/fd.
void lengthen_listen_queue();

}  // namespace fairway::ros1
