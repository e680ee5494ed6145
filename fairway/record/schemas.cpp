// SPDX-License-Identifier: Apache-2.0
#include "fairway/record/schemas.hpp"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "fairway/avoidance/command.hpp"
#include "fairway/avoidance/drawing.hpp"
#include "fairway/avoidance/situation.hpp"
#include "fairway/core/leg.hpp"
#include "fairway/record/record_cdr.hpp"

namespace fairway {

namespace {

struct Definition {
  std::string_view name;
  std::string_view fields;
};

constexpr Definition time{"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"};
constexpr Definition header{"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"};
constexpr std::string_view xyz = "float64 x\nfloat64 y\nfloat64 z\n";
constexpr Definition point{"geometry_msgs/Point", xyz};
constexpr Definition vector3{"geometry_msgs/Vector3", xyz};
constexpr Definition quaternion{"geometry_msgs/Quaternion",
                                "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"};
constexpr Definition pose{"geometry_msgs/Pose",
                          "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"};
constexpr Definition pose_with_covariance{"geometry_msgs/PoseWithCovariance",
                                          "geometry_msgs/Pose pose\nfloat64[36] covariance\n"};
constexpr Definition twist{"geometry_msgs/Twist",
                           "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"};
constexpr Definition twist_with_covariance{"geometry_msgs/TwistWithCovariance",
                                           "geometry_msgs/Twist twist\nfloat64[36] covariance\n"};
constexpr Definition transform{"geometry_msgs/Transform",
                               "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"};
constexpr Definition transform_stamped{
    "geometry_msgs/TransformStamped",
    "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"};

constexpr Definition point_field{"sensor_msgs/PointField",
                                 "uint8 INT8=1\n"
                                 "uint8 UINT8=2\n"
                                 "uint8 INT16=3\n"
                                 "uint8 UINT16=4\n"
                                 "uint8 INT32=5\n"
                                 "uint8 UINT32=6\n"
                                 "uint8 FLOAT32=7\n"
                                 "uint8 FLOAT64=8\n"
                                 "string name\n"
                                 "uint32 offset\n"
                                 "uint8 datatype\n"
                                 "uint32 count\n"};
constexpr Definition flight{"fairway_msgs/MessageFlight",
                            "# indices of vehicles\n"
                            "uint32 from_index\n"
                            "uint32 to_index\n"
                            "# when its transmission began, when it begins to be heard, when all of it is\n"
                            "float64 sent_s\n"
                            "float64 begins_s\n"
                            "float64 arrives_s\n"
                            "# the receiver transmits meanwhile and will not hear it\n"
                            "bool drowned\n"};
/// The fields of a fairway_msgs/Stroke, behind the constants of its kinds.
constexpr std::string_view stroke_fields =
    "uint8 kind\n"
    "string meaning\n"
    "# positions [m] of PATH, TREE (pairs, an edge each) and SPHERE (its centre); velocities [m/s] of\n"
    "# VELOCITY, REGION (an outline) and HALF_SPACE (a point, then the normal towards what is allowed)\n"
    "geometry_msgs/Point[] points\n"
    "# radius of a SPHERE [m]; of an IMAGE the velocity of the outermost pixels' middles [m/s]\n"
    "float64 size\n"
    "# of the top of an IMAGE\n"
    "float64 yaw_rad\n"
    "# of an IMAGE, pixels: from the fastest ahead, in each row from the fastest to port\n"
    "int32 side_count\n"
    "# of an IMAGE: red, green and blue of each pixel\n"
    "uint8[] rgb\n";

// "uint8 MODE_CRUISE=0" for each enumerator
template <class E>
std::string constants(const std::string& prefix) {
  std::string text;
  int value = 0;
  for (std::string name : EnumNames<E>::names) {
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    text += "uint8 " + prefix + name + "=" + std::to_string(value++) + "\n";
  }
  return text;
}

std::string with(std::string_view fields, std::initializer_list<Definition> used) {
  std::string text{fields};
  for (const auto& [name, definition] : used) {
    text.append(80, '=').append("\nMSG: ");
    text += name;
    text += '\n';
    text += definition;
  }
  return text;
}

}  // namespace

MessageSchema odometry_schema() {
  return {"nav_msgs/msg/Odometry", with("std_msgs/Header header\n"
                                        "string child_frame_id\n"
                                        "geometry_msgs/PoseWithCovariance pose\n"
                                        "geometry_msgs/TwistWithCovariance twist\n",
                                        {header, time, pose_with_covariance, pose, point, quaternion,
                                         twist_with_covariance, twist, vector3})};
}

MessageSchema transforms_schema() {
  return {"tf2_msgs/msg/TFMessage", with("geometry_msgs/TransformStamped[] transforms\n",
                                         {transform_stamped, header, time, transform, vector3, quaternion})};
}

MessageSchema vehicle_status_schema() {
  return {"fairway_msgs/msg/VehicleStatus",
          with("# What was asked of a vehicle at one instant, and what its odometry does not say.\n"
               "# Axes are north, east, down.\n" +
                   constants<Phase>("PHASE_") + constants<Mode>("MODE_") +
                   "std_msgs/Header header\n"
                   "int64 tick\n"
                   "uint32 id\n"
                   "uint8 phase\n" +
                   record_definition<Command>("command_") +
                   "# of the present leg\n"
                   "float64[3] goal_m\n"
                   "float64 goal_speed_mps\n"
                   "# drawn by the actuators\n"
                   "float64 power_w\n"
                   "# of the actuators on the vehicle, as command_wrench\n"
                   "float64[6] wrench\n"
                   "# in the order and units of the vehicle model\n"
                   "float64[] actuators\n",
               {header, time})};
}

MessageSchema frame_schema() {
  return {"fairway_msgs/msg/Frame",
          with("# One instant of a run. It comes before the odometry and status of its vehicles.\n"
               "std_msgs/Header header\n"
               "int64 tick\n"
               "float64 time_s\n"
               "# to the next recorded frame\n"
               "float64 period_s\n"
               "# of tick, states, commands, goals and actuators, to the bit\n"
               "uint64 hash\n",
               {header, time})};
}

MessageSchema tracks_schema() {
  const std::string track = record_definition<Track>();
  return {"fairway_msgs/msg/Tracks",
          with("# The others, as a vehicle perceived them when it last decided: nearest first. Axes are\n"
               "# north, east, down. Written when it changes; until then it stays as it is.\n"
               "std_msgs/Header header\n"
               "fairway_msgs/Track[] tracks\n",
               {header, time, {"fairway_msgs/Track", track}})};
}

MessageSchema echoes_schema() {
  return {"sensor_msgs/msg/PointCloud2", with("std_msgs/Header header\n"
                                              "uint32 height\n"
                                              "uint32 width\n"
                                              "sensor_msgs/PointField[] fields\n"
                                              "bool is_bigendian\n"
                                              "uint32 point_step\n"
                                              "uint32 row_step\n"
                                              "uint8[] data\n"
                                              "bool is_dense\n",
                                              {header, time, point_field})};
}

MessageSchema sketch_schema() {
  const std::string stroke = constants<Stroke::Kind>("KIND_").append(stroke_fields);
  return {
      "fairway_msgs/msg/Sketch",
      with("# What a vehicle drew of its thinking when it last decided, in the order in which it drew. Axes\n"
           "# are north, east, down. Written when it changes; until then it stays as it is.\n"
           "std_msgs/Header header\n"
           "fairway_msgs/Stroke[] strokes\n",
           {header, time, {"fairway_msgs/Stroke", stroke}, point})};
}

MessageSchema flights_schema() {
  return {
      "fairway_msgs/msg/MessageFlights",
      with("# The messages on their way between vehicles. Written when it changes; until then it stays as\n"
           "# it is.\n"
           "std_msgs/Header header\n"
           "fairway_msgs/MessageFlight[] flights\n",
           {header, time, flight})};
}

MessageSchema word_schema() {
  return {
      "fairway_msgs/msg/Word",
      with(
          "# What a vehicle's method said of its own in a turn, whether or not anybody heard it. Flights of\n"
          "# the same from_index and sent_s are on their way with it.\n"
          "std_msgs/Header header\n"
          "# index of the vehicle\n"
          "uint32 from_index\n"
          "# when its transmission began\n"
          "float64 sent_s\n"
          "# what it said, 1 to 25 bytes, which its method can read\n"
          "uint8[] bytes\n",
          {header, time})};
}

MessageSchema perception_schema() {
  return {"fairway_msgs/msg/Perception",
          with("# What the vehicles perceived at one instant. It comes behind the frame's own message.\n"
               "std_msgs/Header header\n"
               "int64 tick\n"
               "# of tick, tracks and echoes, to the bit\n"
               "uint64 hash\n",
               {header, time})};
}

}  // namespace fairway
