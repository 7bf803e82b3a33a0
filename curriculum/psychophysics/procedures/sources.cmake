list(APPEND psychophysics_sources
    procedures/blocked_sum.cpp procedures/constant_stimuli.cpp procedures/descending.cpp procedures/make_procedure.cpp
    procedures/outcome_tables.cpp procedures/pest.cpp procedures/posterior_grid.cpp procedures/psychometric_functions.cpp
    procedures/psychometric_tables.cpp procedures/quest.cpp procedures/quest_plus.cpp procedures/quest_plus_model.cpp
    procedures/rank3_quest_plus.cpp procedures/staircase.cpp procedures/trial_log.cpp)
