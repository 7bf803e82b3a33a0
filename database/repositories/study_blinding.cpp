// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/study_blinding.h"

#include "database/query.h"
#include "database/repositories/study_rows.h"
#include "database/repositories/study_rules.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <array>
#include <initializer_list>
#include <limits>
#include <string_view>

namespace chiron::database {
namespace {

// What is said of a spoiled trial whose reason comes of the forces.
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
    return "study s JOIN study_participant p ON p.study_id = s.id JOIN study_run r ON r.participant_id = p.id WHERE r.id = ?";
}

QJsonObject without(QJsonObject object, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        object.remove(QLatin1String(key));
    }
    return object;
}

// Marks beside an apex as shares of the radius, as if that were 1.
QJsonObject ofRadius(QJsonObject apex) {
    const double radius = apex.value("radius_m").toDouble();
    for (const char* key : {"error_x_m", "error_y_m"}) {
        const QJsonValue error = apex.value(QLatin1String(key));
        apex[QLatin1String(key)] = radius > 0.0 && error.isDouble() ? QJsonValue(error.toDouble() / radius) : QJsonValue();
    }
    apex["radius_m"] = 1.0;
    return apex;
}

// Forces and values, as they were: hard from soft, heavy from light.
std::string withoutPhysics(const std::string& fidelityJson) {
    QJsonObject fidelity = without(QJsonDocument::fromJson(QByteArray::fromStdString(fidelityJson)).object(),
                                   {"peak_force_N", "force_error_rms_N", "saturated", "stiffness_error", "outside"});
    QJsonArray places;
    for (const QJsonValue value : fidelity.value("places").toArray()) {
        places.append(without(value.toObject(), {"asked", "rendered", "standard_error", "peak_force_N", "terminal_force_N"}));
    }
    if (fidelity.contains("places")) {
        fidelity["places"] = places;
    }
    if (fidelity.contains("apex")) {
        fidelity["apex"] = ofRadius(fidelity.value("apex").toObject());
    }
    return QJsonDocument(fidelity).toJson(QJsonDocument::Compact).toStdString();
}

// Reasons of spoiling that come of forces.
bool isOfForces(std::string_view spoiled) {
    constexpr std::array<std::string_view, 4> kReasons{"force_error", "stiffness_error", "saturation", "peak_force"};
    return std::find(kReasons.begin(), kReasons.end(), spoiled) != kReasons.end();
}

// That there was an answer, not which, nor to what.
StudyTrial counted(StudyTrial trial) {
    trial.procedure = 0;
    trial.candidate = trial.arrangement = trial.outcome = -1;
    trial.difference = trial.entropyMargin = std::numeric_limits<double>::quiet_NaN();
    trial.answer = trial.answer >= 0 || trial.value ? 0 : -1;
    trial.value.reset();
    return trial;
}

} // namespace

core::Result<Blinding> blindingOf(const std::string& designJson, bool unblinded) {
    const auto design = designObject(designJson);
    if (!design) {
        return tl::unexpected(design.error());
    }
    Blinding blinding;
    blinding.designed = design->value("blind_experimenter").toBool();
    blinding.on = blinding.designed && !unblinded;
    const QJsonArray conditions = design->value("conditions").toArray();
    const QJsonObject first = conditions.first().toObject();
    const QJsonObject like = first["stimulus"].toObject();
    // Whatever else a condition has is how it asks, so that what is added to conditions later is compared, too.
    const auto asking = [](const QJsonObject& each) { return without(each, {"id", "title", "task", "stimulus"}); };
    for (const QJsonValue value : conditions) {
        const QJsonObject each = value.toObject();
        const QJsonObject stimulus = each["stimulus"].toObject();
        const bool apex = stimulus["attribute"].toString() == kApex;
        blinding.oneTask = blinding.oneTask && each["task"] == first["task"];
        blinding.oneTable = blinding.oneTable && stimulus["differences"] == like["differences"];
        blinding.oneProcedure = blinding.oneProcedure && asking(each) == asking(first);
        blinding.oneStimulus = blinding.oneStimulus && without(stimulus, {"differences"}) == without(like, {"differences"});
        blinding.adjusts = blinding.adjusts || (!apex && each["task"].toString() == QLatin1String("adjustment"));
        blinding.oneExercise = blinding.oneExercise && apex == (like["attribute"].toString() == kApex);
    }
    return blinding;
}

core::Result<Blinding> blindingOf(Connection& connection, StudyPart part, std::int64_t number) {
    auto query = Query::run(connection, "SELECT s.design_json, s.unblinded FROM " + joinsTo(part), {number});
    const auto row = query ? query->next() : tl::unexpected(query.error());
    if (!row) {
        return tl::unexpected(row.error());
    }
    return *row ? blindingOf(query->text(0), query->integer(1) != 0)
                : core::fail(core::ErrorCode::notFound, "there is no study of number " + std::to_string(number));
}

StudyRun sealed(StudyRun run, const Blinding& blinding) {
    if (blinding.on) {
        run.condition.clear();
    }
    if (blinding.on && !blinding.analysable()) { // with the seed each condition's presentations could be drawn, and compared
        run.procedures.clear();
        run.seed = 0;
    }
    return run;
}

StudyTrial sealed(StudyTrial trial, const Blinding& blinding) {
    if (!blinding.on) {
        return trial;
    }
    if (!blinding.analysable()) {
        trial = counted(std::move(trial));
    }
    if (!blinding.oneStimulus) {
        trial.fidelityJson = withoutPhysics(trial.fidelityJson);
        if (trial.fidelityJson.find("\"apex\"") != std::string::npos) { // a distance beside its share would tell the radius
            trial.value.reset();
        }
    }
    trial.spoiled = shownReason(trial.spoiled, blinding);
    return trial;
}

std::string shownReason(const std::string& spoiled, const Blinding& blinding) {
    return blinding.on && !blinding.oneStimulus && isOfForces(spoiled) ? std::string(kWithheld) : spoiled;
}

core::Result<std::vector<StudyRun>> shownRuns(Connection& connection, ParticipantNumber participant) {
    const auto blinding = blindingOf(connection, StudyPart::participant, participant);
    auto runs = blinding ? runRows(connection, participant) : tl::unexpected(blinding.error());
    if (runs) {
        for (StudyRun& run : *runs) {
            run = sealed(std::move(run), *blinding);
        }
    }
    return runs;
}

core::Result<std::vector<StudyTrial>> shownTrials(Connection& connection, StudyRunNumber run) {
    const auto blinding = blindingOf(connection, StudyPart::run, run);
    auto trials = blinding ? studyTrialRows(connection, run) : tl::unexpected(blinding.error());
    if (trials) {
        for (StudyTrial& trial : *trials) {
            trial = sealed(std::move(trial), *blinding);
        }
    }
    return trials;
}

core::Result<bool> isSealedSitting(Connection& connection, const Actor& actor, SessionId session) {
    if (actor.kind() == ActorKind::maintenance) {
        return false;
    }
    const auto found = selectInteger(
        connection,
        "SELECT count(*) FROM study s WHERE s.unblinded = 0 AND s.state <> 'draft' "
        "AND CASE WHEN json_valid(s.design_json) THEN json_extract(s.design_json, '$.blind_experimenter') END = 1 "
        "AND (EXISTS (SELECT 1 FROM study_trial t JOIN study_run r ON r.id = t.run_id JOIN study_participant p "
        "ON p.id = r.participant_id WHERE t.session_id = ? AND p.study_id = s.id) "
        "OR EXISTS (SELECT 1 FROM session x JOIN content c ON c.id = x.content_id JOIN study_condition k "
        "ON k.study_id = s.id WHERE x.id = ? AND "
        "CASE WHEN json_valid(c.json) THEN json_extract(c.json, '$.level.title.en') END = s.key || ' / ' || k.sealed_code))",
        {session, session});
    return found ? core::Result<bool>(found->value_or(0) > 0) : tl::unexpected(found.error());
}

core::Result<void> mayOpenSitting(Connection& connection, const Actor& actor, SessionId session) {
    const auto closed = isSealedSitting(connection, actor, session);
    if (!closed) {
        return tl::unexpected(closed.error());
    }
    return *closed ? core::fail(core::ErrorCode::notAllowed, "session " + std::to_string(session) +
                                                                 " is a sitting of a blinded study: it opens once the study is unblinded")
                   : core::Result<void>();
}

} // namespace chiron::database
