# A chapter's CMakeLists.txt: add_chapter makes its program, and add_chapter_picture the pictures that
# ./run.sh makes of it.

# add_chapter(NAME USES module...)
# The program NAME of the folder's main.cpp. Its other .cpp files are the library raysteps::chapter_NAME,
# which the chapter's tests link too (`#include "NAME/file.h"`).
function(add_chapter name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
  add_executable(${name} main.cpp)
  list(TRANSFORM arg_USES PREPEND raysteps::)
  if(sources)
    add_library(raysteps_chapter_${name} STATIC ${sources})
    merge_sources(raysteps_chapter_${name})
    add_library(raysteps::chapter_${name} ALIAS raysteps_chapter_${name})
    target_include_directories(raysteps_chapter_${name} PUBLIC ${PROJECT_SOURCE_DIR}/chapters)
    target_link_libraries(raysteps_chapter_${name} PUBLIC ${arg_USES})
    target_link_libraries(${name} PRIVATE raysteps_chapter_${name})
  else()
    target_link_libraries(${name} PRIVATE ${arg_USES})
  endif()
  set_property(GLOBAL APPEND PROPERTY RAYSTEPS_CHAPTERS ${name})
  if(NOT TARGET pictures)
    add_custom_target(pictures)
  endif()
  add_custom_target(pictures_${name})
  add_dependencies(pictures pictures_${name})
endfunction()

# add_chapter_picture(NAME FILE file.png [ARGUMENTS argument...])
# The chapter's program makes out/NAME/FILE, unless the picture is newer than the program and all shaders.
function(add_chapter_picture name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "FILE" "ARGUMENTS")
  file(GLOB_RECURSE shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*)
  set(picture ${PROJECT_SOURCE_DIR}/out/${name}/${arg_FILE})
  cmake_path(GET arg_FILE STEM stem)
  add_custom_command(OUTPUT ${picture}
    COMMAND ${name} ${arg_ARGUMENTS} --json out/${name}/${stem}.json
    DEPENDS ${name} ${shaders}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Rendering out/${name}/${arg_FILE}"
    USES_TERMINAL VERBATIM)
  add_custom_target(picture_${name}_${stem} DEPENDS ${picture})
  add_dependencies(pictures_${name} picture_${name}_${stem})
endfunction()
