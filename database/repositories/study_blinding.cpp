// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_blinding.h"

#include "database/query.h"
#include "database/repositories/study_rows.h"
#include "database/repositories/study_rules.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <string_view>

namespace chiron::database {
namespace {

// The reason shown for a trial that was spoiled for a reason related to forces.
constexpr std::string_view kWithheld = "withheld";
constexpr QLatin1String kApex("apex");

std::string joinsTo(StudyPart part) {
    switch (part) {
    case StudyPart::study:
        return "study s WHERE s.id = ?";
    case StudyPart::participant:
        return "study s JOIN study_participant p ON p.study_id = s.id WHERE p.id = ?";
    case StudyPart::run:
        break;
    }
    return "study s JOIN study_participant p ON p.study_id = s.id JOIN study_run r ON r.participant_id = "
           "p.id WHERE r.id = ?";
}

QJsonObject without(QJsonObject object, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        object.remove(QLatin1String(key));
    }
    return object;
}

// Returns whether the reason for spoiling a trial is related to forces.
bool isOfForces(std::string_view spoiled) {
    constexpr std::array<std::string_view, 4> kReasons{"force_error", "stiffness_error", "saturation",
                                                       "peak_force"};
    return std::find(kReasons.begin(), kReasons.end(), spoiled) != kReasons.end();
}

} // namespace

core::Result<Blinding> blindingOf(const std::string& designJson, bool unblinded) {
    const auto design = designObject(designJson);
    CHIRON_TRY(design);
    Blinding blinding;
    blinding.designed = design->value("blind_experimenter").toBool();
    blinding.on = blinding.designed && !unblinded;
    const QJsonArray conditions = design->value("conditions").toArray();
    const QJsonObject first = conditions.first().toObject();
    const QJsonObject like = first["stimulus"].toObject();
    // All other keys of a condition say how it asks, so that keys added to conditions later are compared,
    // too.
    const auto asking = [](const QJsonObject& each) {
        return without(each, {"id", "title", "task", "stimulus", "instructions"});
    };
    for (const QJsonValue value : conditions) {
        const QJsonObject each = value.toObject();
        const QJsonObject stimulus = each["stimulus"].toObject();
        const bool apex = stimulus["attribute"].toString() == kApex;
        blinding.oneTask = blinding.oneTask && each["task"] == first["task"];
        blinding.oneTable = blinding.oneTable && stimulus["differences"] == like["differences"];
        blinding.oneProcedure = blinding.oneProcedure && asking(each) == asking(first);
        blinding.oneStimulus =
            blinding.oneStimulus && without(stimulus, {"differences"}) == without(like, {"differences"});
        blinding.adjusts =
            blinding.adjusts || (!apex && each["task"].toString() == QLatin1String("adjustment"));
        blinding.oneExercise = blinding.oneExercise && apex == (like["attribute"].toString() == kApex);
    }
    return blinding;
}

core::Result<Blinding> blindingOf(Connection& connection, StudyPart part, std::int64_t number) {
    auto query = Query::run(connection, "SELECT s.design_json, s.unblinded FROM " + joinsTo(part), {number});
    CHIRON_TRY(query);
    const auto row = query->next();
    CHIRON_TRY(row);
    return *row ? blindingOf(query->text(0), query->integer(1) != 0)
                : core::fail(core::ErrorCode::notFound,
                             "there is no study of number " + std::to_string(number));
}

StudyRun sealed(StudyRun run, const Blinding& blinding) {
    if (blinding.on) {
        run.condition.clear();
    }
    // With the seed the presentations of each condition could be drawn and compared.
    if (blinding.seals()) {
        run.procedures.clear();
        run.seed = 0;
        run.endedUtc.clear(); // reveals how long the run took
    }
    return run;
}

QuestionnaireAnswer sealed(QuestionnaireAnswer answer, const Blinding& blinding) {
    if (blinding.on) {
        answer.condition.clear();
    }
    // The difficulty of a condition reveals which one it is, and the time reveals how long it took.
    if (blinding.seals() && answer.run != 0) {
        answer.number.reset();
        answer.text.clear();
        answer.utc.clear();
        answer.withheld = true;
    }
    return answer;
}

std::string shownReason(const std::string& spoiled, const Blinding& blinding) {
    return blinding.on && !blinding.oneStimulus && isOfForces(spoiled) ? std::string(kWithheld) : spoiled;
}

core::Result<std::vector<StudyRun>> shownRuns(Connection& connection, ParticipantNumber participant) {
    const auto blinding = blindingOf(connection, StudyPart::participant, participant);
    CHIRON_TRY(blinding);
    auto runs = runRows(connection, participant);
    if (runs) {
        for (StudyRun& run : *runs) {
            run = sealed(std::move(run), *blinding);
        }
    }
    return runs;
}

core::Result<std::vector<QuestionnaireAnswer>> shownAnswers(Connection& connection, StudyNumber study) {
    const auto blinding = blindingOf(connection, StudyPart::study, study);
    CHIRON_TRY(blinding);
    auto answers = answerRows(connection, "p.study_id = ?", study);
    if (answers) {
        for (QuestionnaireAnswer& answer : *answers) {
            answer = sealed(std::move(answer), *blinding);
        }
    }
    return answers;
}

core::Result<std::vector<StudyTrial>> shownTrials(Connection& connection, StudyRunNumber run) {
    const auto blinding = blindingOf(connection, StudyPart::run, run);
    CHIRON_TRY(blinding);
    return blinding->seals() ? core::Result<std::vector<StudyTrial>>(std::vector<StudyTrial>())
                             : studyTrialRows(connection, run);
}

namespace {

// Adds all of a participant's trials, whatever their conditions.
void addTrials(ParticipantQuality& quality, const std::vector<StudyTrial>& trials,
               std::set<std::string>& devices, std::map<std::string, int>& reasons, std::vector<double>& late,
               std::vector<double>& times) {
    for (const StudyTrial& trial : trials) {
        const QJsonObject fidelity =
            QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson)).object();
        if (const QJsonValue share = fidelity["late_ticks"]; share.isDouble()) {
            late.push_back(share.toDouble());
        }
        if (const QJsonValue worst = fidelity["worst_lateness_us"]; worst.isDouble()) {
            quality.worstLateness_us = std::fmax(quality.worstLateness_us, worst.toDouble());
        }
        if (trial.felt) {
            quality.felt = quality.felt.value_or(true) && *trial.felt;
            devices.insert(trial.device);
        }
        ++quality.presentations;
        quality.practice += trial.practice ? 1 : 0;
        const bool scored = !trial.practice && !trial.undone && trial.spoiled.empty();
        quality.scored += scored ? 1 : 0;
        if (scored && trial.exploration_s > 0.0) { // in a simulation without rendering nothing was explored
            times.push_back(trial.exploration_s);
        }
        if (isRepeated(trial)) {
            ++reasons[trial.spoiled];
        }
    }
}

double medianOf(std::vector<double> values) {
    if (values.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    std::sort(values.begin(), values.end());
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

// Removes the figures that depend on the objects; used until every condition is included.
ParticipantQuality withoutBehaviour(ParticipantQuality quality) {
    quality.presentations = quality.practice = quality.scored = 0;
    quality.spoiled.clear();
    quality.exploration_s = std::numeric_limits<double>::quiet_NaN();
    return quality;
}

core::Result<ParticipantQuality> qualityOf(Connection& connection, ParticipantNumber participant,
                                           int conditions, const Blinding& blinding) {
    ParticipantQuality quality;
    quality.participant = participant;
    quality.conditions = conditions;
    const auto runs = runRows(connection, participant);
    CHIRON_TRY(runs);
    std::set<std::string> devices, done;
    std::map<std::string, int> reasons;
    std::vector<double> late, times;
    for (const StudyRun& run : *runs) {
        const auto trials = studyTrialRows(connection, run.id);
        CHIRON_TRY(trials);
        addTrials(quality, *trials, devices, reasons, late, times);
        if (run.state == StudyRunState::completed) {
            done.insert(run.condition);
        }
    }
    quality.conditionsDone = static_cast<int>(done.size());
    quality.whole = !blinding.seals() || quality.conditionsDone == conditions;
    if (!late.empty()) {
        quality.lateTicks = std::accumulate(late.begin(), late.end(), 0.0) / static_cast<double>(late.size());
    }
    for (const std::string& device : devices) {
        quality.device += (quality.device.empty() ? "" : ", ") + device;
    }
    quality.spoiled.assign(reasons.begin(), reasons.end());
    quality.exploration_s = medianOf(std::move(times));
    return quality.whole ? quality : withoutBehaviour(std::move(quality));
}

} // namespace

core::Result<std::vector<ParticipantQuality>> qualityRows(Connection& connection, StudyNumber study) {
    const auto blinding = blindingOf(connection, StudyPart::study, study);
    CHIRON_TRY(blinding);
    const auto conditions = sealedConditionRows(connection, study);
    CHIRON_TRY(conditions);
    auto participants = participantRows(connection, "p.study_id = ?", {study});
    CHIRON_TRY(participants);
    std::vector<ParticipantQuality> rows;
    for (const Participant& participant : *participants) {
        auto quality = qualityOf(connection, participant.id, static_cast<int>(conditions->size()), *blinding);
        CHIRON_TRY(quality);
        rows.push_back(std::move(*quality));
    }
    return rows;
}

core::Result<bool> isSealedSitting(Connection& connection, const Actor& actor, SessionId session) {
    if (actor.kind() == ActorKind::maintenance) {
        return false;
    }
    const auto found = selectInteger(
        connection,
        "SELECT count(*) FROM study s WHERE s.unblinded = 0 AND s.state <> 'draft' "
        "AND CASE WHEN json_valid(s.design_json) THEN json_extract(s.design_json, '$.blind_experimenter') "
        "END = 1 "
        "AND (EXISTS (SELECT 1 FROM recorded_sitting t JOIN study_run r ON r.id = t.run_id JOIN "
        "study_participant p "
        "ON p.id = r.participant_id WHERE t.session_id = ? AND p.study_id = s.id) "
        "OR EXISTS (SELECT 1 FROM session x JOIN content c ON c.id = x.content_id JOIN study_condition k "
        "ON k.study_id = s.id WHERE x.id = ? AND "
        "CASE WHEN json_valid(c.json) THEN json_extract(c.json, '$.level.title.en') END = s.key || ' / ' || "
        "k.sealed_code))",
        {session, session});
    CHIRON_TRY(found);
    return found->value_or(0) > 0;
}

core::Result<std::set<SessionId>> sealedSittings(Connection& connection, const Actor& actor) {
    std::set<SessionId> sealed;
    if (actor.kind() == ActorKind::maintenance) {
        return sealed;
    }
    const std::string blind = "s.unblinded = 0 AND s.state <> 'draft' "
                              "AND CASE WHEN json_valid(s.design_json) THEN json_extract(s.design_json, "
                              "'$.blind_experimenter') END = 1";
    auto query = Query::run(
        connection,
        "SELECT t.session_id FROM study s JOIN study_participant p ON p.study_id = s.id JOIN study_run r ON "
        "r.participant_id = p.id "
        "JOIN recorded_sitting t ON t.run_id = r.id WHERE " +
            blind + " UNION SELECT x.id FROM session x WHERE EXISTS (SELECT 1 FROM study s WHERE " + blind +
            ") AND x.content_id IN (SELECT c.id FROM content c "
            "WHERE CASE WHEN json_valid(c.json) THEN json_extract(c.json, '$.level.title.en') END IN "
            "(SELECT s.key || ' / ' || k.sealed_code FROM study s JOIN study_condition k ON k.study_id = "
            "s.id WHERE " +
            blind + "))",
        {});
    CHIRON_TRY(query);
    auto row = query->next();
    for (; row && *row; row = query->next()) {
        sealed.insert(query->integer(0));
    }
    CHIRON_TRY(row);
    return sealed;
}

core::Result<void> mayOpenSitting(Connection& connection, const Actor& actor, SessionId session) {
    const auto closed = isSealedSitting(connection, actor, session);
    CHIRON_TRY(closed);
    return *closed ? core::fail(core::ErrorCode::notAllowed,
                                "session " + std::to_string(session) +
                                    " is a session of a blinded study: it opens once the study is unblinded")
                   : core::Result<void>();
}

} // namespace chiron::database
