// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/session_setup.h"
#include "support/session_fixture.h"

#include <QtTest>

using namespace chiron;

namespace {

session::SessionSetup usualSetup() {
    session::SessionSetup setup;
    setup.level = tests::shortLevel(3, 2, 5.0);
    setup.seed = 0xfedcba9876543210ULL;
    auto station = session::scriptedStation(**session::exerciseKind("sphere_apex"), setup.level, "expert", 1);
    setup.devices = {station->devices.front()->descriptor()};
    setup.mappings = station->mappings;
    setup.safety = session::headlessSafety(setup.level);
    return setup;
}

} // namespace

class TestSessionSetup : public QObject {
    Q_OBJECT
private slots:
    void comesBackFromItsColumns();
    void columnsFollowTheSetup();
    void badColumns_data();
    void badColumns();
    void toolCounts();
};

void TestSessionSetup::comesBackFromItsColumns() {
    const session::SessionSetup before = usualSetup();
    const database::NewSession columns = session::toNewSession(before);
    const auto after = session::setupFromStored(columns);
    QVERIFY2(after, after ? "" : after.error().message.c_str());
    QCOMPARE(after->seed, before.seed);
    QCOMPARE(after->level.resolvedSha256, before.level.resolvedSha256);
    const database::NewSession again = session::toNewSession(*after);
    QCOMPARE(again.deviceJson, columns.deviceJson);
    QCOMPARE(again.mappingJson, columns.mappingJson);
    QCOMPARE(again.supervisorJson, columns.supervisorJson);
    QCOMPARE(again.contentJson, columns.contentJson);
    QCOMPARE(again.versionsJson, columns.versionsJson);
}

void TestSessionSetup::columnsFollowTheSetup() {
    session::SessionSetup setup = usualSetup();
    const database::NewSession columns = session::toNewSession(setup);
    QCOMPARE(columns.exercise, std::string("sphere_apex"));
    QCOMPARE(columns.level, 3);
    QCOMPARE(columns.plannedTrials, 2);
    QCOMPARE(columns.forceLimit_N, setup.safety.exerciseForce_N);
    QVERIFY(columns.felt);
    for (const auto& metric : setup.level.metrics)
        QVERIFY(columns.versionsJson.find("\"" + metric.id + "\"") != std::string::npos);
    setup.devices.front().rendersForce = false;
    QVERIFY(!session::toNewSession(setup).felt);
}

void TestSessionSetup::badColumns_data() {
    QTest::addColumn<QByteArray>("column");
    QTest::addColumn<QByteArray>("text");
    for (const char* column : {"content", "device", "mapping", "supervisor"}) {
        for (const char* text :
             {"", "{", "[]", "null", "{}", "{\"tools\":7}", "{\"tools\":[{}]}", "\xff\xfe"})
            QTest::addRow("%s %s", column, text) << QByteArray(column) << QByteArray(text);
    }
}

void TestSessionSetup::badColumns() {
    QFETCH(QByteArray, column);
    QFETCH(QByteArray, text);
    database::NewSession stored = session::toNewSession(usualSetup());
    std::string& target = column == "content"   ? stored.contentJson
                          : column == "device"  ? stored.deviceJson
                          : column == "mapping" ? stored.mappingJson
                                                : stored.supervisorJson;
    target = text.toStdString();
    const auto setup = session::setupFromStored(stored);
    QVERIFY(!setup);
    QCOMPARE(setup.error().code, core::ErrorCode::badInput);
    if (column != "content") // the catalogue names its own places
        QVERIFY2(setup.error().message.find(column.toStdString()) != std::string::npos,
                 setup.error().message.c_str());
}

void TestSessionSetup::toolCounts() {
    session::SessionSetup setup = usualSetup();
    setup.devices.push_back(setup.devices.front());
    QVERIFY(!session::setupFromStored(session::toNewSession(setup))); // two devices, one mapping
    setup.mappings.push_back({});
    const auto two = session::setupFromStored(session::toNewSession(setup));
    QVERIFY2(two, two ? "" : two.error().message.c_str());
    QCOMPARE(two->devices.size(), std::size_t{2});
    setup.devices.resize(core::kMaxTools + 1, setup.devices.front());
    setup.mappings.resize(core::kMaxTools + 1);
    QVERIFY(!session::setupFromStored(session::toNewSession(setup)));
}

QTEST_APPLESS_MAIN(TestSessionSetup)
#include "test_session_setup.moc"
