// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/exercises/palpation/catalogue/palpation_content.h"

#include "catalogue/tissue_content.h"
#include "catalogue/yield_content.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <utility>

namespace chiron::catalogue {

namespace {

using Parameters = simulation::PalpationParameters;
using Control = simulation::PalpationControl;
using simulation::LumpKind;

/// The parameters while they are read: `pinch` is made of a yes or no and of its numbers.
struct Draft : Parameters {
    bool pinches = false;
    simulation::PinchParameters jaws;
};
using Row = ParameterRow<Draft>;

const std::vector<ParameterRow<LumpKind>>& lumpRows() {
    using Item = ParameterRow<LumpKind>;
    static const std::vector<Item> kRows{
        Item::number("radius_mm", units::kMm, {2, 20}, &LumpKind::radius_m, "Radius R of the ball."),
        Item::number("depth_mm", units::kMm, {3, 40}, &LumpKind::depth_m, "Of its middle below the surface."),
        Item::number("ratio", units::kPure, {1, 50}, &LumpKind::ratio,
                     "Its modulus over the tissue's; 1 cannot be felt. Real tumours have 2.1 to 2.5 "
                     "(prostate); lumps to train with are far stiffer."),
        Item::whole("hardness", {1, 5}, &LumpKind::hardness,
                    "What a person should call it, 1 soft to 5 stony.")};
    return kRows;
}

/// The parameters of a level, in the order of the schema.
const std::vector<Row>& rows() {
    static const std::vector<Row> kRows{
        Row::reference("tissue", kNamedTissue, readTissue, "pad", &Parameters::tissue,
                       "What is palpated: a tissue of content/tissues, and what differs from it."),
        Row::list("lump_kinds", {1, 12}, lumpRows(), "One kind of lump.", "a number of a lump",
                  &Parameters::kinds, "What a lump may be; each lump draws one, all alike likely."),
        Row::whole("lumps_low", {0, 6}, &Parameters::lumpsLow,
                   "A trial that is no catch trial has at least this many lumps."),
        Row::whole("lumps_high", {0, 6}, &Parameters::lumpsHigh, "And at most this many."),
        Row::whole("catch_trials", {0, 31}, &Parameters::catchTrials,
                   "This many of the trials have no lump; which ones is drawn.")
            .withDefault(1),
        Row::flag("lump_first", &Parameters::lumpFirst,
                  "The first trial has a lump, whatever is drawn: for levels that teach. It is marked as an "
                  "introduction and left out of d', c and the ROC."),
        Row::number("depth_spread_mm", units::kMm, {0, 5}, &Parameters::depthSpread_m,
                    "A lump's depth is its kind's, this more or less."),
        Row::number("spacing_mm", units::kMm, {5, 100}, &Parameters::spacing_m,
                    "From lump to lump, and from a distractor's middle, at least."),
        Row::number(
            "area_half_x_mm", units::kMm, {10, 100}, [](Draft& p) -> double& { return p.areaHalf_m.x(); },
            "The search area goes so far along x, either way."),
        Row::number(
            "area_half_y_mm", units::kMm, {10, 100}, [](Draft& p) -> double& { return p.areaHalf_m.y(); },
            "And so far along y."),
        Row::whole(
            "region_columns", {1, 10}, &Parameters::regionColumns,
            "The search area is divided for d': each region either holds a lump or does not. Along x."),
        Row::whole("region_rows", {1, 10}, &Parameters::regionRows, "Along y."),
        Row::number("hit_radius_mm", units::kMm, {2, 40}, &Parameters::hitRadius_m,
                    "A mark so near to the place above a lump found it (or within the lump's radius, if that "
                    "is more)."),
        Row::number("band_low_N", units::kN, {0.05, 4}, &Parameters::bandLow_N,
                    "How hard to press, at least."),
        Row::number("band_high_N", units::kN, {0.1, 4.5}, &Parameters::bandHigh_N, "And at most."),
        Row::number("cover_force_N", units::kN, {0.05, 4}, &Parameters::coverForce_N,
                    "A spot that was pressed so hard counts as searched."),
        Row::flag("asks_size", &Parameters::asksSize, "The trainee is to tell the size of each finding."),
        Row::flag("asks_hardness", &Parameters::asksHardness,
                  "The trainee is to tell how hard each finding is."),
        Row::flag("asks_confidence", &Parameters::asksConfidence,
                  "The trainee is to tell how certain each finding is."),
        Row::whole("hands", {1, 2}, &Parameters::hands, "P3: an arm for each hand."),
        Row::whole("fingers", {1, 2}, &Parameters::fingers,
                   "Of each hand: the index, or index and middle side by side."),
        Row::number("finger_spacing_mm", units::kMm, {10, 30}, &Parameters::fingerSpacing_m,
                    "From finger to finger of one hand."),
        Row::whole("trials", {1, 32}, &Parameters::trials, "One after the other."),
        Row::number("trial_limit_s", units::kS, {5, 600}, &Parameters::trialLimit_s,
                    "After it a trial ends with what was reported by then."),
        Row::number("between_trials_s", units::kS, {0.001, 30}, &Parameters::betweenTrials_s,
                    "Pause between two trials, without tissue."),
        Row::number("maximum_force_N", units::kN, {0.5, 4.5}, &Parameters::maximumForce_N,
                    "The exercise's force cap for the supervisor and the limit of the over-the-limit "
                    "metrics. The lump's law is valid down to the depth at which the tissue gives it."),
        yieldForceRow<Draft>(
            13.5, "The tissue gives way under a finger that is pressed harder: a critical error. More than "
                  "maximum_force_N and at most three times that; 0: it never gives way."),
        yieldFallRow<Draft>("How long the force takes to fall to nothing when the tissue gives way."),
        Row::flag("pinch", &Draft::pinches,
                  "The jaws of a hand's first finger squeeze the tissue that came between them while they "
                  "were open (P3's grasping); only where the device has a jaw."),
        Row::number("jaw_length_mm", units::kMm, {5, 60},
                    within(&Draft::jaws, &simulation::PinchParameters::jawLength_m),
                    "Length of these jaws, from the joint to the tips."),
        Row::number("jaw_friction", units::kPure, {0, 1},
                    within(&Draft::jaws, &simulation::PinchParameters::friction),
                    "Coulomb friction of each jaw on the tissue: what is held pulls at the tool with twice "
                    "that times the squeeze at most."),
        Row::flag("control_force_off", within(&Parameters::control, &Control::forceOff),
                  "Research: the tissue answers nothing, so that nothing can be found."),
        Row::number("control_move_after_s", units::kS, {0, 600},
                    within(&Parameters::control, &Control::moveAfter_s),
                    "Research: above 0, all lumps move so long after their trial began, when no finger "
                    "touches; their truth is then the new place."),
        Row::number(
            "control_move_x_mm", units::kMm, {-200, 200},
            [](Draft& p) -> double& { return p.control.move_m.x(); }, "By so much along x."),
        Row::number(
            "control_move_y_mm", units::kMm, {-200, 200},
            [](Draft& p) -> double& { return p.control.move_m.y(); }, "By so much along y.")};
    return kRows;
}

} // namespace

QByteArray palpationSchema() {
    return parametersSchema({"Parameters of palpation",
                             "Lumps in a tissue, to be found by pressing (P3; models.md §3).",
                             JsonLayout::itemPerLine},
                            rows());
}

ExerciseParameters readPalpation(const ObjectReader& parameters, const std::vector<std::string>& cues) {
    Draft draft;
    readParameters(rows(), parameters, QStringLiteral("a parameter of palpation"), draft);
    if (draft.pinches)
        draft.pinch = draft.jaws;
    draft.cues = cues;
    return ExerciseParameters(Parameters(std::move(draft)));
}

} // namespace chiron::catalogue
