# Flags that every target shares, as an interface target.
add_library(sinew_flags INTERFACE)
target_include_directories(sinew_flags INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_features(sinew_flags INTERFACE cxx_std_20)
target_compile_options(sinew_flags INTERFACE -march=${SINEW_ARCHITECTURE} -ffp-contract=fast -fno-math-errno -fno-trapping-math
                       -Wall -Wextra -Wpedantic -Wshadow -Wno-psabi
                       "$<$<CXX_COMPILER_ID:GNU>:-Wno-restrict;-Wno-maybe-uninitialized>")  # false alarms of GCC 12 on std::string (bugs 105651, 105562)
if(SINEW_WARNINGS_AS_ERRORS)
  target_compile_options(sinew_flags INTERFACE -Werror)
endif()
