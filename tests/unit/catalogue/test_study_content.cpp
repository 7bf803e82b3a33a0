// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_samples.h"

#include "catalogue/canonical_json.h"
#include "catalogue/comparison_content.h"
#include "catalogue/schema.h"
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <set>

using namespace chiron;
using namespace chiron::catalogue;
using namespace chiron::test;

namespace {
const QString kContent = QStringLiteral(CHIRON_SOURCE_DIR "/curriculum/content");
} // namespace

/// Studies as JSON: read, written, shipped.
class TestStudyContent : public QObject {
    Q_OBJECT
private slots:
    void everyKeyIsRead();
    void writingIsCanonical();
    void keysLeftOutKeepTheDefaults();
    void whatADesignDoesNotSay();
    void shippedStudiesRoundTrip();
    void schemaKnowsEveryKey();
    void shippedStudiesAreComplete();
    void whatAReplayNeedsIsStored();
    void aSmallestForceIsPartOfTheDesign();
};

void TestStudyContent::everyKeyIsRead() {
    using namespace psychophysics;
    const auto study = readStudy(someStudy(), "s.json");
    QVERIFY2(study.has_value(), study ? "" : study.error().message.c_str());
    QCOMPARE(study->title.at("de"), std::string("U"));
    QCOMPARE(study->conditions.size(), std::size_t{2});
    const Condition& first = study->conditions[0];
    QVERIFY(first.task == Task::rank3 && first.stimulus.attribute == Attribute::stiffness &&
            first.criterion == 0.75);
    QCOMPARE(first.stimulus.fixed.at("damping_Ns_per_m"), 1.0);
    QCOMPARE(first.stimulus.differences, (std::vector<double>{0.01, 0.02, 0.1}));
    const Condition& second = study->conditions[1];
    QVERIFY(second.task == Task::twoAfc && second.scale == ProcedureScale::logDifference &&
            second.criterion == 0.8);
    QVERIFY(std::holds_alternative<StaircaseSpec>(second.procedures[0]) &&
            std::get<StaircaseSpec>(second.procedures[0]).start == -1.0);
    QVERIFY(first.instructions.empty() && second.instructions.at("en") == "Put on the glove." &&
            second.instructions.size() == 2);
    QVERIFY(study->order == OrderDesign::latinSquare && study->trial.feedback &&
            study->trial.practiceTrials == 2);
    QCOMPARE(study->fidelity.peakForce_N, 3.0);
    QCOMPARE(study->fidelity.lateTicks, FidelityLimits{}.lateTicks);
    const Questionnaire& questionnaire = study->questionnaires.at(0);
    QVERIFY(questionnaire.when == Questionnaire::When::before && questionnaire.items.size() == 4);
    QVERIFY(questionnaire.items[0].scale == 7 && questionnaire.items[0].high.at("en") == "yes" &&
            questionnaire.items[0].construct == "face");
    QVERIFY(questionnaire.items[1].highest == 9.0 && questionnaire.items[2].choices.size() == 2 &&
            !questionnaire.items[3].required);
    QVERIFY(study->participantsPlanned == 7 && !study->blindParticipant && study->blindExperimenter);
    QCOMPARE(study->seed, std::uint64_t{9007199254740991});
}

void TestStudyContent::writingIsCanonical() {
    const auto study = readStudy(someStudy(), "s.json");
    const QByteArray written = studyJson(*study);
    QCOMPARE(QByteArray::fromStdString(canonicalJson(parsed(written))), written);
    const auto again = readStudy(written, "again");
    QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
    QCOMPARE(studyJson(*again), written);
    const QJsonArray conditions = parsed(written)["conditions"].toArray();
    QVERIFY(!conditions[0].toObject().contains("instructions") &&
            conditions[1].toObject().contains("instructions")); // digests of older designs stay
    QCOMPARE(studySha256(written).size(), std::size_t{64});
    QVERIFY(studySha256(written) != studySha256(written + " "));
    // Order of keys and spaces do not matter, a value does.
    QCOMPARE(studyJson(*readStudy(QJsonDocument(parsed(someStudy())).toJson(), "spaced")), written);
    const QJsonObject other = changed(parsed(someStudy()), {"seed"}, 8).toObject();
    QVERIFY(studyJson(*readStudy(QJsonDocument(other).toJson(), "other")) != written);
}

void TestStudyContent::keysLeftOutKeepTheDefaults() {
    QJsonObject json = parsed(someStudy());
    for (const char* key : {"order", "trial", "fidelity", "questionnaires", "participants_planned",
                            "blind_participant", "blind_experimenter", "seed"})
        json.remove(QLatin1String(key));
    const auto study = readStudy(QJsonDocument(json).toJson(), "short");
    QVERIFY(study.has_value());
    const psychophysics::StudyDesign plain;
    QVERIFY(study->order == plain.order && study->seed == plain.seed &&
            study->participantsPlanned == plain.participantsPlanned);
    QVERIFY(study->trial.exploreLimit_s == plain.trial.exploreLimit_s &&
            study->blindParticipant == plain.blindParticipant);
}

// A design that says no more than it has to: what it then means is written into it when it is frozen, and
// must not become something else in a later version.
void TestStudyContent::whatADesignDoesNotSay() {
    QJsonObject json = parsed(someStudy());
    for (const char* key : {"order", "trial", "fidelity", "participants_planned", "blind_participant",
                            "blind_experimenter", "seed"})
        json.remove(QLatin1String(key));
    QJsonObject condition = json["conditions"].toArray().at(0).toObject();
    for (const char* key : {"scale", "criterion"})
        condition.remove(QLatin1String(key));
    json["conditions"] = QJsonArray{condition};
    const QJsonObject item{{"id", "l"}, {"text", QJsonObject{{"en", "L"}}}, {"kind", "likert"}};
    json["questionnaires"] = QJsonArray{
        QJsonObject{{"id", "q"}, {"title", QJsonObject{{"en", "Q"}}}, {"items", QJsonArray{item}}}};
    const auto study = readStudy(QJsonDocument(json).toJson(), "short");
    QVERIFY2(study, study ? "" : study.error().message.c_str());
    const QJsonObject written = parsed(studyJson(*study));
    QCOMPARE(canonicalJson(written["trial"]), canonicalJson(QJsonObject{{"explore_limit_s", 30},
                                                                        {"answer_limit_s", 20},
                                                                        {"between_trials_s", 1},
                                                                        {"break_at_least_s", 30},
                                                                        {"practice_trials", 4},
                                                                        {"break_every", 40},
                                                                        {"feedback", false},
                                                                        {"masking_sound", true},
                                                                        {"visible_objects", true},
                                                                        {"must_touch_all", true}}));
    QCOMPARE(canonicalJson(written["fidelity"]), canonicalJson(QJsonObject{{"force_error_rms_N", 0.15},
                                                                           {"stiffness_error", 0.15},
                                                                           {"late_ticks", 0.01},
                                                                           {"saturated", 0.05},
                                                                           {"peak_force_N", 4},
                                                                           {"mean_speed_m_per_s", 0.2},
                                                                           {"repeats_at_most", 5}}));
    QCOMPARE(written["order"].toString(), QStringLiteral("williams"));
    QCOMPARE(written["participants_planned"].toInt(), 12);
    QCOMPARE(written["seed"].toInt(), 1);
    QVERIFY(written["blind_participant"].toBool() && !written["blind_experimenter"].toBool());
    const QJsonObject asked = written["conditions"].toArray().at(0).toObject();
    QCOMPARE(asked["criterion"].toDouble(), 0.75);
    QCOMPARE(asked["scale"].toString(), QStringLiteral("difference"));
    const QJsonObject questionnaire = written["questionnaires"].toArray().at(0).toObject();
    QCOMPARE(questionnaire["when"].toString(), QStringLiteral("after"));
    const QJsonObject question = questionnaire["items"].toArray().at(0).toObject();
    QVERIFY(question["scale"].toInt() == 5 && question["required"].toBool() &&
            question["construct"].toString().isEmpty());
}

void TestStudyContent::shippedStudiesRoundTrip() {
    const auto catalogue = StudyCatalogue::load(kContent.toStdString());
    QVERIFY2(catalogue.has_value(), catalogue ? "" : catalogue.error().message.c_str());
    QCOMPARE(catalogue->studies().size(), std::size_t{14});
    for (const auto& study : catalogue->studies()) {
        const QByteArray written = studyJson(study);
        const auto again = readStudy(written, study.id);
        QVERIFY2(again.has_value(), again ? "" : again.error().message.c_str());
        QCOMPARE(studyJson(*again), written);
        QCOMPARE(catalogue->find(study.id), &study);
    }
    QVERIFY(catalogue->find("none") == nullptr);
}

// schema/study.json documents every key that is written, with a range that holds.
void TestStudyContent::schemaKnowsEveryKey() {
    const auto schema = readSchema(kContent + "/schema", "study");
    QVERIFY2(schema.has_value(), schema ? "" : schema.error().message.c_str());
    const auto catalogue = StudyCatalogue::load(kContent.toStdString());
    std::vector<QByteArray> documents{studyJson(*readStudy(someStudy(), "s"))};
    for (const auto& study : catalogue->studies())
        documents.push_back(studyJson(study));
    for (const QByteArray& document : documents) {
        Problems problems;
        (void)validated(parsed(document), *schema, "$", problems);
        QVERIFY2(problems.empty(), problems.empty() ? ""
                                                    : qPrintable(problems[0].path + ": " + problems[0].found +
                                                                 ": " + problems[0].expected));
    }
}

// One study an attribute by rank-3, each other way of asking once, the surgeons' with both validities, in
// three languages.
void TestStudyContent::shippedStudiesAreComplete() {
    using namespace psychophysics;
    const auto catalogue = StudyCatalogue::load(kContent.toStdString());
    const auto inEveryLanguage = [](const StudyText& text) {
        const auto languages = core::languageIds();
        return std::all_of(languages.begin(), languages.end(),
                           [&](const std::string& language) { return text.contains(language); });
    };
    std::set<Attribute> ranked;
    std::set<Task> tasks;
    std::set<std::string> kinds;
    for (const StudyDesign& study : catalogue->studies()) {
        for (const StudyText* text : {&study.title, &study.objective, &study.instructions, &study.consent})
            QVERIFY2(inEveryLanguage(*text), study.id.c_str());
        QVERIFY(study.blindParticipant);
        for (const Condition& condition : study.conditions) {
            QVERIFY2(inEveryLanguage(condition.title), study.id.c_str());
            tasks.insert(condition.task);
            for (const ProcedureSpec& spec : condition.procedures) {
                kinds.insert(std::string(kindOf(spec)));
                if (kindOf(spec) == "rank3_quest_plus")
                    ranked.insert(condition.stimulus.attribute);
            }
        }
    }
    QCOMPARE(ranked.size(), std::size_t{6});
    QVERIFY(tasks.contains(Task::twoAfc) && tasks.contains(Task::magnitude) &&
            tasks.contains(Task::adjustment));
    QVERIFY(kinds.contains("descending") && kinds.contains("quest_plus") && kinds.contains("constant"));
    std::set<std::string> constructs;
    for (const Questionnaire& questionnaire : catalogue->find("surgeons")->questionnaires)
        for (const QuestionnaireItem& item : questionnaire.items) {
            constructs.insert(item.construct);
            QVERIFY(inEveryLanguage(item.text));
        }
    QVERIFY(constructs.contains("face") && constructs.contains("content"));
}

/// How a tube is taken hold of again, and whether the session begins with a free minute, is stored with the
/// session and read for its replay; where neither is so, nothing is written.
void TestStudyContent::whatAReplayNeedsIsStored() {
    const auto study = readStudy(someStudy(), "study");
    QVERIFY(study);
    psychophysics::Condition condition = study->conditions[0];
    condition.stimulus.attribute = psychophysics::Attribute::stiffness;
    condition.stimulus.reference = 300.0;
    auto parameters = comparisonOf(condition, study->trial);
    QVERIFY(parameters && parameters->leaveBeforeAgain && !parameters->freeFirst);
    for (const bool is : {false, true}) {
        parameters->leaveBeforeAgain = parameters->freeFirst = is;
        const ExerciseLevel level = comparisonLevel(*parameters, "study", "a");
        const auto& read = level.parameters.as<simulation::ComparisonParameters>();
        QVERIFY(read.leaveBeforeAgain == is && read.freeFirst == is);
    }
    QCOMPARE(parameters->padSlope, 0.0); // of a tube
    condition.stimulus.attribute = psychophysics::Attribute::friction;
    condition.stimulus.reference = 0.25;
    parameters = comparisonOf(condition, study->trial);
    QVERIFY(parameters && parameters->padSlope > 0.0);
    for (const double slope : {0.75, 0.0}) { // 0: as in sessions of earlier versions
        parameters->padSlope = slope;
        const ExerciseLevel level = comparisonLevel(*parameters, "study", "a");
        QCOMPARE(level.parameters.as<simulation::ComparisonParameters>().padSlope, slope);
        QCOMPARE(level.resolvedJson.find("pad_slope") != std::string::npos, slope > 0.0);
    }
    parameters->padSlope = 11.0;
    Problems problems;
    checkComparison(ExerciseParameters(*parameters), QStringLiteral("level"), problems);
    QCOMPARE(problems.size(), std::size_t{1});
    QCOMPARE(problems.front().path, QStringLiteral("level.pad_slope"));
    condition.stimulus.attribute = psychophysics::Attribute::stiffness;
    condition.stimulus.reference = 300.0;
    parameters = comparisonOf(condition, study->trial);
    QVERIFY(std::isinf(parameters->yield.force_N));
    condition.stimulus.attribute = psychophysics::Attribute::mass;
    condition.stimulus.reference = 0.1;
    parameters = comparisonOf(condition, study->trial);
    QVERIFY(!parameters->leaveBeforeAgain && parameters->touchedOnceLifted);
    QCOMPARE(parameters->yield.force_N, 3.0 * parameters->maximumForce_N); // how hard it may be pressed
    for (const bool is : {true, false}) {
        if (!is) { // as in sessions of earlier versions
            parameters->yield = {};
            parameters->touchedOnceLifted = false;
        }
        const ExerciseLevel level = comparisonLevel(*parameters, "study", "a");
        const auto& read = level.parameters.as<simulation::ComparisonParameters>();
        QCOMPARE(read.yield.force_N, parameters->yield.force_N);
        QCOMPARE(read.yield.fall_s, parameters->yield.fall_s);
        QCOMPARE(read.touchedOnceLifted, is);
        QCOMPARE(level.resolvedJson.find("yield") != std::string::npos, is);
    }
}

/// Designs without it stay what they were, to the byte; new ones say it, and it goes into what a session
/// stores.
void TestStudyContent::aSmallestForceIsPartOfTheDesign() {
    const auto without = readStudy(someStudy(), "without");
    QVERIFY(without);
    QCOMPARE(without->trial.probeAtLeast_N, 0.0);
    QVERIFY(!studyJson(*without).contains("probe_at_least_N"));
    auto parameters = comparisonOf(without->conditions[0], without->trial);
    QVERIFY(parameters);
    QCOMPARE(parameters->probeAtLeast_N, 0.0);

    const auto read = [](double probe_N) {
        return readStudy(
            QJsonDocument(changed(parsed(someStudy()), {"trial", "probe_at_least_N"}, probe_N).toObject())
                .toJson(),
            "with");
    };
    const auto with = read(0.3);
    QVERIFY2(with, with ? "" : with.error().message.c_str());
    QCOMPARE(with->trial.probeAtLeast_N, 0.3);
    QVERIFY(studyJson(*with).contains("\"probe_at_least_N\":0.3"));
    parameters = comparisonOf(with->conditions[0], with->trial);
    QCOMPARE(parameters->probeAtLeast_N, 0.3);
    const ExerciseLevel level =
        comparisonLevel(*parameters, "study", "a"); // as it is stored with a session, and read for its replay
    QCOMPARE(level.parameters.as<simulation::ComparisonParameters>().probeAtLeast_N, 0.3);
    psychophysics::TrialRules rules = with->trial;
    rules.mustTouchAll = false;
    QCOMPARE(comparisonOf(with->conditions[0], rules)->probeAtLeast_N, 0.0); // nothing has to be touched

    const auto heavy = read(0.6); // the lightest object of 50 g weighs 0.49 N
    QVERIFY(!heavy &&
            QString::fromStdString(heavy.error().message).contains(QStringLiteral("lightest object")));
    const auto beyond = read(3.0); // a trial with more than 3 N does not count
    QVERIFY(!beyond &&
            QString::fromStdString(beyond.error().message).contains(QStringLiteral("largest force")));
    const auto catalogue = StudyCatalogue::load(kContent.toStdString());
    for (const auto& study : catalogue->studies())
        if (study.conditions.front().stimulus.attribute != psychophysics::Attribute::apex)
            QVERIFY2(study.trial.probeAtLeast_N == psychophysics::kUsualProbe_N, study.id.c_str());
}

QTEST_APPLESS_MAIN(TestStudyContent)
#include "test_study_content.moc"
