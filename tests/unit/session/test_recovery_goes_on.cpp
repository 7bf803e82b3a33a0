// SPDX-License-Identifier: GPL-3.0-or-later
// One damaged session or ring must not shut a site: the others are recovered, and what could not be is told.
#include "database/repositories/session_reader.h"
#include "database/repositories/session_repository.h"
#include "recording/ring_layout.h"
#include "session/channels.h"
#include "session/live_recording.h"
#include "session/recovery.h"
#include "support/session_fixture.h"

#include <QFile>
#include <QtTest>

using namespace chiron;
using database::SessionState;

namespace {

/// A session that its program left open, with no frame stored.
database::SessionId openSession(tests::SessionFixture& site,
                                const std::function<void(database::NewSession&)>& change) {
    session::SessionSetup setup;
    setup.level = tests::shortLevel(2, 1, 5.0);
    auto station = session::scriptedStation(**session::exerciseKind("sphere_apex"), setup.level, "expert", 1);
    setup.devices = {station->tools.front().device->descriptor()};
    setup.mappings = station->mappings();
    setup.safety = session::headlessSafety(setup.level);
    database::NewSession columns = session::toNewSession(setup);
    columns.channelTable = session::channelTableFor(setup)->encode();
    change(columns);
    const auto id = site.database->write([&](database::WriteContext& context) {
        return database::SessionRepository(context.connection(), database::Actor::simulated())
            .beginSession(columns);
    });
    if (!id)
        qFatal("%s", id.error().message.c_str());
    return *id;
}

SessionState stateOf(tests::SessionFixture& site, database::SessionId id) {
    auto connection = site.database->openReader();
    return database::SessionReader(**connection, database::Actor::maintenance()).session(id)->summary.state;
}

} // namespace

class TestRecoveryGoesOn : public QObject {
    Q_OBJECT
private slots:
    void oneBadSessionDoesNotStopTheOthers();
};

void TestRecoveryGoesOn::oneBadSessionDoesNotStopTheOthers() {
    tests::SessionFixture site;
    QTemporaryDir rings;
    const auto same = [](database::NewSession&) {};
    const auto badRing = openSession(site, same);
    const auto badColumn =
        openSession(site, [](database::NewSession& s) { s.deviceJson = "{\"tools\":[]}"; });
    const auto sound = openSession(site, same);
    const auto id = session::ringIdOf(*site.database);
    QVERIFY(id);
    QFile ring(rings.filePath(QString::fromStdString(recording::ringFilePrefix(*id) +
                                                     std::to_string(badRing) + recording::kRingSuffix)));
    QVERIFY(ring.open(QIODevice::WriteOnly) && ring.write("no ring") == 7);
    ring.close();

    const auto recovered = session::recoverSessions(*site.database, rings.path().toStdString());
    QVERIFY2(recovered, recovered ? "" : recovered.error().message.c_str());
    QCOMPARE(recovered->size(), std::size_t{3});
    QCOMPARE((*recovered)[0].session, badRing);
    QVERIFY(QString::fromStdString((*recovered)[0].problem).contains(ring.fileName()));
    QCOMPARE(stateOf(site, badRing), SessionState::interrupted); // what was committed is kept ...
    QVERIFY(ring.exists());                                      // ... and so is what could not be read
    QCOMPARE((*recovered)[1].session, badColumn);
    QVERIFY(QString::fromStdString((*recovered)[1].problem).contains("device"));
    QCOMPARE(stateOf(site, badColumn), SessionState::running); // tried again at the next start
    QCOMPARE((*recovered)[2].session, sound);
    QCOMPARE((*recovered)[2].problem, std::string());
    QCOMPARE(stateOf(site, sound), SessionState::interrupted);
}

QTEST_GUILESS_MAIN(TestRecoveryGoesOn)
#include "test_recovery_goes_on.moc"
