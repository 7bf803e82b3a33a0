// SPDX-License-Identifier: GPL-3.0-or-later
// What the tissues' presets claim of their resistance, at the speeds of an insertion, on a device that
// carries 50 N·s/m.
#include "catalogue/catalogue.h"
#include "core/fp_environment.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_centreline.h"
#include "support/content_copy.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

using namespace chiron;
using namespace chiron::catalogue;

namespace {

const std::array<double, 3> kSpeeds_m_per_s{0.005, 0.010, 0.020};
const QString kFolder = QStringLiteral("exercises/urethra_insertion/");

/// At one speed along the middle of the canal, aligned: friction with the tip in the bladder, and the largest
/// resistance on the way.
struct Resistance {
    double friction_N = 0.0, total_N = 0.0, elastic_N = 0.0;
};

simulation::UrethraInsertionParameters parametersOf(const QString& tissue) {
    ContentCopy copy;
    const QString level = kFolder + QStringLiteral("levels/stricture.json");
    QByteArray text = copy.read(level);
    copy.write(level, text.replace("\"tissue\": \"stricture\"", "\"tissue\": \"" + tissue.toUtf8() + '"'));
    const auto catalogue = Catalogue::load(copy.directory());
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return catalogue->find("urethra_insertion", 4)->parameters.as<simulation::UrethraInsertionParameters>();
}

Resistance resistanceOf(const simulation::UrethraInsertionParameters& p, double speed_m_per_s) {
    const simulation::UrethraForces forces(p.anatomy, p.endoscope, p.forces);
    const double deepest = forces.centreline().length_m() + 0.010;
    Resistance most;
    for (double s = -0.012; s <= deepest; s += 0.0002) {
        const simulation::CentrelinePoint at = forces.centreline().at(s);
        const simulation::UrethraResponse r =
            forces.respond({at.p_A, at.t_A, speed_m_per_s * at.t_A, core::Vec3::Zero()});
        most.friction_N = -r.friction_N; // at last that of the whole canal
        most.elastic_N = std::max(most.elastic_N, -r.elastic_N);
        most.total_N = std::max(most.total_N, -r.friction_N - r.viscous_N - r.elastic_N);
    }
    return most;
}

QString printed(double value) {
    return QString::number(value, 'f', 2);
}

} // namespace

class TestTissueResistance : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void presetsSayWhatIsFelt_data();
    void presetsSayWhatIsFelt();
    void strictureResistsMoreThanTightMoreThanNormal();
    void frictionIsFarBelowItsLimitAtClinicalSpeed();
};

void TestTissueResistance::presetsSayWhatIsFelt_data() {
    QTest::addColumn<QString>("tissue");
    for (const char* tissue : {"normal", "tight", "stricture"})
        QTest::newRow(tissue) << QString(tissue);
}

void TestTissueResistance::presetsSayWhatIsFelt() {
    QFETCH(QString, tissue);
    const auto p = parametersOf(tissue);
    ContentCopy copy;
    const QByteArray file = copy.read(kFolder + QStringLiteral("presets/%1.json").arg(tissue));
    const QString source = QJsonDocument::fromJson(file).object()["source"].toString();
    std::array<Resistance, 3> felt;
    for (std::size_t i = 0; i < 3; ++i)
        felt[i] = resistanceOf(p, kSpeeds_m_per_s[i]);
    const auto listed = [&](auto member) {
        return QStringLiteral("%1, %2 and %3 N")
            .arg(printed(felt[0].*member), printed(felt[1].*member), printed(felt[2].*member));
    };
    const QString friction = listed(&Resistance::friction_N).replace(QStringLiteral(" N"), QString());
    QVERIFY2(source.contains(friction + QStringLiteral(" N at 5, 10 and 20 mm/s")), qPrintable(friction));
    QVERIFY2(source.contains(listed(&Resistance::total_N)), qPrintable(listed(&Resistance::total_N)));
    const QString limit =
        printed(resistanceOf(p, 1000.0).friction_N); // μN: the model's, at no speed of a hand
    QVERIFY2(source.contains(limit + QStringLiteral(" N")), qPrintable(limit));
    if (tissue == "stricture")
        QVERIFY2(source.contains(printed(felt[0].elastic_N) + QStringLiteral(" N of elastic")),
                 qPrintable(printed(felt[0].elastic_N)));
}

void TestTissueResistance::strictureResistsMoreThanTightMoreThanNormal() {
    const auto normal = parametersOf("normal"), tight = parametersOf("tight"),
               stricture = parametersOf("stricture");
    for (const double speed : kSpeeds_m_per_s) {
        const double n = resistanceOf(normal, speed).total_N, t = resistanceOf(tight, speed).total_N;
        const double s = resistanceOf(stricture, speed).total_N;
        QVERIFY2(t > 1.13 * n && s > 2.0 * t,
                 qPrintable(QStringLiteral("%1, %2, %3 at %4").arg(n).arg(t).arg(s).arg(speed)));
    }
}

// Friction alone hardly tells tissues apart at these speeds: its slope is the device's, not theirs.
void TestTissueResistance::frictionIsFarBelowItsLimitAtClinicalSpeed() {
    for (const char* tissue : {"normal", "tight", "stricture"}) {
        const auto p = parametersOf(tissue);
        const double limit = resistanceOf(p, 1000.0).friction_N, steepest = p.forces.maximumDamping_Ns_per_m;
        for (const double speed : kSpeeds_m_per_s) {
            const double friction = resistanceOf(p, speed).friction_N;
            QVERIFY(friction <= steepest * speed);
            QVERIFY(std::abs(friction - limit * speed / std::hypot(speed, limit / steepest)) < 1e-9);
            QVERIFY(speed > 0.011 || friction > 0.85 * steepest * speed);
        }
    }
}

QTEST_APPLESS_MAIN(TestTissueResistance)
#include "test_tissue_resistance.moc"
