# cmake --install: the programs behind the command `raysteps`, what they read, and some modules as libraries
# for find_package(Raysteps) (docs/installing.md). CPack makes a Debian package of it.
include(CMakePackageConfigHelpers)

# Static libraries carry what they are made of: these modules are what the four named ones need.
set(modules basics image scene structure mirror reference gpu)
set(cmake_folder ${CMAKE_INSTALL_LIBDIR}/cmake/Raysteps)
foreach(module IN LISTS modules)
  set_target_properties(raysteps_${module} PROPERTIES EXPORT_NAME ${module})
  install(TARGETS raysteps_${module} EXPORT Raysteps ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/common/${module} DESTINATION include/raysteps COMPONENT library
    FILES_MATCHING PATTERN "*.h" PATTERN "*.inc")
endforeach()
set_target_properties(raysteps_gl_loader PROPERTIES EXPORT_NAME gl_loader)
install(TARGETS raysteps_gl_loader EXPORT Raysteps)
install(DIRECTORY ${PROJECT_BINARY_DIR}/gl_loader/include/ DESTINATION include/raysteps/made COMPONENT library)
install(FILES ${PROJECT_BINARY_DIR}/common/mirror/mirror_walks.inc DESTINATION include/raysteps/made COMPONENT library)
install(FILES ${PROJECT_SOURCE_DIR}/scripts/trees/raysteps_dump.h DESTINATION include COMPONENT library)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/shaders DESTINATION share/raysteps COMPONENT library
  FILES_MATCHING PATTERN "*.glsl" PATTERN "*.frag" PATTERN "*.vert")
install(EXPORT Raysteps NAMESPACE Raysteps:: DESTINATION ${cmake_folder} COMPONENT library)

set(RAYSTEPS_CONFIG_EMBREE "")
if(RAYSTEPS_EMBREE)
  set(RAYSTEPS_CONFIG_EMBREE "find_dependency(embree ${embree_VERSION_MAJOR})")
endif()
set(RAYSTEPS_CONFIG_WINDOW "")
if(RAYSTEPS_WINDOW)
  set(RAYSTEPS_CONFIG_WINDOW "find_dependency(glfw3 3.3)")
endif()
set(RAYSTEPS_CONFIG_CONTEXTS "")
if(EGL_FOUND)
  set(RAYSTEPS_CONFIG_CONTEXTS "pkg_check_modules(EGL REQUIRED QUIET IMPORTED_TARGET egl)\n")
endif()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/RaystepsConfig.cmake.in
  ${PROJECT_BINARY_DIR}/RaystepsConfig.cmake INSTALL_DESTINATION ${cmake_folder}
  NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/RaystepsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/RaystepsConfig.cmake ${PROJECT_BINARY_DIR}/RaystepsConfigVersion.cmake
  DESTINATION ${cmake_folder} COMPONENT library)

# What was not built is not installed.
get_property(chapters GLOBAL PROPERTY RAYSTEPS_CHAPTERS)
foreach(program ${chapters} visualizer raysteps_importer)
  install(TARGETS ${program} RUNTIME DESTINATION lib/raysteps COMPONENT programs OPTIONAL)
endforeach()
install(PROGRAMS ${PROJECT_SOURCE_DIR}/scripts/raysteps DESTINATION bin COMPONENT programs)
foreach(folder trees shrink accuracy_page conformance)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scripts/${folder} DESTINATION share/raysteps/scripts COMPONENT programs
    FILES_MATCHING PATTERN "*.py")
endforeach()
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/conformance/suite DESTINATION share/raysteps/docs/conformance
  COMPONENT programs)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION share/doc/raysteps RENAME copyright COMPONENT programs)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the Raysteps project")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL OFF)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, libegl-mesa0, libgl1-mesa-dri, fonts-dejavu-core")
if(OSMESA_FOUND)
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", libosmesa6")
endif()
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "gnuplot-nox, glmark2-data")
include(CPack)
