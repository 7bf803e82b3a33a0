// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/catalogue/urethra_insertion_content.h"

#include "catalogue/yield_content.h"
#include "core/units.h"
#include "mechanisms/five_bar_plant_parameters.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "simulation/geometry/urethra/urethra_validity_setup.h"
#include "simulation/scene_parameters.h"

#include <algorithm>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::UrethraInsertionParameters;

QString mm(double length_m) {
    return QStringLiteral("%1 mm").arg(core::mmFromM(length_m), 0, 'g', 4);
}

constexpr double kWayStep_m = 0.001;

/// Returns why P1's mechanism (D is W) cannot hold its tip at `p_W` with the endoscope along the canal; empty
/// if it can.
QString outsideMechanism(const core::Vec3& p_W, double psi_rad) {
    static const mechanisms::FiveBarPlantParameters kPlant;
    const QString place = QStringLiteral("(%1 inwards, %2 up)").arg(mm(p_W.y()), mm(p_W.z()));
    const auto theta = mechanisms::FiveBarKinematics(kPlant.geometry).inverse(p_W);
    if (!theta)
        return place + QStringLiteral(" its links do not reach");
    const double axes[] = {(*theta)[0], (*theta)[1], psi_rad - kPlant.mountingPitch_rad};
    const char* const names[] = {"theta1", "theta2", "pitch"};
    for (std::size_t i = 0; i < 3; ++i)
        if (!(axes[i] >= kPlant.minimum[i] && axes[i] <= kPlant.maximum[i]))
            return place + QStringLiteral(" its axis %1 would stand at %2°, beyond its travel")
                               .arg(QLatin1String(names[i]))
                               .arg(core::degFromRad(axes[i]), 0, 'f', 1);
    return {};
}

/// Translates a field of the structs, such as `changes[1].radius_m`, into the key of the content,
/// `local_changes[1].radius_mm`.
QString contentKey(const QString& field) {
    static const std::pair<const char*, const char*> kNames[] = {
        {"curvature_per_m", "centreline_curvature_per_m"},
        {"zEnd_m", "bladder_neck_z_mm"},
        {"straight_m", "straight_length_mm"},
        {"pivotSpan_m", "pivot_span_mm"},
        {"endoscope.radius_m", "endoscope_size_Fr"},
        {"endoscope.beak_m", "beak_mm"},
        {"endoscope.behind_m", "behind_mm"},
        {"endoscope.fieldOfView_rad", "field_of_view_deg"},
        {"mesh.n", "mesh_points"},
        {"mesh.w", "mesh_sections"},
        {"mesh.perPatch", "mesh_per_patch"},
        {"mesh.movingSections", "mesh_moving_sections"},
        {"radius_m", "rest_radius_mm"},
        {"wallStiffness_N_per_m3", "wall_stiffness_N_per_m3"},
        {"wallStiffening_per_m", "wall_stiffening_per_m"},
        {"viscosity_Ns_per_m2", "viscosity_N_s_per_m2"},
        {"wallRetardation_s", "wall_retardation_ms"},
        {"freeLength_m", "free_length_mm"},
        {"freeBlend_m", "free_blend_mm"},
        {"angularStiffness_Nm_per_rad", "angular_stiffness_N_m_per_rad"},
        {"angularCorner_m", "angular_corner_mm"},
        {"bladderRadius_m", "bladder_radius_mm"},
        {"bladderStiffness_N_per_m", "bladder_stiffness_N_per_m"},
        {"bladderOpening_rad", "bladder_opening_deg"},
        {"bladderOpeningEdge_rad", "bladder_opening_edge_deg"},
        {"changeCount", "local_changes"},
        {"centre_m", "centre_mm"},
        {"length_m", "length_mm"},
        {"edge_m", "edge_mm"},
        {"stiffnessFactor", "stiffness_factor"},
        {"frictionFactor", "friction_factor"},
    };
    if (field.startsWith(QLatin1String("changes["))) {
        const qsizetype dot = field.indexOf(u'.');
        const QString inner = field.mid(dot + 1);
        const QString name =
            inner == QLatin1String("radius_m") ? QStringLiteral("radius_mm") : contentKey(inner);
        return QStringLiteral("local_") + field.left(dot + 1) + name;
    }
    for (const auto& [member, key] : kNames)
        if (field == QLatin1String(member))
            return QLatin1String(key);
    return field;
}

/// The checks of one level. Each adds its problems.
class Checks {
public:
    Checks(const Parameters& p, const QString& path, Problems& problems)
        : m_p(p), m_path(path), m_problems(problems), m_length_m(lengthOf(p.anatomy)) {}

    void all() {
        if (!(m_length_m > 0.0)) {
            add("bladder_neck_z_mm", mm(m_p.anatomy.zEnd_m), QStringLiteral("a canal of some length"));
            return;
        }
        geometry();
        forces();
        goal();
        workspace();
        landmarks();
        cues();
    }

private:
    static double lengthOf(const simulation::UrethraAnatomy& anatomy) {
        if (!(anatomy.curvature_per_m > 0.0) || !(anatomy.zEnd_m > anatomy.straight_m))
            return 0.0;
        return simulation::UrethraCentreline(anatomy).length_m();
    }

    void add(const char* key, const QString& found, const QString& expected) {
        m_problems.push_back({memberPath(m_path, QLatin1String(key)), found, expected});
    }

    /// The code that builds a urethra knows what makes it impossible. This function only adds the content's
    /// names and values.
    void geometry() {
        for (const simulation::UrethraProblem& problem :
             simulation::urethraProblems(m_p.anatomy, m_p.endoscope, m_p.mesh)) {
            const QString key = contentKey(QString::fromStdString(problem.field));
            m_problems.push_back({m_path + u'.' + key, QStringLiteral("impossible"),
                                  QStringLiteral("a urethra that can exist (in SI units: %1)")
                                      .arg(QString::fromStdString(problem.reason))});
        }
    }

    void forces() {
        checkYield(m_p.yield, m_p.maximumForce_N, m_path, m_problems);
        checkYieldTorque(m_p.yield, m_p.maximumTorque_Nm, m_path, m_problems);
        if (m_p.anatomy.bladderRadius_m < 3.0 * m_p.endoscope.radius_m)
            add("bladder_radius_mm", mm(m_p.anatomy.bladderRadius_m),
                QStringLiteral("at least three times the endoscope's radius, %1")
                    .arg(mm(3.0 * m_p.endoscope.radius_m)));
    }

    void goal() {
        const double deepest_m = m_length_m + m_p.anatomy.bladderRadius_m;
        if (m_p.goalDepth_m > deepest_m)
            add("goal_depth_mm", mm(m_p.goalDepth_m),
                QStringLiteral("at most the bladder's middle, %1").arg(mm(deepest_m)));
        if (!m_p.landmarks.empty() && m_p.goalDepth_m > 0.0 && m_p.goalDepth_m < m_length_m)
            add("goal_depth_mm", mm(m_p.goalDepth_m),
                QStringLiteral("in the bladder, at least %1, since landmarks are inspected from there")
                    .arg(mm(m_length_m)));
    }

    /// Checks that P1's mechanism can follow the path from the start to the bladder's middle, which is the
    /// deepest position a goal may have.
    void workspace() {
        const simulation::UrethraCentreline line(m_p.anatomy);
        const double deepest_m = m_length_m + m_p.anatomy.bladderRadius_m;
        for (double s_m = -simulation::kStartBeforeEntrance_m; s_m <= deepest_m + 1e-9; s_m += kWayStep_m) {
            simulation::CentrelinePoint at = line.at(std::min(s_m, m_length_m));
            at.p_A += std::max(0.0, s_m - m_length_m) * at.t_A;
            const QString why = outsideMechanism(m_p.pose.pointToW(at.p_A), at.psi_rad);
            if (why.isEmpty())
                continue;
            const bool bladder = s_m > m_length_m;
            add(bladder ? "bladder_radius_mm" : "bladder_neck_z_mm",
                mm(bladder ? m_p.anatomy.bladderRadius_m : m_p.anatomy.zEnd_m),
                QStringLiteral("a %1 within the mechanism's workspace; at a depth of %2 %3")
                    .arg(bladder ? QStringLiteral("bladder") : QStringLiteral("canal"), mm(s_m), why));
            return;
        }
    }

    void landmarks() {
        const QString list = memberPath(m_path, QStringLiteral("landmarks"));
        for (std::size_t i = 0; i < m_p.landmarks.size(); ++i) {
            for (std::size_t k = 0; k < i; ++k)
                if (m_p.landmarks[k].id == m_p.landmarks[i].id)
                    m_problems.push_back(
                        {memberPath(elementPath(list, static_cast<qsizetype>(i)), QStringLiteral("id")),
                         quoted(QString::fromStdString(m_p.landmarks[i].id)),
                         QStringLiteral("each landmark once")});
        }
        if (2.0 * m_p.landmarkHalfAngle_rad > m_p.endoscope.fieldOfView_rad)
            add("landmark_half_angle_deg", QString::number(core::degFromRad(m_p.landmarkHalfAngle_rad)),
                QStringLiteral("inside the picture, at most %1")
                    .arg(0.5 * core::degFromRad(m_p.endoscope.fieldOfView_rad)));
    }

    void cues() {
        if (simulation::hasCue(m_p.cues, "guidance") && !simulation::hasCue(m_p.cues, "object"))
            m_problems.push_back({QStringLiteral("$.cues"), QStringLiteral("\"guidance\" without \"object\""),
                                  QStringLiteral("the picture that the way is marked in")});
    }

    const Parameters& m_p;
    QString m_path;
    Problems& m_problems;
    double m_length_m;
};

} // namespace

void checkUrethraInsertion(const ExerciseParameters& parameters, const QString& path, Problems& problems) {
    Checks(parameters.as<Parameters>(), path, problems).all();
}

} // namespace chiron::catalogue
