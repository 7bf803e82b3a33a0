# The languages of the program as CMake needs them: CHIRON_LANGUAGES has the ids of core/languages.h, which is the only list, in its order
# ("en;de;el", English first). Each language has the files that docs/guides/add-a-language.md names.
block(PROPAGATE CHIRON_LANGUAGES)
    set(header ${CMAKE_CURRENT_LIST_DIR}/../modules/core/languages.h)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
    file(READ ${header} text)
    string(REGEX MATCHALL "Language{\"[a-z]+\"" found "${text}")
    list(TRANSFORM found REPLACE ".*\"([a-z]+)\"" "\\1" OUTPUT_VARIABLE CHIRON_LANGUAGES)
    list(GET CHIRON_LANGUAGES 0 first)
    if(NOT first STREQUAL "en")
        message(FATAL_ERROR "modules/core/languages.h: the first language is \"${first}\": expected lines like Language{\"en\", ...}, English first")
    endif()

    # The words that the program stores or recognises, and nothing of a language that nobody can choose. (What it shows may be missing until
    # `ninja update_translations` has made the file.)
    foreach(language IN LISTS CHIRON_LANGUAGES)
        if(NOT EXISTS ${CMAKE_CURRENT_LIST_DIR}/words/${language}.json)
            message(FATAL_ERROR "modules/core/languages.h lists \"${language}\", and translations/words/${language}.json is missing: "
                                "copy translations/words/en.json and translate its words")
        endif()
    endforeach()
    file(GLOB files RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/chiron_*.ts ${CMAKE_CURRENT_LIST_DIR}/words/*.json)
    foreach(file IN LISTS files)
        string(REGEX REPLACE "^(chiron_|words/)([^.]*)\\..*$" "\\2" language ${file})
        if(NOT language IN_LIST CHIRON_LANGUAGES)
            message(FATAL_ERROR "translations/${file} is of no language of modules/core/languages.h: add a line for \"${language}\" there")
        endif()
    endforeach()
endblock()
