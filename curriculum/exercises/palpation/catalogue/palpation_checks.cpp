// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/tissue_content.h"
#include "curriculum/exercises/palpation/catalogue/palpation_content.h"

#include "core/tool_state.h"
#include "core/units.h"
#include "modules/exercises/palpation/simulation/palpation_plan.h"
#include "simulation/palpation/tissue_contact.h"

#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::PalpationParameters;
using simulation::LumpKind;

QString mm(double length_m) {
    return QString::number(core::mmFromM(length_m), 'g', 4) + QStringLiteral(" mm");
}
QString newtons(double force_N) {
    return QString::number(force_N, 'g', 4) + QStringLiteral(" N");
}

/// Adds problems at the keys of one level's parameters.
class Checks {
public:
    Checks(const Parameters& p, const QString& path, Problems& problems)
        : m_p(p), m_path(path), m_problems(problems) {
        // The softest point determines how deep the force cap lets a finger sink in. Where regions overlap,
        // their gains add up.
        for (const simulation::StiffRegion& region : p.tissue.regions)
            m_softest += std::min(0.0, region.gain);
        const double stiffness_N_per_m =
            simulation::TissueContact(p.tissue).normalStiffness_N_per_m() * m_softest;
        m_deepest_m = stiffness_N_per_m > 0.0 ? p.maximumForce_N / stiffness_N_per_m : 0.0;
    }

    void numbers() const {
        if (m_p.lumpsLow > m_p.lumpsHigh)
            add("lumps_low", QString::number(m_p.lumpsLow),
                QStringLiteral("at most lumps_high, %1").arg(m_p.lumpsHigh));
        if (m_p.catchTrials >= m_p.trials)
            add("catch_trials", QString::number(m_p.catchTrials),
                QStringLiteral("less than trials, %1: else there is nothing to find").arg(m_p.trials));
        if (m_p.lumpFirst && (m_p.catchTrials + 1 > m_p.trials || m_p.lumpsHigh < 1))
            add("lump_first", QStringLiteral("true"),
                QStringLiteral("a trial that is no catch trial, and lumps_high of at least 1"));
        if (m_p.tools() > core::kMaxTools)
            add("fingers", QString::number(m_p.fingers),
                QStringLiteral("at most %1 fingers in all").arg(core::kMaxTools));
        if (m_p.bandLow_N >= m_p.bandHigh_N)
            add("band_low_N", newtons(m_p.bandLow_N),
                QStringLiteral("less than band_high_N, %1").arg(newtons(m_p.bandHigh_N)));
        if (m_p.bandHigh_N > m_p.maximumForce_N)
            add("band_high_N", newtons(m_p.bandHigh_N),
                QStringLiteral("at most maximum_force_N, %1").arg(newtons(m_p.maximumForce_N)));
        if (std::isfinite(m_p.yield.force_N) &&
            (m_p.yield.force_N <= m_p.maximumForce_N || m_p.yield.force_N > 3.0 * m_p.maximumForce_N))
            add("yield_force_N", newtons(m_p.yield.force_N),
                QStringLiteral("more than maximum_force_N and at most three times that, %1 to %2")
                    .arg(newtons(m_p.maximumForce_N), newtons(3.0 * m_p.maximumForce_N)));
        if (m_p.coverForce_N > m_p.bandLow_N) // the map's bands need ascending edges, too
            add("cover_force_N", newtons(m_p.coverForce_N),
                QStringLiteral("at most band_low_N, %1: pressing as asked must count as searching")
                    .arg(newtons(m_p.bandLow_N)));
    }

    void lumps() const {
        for (std::size_t i = 0; i < m_p.kinds.size(); ++i)
            lump(m_p.kinds[i], elementPath(memberPath(m_path, "lump_kinds"), static_cast<qsizetype>(i)));
    }

    void places() const {
        const int most = simulation::mostPalpationLumps(m_p);
        if (m_p.lumpsHigh > most)
            add("lumps_high", QString::number(m_p.lumpsHigh),
                QStringLiteral(
                    "at most %1: no more fit, one a region of %2 x %3, %4 apart and from distractors%5")
                    .arg(most)
                    .arg(m_p.regionColumns)
                    .arg(m_p.regionRows)
                    .arg(mm(m_p.spacing_m), m_p.control.moveAfter_s > 0.0
                                                ? QStringLiteral(", before and after the control's move")
                                                : QString()));
    }

    void regions() const {
        if (m_softest <= 0.0)
            addBelow("tissue", "distractors",
                     QStringLiteral("soft gains of %1 in all").arg(m_softest - 1.0, 0, 'g', 3),
                     QStringLiteral("more than -1 in all: where distractors overlap their gains add, and no "
                                    "stiffness would be left"));
    }

    void surface() const {
        if (m_softest <= 0.0) // reported by regions()
            return;
        const double unique_m = simulation::TissueSurface(m_p.tissue.shape).deepestUnique_m();
        if (unique_m <= m_deepest_m)
            addBelow("tissue", "bumps", QStringLiteral("a surface that bends round %1").arg(mm(unique_m)),
                     QStringLiteral("gentler, or a stiffer tissue: maximum_force_N presses a finger in by %1")
                         .arg(mm(m_deepest_m)));
    }

private:
    /// Checks the validity of the law of models.md §3: R ≤ 0.75 h, a ≤ h/2, λ d ≤ (h − R)/2.
    void lump(const LumpKind& kind, const QString& path) const {
        const double h_m = kind.depth_m - m_p.depthSpread_m; // the shallowest depth that can be drawn
        const auto refuse = [&](const char* key, double found_m, const QString& expected) {
            m_problems.push_back({memberPath(path, key), mm(found_m), expected});
        };
        const QString spread =
            m_p.depthSpread_m > 0.0 ? QStringLiteral(" (depth_mm less depth_spread_mm)") : QString();
        if (kind.radius_m > 0.75 * h_m)
            return refuse("radius_mm", kind.radius_m,
                          QStringLiteral("at most 0.75 times the depth of its middle, %1%2")
                              .arg(mm(0.75 * std::max(0.0, h_m)), spread));
        if (m_p.tissue.contactRadius_m > 0.5 * h_m)
            refuse("depth_mm", kind.depth_m,
                   QStringLiteral("at least %1%2: twice the tissue's contact_radius_mm")
                       .arg(mm(2.0 * m_p.tissue.contactRadius_m + m_p.depthSpread_m), spread));
        if (const double sinks_m = m_p.tissue.sinkage * m_deepest_m; sinks_m > 0.5 * (h_m - kind.radius_m))
            refuse("depth_mm", kind.depth_m,
                   QStringLiteral("at least %1%2: maximum_force_N presses a finger in by %3, which brings it "
                                  "nearer to the lump by %4, "
                                  "at most half of what lies between")
                       .arg(mm(2.0 * sinks_m + kind.radius_m + m_p.depthSpread_m), spread, mm(m_deepest_m),
                            mm(sinks_m)));
    }

    void add(const char* key, const QString& found, const QString& expected) const {
        m_problems.push_back({memberPath(m_path, key), found, expected});
    }
    void addBelow(const char* object, const char* key, const QString& found, const QString& expected) const {
        m_problems.push_back({memberPath(memberPath(m_path, object), key), found, expected});
    }

    const Parameters& m_p;
    const QString& m_path;
    Problems& m_problems;
    double m_softest = 1.0; ///< as a factor of the tissue's stiffness
    double m_deepest_m = 0.0;
};

} // namespace

void checkPalpation(const ExerciseParameters& parameters, const QString& path, Problems& problems) {
    const auto& p = parameters.as<Parameters>();
    checkTissue(p.tissue, memberPath(path, "tissue"), problems);
    const Checks checks(p, path, problems);
    checks.numbers();
    checks.regions();
    checks.lumps();
    checks.places();
    checks.surface();
}

} // namespace chiron::catalogue
