# SPDX-License-Identifier: GPL-3.0-or-later
# Looks through object files for symbols that tick code must not need. Call with
#   cmake -DNM=nm -DOBJECTS="a.o;b.o" [-DSKIP=regex] [-DEXPECT_OFFENCE=symbol] -P check_tick_symbols.cmake
# SKIP leaves out set-up code by file name. With EXPECT_OFFENCE the check holds only if it finds that symbol: the test of
# the test.
set(forbidden
    "operator new" "operator delete" "malloc" "calloc" "realloc" "free" "aligned_alloc" "posix_memalign"
    "pthread_mutex" "pthread_cond" "pthread_rwlock" "pthread_once" "__cxa_throw" "__cxa_rethrow"
    "__cxa_allocate_exception" "__cxa_guard_acquire" "std::__throw_" "std::function" "std::ostream" "std::basic_ostream"
    "std::basic_string" "std::__cxx11::" "std::mutex" "std::condition_variable" "std::this_thread" "dlopen" "fopen" "fwrite"
    "printf" "fprintf" "puts" "write" "read" "usleep" "nanosleep" "syslog")
set(found "")
set(checked 0)
foreach(object IN LISTS OBJECTS)
    if(object MATCHES "\\.gch$" OR (SKIP AND object MATCHES "${SKIP}")) # precompiled headers hold no code
        continue()
    endif()
    math(EXPR checked "${checked} + 1")
    execute_process(COMMAND ${NM} -uC ${object} OUTPUT_VARIABLE symbols RESULT_VARIABLE status)
    if(NOT status EQUAL 0)
        message(FATAL_ERROR "nm failed on ${object}")
    endif()
    string(REPLACE ";" "," symbols "${symbols}")
    string(REPLACE "\n" ";" symbols "${symbols}")
    foreach(line IN LISTS symbols)
        string(REGEX REPLACE "^ *[UwV] +" "" symbol "${line}")
        foreach(name IN LISTS forbidden)
            string(FIND "${symbol}" "${name}" at)
            # A plain C name must be the whole symbol; a C++ name or a prefix begins it.
            if(symbol STREQUAL name OR symbol MATCHES "^${name}@" OR (at EQUAL 0 AND name MATCHES "[: _]"))
                list(APPEND found "${object}: ${symbol}")
            endif()
        endforeach()
    endforeach()
endforeach()
if(checked EQUAL 0)
    message(FATAL_ERROR "no object was checked")
endif()
if(EXPECT_OFFENCE)
    if(NOT found MATCHES "${EXPECT_OFFENCE}")
        message(FATAL_ERROR "the check is blind: ${EXPECT_OFFENCE} was not found; found: ${found}")
    endif()
elseif(found)
    list(REMOVE_DUPLICATES found)
    string(REPLACE ";" "\n  " found "${found}")
    message(FATAL_ERROR "tick code needs forbidden symbols:\n  ${found}")
endif()
message(STATUS "${checked} objects checked")
