// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_json.h"

#include "catalogue/canonical_json.h"
#include "catalogue/json_file.h"
#include "catalogue/procedure_reader.h"
#include "catalogue/study_parts.h"

#include <cmath>

namespace chiron::catalogue {

using psychophysics::Attribute;
using psychophysics::Condition;
using psychophysics::ProcedureScale;
using psychophysics::StimulusDesign;
using psychophysics::StudyDesign;
using psychophysics::Task;

namespace {

/// Returns the tokens of an enumeration, for messages.
template <class Word, int n> QString tokens() {
    QStringList words;
    for (int i = 0; i < n; ++i) {
        const std::string_view word = psychophysics::token(static_cast<Word>(i));
        words << QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size()));
    }
    return QStringLiteral("one of ") + words.join(", ");
}

std::vector<double> readDifferences(const ObjectReader& json) {
    std::vector<double> out;
    const QJsonValue given = json.json()["differences"];
    const QJsonArray array = given.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString at = elementPath(memberPath(json.path(), "differences"), i);
        const double value = array[i].toDouble(std::nan(""));
        if (!std::isfinite(value) || std::abs(value) > 2.0)
            json.problems().push_back(
                {at, array[i].isDouble() ? QString::number(value) : QStringLiteral("another type"),
                 QStringLiteral("a number, -2 to 2")});
        else if (!out.empty() && value <= out.back())
            json.problems().push_back(
                {at, QString::number(value), QStringLiteral("more than the one before it")});
        out.push_back(value);
    }
    if (!given.isArray() || out.empty() || out.size() > 4096)
        addProblem(json, "differences",
                   given.isUndefined() ? QStringLiteral("missing") : QString::number(out.size()),
                   QStringLiteral("an array of 1 to 4096 numbers, ascending"));
    return out;
}

/// The attributes of objects other than the one compared (comparison_content.h, SI). They are checked there
/// again, with their ranges.
const std::vector<QString>& fixedNames() {
    static const std::vector<QString> names{"stiffness_N_per_m",
                                            "stiffening_per_m",
                                            "mass_kg",
                                            "recovery_s",
                                            "recovery_share",
                                            "roughness_m",
                                            "roughness_wavelength_m",
                                            "friction",
                                            "bristle_stiffness_N_per_m",
                                            "viscosity_Ns_per_m",
                                            "damping_Ns_per_m"};
    return names;
}

std::map<std::string, double> readFixed(const ObjectReader& json) {
    std::map<std::string, double> out;
    for (const QString& key : json.json().keys())
        out[key.toStdString()] = readNumber(json, key.toUtf8().constData(), 0.0, 1e9, 0.0);
    refuseUnknownKeys(json, fixedNames(), QStringLiteral("an attribute of objects"));
    return out;
}

StimulusDesign readStimulus(const ObjectReader& json) {
    StimulusDesign out;
    const std::string word = json.text("attribute");
    const auto attribute = psychophysics::attributeFromToken(word);
    if (!attribute && json.json()["attribute"].isString())
        addProblem(json, "attribute", quoted(QString::fromStdString(word)),
                   tokens<Attribute, psychophysics::kAttributes>());
    out.attribute = attribute.value_or(Attribute::stiffness);
    out.reference = json.number("reference");
    out.differences = readDifferences(json);
    if (json.has("fixed"))
        out.fixed = readFixed(json.object("fixed"));
    refuseUnknownKeys(json, {"attribute", "reference", "differences", "fixed"},
                      QStringLiteral("a key of a stimulus"));
    return out;
}

Condition readCondition(const ObjectReader& json) {
    const std::size_t before = json.problems().size();
    Condition out;
    out.id = readIdentifier(json, "id");
    out.title = readStudyText(json, "title", true);
    out.stimulus = readStimulus(json.object("stimulus"));
    const std::string word = json.text("task");
    const auto task = psychophysics::taskFromToken(word);
    if (!task && json.json()["task"].isString())
        addProblem(json, "task", quoted(QString::fromStdString(word)), tokens<Task, psychophysics::kTasks>());
    out.task = task.value_or(Task::rank3);
    out.scale = readWord(json, "scale", kScales, ProcedureScale::difference);
    out.criterion = readNumber(json, "criterion", 0.01, 0.99, out.criterion);
    out.instructions = readStudyText(json, "instructions", false);
    const bool tableReads = json.problems().size() == before;
    json.eachObject("procedures",
                    [&](const ObjectReader& one) { out.procedures.push_back(readProcedure(one)); });
    if (out.procedures.empty() || out.procedures.size() > 8)
        addProblem(json, "procedures", QString::number(out.procedures.size()),
                   QStringLiteral("1 to 8 procedures"));
    refuseUnknownKeys(json,
                      {"id", "title", "stimulus", "task", "scale", "criterion", "procedures", "instructions"},
                      QStringLiteral("a key of a condition"));
    if (json.problems().size() == before)
        checkCondition(out, json.path(), json.problems());
    else if (tableReads) // if a procedure could not be read, the table may be the reason
        checkTable(out, json.path(), json.problems());
    return out;
}

/// Reads a text in one language, or an empty one.
std::string readLine(const ObjectReader& json, const char* key) {
    constexpr qsizetype kLongest = 2000;
    if (!json.has(QLatin1String(key)))
        return {};
    std::string text = json.text(QLatin1String(key));
    const qsizetype length = QString::fromStdString(text).size();
    if (length > kLongest)
        addProblem(json, key, QStringLiteral("%1 characters").arg(length),
                   QStringLiteral("at most %1").arg(kLongest));
    return text;
}

void readTexts(const ObjectReader& json, StudyDesign& out) {
    out.id = readIdentifier(json, "id");
    out.title = readStudyText(json, "title", true);
    out.objective = readStudyText(json, "objective", true);
    out.instructions = readStudyText(json, "instructions", true);
    if (json.has("own_instructions"))
        out.ownInstructions = readStudyText(json, "own_instructions", false);
    out.consent = readStudyText(json, "consent", true);
    out.source = readLine(json, "source");
    out.ethics = readLine(json, "ethics");
    if (json.has("pilot_of"))
        out.pilotOf = readIdentifier(json, "pilot_of");
}

void readConditions(const ObjectReader& json, StudyDesign& out) {
    std::vector<std::string> seen;
    json.eachObject("conditions", [&](const ObjectReader& one) {
        out.conditions.push_back(readCondition(one));
        refuseTwice(one, "id", out.conditions.back().id, seen);
    });
    if (out.conditions.empty() || out.conditions.size() > 50)
        addProblem(json, "conditions", QString::number(out.conditions.size()),
                   QStringLiteral("1 to 50 conditions"));
}

std::uint64_t readSeed(const ObjectReader& json) {
    if (!json.has("seed"))
        return StudyDesign{}.seed;
    const double seed = json.number("seed");
    if (seed < 0.0 || seed > static_cast<double>(kLargestSeed) || seed != std::floor(seed)) {
        addProblem(json, "seed", QString::number(seed),
                   QStringLiteral("a whole number, 0 to %1").arg(static_cast<qulonglong>(kLargestSeed)));
        return 0;
    }
    return static_cast<std::uint64_t>(seed);
}

} // namespace

core::Result<StudyDesign> readStudy(const QByteArray& json, const std::string& file) {
    const auto parsed = JsonFile::parse(json, QString::fromStdString(file));
    CHIRON_TRY(parsed);
    return readStudy(parsed->root(), *parsed);
}

core::Result<StudyDesign> readStudy(const QJsonObject& document, const JsonFile& file) {
    Problems problems;
    const ObjectReader root(document, QStringLiteral("$"), problems);
    StudyDesign out;
    readTexts(root, out);
    readConditions(root, out);
    out.order = readWord(root, "order", kOrders, out.order);
    if (root.has("trial"))
        out.trial = readTrialRules(root.object("trial"));
    if (root.has("fidelity"))
        out.fidelity = readFidelityLimits(root.object("fidelity"));
    if (root.has("questionnaires"))
        out.questionnaires = readQuestionnaires(root);
    out.participantsPlanned = readWhole(root, "participants_planned", 1, 100000, out.participantsPlanned);
    out.blindParticipant = readSwitch(root, "blind_participant", out.blindParticipant);
    out.blindExperimenter = readSwitch(root, "blind_experimenter", out.blindExperimenter);
    out.seed = readSeed(root);
    refuseUnknownKeys(root,
                      {"id", "title", "objective", "instructions", "own_instructions", "consent",
                       "conditions", "order", "trial", "fidelity", "questionnaires", "participants_planned",
                       "blind_participant", "blind_experimenter", "seed", "source", "ethics", "pilot_of"},
                      QStringLiteral("a key of a study"));
    if (problems.empty())
        checkProbe(out, QStringLiteral("$.trial.probe_at_least_N"), problems);
    if (!problems.empty())
        return tl::unexpected(file.error(problems));
    return out;
}

std::string studySha256(const QByteArray& json) {
    return sha256Hex(json.toStdString());
}

} // namespace chiron::catalogue
