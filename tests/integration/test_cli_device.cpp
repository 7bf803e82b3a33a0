// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"
#include "mechanisms/fingertip_verification.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <cmath>

using namespace chiron;

/// `device check` and `device list` from outside: the contract's keys, P3's figures, exit codes.
class TestCliDevice : public QObject {
    Q_OBJECT
private slots:
    void theFingertipPlatformHolds();
    void theArmHolds();
    void aFastSineDoesNotHold();
    void seriesAndDegradationWhereAskedFor();
    void theGimbalsFriction();
    void theGimbalsDelay();
    void whatIsWrongIsRefused();

private:
    static QJsonObject object(const CliRun& run) { return QJsonDocument::fromJson(run.out).object(); }
};

void TestCliDevice::theFingertipPlatformHolds() {
    const CliRun run = runCli({"device", "check", "--seed", "2", "--json"});
    QCOMPARE(run.exitCode, 0);
    const QJsonObject json = object(run);
    QVERIFY(json["holds"].toBool());
    QVERIFY(json["rmse_N"].toDouble() > 0.0 && json["rmse_N"].toDouble() < 0.0707);
    QVERIFY(json["angle_error_deg"].toDouble() > 0.0 && json["angle_error_deg"].toDouble() < 1.95);
    QVERIFY(json["latency_us"].toDouble() > 0.0 && json["latency_us"].toDouble() < 50000.0);
    QVERIFY(json["simulated"].toBool());
    QVERIFY(json.contains("serial_number") && json["serial_number"].isNull());
    QCOMPARE(json["fingers"].toArray().size(), 8);
    for (const QJsonValue& on : json["fingers"].toArray())
        QVERIFY(on["holds"].toBool() && on["most_N"].toDouble() <= 4.0 &&
                on["rmse_true_N"].toDouble() < 0.0707);
    QCOMPARE(json["rmse_cycles_N"].toArray().size(), 3);
    QVERIFY(!json.contains("series") && !json.contains("degradation"));
    const double delay_s = 1e-6 * json["latency_us"].toDouble();
    // The station's number: with the damping of three drives and pad; another with --damping.
    const double damping = 3.0 * json["friction"]["viscous_Ns_per_m"].toDouble() +
                           mechanisms::FingertipPlatformParameters{}.pad.damping_Ns_per_m;
    QVERIFY(std::abs(json["damping_Ns_per_m"].toDouble() - damping) < 1e-9);
    QVERIFY(std::abs(json["stiffness_cap_N_per_m"].toDouble() - damping / (0.0005 + delay_s)) < 1e-6);
    const QStringList few{"device",    "check", "--seed", "18446744073709551615", "--poses", "3",
                          "--damping", "2",     "--json"};
    const CliRun once = runCli(few);
    QCOMPARE(runCli(few).out, once.out); // the same seed, the same figures
    const QJsonObject chosen = object(once);
    QCOMPARE(chosen["seed"].toString(), QString("18446744073709551615"));
    QVERIFY(std::abs(chosen["stiffness_cap_N_per_m"].toDouble() -
                     2.0 / (0.0005 + 1e-6 * chosen["latency_us"].toDouble())) < 1e-6);
    QVERIFY(std::abs(json["friction"]["coulomb_N"].toDouble() - 0.25) < 0.03);
    const CliRun words = runCli({"device", "check", "--seed", "2", "--poses", "3"});
    for (const char* word : {"0.0707", "1.95", "force RMSE, cycle 3", "relaxing", "in simulation",
                             "Within its bounds", "not reported by the device"})
        QVERIFY2(words.out.contains(word), word);
}

void TestCliDevice::theArmHolds() {
    const QStringList few{"device", "check", "--poses", "3", "--seed", "4"};
    const QJsonObject arm = object(runCli(few + QStringList{"--json"}))["arm"].toObject();
    QVERIFY(arm["holds"].toBool());
    QCOMPARE(arm["freedoms"].toInt(), arm["published"]["freedoms"].toInt()); // P3: 7 sensed
    QCOMPARE(arm["reached"].toInt(), arm["poses"].toInt());
    QVERIFY(arm["poses"].toInt() > 4000);
    for (const char* key : {"condition", "inverse_error_m", "inverse_error_rad", "jacobian_error",
                            "gravity_error_Nm", "weight_N", "sinks_m", "friction_error", "place_error_m"})
        QVERIFY2(arm[QLatin1String(key)].toDouble() > 0.0 &&
                     arm[QLatin1String(key)].toDouble() <= arm["bounds"][QLatin1String(key)].toDouble(),
                 key);
    QCOMPARE(arm["friction"].toArray().size(), 9);
    const CliRun words = runCli(few);
    QCOMPARE(words.exitCode, 0);
    for (const char* word :
         {"poses of the box within reach", "not printed", "7: 3 + 3 + 1", "The arm is within its bounds"})
        QVERIFY2(words.out.contains(word), word);
}

void TestCliDevice::aFastSineDoesNotHold() {
    const CliRun run = runCli({"device", "check", "--frequency", "5", "--poses", "3", "--json"});
    QCOMPARE(run.exitCode, 1);
    QVERIFY(!object(run)["holds"].toBool());
}

void TestCliDevice::seriesAndDegradationWhereAskedFor() {
    const QJsonObject json = object(
        runCli({"device", "check", "--poses", "3", "--frequency", "1", "--degrade", "--series", "--json"}));
    QCOMPARE(json["degradation"].toArray().size(), 24);
    QCOMPARE(json["degradation"][1]["rmse_N"].toDouble(),
             json["rmse_N"].toDouble()); // times 1 is the plant itself
    QCOMPARE(json["series"]["time_s"].toArray().size(), 3000);
    QCOMPARE(json["series"]["measured_N"].toArray().size(), 3000);
    QCOMPARE(json["series"]["poses_deg"].toArray().size(), 3);
}

void TestCliDevice::theGimbalsFriction() {
    const CliRun run = runCli({"device", "check", "--mechanism", "gimbal_hprd", "--json"});
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(object(run)["friction"].toArray().size(), 3);
    QVERIFY(object(run).contains("serial_number") && object(run)["serial_number"].isNull());
    // What is felt of it: all of it where it breaks away, little in motion, and never less than nothing.
    const QJsonObject felt = object(run)["friction_felt"].toObject();
    QCOMPARE(felt["rows"].toArray().size(), 12);
    for (const QJsonValue& row : felt["rows"].toArray()) {
        const double before = row["before_N"].toDouble(), after = row["after_N"].toDouble(),
                     speed = row["speed_m_per_s"].toDouble();
        QVERIFY(after > 0.0 && after <= before + 1e-3);
        QVERIFY(speed > 0.002 || before - after < 1e-3);
        QVERIFY(speed < 0.045 || after < before - 0.06);
    }
    QVERIFY(felt["work_after_J"].toDouble() > 0.0 &&
            felt["work_after_J"].toDouble() < 0.8 * felt["work_before_J"].toDouble());
    QVERIFY(felt["held_after_N"].toDouble() < 0.001);
}

/// Measured as on any device, and what follows for a wall (devices.md §6).
void TestCliDevice::theGimbalsDelay() {
    const QJsonObject quick = object(runCli({"device", "check", "--mechanism", "gimbal_hprd", "--json"}));
    const QJsonObject late =
        object(runCli({"device", "check", "--mechanism", "gimbal_hprd", "--sample-delay", "2", "--json"}));
    QVERIFY(quick["holds"].toBool() && late["holds"].toBool());
    QVERIFY(std::abs(late["latency_us"].toDouble() - quick["latency_us"].toDouble() - 2000.0) < 100.0);
    QVERIFY(late["latency_error_us"].toDouble() > 0.0);
    QCOMPARE(late["latency_given_us"].toDouble(), 2300.0);
    QVERIFY(std::abs(late["stiffness_cap_N_per_m"].toDouble() -
                     2.0 / (0.0005 + 1e-6 * late["latency_us"].toDouble())) < 1e-6);
}

void TestCliDevice::whatIsWrongIsRefused() {
    QCOMPARE(refusalFault(runCli({"device", "check", "--mechanism", "crane"}), 2,
                          {"mechanism", "crane", "fingertip_arm"}),
             QString());
    QCOMPARE(refusalFault(runCli({"device", "check", "--poses", "0"}), 2, {"poses"}), QString());
    QCOMPARE(refusalFault(runCli({"device", "check", "--driver", "crane"}), 2, {"crane"}), QString());
    QCOMPARE(refusalFault(runCli({"device", "check", "--driver", "keyboard_mouse"}), 5,
                          {"keyboard_mouse", "no motors"}),
             QString());
    QCOMPARE(
        refusalFault(runCli({"device", "check", "--mechanism", "gimbal_hprd", "--degrade"}), 2, {"degrade"}),
        QString());
    QCOMPARE(refusalFault(runCli({"device", "check", "--mechanism", "gimbal_hprd", "--sample-delay", "4"}), 2,
                          {"sample-delay", "0", "3"}),
             QString());
    QCOMPARE(refusalFault(runCli({"device", "check", "--sample-delay", "1"}), 2,
                          {"sample-delay", "fingertip_arm"}),
             QString());
    QVERIFY(runCli({"device", "check", "--help"})
                .out.contains("chiron-cli device check --seed 1 --degrade --json"));
}

QTEST_GUILESS_MAIN(TestCliDevice)
#include "test_cli_device.moc"
