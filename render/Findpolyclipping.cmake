# Defines the target polyclipping::polyclipping: Clipper 6 by Angus Johnson, which brings no package
# file for CMake. (Debian's libclipper-dev is something else, for crystals.)
find_path(POLYCLIPPING_INCLUDE_DIR polyclipping/clipper.hpp)
find_library(POLYCLIPPING_LIBRARY polyclipping)
mark_as_advanced(POLYCLIPPING_INCLUDE_DIR POLYCLIPPING_LIBRARY)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(polyclipping
    REQUIRED_VARS POLYCLIPPING_LIBRARY POLYCLIPPING_INCLUDE_DIR)

if(polyclipping_FOUND AND NOT TARGET polyclipping::polyclipping)
    add_library(polyclipping::polyclipping UNKNOWN IMPORTED)
    set_target_properties(polyclipping::polyclipping PROPERTIES
        IMPORTED_LOCATION ${POLYCLIPPING_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${POLYCLIPPING_INCLUDE_DIR})
endif()
