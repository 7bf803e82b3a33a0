// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/elastic_tube/catalogue/elastic_tube_content.h"

#include "catalogue/object_content.h"
#include "catalogue/yield_content.h"
#include "core/units.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_plan.h"

#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ElasticTubeParameters;
using simulation::TubeTask;

/// models.md §4: with one tick of delay the default hand and the firm hand are stable on stiffnesses up to
/// this value.
constexpr double kStiffest_N_per_m = 2000.0;
/// The pivot of P2's mechanism is 180 mm above the floor, and its rod comes no nearer to the pivot than 80
/// mm.
constexpr double kHighest_m = 0.100;

/// As far as a retractor is drawn back in an operating field of this size.
constexpr double kFarthestFold_m = 0.060;

QString mm(double length_m) {
    return QStringLiteral("%1 mm").arg(core::mmFromM(length_m), 0, 'g', 4);
}
QString newtons(double force_N) {
    return QStringLiteral("%1 N").arg(force_N, 0, 'g', 4);
}

/// The checks of one level. Each adds its problems.
class Checks {
public:
    Checks(const Parameters& p, const QString& path, Problems& problems)
        : m_p(p), m_path(path), m_problems(problems) {}

    void all() {
        checkObject(m_p.tube, memberPath(m_path, "tube"), m_problems);
        checkYield(m_p.yield, m_p.maximumForce_N, m_path, m_problems);
        stiffness();
        lengths();
        if (m_p.task == TubeTask::hold || m_p.task == TubeTask::twoHanded)
            band();
        if (m_p.task == TubeTask::stretch)
            mark();
        if (m_p.task == TubeTask::transfer)
            target();
        if (m_p.hasFold())
            fold();
        if (!(m_p.graspAngle_rad < m_p.releaseAngle_rad))
            add("release_angle_deg", QString::number(core::degFromRad(m_p.releaseAngle_rad)),
                QStringLiteral("more than grasp_angle_deg, %1").arg(core::degFromRad(m_p.graspAngle_rad)));
    }

private:
    void add(const char* key, const QString& found, const QString& expected) {
        m_problems.push_back({memberPath(m_path, QLatin1String(key)), found, expected});
    }

    bool draws() const { return m_p.stiffnessHigh_N_per_m > 0.0; }
    double softest_N_per_m() const { return draws() ? m_p.stiffnessLow_N_per_m : m_p.tube.stiffness_N_per_m; }
    double stiffest_N_per_m() const {
        return draws() ? m_p.stiffnessHigh_N_per_m : m_p.tube.stiffness_N_per_m;
    }
    simulation::TubeLaw lawOf(double stiffness_N_per_m) const {
        simulation::ElasticTubeTrial trial;
        trial.stiffness_N_per_m = stiffness_N_per_m;
        return simulation::elasticTubeLaw(m_p, trial);
    }

    void stiffness() {
        if (m_p.stiffnessLow_N_per_m > m_p.stiffnessHigh_N_per_m)
            add("stiffness_low_N_per_m", QString::number(m_p.stiffnessLow_N_per_m),
                QStringLiteral("at most the high end, %1").arg(m_p.stiffnessHigh_N_per_m));
        if (!(softest_N_per_m() > 0.0)) {
            add(draws() ? "stiffness_low_N_per_m" : "tube", QString::number(softest_N_per_m()),
                QStringLiteral("a stiffness above 0, or there is no tension"));
            return;
        }
        // A hand that holds the tube in between feels the part below and the part above, acting in parallel.
        const double parts =
            m_p.task == TubeTask::transfer ? 1.0 / m_p.gripShare + 1.0 / (1.0 - m_p.gripShare) : 1.0;
        const simulation::TubeLaw law = lawOf(stiffest_N_per_m());
        const double felt = parts * law.slope_N_per_m(law.limit_m);
        if (felt > kStiffest_N_per_m)
            add(draws() ? "stiffness_high_N_per_m" : "tube",
                QStringLiteral("%1 N/m where it tears").arg(felt, 0, 'g', 4),
                QStringLiteral(
                    "at most %1 N/m there, stiffening and grip_share included, so that the loop stays stable")
                    .arg(kStiffest_N_per_m));
    }

    void lengths() {
        if (!(m_p.overStretchRatio < m_p.tearRatio))
            add("over_stretch_ratio", QString::number(m_p.overStretchRatio),
                QStringLiteral("below tear_ratio, %1").arg(m_p.tearRatio));
        if (m_p.task != TubeTask::twoHanded && m_p.overStretchRatio * m_p.restLength_m > kHighest_m)
            add("rest_length_mm", mm(m_p.restLength_m),
                QStringLiteral("at most %1, so that the tube can be stretched within the instrument's reach")
                    .arg(mm(kHighest_m / m_p.overStretchRatio)));
    }

    void band() {
        if (m_p.targetLow_N > m_p.targetHigh_N)
            add("target_low_N", newtons(m_p.targetLow_N),
                QStringLiteral("at most the high end, %1").arg(newtons(m_p.targetHigh_N)));
        if (!(m_p.targetLow_N > m_p.band_N))
            add("band_N", newtons(m_p.band_N),
                QStringLiteral("less than target_low_N, %1, so that a slack tube is never in the band")
                    .arg(newtons(m_p.targetLow_N)));
        const double most_N = m_p.targetHigh_N + m_p.band_N;
        const double safe_N =
            lawOf(softest_N_per_m()).tension_N((m_p.overStretchRatio - 1.0) * m_p.restLength_m);
        if (most_N > safe_N)
            add("target_high_N", newtons(m_p.targetHigh_N),
                QStringLiteral(
                    "at most %1, so that the softest tube is in the band before it is over-stretched")
                    .arg(newtons(safe_N - m_p.band_N)));
        if (most_N > m_p.maximumForce_N)
            add("target_high_N", newtons(m_p.targetHigh_N),
                QStringLiteral("at most maximum_force_N - band_N = %1")
                    .arg(newtons(m_p.maximumForce_N - m_p.band_N)));
    }

    /// Checks that the fold, held back with the middle of its force band, is within the retractor's reach,
    /// and that the task asks for no more force than is allowed.
    void fold() {
        if (!(m_p.retractionLow_N < m_p.retractionHigh_N))
            add("retraction_low_N", newtons(m_p.retractionLow_N),
                QStringLiteral("less than retraction_high_N, %1").arg(newtons(m_p.retractionHigh_N)));
        if (m_p.retractionHigh_N > m_p.maximumForce_N)
            add("retraction_high_N", newtons(m_p.retractionHigh_N),
                QStringLiteral("at most maximum_force_N, %1").arg(newtons(m_p.maximumForce_N)));
        const double way_m = 0.5 * (m_p.retractionLow_N + m_p.retractionHigh_N) / m_p.foldStiffness_N_per_m;
        if (way_m > kFarthestFold_m)
            add("fold_stiffness_N_per_m", QString::number(m_p.foldStiffness_N_per_m),
                QStringLiteral("at least %1, so that the fold is held back within %2, and not after %3")
                    .arg(0.5 * (m_p.retractionLow_N + m_p.retractionHigh_N) / kFarthestFold_m, 0, 'g', 3)
                    .arg(mm(kFarthestFold_m), mm(way_m)));
    }

    void mark() {
        if (!(m_p.markRatio - m_p.markTolerance > 1.0))
            add("mark_ratio", QString::number(m_p.markRatio),
                QStringLiteral("more than 1 + mark_tolerance = %1, so that a slack tube is never at it")
                    .arg(1.0 + m_p.markTolerance));
        if (m_p.markRatio + m_p.markTolerance > m_p.overStretchRatio)
            add("mark_ratio", QString::number(m_p.markRatio),
                QStringLiteral("at most over_stretch_ratio - mark_tolerance = %1")
                    .arg(m_p.overStretchRatio - m_p.markTolerance));
    }

    /// Checks the worst case: the part of the tube below the grip runs from the farthest base straight to the
    /// target.
    void target() {
        const double away_m =
            std::hypot(m_p.targetX_m - m_p.baseX_m, m_p.targetY_m - m_p.baseY_m) + m_p.baseSpread_m;
        const double length_m = std::hypot(away_m, m_p.targetZ_m) - (1.0 - m_p.gripShare) * m_p.restLength_m;
        const double ratio = length_m / (m_p.gripShare * m_p.restLength_m);
        if (ratio > m_p.overStretchRatio)
            add("target_x_mm",
                QStringLiteral("%1 away from the farthest base").arg(mm(std::hypot(away_m, m_p.targetZ_m))),
                QStringLiteral(
                    "a target that is reached before the tube is stretched to %1 times its length, not %2")
                    .arg(m_p.overStretchRatio)
                    .arg(ratio, 0, 'g', 3));
    }

    const Parameters& m_p;
    QString m_path;
    Problems& m_problems;
};

} // namespace

void checkElasticTube(const ExerciseParameters& parameters, const QString& path, Problems& problems) {
    Checks(parameters.as<Parameters>(), path, problems).all();
}

} // namespace chiron::catalogue
