// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "psychophysics/procedures/constant_stimuli.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/usual_levels.h"

#include <algorithm>

namespace chiron::psychophysics {

namespace {

std::vector<Parameter> constantRows() {
    using Spec = ConstantSpec;
    return {
        rowOf(&Spec::repeats,
              {.key = "repeats",
               .minimum = 1,
               .maximum = 1e6,
               .description = "presentations of each level.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Trials per level"),
               .meaning = QT_TRANSLATE_NOOP("Procedures", "How often each level is presented."),
               .usual = UsualValue{20}}),
        rowOf(&Spec::shuffled,
              {.key = "shuffled",
               .description = "in blocks of one of each level, shuffled; false: in the order given.",
               .title = QT_TRANSLATE_NOOP("Procedures", "In random order"),
               .meaning = QT_TRANSLATE_NOOP("Procedures", "Levels come in random order, each once in every "
                                                          "block; otherwise in the order of the table.")}),
        rowOf(&Spec::levels,
              {.key = "levels",
               .unit = "x",
               .quantity = Quantity::level,
               .minimum = -kUnbounded,
               .fewest = 1,
               .most = 65536,
               .description = "the levels.",
               .inTable = true,
               .title = QT_TRANSLATE_NOOP("Procedures", "Levels"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "What is presented. Levels must lie within the table of differences.")})};
}

class ConstantKind final : public ProcedureKindOf<ConstantSpec> {
public:
    ConstantKind()
        : ProcedureKindOf(
              {QT_TRANSLATE_NOOP("Procedures", "Constant stimuli"),
               QT_TRANSLATE_NOOP("Procedures", "Presents every difference equally often, in random order. "
                                               "Measures the whole curve, but needs many trials.")},
              constantRows()) {}

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return checkedFactory(
            [of = ours(spec)](std::uint64_t seed) { return ConstantStimuli::make(of, seed); });
    }

    ProcedureSpec usual(const Condition& condition) const override {
        ConstantSpec spec;
        spec.levels = someOf(usualLevels(condition), 7);
        return spec;
    }

    bool drives(Task) const override { return true; } // it does not depend on outcomes
    int recommended(Task task) const override {
        if (isForcedChoice(task))
            return 2;
        return ranksThree(task) ? 1 : 4;
    }
    bool trialsAreFixed() const override { return true; }
    bool endAfter(ProcedureSpec& spec, int trials) const override {
        ConstantSpec& constant = std::get<ConstantSpec>(spec);
        constant.repeats = std::max(1, trials / std::max(1, static_cast<int>(constant.levels.size())));
        return true;
    }
};

} // namespace

const ProcedureKind& ConstantSpec::kind() {
    static const ConstantKind kind;
    return kind;
}

} // namespace chiron::psychophysics
