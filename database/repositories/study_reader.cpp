// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_reader.h"

#include "database/access/authorise.h"
#include "database/access/writer_only.h"
#include "database/audit/audit_trail.h"
#include "database/query.h"
#include "database/repositories/study_blinding.h"
#include "database/repositories/study_mask.h"
#include "database/repositories/study_rows.h"
#include "database/repositories/study_rules.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace chiron::database {
namespace {

constexpr const char* kSummaryColumns =
    "s.id, s.key, s.title, s.state, coalesce(lower(hex(s.sha256)), ''), s.author_id, s.created_utc, "
    "s.frozen_utc, "
    "s.unblinded, s.archived, s.demonstration, "
    "(SELECT count(*) FROM study_participant p WHERE p.study_id = s.id AND p.state <> 'withdrawn'), "
    "(SELECT count(*) FROM study_participant p WHERE p.study_id = s.id AND p.state = 'completed'), "
    "(SELECT count(*) FROM study_participant p JOIN study_run r ON r.participant_id = p.id JOIN study_trial "
    "t ON "
    "t.run_id = r.id WHERE p.study_id = s.id AND t.spoiled = '' AND t.practice = 0 AND t.undone = 0 "
    // While experimenters are blind, only trials of participants who have completed all conditions count;
    // otherwise the difference of the counts before and after a run would be that run's number of trials.
    "AND (p.state = 'completed' OR s.unblinded = 1 OR s.state = 'draft' "
    "OR CASE WHEN json_valid(s.design_json) THEN coalesce(json_extract(s.design_json, "
    "'$.blind_experimenter'), 0) ELSE 0 END = 0)), "
    "CASE WHEN json_valid(s.design_json) THEN coalesce(json_extract(s.design_json, '$.pilot_of'), '') ELSE "
    "'' END AS pilot_of";

StudySummary summaryOf(const Query& row) {
    StudySummary summary;
    summary.id = row.integer(0);
    summary.key = row.text(1);
    summary.title = row.text(2);
    summary.state = row.integer(9) != 0 ? StudyState::archived
                                        : studyStateFromToken(row.text(3)).value_or(StudyState::draft);
    summary.sha256 = row.text(4);
    summary.author = row.integer(5);
    summary.createdUtc = row.text(6);
    summary.frozenUtc = row.text(7);
    summary.unblinded = row.integer(8) != 0;
    summary.demonstration = row.integer(10) != 0;
    summary.participants = static_cast<int>(row.integer(11));
    summary.completed = static_cast<int>(row.integer(12));
    summary.trials = static_cast<int>(row.integer(13));
    summary.pilotOf = row.text(14);
    return summary;
}

// Returns whether the actor may look up which code is which, and therefore may see the conditions themselves.
core::Result<bool> mayKnow(Connection& connection, const Actor& actor, StudyNumber study) {
    const auto may = authoriseForStudy(connection, actor, Action::sealedConditions, StudyPart::study, study);
    if (core::failedAs(may, core::ErrorCode::notAllowed)) {
        return false;
    }
    CHIRON_TRY(may);
    return true;
}

// Returns rows if the actor may read them.
template <class T, class Make>
core::Result<std::vector<T>> permittedRows(Connection& connection, const Actor& actor, Action action,
                                           StudyPart part, std::int64_t number, const std::string& sql,
                                           Make make) {
    CHIRON_TRY(authoriseForStudy(connection, actor, action, part, number));
    return rowsOf<T>(connection, sql, {number}, make);
}

} // namespace

core::Result<std::vector<StudySummary>> StudyReader::listStudies(bool includeArchived) {
    const auto scope = authorise(m_connection, m_actor, Action::listStudies);
    CHIRON_TRY(scope);
    return rowsOf<StudySummary>(m_connection,
                                std::string("SELECT ") + kSummaryColumns +
                                    " FROM study s WHERE (s.author_id = 1 OR ?) AND (s.archived = 0 OR ?) "
                                    "AND pilot_of = '' ORDER BY s.id",
                                {std::int64_t{*scope == Scope::all}, std::int64_t{includeArchived}},
                                summaryOf);
}

core::Result<std::vector<StudySummary>> StudyReader::listPilots(const std::string& key) {
    const auto scope = authorise(m_connection, m_actor, Action::listPilots);
    CHIRON_TRY(scope);
    return rowsOf<StudySummary>(
        m_connection,
        std::string("SELECT ") + kSummaryColumns +
            " FROM study s WHERE (s.author_id = 1 OR ?) AND pilot_of <> '' AND pilot_of = ? ORDER BY s.id",
        {std::int64_t{*scope == Scope::all}, key}, summaryOf);
}

core::Result<StudyRecord> StudyReader::study(StudyNumber study) {
    auto found = permittedRows<StudyRecord>(m_connection, m_actor, Action::study, StudyPart::study, study,
                                            std::string("SELECT ") + kSummaryColumns +
                                                ", s.design_json FROM study s WHERE s.id = ?",
                                            [](const Query& row) {
                                                return StudyRecord{summaryOf(row), row.text(15), {}, false};
                                            });
    if (!found || found->empty()) {
        CHIRON_TRY(found);
        return core::fail(core::ErrorCode::notFound, "there is no study " + std::to_string(study));
    }
    StudyRecord& record = found->front();
    const auto blinding = blindingOf(record.designJson, record.summary.unblinded);
    CHIRON_TRY(blinding);
    const auto open = mayKnow(m_connection, m_actor, study);
    CHIRON_TRY(open);
    record.blinding = *blinding;
    record.masked = blinding->on && !record.summary.sha256.empty() && !*open;
    if (!record.masked) {
        return std::move(record);
    }
    const auto codes = conditionCodes(study);
    CHIRON_TRY(codes);
    auto masked = maskedDesign(record.designJson, *blinding, *codes);
    CHIRON_TRY(masked);
    record.designJson = std::move(*masked);
    return std::move(record);
}

core::Result<StudyRecord> StudyReader::studyByKey(const std::string& key) {
    const auto scope = authorise(m_connection, m_actor, Action::studyByKey);
    CHIRON_TRY(scope);
    const auto id = selectInteger(m_connection,
                                  "SELECT id FROM study WHERE key = ? AND (author_id = 1 OR ?) ORDER BY "
                                  "author_id = 1, id LIMIT 1",
                                  {key, std::int64_t{*scope == Scope::all}});
    CHIRON_TRY(id);
    return *id ? study(**id)
               : core::fail(core::ErrorCode::notFound, "there is no study \"" + key + "\" in the database");
}

core::Result<std::vector<SealedCondition>> StudyReader::conditionCodes(StudyNumber study) {
    CHIRON_TRY(authoriseForStudy(m_connection, m_actor, Action::conditionCodes, StudyPart::study, study));
    const auto blinding = blindingOf(m_connection, StudyPart::study, study);
    CHIRON_TRY(blinding);
    auto codes = sealedConditionRows(m_connection, study);
    if (!codes || !blinding->designed) {
        return codes;
    }
    std::sort(codes->begin(), codes->end(),
              [](const SealedCondition& a, const SealedCondition& b) { return a.sealedCode < b.sealedCode; });
    for (SealedCondition& each : *codes) {
        each.condition = blinding->on ? std::string() : std::move(each.condition);
    }
    return codes;
}

core::Result<std::vector<SealedCondition>> StudyReader::sealedConditions(StudyNumber study) {
    auto done = mayWriteStudy(m_connection, m_actor, Action::sealedConditions, StudyPart::study, study);
    done = done ? appendAudit(m_connection, m_actor, {"sealedConditions", "study", study, std::nullopt, "{}"})
                : done;
    CHIRON_TRY(done);
    return sealedConditionRows(m_connection, study);
}

core::Result<std::vector<Participant>> StudyReader::participants(StudyNumber study) {
    auto allowed = authoriseForStudy(m_connection, m_actor, Action::participants, StudyPart::study, study);
    CHIRON_TRY(allowed);
    return participantRows(m_connection, "p.study_id = ?", {study});
}

core::Result<Participant> StudyReader::participantByCode(StudyNumber study, const std::string& code) {
    CHIRON_TRY(authoriseForStudy(m_connection, m_actor, Action::participantByCode, StudyPart::study, study));
    auto found = participantRows(
        m_connection, "p.study_id = ? AND upper(replace(p.code, '-', '')) = upper(replace(?, '-', ''))",
        {study, code});
    if (!found || found->empty()) {
        CHIRON_TRY(found);
        return core::fail(core::ErrorCode::notFound,
                          "there is no participant \"" + code + "\" in this study");
    }
    return std::move(found->front());
}

core::Result<std::vector<StudyRun>> StudyReader::runs(ParticipantNumber participant) {
    auto allowed =
        authoriseForStudy(m_connection, m_actor, Action::runs, StudyPart::participant, participant);
    CHIRON_TRY(allowed);
    return shownRuns(m_connection, participant);
}

core::Result<std::vector<StudyTrial>> StudyReader::studyTrials(StudyRunNumber run) {
    auto allowed = authoriseForStudy(m_connection, m_actor, Action::studyTrials, StudyPart::run, run);
    CHIRON_TRY(allowed);
    return shownTrials(m_connection, run);
}

core::Result<std::vector<ParticipantQuality>> StudyReader::trialQuality(StudyNumber study) {
    auto allowed = authoriseForStudy(m_connection, m_actor, Action::trialQuality, StudyPart::study, study);
    CHIRON_TRY(allowed);
    return qualityRows(m_connection, study);
}

core::Result<std::vector<QuestionnaireAnswer>> StudyReader::questionnaireAnswers(StudyNumber study) {
    auto allowed =
        authoriseForStudy(m_connection, m_actor, Action::questionnaireAnswers, StudyPart::study, study);
    CHIRON_TRY(allowed);
    return shownAnswers(m_connection, study);
}

core::Result<std::vector<ParticipantKey>> StudyReader::participantKeys(StudyNumber study) {
    auto done = mayWriteStudy(m_connection, m_actor, Action::participantKeys, StudyPart::study, study);
    done = done ? appendAudit(m_connection, m_actor, {"participantKeys", "study", study, std::nullopt, "{}"})
                : done;
    CHIRON_TRY(done);
    return rowsOf<ParticipantKey>(
        m_connection,
        "SELECT p.id, p.code, k.key_json, coalesce((SELECT name FROM person WHERE id = CASE WHEN "
        "json_valid(k.key_json) THEN "
        "json_extract(k.key_json, '$.person') END AND kind = 'person'), '') FROM participant_key k JOIN "
        "study_participant p ON p.id = k.id WHERE "
        "p.study_id = ? AND k.key_json <> '' ORDER BY p.id",
        {study}, [](const Query& row) {
            const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(row.text(2))).object();
            const PersonId person = json["person"].toInteger();
            return ParticipantKey{row.integer(0), row.text(1), json["identity"].toString().toStdString(),
                                  person != 0 ? std::optional(person) : std::nullopt, row.text(3)};
        });
}

} // namespace chiron::database
