# `cmake --build … --target doc` makes the manual and the reference as HTML in doc/html of the build folder, if there is doxygen. With
# EXTREMAL_MESH_3_BUILD_DOC every build does, and they are installed.
find_program(EXTREMAL_MESH_3_DOC_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_package(Doxygen 1.9.4 QUIET)

# in the order in which they are read; a test looks whether all of doc/*.md are here
set(doc_pages manual shell library inputs queries surfaces simplification registration scale_space guarantees performance
              troubleshooting file_formats tutorial_slicer tutorial_meshlab tutorial_program gallery mathematics
              architecture history bibliography)
list(TRANSFORM doc_pages PREPEND ${PROJECT_SOURCE_DIR}/doc/)
list(TRANSFORM doc_pages APPEND .md)
list(JOIN doc_pages " \\\n                         " doc_pages)
set(doc_output ${PROJECT_BINARY_DIR}/doc)
configure_file(${PROJECT_SOURCE_DIR}/doc/Doxyfile.in ${doc_output}/Doxyfile @ONLY)

if(TARGET Doxygen::doxygen AND EXTREMAL_MESH_3_DOC_PYTHON)
  add_custom_target(doc COMMAND Doxygen::doxygen ${doc_output}/Doxyfile
                    COMMENT "Making the manual and the reference in ${doc_output}/html" VERBATIM)
  if(EXTREMAL_MESH_3_BUILD_DOC)
    set_target_properties(doc PROPERTIES EXCLUDE_FROM_ALL FALSE)
    install(DIRECTORY ${doc_output}/html DESTINATION ${CMAKE_INSTALL_DOCDIR})
  endif()
elseif(EXTREMAL_MESH_3_BUILD_DOC)
  message(FATAL_ERROR "EXTREMAL_MESH_3_BUILD_DOC needs doxygen 1.9.4 or newer, and python3")
endif()
