// SPDX-License-Identifier: Apache-2.0
#include "ros/ros2/graph.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>
#include <stdexcept>

#include "ros/ros2/memory.hpp"
#include "ros/ros2/twin_readers.hpp"

namespace fairway::ros2 {
namespace {

/// Everything on the loopback interface, found by multicast there and, where that is not let through, by
/// asking the ports of the first participants.
constexpr const char* on_loopback = R"(<CycloneDDS><Domain id="any">
  <General><Interfaces><NetworkInterface name="lo" multicast="true"/></Interfaces></General>
  <Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>60</MaxAutoParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers></Discovery>
</Domain></CycloneDDS>)";

/// The longest that a listener which does not keep up makes a publisher wait. Not the 100 ms that are the
/// default of DDS: Cyclone does not tell what is as by default, and not every peer knows what that is.
constexpr dds_duration_t max_blocking = DDS_MSECS(20);

dds_entity_t valid(dds_entity_t entity, const std::string& what) {
  if (entity < 0) throw std::runtime_error("DDS: " + what + ": " + dds_strretcode(entity));
  return entity;
}

/// How a topic is kept and sent.
struct Qos {
  bool reliable{true};
  bool latched{false};  ///< transient local
  std::int32_t depth{10};
};

constexpr Qos usual{};  // of ROS 2

Qos sent(Keep keep) {
  return keep == Keep::many ? Qos{true, false, 100} : keep == Keep::latched ? Qos{true, true, 1} : usual;
}

Qos heard(Keep keep) {
  return keep == Keep::many ? Qos{true, false, 100} : keep == Keep::newest ? Qos{false, false, 10} : usual;
}

using QosPointer = std::unique_ptr<dds_qos_t, decltype(&dds_delete_qos)>;

QosPointer dds_qos_of(const Qos& qos) {
  QosPointer made{dds_create_qos(), &dds_delete_qos};
  dds_qset_reliability(made.get(), qos.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       max_blocking);
  dds_qset_durability(made.get(), qos.latched ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  dds_qset_history(made.get(), DDS_HISTORY_KEEP_LAST, qos.depth);
  if (qos.latched)
    dds_qset_durability_service(made.get(), 0, DDS_HISTORY_KEEP_LAST, qos.depth, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED);
  dds_qset_writer_data_lifecycle(made.get(), false);
  return made;
}

std::string expanded(const GraphOptions& options, const std::string& name) {
  const std::string space = options.space == "/" ? "" : options.space;
  if (name.starts_with('/')) return name;
  if (name.starts_with("~/")) return space + "/" + options.node + name.substr(1);
  return space + "/" + name;
}

Gid gid_of(dds_entity_t entity) {
  dds_guid_t guid{};
  valid(dds_get_guid(entity, &guid), "the identity of an entity");
  Gid gid{};
  std::memcpy(gid.data, guid.v, sizeof guid.v);
  return gid;
}

}  // namespace

struct Graph::Subscription {
  dds_entity_t reader{};
  std::string topic;
  std::function<void(const void*)> handle;
  std::shared_ptr<TwinReaders> twins;  // of two that are one

  bool has_been_seen(const dds_sample_info_t& info) const {
    return twins != nullptr && twins->has_been_seen(info.publication_handle, info.source_timestamp, reader);
  }
};

std::uint32_t domain_of_environment() {
  const char* const text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return 0;
  char* end = nullptr;
  const unsigned long domain = std::strtoul(text, &end, 10);
  if (*end != '\0' || *text == '-' || domain > 232)
    throw std::runtime_error(std::string{"ROS_DOMAIN_ID: "} + text +
                             ": expected a whole number from 0 to 232");
  return static_cast<std::uint32_t>(domain);
}

bool loopback_of_environment() {
  const char* const text = std::getenv("ROS_LOCALHOST_ONLY");
  return text != nullptr && std::string_view{text} == "1";
}

std::string resolved(const GraphOptions& options, const std::string& topic) {
  std::string full = expanded(options, topic);
  for (const auto& [from, to] : options.remaps)
    if (expanded(options, from) == full) return expanded(options, to);
  return full;
}

Graph::Graph(GraphOptions options) : options_{std::move(options)} {
  if (options_.loopback_only && std::getenv("CYCLONEDDS_URI") == nullptr)
    domain_ = valid(dds_create_domain(options_.domain, on_loopback), "the loopback interface");
  const QosPointer qos{dds_create_qos(), &dds_delete_qos};
  // where ROS 2 looks for a participant's security enclave; one without is no node to it
  constexpr std::string_view enclave = "enclave=/;";
  dds_qset_userdata(qos.get(), enclave.data(), enclave.size());
  participant_ = valid(dds_create_participant(options_.domain, qos.get(), nullptr), "a participant");
  waitset_ = valid(dds_create_waitset(participant_), "a wait set");
  const dds_entity_t discovery = valid(
      dds_create_writer(participant_, topic("ros_discovery_info", descriptor<ParticipantEntitiesInfo>()),
                        dds_qos_of(sent(Keep::latched)).get(), nullptr),
      "ros_discovery_info");
  discovery_ = Publisher<ParticipantEntitiesInfo>{discovery};
}

Graph::~Graph() {
  dds_delete(participant_);
  if (domain_ != 0) dds_delete(domain_);
}

dds_entity_t Graph::topic(const std::string& name, const dds_topic_descriptor_t& type) {
  return valid(dds_create_topic(participant_, &type, name.c_str(), nullptr, nullptr), "topic " + name);
}

dds_entity_t Graph::writer(const std::string& name, const dds_topic_descriptor_t& type, Keep keep) {
  const std::string full = "rt" + resolved(options_, name);
  return writers_.emplace_back(
      valid(dds_create_writer(participant_, topic(full, type), dds_qos_of(sent(keep)).get(), nullptr), full));
}

/// DDS has no subscription that takes what latched publishers sent before and what others send: it is two,
/// and what comes by both is handled once.
void Graph::reader(const std::string& name, const dds_topic_descriptor_t& type, Keep keep,
                   const std::function<void(const void*)>& handle) {
  const auto twins = keep == Keep::latched ? std::make_shared<TwinReaders>() : nullptr;
  const auto add = [&](const Qos& qos) {
    const std::string full = resolved(options_, name);
    const dds_entity_t reader = valid(
        dds_create_reader(participant_, topic("rt" + full, type), dds_qos_of(qos).get(), nullptr), full);
    const dds_entity_t arrived = valid(dds_create_readcondition(reader, DDS_ANY_STATE), full);
    valid(dds_waitset_attach(waitset_, arrived, 0), full);
    subscriptions_.push_back(std::make_unique<Subscription>(Subscription{reader, full, handle, twins}));
  };
  if (keep == Keep::latched) add({.latched = true});
  add(heard(keep));
}

void Graph::announce() {
  Memory memory;
  ParticipantEntitiesInfo info{};
  info.gid = gid_of(participant_);
  NodeEntitiesInfo& node = memory.room(info.node_entities_info_seq, 1)[0];
  const auto copy = [](const std::string& text, std::span<char> to) {
    std::copy_n(text.begin(), std::min(text.size(), to.size() - 1), to.begin());
  };
  copy(options_.space, node.node_namespace);
  copy(options_.node, node.node_name);
  const auto readers = memory.room(node.reader_gid_seq, subscriptions_.size());
  for (std::size_t i = 0; i < readers.size(); ++i) readers[i] = gid_of(subscriptions_[i]->reader);
  const auto writers = memory.room(node.writer_gid_seq, writers_.size());
  for (std::size_t i = 0; i < writers.size(); ++i) writers[i] = gid_of(writers_[i]);
  discovery_.publish(info);
}

void Graph::handle(double longest) {
  if (longest > 0.0) {
    dds_attach_t triggered{};
    dds_waitset_wait(waitset_, &triggered, 1, static_cast<dds_duration_t>(1e9 * longest));
  }
  while (handle_some()) {
  }
}

bool Graph::handle_some() {
  constexpr std::size_t at_once = 16;
  std::array<void*, at_once> messages{};
  std::array<dds_sample_info_t, at_once> infos{};
  bool any = false;
  for (const auto& subscription : subscriptions_) {
    messages[0] = nullptr;  // borrowed from the middleware
    const dds_return_t count =
        dds_take(subscription->reader, messages.data(), infos.data(), at_once, at_once);
    for (dds_return_t i = 0; i < count; ++i) {
      const dds_sample_info_t& info = infos[static_cast<std::size_t>(i)];
      if (info.valid_data && !subscription->has_been_seen(info))
        subscription->handle(messages[static_cast<std::size_t>(i)]);
    }
    if (count <= 0) continue;
    dds_return_loan(subscription->reader, messages.data(), count);
    any = true;
  }
  return any;
}

std::size_t Graph::sources(const std::string& topic) const {
  const std::string full = resolved(options_, topic);
  for (const auto& subscription : subscriptions_) {
    dds_subscription_matched_status_t status{};
    if (subscription->topic == full &&
        dds_get_subscription_matched_status(subscription->reader, &status) == DDS_RETCODE_OK)
      return status.current_count;
  }
  return 0;
}

}  // namespace fairway::ros2
