// SPDX-License-Identifier: Apache-2.0
// A peer in a ROS 2 graph that is not ours: Fast DDS, on the loopback interface, in the domain of
// ROS_DOMAIN_ID.
//   fastdds_peer listen SECONDS VEHICLE...          counts the numbered odometry that comes
//   fastdds_peer talk SECONDS RATE_HZ VEHICLE...    sends numbered odometry
//   fastdds_peer steer SECONDS VEHICLE              orders 0.5 m/s ahead, and says how far the vehicle moved
//   fastdds_peer be SECONDS VEHICLE X Y Z           is a vehicle that goes where `velocity_command` says,
//   with a goal
// Each prints a line of JSON at its end.
#include <fastdds/rtps/transport/UDPv4TransportDescriptor.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/ros2/counting.hpp"
#include "tests/ros2/fastdds_messages.hpp"

namespace fastdds_peer {
namespace {

namespace dds = eprosima::fastdds::dds;
using fairway::testing::Count;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

template <class Thing>
Thing* valid(Thing* thing, const char* what) {
  if (thing == nullptr) throw std::runtime_error(std::string{"Fast DDS: no "} + what);
  return thing;
}

/// A participant with ROS 2's quality of service, but for more of the last messages.
class Peer {
 public:
  Peer() {
    dds::DomainParticipantQos qos;
    auto transport = std::make_shared<eprosima::fastdds::rtps::UDPv4TransportDescriptor>();
    transport->interfaceWhiteList = {"127.0.0.1"};
    qos.transport().use_builtin_transports = false;
    qos.transport().user_transports.push_back(transport);
    const char* const domain = std::getenv("ROS_DOMAIN_ID");
    participant_ = valid(dds::DomainParticipantFactory::get_instance()->create_participant(
                             domain == nullptr ? 0 : static_cast<std::uint32_t>(std::stoul(domain)), qos),
                         "participant");
    publisher_ = valid(participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT), "publisher");
    subscriber_ = valid(participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT), "subscriber");
  }
  ~Peer() {
    participant_->delete_contained_entities();
    dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
  }
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  template <class Message>
  dds::DataWriter* writer(const std::string& topic, bool latched = false) {
    dds::DataWriterQos qos;
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    qos.durability().kind = latched ? dds::TRANSIENT_LOCAL_DURABILITY_QOS : dds::VOLATILE_DURABILITY_QOS;
    qos.history().depth = 100;
    return valid(publisher_->create_datawriter(topic_of<Message>(topic), qos), "writer");
  }

  template <class Message>
  dds::DataReader* reader(const std::string& topic) {
    dds::DataReaderQos qos;
    qos.reliability().kind = dds::RELIABLE_RELIABILITY_QOS;
    qos.history().depth = 500;  // the machine that tests is shared: this peer may be late
    return valid(subscriber_->create_datareader(topic_of<Message>(topic), qos), "reader");
  }

 private:
  template <class Message>
  dds::Topic* topic_of(const std::string& topic) {
    dds::TypeSupport{new Type<Message>}.register_type(participant_);
    return valid(participant_->create_topic("rt/" + topic, Message::name, dds::TOPIC_QOS_DEFAULT), "topic");
  }

  dds::DomainParticipant* participant_;
  dds::Publisher* publisher_;
  dds::Subscriber* subscriber_;
};

template <class Message, class Use>
void take(dds::DataReader* reader, Use&& use) {
  Message message;
  dds::SampleInfo info;
  while (reader->take_next_sample(&message, &info) == ReturnCode_t::RETCODE_OK)
    if (info.valid_data) use(message);
}

void listen(double seconds, const std::vector<std::string>& vehicles) {
  Peer peer;
  std::map<std::string, Count> counts;
  std::map<std::string, dds::DataReader*> readers;
  for (const auto& vehicle : vehicles) readers[vehicle] = peer.reader<Odometry>(vehicle + "/odometry");
  for (const auto start = Clock::now(); seconds_since(start) < seconds;) {
    for (auto& [vehicle, reader] : readers)
      take<Odometry>(reader, [&](const Odometry& odometry) {
        counts[vehicle].see(std::lround(odometry.pose_covariance[0]));
      });
    std::this_thread::sleep_for(std::chrono::milliseconds{2});
  }
  std::cout << fairway::testing::told(counts) << '\n';
}

void talk(double seconds, double rate, const std::vector<std::string>& vehicles) {
  Peer peer;
  std::map<std::string, dds::DataWriter*> writers;
  for (const auto& vehicle : vehicles) writers[vehicle] = peer.writer<Odometry>(vehicle + "/odometry");
  const auto start = Clock::now();
  std::int64_t sent = 0;
  for (; seconds_since(start) < seconds; ++sent) {
    for (auto& [vehicle, writer] : writers) {
      Odometry odometry;
      odometry.header.sec = static_cast<std::int32_t>(sent);
      odometry.header.frame_id = "world";
      odometry.child_frame_id = vehicle;
      odometry.pose_covariance[0] = static_cast<double>(sent);
      writer->write(&odometry);
    }
    std::this_thread::sleep_until(start +
                                  std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(static_cast<double>(sent + 1) / rate)));
  }
  std::cout << "{\"sent\":" << sent << "}\n";
}

void steer(double seconds, const std::string& vehicle) {
  Peer peer;
  dds::DataReader* const odometry = peer.reader<Odometry>(vehicle + "/odometry");
  dds::DataWriter* const command = peer.writer<TwistStamped>(vehicle + "/velocity_command");
  std::array<double, 3> first{}, last{};
  std::int64_t heard = 0;
  Header navigation;
  for (const auto start = Clock::now(); seconds_since(start) < seconds;) {
    take<Odometry>(odometry, [&](const Odometry& message) {
      if (heard++ == 0) first = message.position;
      last = message.position;
      navigation = message.header;
    });
    TwistStamped twist;
    twist.header = navigation;
    twist.header.frame_id = vehicle;
    twist.linear[0] = 0.5;
    if (heard > 0) command->write(&twist);
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
  }
  std::cout << nlohmann::json{{"heard", heard},
                              {"moved_m",
                               std::hypot(last[0] - first[0], last[1] - first[1], last[2] - first[2])}}
            << '\n';
}

/// A point that turns at once, in ENU with the body's axes forward, left and up.
void be(double seconds, const std::string& vehicle, const std::array<double, 3>& goal_position) {
  Peer peer;
  dds::DataWriter* const odometry = peer.writer<Odometry>(vehicle + "/odometry");
  dds::DataWriter* const goals = peer.writer<PoseStamped>(vehicle + "/goal", true);
  dds::DataReader* const commands = peer.reader<TwistStamped>(vehicle + "/velocity_command");
  constexpr double h = 0.05;
  Odometry at;
  at.header.frame_id = "world";
  at.child_frame_id = vehicle;
  double yaw = 0;
  std::int64_t heard = 0;
  TwistStamped command;
  const auto start = Clock::now();
  for (std::int64_t step = 0; seconds_since(start) < seconds; ++step) {
    const double now =
        std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
    at.header.sec = static_cast<std::int32_t>(now);
    at.header.nanosec = static_cast<std::uint32_t>((now - std::floor(now)) * 1e9);
    odometry->write(&at);
    if (step == 20) {
      PoseStamped goal;
      goal.header = at.header;
      goal.position = goal_position;
      goals->write(&goal);
    }
    std::this_thread::sleep_until(start +
                                  std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(static_cast<double>(step + 1) * h)));
    take<TwistStamped>(commands, [&](const TwistStamped& message) { command = message, ++heard; });
    at.linear = command.linear;
    at.angular = {0, 0, command.angular[2]};
    yaw += command.angular[2] * h;
    at.orientation = {0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
    at.position[0] += (std::cos(yaw) * command.linear[0] - std::sin(yaw) * command.linear[1]) * h;
    at.position[1] += (std::sin(yaw) * command.linear[0] + std::cos(yaw) * command.linear[1]) * h;
    at.position[2] += command.linear[2] * h;
  }
  const auto& p = at.position;
  std::cout << nlohmann::json{{"heard", heard},
                              {"moved_m", std::hypot(p[0], p[1], p[2])},
                              {"from_goal_m", std::hypot(p[0] - goal_position[0], p[1] - goal_position[1],
                                                         p[2] - goal_position[2])}}
            << '\n';
}

int run(const std::vector<std::string>& words) {
  if (words.size() < 3) throw std::invalid_argument("words");
  const double seconds = std::stod(words[1]);
  if (words[0] == "listen") return listen(seconds, {words.begin() + 2, words.end()}), 0;
  if (words[0] == "talk") return talk(seconds, std::stod(words[2]), {words.begin() + 3, words.end()}), 0;
  if (words[0] == "steer") return steer(seconds, words[2]), 0;
  if (words[0] == "be")
    return be(seconds, words[2], {std::stod(words.at(3)), std::stod(words.at(4)), std::stod(words.at(5))}), 0;
  throw std::invalid_argument("words");
}

}  // namespace
}  // namespace fastdds_peer

int main(int argc, char** argv) {
  try {
    return fastdds_peer::run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::cerr << "fastdds_peer: " << error.what() << '\n';
    return 2;
  }
}
