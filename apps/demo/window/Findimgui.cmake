# Dear ImGui, of which Debian has neither a CMake nor, without its source, an SDL renderer's file.
find_path(imgui_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui)
find_library(imgui_LIBRARY imgui)
find_library(imgui_stb_LIBRARY stb)  # Debian's leaves its letters to that
find_package(Freetype QUIET)
mark_as_advanced(imgui_INCLUDE_DIR imgui_LIBRARY imgui_stb_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(imgui
    REQUIRED_VARS imgui_LIBRARY imgui_INCLUDE_DIR imgui_stb_LIBRARY FREETYPE_FOUND)
if(imgui_FOUND AND NOT TARGET imgui::imgui)
    add_library(imgui::imgui UNKNOWN IMPORTED)
    set_target_properties(imgui::imgui PROPERTIES
        IMPORTED_LOCATION ${imgui_LIBRARY}
        INTERFACE_INCLUDE_DIRECTORIES ${imgui_INCLUDE_DIR}
        INTERFACE_LINK_LIBRARIES "${imgui_stb_LIBRARY};Freetype::Freetype")
endif()
