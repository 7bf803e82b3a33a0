// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/hidraw_node.h"
#include "cli_process.h"
#include "support/hid_computer.h"
#include "support/patience.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>

using namespace chiron;

// A session on a connected device from outside: chiron-cli train --device against chiron-station, stepped by
// the session, so that it takes as long as the machine needs.
class TestCliStation : public QObject {
    Q_OBJECT
private slots:
    void aSessionIsTrainedAndReplayed_data();
    void aSessionIsTrainedAndReplayed();
    void whatDoesNotFitIsRefused();
    void whatIsPluggedInIsListed();

private:
    CliRun cli(const QStringList& arguments) {
        return runCli(arguments + QStringList{"--database", m_folder.filePath("site.db"), "--json"});
    }
    QTemporaryDir m_folder;
};

namespace {

/// Whether USB HID devices can be plugged in here that are not there.
bool g_hid = false;

/// Starts chiron-station; returns its address, or nothing.
QString started(QProcess& station, const QStringList& more, const QStringList& line = {"--tcp", "0"}) {
    station.setProgram(QStringLiteral(CHIRON_STATION));
    station.setArguments(QStringList{"--mechanism", "gimbal_hprd", "--serial", "T-1"} + line + more);
    station.start();
    station.setReadChannel(QProcess::StandardError);
    while (!station.canReadLine())
        if (!station.waitForReadyRead(tests::kPatience_ms))
            return {};
    return QString::fromUtf8(station.readLine()).trimmed().section(QStringLiteral(" at "), -1);
}

QJsonObject object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

} // namespace

void TestCliStation::aSessionIsTrainedAndReplayed_data() {
    QTest::addColumn<bool>("usb");
    QTest::newRow("tcp") << false;
    QTest::newRow("hid") << true;
}

void TestCliStation::aSessionIsTrainedAndReplayed() {
    QFETCH(bool, usb);
    if (usb && !g_hid)
        QSKIP("takes root and /dev/fuse");
    if (usb)
        tests::HidComputer::plugIn(0, "T-1");
    const auto pulledOut = qScopeGuard([usb] {
        if (usb)
            tests::HidComputer::pullOut(0);
    });
    QProcess station;
    // It goes away after six seconds of its own: the session goes on without it to its end.
    const QString address =
        started(station, {"--lockstep", "--hand", "press", "--ticks", "6000"},
                usb ? QStringList{"--fuse", tests::HidComputer::kFolder} : QStringList{"--tcp", "0"});
    QVERIFY(!address.isEmpty());
    const QJsonObject trained =
        object(cli({"train", "sphere_apex", "--device", "station", "--address", address}));
    const QString id = QString::number(trained["session_id"].toInteger());
    QVERIFY(id != QLatin1String("0"));
    QVERIFY(trained["recording"].toObject()["frames"].toInteger() > 6000);
    QCOMPARE(trained["recording"].toObject()["dropped"].toInteger(), 0);
    QVERIFY(station.state() == QProcess::NotRunning || station.waitForFinished(tests::kPatience_ms));
    station.setReadChannel(QProcess::StandardOutput);
    const QJsonObject told = QJsonDocument::fromJson(station.readAll()).object();
    QCOMPARE(told["bad_crc"].toInteger() + told["bad_frames"].toInteger() + told["lost_outputs"].toInteger(),
             0);
    QCOMPARE(told["ticks"].toInteger(), 6000);

    const QJsonObject shown = object(cli({"session", "show", id}));
    const QJsonObject device = shown["devices"].toArray().at(0).toObject();
    QCOMPARE(device["driver"].toString(), QStringLiteral("station"));
    QCOMPARE(device["serial_number"].toString(), QStringLiteral("T-1"));
    QCOMPARE(shown["device_class"].toString(), QStringLiteral("felt"));
    const QJsonObject replayed = object(cli({"replay", id}));
    QVERIFY(replayed["identical"].toBool());
}

void TestCliStation::whatDoesNotFitIsRefused() {
    QCOMPARE(refusalFault(cli({"train", "sphere_apex"}), 2, {"--operator", "--device"}), QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--operator", "expert", "--device", "station"}), 2,
                          {"--operator", "--device"}),
             QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--operator", "expert", "--address", "tcp:a:1"}), 2,
                          {"--address"}),
             QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "crane"}), 2, {"crane"}), QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "keyboard_mouse"}), 2, {"window"}),
             QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "replay"}), 2, {"operator"}), QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "station", "--mechanism", "gimbal_hprd"}),
                          2, {"--mechanism"}),
             QString());
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "station", "--address", "tcp:1"}), 3,
                          {"tcp:HOST:PORT"}),
             QString());
    QProcess station; // nobody listens any more where one was
    const QString address = started(station, {"--lockstep"});
    station.terminate();
    QVERIFY(station.waitForFinished(tests::kPatience_ms));
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "station", "--address", address}), 5,
                          {"switched on"}),
             QString());
    const QString second = started(station, {"--lockstep"});
    QCOMPARE(refusalFault(cli({"train", "sphere_apex", "--device", "station", "--address",
                               second + QLatin1Char(',') + second}),
                          3, {"addresses: 2", "tools: 1"}),
             QString());
    QCOMPARE(refusalFault(cli({"train", "object_handling", "--device", "station", "--address", second}), 2,
                          {"jaw"}),
             QString());
    station.terminate();
    QVERIFY(station.waitForFinished(tests::kPatience_ms));
}

void TestCliStation::whatIsPluggedInIsListed() {
    if (!g_hid)
        QSKIP("takes root and /dev/fuse");
    const auto connected = [] {
        for (const QJsonValue& driver :
             QJsonDocument::fromJson(runCli({"device", "list", "--json"}).out).array())
            if (driver["id"] == QLatin1String("station"))
                return driver["connected"].toArray();
        return QJsonArray{QStringLiteral("no such driver")};
    };
    QCOMPARE(connected(), QJsonArray());
    tests::HidComputer::plugIn(1, "R-2");
    tests::HidComputer::plugIn(2, "L-1");
    QCOMPARE(connected(), (QJsonArray{QJsonObject{{"model", "Emulated station"},
                                                  {"serial_number", "L-1"},
                                                  {"address", "hid:1209:0001:L-1"}},
                                      QJsonObject{{"model", "Emulated station"},
                                                  {"serial_number", "R-2"},
                                                  {"address", "hid:1209:0001:R-2"}}}));
    const QByteArray table = runCli({"device", "list"}).out;
    QVERIFY2(table.contains("R-2") && table.contains("hid:1209:0001:L-1"), table.constData());
    tests::HidComputer::pullOut(2);
    QCOMPARE(connected().size(), 1);
    tests::HidComputer::pullOut(1);
    QCOMPARE(connected(), QJsonArray());
}

int main(int argc, char** argv) {
    using tests::HidComputer;
    g_hid = HidComputer::enter() && station::HidrawNode::serve(HidComputer::kFolder).has_value();
    const QCoreApplication application(argc, argv);
    TestCliStation test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_cli_station.moc"
