// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/catalogue/urethra_insertion_content.h"

#include "catalogue/yield_content.h"

#include "core/units.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"

#include <algorithm>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::UrethraInsertionParameters;

constexpr double kMm = 1000.0;
constexpr double kDeg = 180.0 / core::kPi;
constexpr double kFr = 6000.0; // converts a radius: 1 Fr = 1/3 mm of diameter

struct Number {
    const char* name;
    double& (*in)(Parameters&);
    double perUnit; ///< content units per SI unit
};

struct Whole {
    const char* name;
    int& (*in)(Parameters&);
};

struct Flag {
    const char* name;
    bool& (*in)(Parameters&);
};

constexpr Number kNumbers[] = {
    {"centreline_curvature_per_m", [](Parameters& p) -> double& { return p.anatomy.curvature_per_m; }, 1.0},
    {"straight_length_mm", [](Parameters& p) -> double& { return p.anatomy.straight_m; }, kMm},
    {"pivot_span_mm", [](Parameters& p) -> double& { return p.anatomy.pivotSpan_m; }, kMm},
    {"bladder_neck_z_mm", [](Parameters& p) -> double& { return p.anatomy.zEnd_m; }, kMm},
    {"rest_radius_mm", [](Parameters& p) -> double& { return p.anatomy.radius_m; }, kMm},
    {"wall_stiffness_N_per_m3", [](Parameters& p) -> double& { return p.anatomy.wallStiffness_N_per_m3; },
     1.0},
    {"wall_stiffening_per_m", [](Parameters& p) -> double& { return p.anatomy.wallStiffening_per_m; }, 1.0},
    {"friction", [](Parameters& p) -> double& { return p.anatomy.friction; }, 1.0},
    {"viscosity_N_s_per_m2", [](Parameters& p) -> double& { return p.anatomy.viscosity_Ns_per_m2; }, 1.0},
    {"wall_retardation_ms", [](Parameters& p) -> double& { return p.anatomy.wallRetardation_s; }, 1000.0},
    {"free_length_mm", [](Parameters& p) -> double& { return p.anatomy.freeLength_m; }, kMm},
    {"free_blend_mm", [](Parameters& p) -> double& { return p.anatomy.freeBlend_m; }, kMm},
    {"free_hold_N_per_m", [](Parameters& p) -> double& { return p.anatomy.freeHold_N_per_m; }, 1.0},
    {"meatus_radius_mm", [](Parameters& p) -> double& { return p.meatus_m; }, kMm},
    {"angular_stiffness_N_m_per_rad",
     [](Parameters& p) -> double& { return p.anatomy.angularStiffness_Nm_per_rad; }, 1.0},
    {"angular_corner_mm", [](Parameters& p) -> double& { return p.anatomy.angularCorner_m; }, kMm},
    {"bladder_radius_mm", [](Parameters& p) -> double& { return p.anatomy.bladderRadius_m; }, kMm},
    {"bladder_stiffness_N_per_m", [](Parameters& p) -> double& { return p.anatomy.bladderStiffness_N_per_m; },
     1.0},
    {"bladder_opening_deg", [](Parameters& p) -> double& { return p.anatomy.bladderOpening_rad; }, kDeg},
    {"bladder_opening_edge_deg", [](Parameters& p) -> double& { return p.anatomy.bladderOpeningEdge_rad; },
     kDeg},
    {"endoscope_size_Fr", [](Parameters& p) -> double& { return p.endoscope.radius_m; }, kFr},
    {"beak_mm", [](Parameters& p) -> double& { return p.endoscope.beak_m; }, kMm},
    {"behind_mm", [](Parameters& p) -> double& { return p.endoscope.behind_m; }, kMm},
    {"field_of_view_deg", [](Parameters& p) -> double& { return p.endoscope.fieldOfView_rad; }, kDeg},
    {"force_step_mm", [](Parameters& p) -> double& { return p.forces.maximumStep_m; }, kMm},
    {"largest_damping_N_s_per_m", [](Parameters& p) -> double& { return p.forces.maximumDamping_Ns_per_m; },
     1.0},
    {"goal_depth_mm", [](Parameters& p) -> double& { return p.goalDepth_m; }, kMm},
    {"landmark_half_angle_deg", [](Parameters& p) -> double& { return p.landmarkHalfAngle_rad; }, kDeg},
    {"landmark_distance_mm", [](Parameters& p) -> double& { return p.landmarkDistance_m; }, kMm},
    {"landmark_hold_s", [](Parameters& p) -> double& { return p.landmarkHold_s; }, 1.0},
    {"landmark_speed_mm_per_s", [](Parameters& p) -> double& { return p.landmarkSpeed_m_per_s; }, kMm},
    {"trial_limit_s", [](Parameters& p) -> double& { return p.trialLimit_s; }, 1.0},
    {"maximum_force_N", [](Parameters& p) -> double& { return p.maximumForce_N; }, 1.0},
    {"maximum_torque_mN_m", [](Parameters& p) -> double& { return p.maximumTorque_Nm; }, 1000.0},
    {"lateral_limit_N", [](Parameters& p) -> double& { return p.lateralLimit_N; }, 1.0},
};

constexpr Whole kWholes[] = {
    {"p1_basic_sections", [](Parameters& p) -> int& { return p.forces.basicSections; }},
    {"mesh_points", [](Parameters& p) -> int& { return p.mesh.n; }},
    {"mesh_sections", [](Parameters& p) -> int& { return p.mesh.w; }},
    {"mesh_per_patch", [](Parameters& p) -> int& { return p.mesh.perPatch; }},
    {"mesh_moving_sections", [](Parameters& p) -> int& { return p.mesh.movingSections; }},
};

constexpr Flag kFlags[] = {
    {"withdraws", [](Parameters& p) -> bool& { return p.withdraws; }},
    {"depth_of_field", [](Parameters& p) -> bool& { return p.depthOfField; }},
    {"depth_of_field_fixed", [](Parameters& p) -> bool& { return p.depthOfFieldFixed; }},
};

constexpr const char* kOthers[] = {"tissue", "force_sections", "local_changes", "landmarks"};

void readChanges(const ObjectReader& parameters, Parameters& p) {
    p.anatomy.changeCount = 0;
    parameters.eachObject("local_changes", [&](const ObjectReader& json) {
        if (p.anatomy.changeCount >= simulation::UrethraAnatomy::kMaxChanges) {
            parameters.problems().push_back(
                {json.path(), QStringLiteral("one too many"),
                 QStringLiteral("at most %1").arg(simulation::UrethraAnatomy::kMaxChanges)});
            return;
        }
        simulation::UrethraLocalChange& change = p.anatomy.changes[p.anatomy.changeCount++];
        change.centre_m = json.number("centre_mm") / kMm;
        change.length_m = json.number("length_mm") / kMm;
        change.edge_m = json.number("edge_mm") / kMm;
        change.radius_m = json.number("radius_mm") / kMm;
        change.stiffnessFactor = json.number("stiffness_factor");
        change.frictionFactor = json.number("friction_factor");
    });
}

void readLandmarks(const ObjectReader& parameters, Parameters& p) {
    p.landmarks.clear();
    parameters.eachObject("landmarks", [&](const ObjectReader& json) {
        p.landmarks.push_back(
            {json.text("id"), json.number("polar_deg") / kDeg, json.number("azimuth_deg") / kDeg});
    });
}

void readSections(const ObjectReader& parameters, Parameters& p) {
    const std::string sections = parameters.text("force_sections");
    if (sections == "p1_basic")
        p.forces.sections = simulation::ForceSections::p1Basic;
    else if (sections == "fine")
        p.forces.sections = simulation::ForceSections::fine;
    else
        parameters.problems().push_back({memberPath(parameters.path(), "force_sections"),
                                         quoted(QString::fromStdString(sections)),
                                         QStringLiteral("\"fine\" or \"p1_basic\"")});
}

void refuseUnknownKeys(const ObjectReader& parameters) {
    std::vector<QString> known;
    for (const Number& key : kNumbers)
        known.push_back(QLatin1String(key.name));
    for (const Whole& key : kWholes)
        known.push_back(QLatin1String(key.name));
    for (const Flag& key : kFlags)
        known.push_back(QLatin1String(key.name));
    for (const char* key : kOthers)
        known.push_back(QLatin1String(key));
    for (const char* key : kYieldKeys)
        known.push_back(QLatin1String(key));
    known.push_back(QLatin1String(kYieldTorqueKey));
    for (const QString& key : parameters.json().keys())
        if (std::find(known.begin(), known.end(), key) == known.end())
            parameters.problems().push_back(
                {memberPath(parameters.path(), key), QStringLiteral("unknown key"),
                 QStringLiteral("a parameter of urethra_insertion") + didYouMean(key, known)});
}

} // namespace

ExerciseParameters readUrethraInsertion(const ObjectReader& parameters,
                                        const std::vector<std::string>& cues) {
    Parameters p;
    for (const Number& key : kNumbers)
        if (parameters.has(QLatin1String(key.name)))
            key.in(p) = parameters.number(QLatin1String(key.name)) / key.perUnit;
    for (const Whole& key : kWholes)
        if (parameters.has(QLatin1String(key.name)))
            key.in(p) = parameters.integer(QLatin1String(key.name));
    for (const Flag& key : kFlags)
        if (parameters.has(QLatin1String(key.name)))
            key.in(p) = parameters.boolean(QLatin1String(key.name));
    readYield(parameters, p.yield);
    if (parameters.has("tissue"))
        p.tissue = parameters.text("tissue");
    if (parameters.has("force_sections"))
        readSections(parameters, p);
    if (parameters.has("local_changes"))
        readChanges(parameters, p);
    if (parameters.has("landmarks"))
        readLandmarks(parameters, p);
    refuseUnknownKeys(parameters);
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

} // namespace chiron::catalogue
