# Writes the header with commit and compiler. Run at each build (cmake -P); the file is only touched when its content changes, and
# one source includes it, so that a new commit compiles one file.
#   -D OUTPUT=... -D SOURCE=... -D SINEW_VERSION=... -D SINEW_COMPILER=... -D SINEW_BUILD_TYPE=... -D SINEW_HDF5=...
set(SINEW_COMMIT "unknown")
execute_process(COMMAND git -C "${SOURCE}" describe --always --dirty --abbrev=12 --exclude=*
                OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
if(NOT failed AND described)
  set(SINEW_COMMIT "${described}")
endif()
configure_file("${CMAKE_CURRENT_LIST_DIR}/build_info.hpp.in" "${OUTPUT}" @ONLY)
