# add_module(NAME [USES module...] [UNLINKED module...] [PACKAGES target...] [PRIVATE_PACKAGES target...] [HEADERS target...]
#            [WITHOUT folder...])
# Makes the library of the folder common/NAME from the .cpp files in it and in its folders, except those of
# WITHOUT, which are added where their package is there. USES names the modules that its includes may name
# (docs/architecture.md, "Modules"); it can link nothing else. Of those that UNLINKED names it needs types
# alone: a program that calls none of their functions does not have to build them.
# HEADERS are packages without a library: those who link an installed module need nothing of them.
# Files of RAYSTEPS_WORKBOOK take the place of their namesakes, and come first for the compiler.
function(add_module name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;UNLINKED;PACKAGES;PRIVATE_PACKAGES;HEADERS;WITHOUT")
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  foreach(folder IN LISTS arg_WITHOUT)
    list(FILTER sources EXCLUDE REGEX "^${CMAKE_CURRENT_SOURCE_DIR}/${folder}/")
  endforeach()
  if(RAYSTEPS_WORKBOOK)
    file(GLOB_RECURSE own RELATIVE ${RAYSTEPS_WORKBOOK}/common/${name} CONFIGURE_DEPENDS
      ${RAYSTEPS_WORKBOOK}/common/${name}/*.cpp)
    foreach(file IN LISTS own)
      list(REMOVE_ITEM sources ${CMAKE_CURRENT_SOURCE_DIR}/${file})
      list(APPEND sources ${RAYSTEPS_WORKBOOK}/common/${name}/${file})
    endforeach()
  endif()
  list(REMOVE_ITEM arg_USES ${arg_UNLINKED})
  list(TRANSFORM arg_USES PREPEND raysteps::)
  if(sources)
    add_library(raysteps_${name} STATIC ${sources})
    merge_sources(raysteps_${name})
    set(scope PUBLIC)
    target_link_libraries(raysteps_${name} PRIVATE ${arg_PRIVATE_PACKAGES})
    foreach(package IN LISTS arg_HEADERS)
      target_link_libraries(raysteps_${name} PRIVATE $<BUILD_INTERFACE:${package}>)
    endforeach()
  else()
    add_library(raysteps_${name} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(raysteps::${name} ALIAS raysteps_${name})
  if(RAYSTEPS_WORKBOOK)
    target_include_directories(raysteps_${name} BEFORE ${scope}
      ${RAYSTEPS_WORKBOOK}/common ${RAYSTEPS_WORKBOOK}/shaders)
  endif()
  target_include_directories(raysteps_${name} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/common> $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shaders>
    $<INSTALL_INTERFACE:include/raysteps> $<INSTALL_INTERFACE:share/raysteps/shaders>)
  target_link_libraries(raysteps_${name} ${scope} ${arg_USES} ${arg_PACKAGES})
endfunction()
