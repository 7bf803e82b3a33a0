// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "psychophysics/procedures/descending.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/usual_levels.h"

#include <algorithm>

namespace chiron::psychophysics {

namespace {

std::vector<Parameter> descendingRows() {
    using Spec = DescendingSpec;
    return {rowOf(&Spec::repeats,
                  {.key = "repeats",
                   .minimum = 1,
                   .maximum = 1e6,
                   .description = "presentations of a level before it is judged.",
                   .title = QT_TRANSLATE_NOOP("Procedures", "Presentations per level"),
                   .meaning = QT_TRANSLATE_NOOP(
                       "Procedures", "How often each level is presented before the run goes on or ends."),
                   .usual = UsualValue{3}}),
            rowOf(&Spec::passes,
                  {.key = "passes",
                   .minimum = 1,
                   .maximum = 1e6,
                   .description = "right answers of a level's presentations that are needed to go on.",
                   .title = QT_TRANSLATE_NOOP("Procedures", "Right answers to go on"),
                   .meaning = QT_TRANSLATE_NOOP("Procedures",
                                                "With fewer right answers at a level the run ends there."),
                   .usual = UsualValue{2}}),
            rowOf(&Spec::levels,
                  {.key = "levels",
                   .unit = "x",
                   .quantity = Quantity::level,
                   .minimum = -kUnbounded,
                   .fewest = 1,
                   .most = 65536,
                   .description = "the levels, largest first.",
                   .inTable = true,
                   .title = QT_TRANSLATE_NOOP("Procedures", "Levels"),
                   .meaning = QT_TRANSLATE_NOOP(
                       "Procedures", "What is presented, from the largest to the smallest difference.")})};
}

class DescendingKind final : public ProcedureKindOf<DescendingSpec> {
public:
    DescendingKind()
        : ProcedureKindOf({QT_TRANSLATE_NOOP("Procedures", "Descending ranking (legacy)"),
                           QT_TRANSLATE_NOOP("Procedures",
                                             "The difference shrinks until an answer is wrong. The resulting "
                                             "JND is 1.5 to 3 times too large; for replications only."),
                           true},
                          descendingRows()) {}

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return checkedFactory([of = ours(spec)](std::uint64_t) { return Descending::make(of); });
    }

    ProcedureSpec usual(const Condition& condition) const override {
        DescendingSpec spec;
        spec.levels = someOf(usualLevels(condition), 12);
        std::reverse(spec.levels.begin(), spec.levels.end());
        return spec;
    }

    std::vector<std::string_view> runIds() const override { return {"descending_legacy"}; }
    bool drives(Task task) const override { return isRightOrWrong(task) || ranksThree(task); }
    int recommended(Task task) const override { return ranksThree(task) ? 2 : 0; }
};

} // namespace

const ProcedureKind& DescendingSpec::kind() {
    static const DescendingKind kind;
    return kind;
}

} // namespace chiron::psychophysics
