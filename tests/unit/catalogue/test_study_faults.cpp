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
    void limitsAreMetJustThere_data();
    void limitsAreMetJustThere();
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

void TestStudyFaults::limitsAreMetJustThere_data() {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QJsonValue>("taken"); ///< the last value that may stand there
    QTest::addColumn<QJsonValue>("refused");
    int number = 0;
    const auto row = [&number](const char* path, const QJsonValue& taken, const QJsonValue& refused) {
        QTest::addRow("%d %s", ++number, path) << path << taken << refused;
    };
    const auto letters = [](int count) { return QString(count, QLatin1Char('x')); };
    const auto numbered = [](QJsonObject like, int count) {
        QJsonArray array;
        for (int i = 0; i < count; ++i) {
            like["id"] = QStringLiteral("i%1").arg(i);
            array.append(like);
        }
        return array;
    };
    const auto ascending = [](int count) { // from 0.01 to 0.1
        QJsonArray array;
        for (int i = 0; i < count; ++i)
            array.append(0.01 + 0.09 * i / (count - 1));
        return array;
    };
    const QJsonObject study = parsed(someStudy());
    const QJsonObject condition = study["conditions"].toArray().at(0).toObject();
    const QJsonObject item = study["questionnaires"].toArray().at(0)["items"].toArray().at(3).toObject();
    QJsonArray procedures, choices;
    for (int i = 0; i < 9; ++i)
        procedures.append(condition["procedures"].toArray().at(0));
    for (int i = 0; i < 51; ++i)
        choices.append(QJsonObject{{"en", "x"}});
    const auto without = [](QJsonArray array) {
        array.removeLast();
        return array;
    };
    row("id", letters(64), letters(65));
    row("pilot_of", letters(64), letters(65));
    row("title.en", letters(1), letters(0));
    row("title.en", letters(20000), letters(20001));
    row("source", letters(2000), letters(2001));
    row("ethics", letters(2000), letters(2001));
    row("conditions", numbered(condition, 50), numbered(condition, 51));
    row("conditions.0.criterion", 0.01, 0.009);
    row("conditions.0.criterion", 0.99, 0.991);
    row("conditions.0.procedures", without(procedures), procedures);
    row("conditions.0.stimulus.differences", ascending(4096), ascending(4097));
    row("conditions.1.stimulus.differences.1", 2, 2.001);
    row("conditions.1.stimulus.fixed", QJsonObject{{"friction", 1e9}}, QJsonObject{{"friction", 1.1e9}});
    for (const char* limit : {"explore_limit_s", "answer_limit_s", "break_at_least_s"}) {
        row(qPrintable(QStringLiteral("trial.") + QLatin1String(limit)), 3600, 3600.5);
        row(qPrintable(QStringLiteral("trial.") + QLatin1String(limit)), 0, -0.5);
    }
    row("trial.between_trials_s", 60, 60.5);
    row("trial.between_trials_s", 0, -0.5);
    row("trial.practice_trials", 200, 201);
    row("trial.practice_trials", 0, -1);
    row("trial.break_every", 10000, 10001);
    row("trial.break_every", 0, -1);
    row("trial.probe_at_least_N", 0, -0.1);
    row("fidelity.force_error_rms_N", 0.001, 0.0009);
    row("fidelity.force_error_rms_N", 100, 100.5);
    row("fidelity.stiffness_error", 0.001, 0.0009);
    row("fidelity.stiffness_error", 10, 10.5);
    row("fidelity.late_ticks", 0, -0.01);
    row("fidelity.late_ticks", 1, 1.01);
    row("fidelity.saturated", 0, -0.01);
    row("fidelity.saturated", 1, 1.01);
    row("fidelity.peak_force_N", 0.01, 0.009);
    row("fidelity.peak_force_N", 100, 100.5);
    row("fidelity.mean_speed_m_per_s", 0.001, 0.0009);
    row("fidelity.mean_speed_m_per_s", 10, 10.5);
    row("fidelity.repeats_at_most", 1, 0);
    row("fidelity.repeats_at_most", 100, 101);
    row("questionnaires.0.items", numbered(item, 200), numbered(item, 201));
    row("questionnaires.0.items.0.scale", 2, 1);
    row("questionnaires.0.items.0.scale", 21, 22);
    row("questionnaires.0.items.1.lowest", -1e9, -1.1e9);
    row("questionnaires.0.items.1.highest", 1e9, 1.1e9);
    row("questionnaires.0.items.1.highest", 0.001, 0);
    row("questionnaires.0.items.2.choices", QJsonArray{choices[0], choices[1]}, QJsonArray{choices[0]});
    row("questionnaires.0.items.2.choices", without(choices), choices);
    row("participants_planned", 1, 0);
    row("participants_planned", 100000, 100001);
    row("seed", 0, -1);
    row("seed", 9007199254740991.0, 9007199254740992.0); // what JSON holds exactly
}

void TestStudyFaults::limitsAreMetJustThere() {
    QFETCH(QString, path);
    QFETCH(QJsonValue, taken);
    QFETCH(QJsonValue, refused);
    const auto with = [&](const QJsonValue& value) {
        return readStudy(
            QJsonDocument(changed(parsed(someStudy()), path.split(QLatin1Char('.')), value).toObject())
                .toJson(QJsonDocument::Compact),
            "limit");
    };
    const auto good = with(taken);
    QVERIFY2(good, good ? "" : good.error().message.c_str());
    const auto bad = with(refused);
    QVERIFY(!bad);
    const QStringList steps = path.split(QLatin1Char('.'));
    const bool place = steps.back().front().isDigit(); // then the array says it
    QVERIFY2(QString::fromStdString(bad.error().message).contains(steps.at(steps.size() - (place ? 2 : 1))),
             bad.error().message.c_str());
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
