// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/object_content.h"
#include "catalogue/yield_content.h"
#include "curriculum/exercises/object_handling/catalogue/object_handling_content.h"

#include "core/units.h"
#include "modules/exercises/object_handling/simulation/handling_world.h"
#include "modules/exercises/object_handling/simulation/object_handling_plan.h"
#include "modules/exercises/object_handling/simulation/soft_bed.h"
#include "simulation/objects/grasp.h"

#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ObjectHandlingParameters;
using simulation::HandlingTask;

constexpr double kWidestJaw_rad = 1.4;       ///< 80°: graspers open by 60 to 90°
constexpr double kShareOfSqueezeLimit = 0.8; ///< the weakest grip that carries the object leaves this much
                                             ///< room below the limit

QString mm(double length_m) {
    return QString::number(core::mmFromM(length_m), 'g', 4) + QStringLiteral(" mm");
}
QString g(double mass_kg) {
    return QString::number(1000.0 * mass_kg, 'g', 4) + QStringLiteral(" g");
}

/// Adds problems at the keys of one level's parameters.
class Checks {
public:
    Checks(const Parameters& p, const QString& path, Problems& problems)
        : m_p(p), m_path(path), m_problems(problems) {}

    void masses() const {
        const bool own = m_p.massLow_kg <= 0.0 && m_p.massHigh_kg <= 0.0;
        if (own && m_p.object.mass_kg <= 0.0)
            add("mass_low_g", g(m_p.massLow_kg),
                QStringLiteral("a mass above 0, here or in the object's mass_g"));
        if (!own && (m_p.massLow_kg <= 0.0 || m_p.massLow_kg > m_p.massHigh_kg))
            add("mass_low_g", g(m_p.massLow_kg),
                QStringLiteral("above 0 and at most the high end, %1").arg(g(m_p.massHigh_kg)));
        if (m_p.task == HandlingTask::weigh && m_p.massHigh_kg < m_p.massRatio * m_p.massLow_kg)
            add("mass_high_g", g(m_p.massHigh_kg),
                QStringLiteral("at least mass_ratio × mass_low_g = %1, so that one can be the heaviest")
                    .arg(g(m_p.massRatio * m_p.massLow_kg)));
        if (m_p.task == HandlingTask::weigh && own)
            add("mass_low_g", g(m_p.massLow_kg),
                QStringLiteral("masses to draw from, since a weigh task has a heaviest object"));
    }

    void count() const {
        const bool weigh = m_p.task == HandlingTask::weigh;
        if (weigh ? m_p.objects < 2 : m_p.objects != 1)
            add("objects", QString::number(m_p.objects),
                weigh ? QStringLiteral("2 or 3 to weigh") : QStringLiteral("1 to place"));
        // The fallback arrangement: objects and target at equal angles on a ring of placesRadius_m.
        const double chord = 2.0 * m_p.placesRadius_m * std::sin(core::kPi / (m_p.objects + 1));
        const double apart =
            m_p.objects > 1 ? std::max(simulation::objectSpacing_m(m_p), simulation::targetSpacing_m(m_p))
                            : simulation::targetSpacing_m(m_p);
        if (chord < apart)
            add("places_radius_mm", mm(m_p.placesRadius_m),
                QStringLiteral("at least %1, so that %2 objects and their target lie apart")
                    .arg(mm(m_p.placesRadius_m * apart / chord))
                    .arg(m_p.objects));
    }

    void grip() const {
        const double widest = simulation::JawGeometry{m_p.jawLength_m}.opening_m(kWidestJaw_rad);
        const double thickness = 2.0 * m_p.radius_m + m_p.releaseClearance_m;
        if (thickness > widest)
            add("jaw_length_mm", mm(m_p.jawLength_m),
                QStringLiteral("at least %1: jaws that open 80° have to pass the object and its clearance")
                    .arg(mm(m_p.jawLength_m * thickness / widest)));
        if (m_p.object.friction <= 0.0)
            return addBelow("object", "friction", QString::number(m_p.object.friction),
                            QStringLiteral("above 0: friction alone carries it"));
        const double needed_N = heaviest_kg() * core::kStandardGravity / (2.0 * m_p.object.friction);
        if (needed_N > kShareOfSqueezeLimit * m_p.squeezeLimit_N)
            add("squeeze_limit_N", QString::number(m_p.squeezeLimit_N),
                QStringLiteral(
                    "at least %1: the heaviest needs a squeeze of m g / 2 μ = %2 N, and some room above it")
                    .arg(needed_N / kShareOfSqueezeLimit, 0, 'g', 3)
                    .arg(needed_N, 0, 'g', 3));
    }

    void stability() const {
        const double lightest = m_p.massLow_kg > 0.0 ? m_p.massLow_kg : m_p.object.mass_kg;
        // The slope of k/b (e^{bx} - 1) at the force f is k + b f.
        const auto slopeAtCap = [&](const simulation::ObjectAttributes& a) {
            return a.stiffness_N_per_m * (1.0 + a.recoveryShare) + a.stiffening_per_m * m_p.maximumForce_N;
        };
        const double stiffness = slopeAtCap(m_p.object) + slopeAtCap(m_p.bed) +
                                 m_p.object.bristleStiffness_N_per_m + m_p.bed.bristleStiffness_N_per_m;
        constexpr double kT = core::kTickSeconds;
        // Semi-implicit Euler is stable up to 4 m / T²; at a quarter of it an oscillation has six ticks per
        // period.
        if (lightest > 0.0 && stiffness * kT * kT > lightest)
            addBelow(
                "object", "stiffness_N_per_m", QString::number(m_p.object.stiffness_N_per_m),
                QStringLiteral(
                    "less: all stiffnesses at the lightest object, %1, add up to at most %2 N/m (here %3)")
                    .arg(g(lightest))
                    .arg(lightest / (kT * kT), 0, 'g', 4)
                    .arg(stiffness, 0, 'g', 4));
        const double damping = m_p.object.damping_Ns_per_m + m_p.object.viscosity_Ns_per_m +
                               m_p.bed.damping_Ns_per_m + m_p.bed.viscosity_Ns_per_m;
        if (lightest > 0.0 && damping * kT > 0.5 * lightest)
            addBelow("object", "damping_N_s_per_m", QString::number(m_p.object.damping_Ns_per_m),
                     QStringLiteral("less: all damping and viscosity at the lightest object, %1, add up to "
                                    "at most %2 N·s/m (here %3)")
                         .arg(g(lightest))
                         .arg(0.5 * lightest / kT, 0, 'g', 4)
                         .arg(damping, 0, 'g', 4));
    }

    void depths() const {
        const double toMiddle_N = simulation::elasticOf(m_p.object).tension(m_p.radius_m);
        if (toMiddle_N < m_p.maximumForce_N)
            addBelow("object", "stiffness_N_per_m", QString::number(m_p.object.stiffness_N_per_m),
                     QStringLiteral("more: pressed to its middle it gives %1 N; at least maximum_force_N = "
                                    "%2, so that no tip comes there")
                         .arg(toMiddle_N, 0, 'g', 3)
                         .arg(m_p.maximumForce_N));
        const double weight_N = heaviest_kg() * core::kStandardGravity;
        if (simulation::elasticOf(m_p.bed).tension(0.25 * m_p.radius_m) < weight_N)
            addBelow("bed", "stiffness_N_per_m", QString::number(m_p.bed.stiffness_N_per_m),
                     QStringLiteral("enough to carry the heaviest object (%1) within a quarter of its radius")
                         .arg(g(heaviest_kg())));
    }

    void organ() const {
        if (!m_p.organBed)
            return;
        // A question to the organ model waits for the previous answer, so a longer latency would slow down
        // the organ's own time.
        const auto period = static_cast<int>(simulation::SoftBed::period_ticks(m_p));
        if (m_p.bedLatency_ticks > period)
            add("bed_latency_ticks", QString::number(m_p.bedLatency_ticks),
                QStringLiteral("at most the %1 ticks between two steps at bed_rate_Hz = %2, so that a step "
                               "of the organ lasts as long as it says")
                    .arg(period)
                    .arg(m_p.bedRate_Hz));
        const auto bed = simulation::SoftBed::make(m_p);
        if (!bed)
            return add("bed_mesh", QString::fromStdString(m_p.bedMesh.id),
                       QString::fromStdString("an organ that can be made: " + bed.error().message));
        const double field_m = simulation::HandlingWorld::reachOfField_m(m_p);
        if ((*bed)->reach_m() < field_m)
            add("bed_mesh",
                QString::fromStdString(m_p.bedMesh.id) + QStringLiteral(" reaching ") + mm((*bed)->reach_m()),
                QStringLiteral("an organ that reaches at least %1 along x and y: places_radius_mm, the rim "
                               "%2 beyond it, and radius_mm")
                    .arg(mm(field_m), mm(simulation::HandlingWorld::kRimBeyondPlaces_m)));
    }

private:
    double heaviest_kg() const { return m_p.massHigh_kg > 0.0 ? m_p.massHigh_kg : m_p.object.mass_kg; }
    void add(const char* key, const QString& found, const QString& expected) const {
        m_problems.push_back({memberPath(m_path, key), found, expected});
    }
    void addBelow(const char* object, const char* key, const QString& found, const QString& expected) const {
        m_problems.push_back({memberPath(memberPath(m_path, object), key), found, expected});
    }

    const Parameters& m_p;
    const QString& m_path;
    Problems& m_problems;
};

} // namespace

void checkObjectHandling(const ExerciseParameters& parameters, const QString& path, Problems& problems) {
    const auto& p = parameters.as<Parameters>();
    checkObject(p.object, memberPath(path, "object"), problems);
    checkObject(p.bed, memberPath(path, "bed"), problems);
    checkYield(p.yield, p.maximumForce_N, path, problems);
    checkMesh(p.bedMesh, memberPath(path, "bed_mesh"), problems);
    const Checks checks(p, path, problems);
    checks.masses();
    checks.count();
    checks.grip();
    checks.stability();
    checks.depths();
    checks.organ();
}

} // namespace chiron::catalogue
