# add_test_folder(NAME [LABEL label] [USES module...] [PACKAGES target...])
# Makes one program of the folder's Catch2 tests, and one CTest test of each TEST_CASE in it.
# A chapter's folder has the chapter's number as its label, so `ctest -L 02` tests chapter 02.
function(add_test_folder name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "LABEL" "USES;PACKAGES")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_executable(test_${name} ${sources})
  list(TRANSFORM arg_USES PREPEND raysteps::)
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(test_${name} PRIVATE ${arg_USES} ${arg_PACKAGES} Catch2::Catch2WithMain)
  target_compile_definitions(test_${name} PRIVATE
    RAYSTEPS_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
    RAYSTEPS_TEST_DIR="${CMAKE_CURRENT_SOURCE_DIR}"
    RAYSTEPS_BINARY_DIR="${PROJECT_BINARY_DIR}")
  if(NOT arg_LABEL)
    set(arg_LABEL ${name})
  endif()
  catch_discover_tests(test_${name} TEST_PREFIX "${name}: " PROPERTIES LABELS ${arg_LABEL} TIMEOUT 300)
endfunction()
