# SPDX-License-Identifier: BSD-3-Clause
#[==[
Finds Mesa's off-screen library. Used by this build and, once installed, by programs that link
vtkSSAOPass::OSMesa.

  OSMesa_FOUND    the library exists (and its header, if the component Development is asked for)
  OSMesa::OSMesa  imported target

Programs need the library only, so the file with the version in its name is accepted as well: it is
there without the development package.
#]==]
find_library(OSMESA_LIBRARY NAMES OSMesa libOSMesa.so.8 libOSMesa.so.6
  DOC "Mesa's off-screen library")
find_path(OSMESA_INCLUDE_DIR NAMES GL/osmesa.h
  DOC "Directory with GL/osmesa.h")
mark_as_advanced(OSMESA_LIBRARY OSMESA_INCLUDE_DIR)

set(OSMesa_Development_FOUND FALSE)
if (OSMESA_INCLUDE_DIR)
  set(OSMesa_Development_FOUND TRUE)
endif ()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OSMesa
  REQUIRED_VARS OSMESA_LIBRARY
  HANDLE_COMPONENTS)

if (OSMesa_FOUND AND NOT TARGET OSMesa::OSMesa)
  add_library(OSMesa::OSMesa UNKNOWN IMPORTED)
  set_target_properties(OSMesa::OSMesa PROPERTIES
    IMPORTED_LOCATION "${OSMESA_LIBRARY}")
  if (OSMESA_INCLUDE_DIR)
    set_target_properties(OSMesa::OSMesa PROPERTIES
      INTERFACE_INCLUDE_DIRECTORIES "${OSMESA_INCLUDE_DIR}")
  endif ()
endif ()
