// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/urethra_insertion/catalogue/urethra_insertion_content.h"

#include "catalogue/yield_content.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_insertion_parameters.h"
#include "simulation/geometry/urethra/urethra_anatomy.h"

#include <algorithm>
#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::UrethraInsertionParameters;
using Anatomy = simulation::UrethraAnatomy;
using Change = simulation::UrethraLocalChange;
using Forces = simulation::UrethraForceSettings;
using Landmark = simulation::BladderLandmark;
using Mesh = simulation::UrethraMeshSettings;
using simulation::ForceSections;

constexpr ContentUnit kFr{"Fr", 6000.0}; // of a radius: 1 Fr = 1/3 mm of diameter

/// The parameters while they are read: the anatomy has a fixed number of places for local changes.
struct Draft : Parameters {
    std::vector<Change> changes;
};
using Row = ParameterRow<Draft>;

const std::vector<ParameterRow<Change>>& changeRows() {
    using Item = ParameterRow<Change>;
    static const std::vector<Item> kRows{
        Item::number("centre_mm", units::kMm, {0, 400}, &Change::centre_m,
                     "Arc length of its middle, from the entrance."),
        Item::number(
            "length_mm", units::kMm, {10, 200}, &Change::length_m,
            "Between its two half-height points; at least 10, so that the force sections cannot miss it."),
        Item::number("edge_mm", units::kMm, {2, 100}, &Change::edge_m,
                     "Over which it sets in and fades; at most the length. Under 2 the force sections would "
                     "be too many."),
        Item::number("radius_mm", units::kMm, {0.3, 8}, &Change::radius_m,
                     "Of the urethra at rest in its middle."),
        Item::number("stiffness_factor", units::kPure, {0.01, 100}, &Change::stiffnessFactor,
                     "Times the wall's stiffness."),
        Item::number("friction_factor", units::kPure, {0, 10}, &Change::frictionFactor,
                     "Times the wall's friction.")};
    return kRows;
}

const std::vector<ParameterRow<Landmark>>& landmarkRows() {
    using Item = ParameterRow<Landmark>;
    static const std::vector<Item> kRows{
        Item::identifier("id", &Landmark::id, "Its name for the screen and for scores."),
        Item::number("polar_deg", units::kDeg, {0, 150}, &Landmark::polar_rad,
                     "Angle at the bladder's centre from the direction straight ahead of the neck."),
        Item::number("azimuth_deg", units::kDeg, {-180, 180}, &Landmark::azimuth_rad,
                     "Direction round that axis: 0 to the patient's right, 90 to the front, 180 to the left, "
                     "-90 to the back.")};
    return kRows;
}

/// The parameters of a level, in the order of the schema.
const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        Row::identifier("tissue", &Parameters::tissue,
                        "Name of the preset in exercises/urethra_insertion/presets whose parameters hold "
                        "where the level gives none of its own: normal, tight or stricture. Each preset says "
                        "where its numbers come from."),
        Row::number("centreline_curvature_per_m", {"1/m"}, {1, 100},
                    within(&Parameters::anatomy, &Anatomy::curvature_per_m),
                    "c of the centre-line y = c (z − straight part)² in the plane of symmetry. P1 prints "
                    "0.13 for lengths in cm (models.md §1.1)."),
        Row::number("straight_length_mm", units::kMm, {0, 120},
                    within(&Parameters::anatomy, &Anatomy::straight_m),
                    "The straight part of the canal, from the entrance A to the bend B, P1's point where the "
                    "endoscope turns: the parabola's vertex lies there. At most the free length less the "
                    "angular corner. 0: the vertex lies at the entrance, as before there was this key."),
        Row::number("pivot_span_mm", units::kMm, {0, 100},
                    within(&Parameters::anatomy, &Anatomy::pivotSpan_m),
                    "The rigid shaft pivots at the pelvic floor, where the free part ends, which holds it "
                    "over this length: tilting it takes the tip aside, and a tip that is aside tilts it (P1: "
                    "torque 'off the parabolic CL'). The membranous urethra is about 20 mm long: assumption. "
                    "0: tilt and offset have nothing to do with each other, as before there was this key."),
        Row::number("bladder_neck_z_mm", units::kMm, {20, 150},
                    within(&Parameters::anatomy, &Anatomy::zEnd_m),
                    "z of the bladder neck C on the centre-line; the entrance A is at 0. 87.7 mm spans P1's "
                    "workspace of 0.1 m in y where the canal bends from the entrance on; behind a straight "
                    "part of 35 mm, 100 mm spans it in z, and the canal turns by 59.4°, within P1's ±30°."),
        Row::number("rest_radius_mm", units::kMm, {0.3, 8}, within(&Parameters::anatomy, &Anatomy::radius_m),
                    "Radius of the urethra at rest. Assumption; P1 gives none."),
        Row::number("wall_stiffness_N_per_m3", {"N/m³"}, {10000, 100000000},
                    within(&Parameters::anatomy, &Anatomy::wallStiffness_N_per_m3),
                    "Pressure on the wall for each metre it is stretched radially. Assumption; a whole canal "
                    "that bends from its entrance then presses with 10.3 N (models.md §1.2)."),
        Row::number("wall_stiffening_per_m", {"1/m"}, {0, 3000},
                    within(&Parameters::anatomy, &Anatomy::wallStiffening_per_m),
                    "Strain stiffening: the pressure is κ Δ (1 + β Δ). Assumption."),
        Row::number(
            "friction", units::kPure, {0, 1}, within(&Parameters::anatomy, &Anatomy::friction),
            "Coulomb friction of the wet wall. Assumption; in a canal that bends from its entrance it gives "
            "1.0 N. The pull at which catheters come out is 0.84 to 1.38 N (Waller 1997, abstract)."),
        Row::number("viscosity_N_s_per_m2", {"N·s/m²"}, {0, 1000},
                    within(&Parameters::anatomy, &Anatomy::viscosity_Ns_per_m2),
                    "Viscous drag for each metre of canal in contact. Assumption."),
        Row::number("wall_retardation_ms", units::kMs, {0, 50},
                    within(&Parameters::anatomy, &Anatomy::wallRetardation_s),
                    "The wall is no spring alone: pressed aside, it takes the tip's motion across the canal "
                    "with its stiffness times this (Kelvin–Voigt: viscosity over modulus), within what the "
                    "device carries of damping. Its loss factor is 2π times frequency times this. "
                    "Assumption; 0: it does not damp across the canal, as before there was this key."),
        Row::number("free_length_mm", units::kMm, {0, 150},
                    within(&Parameters::anatomy, &Anatomy::freeLength_m),
                    "Arc length of the part outside the body, which follows the shaft without resisting its "
                    "direction (models.md §1.2). Assumption."),
        Row::number(
            "free_blend_mm", units::kMm, {1, 40}, within(&Parameters::anatomy, &Anatomy::freeBlend_m),
            "The wall's hold on the shaft sets in over the free length plus and minus this. Assumption."),
        Row::number("free_hold_N_per_m", units::kN_per_m, {0, 5000},
                    within(&Parameters::anatomy, &Anatomy::freeHold_N_per_m),
                    "What holds the part outside the body where the shaft takes it more than 10 mm aside: it "
                    "hangs on the body. Assumption; 0: nothing, as before there was this key."),
        Row::number("meatus_radius_mm", units::kMm, {0, 10}, &Parameters::meatus_m,
                    "The endoscope gets into the canal only where its beak meets the entrance within this "
                    "distance of the middle; elsewhere nothing is felt. Assumption; 0: it gets in anywhere, "
                    "as before there was this key."),
        yieldForceRow<Draft>(
            13.5, "The wall gives way to a false passage under more force than this: a critical error. More "
                  "than maximum_force_N and at most three times that; 0: it never gives way."),
        yieldFallRow<Draft>("How long force and torque take to fall to nothing when the wall gives way."),
        yieldTorqueRow<Draft>(
            450, "It gives way under more torque than this, too. More than maximum_torque_mN_m and at most "
                 "three times that; 0: under force alone, as before there was this key."),
        Row::number("angular_stiffness_N_m_per_rad", {"N·m/rad"}, {0, 2},
                    within(&Parameters::anatomy, &Anatomy::angularStiffness_Nm_per_rad),
                    "Stiffness against turning the endoscope away from the centre-line at the bladder neck; "
                    "it rises linearly from the free length (P1). Assumption; 105 mN·m at 30°."),
        Row::number("angular_corner_mm", units::kMm, {0.5, 20},
                    within(&Parameters::anatomy, &Anatomy::angularCorner_m),
                    "The corners of that rise are rounded over plus and minus this. Assumption."),
        Row::list("local_changes", {0, static_cast<int>(Anatomy::kMaxChanges)}, changeRows(),
                  "One stretch; it sets in and fades by a smooth step.", "a number of a local change",
                  &Draft::changes, "Stretches where the wall differs, for instance a stricture."),
        Row::number("bladder_radius_mm", units::kMm, {15, 80},
                    within(&Parameters::anatomy, &Anatomy::bladderRadius_m),
                    "Of the bladder, a sphere whose wall meets the centre-line at the neck; 35 mm hold 180 "
                    "ml. Assumption."),
        Row::number("bladder_stiffness_N_per_m", units::kN_per_m, {0, 2000},
                    within(&Parameters::anatomy, &Anatomy::bladderStiffness_N_per_m),
                    "Of the bladder's wall against the tip. Assumption: soft, between P3's 227 and 650 N/m."),
        Row::number(
            "bladder_opening_deg", units::kDeg, {2, 45},
            within(&Parameters::anatomy, &Anatomy::bladderOpening_rad),
            "Half angle of the neck, seen from the bladder's centre, where there is no wall. Assumption."),
        Row::number("bladder_opening_edge_deg", units::kDeg, {1, 30},
                    within(&Parameters::anatomy, &Anatomy::bladderOpeningEdge_rad),
                    "The wall grows to its full stiffness over this angle. Assumption."),
        Row::number("endoscope_size_Fr", kFr, {6, 30},
                    within(&Parameters::endoscope, &simulation::Endoscope::radius_m),
                    "Outer diameter of the rigid endoscope; 1 Fr is a third of a millimetre. 22 Fr: a usual "
                    "cystoscope sheath. One thinner than the urethra runs without squeezing it."),
        Row::number("beak_mm", units::kMm, {2, 30},
                    within(&Parameters::endoscope, &simulation::Endoscope::beak_m),
                    "How far ahead of the tip the canal opens (P1's sinusoidal profile)."),
        Row::number("behind_mm", units::kMm, {5, 100},
                    within(&Parameters::endoscope, &simulation::Endoscope::behind_m),
                    "How far behind the tip the canal moves with its offset. Assumption."),
        Row::number("field_of_view_deg", units::kDeg, {20, 120},
                    within(&Parameters::endoscope, &simulation::Endoscope::fieldOfView_rad),
                    "Full angle of the picture. Assumption: usual for cystoscopes."),
        Row::choice<ForceSections>("force_sections",
                                   {{"fine", ForceSections::fine}, {"p1_basic", ForceSections::p1Basic}},
                                   within(&Parameters::forces, &Forces::sections),
                                   "Where the springs lie: on a grid of their own, at most 1.25 mm apart, or "
                                   "on P1's drawn sections, for comparison."),
        Row::number("force_step_mm", units::kMm, {0.5, 5},
                    within(&Parameters::forces, &Forces::maximumStep_m),
                    "Largest distance of the fine grid's sections, less where a local change has edges under "
                    "4 mm; halving the default changes felt forces by less than 1 % everywhere."),
        Row::whole("p1_basic_sections", {4, 401}, within(&Parameters::forces, &Forces::basicSections),
                   "How many sections carry springs where force_sections is p1_basic; P1: 26."),
        Row::number("largest_damping_N_s_per_m", units::kNs_per_m, {1, 500},
                    within(&Parameters::forces, &Forces::maximumDamping_Ns_per_m),
                    "Coulomb friction sets in no steeper than this, and no steeper than the session's device "
                    "renders stably, whichever is less (models.md §0)."),
        Row::whole("mesh_points", {5, 129}, within(&Parameters::mesh, &Mesh::n),
                   "Points of a drawn section, first and last the same; P1: 17."),
        Row::whole("mesh_sections", {4, 401}, within(&Parameters::mesh, &Mesh::w), "Drawn sections; P1: 26."),
        Row::whole("mesh_per_patch", {1, 32}, within(&Parameters::mesh, &Mesh::perPatch),
                   "Each patch is drawn by this many squares a side."),
        Row::whole("mesh_moving_sections", {3, 33}, within(&Parameters::mesh, &Mesh::movingSections),
                   "Sections of the moving deformation ahead of the tip."),
        Row::number("goal_depth_mm", units::kMm, {0, 400}, &Parameters::goalDepth_m,
                    "How far in the tip has to come (arc length); 0: 10 mm past the bladder neck."),
        Row::flag("withdraws", &Parameters::withdraws,
                  "The procedure ends with the endoscope outside again."),
        Row::list(
            "landmarks", {0, 16}, landmarkRows(), "A place on the bladder's sphere.", "a key of a landmark",
            &Parameters::landmarks,
            "Places of the bladder's wall that have to be inspected after the insertion, in any order."),
        Row::number("landmark_half_angle_deg", units::kDeg, {2, 45}, &Parameters::landmarkHalfAngle_rad,
                    "A landmark counts as looked at within this angle of the view's middle ..."),
        Row::number("landmark_distance_mm", units::kMm, {5, 160}, &Parameters::landmarkDistance_m,
                    "... and nearer to the tip than this ..."),
        Row::number("landmark_hold_s", units::kS, {0.1, 10}, &Parameters::landmarkHold_s,
                    "... for so long without a break ..."),
        Row::number("landmark_speed_mm_per_s", units::kMm_per_s, {0.5, 50},
                    &Parameters::landmarkSpeed_m_per_s, "... with the tip no faster than this, over 0.1 s."),
        Row::number("trial_limit_s", units::kS, {5, 1800}, &Parameters::trialLimit_s,
                    "After it the procedure ends unfinished."),
        Row::number("maximum_force_N", units::kN, {0.5, 4.5}, &Parameters::maximumForce_N,
                    "The exercise's force cap for the supervisor and the limit of the over-the-limit "
                    "metrics; P1's device gives 4.5 N."),
        Row::number("maximum_torque_mN_m", units::kMilliNm, {10, 150}, &Parameters::maximumTorque_Nm,
                    "The exercise's torque cap for the supervisor; P1's device gives 150 mN·m."),
        Row::number("lateral_limit_N", units::kN, {0.2, 4.5}, &Parameters::lateralLimit_N,
                    "A force across the canal above this for 20 ms counts as a trauma: all tissue force but "
                    "its part along the canal, friction on a tilted shaft included. Assumption: half of the "
                    "exercise's force cap; no measured limit of injury is known to us."),
        Row::flag("depth_of_field", &Parameters::depthOfField,
                  "The picture begins with the depth of field of a real lens: what is nearer or farther is "
                  "out of focus."),
        Row::flag("depth_of_field_fixed", &Parameters::depthOfFieldFixed, "It cannot be switched.")};
    return kRows;
}

/// Puts the local changes into the anatomy's places.
void place(const std::vector<Change>& changes, const ObjectReader& parameters, Anatomy& anatomy) {
    const QString path = memberPath(parameters.path(), "local_changes");
    for (std::size_t i = Anatomy::kMaxChanges; i < changes.size(); ++i)
        parameters.problems().push_back({elementPath(path, static_cast<qsizetype>(i)),
                                         QStringLiteral("one too many"),
                                         QStringLiteral("at most %1").arg(Anatomy::kMaxChanges)});
    anatomy.changeCount = std::min(changes.size(), Anatomy::kMaxChanges);
    std::copy_n(changes.begin(), anatomy.changeCount, anatomy.changes.begin());
}

} // namespace

QByteArray urethraInsertionSchema() {
    return parametersSchema({"Parameters of urethra_insertion",
                             "A rigid endoscope through the male urethra into the bladder (models.md §1, "
                             "P1). Numbers without a source are assumptions and say so."},
                            rows());
}

ExerciseParameters readUrethraInsertion(const ObjectReader& parameters,
                                        const std::vector<std::string>& cues) {
    Draft draft;
    readParameters(rows(), parameters, QStringLiteral("a parameter of urethra_insertion"), draft);
    place(draft.changes, parameters, draft.anatomy);
    draft.cues = cues;
    return ExerciseParameters(Parameters(std::move(draft)));
}

} // namespace chiron::catalogue
