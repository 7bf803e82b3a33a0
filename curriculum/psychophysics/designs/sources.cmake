list(APPEND psychophysics_sources designs/latin_square.cpp designs/williams.cpp)
