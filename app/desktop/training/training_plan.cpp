// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/training_plan.h"

#include "recording/crash_ring.h"
#include "scoring/trace_csv.h"

#include <QRandomGenerator>
#include <algorithm>

namespace chiron::desktop {

namespace {

const std::string kExpert = "expert"; // the operator of demonstrations
constexpr int kTried = 3; // number of trials: enough to improve by the third, short enough for a first try

core::Result<session::Station> stationOf(const TrainingPlan& plan, const catalogue::ExerciseLevel& level,
                                         std::uint64_t seed) {
    auto kind = session::exerciseKind(level.exercise);
    CHIRON_TRY(kind);
    switch (plan.driver->movedBy) {
    case devices::MovedBy::person: {
        std::vector<std::string> addresses;
        for (const QString& address : plan.addresses)
            addresses.push_back(address.toStdString());
        return session::personStation(*plan.driver, plan.workspace, **kind, level, addresses);
    }
    case devices::MovedBy::scriptedOperator: {
        const std::string forceMap = plan.forceMap.toStdString();
        session::ScriptedDevice held{.driver = plan.driver, .forceMap = forceMap};
        if ((*kind)->operatorsKnowTheirPlace())
            held.mounting.turn_rad = plan.workspace.turn_rad;
        return session::scriptedStation(**kind, level, plan.operatorName.toStdString(), seed, held);
    }
    case devices::MovedBy::recording:
        break;
    }
    auto rows = scoring::readTraceCsvFile(plan.traceFile.toStdString());
    CHIRON_TRY(rows);
    return session::traceStation(*rows, (*kind)->pointerTool(), (*kind)->toolCount(level), *plan.driver);
}

/// The driver with this name in a plan; an unknown name gives the default driver.
const devices::Driver* driverOf(const QString& word) {
    const devices::Driver* driver = devices::findDriverOfPlan(word.toStdString());
    return driver ? driver : TrainingPlan().driver;
}

} // namespace

QVariantMap TrainingPlan::toMap() const {
    QVariantMap map{{QStringLiteral("exercise"), exercise},
                    {QStringLiteral("level"), level},
                    {QStringLiteral("device"),
                     QString::fromUtf8(driver->planWord.data(), qsizetype(driver->planWord.size()))},
                    {QStringLiteral("operator"), operatorName},
                    {QStringLiteral("seed"), qulonglong{seed}},
                    {QStringLiteral("force_map"), forceMap},
                    {QStringLiteral("trace"), traceFile},
                    {QStringLiteral("addresses"), addresses},
                    {QStringLiteral("scale"), workspace.scale},
                    {QStringLiteral("origin_x_m"), workspace.origin_m[0]},
                    {QStringLiteral("origin_y_m"), workspace.origin_m[1]},
                    {QStringLiteral("origin_z_m"), workspace.origin_m[2]},
                    {QStringLiteral("left_handed"), workspace.leftHanded},
                    {QStringLiteral("base_turn_rad"), workspace.turn_rad[0]},
                    {QStringLiteral("base_tilt_rad"), workspace.turn_rad[1]},
                    {QStringLiteral("base_roll_rad"), workspace.turn_rad[2]},
                    {QStringLiteral("familiarisation"), familiarisation},
                    {QStringLiteral("practice_s"), practice_s},
                    {QStringLiteral("trials"), trials}};
    if (depthOfField)
        map.insert(QStringLiteral("depth_of_field"), *depthOfField);
    return map;
}

TrainingPlan TrainingPlan::fromMap(const QVariantMap& map) {
    TrainingPlan plan;
    plan.exercise = map.value(QStringLiteral("exercise")).toString();
    plan.level = map.value(QStringLiteral("level"), 1).toInt();
    plan.driver = driverOf(map.value(QStringLiteral("device")).toString());
    plan.operatorName = map.value(QStringLiteral("operator")).toString();
    plan.seed = map.value(QStringLiteral("seed")).toULongLong();
    plan.forceMap = map.value(QStringLiteral("force_map")).toString();
    plan.traceFile = map.value(QStringLiteral("trace")).toString();
    plan.addresses = map.value(QStringLiteral("addresses")).toStringList();
    plan.workspace.scale = map.value(QStringLiteral("scale"), 1.0).toDouble();
    plan.workspace.origin_m = {map.value(QStringLiteral("origin_x_m")).toDouble(),
                               map.value(QStringLiteral("origin_y_m")).toDouble(),
                               map.value(QStringLiteral("origin_z_m")).toDouble()};
    plan.workspace.leftHanded = map.value(QStringLiteral("left_handed")).toBool();
    plan.workspace.turn_rad = {map.value(QStringLiteral("base_turn_rad")).toDouble(),
                               map.value(QStringLiteral("base_tilt_rad")).toDouble(),
                               map.value(QStringLiteral("base_roll_rad")).toDouble()};
    plan.familiarisation = map.value(QStringLiteral("familiarisation")).toBool();
    plan.practice_s = map.value(QStringLiteral("practice_s")).toDouble();
    plan.trials = map.value(QStringLiteral("trials")).toInt();
    if (map.contains(QStringLiteral("depth_of_field")))
        plan.depthOfField = map.value(QStringLiteral("depth_of_field")).toBool();
    return plan;
}

TrainingPlan tryPlan(const std::string& exercise, int level) {
    TrainingPlan plan;
    plan.exercise = QString::fromStdString(exercise);
    plan.level = level;
    plan.familiarisation = true;
    plan.trials = kTried;
    return plan;
}

std::optional<TrainingPlan> expertPlan(const std::string& exercise, int level) {
    const auto kind = session::exerciseKind(exercise);
    if (!kind)
        return std::nullopt;
    const std::vector<std::string> names = (*kind)->operatorNames();
    if (std::find(names.begin(), names.end(), kExpert) == names.end())
        return std::nullopt;
    TrainingPlan plan;
    plan.exercise = QString::fromStdString(exercise);
    plan.level = level;
    plan.driver = &devices::usualDriver(devices::MovedBy::scriptedOperator);
    plan.operatorName = QString::fromStdString(kExpert);
    plan.seed = (*kind)->demonstrationSeed();
    return plan;
}

QString readyKey(const TrainingPlan& plan) {
    return QStringLiteral("ready_%1_%2").arg(plan.exercise).arg(plan.level);
}

core::Result<session::TrainingRequest> requestOf(const TrainingPlan& plan,
                                                 const catalogue::ExerciseLevel& level) {
    session::TrainingRequest request;
    request.level = level;
    request.seed = plan.seed != 0
                       ? plan.seed
                       : QRandomGenerator::global()->generate64() >> 1; // also fits a signed number
    request.familiarisation = (plan.familiarisation && plan.ownHand()) || plan.practises();
    request.ringFolder = recording::defaultRingFolder();
    auto station = stationOf(plan, level, request.seed);
    CHIRON_TRY(station);
    request.station = std::move(*station);
    return request;
}

database::Actor actorOf(const TrainingPlan& plan, const database::Actor& person) {
    return plan.movedBy(devices::MovedBy::scriptedOperator) ? database::Actor::simulated() : person;
}

} // namespace chiron::desktop
