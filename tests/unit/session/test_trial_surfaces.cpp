// SPDX-License-Identifier: GPL-3.0-or-later
// What could be touched in the trials of a session: of those that were planned and of no other, and a tool
// that touches nothing stands where it is.
#include "catalogue/catalogue.h"
#include "session/exercise_kind.h"
#include "session/trial_surfaces.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;

class TestTrialSurfaces : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatWasPlanned_data();
    void onlyWhatWasPlanned();
    void aTouchIsDrawnAtTheSurface();

private:
    static const catalogue::Catalogue& content() {
        static const auto loaded = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        if (!loaded)
            qFatal("%s", loaded.error().message.c_str());
        return *loaded;
    }
};

void TestTrialSurfaces::onlyWhatWasPlanned_data() {
    QTest::addColumn<QString>("exercise");
    QTest::addColumn<int>("level");
    for (const char* exercise : {"sphere_apex", "elastic_tube", "object_handling", "palpation"})
        for (const catalogue::ExerciseLevel& level : content().find(exercise)->levels)
            if (level.number <= 4)
                QTest::addRow("%s %d", exercise, level.number)
                    << QString::fromLatin1(exercise) << level.number;
}

void TestTrialSurfaces::onlyWhatWasPlanned() {
    QFETCH(QString, exercise);
    QFETCH(int, level);
    const catalogue::ExerciseLevel& found = *content().find(exercise.toStdString(), level);
    const auto kind = session::exerciseKind(exercise.toStdString());
    const auto surfaces = (*kind)->makeSurfaces(found, 11);
    const int trials = (*kind)->trialCount(found);
    QVERIFY(trials > 0);
    const Vec3 deep(0.0, 0.0, -0.5), high(0.0, 0.0, 0.5), none(std::nan(""), 0.0, 0.0);
    for (int trial = 0; trial < trials; ++trial) {
        const auto object = surfaces->object(trial);
        QVERIFY(object && object->p_WObject.allFinite() &&
                (object->radius_m > 0.0 || exercise == u"palpation")); // which has lumps instead
        QCOMPARE(surfaces->surfacePoint(trial, high), high);
        QVERIFY(std::isnan(surfaces->surfacePoint(trial, none).x()));
    }
    for (const int trial : {-1, trials, trials + 1}) {
        QVERIFY(!surfaces->object(trial));
        QCOMPARE(surfaces->surfacePoint(trial, deep), deep);
    }
}

void TestTrialSurfaces::aTouchIsDrawnAtTheSurface() {
    const auto surfaces = [](const char* exercise) {
        return (*session::exerciseKind(exercise))->makeSurfaces(*content().find(exercise, 1), 11);
    };
    const auto apex = surfaces("sphere_apex");
    for (int trial = 0; trial < 3; ++trial) {
        const session::TrialObject ball = *apex->object(trial);
        const Vec3 inside = ball.p_WObject + 0.9 * ball.radius_m * Vec3(0.6, 0.0, 0.8),
                   drawn = apex->surfacePoint(trial, inside);
        QVERIFY(std::abs((drawn - ball.p_WObject).norm() - ball.radius_m) < 1e-3 &&
                (drawn - inside).norm() > 1e-4);
        const Vec3 outside = ball.p_WObject + 1.1 * ball.radius_m * Vec3(0.6, 0.0, 0.8);
        QCOMPARE(apex->surfacePoint(trial, outside), outside);
    }
    QCOMPARE(surfaces("object_handling")->surfacePoint(0, Vec3(0.01, -0.02, -0.003)),
             Vec3(0.01, -0.02, 0.0)); // on the table
    QCOMPARE(surfaces("elastic_tube")->surfacePoint(0, Vec3(0.01, -0.02, -0.003)), Vec3(0.01, -0.02, -0.003));
    QCOMPARE(surfaces("elastic_tube")->object(0)->p_WObject.z(), 0.0);
    const auto tissue = surfaces("palpation");
    const Vec3 pressed(0.0, 0.0, -0.02), drawn = tissue->surfacePoint(0, pressed);
    QVERIFY(drawn.z() > pressed.z());
    QVERIFY(tissue->surfacePoint(0, drawn + Vec3(0.0, 0.0, 1e-6)) == drawn + Vec3(0.0, 0.0, 1e-6));
}

QTEST_APPLESS_MAIN(TestTrialSurfaces)
#include "test_trial_surfaces.moc"
