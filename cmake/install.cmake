# SPDX-License-Identifier: Apache-2.0
# cmake --install build --prefix P: the libraries that were made with their headers, the command, the licence, and the
# CMake package that finds them. Nothing installed names a folder of this machine. cpack makes two Debian packages of
# it: fairway, the command, and libfairway-dev, what one builds with.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/fairway)

set(fairway_lists "")
foreach(name IN LISTS fairway_made)
  install(TARGETS fairway_${name} EXPORT fairway_${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT command NAMELINK_COMPONENT development
          FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})  # said again for a host's CMake that knows no file sets
  install(EXPORT fairway_${name} FILE ${name}.cmake NAMESPACE fairway:: DESTINATION ${package_folder} COMPONENT development)
  string(APPEND fairway_lists "set(fairway_uses_${name} ${fairway_uses_${name}})\n"
                              "set(fairway_links_${name} ${fairway_links_${name}})\n")
endforeach()
if(TARGET fairway)
  install(TARGETS fairway RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenarios ${PROJECT_SOURCE_DIR}/campaigns DESTINATION ${CMAKE_INSTALL_DATADIR}/fairway COMPONENT command)
endif()
if(TARGET fairway_mpi)  # in no package, as it would have every user of fairway install MPI
  install(TARGETS fairway_mpi RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT mpi EXCLUDE_FROM_ALL)
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/fairwayConfig.cmake.in ${PROJECT_BINARY_DIR}/package/fairwayConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/fairwayConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/fairwayConfig.cmake ${PROJECT_BINARY_DIR}/package/fairwayConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/components.cmake DESTINATION ${package_folder} COMPONENT development)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT command)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "The Fairway authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "compares collision avoidance methods of marine robots")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL command development)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMMAND_PACKAGE_NAME fairway)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfairway-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libeigen3-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS  # what the libraries besides avoidance, embed, dynamics and control need
  "libyaml-cpp-dev, libfmt-dev, nlohmann-json3-dev, libcli11-dev, libsqlite3-dev, libzstd-dev, libboost-dev, libompl-dev, libceres-dev, pkg-config")
include(CPack)
