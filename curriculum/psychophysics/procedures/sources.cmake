list(APPEND psychophysics_sources
    procedures/blocked_sum.cpp procedures/constant_kind.cpp procedures/constant_stimuli.cpp procedures/descending.cpp
    procedures/descending_kind.cpp procedures/outcome_tables.cpp procedures/parameter.cpp procedures/pest.cpp procedures/pest_kind.cpp
    procedures/posterior_grid.cpp procedures/procedure_catalogue.cpp procedures/psychometric_functions.cpp
    procedures/psychometric_tables.cpp procedures/quest.cpp procedures/quest_kind.cpp procedures/quest_plus.cpp
    procedures/quest_plus_kind.cpp procedures/quest_plus_model.cpp procedures/rank3_kind.cpp procedures/rank3_quest_plus.cpp
    procedures/staircase.cpp procedures/staircase_kind.cpp procedures/trial_log.cpp procedures/usual_levels.cpp)
