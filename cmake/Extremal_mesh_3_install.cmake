# Installs the library, its headers and the program, with what find_package and pkg-config need to find them.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Extremal_mesh_3)

# Until version 1 every minor version may change the interface.
set_target_properties(Extremal_mesh_3 PROPERTIES VERSION ${PROJECT_VERSION}
                                                 SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
file(RELATIVE_PATH lib_from_bin ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
set_target_properties(extremal_mesh PROPERTIES INSTALL_RPATH $ORIGIN/${lib_from_bin})

install(TARGETS Extremal_mesh_3 EXPORT Extremal_mesh_3Targets)
install(TARGETS extremal_mesh)
install(DIRECTORY include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.h)
install(FILES ${PROJECT_BINARY_DIR}/src/tool/extremal_mesh.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${PROJECT_BINARY_DIR}/src/tool/extremal_mesh.bash RENAME extremal_mesh
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES LICENSE README.md CHANGELOG.md CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR})

get_target_property(type Extremal_mesh_3 TYPE)
if(type STREQUAL STATIC_LIBRARY)
  set(Extremal_mesh_3_is_static TRUE)
  set(pkgconfig_requires "fmt tbb libpng zlib mpfr gmp")
  set(pkgconfig_libs " -lgdcmCommon")
  foreach(library ITKIOGDCM ITKIOMeta ITKIONIFTI ITKIONRRD ITKIOVTK ITKIOImageBase ITKCommon)
    string(APPEND pkgconfig_libs " -l:$<TARGET_LINKER_FILE_NAME:${library}>")
  endforeach()
else()
  set(Extremal_mesh_3_is_static FALSE)
endif()

configure_package_config_file(cmake/Extremal_mesh_3Config.cmake.in cmake/Extremal_mesh_3Config.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(cmake/Extremal_mesh_3ConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(EXPORT Extremal_mesh_3Targets NAMESPACE Extremal_mesh_3:: DESTINATION ${package_dir})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cmake/Extremal_mesh_3Config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/cmake/Extremal_mesh_3ConfigVersion.cmake DESTINATION ${package_dir})

# The prefix follows from where the .pc file lies, so that an installed tree can be moved.
file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/Extremal_mesh_3.pc.in cmake/Extremal_mesh_3.pc.in @ONLY)
file(GENERATE OUTPUT cmake/Extremal_mesh_3.pc INPUT ${CMAKE_CURRENT_BINARY_DIR}/cmake/Extremal_mesh_3.pc.in)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/cmake/Extremal_mesh_3.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
