# The OpenGL 4.1 core loader, generated off line by glad 2 from the Khronos registry, both from the
# system's packages (python3-glad, khronos-api). Target: raysteps::gl_loader.
find_program(RAYSTEPS_GLAD glad)
if(NOT RAYSTEPS_GLAD)
  message(FATAL_ERROR "The OpenGL loader generator `glad` is missing. Install the packages python3-glad and khronos-api.")
endif()
set(gl_loader_dir ${PROJECT_BINARY_DIR}/gl_loader)
if(NOT EXISTS ${gl_loader_dir}/include/glad/gl.h)
  execute_process(
    COMMAND ${RAYSTEPS_GLAD} --reproducible --quiet --api gl:core=4.1 --extensions ""
            --out-path ${gl_loader_dir}.partial c --header-only
    RESULT_VARIABLE glad_result ERROR_VARIABLE glad_error)
  if(NOT glad_result EQUAL 0)
    message(FATAL_ERROR "glad could not generate the OpenGL loader: ${glad_error}")
  endif()
  # Only what was generated to its end gets the name.
  file(REMOVE_RECURSE ${gl_loader_dir})
  file(RENAME ${gl_loader_dir}.partial ${gl_loader_dir})
endif()
add_library(raysteps_gl_loader INTERFACE)
add_library(raysteps::gl_loader ALIAS raysteps_gl_loader)
target_include_directories(raysteps_gl_loader SYSTEM INTERFACE
  $<BUILD_INTERFACE:${gl_loader_dir}/include> $<INSTALL_INTERFACE:include/raysteps/made>)
