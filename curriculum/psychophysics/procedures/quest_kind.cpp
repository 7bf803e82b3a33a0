// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/marked_texts.h"
#include "psychophysics/procedures/procedure_kind.h"
#include "psychophysics/procedures/quest.h"
#include "psychophysics/procedures/usual_levels.h"

namespace chiron::psychophysics {

namespace {

std::vector<Parameter> questRows() {
    using Spec = QuestSpec;
    std::vector<Parameter> rows{
        rowOf(&Spec::priorMean,
              {.key = "prior_mean",
               .unit = "x",
               .quantity = Quantity::level,
               .minimum = -kUnbounded,
               .description = "guess of the threshold, where the first trial is.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Expected threshold"),
               .meaning = QT_TRANSLATE_NOOP("Procedures",
                                            "Where the threshold is expected before the first answer.")}),
        rowOf(
            &Spec::priorSd,
            {.key = "prior_sd",
             .unit = "x",
             .quantity = Quantity::spread,
             .description = "sd of that guess.",
             .title = QT_TRANSLATE_NOOP("Procedures", "Uncertainty of the expectation"),
             .meaning = QT_TRANSLATE_NOOP("Procedures",
                                          "How far off the expectation may be (one standard deviation)."),
             .meaningOfFactor = QT_TRANSLATE_NOOP(
                 "Procedures", "How far off the expectation may be (one standard deviation). Usually × 3.")}),
        rowOf(&Spec::target,
              {.key = "target",
               .quantity = Quantity::share,
               .maximum = 1,
               .description = "proportion right that the threshold is defined by, above guess "
                              "and below 1 - lapse (1 - guess).",
               .title = QT_TRANSLATE_NOOP("Procedures", "Target share of right answers"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "The threshold is the difference at which this share of the answers is right."),
               .usual = UsualValue{82}}),
        rowOf(&Spec::slope,
              {.key = "slope",
               .unit = "1/x",
               .maximum = 1e6,
               .description = "beta of the Weibull function.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Slope β"),
               .meaning = QT_TRANSLATE_NOOP("Procedures", "How steeply the share of right answers grows with "
                                                          "the difference; it is assumed, not measured."),
               .usual = UsualValue{3.5},
               .field = FieldRange{0.1, 50, 2, 0.1}}),
        rowOf(&Spec::lapse,
              {.key = "lapse",
               .quantity = Quantity::share,
               .maximum = 1,
               .description = "delta, share of trials answered blindly.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Lapses"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures", "Share of answers that are wrong although the difference is felt."),
               .usual = UsualValue{1}}),
        rowOf(&Spec::guess,
              {.key = "guess",
               .quantity = Quantity::share,
               .maximum = 1,
               .description = "gamma, proportion right without any signal.",
               .title = QT_TRANSLATE_NOOP("Procedures", "Right by guessing"),
               .meaning = QT_TRANSLATE_NOOP(
                   "Procedures",
                   "Share of answers that are right although nothing is felt: 50 % with two alternatives."),
               .usual = UsualValue{}}),
        rowOf(
            &Spec::method,
            {.key = "method",
             .words = {{"quantile", QT_TRANSLATE_NOOP("Procedures", "Quantile")},
                       {"mean", QT_TRANSLATE_NOOP("Procedures", "Mean")},
                       {"mode", QT_TRANSLATE_NOOP("Procedures", "Mode")}},
             .description = "where to test: the optimal quantile, mean or mode of the posterior.",
             .title = QT_TRANSLATE_NOOP("Procedures", "Place trials at"),
             .meaning = QT_TRANSLATE_NOOP("Procedures", "Where on the posterior distribution the next trial "
                                                        "is placed; the quantile is the most efficient.")}),
        rowOf(&Spec::grain, {.key = "grain",
                             .unit = "x",
                             .quantity = Quantity::spread,
                             .description = "spacing of the grid of thresholds."}),
        rowOf(&Spec::range, {.key = "range",
                             .unit = "x",
                             .quantity = Quantity::spread,
                             .description = "width of the grid of thresholds, around prior_mean."}),
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
    addStopRows<Spec>(rows, {.precision = true});
    return rows;
}

class QuestKind final : public ProcedureKindOf<QuestSpec> {
public:
    QuestKind()
        : ProcedureKindOf({QT_TRANSLATE_NOOP("Procedures", "QUEST"),
                           QT_TRANSLATE_NOOP("Procedures",
                                             "Bayesian; places each trial where the threshold probably is.")},
                          questRows()) {}

    core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const override {
        return checkedFactory([of = ours(spec)](std::uint64_t) { return Quest::make(of); });
    }

    ProcedureSpec usual(const Condition& condition) const override {
        const std::vector<double> levels = usualLevels(condition);
        QuestSpec spec;
        spec.priorMean = levels[levels.size() / 2];
        spec.guess = guessRateOf(condition.task);
        spec.minimum = levels.front();
        spec.maximum = levels.back();
        return spec;
    }

    bool drives(Task task) const override { return isRightOrWrong(task); }
    int recommended(Task task) const override {
        return isForcedChoice(task) ? 3 : isRightOrWrong(task) ? 2 : 0;
    }
};

} // namespace

const ProcedureKind& QuestSpec::kind() {
    static const QuestKind kind;
    return kind;
}

} // namespace chiron::psychophysics
