list(APPEND psychophysics_sources planning/fisher_information.cpp planning/run_simulator.cpp planning/study_plan.cpp)
