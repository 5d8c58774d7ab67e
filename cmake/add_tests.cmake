# add_tests(PROGRAM FOLDERS folder... USES module... [PACKAGES target...] [LABEL label])
# Makes one program of the Catch2 tests in the folders, and one CTest test of each file x_test.cpp in them: its
# cases run in one process. The label is the folder's name, or LABEL; `ctest -L 06` tests chapter 06.
function(add_tests program)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "FOLDERS;USES;PACKAGES")
  add_executable(${program})
  list(TRANSFORM arg_USES PREPEND raysteps::)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(${program} PRIVATE ${arg_USES} ${arg_PACKAGES} Catch2::Catch2WithMain)
  target_compile_definitions(${program} PRIVATE
    RAYSTEPS_SOURCE_DIR="${PROJECT_SOURCE_DIR}" RAYSTEPS_BINARY_DIR="${PROJECT_BINARY_DIR}")

  foreach(folder IN LISTS arg_FOLDERS)
    get_filename_component(folder ${folder} ABSOLUTE)
    cmake_path(GET folder FILENAME name)
    set(label ${name})
    if(arg_LABEL)
      set(label ${arg_LABEL})
    endif()
    add_to_tests_of(${label} ${program})
    file(GLOB sources CONFIGURE_DEPENDS ${folder}/*.cpp)
    target_sources(${program} PRIVATE ${sources})
    list(FILTER sources INCLUDE REGEX "_test\\.cpp$")
    foreach(source IN LISTS sources)
      add_file_test(${program} ${name} ${source})
      set_tests_properties(${test} PROPERTIES LABELS ${label})
    endforeach()
  endforeach()
  merge_sources(${program})
endfunction()

# add_to_tests_of(LABEL target...)
# `./test.sh LABEL` builds these.
function(add_to_tests_of label)
  if(NOT TARGET tests_${label})
    add_custom_target(tests_${label})
  endif()
  add_dependencies(tests_${label} ${ARGN})
endfunction()

# The CTest test of one file; its name comes back in `test`. Catch2 calls a file's cases by a tag.
function(add_file_test program folder source)
  cmake_path(GET source STEM stem)
  string(REGEX REPLACE "_test$" "" subject ${stem})
  set(test "${folder}: ${subject}")
  if(Catch2_VERSION VERSION_LESS 3)
    set(no_empty_run --warn NoTests) # from version 3 on it is an error by itself
  endif()
  add_test(NAME ${test} COMMAND ${program} --filenames-as-tags "[#${stem}]~[.]" ${no_empty_run})
  set_tests_properties(${test} PROPERTIES TIMEOUT 1800)
  return(PROPAGATE test)
endfunction()

# add_long_test(FACT COMMAND...)
# What takes many minutes: run by `ctest --preset long` alone.
function(add_long_test fact)
  add_test(NAME "long: ${fact}" COMMAND ${ARGN})
  set_tests_properties("long: ${fact}" PROPERTIES LABELS long TIMEOUT 36000)
endfunction()
