// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "psychophysics/procedures/pest.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/usual_levels.h"

namespace chiron::psychophysics {

namespace {

std::vector<Parameter> pestRows() {
    using Spec = PestSpec;
    std::vector<Parameter> rows{
        rowOf(&Spec::start,
              {.key = "start",
               .unit = "x",
               .quantity = Quantity::level,
               .minimum = -kUnbounded,
               .description = "the first level, from minimum to maximum.",
               .title = QT_TRANSLATE_NOOP("Procedures", "First difference"),
               .meaning = QT_TRANSLATE_NOOP("Procedures",
                                            "Where the run begins: large enough to be felt by everybody.")}),
        rowOf(&Spec::target,
              {.key = "target",
               .quantity = Quantity::share,
               .maximum = 1,
               .description = "proportion right that the threshold is defined by.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Target share of right answers"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "The run looks for the difference at which this share of the answers is right."),
               .usual = UsualValue{75}}),
        rowOf(&Spec::waldDeviation,
              {.key = "wald_deviation",
               .maximum = 1000,
               .description = "a step once right answers are off by more than this.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Tolerated deviation"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "A level ends once the number of right answers differs from the expected "
                   "one by more than this. Larger values take longer and make the decision more reliable."),
               .usual = UsualValue{1},
               .field = FieldRange{0.1, 10, 2, 0.1}}),
        rowOf(&Spec::step,
              {.key = "step",
               .unit = "x",
               .quantity = Quantity::spread,
               .description = "first step.",
               .title = QT_TRANSLATE_NOOP("Procedures", "First step"),
               .meaning = QT_TRANSLATE_NOOP("Procedures", "How far the difference changes at first.")}),
        rowOf(&Spec::smallestStep,
              {.key = "smallest_step",
               .unit = "x",
               .quantity = Quantity::spread,
               .description = "a step no larger than this is the last.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Smallest step"),
               .meaning =
                   QT_TRANSLATE_NOOP("Procedures", "The run ends when a step would be as small as this.")}),
        rowOf(&Spec::largestStep,
              {.key = "largest_step",
               .unit = "x",
               .quantity = Quantity::spread,
               .description = "steps double up to this.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Largest step"),
               .meaning = QT_TRANSLATE_NOOP("Procedures", "Steps never grow beyond this.")}),
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
    addStopRows<Spec>(rows, {.reversals = true});
    return rows;
}

class PestKind final : public ProcedureKindOf<PestSpec> {
public:
    PestKind()
        : ProcedureKindOf(
              {QT_TRANSLATE_NOOP("Procedures", "PEST"),
               QT_TRANSLATE_NOOP("Procedures",
                                 "A sequential test halves and doubles the steps. For replications only.")},
              pestRows()) {}

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return checkedFactory([of = ours(spec)](std::uint64_t) { return Pest::make(of); });
    }

    ProcedureSpec usual(const Condition& condition) const override {
        const std::vector<double> levels = usualLevels(condition);
        PestSpec spec;
        spec.start = spec.maximum = levels.back();
        spec.minimum = levels.front();
        return spec;
    }

    bool drives(Task task) const override { return isRightOrWrong(task); }
    int recommended(Task task) const override { return isForcedChoice(task) ? 1 : 0; }
};

} // namespace

const ProcedureKind& PestSpec::kind() {
    static const PestKind kind;
    return kind;
}

} // namespace chiron::psychophysics
