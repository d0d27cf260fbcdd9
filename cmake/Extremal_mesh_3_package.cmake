# `cpack` in the build folder makes a .deb of what is installed: program, library, headers.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME extremal-mesh-3)
set(CPACK_PACKAGE_VENDOR "The Extremal_mesh_3 authors")
set(CPACK_PACKAGE_CONTACT "The Extremal_mesh_3 authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};${PROJECT_NAME};Unspecified;/") # the Python module is a wheel of its own
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# to build against the library, which is not needed to run the program
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libboost-graph-dev, libtbb-dev, libfmt-dev, libpng-dev, libinsighttoolkit5-dev, libcgal-dev")
include(CPack)
