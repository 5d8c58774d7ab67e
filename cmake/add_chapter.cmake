# A chapter's manifest is its CMakeLists.txt: add_chapter names the files born in it, and
# add_chapter_picture the pictures that ./run.sh makes of it.

# add_chapter(NAME USES module... BORN path...)
# BORN names the files and folders that came with the chapter. A chapter adds files and never edits those
# of an earlier one; a test sees to it that each file is born once.
function(add_chapter name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;BORN")
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  add_executable(${name} ${sources})
  list(TRANSFORM arg_USES PREPEND raysteps::)
  target_link_libraries(${name} PRIVATE ${arg_USES})
  set_property(GLOBAL APPEND PROPERTY RAYSTEPS_CHAPTERS ${name})
  set_property(GLOBAL PROPERTY RAYSTEPS_BORN_IN_${name} ${arg_BORN})
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
