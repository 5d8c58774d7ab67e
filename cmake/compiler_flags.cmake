# What every file is compiled with.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()

# Contraction of a * b + c into a fused multiply-add changes bits, and opens leaks at the edges of
# triangles. -std=c++20 alone does not switch it off. A test fails where this flag is lost.
add_compile_options(-Wall -Wextra -Wpedantic -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # g++ 12 warns wrongly of "text" + std::string (GCC bug 105651).
  add_compile_options(-Wno-restrict)
endif()

if(RAYSTEPS_SANITIZE)
  add_compile_options(-fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=address,undefined)
  add_library(sanitizer_defaults OBJECT ${CMAKE_CURRENT_SOURCE_DIR}/tests/whole/sanitize/sanitizer_defaults.cpp)
  # In every program, and its dlclose instead of the system's in every library that is loaded.
  link_libraries("$<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:$<TARGET_OBJECTS:sanitizer_defaults>>")
  add_link_options(-rdynamic)
endif()
