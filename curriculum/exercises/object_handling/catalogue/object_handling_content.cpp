// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/object_handling/catalogue/object_handling_content.h"

#include "catalogue/object_content.h"
#include "catalogue/yield_content.h"
#include "modules/exercises/object_handling/simulation/object_handling_parameters.h"

#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ObjectHandlingParameters;
using Row = ParameterRow<Parameters>;
using simulation::HandlingTask;

/// The parameters of a level, in the order of the schema.
const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        Row::choice<HandlingTask>("task", {{"place", HandlingTask::place}, {"weigh", HandlingTask::weigh}},
                                  &Parameters::task,
                                  "place: lift the object and set it down in the target; weigh: of several "
                                  "that look alike, set the heaviest down there (P2's mass study)."),
        Row::reference("object", kNamedObject, readObject, "ovary", &Parameters::object,
                       "What is handled: an object of content/objects, and what differs from it."),
        Row::reference("bed", kNamedObject, readObject, "plane", &Parameters::bed, "What it lies on."),
        Row::flag("organ_bed", &Parameters::organBed,
                  "The bed is a deformable organ, simulated at the slow rate beside the force loop (P2, two "
                  "rates)."),
        Row::reference("bed_mesh", kNamedMesh, readMesh, "organ", &Parameters::bedMesh, "Of the organ."),
        Row::number("bed_rate_Hz", {"Hz"}, {30, 50}, &Parameters::bedRate_Hz,
                    "How often the organ is simulated."),
        Row::whole("bed_latency_ticks", {20, 33}, &Parameters::bedLatency_ticks,
                   "An answer of the organ's model takes effect this many ticks of 1 ms after it was asked "
                   "for, and is blended in over as many: at most one period of bed_rate_Hz."),
        Row::whole("objects", {1, 3}, &Parameters::objects, "How many objects lie on the bed."),
        Row::number("mass_low_g", units::kG, {0, 200}, &Parameters::massLow_kg,
                    "Each object of a trial draws its mass uniformly between low and high; both 0: the "
                    "object's own."),
        Row::number("mass_high_g", units::kG, {0, 200}, &Parameters::massHigh_kg, "Upper end of a mass."),
        Row::number("mass_ratio", units::kPure, {1.05, 5}, &Parameters::massRatio,
                    "weigh: the heaviest is at least this many times as heavy as the next."),
        Row::number("radius_mm", units::kMm, {4, 16}, &Parameters::radius_m,
                    "Of the object, half its thickness between the jaws; an ovary is about 30 x 20 x 15 mm. "
                    "Assumption."),
        Row::number("places_radius_mm", units::kMm, {10, 60}, &Parameters::placesRadius_m,
                    "Objects and target are drawn in this disc round the middle of the field."),
        Row::number("target_radius_mm", units::kMm, {4, 40}, &Parameters::targetRadius_m,
                    "An object whose middle is within it lies in the target."),
        Row::number("squeeze_limit_N", units::kN, {0.1, 10}, &Parameters::squeezeLimit_N,
                    "Grip force of each jaw beyond which the tissue counts as crushed; no measured limit for "
                    "an ovary is known to us. Assumption."),
        Row::number("jaw_length_mm", units::kMm, {8, 40}, &Parameters::jawLength_m,
                    "From the joint of the jaws to their tips."),
        Row::number("grasp_reach_mm", units::kMm, {0, 15}, &Parameters::graspReach_m,
                    "How near to the object's surface the tip has to be to take hold of it."),
        Row::number("release_clearance_mm", units::kMm, {0.2, 8}, &Parameters::releaseClearance_m,
                    "The jaws let go when they are so much wider than the object, and have to be opened as "
                    "wide before they can take hold."),
        Row::number("lift_height_mm", units::kMm, {2, 80}, &Parameters::liftHeight_m,
                    "How high it has to be lifted on the way."),
        Row::number("drop_speed_mm_per_s", units::kMm_per_s, {20, 1000}, &Parameters::dropSpeed_m_per_s,
                    "An object that was let go and strikes the bed faster counts as dropped; 150 mm/s: 1.1 "
                    "mm of fall."),
        Row::number("hold_s", units::kS, {0.1, 10}, &Parameters::hold_s,
                    "How long it has to lie at rest in the target, let go."),
        Row::whole("trials", {1, 32}, &Parameters::trials, "Objects to handle, one after the other."),
        Row::number("trial_limit_s", units::kS, {5, 600}, &Parameters::trialLimit_s,
                    "After it a trial ends unfinished."),
        Row::number("between_trials_s", units::kS, {0.001, 30}, &Parameters::betweenTrials_s,
                    "Pause between two trials, without objects."),
        Row::number(
            "maximum_force_N", units::kN, {0.5, 4.5}, &Parameters::maximumForce_N,
            "The exercise's force cap for the supervisor and the limit of the over-the-limit metrics."),
        yieldForceRow<Parameters>(),
        yieldFallRow<Parameters>()};
    return kRows;
}

} // namespace

QByteArray objectHandlingSchema() {
    return parametersSchema(
        {"Parameters of object_handling",
         "Loose objects on a bed, to be lifted, weighed and placed (P2; models.md §2.2)."},
        rows());
}

ExerciseParameters readObjectHandling(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    readParameters(rows(), parameters, QStringLiteral("a parameter of object_handling"), p);
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

} // namespace chiron::catalogue
