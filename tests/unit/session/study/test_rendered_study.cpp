// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/rendered_run.h"
#include "support/study_designs.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>

#include <algorithm>
#include <cmath>

using namespace chiron;
using psychophysics::Attribute;
using simulation::ComparisonControl;

namespace {

session::RenderedRunRequest requestOf(std::uint64_t seed,
                                      ComparisonControl control = ComparisonControl::none) {
    session::RenderedRunRequest request;
    request.design = testing::rank3Study();
    request.condition = "main";
    request.observer = {.weber = 0.12, .lapse = 0.02};
    request.seed = seed;
    request.control = control;
    return request;
}

int spoiledBy(const session::RenderedRun& run, const std::string& word) {
    return static_cast<int>(std::count_if(run.trials.begin(), run.trials.end(),
                                          [&](const auto& t) { return t.spoiled == word; }));
}

/// Largest relative error of any place of any trial; 1 where one has no number.
double worst(const session::RenderedRun& run, const char* key) {
    double off = 0.0;
    for (const auto& trial : run.trials)
        for (const QJsonValue& each : QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson))
                                          .object()["places"]
                                          .toArray()) {
            const QJsonObject place = each.toObject();
            off = std::max(off, place[key].isDouble()
                                    ? std::abs(place[key].toDouble() / place["asked"].toDouble() - 1.0)
                                    : 1.0);
        }
    return off;
}

} // namespace

class TestRenderedStudy : public QObject {
    Q_OBJECT
private slots:
    void noiseOfTheRenderingIsSmall() {
        const auto noise = session::renderingNoise(testing::rank3Study(), "main", 12, 12, 17);
        QVERIFY(noise);
        QCOMPARE(noise->missed, 0);
        QVERIFY2(noise->pooledSd < 0.01, qPrintable(QString::number(noise->pooledSd)));
        QVERIFY(noise->seconds < 8.0);
    }
    /// Simulated participants are told the smallest force as people are, and reach it at every place: no
    /// pilot, preview or demonstration is stuck.
    void theSmallestForceIsReached() {
        for (const Attribute attribute : {Attribute::stiffness, Attribute::mass, Attribute::deformation,
                                          Attribute::roughness, Attribute::friction, Attribute::viscosity}) {
            session::RenderedRunRequest request = requestOf(5);
            request.design = testing::rank3Study(attribute);
            request.design.trial.probeAtLeast_N = psychophysics::kUsualProbe_N;
            request.trialsAtMost = 6;
            const auto run = session::runRendered(request);
            QVERIFY2(run, run ? "" : run.error().message.c_str());
            QVERIFY(!run->trials.empty());
            QCOMPARE(spoiledBy(*run, "untouched"), 0);
            for (const auto& trial : run->trials)
                for (const QJsonValue& place :
                     QJsonDocument::fromJson(QByteArray::fromStdString(trial.fidelityJson))
                         .object()["places"]
                         .toArray())
                    QVERIFY2(place.toObject()["peak_force_N"].toDouble() >= psychophysics::kUsualProbe_N,
                             trial.fidelityJson.c_str());
        }
    }
    void weberFractionIsRecovered() {
        int inside = 0;
        const double sigma = psychophysics::sigmaOf({.weber = 0.12, .lapse = 0.02});
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            const auto run = session::runRendered(requestOf(seed));
            QVERIFY(run);
            QVERIFY(run->completed);
            QVERIFY(spoiledBy(*run, "stiffness_error") == 0);
            inside += run->estimate.sigma95.low <= sigma && sigma <= run->estimate.sigma95.high ? 1 : 0;
            QVERIFY(std::abs(std::log10(run->estimate.sigma_log10 / sigma)) < 0.25);
        }
        QVERIFY(inside >= 2);
    }
    /// A difference of 0.21 log10 units is felt as such; once a trembling hand and the pad's edge left it
    /// 0.08.
    void roughnessIsFeltAsItIs() {
        const auto design = testing::rank3Study(Attribute::roughness);
        const auto noise = session::renderingNoise(design, "main", 20, 36, 17);
        QVERIFY(noise);
        QCOMPARE(noise->missed, 0);
        const double difference = 2.0 * design.conditions.front().stimulus.differences[20];
        const double felt = difference + noise->mean[2] - noise->mean[0];
        QVERIFY2(std::abs(felt / difference - 1.0) < 0.1,
                 qPrintable(QString("%1 of %2").arg(felt).arg(difference)));
        QVERIFY2(noise->pooledSd < 0.05, qPrintable(QString::number(noise->pooledSd)));
    }
    /// What the meter says of each place of the widest table is what was asked for, and it notices what is
    /// not.
    void frictionIsRenderedAsAsked() {
        const auto design = testing::rank3Study(Attribute::friction);
        for (const auto control : {ComparisonControl::none, ComparisonControl::swapped}) {
            session::RenderedRunRequest request = requestOf(1, control);
            request.design = design;
            auto& procedure =
                std::get<psychophysics::Rank3Spec>(request.design.conditions.front().procedures.front());
            procedure.differences =
                request.design.conditions.front().stimulus.differences = {0.1, 0.3}; // up to μ = 1
            request.trialsAtMost = 8;
            const auto run = session::runRendered(request);
            QVERIFY(run);
            if (control == ComparisonControl::none) {
                QCOMPARE(spoiledBy(*run, "stiffness_error"), 0);
                QVERIFY2(worst(*run, "rendered") < 0.05,
                         qPrintable(QString::number(worst(*run, "rendered"))));
            } else
                QVERIFY(spoiledBy(*run, "stiffness_error") == static_cast<int>(run->trials.size()));
        }
    }
    void sameSeedSameRun() {
        auto request = requestOf(4);
        request.trialsAtMost = 8;
        const auto a = session::runRendered(request);
        const auto b = session::runRendered(request);
        QVERIFY(a && b);
        QCOMPARE(a->ticks, b->ticks);
        QCOMPARE(a->trials.size(), b->trials.size());
        for (std::size_t i = 0; i < a->trials.size(); ++i) {
            QCOMPARE(a->trials[i].answer, b->trials[i].answer);
            QVERIFY(a->trials[i].fidelityJson == b->trials[i].fidelityJson);
        }
    }
    /// Negative controls (psychophysics.md §6): each fault is seen.
    void aRendererThatIsTooStrongSpoilsEveryTrial() {
        const auto run = session::runRendered(requestOf(1, ComparisonControl::gain));
        QVERIFY(run);
        QVERIFY(!run->completed);
        QCOMPARE(spoiledBy(*run, "stiffness_error"), static_cast<int>(run->trials.size()));
    }
    void swappedStimuliCollapseTheEstimate() {
        auto request = requestOf(1, ComparisonControl::swapped);
        request.design.fidelity.stiffnessError = 10.0; // or fidelity would see it first
        const auto run = session::runRendered(request);
        QVERIFY(run);
        const double sigma = psychophysics::sigmaOf(request.observer);
        QVERIFY(!(run->estimate.sigma_log10 < 2.5 * sigma));
    }
    void aConstantForceTeachesNothing() {
        auto request = requestOf(1, ComparisonControl::constant);
        request.design.fidelity.stiffnessError = 10.0;
        const auto run = session::runRendered(request);
        QVERIFY(run);
        QVERIFY(!run->estimate.warnings.empty());
        QVERIFY(!(run->estimate.sigma_log10 < 2.5 * psychophysics::sigmaOf(request.observer)));
    }
};

QTEST_MAIN(TestRenderedStudy)
#include "test_rendered_study.moc"
