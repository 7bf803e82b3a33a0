// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/staircase.h"
#include "psychophysics/procedures/usual_levels.h"

#include <array>

namespace chiron::psychophysics {

namespace {

constexpr std::array<std::string_view, 3> kStepTypes{"linear", "log", "db"}; // in the order of StepType

Parameter stepTypeRow() {
    Parameter row{.key = "step_type", .description = "linear x + s; log x * 10^s; db x * 10^(s/20)."};
    for (const std::string_view word : kStepTypes)
        row.words.push_back({word});
    row.get = [](const ProcedureSpec& spec) -> ParameterValue {
        return std::string(kStepTypes[static_cast<std::size_t>(std::get<StaircaseSpec>(spec).stepType)]);
    };
    row.set = [](ProcedureSpec& spec, const ParameterValue& value) {
        for (std::size_t i = 0; i < kStepTypes.size(); ++i)
            if (kStepTypes[i] == std::get<std::string>(value))
                std::get<StaircaseSpec>(spec).stepType = static_cast<StaircaseSpec::StepType>(i);
    };
    return row;
}

bool hasLogarithmicSteps(const ProcedureSpec& spec) {
    return std::get<StaircaseSpec>(spec).stepType != StaircaseSpec::StepType::linear;
}
bool listsStepsDown(const ProcedureSpec& spec) {
    return std::get<StaircaseSpec>(spec).stepRatio <= 0.0;
}

std::vector<Parameter> staircaseRows() {
    using Spec = StaircaseSpec;
    std::vector<Parameter> rows{
        rowOf(&Spec::start,
              {.key = "start",
               .unit = "x",
               .quantity = Quantity::level,
               .minimum = -kUnbounded,
               .description = "the first level, from minimum to maximum where truncate is true.",
               .title = QT_TRANSLATE_NOOP("Procedures", "First difference"),
               .meaning =
                   QT_TRANSLATE_NOOP("Procedures", "Where the run begins: large enough to be felt by "
                                                   "everybody. It must lie in the table of differences.")}),
        rowOf(&Spec::down,
              {.key = "down",
               .minimum = 1,
               .maximum = 100,
               .description = "consecutive right answers before a step down.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Right answers for a step down"),
               .meaning = QT_TRANSLATE_NOOP("Procedures",
                                            "After this many right answers in a row the next trial is "
                                            "harder; with 3 the run converges at about 80 % right answers."),
               .usual = UsualValue{3}}),
        rowOf(&Spec::up,
              {.key = "up",
               .minimum = 1,
               .maximum = 100,
               .description = "consecutive wrong answers before a step up.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Wrong answers for a step up"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "After this many wrong answers in a row the next trial is easier."),
               .usual = UsualValue{1}}),
        rowOf(&Spec::stepRatio,
              {.key = "step_ratio",
               .quantity = Quantity::share,
               .maximum = 1000,
               .description = "above 0, a step down is the step up times this (Garcia-Perez 1998: 0.2845, "
                              "0.5488, 0.7393, 0.8415 for down 1 to 4; "
                              "Kaernbach 1991: down 1, p = 1/(1+ratio)).",
               .title = QT_TRANSLATE_NOOP("Procedures", "Step down as a share of a step up"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "Steps down are usually smaller than steps up, so that the run converges: "
                                 "73.93 % for three right answers (García-Pérez 1998)."),
               .zero = QT_TRANSLATE_NOOP("Procedures", "as listed"),
               .field = FieldRange{0, 1000, 2, 1}}),
        rowOf(
            &Spec::estimateReversals,
            {.key = "estimate_reversals",
             .minimum = 2,
             .maximum = 10000,
             .description = "the estimate is the mean of this many last reversals, made even.",
             .title = QT_TRANSLATE_NOOP("Procedures", "Reversals averaged"),
             .meaning = QT_TRANSLATE_NOOP("Procedures", "How many of the last reversals are averaged for the "
                                                        "staircase's own estimate; the fit uses all trials."),
             .usual = UsualValue{6}})};
    addStopRows<Spec>(rows, {.reversals = true, .reversalsAndTrials = true, .asksReversals = true});
    std::vector<Parameter> rest{
        rowOf(&Spec::stepsUp,
              {.key = "steps_up",
               .unit = "x",
               .quantity = Quantity::spread,
               .minimum = 1e-12,
               .fewest = 1,
               .description = "size of steps up, by the number of reversals so far; the last one is kept.",
               .item = "A step.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Steps up"),
               .meaning = QT_TRANSLATE_NOOP("Procedures",
                                            "The first step is used until the first reversal, then the next "
                                            "one after each reversal; the last one stays in use."),
               .asStored = hasLogarithmicSteps}),
        rowOf(&Spec::stepsDown, {.key = "steps_down",
                                 .unit = "x",
                                 .quantity = Quantity::spread,
                                 .minimum = 1e-12,
                                 .description = "the same of steps down.",
                                 .item = "A step.",
                                 .byDefault = "[]: as steps_up",
                                 .title = QT_TRANSLATE_NOOP("Procedures", "Steps down"),
                                 .meaning = QT_TRANSLATE_NOOP(
                                     "Procedures", "In the same order as the steps up. Without an entry, the "
                                                   "steps down are as large as the steps up."),
                                 .applies = listsStepsDown,
                                 .asStored = hasLogarithmicSteps}),
        rowOf(&Spec::initialOneUpOneDown,
              {.key = "initial_one_up_one_down",
               .description = "every answer steps until the first reversal.",
               .title = QT_TRANSLATE_NOOP("Procedures", "One up, one down at first"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "Until the first reversal a single right answer makes the next trial "
                                 "harder, so that the run gets near the threshold sooner.")}),
        rowOf(&Spec::resetCounters,
              {.key = "reset_counters",
               .description = "consecutive answers are counted afresh after each step.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Start counting again after each step"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "After each step, right and wrong answers are counted from zero.")}),
        rowOf(&Spec::newStepAtReversal,
              {.key = "new_step_at_reversal",
               .description = "the step that makes a reversal has the new size already.",
               .title = QT_TRANSLATE_NOOP("Procedures", "New step size at the reversal"),
               .meaning = QT_TRANSLATE_NOOP("Procedures",
                                            "The step that makes the reversal already has the new size.")}),
        rowOf(&Spec::truncate,
              {.key = "truncate",
               .description = "the level itself stops at minimum and maximum; false: only what is presented.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Stay within the table"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "The run never asks for differences beyond the smallest and largest.")}),
        stepTypeRow(),
        rowOf(&Spec::minimum, {.key = "minimum",
                               .unit = "x",
                               .quantity = Quantity::level,
                               .minimum = -kUnbounded,
                               .description = "never presented below.",
                               .byDefault = "none"}),
        rowOf(&Spec::maximum, {.key = "maximum",
                               .unit = "x",
                               .quantity = Quantity::level,
                               .minimum = -kUnbounded,
                               .description = "never presented above.",
                               .byDefault = "none"})};
    for (Parameter& row : rest)
        rows.push_back(std::move(row));
    return rows;
}

class StaircaseKind final : public ProcedureKindOf<StaircaseSpec> {
public:
    StaircaseKind()
        : ProcedureKindOf({QT_TRANSLATE_NOOP("Procedures", "Staircase (up–down)"),
                           QT_TRANSLATE_NOOP("Procedures", "Gets harder after right answers and easier after "
                                                           "wrong ones. Robust and easy to explain.")},
                          staircaseRows()) {}

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return checkedFactory([of = ours(spec)](std::uint64_t) { return Staircase::make(of); });
    }

    /// Returns a 1-up/3-down staircase with García-Pérez's ratio of steps, which converges at 83.15 %.
    ProcedureSpec usual(const Condition& condition) const override {
        constexpr double kRatioOfThreeDown = 0.7393;
        const std::vector<double> levels = usualLevels(condition);
        StaircaseSpec spec;
        spec.start = levels.back();
        spec.stepRatio = kRatioOfThreeDown;
        spec.minimum = levels.front();
        spec.maximum = levels.back();
        return spec;
    }

    bool drives(Task task) const override { return isRightOrWrong(task); }
    int recommended(Task task) const override {
        return isForcedChoice(task) ? 4 : isRightOrWrong(task) ? 1 : 0;
    }
};

} // namespace

const ProcedureKind& StaircaseSpec::kind() {
    static const StaircaseKind kind;
    return kind;
}

} // namespace chiron::psychophysics
