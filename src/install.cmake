# SPDX-License-Identifier: Apache-2.0
# Tells where `cmake --install` puts the CMake package `ideotype` with the library
# that evaluates canopies, and the program with all that belongs to it.
include(CMakePackageConfigHelpers)

install(FILES LICENSE README.md CHANGELOG.md CITATION.cff TYPE DOC)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/ideotype)
foreach(area ${library})
    set_target_properties(ideotype_${area} PROPERTIES EXPORT_NAME ${area})
    install(TARGETS ideotype_${area} EXPORT ideotype ARCHIVE
        INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
    if(EXISTS ${PROJECT_SOURCE_DIR}/include/ideotype/${area})
        install(DIRECTORY include/ideotype/${area}
            DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ideotype)
    endif()
endforeach()
install(EXPORT ideotype NAMESPACE ideotype:: DESTINATION ${package}
    FILE ideotypeTargets.cmake)
configure_package_config_file(src/ideotypeConfig.cmake.in
    ideotypeConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(ideotypeConfigVersion.cmake
    COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/ideotypeConfig.cmake
    ${PROJECT_BINARY_DIR}/ideotypeConfigVersion.cmake DESTINATION ${package})
install(FILES ${PROJECT_BINARY_DIR}/include/ideotype/version.hpp
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ideotype)

# pkg-config finds the library by a path from its own file, so that the
# prefix may move. Archives need all that they link; neither Embree nor GLM has
# such a file everywhere.
set(pkgconfig ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
string(REGEX REPLACE "[^/]+" ".." up_to_prefix ${pkgconfig})
set(cflags "-I\${includedir}"
    "-I$<JOIN:$<TARGET_PROPERTY:glm::glm,INTERFACE_INCLUDE_DIRECTORIES>, -I>")
if(IDEOTYPE_CONTRACTS)
    list(APPEND cflags -DIDEOTYPE_CONTRACTS)
endif()
set(libs ${library})
list(REVERSE libs)
list(TRANSFORM libs PREPEND -lideotype_)
list(PREPEND libs "-L\${libdir}")
list(APPEND libs -L$<TARGET_LINKER_FILE_DIR:embree>
    -lembree${embree_VERSION_MAJOR})
list(JOIN cflags " " cflags)
list(JOIN libs " " libs)
configure_file(src/ideotype.pc.in ideotype.pc.in @ONLY)
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/ideotype.pc
    INPUT ${PROJECT_BINARY_DIR}/ideotype.pc.in)
install(FILES ${PROJECT_BINARY_DIR}/ideotype.pc DESTINATION ${pkgconfig})

if(NOT IDEOTYPE_PROGRAM)
    return()
endif()
set(data ${CMAKE_INSTALL_DATADIR}/ideotype)
install(TARGETS ideotype RUNTIME)
# Editors complete and check campaigns by it.
install(FILES analysis/src/ideotype/schemas/campaign.schema.json
    DESTINATION ${data})
install(DIRECTORY campaigns DESTINATION ${data} PATTERN study EXCLUDE)
if(HELP2MAN)
    install(FILES ${PROJECT_BINARY_DIR}/src/ideotype.1
        DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
install(FILES src/cli/completion.bash RENAME ideotype
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(DIRECTORY slurm DESTINATION ${data} USE_SOURCE_PERMISSIONS)
# The SLURM scripts find the program by this link.
file(RELATIVE_PATH program ${CMAKE_INSTALL_FULL_DATADIR}/ideotype/slurm
    ${CMAKE_INSTALL_FULL_BINDIR}/ideotype)
install(CODE "file(CREATE_LINK \"${program}\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${data}/slurm/ideotype\" SYMBOLIC)")
