# SPDX-License-Identifier: Apache-2.0
# fairway_avoider, its services (package fairway_ros: headers and Python), and the adapter of COLA2.
find_program(gen_cpp gen_cpp.py PATHS /usr/lib/gencpp REQUIRED)
find_program(gensrv_py gensrv_py.py PATHS /usr/lib/genpy REQUIRED)
find_path(ros_definitions geometry_msgs/msg/Point.msg PATHS /usr/share)
find_path(gencpp_templates srv.h.template PATHS /usr/share/gencpp)
if(NOT ros_definitions OR NOT gencpp_templates)
  message(FATAL_ERROR "fairway_ros: its services need ros-geometry-msgs, ros-std-msgs and gencpp of Debian")
endif()

# the generators of genmsg, called as they are: its CMake macros want a catkin workspace
set(fairway_ros_headers ${CMAKE_BINARY_DIR}/ros1/include)
set(fairway_ros_python ${CMAKE_BINARY_DIR}/ros1/python)
set(services ${CMAKE_CURRENT_SOURCE_DIR}/srv/GoTo.srv ${CMAKE_CURRENT_SOURCE_DIR}/srv/Section.srv)
set(message_paths -Igeometry_msgs:${ros_definitions}/geometry_msgs/msg -Istd_msgs:${ros_definitions}/std_msgs/msg)
set(generated "")
set(modules "")
foreach(service ${services})
  get_filename_component(name ${service} NAME_WE)
  set(headers ${fairway_ros_headers}/fairway_ros/${name}.h ${fairway_ros_headers}/fairway_ros/${name}Request.h
              ${fairway_ros_headers}/fairway_ros/${name}Response.h)
  add_custom_command(OUTPUT ${headers} DEPENDS ${service}
    COMMAND ${Python_EXECUTABLE} ${gen_cpp} ${service} ${message_paths} -p fairway_ros
            -o ${fairway_ros_headers}/fairway_ros -e ${gencpp_templates}
    COMMENT "service ${name}: C++" VERBATIM)
  set(module ${fairway_ros_python}/fairway_ros/srv/_${name}.py)
  add_custom_command(OUTPUT ${module} DEPENDS ${service}
    COMMAND ${Python_EXECUTABLE} ${gensrv_py} ${service} ${message_paths} -p fairway_ros
            -o ${fairway_ros_python}/fairway_ros/srv
    COMMENT "service ${name}: Python" VERBATIM)
  list(APPEND generated ${headers})
  list(APPEND modules ${module})
endforeach()
# it names the modules that it finds in the folder
add_custom_command(OUTPUT ${fairway_ros_python}/fairway_ros/srv/__init__.py DEPENDS ${modules}
  COMMAND ${Python_EXECUTABLE} ${gensrv_py} --initpy -o ${fairway_ros_python}/fairway_ros/srv
  COMMAND ${CMAKE_COMMAND} -E touch ${fairway_ros_python}/fairway_ros/__init__.py
  COMMENT "services: Python package" VERBATIM)
add_custom_target(fairway_ros_services ALL
  DEPENDS ${generated} ${modules} ${fairway_ros_python}/fairway_ros/srv/__init__.py)

add_library(fairway_ros_messages INTERFACE)
add_dependencies(fairway_ros_messages fairway_ros_services)
target_include_directories(fairway_ros_messages SYSTEM INTERFACE ${fairway_ros_headers})

fairway_ros1_program(fairway_avoider avoider_main.cpp avoider_node.cpp LINKS fairway_ros_messages)
fairway_ros1_program(fairway_latency latency.cpp LINKS fairway_ros1)

# where COLA2's messages are not installed, its adapter is built for its test alone
find_package(cola2_msgs QUIET)
if(cola2_msgs_FOUND)
  fairway_ros1_program(fairway_cola2 cola2/cola2_node.cpp LINKS fairway_ros1)
  target_include_directories(fairway_cola2_node SYSTEM PRIVATE ${cola2_msgs_INCLUDE_DIRS})
endif()

install(DIRECTORY ${fairway_ros_headers}/fairway_ros DESTINATION include COMPONENT ros1)
install(DIRECTORY ${fairway_ros_python}/fairway_ros DESTINATION lib/python3/dist-packages COMPONENT ros1)
