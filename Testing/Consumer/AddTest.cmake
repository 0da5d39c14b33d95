# SPDX-License-Identifier: BSD-3-Clause
# Included by Testing/CMakeLists.txt: tests of what users get, rather than of the module.

# The installed package, moved elsewhere, serves a program of its own. An AddressSanitizer build
# would need its flags in that program too, which is not what users do.
if (NOT SSAO_TEST_SANITIZE)
  add_test(NAME TestInstalledPackage
    COMMAND "${CMAKE_COMMAND}"
      "-DPACKAGE_BUILD=${PROJECT_BINARY_DIR}"
      "-DPACKAGE_SOURCE=${PROJECT_SOURCE_DIR}"
      "-DPACKAGE_VERSION=${PROJECT_VERSION}"
      "-DPACKAGE_HAS_OSMESA=$<TARGET_EXISTS:vtkSSAOPass::OSMesa>"
      "-DPACKAGE_SHARED=$<BOOL:${BUILD_SHARED_LIBS}>"
      "-DWORK=${PROJECT_BINARY_DIR}/Testing/InstalledPackage"
      "-DCONFIGURATION=$<CONFIG>"
      "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DMAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}"
      "-DC_COMPILER=${CMAKE_C_COMPILER}"
      "-DCXX_COMPILER=${CMAKE_CXX_COMPILER}"
      "-DCXX_FLAGS=${CMAKE_CXX_FLAGS}"
      "-DVTK_DIR=${VTK_DIR}"
      -P "${PROJECT_SOURCE_DIR}/Testing/Consumer/TestInstalledPackage.cmake")
  set_tests_properties(TestInstalledPackage PROPERTIES TIMEOUT 600 LABELS "SSAO;Package")
endif ()

# The program in the README is examples/MinimalSSAO.cxx, and short.
add_test(NAME TestReadmeProgram
  COMMAND "${CMAKE_COMMAND}" "-DPACKAGE_SOURCE=${PROJECT_SOURCE_DIR}"
    -P "${PROJECT_SOURCE_DIR}/Testing/Consumer/TestReadmeProgram.cmake")
set_tests_properties(TestReadmeProgram PROPERTIES TIMEOUT 60 LABELS "SSAO;Package")
