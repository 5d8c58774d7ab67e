# cmake -D ROOT=... -D FILE=... -P write_commit.cmake: writes which commit is built into FILE, and leaves the file alone
# where it says so already. A tree that is not the root of a repository of its own has no commit.
set(commit "unknown")
set(modified "false")
execute_process(COMMAND git -C ${ROOT} rev-parse --show-toplevel HEAD
  OUTPUT_VARIABLE lines ERROR_QUIET RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE)
if(NOT failed)
  string(REPLACE "\n" ";" lines "${lines}")
  list(GET lines 0 top)
  file(REAL_PATH ${ROOT} root)
  if(top STREQUAL root)
    list(GET lines 1 commit)
    execute_process(COMMAND git -C ${ROOT} status --porcelain -- CMakeLists.txt cmake chapters common shaders
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(changes)
      set(modified "true")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${FILE} CONTENT "// Made by cmake/write_commit.cmake at each build.
inline constexpr const char* built_commit = \"${commit}\";
inline constexpr bool built_from_modified_tree = ${modified};
" @ONLY)
