// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/quest_plus.h"
#include "psychophysics/procedures/rank3_quest_plus.h"
#include "psychophysics/procedures/usual_levels.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

namespace {

bool allowsTies(const ProcedureSpec& spec) {
    return std::get<Rank3Spec>(spec).allowTies;
}

std::vector<Parameter> rank3Rows() {
    using Spec = Rank3Spec;
    std::vector<Parameter> rows{rowOf(
        &Spec::repeatLimit,
        {.key = "repeat_limit",
         .maximum = 1000,
         .description = "the same stimulus, in whatever rows it is given, at most this often in a row; 0 "
                        "as often as it is best.",
         .title = QT_TRANSLATE_NOOP("Procedures", "Same difference in a row"),
         .meaning = QT_TRANSLATE_NOOP(
             "Procedures", "The same difference is presented at most this many times in a row; 0: no limit."),
         .usual = UsualValue{}})};
    // The parameter is log10 of the noise, so its spread is a factor on any scale.
    addStopRows<Spec>(rows, {.precision = true, .sd = Quantity::factor});
    std::vector<Parameter> rest{
        rowOf(&Spec::lapse, {.key = "lapse_rates",
                             .quantity = Quantity::share,
                             .maximum = 1,
                             .fewest = 1,
                             .description = "grid of lapse rates.",
                             .item = "A share of trials answered blindly.",
                             .title = QT_TRANSLATE_NOOP("Procedures", "Lapses"),
                             .meaning = QT_TRANSLATE_NOOP(
                                 "Procedures", "Shares of careless answers that are considered possible.")}),
        rowOf(&Spec::tieThresholds,
              {.key = "tie_thresholds",
               .maximum = 20,
               .fewest = 1,
               .description = "with allow_ties: grid of the difference felt, in sigma, below which "
                              "neighbours are called equal.",
               .item = "A threshold above 0.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Ties (in σ)"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "Values of the limit that are considered possible: two objects are called "
                   "equal when the difference felt is below it. In standard deviations of what is "
                   "felt."),
               .applies = allowsTies}),
        rowOf(&Spec::log10Sigma,
              {.key = "log10_sigma",
               .unit = "log10 of log10",
               .quantity = Quantity::noise,
               .minimum = -20,
               .maximum = 20,
               .most = 65536,
               .description = "grid of log10 of the internal noise sigma.",
               .item = "A value.",
               .byDefault = "from a tenth of the smallest difference to three times the largest, 0.05 apart",
               .title = QT_TRANSLATE_NOOP("Procedures", "Just noticeable difference"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "The just noticeable difference is assumed to lie between these two values.")}),
        rowOf(&Spec::differences,
              {.key = "differences",
               .unit = "log10",
               .quantity = Quantity::level,
               .minimum = 1e-9,
               .maximum = 20,
               .fewest = 1,
               .most = 65536,
               .description = "candidate differences D, log10 of a ratio; objects lie at 0, D, 2D.",
               .item = "A difference.",
               .inTable = true}),
        rowOf(&Spec::allowTies,
              {.key = "allow_ties",
               .description =
                   "neighbours may be called equal: 13 outcomes, and the task of a study is rank3_ties."})};
    for (Parameter& row : rest)
        rows.push_back(std::move(row));
    return rows;
}

class Rank3Kind final : public ProcedureKindOf<Rank3Spec> {
public:
    Rank3Kind()
        : ProcedureKindOf({QT_TRANSLATE_NOOP("Procedures", "QUEST+ for rankings"),
                           QT_TRANSLATE_NOOP("Procedures", "QUEST+ with an observer model for rankings of "
                                                           "three. Needs the fewest trials; the default.")},
                          rank3Rows()) {}

    std::vector<std::string_view> runIds() const override { return {"rank3_quest_plus_ties"}; }

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return factoryOfModel(rank3Model(ours(spec)), {});
    }
    core::Result<void> check(const ProcedureSpec& spec) const override { return checkRank3(ours(spec)); }

    ProcedureSpec usual(const Condition& condition) const override {
        Rank3Spec spec;
        spec.allowTies = condition.task == Task::rank3Ties;
        spec.differences = usualLevels(condition);
        spec.differences.erase(std::remove_if(spec.differences.begin(), spec.differences.end(),
                                              [](double d) { return d <= 0.0; }),
                               spec.differences.end());
        const double largest = spec.differences.empty() ? 0.2 : spec.differences.back();
        const double smallest = spec.differences.empty() ? 0.005 : spec.differences.front();
        spec.log10Sigma = evenGrid(std::log10(smallest / 3.0), std::log10(largest), 41);
        return spec;
    }

    bool drives(Task task) const override { return ranksThree(task); }
    int recommended(Task task) const override { return ranksThree(task) ? 3 : 0; }
    std::optional<TaskFault> faultFor(const ProcedureSpec& spec, Task task) const override {
        const bool ties = task == Task::rank3Ties;
        if (ours(spec).allowTies == ties)
            return std::nullopt;
        return TaskFault{"allow_ties", ties ? "false" : "true",
                         std::string(ties ? "true" : "false") + " for the task " + std::string(token(task))};
    }
    std::optional<ProcedureScale> onlyScale() const override { return ProcedureScale::difference; }
    bool ordersThree(const ProcedureSpec&) const override { return true; }
};

} // namespace

const ProcedureKind& Rank3Spec::kind() {
    static const Rank3Kind kind;
    return kind;
}

} // namespace chiron::psychophysics
