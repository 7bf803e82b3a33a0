// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/procedure_form.h"

#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QComboBox>

namespace chiron::desktop {

using namespace psychophysics;

ProcedureForm::ProcedureForm(const Theme& theme, const QLocale& locale, bool readOnly, StudyDraft& draft, ProcedurePlace place, QWidget* parent)
    : FieldGrid(theme, locale, readOnly, parent), m_draft(draft), m_place(place) {
    const Condition& condition = draft.design().conditions[place.condition];
    const std::string kind(kindOf(condition.procedures[place.procedure]));
    std::vector<std::pair<QString, QVariant>> kinds;
    for (const std::string& each : kindsFor(condition.task))
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
    using Fields = void (ProcedureForm::*)();
    static constexpr Fields kFields[] = {&ProcedureForm::staircaseFields,  &ProcedureForm::pestFields,  &ProcedureForm::constantFields,
                                         &ProcedureForm::descendingFields, &ProcedureForm::questFields, &ProcedureForm::questPlusFields,
                                         &ProcedureForm::rank3Fields};
    (this->*kFields[condition.procedures[place.procedure].index()])();
}

QString ProcedureForm::nameOf(const char* key) const {
    return QStringLiteral("procedure.%1.%2").arg(m_place.procedure).arg(QLatin1String(key));
}

template <class Spec> const Spec* ProcedureForm::spec() const {
    return std::get_if<Spec>(&m_draft.design().conditions[m_place.condition].procedures[m_place.procedure]);
}

template <class Spec> void ProcedureForm::edit(const QString& key, const std::function<void(Spec&)>& change) {
    const QString where = QStringLiteral("%1.%2").arg(m_place.condition).arg(key);
    m_draft.change(ProcedureForm::tr("Change of the procedure"), where, [&](StudyDesign& design) {
        if (Spec* found = std::get_if<Spec>(&design.conditions[m_place.condition].procedures[m_place.procedure]))
            change(*found);
    });
}

template <class Spec> void ProcedureForm::numberOf(const QString& label, const char* key, double Spec::*member, const NumberRange& range) {
    number(label, nameOf(key), spec<Spec>()->*member, range,
           [this, key = nameOf(key), member](double now) { edit<Spec>(key, [=](Spec& changed) { changed.*member = now; }); });
}

template <class Spec> void ProcedureForm::wholeOf(const QString& label, const char* key, int Spec::*member, int minimum, int maximum) {
    whole(label, nameOf(key), spec<Spec>()->*member, minimum, maximum,
          [this, key = nameOf(key), member](int now) { edit<Spec>(key, [=](Spec& changed) { changed.*member = now; }); });
}

template <class Spec> void ProcedureForm::checkOf(const QString& label, const char* key, bool Spec::*member) {
    check(label, nameOf(key), spec<Spec>()->*member,
          [this, key = nameOf(key), member](bool now) { edit<Spec>(key, [=](Spec& changed) { changed.*member = now; }); });
}

template <class Spec> void ProcedureForm::listOfLevels(const QString& label, const char* key, std::vector<double> Spec::*member) {
    list(label, nameOf(key), spec<Spec>()->*member,
         [this, key = nameOf(key), member](const std::vector<double>& now) { edit<Spec>(key, [&](Spec& changed) { changed.*member = now; }); });
}

template <class Spec> void ProcedureForm::stopFields() {
    const StopRule& stop = spec<Spec>()->stop;
    const auto add = [this](const QString& label, const char* key, int StopRule::*member, int value) {
        whole(label, nameOf(key), value, 0, 100000,
              [this, key = nameOf(key), member](int now) { edit<Spec>(key, [=](Spec& changed) { changed.stop.*member = now; }); });
    };
    add(ProcedureForm::tr("Maximum trials"), "trials", &StopRule::trials, stop.trials);
    add(ProcedureForm::tr("Minimum trials"), "minimum_trials", &StopRule::minimumTrials, stop.minimumTrials);
    if constexpr (std::is_same_v<Spec, StaircaseSpec>) {
        add(ProcedureForm::tr("Reversals until stop (0: never)"), "reversals", &StopRule::reversals, stop.reversals);
    } else if constexpr (!std::is_same_v<Spec, PestSpec>) {
        number(ProcedureForm::tr("Stop at SD of estimate (0: never)"), nameOf("sd"), stop.sd, {0.0, 10.0, 3, {}, 0.01},
               [this, key = nameOf("sd")](double now) { edit<Spec>(key, [=](Spec& changed) { changed.stop.sd = now; }); });
    }
}

void ProcedureForm::staircaseFields() {
    numberOf<StaircaseSpec>(tr("First x"), "start", &StaircaseSpec::start, {-10, 10, 3, {}, 0.01});
    wholeOf<StaircaseSpec>(tr("Right answers for a step down"), "down", &StaircaseSpec::down, 1, 10);
    wholeOf<StaircaseSpec>(tr("Wrong answers for a step up"), "up", &StaircaseSpec::up, 1, 10);
    numberOf<StaircaseSpec>(tr("Step down : step up (0: from the lists)"), "step_ratio", &StaircaseSpec::stepRatio, {0, 10, 4, {}, 0.01});
    choice(tr("Step type"), nameOf("step_type"),
           {{tr("linear"), static_cast<int>(StaircaseSpec::StepType::linear)},
            {tr("in log10 units"), static_cast<int>(StaircaseSpec::StepType::log)},
            {tr("in dB"), static_cast<int>(StaircaseSpec::StepType::db)}},
           static_cast<int>(spec<StaircaseSpec>()->stepType), [this](const QVariant& now) {
               edit<StaircaseSpec>(nameOf("step_type"),
                                   [&](StaircaseSpec& changed) { changed.stepType = static_cast<StaircaseSpec::StepType>(now.toInt()); });
           });
    wholeOf<StaircaseSpec>(tr("Reversals averaged"), "estimate_reversals", &StaircaseSpec::estimateReversals, 2, 100);
    stopFields<StaircaseSpec>();
    listOfLevels<StaircaseSpec>(tr("Steps up, by number of reversals"), "steps_up", &StaircaseSpec::stepsUp);
    listOfLevels<StaircaseSpec>(tr("Steps down (empty: as up)"), "steps_down", &StaircaseSpec::stepsDown);
    checkOf<StaircaseSpec>(tr("1-up/1-down until the first reversal"), "initial_one_up_one_down", &StaircaseSpec::initialOneUpOneDown);
    checkOf<StaircaseSpec>(tr("Reset counters at each step"), "reset_counters", &StaircaseSpec::resetCounters);
    checkOf<StaircaseSpec>(tr("New step size at the reversal itself"), "new_step_at_reversal", &StaircaseSpec::newStepAtReversal);
    checkOf<StaircaseSpec>(tr("Stay within the range"), "truncate", &StaircaseSpec::truncate);
}

void ProcedureForm::pestFields() {
    numberOf<PestSpec>(tr("First x"), "start", &PestSpec::start, {-10, 10, 3, {}, 0.01});
    numberOf<PestSpec>(tr("Target proportion"), "target", &PestSpec::target, {0.01, 0.99, 3, {}, 0.01});
    numberOf<PestSpec>(tr("Wald deviation"), "wald_deviation", &PestSpec::waldDeviation, {0.1, 10, 2, {}, 0.1});
    numberOf<PestSpec>(tr("First step"), "step", &PestSpec::step, {0.0001, 10, 4, {}, 0.01});
    numberOf<PestSpec>(tr("Smallest step"), "smallest_step", &PestSpec::smallestStep, {0.0001, 10, 4, {}, 0.01});
    numberOf<PestSpec>(tr("Largest step"), "largest_step", &PestSpec::largestStep, {0.0001, 100, 4, {}, 0.1});
    stopFields<PestSpec>();
}

void ProcedureForm::constantFields() {
    wholeOf<ConstantSpec>(tr("Trials per level"), "repeats", &ConstantSpec::repeats, 1, 10000);
    checkOf<ConstantSpec>(tr("In random order"), "shuffled", &ConstantSpec::shuffled);
    listOfLevels<ConstantSpec>(tr("Levels (x)"), "levels", &ConstantSpec::levels);
}

void ProcedureForm::descendingFields() {
    wholeOf<DescendingSpec>(tr("Presentations per level"), "repeats", &DescendingSpec::repeats, 1, 100);
    wholeOf<DescendingSpec>(tr("Correct answers to go on"), "passes", &DescendingSpec::passes, 1, 100);
    listOfLevels<DescendingSpec>(tr("Levels (x), descending"), "levels", &DescendingSpec::levels);
}

void ProcedureForm::questFields() {
    numberOf<QuestSpec>(tr("Prior: mean threshold"), "prior_mean", &QuestSpec::priorMean, {-10, 10, 3, {}, 0.01});
    numberOf<QuestSpec>(tr("Prior: SD"), "prior_sd", &QuestSpec::priorSd, {0.001, 10, 3, {}, 0.01});
    numberOf<QuestSpec>(tr("Target proportion"), "target", &QuestSpec::target, {0.01, 0.99, 3, {}, 0.01});
    numberOf<QuestSpec>(tr("Slope β"), "slope", &QuestSpec::slope, {0.1, 50, 2, {}, 0.1});
    numberOf<QuestSpec>(tr("Lapse rate δ"), "lapse", &QuestSpec::lapse, {0, 0.5, 3, {}, 0.01});
    numberOf<QuestSpec>(tr("Guess rate γ"), "guess", &QuestSpec::guess, {0, 0.99, 3, {}, 0.01});
    choice(tr("Place trials at"), nameOf("method"),
           {{tr("Quantile"), QStringLiteral("quantile")}, {tr("Mean"), QStringLiteral("mean")}, {tr("Mode"), QStringLiteral("mode")}},
           QString::fromStdString(spec<QuestSpec>()->method), [this](const QVariant& now) {
               edit<QuestSpec>(nameOf("method"), [&](QuestSpec& changed) { changed.method = now.toString().toStdString(); });
           });
    stopFields<QuestSpec>();
}

void ProcedureForm::questPlusFields() {
    text(tr("Psychometric function"), nameOf("function"), QString::fromStdString(spec<QuestPlusSpec>()->function), [this](const QString& now) {
        edit<QuestPlusSpec>(nameOf("function"), [&](QuestPlusSpec& changed) { changed.function = now.trimmed().toStdString(); });
    });
    wholeOf<QuestPlusSpec>(tr("Same stimulus in a row, at most (0: no limit)"), "repeat_limit", &QuestPlusSpec::repeatLimit, 0, 1000);
    numberOf<QuestPlusSpec>(tr("Share of catch trials"), "catch_every", &QuestPlusSpec::catchEvery, {0, 0.9, 2, {}, 0.05});
    stopFields<QuestPlusSpec>();
    const std::vector<ParameterGrid>& grids = spec<QuestPlusSpec>()->parameters;
    for (std::size_t i = 0; i < grids.size(); ++i)
        list(tr("Grid: %1").arg(study_words::parameter(grids[i].name)), nameOf("grid") + QString::number(i), grids[i].values,
             [this, i](const std::vector<double>& now) {
                 edit<QuestPlusSpec>(nameOf("grid") + QString::number(i), [&](QuestPlusSpec& changed) {
                     changed.parameters[i].values = now;
                     changed.parameters[i].prior.clear(); // its length was that of the old grid
                 });
             });
}

void ProcedureForm::rank3Fields() {
    wholeOf<Rank3Spec>(tr("Same stimulus in a row, at most (0: no limit)"), "repeat_limit", &Rank3Spec::repeatLimit, 0, 1000);
    stopFields<Rank3Spec>();
    listOfLevels<Rank3Spec>(tr("Grid of lapse rates"), "lapse", &Rank3Spec::lapse);
    if (spec<Rank3Spec>()->allowTies)
        listOfLevels<Rank3Spec>(tr("Grid of tie thresholds (in σ)"), "tie_thresholds", &Rank3Spec::tieThresholds);
    listOfLevels<Rank3Spec>(tr("Grid of noise (log10 σ)"), "log10_sigma", &Rank3Spec::log10Sigma);
}

} // namespace chiron::desktop
