# mirror_walks(SHADERS FOLDER): writes FOLDER/mirror_walks.inc, which makes a C++ type of every walk and of
# every triangle test in the shader folder, so that a new one is one new file there. Its text comes from what
# the files say: which of them are walks, and which arrays and numbers they read.

# The names of the uniforms of a part and of the parts that it includes.
function(uniforms_of shaders part result)
  file(READ ${part} text)
  string(REGEX MATCHALL "uniform [a-zA-Z0-9]+ [a-z_0-9]+" found "${text}")
  list(TRANSFORM found REPLACE "uniform [a-zA-Z0-9]+ " "")
  string(REGEX MATCHALL "#include \"[^\"]+\"" includes "${text}")
  foreach(include IN LISTS includes)
    string(REGEX REPLACE "#include \"(.*)\"" "\\1" file "${include}")
    uniforms_of(${shaders} ${shaders}/${file} deeper)
    list(APPEND found ${deeper})
  endforeach()
  list(REMOVE_DUPLICATES found)
  set(${result} ${found} PARENT_SCOPE)
endfunction()

# The type NAME of a walk with a triangle test, and how it gets the arrays of its structure. (The struct has
# another name, since a function of a part may have that of the file.)
function(mirror_type shaders name triangle structure result)
  uniforms_of(${shaders} ${shaders}/${structure} uniforms)
  set(binds "")
  foreach(uniform IN LISTS uniforms)
    string(APPEND binds "        bind(${uniform}, packed, \"${uniform}\");\n")
  endforeach()
  set(${result} "template <class Real, class Observer>
struct ${name}_mirror {
#define TRIANGLE_PART \"${triangle}\"
#define STRUCTURE_PART \"${structure}\"
#include \"mirror/parts.inc\"
    void read(const PackedStructure& packed) {
${binds}    }
};
template <class Real, class Observer = NoObserver>
using ${name} = ${name}_mirror<Real, Observer>;

" PARENT_SCOPE)
endfunction()

function(mirror_walks shaders folder_of_output)
  file(GLOB_RECURSE structure_parts CONFIGURE_DEPENDS ${shaders}/structure/*.glsl)
  file(GLOB triangle_parts CONFIGURE_DEPENDS ${shaders}/triangle/*.glsl)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${structure_parts} ${triangle_parts})
  set(walk_types "")
  set(all_walks "")
  set(folders "")
  foreach(part IN LISTS structure_parts)
    file(READ ${part} text)
    if(NOT text MATCHES "\nWalk go_on\\(")
      continue()
    endif()
    cmake_path(GET part STEM name)
    cmake_path(RELATIVE_PATH part BASE_DIRECTORY ${shaders} OUTPUT_VARIABLE path)
    cmake_path(GET path PARENT_PATH folder)
    cmake_path(GET folder FILENAME folder)
    mirror_type(${shaders} ${name} triangle/watertight.glsl ${path} type)
    string(APPEND walk_types "${type}")
    string(APPEND all_walks " WALK(${name})")
    string(APPEND walks_in_${folder} " WALK(${name})")
    list(APPEND folders ${folder})
  endforeach()
  set(triangle_types "")
  set(all_triangle_tests "")
  foreach(part IN LISTS triangle_parts)
    cmake_path(GET part STEM name)
    mirror_type(${shaders} ${name} triangle/${name}.glsl structure/every_triangle.glsl type)
    string(APPEND triangle_types "${type}")
    string(APPEND all_triangle_tests " TRIANGLE_TEST(${name})")
  endforeach()

  set(text "// Made by cmake/mirror_walks.cmake from shaders/structure and shaders/triangle.\n")
  string(APPEND text "#define ALL_WALKS${all_walks}\n")
  list(REMOVE_DUPLICATES folders)
  foreach(folder IN LISTS folders)
    string(APPEND text "#define WALKS_IN_${folder}${walks_in_${folder}}\n")
  endforeach()
  string(APPEND text "#define ALL_TRIANGLE_TESTS${all_triangle_tests}\n
namespace raysteps::mirror::walks {\n\n${walk_types}} // namespace raysteps::mirror::walks\n
namespace raysteps::mirror::triangle_tests {\n\n${triangle_types}} // namespace raysteps::mirror::triangle_tests\n")
  file(CONFIGURE OUTPUT ${folder_of_output}/mirror_walks.inc CONTENT "${text}" @ONLY)
endfunction()
