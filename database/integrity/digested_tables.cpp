// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/integrity/row_digest.h"

#include <algorithm>
#include <cassert>

// The order of columns is part of the stored format: a digest covers the values in this order. Columns that a
// later version adds stand at the end, are nullable, and are counted in laterColumns.
namespace chiron::database {
namespace {

std::vector<DigestedTable> peopleTables() {
    return {
        {"person",
         {"id"},
         {"id", "kind", "name", "name_key", "display_name", "roles", "enabled", "created_utc"}},
        {"person_code", {"person_id"}, {"person_id", "code"}},
        {"credential",
         {"person_id"},
         {"person_id", "password_hash", "recovery_hash", "must_change", "failures", "wait_boot",
          "wait_until_ns"}},
        {"content", {"id"}, {"id", "sha256", "json"}},
    };
}

DigestedTable namesTable() {
    DigestedTable table{"person_name",
                        {"id"},
                        {"id", "person_id", "until_utc", "changed_by", "names_hash"},
                        "names_json",
                        "names_hash",
                        "EXISTS (SELECT 1 FROM erasure WHERE person_id = person_name.person_id)"};
    table.since = kNamesVersion;
    return table;
}

DigestedTable sittingsTable() {
    DigestedTable table{"study_sitting", {"id"}, {"id", "run_id"}};
    table.since = kSittingsVersion;
    return table;
}

// Its erasure expression reads the tombstones of people and participants, which earlier versions of the
// schema already have.
DigestedTable decisionsTable() {
    DigestedTable table{"session_decision",
                        {"id"},
                        {"id", "session_id", "decision", "person_id", "utc", "reason_hash"},
                        "reason",
                        "reason_hash",
                        "EXISTS (SELECT 1 FROM erasure WHERE person_id IN (session_decision.person_id, "
                        "(SELECT person_id FROM session "
                        "WHERE id = session_decision.session_id))) OR EXISTS (SELECT 1 FROM "
                        "participant_erasure e JOIN study_run r ON "
                        "r.participant_id = e.id JOIN recorded_sitting t ON t.run_id = r.id WHERE "
                        "t.session_id = session_decision.session_id)"};
    table.since = kDecisionsVersion;
    return table;
}

DigestedTable sessionTable() {
    return {"session",
            {"id"},
            {"id",
             "person_id",
             "exercise",
             "level",
             "content_id",
             "seed",
             "operator_name",
             "felt",
             "device_json",
             "mapping_json",
             "supervisor_json",
             "versions_json",
             "build_id",
             "cpu_class",
             "force_limit_n",
             "planned_trials",
             "familiarisation",
             "realtime",
             "demonstration",
             "ring_file",
             "channel_table",
             "started_utc",
             "utc_offset_min",
             "state",
             "ended_utc",
             "ticks",
             "frames",
             "dropped",
             "chunks",
             "recording_bytes",
             "loop_json",
             "seal",
             "archived",
             "recording_erased",
             "void_reason_hash",
             "voided_by",
             "state_before_void"},
            "void_reason",
            "void_reason_hash",
            "EXISTS (SELECT 1 FROM erasure WHERE person_id IN (session.person_id, session.voided_by))",
            0,
            1,
            "EXISTS (SELECT 1 FROM participant_erasure e JOIN study_run r ON r.participant_id = e.id JOIN "
            "study_trial t "
            "ON t.run_id = r.id WHERE t.session_id = session.id)",
            "EXISTS (SELECT 1 FROM participant_erasure e JOIN study_run r ON r.participant_id = e.id JOIN "
            "study_sitting t "
            "ON t.run_id = r.id WHERE t.id = session.id)"};
}

std::vector<DigestedTable> recordTables() {
    return {
        {"trial",
         {"session_id", "ordinal"},
         {"session_id", "ordinal", "seed", "state", "first_tick", "last_tick", "marked", "timed_out",
          "scene_json"}},
        {"chunk",
         {"session_id", "sequence"},
         {"id", "session_id", "sequence", "first_tick", "frames", "payload_hash", "payload_digest",
          "force_hash"},
         "payload",
         "payload_hash",
         "EXISTS (SELECT 1 FROM session WHERE id = chunk.session_id AND recording_erased = 1)"},
        {"second_summary",
         {"session_id", "second", "tool"},
         {"session_id", "second", "tool", "frames", "path_length_m", "maximum_force_n", "mean_force_n",
          "impulse_ns", "time_over_limit_s", "events"}},
        {"event",
         {"session_id", "ordinal"},
         {"session_id", "ordinal", "tick", "time_s", "tool", "kind", "detail_json"}},
        {"score_set", {"id"}, {"id", "session_id", "ordinal", "utc", "passed", "trials", "scores", "seal"}},
        {"score",
         {"score_set_id", "trial", "metric"},
         {"score_set_id", "trial", "ordinal", "metric", "version", "unit", "value", "reason", "passed"}},
        {"session_comment",
         {"id"},
         {"id", "session_id", "author_id", "utc", "text_hash", "tick"},
         "text",
         "text_hash",
         "EXISTS (SELECT 1 FROM erasure WHERE person_id IN (session_comment.author_id, (SELECT person_id "
         "FROM session "
         "WHERE id = session_comment.session_id)))",
         1,
         1,
         "EXISTS (SELECT 1 FROM participant_erasure e JOIN study_run r ON r.participant_id = e.id JOIN "
         "study_trial t "
         "ON t.run_id = r.id WHERE t.session_id = session_comment.session_id)",
         "EXISTS (SELECT 1 FROM participant_erasure e JOIN study_run r ON r.participant_id = e.id JOIN "
         "study_sitting t "
         "ON t.run_id = r.id WHERE t.id = session_comment.session_id)"},
        {"erasure",
         {"person_id"},
         {"person_id", "utc", "reason", "administrator_id", "recordings_withdrawn", "digests_json"}},
    };
}

std::vector<DigestedTable> makeTables() {
    std::vector<DigestedTable> tables = peopleTables();
    tables.push_back(sessionTable());
    for (DigestedTable& table : recordTables()) {
        tables.push_back(std::move(table));
    }
    for (DigestedTable& table : studyTables()) {
        table.since = kStudyVersion;
        tables.push_back(std::move(table));
    }
    tables.push_back(namesTable());
    tables.push_back(sittingsTable());
    tables.push_back(decisionsTable());
    return tables;
}

} // namespace

const std::vector<DigestedTable>& digestedTables() {
    static const std::vector<DigestedTable> tables = makeTables();
    return tables;
}

const DigestedTable& digestedTable(std::string_view name) {
    const auto& tables = digestedTables();
    const auto found =
        std::find_if(tables.begin(), tables.end(), [&](const auto& t) { return t.name == name; });
    assert(found != tables.end());
    return *found;
}

} // namespace chiron::database
