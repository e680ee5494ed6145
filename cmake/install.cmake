# SPDX-License-Identifier: Apache-2.0
# cmake --install build --prefix P: the libraries that were made with their headers, the command, the licence, and the
# CMake package that finds them. Nothing installed names a folder of this machine.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/fairway)

set(fairway_lists "")
foreach(name IN LISTS fairway_made)
  install(TARGETS fairway_${name} EXPORT fairway_${name}
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
          INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})  # said again for a host's CMake that knows no file sets
  install(EXPORT fairway_${name} FILE ${name}.cmake NAMESPACE fairway:: DESTINATION ${package_folder})
  string(APPEND fairway_lists "set(fairway_uses_${name} ${fairway_uses_${name}})\n"
                              "set(fairway_links_${name} ${fairway_links_${name}})\n")
endforeach()
if(TARGET fairway)
  install(TARGETS fairway RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_file(${CMAKE_CURRENT_LIST_DIR}/fairwayConfig.cmake.in ${PROJECT_BINARY_DIR}/package/fairwayConfig.cmake @ONLY)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/fairwayConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/fairwayConfig.cmake ${PROJECT_BINARY_DIR}/package/fairwayConfigVersion.cmake
              ${CMAKE_CURRENT_LIST_DIR}/components.cmake DESTINATION ${package_folder})
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
