// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/procedure_form.h"

#include "desktop/studies/levels_table.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QComboBox>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <memory>

namespace chiron::desktop {

using namespace psychophysics;

namespace {

constexpr double kPercent = 100.0;
constexpr double kJndOfSigma = 0.954; // √2 · 0.6745: what differs by so many σ is told apart in three of four pairs
constexpr double kUneven = 1e-6;

bool isEven(const std::vector<double>& values) {
    const double step = values.size() > 1 ? values[1] - values[0] : 0.0;
    for (std::size_t i = 2; i < values.size(); ++i)
        if (std::abs(values[i] - values[i - 1] - step) > kUneven + 0.02 * std::abs(step)) // written in few digits
            return false;
    return true;
}

std::vector<double> evenly(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low + (high - low) * i / std::max(1, count - 1));
    return values;
}

} // namespace

struct ProcedureForm::FieldsOf {
    ProcedureForm& form;
    void operator()(const StaircaseSpec&) const { form.staircaseFields(); }
    void operator()(const PestSpec&) const { form.pestFields(); }
    void operator()(const ConstantSpec&) const { form.constantFields(); }
    void operator()(const DescendingSpec&) const { form.descendingFields(); }
    void operator()(const QuestSpec&) const { form.questFields(); }
    void operator()(const QuestPlusSpec&) const { form.questPlusFields(); }
    void operator()(const Rank3Spec&) const { form.rank3Fields(); }
};

ProcedureForm::ProcedureForm(const Theme& theme, const QLocale& locale, bool readOnly, StudyDraft& draft, ProcedurePlace place, QWidget* parent)
    : FieldGrid(theme, locale, readOnly, parent), m_draft(draft), m_place(place), m_units(draft.design().conditions[place.condition].scale) {
    const std::string kind(kindOf(condition().procedures[place.procedure]));
    if (condition().stimulus.attribute == Attribute::apex) { // marked so often, and nothing else
        constantFields();
        return;
    }
    std::vector<std::pair<QString, QVariant>> kinds;
    for (const std::string& each : kindsFor(condition().task))
        kinds.emplace_back(study_words::procedure(each), QString::fromStdString(each));
    if (std::none_of(kinds.begin(), kinds.end(), [&](const auto& each) { return each.second.toString().toStdString() == kind; }))
        kinds.emplace_back(study_words::procedure(kind), QString::fromStdString(kind));
    choice(tr("Procedure"), nameOf("kind"), kinds, QString::fromStdString(kind), [this](const QVariant& chosen) {
        m_draft.change(tr("Another procedure"), {}, [&](StudyDesign& design) {
            Condition& changed = design.conditions[m_place.condition];
            changed.procedures[m_place.procedure] = usualProcedure(chosen.toString().toStdString(), changed);
        }, true);
    });
    wide(kit::label(theme, study_words::procedureInWords(kind), TextStyle::small, kind == "descending" ? "warning" : "muted"));
    std::visit(FieldsOf{*this}, condition().procedures[place.procedure]);
}

QString ProcedureForm::nameOf(const char* key) const {
    return QStringLiteral("procedure.%1.%2").arg(m_place.procedure).arg(QLatin1String(key));
}

const Condition& ProcedureForm::condition() const { return m_draft.design().conditions[m_place.condition]; }

template <class Spec> const Spec* ProcedureForm::spec() const {
    return std::get_if<Spec>(&condition().procedures[m_place.procedure]);
}

template <class Spec> void ProcedureForm::edit(const QString& key, const std::function<void(Spec&)>& change) {
    const QString where = QStringLiteral("%1.%2").arg(m_place.condition).arg(key);
    m_draft.change(ProcedureForm::tr("Change of the procedure"), where, [&](StudyDesign& design) {
        if (Spec* found = std::get_if<Spec>(&design.conditions[m_place.condition].procedures[m_place.procedure]))
            change(*found);
    });
}

template <class Spec>
void ProcedureForm::numberOf(const QString& label, const char* key, double Spec::*member, const NumberRange& range, const Shown& shown) {
    number(label, nameOf(key), shown.to(spec<Spec>()->*member), range, [this, key = nameOf(key), member, from = shown.from](double now) {
        edit<Spec>(key, [&](Spec& changed) { changed.*member = from(now); });
    });
}

template <class Spec>
void ProcedureForm::percentOf(const QString& label, const char* key, double Spec::*member, const QString& meaning, double usual) {
    numberOf<Spec>(label, key, member, {0, 100, 1, QStringLiteral("%"), 1},
                   {[](double share) { return kPercent * share; }, [](double percent) { return percent / kPercent; }});
    explain(nameOf(key), meaning, {0, 100, usual});
}

template <class Spec> void ProcedureForm::levelOf(const QString& label, const char* key, double Spec::*member, const QString& meaning) {
    numberOf<Spec>(label, key, member, {-99.0, 10000, 2, QStringLiteral("%"), 1},
                   {[units = m_units](double x) { return units.percentOf(x); }, [units = m_units](double percent) { return units.xOf(percent); }});
    explain(nameOf(key), meaning);
}

NumberRange ProcedureForm::spreadRange() const {
    return m_units.spreadIsFactor() ? NumberRange{1.0, 1000.0, 2, QStringLiteral("×"), 0.05, tr("never")} : NumberRange{0.0, 1000.0, 2, QStringLiteral("%"), 0.5, tr("never")};
}

template <class Spec> void ProcedureForm::spreadOf(const QString& label, const char* key, double Spec::*member, const QString& meaning) {
    NumberRange range = spreadRange();
    range.zero.clear();
    numberOf<Spec>(label, key, member, range,
                   {[units = m_units](double x) { return units.spreadOf(x); }, [units = m_units](double spread) { return units.distanceOf(spread); }});
    explain(nameOf(key), meaning);
}

template <class Spec>
void ProcedureForm::wholeOf(const QString& label, const char* key, int Spec::*member, const QString& meaning, const UsualNumber& usual) {
    whole(label, nameOf(key), spec<Spec>()->*member, 0, 100000,
          [this, key = nameOf(key), member](int now) { edit<Spec>(key, [=](Spec& changed) { changed.*member = now; }); });
    explain(nameOf(key), meaning, usual);
}

template <class Spec> void ProcedureForm::checkOf(const QString& label, const char* key, bool Spec::*member, const QString& meaning) {
    check(label, nameOf(key), spec<Spec>()->*member,
          [this, key = nameOf(key), member](bool now) { edit<Spec>(key, [=](Spec& changed) { changed.*member = now; }); });
    explain(nameOf(key), meaning);
}

template <class Spec>
void ProcedureForm::levelsOf(const QString& label, const char* key, std::vector<double> Spec::*member, const QString& meaning) {
    std::vector<double> percents;
    for (const double x : spec<Spec>()->*member)
        percents.push_back(m_units.percentOf(x));
    const StimulusDesign stimulus = condition().stimulus;
    auto* table = new LevelsTable(gridTheme(), gridLocale(), isReadOnly(), nameOf(key), percents, [stimulus, locale = gridLocale()](double percent) {
        return study_words::value(stimulus.reference * (1.0 + percent / kPercent), stimulus.attribute, locale);
    });
    control(label, nameOf(key), table);
    explain(nameOf(key), meaning);
    connect(table, &LevelsTable::unread, this, [this, name = nameOf(key)](const QString& words) { setUnread(name, words); });
    connect(table, &LevelsTable::changed, this, [this, key = nameOf(key), member](const std::vector<double>& now) {
        edit<Spec>(key, [&](Spec& changed) {
            (changed.*member).clear();
            for (const double percent : now)
                (changed.*member).push_back(m_units.xOf(percent));
        });
    });
}

template <class Spec> void ProcedureForm::stopFields(const UsualNumber& trials) {
    const StopRule& stop = spec<Spec>()->stop;
    const auto add = [this](const QString& label, const char* key, int StopRule::*member, int value) {
        whole(label, nameOf(key), value, 0, 100000,
              [this, key = nameOf(key), member](int now) { edit<Spec>(key, [=](Spec& changed) { changed.stop.*member = now; }); });
    };
    whole(ProcedureForm::tr("Maximum trials"), nameOf("trials"), stop.trials, 0, 100000, [this, fewest = stop.minimumTrials](int now) {
        const int least = now > 0 ? std::min(fewest, now) : fewest; // no run can have more than its most; 0: there is none
        edit<Spec>(nameOf("trials"), [=](Spec& changed) {
            changed.stop.trials = now;
            changed.stop.minimumTrials = least;
        });
        if (auto* field = qobject_cast<QSpinBox*>(this->field(nameOf("minimum_trials")))) {
            const QSignalBlocker quiet(field);
            field->setValue(least);
        }
    });
    explain(nameOf("trials"), ProcedureForm::tr("The run ends after so many trials at the latest."), trials);
    if constexpr (std::is_same_v<Spec, StaircaseSpec>) {
        add(ProcedureForm::tr("Reversals until stop"), "reversals", &StopRule::reversals, stop.reversals);
        explain(nameOf("reversals"), ProcedureForm::tr("The run ends once the direction has changed so often; 0: the trials alone end it."), {0, 100, 12});
    } else if constexpr (!std::is_same_v<Spec, PestSpec>) {
        add(ProcedureForm::tr("Minimum trials"), "minimum_trials", &StopRule::minimumTrials, stop.minimumTrials);
        explain(nameOf("minimum_trials"), ProcedureForm::tr("The run does not end earlier, however sure the estimate is."), {0, static_cast<double>(trials.highest), 20});
        // Rank-3 estimates log10 of the noise whatever the scale: its spread is a factor.
        const LevelUnits units = std::is_same_v<Spec, Rank3Spec> ? LevelUnits(ProcedureScale::logDifference) : m_units;
        NumberRange range = spreadRange();
        if (units.spreadIsFactor())
            range = {1.0, 100.0, 3, QStringLiteral("×"), 0.01, ProcedureForm::tr("never")};
        number(ProcedureForm::tr("Stop when known within"), nameOf("sd"), units.spreadOf(stop.sd), range, [this, key = nameOf("sd"), units](double now) {
            edit<Spec>(key, [&](Spec& changed) { changed.stop.sd = units.distanceOf(now); });
        });
        explain(nameOf("sd"), units.spreadIsFactor() ? ProcedureForm::tr("The run ends once the threshold is known within this factor (one standard deviation). Usually × 1.15.")
                                                     : ProcedureForm::tr("The run ends once the threshold is known within this difference (one standard deviation)."));
    }
}

template <class Spec> void ProcedureForm::repeatField() {
    wholeOf<Spec>(ProcedureForm::tr("Same difference in a row"), "repeat_limit", &Spec::repeatLimit,
                  ProcedureForm::tr("A difference is shown at most so often in succession; 0: no limit."), {0, 1000, 4});
}

void ProcedureForm::staircaseFields() {
    using Spec = StaircaseSpec;
    levelOf<Spec>(tr("First difference"), "start", &Spec::start, tr("Where the run begins: large enough to be felt by everybody. It must lie in the table of differences."));
    wholeOf<Spec>(tr("Right answers for a step down"), "down", &Spec::down, tr("So many right answers in succession make the next trial harder; 3 converge at about 80 % right."), {1, 10, 3});
    wholeOf<Spec>(tr("Wrong answers for a step up"), "up", &Spec::up, tr("So many wrong answers in succession make the next trial easier."), {1, 10, 1});
    number(tr("Step down as a share of a step up"), nameOf("step_ratio"), kPercent * spec<Spec>()->stepRatio, {0, 1000, 2, QStringLiteral("%"), 1, tr("as listed")}, [this](double now) {
        edit<Spec>(nameOf("step_ratio"), [&](Spec& changed) { changed.stepRatio = now / kPercent; });
    });
    explain(nameOf("step_ratio"), tr("Steps down are usually smaller than steps up, so that the run converges: 73.93 % for three right answers (García-Pérez 1998)."));
    wholeOf<Spec>(tr("Reversals averaged"), "estimate_reversals", &Spec::estimateReversals, tr("The staircase's own estimate is the mean of so many last reversals; the fit uses all trials."), {2, 100, 6});
    stopFields<Spec>({0, 100000, 60});
    stepsOf(tr("Steps up"), "steps_up", &Spec::stepsUp, tr("One for each reversal so far; the last one is kept."));
    if (spec<Spec>()->stepRatio <= 0.0)
        stepsOf(tr("Steps down"), "steps_down", &Spec::stepsDown, tr("One for each reversal so far; none: the same as up."));
    checkOf<Spec>(tr("One up, one down at first"), "initial_one_up_one_down", &Spec::initialOneUpOneDown, tr("Until the first reversal a single right answer makes it harder: the run gets near the threshold sooner."));
    checkOf<Spec>(tr("Count anew after each step"), "reset_counters", &Spec::resetCounters, tr("Right and wrong answers before a step do not count for the next one."));
    checkOf<Spec>(tr("New step size at the reversal"), "new_step_at_reversal", &Spec::newStepAtReversal, tr("The step that makes the reversal already has the new size."));
    checkOf<Spec>(tr("Stay within the table"), "truncate", &Spec::truncate, tr("The run never asks for differences beyond the smallest and largest."));
}

/// Steps as factors of the difference, or as differences; those of other kinds (earlier designs) as they are stored.
void ProcedureForm::stepsOf(const QString& label, const char* key, std::vector<double> StaircaseSpec::*member, const QString& meaning) {
    const bool plain = spec<StaircaseSpec>()->stepType == StaircaseSpec::StepType::linear;
    std::vector<double> shown;
    for (const double step : spec<StaircaseSpec>()->*member)
        shown.push_back(plain ? m_units.spreadOf(step) : step);
    const QString name = nameOf(key);
    list(label, name, shown, [this, key = nameOf(key), member, plain](const std::vector<double>& now) {
        edit<StaircaseSpec>(key, [&](StaircaseSpec& changed) {
            (changed.*member).clear();
            for (const double step : now)
                (changed.*member).push_back(plain ? m_units.distanceOf(step) : step);
        });
    });
    const QString unit = !plain ? tr("Logarithmic steps of an imported design.") : m_units.spreadIsFactor() ? tr("Factors of the difference, usually 1.26.") : tr("In per cent of the reference.");
    explain(name, meaning + QLatin1Char(' ') + unit);
}

void ProcedureForm::pestFields() {
    using Spec = PestSpec;
    levelOf<Spec>(tr("First difference"), "start", &Spec::start, tr("Where the run begins: large enough to be felt by everybody."));
    percentOf<Spec>(tr("Right answers aimed at"), "target", &Spec::target, tr("The run looks for the difference at which so many answers are right."), 75);
    numberOf<Spec>(tr("Deviation tolerated"), "wald_deviation", &Spec::waldDeviation, {0.1, 10, 2, {}, 0.1}, {[](double x) { return x; }, [](double x) { return x; }});
    explain(nameOf("wald_deviation"), tr("How many answers more or fewer than expected end a level: larger values take longer and are surer."), {0.1, 10, 1});
    spreadOf<Spec>(tr("First step"), "step", &Spec::step, tr("How far the difference changes at first."));
    spreadOf<Spec>(tr("Smallest step"), "smallest_step", &Spec::smallestStep, tr("The run ends when a step would be as small as this."));
    spreadOf<Spec>(tr("Largest step"), "largest_step", &Spec::largestStep, tr("Steps never grow beyond this."));
    stopFields<Spec>({0, 100000, 200});
}

void ProcedureForm::constantFields() {
    using Spec = ConstantSpec;
    if (!spec<Spec>())
        return;
    if (condition().stimulus.attribute == Attribute::apex) {
        wholeOf<Spec>(tr("Trials"), "repeats", &Spec::repeats, tr("How often a participant looks for the apex."), {1, 10000, 10});
        return;
    }
    wholeOf<Spec>(tr("Trials per level"), "repeats", &Spec::repeats, tr("Each level is presented so often."), {1, 10000, 20});
    checkOf<Spec>(tr("In random order"), "shuffled", &Spec::shuffled, tr("Levels come in random blocks of one of each; else in the order of the table."));
    levelsOf<Spec>(tr("Levels"), "levels", &Spec::levels, tr("What is presented. Levels must lie within the table of differences."));
}

void ProcedureForm::descendingFields() {
    using Spec = DescendingSpec;
    wholeOf<Spec>(tr("Presentations per level"), "repeats", &Spec::repeats, tr("Each level is presented so often before it is decided."), {1, 100, 3});
    wholeOf<Spec>(tr("Right answers to go on"), "passes", &Spec::passes, tr("With fewer right answers at a level the run ends there."), {1, 100, 2});
    levelsOf<Spec>(tr("Levels"), "levels", &Spec::levels, tr("What is presented, from the largest to the smallest difference."));
}

void ProcedureForm::questFields() {
    using Spec = QuestSpec;
    levelOf<Spec>(tr("Expected threshold"), "prior_mean", &Spec::priorMean, tr("Where the threshold is expected before the first answer."));
    spreadOf<Spec>(tr("Uncertainty of it"), "prior_sd", &Spec::priorSd, m_units.spreadIsFactor() ? tr("How far off the expectation may be (one standard deviation). Usually × 3.")
                                                                                               : tr("How far off the expectation may be (one standard deviation)."));
    percentOf<Spec>(tr("Right answers aimed at"), "target", &Spec::target, tr("The threshold is where so many answers are right."), 82);
    numberOf<Spec>(tr("Slope β"), "slope", &Spec::slope, {0.1, 50, 2, {}, 0.1}, {[](double x) { return x; }, [](double x) { return x; }});
    explain(nameOf("slope"), tr("How steeply right answers grow with the difference; it is assumed, not measured."), {0.1, 50, 3.5});
    percentOf<Spec>(tr("Lapses"), "lapse", &Spec::lapse, tr("Answers that are wrong although the difference is felt."), 1);
    percentOf<Spec>(tr("Right by guessing"), "guess", &Spec::guess, tr("Answers that are right without feeling anything: 50 % of two alternatives."), kPercent * spec<Spec>()->guess);
    choice(tr("Place trials at"), nameOf("method"),
           {{tr("Quantile"), QStringLiteral("quantile")}, {tr("Mean"), QStringLiteral("mean")}, {tr("Mode"), QStringLiteral("mode")}},
           QString::fromStdString(spec<QuestSpec>()->method), [this](const QVariant& now) {
               edit<QuestSpec>(nameOf("method"), [&](QuestSpec& changed) { changed.method = now.toString().toStdString(); });
           });
    explain(nameOf("method"), tr("Which point of what is known is asked next; the quantile is the most efficient."));
    stopFields<QuestSpec>({0, 100000, 40});
}

void ProcedureForm::functionField() {
    const std::string now = spec<QuestPlusSpec>()->function;
    std::vector<std::pair<QString, QVariant>> functions;
    for (const std::string& each : functionsFor(condition().scale))
        functions.emplace_back(study_words::psychometricFunction(each), QString::fromStdString(each));
    if (std::none_of(functions.begin(), functions.end(), [&](const auto& each) { return each.second.toString().toStdString() == now; }))
        functions.emplace_back(study_words::psychometricFunction(now), QString::fromStdString(now)); // of an imported design
    choice(tr("Psychometric function"), nameOf("function"), functions, QString::fromStdString(now), [this](const QVariant& chosen) {
        m_draft.change(tr("Another function"), {}, [&](StudyDesign& design) {
            Condition& changed = design.conditions[m_place.condition];
            if (auto* plus = std::get_if<QuestPlusSpec>(&changed.procedures[m_place.procedure]))
                takeFunction(*plus, chosen.toString().toStdString(), changed);
        }, true);
    });
    explain(nameOf("function"), tr("The shape by which right answers are assumed to grow with the difference."));
}

void ProcedureForm::questPlusFields() {
    functionField();
    repeatField<QuestPlusSpec>();
    percentOf<QuestPlusSpec>(tr("Catch trials"), "catch_every", &QuestPlusSpec::catchEvery, tr("Share of trials at the largest difference, which show whether a participant attends."), 0);
    stopFields<QuestPlusSpec>({0, 100000, 64});
    for (std::size_t i = 0; i < spec<QuestPlusSpec>()->parameters.size(); ++i)
        parameterField(i);
}

void ProcedureForm::parameterField(std::size_t index) {
    const ParameterGrid& grid = spec<QuestPlusSpec>()->parameters[index];
    const QString key = nameOf("grid") + QString::number(index);
    const auto taken = [this, key, index](const std::vector<double>& now) {
        edit<QuestPlusSpec>(key, [&](QuestPlusSpec& changed) {
            changed.parameters[index].values = now;
            changed.parameters[index].prior.clear(); // its length was that of the old grid
        });
    };
    const LevelUnits units = m_units;
    if (grid.name == "threshold" || grid.name == "mean")
        gridFields(tr("Threshold"), key, grid.values, {-99.0, 10000, 2, QStringLiteral("%"), 1},
                   {[units](double x) { return units.percentOf(x); }, [units](double percent) { return units.xOf(percent); }},
                   tr("Thresholds between these are considered possible."), taken);
    else if (grid.name == "sd")
        gridFields(tr("Spread"), key, grid.values, {0.0, 10000, 2, units.spreadIsFactor() ? QStringLiteral("×") : QStringLiteral("%"), 1},
                   {[units](double x) { return units.spreadOf(x); }, [units](double percent) { return units.distanceOf(percent); }},
                   tr("Spreads of the answers between these are considered possible."), taken);
    else if (grid.name == "lapse_rate" || grid.name == "lower_asymptote")
        sharesField(study_words::parameter(grid.name), key, grid.values,
                    grid.name == "lapse_rate" ? tr("Shares of wrong answers although the difference is felt that are considered possible.")
                                              : tr("Share of answers that are right by guessing: 50 % of two alternatives."), taken);
    else {
        list(study_words::parameter(grid.name), key, grid.values, taken);
        explain(key, grid.name == "slope" ? tr("Slopes that are considered possible: how steeply right answers grow with the difference. Usually 1.5 to 7.")
                                          : tr("Values of this parameter that are considered possible."));
    }
}

void ProcedureForm::sharesField(const QString& label, const QString& key, const std::vector<double>& shares, const QString& meaning,
                                const std::function<void(std::vector<double>)>& taken) {
    std::vector<double> percents;
    for (const double share : shares)
        percents.push_back(kPercent * share);
    list(tr("%1 (%)").arg(label), key, percents, [taken](std::vector<double> now) {
        for (double& percent : now)
            percent /= kPercent;
        taken(std::move(now));
    });
    explain(key, meaning);
}

void ProcedureForm::gridFields(const QString& what, const QString& key, const std::vector<double>& values, const NumberRange& range, const Shown& shown,
                               const QString& meaning, const std::function<void(std::vector<double>)>& taken) {
    struct Ends {
        double low, high;
        int count;
    };
    auto ends = std::make_shared<Ends>(Ends{values.empty() ? 0.0 : values.front(), values.empty() ? 0.0 : values.back(), static_cast<int>(values.size())});
    const auto put = [ends, taken] { taken(evenly(ends->low, ends->high, ends->count)); };
    number(tr("%1: from").arg(what), key + QStringLiteral(".low"), shown.to(ends->low), range, [=, from = shown.from](double now) {
        ends->low = from(now);
        put();
    });
    explain(key + QStringLiteral(".low"), meaning);
    number(tr("%1: to").arg(what), key + QStringLiteral(".high"), shown.to(ends->high), range, [=, from = shown.from](double now) {
        ends->high = from(now);
        put();
    });
    explain(key + QStringLiteral(".high"), isEven(values) ? tr("The largest that is considered possible.") : tr("The largest. An imported design spaced these values unevenly; a change makes them even."));
    whole(tr("%1: steps").arg(what), key + QStringLiteral(".count"), ends->count, 1, 400, [=](int now) {
        ends->count = now;
        put();
    });
    explain(key + QStringLiteral(".count"), tr("More steps are finer, and take longer to compute."), {1, 400, 41});
}

void ProcedureForm::rank3Fields() {
    repeatField<Rank3Spec>();
    stopFields<Rank3Spec>({0, 100000, 80});
    const auto taken = [this](std::vector<double> Rank3Spec::*member, const char* key) {
        return [this, member, name = nameOf(key)](const std::vector<double>& now) { edit<Rank3Spec>(name, [&](Rank3Spec& changed) { changed.*member = now; }); };
    };
    sharesField(tr("Lapses"), nameOf("lapse"), spec<Rank3Spec>()->lapse, tr("Shares of careless answers that are considered possible."), taken(&Rank3Spec::lapse, "lapse"));
    if (spec<Rank3Spec>()->allowTies) {
        list(tr("Ties (in σ)"), nameOf("tie_thresholds"), spec<Rank3Spec>()->tieThresholds, taken(&Rank3Spec::tieThresholds, "tie_thresholds"));
        explain(nameOf("tie_thresholds"), tr("Differences below which objects are called equal, in standard deviations of what is felt, that are considered possible."));
    }
    const auto percent = [](double log10Sigma) { return kPercent * study_words::ratioOf(kJndOfSigma * std::pow(10.0, log10Sigma)); };
    const auto noise = [](double jnd) { return std::log10(study_words::differenceOf(std::max(jnd, 0.01) / kPercent) / kJndOfSigma); };
    gridFields(tr("Just noticeable difference"), nameOf("log10_sigma"), spec<Rank3Spec>()->log10Sigma, {0.01, 10000, 2, QStringLiteral("%"), 1}, {percent, noise},
               tr("Just noticeable differences between these are considered possible."), taken(&Rank3Spec::log10Sigma, "log10_sigma"));
}

} // namespace chiron::desktop
