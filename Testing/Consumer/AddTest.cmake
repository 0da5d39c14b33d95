# SPDX-License-Identifier: BSD-3-Clause
# Included by Testing/CMakeLists.txt: tests of what users get, rather than of the module.

# The installed package, moved elsewhere, serves a program of its own. An AddressSanitizer build
# would need its flags in that program too, which is not what users do.
function (ssao_add_package_test name)
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}"
      "-DPACKAGE_BUILD=${PROJECT_BINARY_DIR}"
      "-DPACKAGE_SOURCE=${PROJECT_SOURCE_DIR}"
      "-DPACKAGE_VERSION=${PROJECT_VERSION}"
      "-DPACKAGE_HAS_OSMESA=$<TARGET_EXISTS:vtkSSAOPass::OSMesa>"
      "-DWORK=${PROJECT_BINARY_DIR}/Testing/${name}"
      "-DCONFIGURATION=$<CONFIG>"
      "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DMAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}"
      "-DC_COMPILER=${CMAKE_C_COMPILER}"
      "-DCXX_COMPILER=${CMAKE_CXX_COMPILER}"
      "-DCXX_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}"
      "-DCXX_FLAGS=${CMAKE_CXX_FLAGS}"
      "-DVTK_DIR=${VTK_DIR}"
      ${ARGN}
      -P "${PROJECT_SOURCE_DIR}/Testing/Consumer/TestInstalledPackage.cmake")
  set_tests_properties(${name} PROPERTIES TIMEOUT 600 LABELS "SSAO;Package")
endfunction ()
if (NOT SSAO_TEST_SANITIZE)
  ssao_add_package_test(TestInstalledPackage "-DPACKAGE_SHARED=$<BOOL:${BUILD_SHARED_LIBS}>")
  if (BUILD_SHARED_LIBS)
    ssao_add_package_test(TestInstalledStaticPackage -DPACKAGE_SHARED=0 -DPACKAGE_STATIC=ON)
  endif ()
endif ()

# The program in the README is examples/MinimalSSAO.cxx, and short. Links of all pages lead somewhere.
foreach (name TestReadmeProgram TestPages)
  add_test(NAME ${name}
    COMMAND "${CMAKE_COMMAND}" "-DPACKAGE_SOURCE=${PROJECT_SOURCE_DIR}"
      -P "${PROJECT_SOURCE_DIR}/Testing/Consumer/${name}.cmake")
  set_tests_properties(${name} PROPERTIES TIMEOUT 60 LABELS "SSAO;Package")
endforeach ()
