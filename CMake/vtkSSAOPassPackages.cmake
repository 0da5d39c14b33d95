# SPDX-License-Identifier: BSD-3-Clause
#[==[
Debian packages by cpack -G DEB, of a build that was configured for the prefix /usr:

  libvtkssaopass1      the library, and the headless window where it was built
  libvtkssaopass-dev   header and CMake package
  python3-vtkssaopass  Python package, where it was built
#]==]
set(CPACK_PACKAGE_NAME vtkssaopass)
set(CPACK_PACKAGE_VENDOR vtkSSAOPass)
set(CPACK_PACKAGE_CONTACT "vtkSSAOPass authors <noreply@example.org>" CACHE STRING
  "Maintainer of the Debian packages: a name and an address")
set(CPACK_PACKAGE_VERSION "${PROJECT_VERSION}")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGING_INSTALL_PREFIX "${CMAKE_INSTALL_PREFIX}")
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL runtime development)
if (SSAO_WRAPS_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif ()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libs)
# Dependencies on libraries are read from the files; those of the project are in the build.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(CPACK_COMPONENT_RUNTIME_DESCRIPTION "Screen-space ambient occlusion for VTK: library
 A render pass that darkens ambient light in creases and contacts.")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME libvtkssaopass1)

set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Screen-space ambient occlusion for VTK: development files
 Header and CMake package: find_package(vtkSSAOPass).")
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libvtkssaopass-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libvtk9-dev)
if (VTKSSAOPASS_HAS_OWN_WINDOW)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libosmesa6-dev")
endif ()

set(CPACK_COMPONENT_PYTHON_DESCRIPTION "Screen-space ambient occlusion for VTK: Python package
 For python3-vtk9, and for PyVista and vedo, which draw with it: import vtkssaopass.")
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-vtkssaopass)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if (SSAO_WRAPS_PYTHON)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3-vtk9, \
python3 (>= ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}), \
python3 (<< ${Python3_VERSION_MAJOR}.${next_minor})")
endif ()

include(CPack)
