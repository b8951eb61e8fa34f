# OpenMesh as `wasm_build.sh` compiles it.
add_library(OpenMeshCore STATIC IMPORTED)
set_target_properties(OpenMeshCore PROPERTIES
    IMPORTED_LOCATION /prefix/lib/libOpenMeshCore.a
    INTERFACE_INCLUDE_DIRECTORIES /openmesh/src)
