// SPDX-License-Identifier: Apache-2.0
// Three messages of ROS 2 for Fast DDS, written by hand from the official definitions and serialised by its
// own Fast CDR. Nothing of this is shared with what is tested.
#pragma once

#include <fastcdr/Cdr.h>
#include <fastcdr/FastBuffer.h>

#include <array>
#include <cstdint>
#include <fastdds/dds/topic/TopicDataType.hpp>
#include <string>

namespace fastdds_peer {

using eprosima::fastcdr::Cdr;

struct Header {
  std::int32_t sec{};
  std::uint32_t nanosec{};
  std::string frame_id;

  template <class Use>
  void members(Use& use) {
    use(sec), use(nanosec), use(frame_id);
  }
};

struct Odometry {
  static constexpr const char* name = "nav_msgs::msg::dds_::Odometry_";
  Header header;
  std::string child_frame_id;
  std::array<double, 3> position{};
  std::array<double, 4> orientation{0, 0, 0, 1};  // x, y, z, w
  std::array<double, 36> pose_covariance{};
  std::array<double, 3> linear{}, angular{};
  std::array<double, 36> twist_covariance{};

  template <class Use>
  void members(Use& use) {
    header.members(use);
    use(child_frame_id), use(position), use(orientation), use(pose_covariance), use(linear), use(angular),
        use(twist_covariance);
  }
};

struct TwistStamped {
  static constexpr const char* name = "geometry_msgs::msg::dds_::TwistStamped_";
  Header header;
  std::array<double, 3> linear{}, angular{};

  template <class Use>
  void members(Use& use) {
    header.members(use);
    use(linear), use(angular);
  }
};

struct PoseStamped {
  static constexpr const char* name = "geometry_msgs::msg::dds_::PoseStamped_";
  Header header;
  std::array<double, 3> position{};
  std::array<double, 4> orientation{0, 0, 0, 1};

  template <class Use>
  void members(Use& use) {
    header.members(use);
    use(position), use(orientation);
  }
};

/// How Fast DDS carries a message.
template <class Message>
class Type : public eprosima::fastdds::dds::TopicDataType {
 public:
  Type() {
    setName(Message::name);
    m_typeSize = 4096;
    m_isGetKeyDefined = false;
  }

  bool serialize(void* data, eprosima::fastrtps::rtps::SerializedPayload_t* payload) override {
    eprosima::fastcdr::FastBuffer buffer{reinterpret_cast<char*>(payload->data), payload->max_size};
    Cdr cdr{buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR};
    payload->encapsulation = cdr.endianness() == Cdr::BIG_ENDIANNESS ? CDR_BE : CDR_LE;
    cdr.serialize_encapsulation();
    auto use = [&](auto& member) { cdr << member; };
    static_cast<Message*>(data)->members(use);
    payload->length = static_cast<std::uint32_t>(cdr.getSerializedDataLength());
    return true;
  }

  bool deserialize(eprosima::fastrtps::rtps::SerializedPayload_t* payload, void* data) override {
    eprosima::fastcdr::FastBuffer buffer{reinterpret_cast<char*>(payload->data), payload->length};
    Cdr cdr{buffer, Cdr::DEFAULT_ENDIAN, Cdr::DDS_CDR};
    cdr.read_encapsulation();
    auto use = [&](auto& member) { cdr >> member; };
    static_cast<Message*>(data)->members(use);
    return true;
  }

  std::function<std::uint32_t()> getSerializedSizeProvider(void*) override {
    return [this] { return m_typeSize; };
  }
  void* createData() override { return new Message; }
  void deleteData(void* data) override { delete static_cast<Message*>(data); }
  bool getKey(void*, eprosima::fastrtps::rtps::InstanceHandle_t*, bool) override { return false; }
};

}  // namespace fastdds_peer
