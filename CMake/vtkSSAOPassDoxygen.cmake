# The reference in HTML, of the comments in the headers:
#   cmake --build build --target vtkSSAOPassDoxygen, into doxygen/html of the build folder.
find_program(SSAO_DOXYGEN doxygen)
mark_as_advanced(SSAO_DOXYGEN)
if (NOT SSAO_DOXYGEN)
  message(STATUS "Reference: off, Doxygen was not found")
  return ()
endif ()
configure_file(vtkSSAOPass/Doxyfile.in "${CMAKE_CURRENT_BINARY_DIR}/Doxyfile" @ONLY)
add_custom_target(vtkSSAOPassDoxygen
  COMMAND "${SSAO_DOXYGEN}" "${CMAKE_CURRENT_BINARY_DIR}/Doxyfile"
  COMMENT "Writing ${CMAKE_CURRENT_BINARY_DIR}/doxygen/html/index.html"
  VERBATIM)
if (BUILD_TESTING) # a method without a comment fails
  add_test(NAME Reference-Doxygen
    COMMAND "${SSAO_DOXYGEN}" "${CMAKE_CURRENT_BINARY_DIR}/Doxyfile")
  set_tests_properties(Reference-Doxygen PROPERTIES LABELS SSAO)
endif ()
