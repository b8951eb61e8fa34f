# Fails on an #include against the arrows of the house:
#
#     2   apps      tests
#     1   render
#     0   mesh      shading      raster        strangers to one another
#
# cmake -DROOT=<the house> -P check.cmake
cmake_minimum_required(VERSION 3.25)

cmake_path(ABSOLUTE_PATH ROOT)
set(folders mesh shading raster render apps tests)
set(mesh_may_include    mesh)
set(shading_may_include shading)
set(raster_may_include  raster)
set(render_may_include  mesh shading raster render)
set(apps_may_include    mesh shading raster render apps)
set(tests_may_include   mesh shading raster render apps tests)

# A library, and the files that may include it. OpenMesh stays behind `mesh`, so that whoever draws
# sees plain arrays; tests and benchmarks may compare themselves with what they please.
set(libraries OpenMesh stb png jpeglib gif_lib libdeflate polyclipping CLI nlohmann toml++ gtest benchmark tiny_obj_loader SDL imgui)
set(OpenMesh_seen_by        "^(mesh|tests|apps/bench)/")
set(stb_seen_by             "^(raster/.*\\.cpp$|tests/)")
set(png_seen_by             "^(raster/.*\\.cpp$|tests/)")
set(jpeglib_seen_by         "^(raster/.*\\.cpp$|tests/)")
set(gif_lib_seen_by         "^(raster/.*\\.cpp$|tests/)")
set(libdeflate_seen_by      "^(raster/.*\\.cpp$|tests/)")
set(polyclipping_seen_by    "^render/.*\\.cpp$")
set(CLI_seen_by             "^(apps|tests)/")
set(nlohmann_seen_by        "^(apps|tests)/")
set(toml++_seen_by          "^apps/scene/.*\\.cpp$")
set(gtest_seen_by           "^tests/")
set(benchmark_seen_by       "^apps/bench/")
set(tiny_obj_loader_seen_by "^(tests|apps/bench)/")
set(SDL_seen_by             "^apps/demo/window/")
set(imgui_seen_by           "^apps/demo/window/.*\\.cpp$")

set(include_line "^[ \t]*#[ \t]*include[ \t]*[\"<]([^\">]+)[\">]")

# The names that `file` includes, in `result`.
function(includes_of file result)
    file(STRINGS ${ROOT}/${file} lines REGEX "${include_line}")
    set(names)
    foreach(line IN LISTS lines)
        string(REGEX MATCH "${include_line}" ignored "${line}")
        list(APPEND names ${CMAKE_MATCH_1})
    endforeach()
    set(${result} ${names} PARENT_SCOPE)
endfunction()

function(refuse file name reason)
    message(NOTICE "${file}: includes ${name}: ${reason}")
    set_property(GLOBAL APPEND PROPERTY refused "${file}")
endfunction()

# A header that includes OpenMesh is private to mesh: other headers would pass it on.
function(is_private header result)
    set(private FALSE)
    if(header MATCHES "^mesh/" AND EXISTS ${ROOT}/${header})
        includes_of(${header} names)
        if(names MATCHES "(^|;)OpenMesh/")
            set(private TRUE)
        endif()
    endif()
    set(${result} ${private} PARENT_SCOPE)
endfunction()

function(check_folder file name)
    string(REGEX MATCH "^[^/]+" from ${file})
    string(REGEX MATCH "^[^/]+" to ${name})
    if(to STREQUAL "..")
        refuse(${file} ${name} "includes are written from the root of the house")
    elseif(to IN_LIST folders AND NOT to IN_LIST ${from}_may_include)
        refuse(${file} ${name} "${from} may not know ${to}")
    endif()
endfunction()

function(check_library file name)
    string(REGEX MATCH "^[^/.]+" library ${name})
    if(library IN_LIST libraries AND NOT file MATCHES "${${library}_seen_by}")
        refuse(${file} ${name} "not the place for ${library}")
    endif()
endfunction()

function(check_private file name)
    is_private(${name} name_is_private)
    is_private(${file} file_is_private)
    if(name_is_private AND NOT file_is_private AND NOT file MATCHES "^mesh/.*\\.cpp$")
        refuse(${file} ${name} "it includes OpenMesh and so is private to mesh/*.cpp")
    endif()
endfunction()

set(count 0)
foreach(folder IN LISTS folders)
    file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    foreach(file IN LISTS files)
        math(EXPR count "${count} + 1")
        includes_of(${file} names)
        foreach(name IN LISTS names)
            check_folder(${file} ${name})
            check_library(${file} ${name})
            check_private(${file} ${name})
        endforeach()
    endforeach()
endforeach()

get_property(refused GLOBAL PROPERTY refused)
if(refused)
    message(FATAL_ERROR "Includes against the arrows of the house: see docs/architecture.md.")
endif()
if(count EQUAL 0)
    message(FATAL_ERROR "No sources below ${ROOT}.")
endif()
message(STATUS "${count} files keep to the arrows of the house")
