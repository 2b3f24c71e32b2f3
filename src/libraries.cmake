# SPDX-License-Identifier: Apache-2.0
# Looks for all libraries, then tells at once which are missing and what they
# are called elsewhere. Most are headers only.

set(systems Debian Fedora Spack conda)
set(how_Debian "Debian, Ubuntu    apt install")
set(how_Fedora "RHEL with EPEL    dnf install")
set(how_Spack "Spack             spack install")
set(how_conda "conda             conda install -c conda-forge")
set(missing "")

# note_missing(NAME DEBIAN FEDORA SPACK CONDA): notes the packages of a library.
macro(note_missing name)
    string(APPEND missing "\n    ${name}")
    set(packages ${ARGN})
    foreach(system package IN ZIP_LISTS systems packages)
        string(APPEND how_${system} " ${package}")
    endforeach()
endmacro()

# need(NAME PACKAGE [FIND ARGUMENTS...] PACKAGES DEBIAN FEDORA SPACK CONDA)
macro(need name package)
    cmake_parse_arguments(need "" "" "FIND;PACKAGES" ${ARGN})
    find_package(${package} QUIET ${need_FIND})
    if(NOT ${package}_FOUND)
        note_missing("${name}" ${need_PACKAGES})
    endif()
endmacro()

# Debian 12 has Embree 3, Debian 13 has Embree 4.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
    need("Embree 3 or 4" embree FIND 3
        PACKAGES libembree-dev embree-devel embree embree)
endif()
need(GLM glm PACKAGES libglm-dev glm-devel glm glm)
need("{fmt}" fmt PACKAGES libfmt-dev fmt-devel fmt fmt)
need(OpenSSL OpenSSL FIND COMPONENTS Crypto
    PACKAGES libssl-dev openssl-devel openssl openssl)
need(Eigen Eigen3 PACKAGES libeigen3-dev eigen3-devel eigen eigen)
# One header of Boost is needed, and no library.
find_path(BOOST_INCLUDE_DIR boost/random/sobol.hpp)
mark_as_advanced(BOOST_INCLUDE_DIR)
if(NOT BOOST_INCLUDE_DIR)
    note_missing("Boost's headers" libboost-dev boost-devel boost+random
        libboost-headers)
endif()
# The library of tinyobjloader has numbers of the type that its packager chose.
find_path(TINYOBJLOADER_INCLUDE_DIR tiny_obj_loader.h)
mark_as_advanced(TINYOBJLOADER_INCLUDE_DIR)
if(NOT TINYOBJLOADER_INCLUDE_DIR)
    note_missing("tinyobjloader 2" libtinyobjloader-dev tinyobjloader-devel
        tinyobjloader tinyobjloader)
endif()
if(IDEOTYPE_PROGRAM OR IDEOTYPE_PYTHON)
    need(toml++ tomlplusplus PACKAGES
        libtomlplusplus-dev tomlplusplus-devel tomlplusplus tomlplusplus)
    need(CLI11 CLI11 PACKAGES libcli11-dev cli11-devel cli11 cli11)
endif()
if(IDEOTYPE_PROGRAM)
    need(MPI MPI FIND COMPONENTS CXX PACKAGES
        "libopenmpi-dev openmpi-bin" openmpi-devel openmpi openmpi)
    # Dimension scales come with HDF5's high-level library.
    need("HDF5 with its high-level library" HDF5 FIND COMPONENTS C HL
        PACKAGES libhdf5-dev hdf5-devel hdf5+hl hdf5)
    # HDF5's headers include mpi.h where it was built with MPI, as in Spack.
    if(HDF5_IS_PARALLEL)
        list(APPEND HDF5_LIBRARIES MPI::MPI_CXX)
    endif()
    need("JSON for Modern C++" nlohmann_json PACKAGES
        nlohmann-json3-dev json-devel nlohmann-json nlohmann_json)
endif()
if(BUILD_TESTING AND IDEOTYPE_PROGRAM)
    find_package(GTest QUIET)
    if(NOT TARGET GTest::gmock)
        message(STATUS "GoogleTest is missing: tests are not built")
        set(BUILD_TESTING OFF)
    endif()
endif()

if(missing)
    foreach(system ${systems})
        string(APPEND ways "\n    ${how_${system}}")
    endforeach()
    message(FATAL_ERROR "Libraries are missing:${missing}\n"
        "Install them with one of${ways}\n"
        "or name the folders that have them in CMAKE_PREFIX_PATH.")
endif()
