// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/preview_page.h"

#include "desktop/frame/app_context.h"
#include "desktop/plots/plot_theme_of.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/plan_words.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "psychophysics/study/apex_study.h"
#include "report/plot_view.h"
#include "session/study/presentation_order.h"
#include "session_report/study_warning_words.h"

#include <QDoubleSpinBox>
#include <QProgressBar>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

namespace chiron::desktop {

namespace {
constexpr int kPoll_ms = 100;
constexpr int kSteps = 1000;
constexpr double kPercent = 100.0;
constexpr double kMostSpread_percent = 900.0; // a factor of 10

bool isApex(const psychophysics::Condition& condition) {
    return condition.stimulus.attribute == psychophysics::Attribute::apex;
}

/// SD of a mark along one axis, from the published mean error, in per cent of the radius.
double publishedMarkSpread_percent() {
    return psychophysics::kP2MeanPercent / std::sqrt(2.0 / std::acos(-1.0));
}
} // namespace

PreviewPage::PreviewPage(const DesignPage& page, QWidget* parent) : QWidget(parent), m_page(page) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(page.app.theme().px(16));
    if (page.masked) {
        column->addWidget(
            kit::notice(page.app.theme(), "info",
                        tr("While the study is blinded, its conditions and their expected precision are "
                           "sealed. Only the study's author can estimate it.")));
        column->addStretch();
        return;
    }
    column->addWidget(observerBox());
    auto* results = new QWidget;
    m_results = new QVBoxLayout(results);
    m_results->setContentsMargins(0, 0, 0, 0);
    m_results->setSpacing(page.app.theme().px(16));
    column->addWidget(results);
    column->addStretch();
    m_poll = new QTimer(this);
    connect(m_poll, &QTimer::timeout, this, [this] {
        if (m_work)
            m_progress->setValue(m_work->done());
    });
}

PreviewPage::~PreviewPage() {
    if (m_work)
        m_work->cancel();
}

bool PreviewPage::working() const {
    return m_start && !m_start->isEnabled();
}

QWidget* PreviewPage::observerBox() {
    const Theme& theme = m_page.app.theme();
    const kit::Box box = kit::box(theme);
    const auto& conditions = m_page.draft.design().conditions;
    const auto compared = std::count_if(conditions.begin(), conditions.end(),
                                        [](const psychophysics::Condition& each) { return !isApex(each); });
    if (compared > 0) {
        box.layout->addWidget(kit::label(
            theme,
            tr("The program calculates how precise the results will be: simulated observers, whose true "
               "values are known, run through the study without haptic rendering. They are no participants, "
               "and nothing of it is stored as data. To see the study as a participant does, use Pilot run "
               "under Check and freeze."),
            TextStyle::body, "muted"));
        box.layout->addWidget(observerGrid());
    } else { // a Weber fraction does not predict how well an apex is found
        box.layout->addWidget(kit::label(
            theme,
            tr("How well an apex is found is planned with the published spread of marks, %1 of the radius "
               "along each axis.")
                .arg(study_words::percent(publishedMarkSpread_percent() / kPercent, m_page.app.locale())),
            TextStyle::body, "muted"));
    }
    if (compared > 1)
        box.layout->addWidget(powerGrid());
    auto* row = new QHBoxLayout;
    m_start =
        kit::button(theme, tr("Estimate the precision"), "primary", QStringLiteral("media-playback-start"));
    m_start->setObjectName(QStringLiteral("preview.start"));
    m_cancel = kit::button(theme, tr("Cancel"));
    m_cancel->setObjectName(QStringLiteral("preview.cancel"));
    m_progress = new QProgressBar;
    m_progress->setAccessibleName(tr("Progress of the simulation"));
    m_progress->setRange(0, kSteps);
    m_progress->setTextVisible(false);
    row->addWidget(m_start, 0, Qt::AlignLeft);
    row->addWidget(m_cancel);
    row->addWidget(m_progress, 1);
    box.layout->addLayout(row);
    m_note = kit::label(theme, {}, TextStyle::body, "bad");
    m_note->hide();
    box.layout->addWidget(m_note);
    connect(m_start, &QPushButton::clicked, this, &PreviewPage::start);
    connect(m_cancel, &QPushButton::clicked, this, [this] {
        if (m_work)
            m_work->cancel();
    });
    setWorking(false);
    return box.frame;
}

QWidget* PreviewPage::observerGrid() {
    auto* grid = new FieldGrid(m_page.app.theme(), m_page.app.locale(), false);
    grid->number(tr("Their Weber fraction"), QStringLiteral("preview.weber"), kPercent * m_observer.weber,
                 {0.1, 200, 1, QStringLiteral("%"), 1},
                 [this](double now) { m_observer.weber = now / kPercent; });
    grid->explain(QStringLiteral("preview.weber"),
                  tr("The just noticeable difference of these observers, as a share of the reference."),
                  {0.1, 200, 10});
    grid->number(tr("Lapse rate"), QStringLiteral("preview.lapse"), kPercent * m_observer.lapse,
                 {0, 50, 1, QStringLiteral("%"), 1},
                 [this](double now) { m_observer.lapse = now / kPercent; });
    grid->explain(QStringLiteral("preview.lapse"), tr("Share of their answers that is careless."),
                  {0, 50, 2});
    const auto& conditions = m_page.draft.design().conditions;
    if (std::any_of(conditions.begin(), conditions.end(), [](const psychophysics::Condition& c) {
            return c.task == psychophysics::Task::rank3Ties;
        })) {
        grid->number(tr("Equality threshold (σ)"), QStringLiteral("preview.ties"), m_observer.ties,
                     {0, 10, 2, {}, 0.1}, [this](double now) { m_observer.ties = now; });
        grid->explain(QStringLiteral("preview.ties"), tr("Simulated observers call smaller differences "
                                                         "equal; in standard deviations of what they feel."));
    }
    grid->whole(tr("Runs per condition"), QStringLiteral("preview.runs"), m_runs, 5, 2000,
                [this](int now) { m_runs = now; });
    grid->explain(QStringLiteral("preview.runs"), tr("More runs take longer and give more precise figures."),
                  {5, 2000, 40});
    return grid;
}

QDoubleSpinBox* PreviewPage::spreadField(FieldGrid& grid, const QString& label, const QString& name,
                                         double& sd_log10) {
    return grid.number(label, name, kPercent * study_words::ratioOf(sd_log10),
                       {0, kMostSpread_percent, 1, QStringLiteral("%"), 1}, [this, &sd_log10](double now) {
                           sd_log10 = study_words::differenceOf(now / kPercent);
                           showPower();
                       });
}

QWidget* PreviewPage::powerGrid() {
    m_power.participants = std::max(2, m_page.draft.design().participantsPlanned);
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    const Theme& theme = m_page.app.theme();
    column->addWidget(kit::label(
        theme,
        tr("For comparing two conditions, the variation between people is assumed, not simulated. Changes "
           "take effect at once."),
        TextStyle::body, "muted"));
    auto* grid = new FieldGrid(theme, m_page.app.locale(), false);
    grid->check(tr("Each participant does both conditions"), QStringLiteral("preview.paired"), m_power.paired,
                [this](bool now) {
                    m_power.paired = now;
                    showPower();
                });
    grid->whole(tr("Participants (with two groups: in each)"), QStringLiteral("preview.participants"),
                m_power.participants, 2, 1000, [this](int now) {
                    m_power.participants = now;
                    showPower();
                });
    m_effectSd = spreadField(*grid, tr("Paired: SD of the difference from person to person"),
                             QStringLiteral("preview.effect_sd"), m_power.effectSdLog10);
    m_personSd = spreadField(*grid, tr("Two groups: SD between people"), QStringLiteral("preview.person_sd"),
                             m_power.personSdLog10);
    grid->number(tr("Significance level, two-sided"), QStringLiteral("preview.alpha"),
                 kPercent * m_power.alpha, {0.01, 50, 2, QStringLiteral("%"), 1}, [this](double now) {
                     m_power.alpha = now / kPercent;
                     showPower();
                 });
    grid->number(tr("Desired power"), QStringLiteral("preview.power"), kPercent * m_wantedPower,
                 {10, 99.9, 1, QStringLiteral("%"), 5}, [this](double now) {
                     m_wantedPower = now / kPercent;
                     showPower();
                 });
    grid->explain(QStringLiteral("preview.paired"), tr("Otherwise each person does one of them."));
    grid->explain(QStringLiteral("preview.participants"), tr("How many people are compared."));
    grid->explain(QStringLiteral("preview.effect_sd"),
                  tr("How much the difference varies between people: 12 % is a factor of 1.12."),
                  {0, kMostSpread_percent, 12});
    grid->explain(QStringLiteral("preview.person_sd"), tr("How much people vary: 40 % is a factor of 1.4."),
                  {0, kMostSpread_percent, 40});
    grid->explain(QStringLiteral("preview.alpha"),
                  tr("How often a difference may be found where there is none."));
    grid->explain(QStringLiteral("preview.power"), tr("How often an existing difference should be found."));
    column->addWidget(grid);
    showPower();
    return part;
}

void PreviewPage::showPower() {
    const QLocale locale = m_page.app.locale();
    m_effectSd->setEnabled(m_power.paired);
    m_personSd->setEnabled(!m_power.paired);
    for (const PowerLabels& labels : m_powers) {
        psychophysics::PowerQuestion question = m_power;
        question.runSdLog10 = labels.runSdLog10;
        const auto smallest = [this](const psychophysics::PowerQuestion& asked) {
            return psychophysics::detectableRatio(asked, m_wantedPower);
        };
        const double ratio = smallest(question);
        const double error = psychophysics::figureError(question, labels.runSdError, smallest);
        const QString written = std::isfinite(error) ? study_words::withError(ratio, error, locale)
                                                     : study_words::number(ratio, locale);
        labels.value->setText(std::isfinite(ratio) ? QStringLiteral("× %1").arg(written)
                                                   : tr("none up to × 10"));
        labels.name->setText(
            (m_power.paired
                 ? tr("smallest ratio of two conditions' Weber fractions that is found with %1 power and %2 "
                      "participants who do both conditions")
                 : tr("smallest ratio of two conditions' Weber fractions that is found with %1 power and two "
                      "groups of %2 participants"))
                .arg(study_words::percent(m_wantedPower, locale), locale.toString(m_power.participants)));
    }
}

void PreviewPage::setWorking(bool working) {
    m_start->setEnabled(!working);
    m_cancel->setVisible(working);
    m_progress->setVisible(working);
}

void PreviewPage::start() {
    m_note->hide();
    setWorking(true);
    m_progress->setValue(0);
    m_work = m_page.app.background().run(
        this,
        [design = m_page.draft.design(), observer = m_observer,
         runs = m_runs](WorkToken& token) -> core::Result<std::vector<PreviewResult>> {
            std::vector<PreviewResult> results;
            const auto count = static_cast<double>(design.conditions.size());
            for (std::size_t i = 0; i < design.conditions.size(); ++i) {
                auto result = previewCondition(design, i, observer, runs, [&](double part) {
                    token.setProgress(static_cast<int>(kSteps * (static_cast<double>(i) + part) / count),
                                      kSteps);
                    return !token.cancelled();
                });
                CHIRON_TRY(result);
                results.push_back(std::move(*result));
            }
            return results;
        },
        [this](core::Result<std::vector<PreviewResult>> results) { finished(std::move(results)); });
    m_poll->start(kPoll_ms);
}

void PreviewPage::finished(core::Result<std::vector<PreviewResult>> results) {
    m_poll->stop();
    setWorking(false);
    if (!results) {
        m_note->setVisible(results.error().code != core::ErrorCode::cancelled);
        m_note->setText(tr("The precision could not be estimated. %1")
                            .arg(QString::fromStdString(results.error().message)));
        return;
    }
    while (QLayoutItem* item = m_results->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_powers.clear();
    for (const PreviewResult& result : *results)
        m_results->addWidget(resultBox(result));
    if (m_effectSd)
        showPower();
}

QWidget* PreviewPage::resultBox(const PreviewResult& result) {
    const Theme& theme = m_page.app.theme();
    const QLocale locale = m_page.app.locale();
    const kit::Box box = kit::box(theme);
    box.frame->setObjectName(QStringLiteral("preview.result"));
    QString title = QString::fromStdString(result.condition);
    const psychophysics::Condition* shown = nullptr;
    for (const psychophysics::Condition& condition : m_page.draft.design().conditions)
        if (condition.id == result.condition) {
            title = study_words::text(condition.title, m_page.app.language());
            shown = &condition;
        }
    box.layout->addWidget(kit::label(theme, title, TextStyle::title));
    auto* grid = new FieldGrid(theme, locale, true);
    const auto fact = [&](const QString& name, const QString& value) {
        auto* part = new QWidget;
        auto* column = new QVBoxLayout(part);
        column->setContentsMargins(0, 0, 0, 0);
        column->setSpacing(0);
        auto* number = kit::label(theme, value, TextStyle::title);
        auto* words = kit::label(theme, name, TextStyle::small, "muted");
        column->addWidget(number);
        column->addWidget(words);
        grid->cell(part);
        return std::pair(number, words);
    };
    if (shown && isApex(*shown)) {
        addApexFacts(*shown, [&](const QString& name, const QString& value) { fact(name, value); });
        box.layout->addWidget(grid);
        return box.frame;
    }
    const auto factor = [](double log10) { return std::pow(10.0, log10) - 1.0; };
    const psychophysics::ConditionPlan& plan = result.plan;
    const auto withError = [](const QString& value, const QString& error) {
        return QStringLiteral("%1 ± %2").arg(value, error);
    };
    fact(tr("expected bias of the Weber fraction"),
         withError(study_words::percent(factor(plan.biasLog10), locale),
                   study_words::percent(factor(plan.biasError), locale)));
    fact(tr("precision: SD of one run, as a factor"),
         QStringLiteral("× %1").arg(withError(
             study_words::number(std::pow(10.0, plan.sdLog10), locale),
             study_words::number(std::pow(10.0, plan.sdLog10 + plan.sdError) - std::pow(10.0, plan.sdLog10),
                                 locale, 2))));
    fact(tr("trials of one run of this condition"),
         withError(study_words::number(plan.meanTrials, locale),
                   study_words::number(plan.trialsError, locale, 2)));
    fact(tr("minutes of one run, breaks included"),
         withError(study_words::number(plan.minutes, locale, 2),
                   study_words::number(plan.minutesError, locale, 2)));
    fact(tr("95 % intervals that contain the true value"),
         withError(study_words::percent(plan.coverage, locale),
                   study_words::percent(plan.coverageError, locale)));
    if (m_effectSd) { // there are conditions to compare
        const auto [value, name] = fact({}, {});
        value->setObjectName(QStringLiteral("preview.detectable"));
        m_powers.push_back({plan.sdLog10, plan.sdError, value, name});
    }
    box.layout->addWidget(grid);
    box.layout->addWidget(
        kit::label(theme, tr("±: one standard error of so few simulated runs; more runs make it smaller."),
                   TextStyle::small, "muted"));
    if (plan.runs > 0 && plan.withoutValue) {
        const QString words = runsWithoutValueWords(plan, locale);
        QWidget* values = psychophysics::oftenWithoutValue(plan)
                              ? static_cast<QWidget*>(kit::notice(theme, "warning", words))
                              : kit::label(theme, words, TextStyle::body, "muted");
        values->setObjectName(QStringLiteral("preview.values"));
        box.layout->addWidget(values);
    }
    for (const psychophysics::Warning& warning : plan.warnings)
        box.layout->addWidget(kit::notice(theme, "warning", session_report::warningWords(warning)));
    if (!result.curve.empty())
        box.layout->addWidget(plotOf(result));
    return box.frame;
}

void PreviewPage::addApexFacts(const psychophysics::Condition& condition,
                               const std::function<void(const QString&, const QString&)>& fact) const {
    const QLocale locale = m_page.app.locale();
    const psychophysics::StudyDesign& design = m_page.draft.design();
    const int trials = session::trialsAtMost(condition);
    const double spread_m = publishedMarkSpread_percent() / kPercent * condition.stimulus.reference;
    const auto millimetres = [&](double metres) {
        return study_words::value(metres, psychophysics::Attribute::apex, locale);
    };
    fact(tr("spread of one mark along an axis, as published"), millimetres(spread_m));
    fact(tr("standard error of one participant's bias"),
         millimetres(spread_m / std::sqrt(std::max(1.0, static_cast<double>(trials)))));
    fact(tr("standard error of the bias of %n participant(s), if they do not differ", nullptr,
            design.participantsPlanned),
         millimetres(spread_m /
                     std::sqrt(std::max(1.0, static_cast<double>(trials) * design.participantsPlanned))));
    fact(tr("trials of one run of this condition"), locale.toString(trials));
    fact(tr("minutes of one run, breaks included"),
         study_words::number(psychophysics::minutesOf(condition, design.trial, trials), locale, 2));
}

QWidget* PreviewPage::plotOf(const PreviewResult& result) const {
    const Theme& theme = m_page.app.theme();
    auto* plot = new report::PlotView(plotThemeOf(theme, m_page.app.locale()));
    plot->setObjectName(QStringLiteral("preview.plot"));
    plot->setMinimumHeight(theme.px(260));
    plot->setTitle(tr("How the estimate converges with more trials"));
    plot->setXAxis({tr("Trials of a run"), {}, {}});
    plot->setXWholeNumbers();
    plot->setYAxis({tr("Weber fraction (%)"), 0.0, {}});
    std::vector<double> trial, middle, low, high, errors;
    std::vector<report::PlotPoint> points;
    for (const PreviewPoint& point : result.curve) {
        trial.push_back(point.trials);
        middle.push_back(kPercent * point.weber);
        low.push_back(kPercent * point.low);
        high.push_back(kPercent * point.high);
        for (const auto& [value, error] : {std::pair{point.low, point.lowError},
                                           {point.weber, point.weberError},
                                           {point.high, point.highError}}) {
            points.push_back({point.trials, kPercent * value});
            errors.push_back(kPercent * error);
        }
    }
    plot->addLine(tr("median of %n run(s)", nullptr, result.plan.runs), trial, middle,
                  report::PlotStyle::solidA);
    plot->addLine(tr("middle 80 %"), trial, low, report::PlotStyle::dashedB);
    plot->addLine({}, trial, high, report::PlotStyle::dashedB);
    plot->addMeans(tr("± one standard error"), points, errors);
    plot->addReference(tr("true value"), kPercent * m_observer.weber);
    return plot;
}

} // namespace chiron::desktop
