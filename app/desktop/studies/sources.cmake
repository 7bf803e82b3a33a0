# Screens of the researcher: design, run, data, questionnaires. What they show comes from other modules; a screen is built where those are there.
set(study_screen_sources
    studies/conditions_page.cpp studies/consent_dialog.cpp studies/difference_table.cpp studies/enrol_dialog.cpp studies/field_grid.cpp
    studies/freeze_dialog.cpp studies/general_page.cpp studies/key_table_dialog.cpp studies/new_study_dialog.cpp
    studies/participants_page.cpp studies/preview_page.cpp studies/preview_work.cpp studies/procedure_form.cpp
    studies/questionnaires_page.cpp studies/studies_actions.cpp studies/studies_screen.cpp studies/study_draft.cpp
    studies/study_numbers.cpp studies/study_screen.cpp studies/study_screen_actions.cpp studies/study_store.cpp studies/study_words.cpp
    studies/usual_procedure.cpp studies/withdraw_dialog.cpp
    study_run/answer_panel.cpp study_run/run_screen.cpp
    study_data/apex_page.cpp study_data/group_page.cpp study_data/person_page.cpp study_data/questionnaire_summary.cpp study_data/study_data_actions.cpp
    study_data/study_data_screen.cpp study_data/study_facts.cpp study_data/trials_page.cpp
    questionnaire/questionnaire_form.cpp questionnaire/questionnaire_screen.cpp)
set(study_definitions CHIRON_STUDY_SCREENS)
if(NOT EXISTS ${CMAKE_SOURCE_DIR}/curriculum/catalogue/study_reader.cpp)
    set(study_screen_sources)
    set(study_definitions)
endif()
if(EXISTS ${CMAKE_SOURCE_DIR}/app/session_report/study_report.cpp)
    set_source_files_properties(study_data/study_data_actions.cpp PROPERTIES COMPILE_DEFINITIONS CHIRON_STUDY_REPORT)
endif()
if(study_screen_sources AND EXISTS ${CMAKE_SOURCE_DIR}/app/session/study/live_study.cpp)
    list(APPEND study_screen_sources study_run/break_panel.cpp study_run/experimenter_panel.cpp study_run/places_view.cpp
                                     study_run/trials_screen.cpp study_run/trials_screen_build.cpp)
    list(APPEND study_definitions CHIRON_STUDY_TRIALS)
endif()
set_property(GLOBAL PROPERTY CHIRON_STUDY_DEFINITIONS "${study_definitions}")
set_source_files_properties(screen_catalogue.cpp home/home_parts.cpp study_run/run_screen.cpp PROPERTIES COMPILE_DEFINITIONS "${study_definitions}")
