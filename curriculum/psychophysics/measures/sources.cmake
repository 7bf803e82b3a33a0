# Measures (discrimination, rankings, settings, questionnaires) and what a run, a group and the apex study say.
list(APPEND psychophysics_sources
    measures/adjustment_summary.cpp
    measures/agreement.cpp
    measures/dense_solve.cpp
    measures/discrimination.cpp
    measures/dprime.cpp
    measures/exact_tests.cpp
    measures/instrument_score.cpp
    measures/magnitude_estimation.cpp
    measures/page_trend.cpp
    measures/paired_models.cpp
    measures/plackett_luce.cpp
    measures/questionnaire_measures.cpp
    measures/random_effects.cpp
    measures/ranking_summary.cpp
    measures/run_curve.cpp
    measures/run_fit.cpp
    measures/run_warnings.cpp
    measures/scored_answers.cpp
    measures/set_and_said.cpp
    measures/thurstone_posterior.cpp
    measures/variance_components.cpp
    study/apex_study.cpp
    study/group_estimate.cpp
    study/run_estimate.cpp
    study/warning.cpp)
