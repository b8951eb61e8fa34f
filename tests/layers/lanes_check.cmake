# Fails where an object file compiled for some instruction set lends a function to the rest of the
# program: an inline function or template instance (weak symbol) outside the set's own namespace.
# The linker keeps one copy of it for all, and if that is one of AVX-512, a lesser machine crashes.
#
# cmake -DNM=<nm> -DOBJECTS=<object file>,… -P lanes_check.cmake
cmake_minimum_required(VERSION 3.25)

string(REPLACE "," ";" OBJECTS "${OBJECTS}")
set(lent)
foreach(object IN LISTS OBJECTS)
    execute_process(COMMAND ${NM} -C ${object} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
    string(REPLACE ";" " " symbols "${symbols}")
    string(REGEX MATCHALL "[0-9a-f]+ [WVu] [^\n]*" weak "${symbols}")
    # A reference to how exceptions are caught is data; what clang calls where one may not get out
    # is two calls.
    list(FILTER weak EXCLUDE REGEX "::N_[A-Z0-9_]+::|DW\\.ref\\.|__clang_call_terminate")
    list(APPEND lent ${weak})
endforeach()
if(lent)
    list(JOIN lent "\n  " lines)
    message(FATAL_ERROR "lanes define for everybody:\n  ${lines}\n"
        "Define it in a .cpp file of its room, where no instruction set is asked for.")
endif()
list(LENGTH OBJECTS count)
message("${count} objects lend nothing.")
