// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_samples.h"

#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

using namespace chiron;
using namespace chiron::catalogue;
using namespace chiron::test;

/// Studies that are wrong, each refused with its place.
class TestStudyFaults : public QObject {
    Q_OBJECT
private slots:
    void wrongDesignsAreRefused_data();
    void wrongDesignsAreRefused();
    void everythingWrongIsToldTogether();
    void brokenFoldersAreTold();
};

void TestStudyFaults::wrongDesignsAreRefused_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("json");  ///< the value put there; empty: taken out
    QTest::addColumn<QString>("place"); ///< what the message says
    const auto row = [](const char* path, const char* json, const char* place) {
        QTest::addRow("%s=%s", path, json) << path << json << place;
    };
    row("id", "", "$.id: missing");
    row("id", "7", "$.id: another type");
    row("id", "\"Big\"", "$.id: \"Big\"");
    row("id", "\"\"", "$.id");
    row("title", "", "$.title: missing");
    row("title", "{}", "$.title.en: missing");
    row("title", "{\"de\":\"D\"}", "$.title.en: missing");
    row("title", "{\"en\":\"\"}", "$.title.en: 0 characters");
    row("title", "{\"en\":\"E\",\"German\":\"D\"}", "$.title.German: unknown key");
    row("title", "{\"en\":7}", "$.title.en: another type");
    row("objective", "7", "$.objective: another type");
    row("instructions", "", "$.instructions: missing");
    row("consent", "", "$.consent: missing");
    row("colour", "1", "$.colour: unknown key");
    row("conditions", "", "$.conditions: missing");
    row("conditions", "[]", "$.conditions: 0");
    row("conditions", "[7]", "$.conditions[0]: another type");
    row("conditions.1.id", "\"a\"", "$.conditions[1].id: \"a\": expected an id that is not given twice");
    row("conditions.0.id", "\"A b\"", "$.conditions[0].id");
    row("conditions.0.title", "", "$.conditions[0].title: missing");
    row("conditions.0.colour", "1", "$.conditions[0].colour: unknown key");
    row("conditions.0.stimulus", "", "$.conditions[0].stimulus: missing");
    row("conditions.0.stimulus.attribute", "\"warmth\"", "$.conditions[0].stimulus.attribute: \"warmth\"");
    row("conditions.0.stimulus.attribute", "", "$.conditions[0].stimulus.attribute: missing");
    row("conditions.0.stimulus.attribute", "\"apex\"", "$.conditions[0].task: \"rank3\"");
    row("conditions.0.stimulus.reference", "", "$.conditions[0].stimulus.reference: missing");
    row("conditions.0.stimulus.reference", "0", "$.conditions[0].stimulus.reference: 0");
    row("conditions.0.stimulus.reference", "-60", "$.conditions[0].stimulus.reference: -60");
    row("conditions.0.stimulus.reference", "60000", "$.conditions[0].stimulus.reference: 60000");
    row("conditions.0.stimulus.reference", "19000", "$.conditions[0].stimulus.differences[2]: an object of");
    row("conditions.1.stimulus.reference", "50",
        "$.conditions[1].stimulus.reference: 50: expected 0.001 to 10 kg");
    row("conditions.0.stimulus.differences", "", "$.conditions[0].stimulus.differences: missing");
    row("conditions.0.stimulus.differences", "[]", "$.conditions[0].stimulus.differences: 0");
    row("conditions.0.stimulus.differences", "0.1", "$.conditions[0].stimulus.differences");
    row("conditions.0.stimulus.differences", "[0.1,0.1]",
        "$.conditions[0].stimulus.differences[1]: 0.1: expected more than");
    row("conditions.0.stimulus.differences", "[0.02,0.1,0.05]",
        "$.conditions[0].stimulus.differences[2]: 0.05");
    row("conditions.0.stimulus.differences", "[0.02,\"x\"]",
        "$.conditions[0].stimulus.differences[1]: another type");
    row("conditions.0.stimulus.differences", "[0.02,0.1,3]", "$.conditions[0].stimulus.differences[2]: 3");
    row("conditions.0.stimulus.differences", "[-0.1,0.02,0.1]",
        "$.conditions[0].stimulus.differences[0]: -0.1: expected more than 0 for the task rank3");
    row("conditions.1.stimulus.differences", "[0,0.1]",
        "$.conditions[1].stimulus.differences[0]: 0: expected more than 0: the scale");
    row("conditions.0.stimulus.fixed", "{\"colour\":1}",
        "$.conditions[0].stimulus.fixed.colour: unknown key");
    row("conditions.0.stimulus.fixed", "{\"mass_kg\":-1}", "$.conditions[0].stimulus.fixed.mass_kg: -1");
    row("conditions.0.stimulus.fixed", "{\"mass_kg\":\"1\"}",
        "$.conditions[0].stimulus.fixed.mass_kg: another type");
    row("conditions.0.stimulus.size", "1", "$.conditions[0].stimulus.size: unknown key");
    row("conditions.0.procedures",
        R"([{"kind":"rank3_quest_plus","differences":[0.02,0.1],"allow_ties":true}])",
        "$.conditions[0].procedures[0].allow_ties: true: expected false for the task rank3");
    row("conditions.0.task", "\"rank4\"", "$.conditions[0].task: \"rank4\"");
    row("conditions.0.task", "", "$.conditions[0].task: missing");
    row("conditions.0.task", "\"adjustment\"",
        "$.conditions[0].procedures[0].kind: \"descending\": expected for the task adjustment one of "
        "constant");
    row("conditions.0.task", "\"magnitude\"", "$.conditions[0].procedures[0].kind: \"descending\"");
    row("conditions.1.task", "\"rank3\"",
        "$.conditions[1].procedures[0].kind: \"staircase\": expected for the task rank3 one of "
        "rank3_quest_plus");
    row("conditions.0.scale", "\"decibel\"", "$.conditions[0].scale: \"decibel\"");
    row("conditions.0.criterion", "1", "$.conditions[0].criterion: 1");
    row("conditions.0.procedures", "[]", "$.conditions[0].procedures: 0");
    row("conditions.0.procedures", "", "$.conditions[0].procedures: missing");
    row("conditions.0.procedures.0.kind", "\"bisection\"",
        "$.conditions[0].procedures[0].kind: \"bisection\"");
    row("conditions.0.procedures.0.kind", "", "$.conditions[0].procedures[0].kind: missing");
    row("conditions.0.procedures.0.levels", "[0.5,0.02]", "$.conditions[0].procedures[0].levels: 0.5");
    row("conditions.0.procedures.0.passes", "\"two\"", "$.conditions[0].procedures[0].passes: another type");
    row("conditions.0.procedures.0.luck", "1", "$.conditions[0].procedures[0].luck: unknown key");
    row("conditions.1.procedures.1.levels", "[-3,-1]", "$.conditions[1].procedures[1].levels: -3");
    row("conditions.1.procedures.0.kind", "\"rank3_quest_plus\"", "$.conditions[1].procedures[0]");
    row("order", "\"alphabetical\"", "$.order: \"alphabetical\"");
    row("trial", "7", "$.trial: another type");
    row("trial.feedback", "1", "$.trial.feedback: another type");
    row("trial.practice_trials", "2.5", "$.trial.practice_trials: 2.5: expected a whole number");
    row("trial.practice_trials", "-1", "$.trial.practice_trials: -1");
    row("trial.explore_limit_s", "1e6", "$.trial.explore_limit_s: 1e+06");
    row("trial.pause", "1", "$.trial.pause: unknown key");
    row("fidelity.late_ticks", "1.5", "$.fidelity.late_ticks: 1.5");
    row("fidelity.repeats_at_most", "0", "$.fidelity.repeats_at_most: 0");
    row("fidelity.peak_force", "1",
        "$.fidelity.peak_force: unknown key: expected a limit of fidelity; did you mean \"peak_force_N\"?");
    row("questionnaires", "{}", "$.questionnaires: another type");
    row("questionnaires.0.items", "[]", "$.questionnaires[0].items: 0");
    row("questionnaires.0.when", "\"during\"", "$.questionnaires[0].when: \"during\"");
    row("questionnaires.0.items.1.id", "\"l\"", "$.questionnaires[0].items[1].id: \"l\"");
    row("questionnaires.0.items.0.kind", "\"stars\"", "$.questionnaires[0].items[0].kind: \"stars\"");
    row("questionnaires.0.items.0.scale", "1", "$.questionnaires[0].items[0].scale: 1");
    row("questionnaires.0.items.0.lowest", "1", "$.questionnaires[0].items[0].lowest: unknown key");
    row("questionnaires.0.items.1.highest", "0",
        "$.questionnaires[0].items[1].highest: 0: expected more than lowest");
    row("questionnaires.0.items.2.choices", "[{\"en\":\"x\"}]", "$.questionnaires[0].items[2].choices: 1");
    row("questionnaires.0.items.2.choices.1", "{\"de\":\"x\"}",
        "$.questionnaires[0].items[2].choices[1].text.en: missing");
    row("participants_planned", "0", "$.participants_planned: 0");
    row("blind_experimenter", "\"yes\"", "$.blind_experimenter: another type");
    row("seed", "-1", "$.seed: -1");
    row("seed", "1.5", "$.seed: 1.5");
    row("seed", "1e17", "$.seed: 1e+17");
}

void TestStudyFaults::wrongDesignsAreRefused() {
    QFETCH(QString, path);
    QFETCH(QString, json);
    QFETCH(QString, place);
    const QJsonValue value = json.isEmpty()
                                 ? QJsonValue(QJsonValue::Undefined)
                                 : QJsonDocument::fromJson("[" + json.toUtf8() + "]").array().at(0);
    const QByteArray wrong =
        QJsonDocument(changed(parsed(someStudy()), path.split('.'), value).toObject()).toJson();
    const auto study = readStudy(wrong, "wrong.json");
    QVERIFY(!study.has_value());
    QCOMPARE(study.error().code, core::ErrorCode::badInput);
    const QString message = QString::fromStdString(study.error().message);
    QVERIFY2(message.contains(place), qPrintable(message));
    QVERIFY2(message.startsWith("wrong.json:") && message.contains("expected "), qPrintable(message));
}

void TestStudyFaults::everythingWrongIsToldTogether() {
    QJsonObject json = parsed(someStudy());
    json["seed"] = -1;
    json["order"] = "none";
    json["colour"] = 1;
    const auto study = readStudy(QJsonDocument(json).toJson(), "wrong.json");
    QCOMPARE(QString::fromStdString(study.error().message).count("\n") + 1, 3);
    QVERIFY(!readStudy("", "empty") && !readStudy("[]", "array") &&
            !readStudy("{\"id\":\"a\",\"id\":\"b\"}", "twice"));
}

void TestStudyFaults::brokenFoldersAreTold() {
    QTemporaryDir folder;
    QDir(folder.path()).mkdir("studies");
    const auto write = [&](const QString& name, const QByteArray& bytes) {
        QFile file(folder.path() + "/studies/" + name);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(bytes);
    };
    QCOMPARE(StudyCatalogue::load(folder.path().toStdString())->studies().size(), std::size_t{0});
    write("s.json", someStudy());
    QCOMPARE(StudyCatalogue::load(folder.path().toStdString())->studies().size(), std::size_t{1});
    write("other.json", someStudy()); // the id is not its file's name
    write("broken.json", "{");
    const auto loaded = StudyCatalogue::load(folder.path().toStdString());
    QVERIFY(!loaded && loaded.error().message.find("other.json") != std::string::npos &&
            loaded.error().message.find("broken.json") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestStudyFaults)
#include "test_study_faults.moc"
