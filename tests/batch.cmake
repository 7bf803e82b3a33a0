# SPDX-License-Identifier: GPL-3.0-or-later
# Writes OUT: one source for several tests, each file in a namespace of its name, so that what they include is read once and
# names of file scope may repeat. TESTS: absolute paths, separated by "|".
string(REPLACE "|" ";" tests "${TESTS}")
set(headers "")
set(bodies "")
foreach(test IN LISTS tests)
    # What a file includes stands outside of its namespace; within, it has been read already.
    file(STRINGS "${test}" includes REGEX "^#include ([<]|\"[^\"]*[.]h\")")
    list(APPEND headers ${includes})
    get_filename_component(name "${test}" NAME_WE)
    string(APPEND bodies "namespace ${name} {\n#define main run\n#include \"${test}\"\n#undef main\n} // namespace ${name}\n"
                         "int run_${name}(int argc, char** argv) { return ${name}::run(argc, argv); }\n")
endforeach()
list(REMOVE_DUPLICATES headers)
list(JOIN headers "\n" headers)
file(WRITE "${OUT}" "${headers}\n${bodies}")
