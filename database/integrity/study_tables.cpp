// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/row_digest.h"

// As in digested_tables.cpp the order of columns is part of the stored format.
namespace chiron::database {
namespace {

constexpr std::string_view kErasedKey =
    "EXISTS (SELECT 1 FROM participant_erasure WHERE id = participant_key.id)";
constexpr std::string_view kErasedAnswer =
    "EXISTS (SELECT 1 FROM participant_erasure WHERE id = questionnaire_answer.participant_id)";

} // namespace

std::vector<DigestedTable> studyTables() {
    return {
        {"study",
         {"id"},
         {"id", "key", "title", "state", "design_json", "sha256", "author_id", "created_utc", "frozen_utc",
          "unblinded", "archived", "demonstration"}},
        {"study_condition", {"study_id", "ordinal"}, {"study_id", "ordinal", "condition", "sealed_code"}},
        {"study_participant",
         {"id"},
         {"id", "study_id", "code", "order_row", "state", "simulated", "observer", "enrolled_by",
          "enrolled_utc", "erase_recordings"}},
        {"participant_key", {"id"}, {"id", "key_hash"}, "key_json", "key_hash", kErasedKey},
        {"participant_consent", {"id"}, {"id", "sha256", "utc", "recorded_by"}},
        {"study_run",
         {"id"},
         {"id", "participant_id", "condition", "sealed_code", "position", "seed", "procedures", "begun_by",
          "state", "started_utc", "ended_utc", "trials", "seal"}},
        {"study_trial",
         {"run_id", "ordinal"},
         {"run_id",    "ordinal",   "procedure",   "session_id",    "first_tick",
          "last_tick", "candidate", "arrangement", "difference",    "entropy_margin",
          "answer",    "outcome",   "value",       "exploration_s", "answer_s",
          "practice",  "undone",    "spoiled",     "fidelity_json", "utc"}},
        {"questionnaire_answer",
         {"id"},
         {"id", "participant_id", "questionnaire", "item", "answer_hash", "utc", "run_id", "language"},
         "answer_json",
         "answer_hash",
         kErasedAnswer,
         2},
        {"participant_erasure",
         {"id"},
         {"id", "utc", "reason", "administrator_id", "recordings_withdrawn", "digests_json"}},
    };
}

} // namespace chiron::database
