// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "support/content_copy.h"

#include <QtTest>

using namespace chiron::catalogue;

namespace {

const QString kPreset = QStringLiteral("exercises/urethra_insertion/presets/stricture.json");

} // namespace

/// Presets are refused in their own file, whether a level uses them or not.
class TestPresets : public QObject {
    Q_OBJECT
private slots:
    void presetFaults_data();
    void presetFaults();
    void presetsThatNoLevelUsesAreCheckedToo();
};

void TestPresets::presetFaults_data() {
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QByteArray>("message");
    const auto row = [](const char* tag, const char* from, const char* to, const char* message) {
        QTest::newRow(tag) << QByteArray(from) << QByteArray(to) << QByteArray(message);
    };
    row("negative stiffness", "\"stiffness_factor\": 15", "\"stiffness_factor\": -15",
        "$.parameters.local_changes[0].stiffness_factor: -15: expected a number");
    row("unknown key", "\"friction\"", "\"fricton\"", "$.parameters.fricton: unknown key");
    row("no source", "\"source\"", "\"sauce\"", "$.source: missing");
    row("another's name", "\"id\": \"stricture\"", "\"id\": \"narrow\"", "$.id: \"narrow\"");
    row("a preset of a preset", "\"friction\": 0.1", "\"tissue\": \"normal\"",
        "$.parameters.tissue: given: expected none");
}

void TestPresets::presetFaults() {
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QByteArray, message);
    ContentCopy copy;
    QByteArray text = copy.read(kPreset);
    QVERIFY(text.contains(from));
    copy.write(kPreset, text.replace(from, to));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(!catalogue.has_value());
    const QByteArray told = QByteArray::fromStdString(catalogue.error().message);
    QVERIFY2(told.startsWith(copy.path(kPreset).toUtf8() + ':'), told.constData());
    QVERIFY2(told.contains(message), told.constData());
}

void TestPresets::presetsThatNoLevelUsesAreCheckedToo() {
    ContentCopy copy;
    const QString unused = QStringLiteral("exercises/urethra_insertion/presets/tight.json");
    QByteArray text = copy.read(unused);
    copy.write(unused, text.replace("\"friction\": 0.13", "\"friction\": 13"));
    const auto catalogue = Catalogue::load(copy.directory());
    QVERIFY(!catalogue && catalogue.error().message.find("tight.json:") != std::string::npos);
}

QTEST_APPLESS_MAIN(TestPresets)
#include "test_presets.moc"
