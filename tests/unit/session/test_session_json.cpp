// SPDX-License-Identifier: GPL-3.0-or-later
// What a session stores of device, workspace and supervisor comes back bit for bit, and damage is named.
#include "session/device_json.h"
#include "session/safety_json.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QtTest>
#include <bit>
#include <limits>

using namespace chiron;

namespace {

/// Stands for any member: T{Any, Any, ...} compiles with as many as T has.
struct Any {
    template <class T> operator T() const;
};
template <class T, class... Members> constexpr std::size_t memberCount() {
    if constexpr (requires { T{Members{}..., Any{}}; })
        return memberCount<T, Members..., Any>();
    else
        return sizeof...(Members);
}

/// Through text, as the database keeps it.
QJsonObject stored(const QJsonObject& json) {
    return QJsonDocument::fromJson(QJsonDocument(json).toJson(QJsonDocument::Compact)).object();
}

constexpr double kAwkward[] = {
    0.1 + 0.2, 1.0 / 3.0, -2.2250738585072014e-308, 4.9406564584124654e-324, 1.7976931348623157e308, -0.0};

devices::DeviceDescriptor awkwardDevice() {
    devices::DeviceDescriptor d;
    d.driver = "simulated";
    d.model = "Ω \"model\"";
    d.kinematics = "gimbal_hprd";
    d.kinematicsParameters = {kAwkward[0], kAwkward[1], kAwkward[2], kAwkward[3], kAwkward[4]};
    devices::AxisDescriptor axis;
    for (const char* id : {"heading", "pitch"}) {
        axis.id = id;
        axis.unit =
            axis.unit == devices::AxisUnit::radian ? devices::AxisUnit::metre : devices::AxisUnit::radian;
        axis.resolution = axis.resolution / 3.0;
        axis.minimum = -kAwkward[0];
        axis.maximum = kAwkward[1];
        axis.continuousRating = 0.7;
        axis.coulombFriction = 0.018 / 7.0;
        axis.viscousFriction = 0.0162 / 7.0;
        d.axes.push_back(axis);
    }
    d.jawResolution_rad = 1e-7 / 3.0;
    d.rendersForce = true;
    d.inProcess = true;
    d.period_us = 1234;
    d.maximumForce_N = 4.1;
    d.maximumTorque_Nm = 0.151;
    d.maximumDamping_Ns_per_m = 33.3;
    d.frictionCompensation = 0.8 / 3.0;
    d.serialNumber = "SN-7 Ω";
    d.oldestSample_us = 5678;
    return d;
}

bool same(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// Keys that earlier versions did not write: not there is their old meaning.
const QStringList kLater{QStringLiteral("coulomb_friction"),
                         QStringLiteral("viscous_friction"),
                         QStringLiteral("friction_compensation"),
                         QStringLiteral("serial_number"),
                         QStringLiteral("capKnee"),
                         QStringLiteral("oldest_sample_us")};

/// Every member taken away, and every member of another type: the error names the key.
template <class Read> void checkDamage(const QJsonObject& good, const QString& place, Read read) {
    for (const QString& key : good.keys()) {
        QJsonObject missing = good;
        missing.remove(key);
        QJsonObject wrong = good;
        wrong[key] = good[key].isObject() || good[key].isArray() || good[key].isString()
                         ? QJsonValue(7)
                         : QJsonValue("seven");
        for (const QJsonObject& bad : {missing, wrong}) {
            const auto result = read(bad);
            if (kLater.contains(key) && !bad.contains(key)) {
                QVERIFY2(result, qPrintable(key));
                continue;
            }
            QVERIFY2(!result, qPrintable(key));
            QCOMPARE(result.error().code, core::ErrorCode::badInput);
            const QString words = QString::fromStdString(result.error().message);
            QVERIFY2(words.contains(place + "." + key), qPrintable(words));
        }
    }
}

} // namespace

class TestSessionJson : public QObject {
    Q_OBJECT
private slots:
    void deviceComesBack();
    void deviceDamageIsNamed();
    void deviceNumbersInLists();
    void mappingComesBack();
    void mappingDamageIsNamed();
    void safetyWritesEveryField();
    void safetyComesBack();
    void safetyDamageIsNamed();
    void wholeNumbersStayInRange();
};

void TestSessionJson::deviceComesBack() {
    const devices::DeviceDescriptor before = awkwardDevice();
    const auto after = session::descriptorFromJson(stored(session::toJson(before)));
    QVERIFY2(after, after ? "" : after.error().message.c_str());
    QCOMPARE(after->driver, before.driver);
    QCOMPARE(after->model, before.model);
    QCOMPARE(after->kinematics, before.kinematics);
    QCOMPARE(after->kinematicsParameters.size(), before.kinematicsParameters.size());
    for (std::size_t i = 0; i < before.kinematicsParameters.size(); ++i)
        QVERIFY(same(after->kinematicsParameters[i], before.kinematicsParameters[i]));
    QCOMPARE(after->axes.size(), before.axes.size());
    for (std::size_t i = 0; i < before.axes.size(); ++i) {
        QCOMPARE(after->axes[i].id, before.axes[i].id);
        QVERIFY(after->axes[i].unit == before.axes[i].unit);
        QVERIFY(same(after->axes[i].resolution, before.axes[i].resolution));
        QVERIFY(same(after->axes[i].minimum, before.axes[i].minimum));
        QVERIFY(same(after->axes[i].maximum, before.axes[i].maximum));
        QVERIFY(same(after->axes[i].continuousRating, before.axes[i].continuousRating));
        QVERIFY(same(after->axes[i].coulombFriction, before.axes[i].coulombFriction));
        QVERIFY(same(after->axes[i].viscousFriction, before.axes[i].viscousFriction));
    }
    QVERIFY(same(after->jawResolution_rad, before.jawResolution_rad));
    QCOMPARE(after->rendersForce, before.rendersForce);
    QCOMPARE(after->measuresForce, before.measuresForce);
    QCOMPARE(after->inProcess, before.inProcess);
    QCOMPARE(after->period_us, before.period_us);
    QVERIFY(same(after->maximumForce_N, before.maximumForce_N));
    QVERIFY(same(after->maximumTorque_Nm, before.maximumTorque_Nm));
    QVERIFY(same(after->maximumDamping_Ns_per_m, before.maximumDamping_Ns_per_m));
    QVERIFY(same(after->frictionCompensation, before.frictionCompensation));
    QCOMPARE(after->serialNumber, before.serialNumber);
    QCOMPARE(after->oldestSample_us, before.oldestSample_us);
    devices::DeviceDescriptor untold = before;
    untold.serialNumber.clear();
    untold.oldestSample_us = devices::kUsualOldestSample_us;
    QVERIFY(!session::toJson(untold).contains("serial_number")); // the text of a session as it always was
    QVERIFY(!session::toJson(untold).contains("oldest_sample_us"));
    QCOMPARE(session::descriptorFromJson(session::toJson(untold))->oldestSample_us, 3000u);
    QJsonObject older = session::toJson(before); // as versions before wrote it
    older.remove("friction_compensation");
    QCOMPARE(session::descriptorFromJson(older)->frictionCompensation, 0.0);
    // A field added to the descriptor but not to its JSON would be lost in silence.
    QCOMPARE(std::size_t(session::toJson(before).size()), memberCount<devices::DeviceDescriptor>());
    const QJsonObject axis = session::toJson(before)["axes"].toArray()[0].toObject();
    QCOMPARE(std::size_t(axis.size()), memberCount<devices::AxisDescriptor>());
}

void TestSessionJson::deviceDamageIsNamed() {
    const QJsonObject good = session::toJson(awkwardDevice());
    checkDamage(good, "device", session::descriptorFromJson);
    const QJsonObject axis = good["axes"].toArray()[0].toObject();
    checkDamage(axis, "device.axes[]", [&good](const QJsonObject& bad) {
        QJsonObject device = good;
        device["axes"] = QJsonArray{bad};
        return session::descriptorFromJson(device);
    });
}

void TestSessionJson::deviceNumbersInLists() {
    const QJsonObject good = session::toJson(awkwardDevice());
    const QJsonObject axis = good["axes"].toArray()[0].toObject();
    QJsonObject unit = axis;
    unit["unit"] = "inch";
    const std::pair<const char*, QJsonArray> bad[] = {
        {"axes", {}},
        {"axes", {axis, axis, axis, axis, axis, axis, axis, axis, axis}}, // a frame has room for eight
        {"axes", {axis, "axis"}},
        {"axes", {unit}},
        {"kinematics_parameters", {0.1, "0.2"}},
        {"kinematics_parameters", {0.1, QJsonValue()}}};
    for (const auto& [key, list] : bad) {
        QJsonObject device = good;
        device[QLatin1String(key)] = list;
        const auto result = session::descriptorFromJson(device);
        QVERIFY2(!result, qPrintable(QJsonDocument(list).toJson()));
        QVERIFY2(result.error().message.find(key) != std::string::npos, result.error().message.c_str());
    }
}

void TestSessionJson::mappingComesBack() {
    devices::WorkspaceMapping before;
    before.origin_m = {kAwkward[0], -kAwkward[1], kAwkward[3]};
    before.scale = 1.0 / 7.0;
    before.leftHanded = true;
    const auto after = session::mappingFromJson(stored(session::toJson(before)));
    QVERIFY2(after, after ? "" : after.error().message.c_str());
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(same(after->origin_m[i], before.origin_m[i]));
    QVERIFY(same(after->scale, before.scale));
    QCOMPARE(after->leftHanded, true);
    QCOMPARE(std::size_t(session::toJson(before).size()),
             std::size_t{3}); // a base that is not turned is not told, as before
    QVERIFY(!after->turned());
    before.q_WD = {0.5, -0.5, 0.5, -0.5};
    const auto turned = session::mappingFromJson(stored(session::toJson(before)));
    QVERIFY2(turned, turned ? "" : turned.error().message.c_str());
    QVERIFY(turned->q_WD == before.q_WD);
    for (const QJsonArray& bad :
         {QJsonArray{1, 0, 0}, QJsonArray{2, 0, 0, 0}, QJsonArray{0, 0, 0, 0}, QJsonArray{1, 0, 0, "0"}}) {
        QJsonObject damaged = session::toJson(before);
        damaged["base_turn"] = bad;
        const auto refused = session::mappingFromJson(damaged);
        QVERIFY(!refused);
        QVERIFY(refused.error().message.find("base_turn") != std::string::npos);
    }
}

void TestSessionJson::mappingDamageIsNamed() {
    const QJsonObject good = session::toJson(devices::WorkspaceMapping{});
    checkDamage(good, "mapping", session::mappingFromJson);
    for (const QJsonArray& origin :
         {QJsonArray{}, QJsonArray{0, 0}, QJsonArray{0, 0, 0, 0}, QJsonArray{0, "0", 0}}) {
        QJsonObject bad = good;
        bad["origin_m"] = origin;
        QVERIFY(!session::mappingFromJson(bad));
    }
    for (const double scale : {0.0, -1.0}) {
        QJsonObject bad = good;
        bad["scale"] = scale;
        QVERIFY(!session::mappingFromJson(bad));
    }
}

void TestSessionJson::safetyWritesEveryField() {
    QCOMPARE(std::size_t(session::toJson(haptics::SafetySettings{}).size()),
             memberCount<haptics::SafetySettings>());
}

// Every field with a value of its own, so that two fields that changed places would show.
void TestSessionJson::safetyComesBack() {
    QJsonObject distinct = session::toJson(haptics::SafetySettings{});
    int n = 0;
    for (const QString& key : distinct.keys()) {
        const QJsonValue value = distinct[key];
        distinct[key] = value.isBool() ? QJsonValue(!value.toBool()) : QJsonValue(double(1000 + ++n));
    }
    const auto settings = session::safetyFromJson(stored(distinct));
    QVERIFY2(settings, settings ? "" : settings.error().message.c_str());
    QCOMPARE(session::toJson(*settings), distinct);
    QCOMPARE(settings->siteForce_N, distinct["siteForce_N"].toDouble());
    QCOMPARE(double(settings->watchdogFault_us), distinct["watchdogFault_us"].toDouble());
    haptics::SafetySettings fine;
    fine.jump_m = 1.0 / 3.0;
    QVERIFY(same(session::safetyFromJson(stored(session::toJson(fine)))->jump_m, fine.jump_m));
}

void TestSessionJson::safetyDamageIsNamed() {
    checkDamage(session::toJson(haptics::SafetySettings{}), "supervisor", session::safetyFromJson);
}

void TestSessionJson::wholeNumbersStayInRange() {
    const QJsonObject good = session::toJson(haptics::SafetySettings{});
    for (const double bad : {-1.0, 0.5, 4294967296.0, 1e300}) {
        QJsonObject json = good;
        json["pauseRamp_ms"] = bad;
        const auto result = session::safetyFromJson(json);
        QVERIFY(!result);
        QVERIFY(result.error().message.find("supervisor.pauseRamp_ms") != std::string::npos);
    }
    QJsonObject largest = good;
    largest["pauseRamp_ms"] = 4294967295.0;
    QCOMPARE(session::safetyFromJson(largest)->pauseRamp_ms, std::numeric_limits<std::uint32_t>::max());
    QJsonObject device = session::toJson(awkwardDevice());
    device["period_us"] = 0;
    QVERIFY(!session::descriptorFromJson(device));
}

QTEST_APPLESS_MAIN(TestSessionJson)
#include "test_session_json.moc"
