# Screens of the researcher: design, run, data, questionnaires.
set(study_screen_sources
    studies/check_list.cpp studies/check_page.cpp studies/conditions_page.cpp studies/consent_dialog.cpp studies/design_faults.cpp studies/difference_table.cpp studies/enrol_dialog.cpp studies/field_grid.cpp
    studies/freeze_checks.cpp studies/freeze_dialog.cpp studies/general_page.cpp studies/key_table_dialog.cpp studies/level_units.cpp studies/levels_table.cpp studies/new_study_dialog.cpp studies/number_list.cpp
    studies/participant_card.cpp studies/participant_progress.cpp studies/participant_sentences.cpp studies/participants_page.cpp studies/pilot_dialog.cpp studies/plan_words.cpp studies/preview_page.cpp studies/preview_work.cpp studies/procedure_form.cpp studies/quantity_text.cpp
    studies/questionnaires_page.cpp studies/rules_page.cpp studies/studies_actions.cpp studies/studies_screen.cpp studies/study_draft.cpp
    studies/study_device.cpp studies/study_numbers.cpp studies/study_screen.cpp studies/study_screen_actions.cpp studies/study_jobs.cpp studies/study_titles.cpp studies/attribute_names.cpp studies/study_words.cpp studies/text_claims.cpp
    studies/weight_check.cpp studies/withdraw_dialog.cpp
    study_run/answer_panel.cpp study_run/condition_questions.cpp study_run/run_screen.cpp
    study_data/apex_page.cpp study_data/comparison_page.cpp study_data/group_page.cpp study_data/person_page.cpp study_data/quality_box.cpp study_data/questionnaire_summary.cpp study_data/replaced_folder.cpp study_data/study_data_actions.cpp
    study_data/study_data_screen.cpp study_data/study_facts.cpp study_data/trials_page.cpp study_data/unblind_dialog.cpp
    questionnaire/questionnaire_form.cpp questionnaire/questionnaire_screen.cpp
    study_run/apex_stage.cpp study_run/asked_sitting.cpp study_run/break_panel.cpp study_run/comparison_face.cpp study_run/experimenter_gate.cpp study_run/experimenter_panel.cpp study_run/participant_page.cpp study_run/participant_window.cpp study_run/sitting_sentences.cpp study_run/study_controls.cpp study_run/trials_screen_desk.cpp study_run/places_view.cpp
    study_run/trials_screen.cpp study_run/trials_screen_build.cpp study_run/trials_screen_show.cpp
    study_data/ranking_box.cpp study_run/run_screen_left.cpp)
