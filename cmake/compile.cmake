# soms_compile_as_library(<target>): the flags of all that queries are made of.
function(soms_compile_as_library target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  # Moved vertices and filters are facts about separately rounded operations: no fused multiply-add,
  # here or in inline functions that users compile.
  target_compile_options(${target} PUBLIC -ffp-contract=off)
  # The archive may become part of a shared object, such as a Python module.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  # No program puts its own function in the place of one of ours, so they may be inlined and called
  # directly.
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  # GCC clears structures of more than a few words by `rep stos`, and copies them by `rep movs`, which
  # take dozens of cycles to begin. Most of ours have 50 to 400 bytes.
  set(short "vector_loop:512:noalign,libcall:-1:noalign")
  check_cxx_compiler_flag("-mmemset-strategy=${short} -mmemcpy-strategy=${short}" SOMS_SHORT_STRINGS)
  if(SOMS_SHORT_STRINGS)
    target_compile_options(${target} PRIVATE "-mmemset-strategy=${short}" "-mmemcpy-strategy=${short}")
  endif()
  # Without a build type queries would take many times as long: the library alone is compiled as for Release then. The
  # project around it keeps its own settings.
  if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES AND NOT CMAKE_CXX_FLAGS MATCHES "(^| )-O")
    separate_arguments(release NATIVE_COMMAND "${CMAKE_CXX_FLAGS_RELEASE}")
    target_compile_options(${target} PRIVATE ${release})
    message(STATUS "soms: no CMAKE_BUILD_TYPE is set, so the library is optimized as for Release")
  endif()
  target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:soms_options>)
endfunction()
