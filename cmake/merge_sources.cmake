# merge_sources(TARGET)
# Compiles each folder of the target's sources as one text (RAYSTEPS_UNITY), so that headers are read once: what the first
# `./course check` builds took 277 s of processor time, and takes 208 s. A file with an exercise stays alone, since ./course
# links a student's version in its place; so does one that asks for it (SKIP_UNITY_BUILD_INCLUSION).
function(merge_sources target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${RAYSTEPS_UNITY} UNITY_BUILD_MODE GROUP)
  if(RAYSTEPS_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage) # g++ takes each source for a header
  endif()
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    cmake_path(ABSOLUTE_PATH source)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(REPLACE "/" "_" group "${folder}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "${group}")
    file(STRINGS ${source} exercises REGEX "//# exercise" LIMIT_COUNT 1)
    if(exercises)
      set_source_files_properties(${source} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endif()
  endforeach()
endfunction()
