// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/person_page.h"

#include "desktop/plots/plot_theme_of.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_words.h"
#include "desktop/study_data/quality_box.h"
#include "desktop/study_data/ranking_box.h"
#include "desktop/study_data/run_choice.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"
#include "session/study/study_store.h"
#include "session/study/trial_fidelity.h"
#include "session_report/group_words.h"
#include "session_report/run_curve_plot.h"
#include "session_report/study_comparison_words.h"
#include "session_report/study_warning_words.h"

#include <QComboBox>
#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

const RunFacts* runOf(const StudyFacts& facts, database::StudyRunNumber run) {
    for (const RunFacts& each : facts.runs)
        if (each.run.id == run)
            return &each;
    return facts.runs.empty() ? nullptr : &facts.runs.front();
}

QComboBox* runChoice(AppContext& app, const StudyFacts& facts, const RunFacts* chosen) {
    auto* choice = new QComboBox;
    choice->setObjectName(QStringLiteral("data.run"));
    choice->setAccessibleName(QCoreApplication::translate("StudyData", "Participant and condition"));
    choice->setFont(app.theme().font(TextStyle::body));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    for (const RunFacts& run : facts.runs)
        choice->addItem(
            QStringLiteral("%1 · %2").arg(
                QString::fromStdString(facts.study.participants[run.participant].participant.code),
                conditionName(facts.study, session::labelOf(run.run), app.language())),
            qlonglong(run.run.id));
    if (chosen)
        choice->setCurrentIndex(choice->findData(qlonglong(chosen->run.id)));
    return choice;
}

PersonPage::PersonPage(AppContext& app, const StudyFacts& facts, database::StudyRunNumber run,
                       QWidget* parent)
    : QWidget(parent), m_app(app), m_facts(facts) {
    const Theme& theme = app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(14));
    const RunFacts* shown = runOf(facts, run);
    if (!shown) {
        column->addWidget(kit::notice(theme, "info", tr("There are no runs yet.")));
        return;
    }
    QComboBox* choice = runChoice(app, facts, shown);
    connect(choice, &QComboBox::activated, this,
            [this, choice] { emit runChosen(choice->currentData().toLongLong()); });
    column->addWidget(choice, 0, Qt::AlignLeft);
    if (facts.sealed) {
        column->addWidget(new QualityBox(app, facts));
        return;
    }
    column->addWidget(estimateBox(*shown));
    column->addWidget(curveBox(*shown));
    if (facts.ranks(shown->condition))
        column->addWidget(new RankingBox(app, shown->ranking, RankingBox::Of::person));
}

QWidget* PersonPage::estimateBox(const RunFacts& run) const {
    const Theme& theme = m_app.theme();
    const QLocale locale = m_app.locale();
    const psychophysics::RunEstimate& estimate = run.estimate;
    const std::optional<psychophysics::Condition>& condition = m_facts.designed[run.condition];
    const kit::Box box = kit::box(theme);
    auto* grid = new FieldGrid(theme, locale, true);
    const auto fact = [&](const QString& name, const QString& value, const QString& interval,
                          const QString& meaning = {}) {
        auto* part = new QWidget;
        auto* column = new QVBoxLayout(part);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(kit::label(theme, name, TextStyle::small, "muted"));
        column->addWidget(kit::label(theme, value, TextStyle::title));
        column->addWidget(kit::label(theme,
                                     interval.isEmpty() ? tr("no interval") : tr("95 %: %1").arg(interval),
                                     TextStyle::small, "muted"));
        if (!meaning.isEmpty())
            column->addWidget(kit::label(theme, meaning, TextStyle::small, "muted"));
        grid->cell(part);
    };
    const auto marked = [&](const QString& value) { return session_report::markedValue(value, estimate); };
    const QString whyNone = session_report::whyNoValue(estimate);
    if (whyNone.isEmpty()) {
        fact(tr("Weber fraction"), marked(study_words::percent(estimate.weber, locale)),
             study_words::intervalPercent(estimate.weber95.low, estimate.weber95.high, locale));
    } else { // what stands in the estimate comes from the prior
        auto* none = new QWidget;
        none->setObjectName(QStringLiteral("data.no_value"));
        auto* column = new QVBoxLayout(none);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        column->addWidget(kit::label(theme, tr("Weber fraction"), TextStyle::small, "muted"));
        column->addWidget(kit::label(
            theme,
            session_report::supportedValue({}, estimate, run.run.state == database::StudyRunState::open),
            TextStyle::title));
        column->addWidget(kit::label(theme, whyNone, TextStyle::small, "muted"));
        grid->cell(none);
    }
    if (!m_facts.study.blind() && condition) {
        const psychophysics::StimulusDesign& stimulus = condition->stimulus;
        const double perWeber = stimulus.reference * study_words::unitOf(stimulus.attribute).factor;
        if (whyNone.isEmpty())
            fact(tr("JND at the reference"),
                 marked(study_words::value(estimate.jnd, stimulus.attribute, locale)),
                 study_words::interval(estimate.weber95.low * perWeber, estimate.weber95.high * perWeber,
                                       locale));
        if (std::isfinite(estimate.pse)) {
            const double factor = study_words::unitOf(stimulus.attribute).factor;
            fact(tr("Point of subjective equality"),
                 study_words::value(estimate.pse, stimulus.attribute, locale),
                 study_words::interval(estimate.pse95.low * factor, estimate.pse95.high * factor, locale));
        }
    }
    if (whyNone.isEmpty())
        fact(tr("Internal noise"), study_words::percent(study_words::ratioOf(estimate.sigma_log10), locale),
             study_words::intervalPercent(study_words::ratioOf(estimate.sigma95.low),
                                          study_words::ratioOf(estimate.sigma95.high), locale),
             tr("How much the same object feels different from one time to the next (one standard "
                "deviation)."));
    if (std::isfinite(estimate.tie))
        fact(tr("Equality threshold (σ)"), study_words::number(estimate.tie, locale),
             study_words::interval(estimate.tie95.low, estimate.tie95.high, locale));
    if (std::isfinite(estimate.exponent))
        fact(tr("Exponent of the power law"), study_words::number(estimate.exponent, locale),
             study_words::interval(estimate.exponent95.low, estimate.exponent95.high, locale));
    box.layout->addWidget(grid);
    auto* use =
        kit::label(theme, tr("In the group value: %1.").arg(session_report::presenceWords(run.presence)));
    use->setObjectName(QStringLiteral("data.run_use"));
    box.layout->addWidget(use);
    const QString method = session_report::methodWords(estimate.method);
    box.layout->addWidget(
        kit::label(theme,
                   tr("%1. %2. %3 scored trials, %4 repeated. %5")
                       .arg(condition ? study_words::task(condition->task) : QStringLiteral("–"),
                            run.run.procedures.empty() ? QStringLiteral("–")
                                                       : study_words::procedure(run.run.procedures),
                            locale.toString(run.scored), locale.toString(run.spoiled),
                            method.isEmpty() ? method : method + QLatin1Char('.')),
                   TextStyle::small, "muted"));
    const auto unmasked =
        std::count_if(run.trials.begin(), run.trials.end(), [](const database::StudyTrial& trial) {
            return session::circumstancesOf(trial.fidelityJson).masking ==
                   session::TrialCircumstances::kMaskingSilent;
        });
    if (unmasked > 0) {
        auto* said = kit::notice(
            theme, "warning",
            tr("The masking sound was not heard in %1 of %2 trials: the machine had no sound output.")
                .arg(locale.toString(qlonglong(unmasked)), locale.toString(qlonglong(run.trials.size()))));
        said->setObjectName(QStringLiteral("data.not_masked"));
        box.layout->addWidget(said);
    }
    if (const QString influence = session_report::influenceWords(estimate.priorInfluence, locale);
        !influence.isEmpty())
        box.layout->addWidget(kit::label(theme, influence, TextStyle::small, "muted"));
    const session::ReplayedChoices& again = run.replayed;
    if (again.trials > 0)
        box.layout->addWidget(kit::label(
            theme,
            again.identical()
                ? tr("Replayed from its log, the procedure makes the same %n choice(s).", nullptr,
                     again.trials)
                : tr("Replayed from its log, the procedure makes different choices: only %1 of %2 "
                     "match.")
                      .arg(locale.toString(again.same + again.ties), locale.toString(again.trials)),
            TextStyle::small, again.identical() ? "muted" : "warning"));
    if (!estimate.warnings.empty())
        box.layout->addWidget(kit::label(theme, session_report::markMeaning(), TextStyle::small, "muted"));
    for (const psychophysics::Warning& warning : estimate.warnings)
        box.layout->addWidget(kit::notice(theme, "warning", session_report::warningWords(warning)));
    return box.frame;
}

QWidget* PersonPage::curveBox(const RunFacts& run) const {
    const Theme& theme = m_app.theme();
    const psychophysics::RunEstimate& estimate = run.estimate;
    const kit::Box box = kit::box(theme);
    auto* plot = new report::PlotView(plotThemeOf(theme, m_app.locale()));
    plot->setObjectName(QStringLiteral("data.curve"));
    plot->setMinimumHeight(theme.px(320));
    plot->setTitle(tr("Proportion correct by difference"));
    session_report::drawRunCurve(*plot, estimate, m_facts.ranks(run.condition));
    if (estimate.curveDifference.empty() && estimate.points.empty())
        plot->setNote(tr("This task has no psychometric curve"));
    box.layout->addWidget(plot);
    return box.frame;
}

} // namespace chiron::desktop
