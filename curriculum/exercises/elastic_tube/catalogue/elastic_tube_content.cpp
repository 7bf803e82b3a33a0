// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/elastic_tube/catalogue/elastic_tube_content.h"

#include "catalogue/object_content.h"
#include "catalogue/yield_content.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"

#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::ElasticTubeParameters;
using Row = ParameterRow<Parameters>;
using simulation::TubeTask;

/// The parameters of a level, in the order of the schema.
const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        Row::choice<TubeTask>(
            "task",
            {{"hold", TubeTask::hold},
             {"stretch", TubeTask::stretch},
             {"two_handed", TubeTask::twoHanded},
             {"transfer", TubeTask::transfer}},
            &Parameters::task,
            "hold: one hand keeps a tension in a band; stretch: to the mark, not to the tear; two_handed: a "
            "tube that nothing else holds, between two graspers; transfer: the free end goes from the right "
            "hand to the left one and on to a target."),
        Row::reference("tube", kNamedObject, readObject, "fallopian_tube", &Parameters::tube,
                       "The tube: elasticity, strain stiffening and viscosity of its whole length, recovery "
                       "of what is let go; its mass is neglected (P2)."),
        Row::number("stiffness_low_N_per_m", units::kN_per_m, {0, 500}, &Parameters::stiffnessLow_N_per_m,
                    "Each trial draws the tube's small-strain stiffness uniformly between low and high; both "
                    "0: the object's own."),
        Row::number("stiffness_high_N_per_m", units::kN_per_m, {0, 500}, &Parameters::stiffnessHigh_N_per_m,
                    "Upper end of a trial's stiffness."),
        Row::number("rest_length_mm", units::kMm, {20, 100}, &Parameters::restLength_m,
                    "Of the whole tube when slack."),
        Row::number("radius_mm", units::kMm, {0.5, 8}, &Parameters::radius_m, "Of the tube as it is drawn."),
        Row::number("base_x_mm", units::kMm, {-60, 60}, &Parameters::baseX_m,
                    "Where the tube is fixed to the floor; two_handed: the middle of where it lies."),
        Row::number("base_y_mm", units::kMm, {-60, 60}, &Parameters::baseY_m,
                    "As base_x_mm, to the far side."),
        Row::number("base_spread_mm", units::kMm, {0, 40}, &Parameters::baseSpread_m,
                    "Each trial draws that place uniformly in a disc of this radius round it."),
        Row::number("tear_ratio", units::kPure, {1.1, 4}, &Parameters::tearRatio,
                    "The tube tears beyond this length over its rest length. Assumption."),
        Row::number("over_stretch_ratio", units::kPure, {1.05, 4}, &Parameters::overStretchRatio,
                    "Beyond this length over rest length an over-stretch is counted."),
        Row::number("target_low_N", units::kN, {0.1, 5}, &Parameters::targetLow_N,
                    "hold, two_handed: each trial draws its target tension uniformly between low and high."),
        Row::number("target_high_N", units::kN, {0.1, 5}, &Parameters::targetHigh_N,
                    "Upper end of a trial's target."),
        Row::number("band_N", units::kN, {0.02, 2}, &Parameters::band_N,
                    "Half the width of the band about the target."),
        Row::number("mark_ratio", units::kPure, {1.02, 3}, &Parameters::markRatio,
                    "stretch: the mark, as length over rest length."),
        Row::number(
            "mark_tolerance", units::kPure, {0.005, 0.3}, &Parameters::markTolerance,
            "stretch: how far from the mark counts as at it, either way, as share of the rest length."),
        Row::number("target_x_mm", units::kMm, {-80, 80}, &Parameters::targetX_m,
                    "transfer: where the free end is brought."),
        Row::number("target_y_mm", units::kMm, {-80, 80}, &Parameters::targetY_m,
                    "transfer: as target_x_mm, to the far side."),
        Row::number("target_z_mm", units::kMm, {0, 100}, &Parameters::targetZ_m,
                    "transfer: as target_x_mm, above the floor."),
        Row::number("target_radius_mm", units::kMm, {2, 30}, &Parameters::targetRadius_m,
                    "transfer: how near to that place the free end has to be."),
        Row::number("grip_share", units::kPure, {0.3, 0.95}, &Parameters::gripShare,
                    "transfer: where the second hand may grip, as share of the rest length from the base."),
        Row::number("hold_s", units::kS, {0.2, 30}, &Parameters::hold_s,
                    "How long the tension, the mark or the target is held."),
        Row::number("grasp_reach_mm", units::kMm, {1, 20}, &Parameters::graspReach_m,
                    "How near to the tube's end, or place to grip, the tip has to be to take hold."),
        Row::number("grasp_angle_deg", units::kDeg, {1, 60}, &Parameters::graspAngle_rad,
                    "The jaw takes hold when it closes to this angle.")
            .withDefault(11.5),
        Row::number("release_angle_deg", units::kDeg, {2, 80}, &Parameters::releaseAngle_rad,
                    "The jaw lets go when it opens to this angle.")
            .withDefault(20),
        Row::number("instruments_apart_mm", units::kMm, {40, 200}, &Parameters::instrumentsApart_m,
                    "two_handed, transfer: between the two entry points, along x."),
        Row::number("fold_stiffness_N_per_m", units::kN_per_m, {0, 200}, &Parameters::foldStiffness_N_per_m,
                    "A fold of tissue lies over the tube, and one more instrument has to hold it back: by "
                    "how much its pull grows over the way that its edge is drawn. 0: none."),
        Row::number("retraction_low_N", units::kN, {0.1, 5}, &Parameters::retractionLow_N,
                    "With a fold: held back with this pull, the tube can be reached; below 80 % of it the "
                    "fold lies over the tube again."),
        Row::number("retraction_high_N", units::kN, {0.2, 10}, &Parameters::retractionHigh_N,
                    "With a fold: pulled harder than this, the tissue suffers."),
        Row::whole("trials", {1, 32}, &Parameters::trials, "In a set."),
        Row::number("trial_limit_s", units::kS, {5, 600}, &Parameters::trialLimit_s,
                    "After it a trial ends undone."),
        Row::number("between_trials_s", units::kS, {0, 30}, &Parameters::betweenTrials_s,
                    "From the end of a trial to the next tube."),
        Row::number(
            "maximum_force_N", units::kN, {0.5, 10}, &Parameters::maximumForce_N,
            "The exercise's force cap for the supervisor, and the limit of the over-the-limit metrics."),
        yieldForceRow<Parameters>(),
        yieldFallRow<Parameters>()};
    return kRows;
}

} // namespace

QByteArray elasticTubeSchema() {
    return parametersSchema(
        {"Parameters of elastic_tube",
         "A massless elastic tube, fixed to the floor or held between two graspers (P2 \"Elastic Tube "
         "Model\", models.md §2.4). Numbers without a source are assumptions."},
        rows());
}

ExerciseParameters readElasticTube(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Parameters p;
    readParameters(rows(), parameters, QStringLiteral("a parameter of elastic_tube"), p);
    p.cues = cues;
    return ExerciseParameters(std::move(p));
}

} // namespace chiron::catalogue
