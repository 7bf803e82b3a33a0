// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/experimenter_panel.h"

#include "desktop/plots/plot_theme_of.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "report/plot_view.h"
#include "session_report/apex_study_plots.h"

#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kWeberPerSigma = 0.954; // JND75 = √2 · 0.6745 · σ
constexpr double kPercent = 100.0;
} // namespace

double weberOf(const std::string& parameter, double value, psychophysics::ProcedureScale scale) {
    if (parameter == "log10_sigma")
        return std::pow(10.0, kWeberPerSigma * std::pow(10.0, value)) - 1.0;
    if (parameter != "threshold")
        return std::nan("");
    const double difference =
        scale == psychophysics::ProcedureScale::logDifference ? std::pow(10.0, value) : value;
    return std::pow(10.0, difference) - 1.0;
}

ExperimenterPanel::ExperimenterPanel(const Theme& theme, const QLocale& locale, QWidget* parent)
    : QScrollArea(parent), m_theme(theme), m_locale(locale) {
    setWidgetResizable(true);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFocusPolicy(Qt::NoFocus);
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Experimenter"), TextStyle::title));
    m_what = kit::label(theme, {}, TextStyle::strong);
    m_what->setObjectName(QStringLiteral("experimenter.what"));
    m_progress = kit::label(theme, {}, TextStyle::body);
    m_progress->setObjectName(QStringLiteral("experimenter.progress"));
    m_estimate = kit::label(theme, {}, TextStyle::body);
    m_estimate->setObjectName(QStringLiteral("experimenter.estimate"));
    m_fidelity = kit::label(theme, {}, TextStyle::small, "muted");
    m_fidelity->setObjectName(QStringLiteral("experimenter.fidelity"));
    box.layout->addWidget(m_what);
    box.layout->addWidget(m_progress);
    box.layout->addWidget(m_estimate);
    m_plotHolder = new QVBoxLayout;
    box.layout->addLayout(m_plotHolder, 1);
    box.layout->addStretch(); // takes the plot's space until there is one
    box.layout->addWidget(kit::rule());
    box.layout->addWidget(m_fidelity);
    m_spoil = add("experimenter.spoil", tr("Discard this trial"), "", "edit-delete");
    m_spoil->setToolTip(tr("It does not count and is presented again."));
    m_pause = add("experimenter.pause", tr("Pause (Space)"), "", "media-playback-pause");
    m_stop = add("experimenter.stop", tr("Stop …"), "danger", "media-playback-stop");
    for (QPushButton* button : {m_spoil, m_pause, m_stop})
        box.layout->addWidget(button);
    connect(m_spoil, &QPushButton::clicked, this, &ExperimenterPanel::spoilAsked);
    connect(m_pause, &QPushButton::clicked, this, &ExperimenterPanel::pauseAsked);
    connect(m_stop, &QPushButton::clicked, this, &ExperimenterPanel::stopAsked);
    setWidget(box.frame);
}

QPushButton* ExperimenterPanel::add(const char* name, const QString& text, const char* kind,
                                    const char* icon) {
    auto* button = kit::button(m_theme, text, kind, QLatin1String(icon));
    button->setObjectName(QLatin1String(name));
    return button;
}

void ExperimenterPanel::show(const session::LiveStudyView& view, const session::LiveStudyNumbers& numbers,
                             const psychophysics::Condition& condition) {
    using State = session::LiveStudyView::State;
    const QString title = study_words::text(condition.title, m_locale.name().section(u'_', 0, 0));
    m_what->setText(numbers.blind
                        ? tr("Condition %1 (sealed)").arg(QString::fromStdString(numbers.sealedCode))
                    : title.isEmpty() ? QString::fromStdString(numbers.condition)
                                      : title);
    const QString most = view.ofAtMost > 0
                             ? tr("%1 of at most %2 trials")
                                   .arg(m_locale.toString(numbers.scored), m_locale.toString(view.ofAtMost))
                             : tr("%n trial(s)", nullptr, numbers.scored);
    m_progress->setText(view.practice ? tr("Practice, not scored. %1").arg(most)
                                      : tr("%1, %2 repeated").arg(most, m_locale.toString(numbers.spoiled)));
    m_pause->setText(view.state == State::paused ? tr("Resume (Space)") : tr("Pause (Space)"));
    m_spoil->setEnabled(!numbers.spoiling &&
                        (view.state == State::exploring || view.state == State::answering));
    m_spoil->setText(numbers.spoiling ? tr("It will not count") : tr("Discard this trial"));
    const int seen = numbers.scored + numbers.spoiled + numbers.practice;
    if (seen == m_seen)
        return;
    m_seen = seen;
    m_fidelity->setText(fidelityText(numbers));
    takeEstimates(numbers, condition);
    if (numbers.blind)
        m_estimate->setText(tr("The estimate stays sealed until the study is unblinded."));
    else if (numbers.apex)
        drawApex(*numbers.apex);
    else
        draw(condition);
}

QString ExperimenterPanel::fidelityText(const session::LiveStudyNumbers& numbers) const {
    const session::TrialFidelity& trial = numbers.lastFidelity;
    // This session has no contacts yet; earlier ones may have had some.
    const bool none =
        trial.contacts == 0 && !std::isfinite(trial.meanSpeed_m_per_s) && !std::isfinite(trial.duration_s);
    if (m_seen <= 0 || none)
        return tr("The fidelity of each trial will appear here.") + QLatin1Char('\n') +
               delayText(numbers.limits);
    QStringList words;
    words << (numbers.lastSpoiled.empty()
                  ? tr("Last trial: counted.")
                  : tr("Last trial: repeated. %1.").arg(study_words::spoiled(numbers.lastSpoiled)));
    words << (std::isfinite(trial.peakForce_N) || !numbers.blind
                  ? forceText(trial)
                  : tr("Mean speed %1 mm/s, %2 contacts, %3 s, late ticks %4. Forces stay sealed: they would "
                       "reveal the condition.")
                        .arg(study_words::number(1e3 * trial.meanSpeed_m_per_s, m_locale),
                             m_locale.toString(trial.contacts),
                             study_words::number(trial.duration_s, m_locale),
                             study_words::percent(trial.lateTicks, m_locale)));
    if (numbers.limited)
        words << tr("The device cannot render all differences: %n remain.", nullptr, numbers.candidates);
    words << delayText(numbers.limits);
    return words.join(QLatin1Char('\n'));
}

QString ExperimenterPanel::forceText(const session::TrialFidelity& trial) const {
    QStringList words;
    words << tr("Peak force %1 N, mean speed %2 mm/s, %3 contacts, %4 s.")
                 .arg(study_words::number(trial.peakForce_N, m_locale),
                      study_words::number(1e3 * trial.meanSpeed_m_per_s, m_locale),
                      m_locale.toString(trial.contacts), study_words::number(trial.duration_s, m_locale));
    words << tr("Felt value off by %1, late ticks %2, device at its limit %3.")
                 .arg(study_words::percent(trial.stiffnessError, m_locale),
                      study_words::percent(trial.lateTicks, m_locale),
                      study_words::percent(trial.saturated, m_locale));
    words << (trial.measured
                  ? tr("Force error %1 N.").arg(study_words::number(trial.forceErrorRms_N, m_locale))
                  : tr("The device measures no force."));
    return words.join(QLatin1Char('\n'));
}

/// Describes the delay on which the limits of passive rendering are based.
QString ExperimenterPanel::delayText(const session::RenderingLimits& limits) const {
    if (!std::isfinite(limits.largestStiffness_N_per_m))
        return tr("Force is shown, not felt, so rendering is not limited.");
    const QString delay = study_words::number(1e3 * limits.delay_s, m_locale);
    return limits.measured ? tr("Measured delay of the device: %1 ms.").arg(delay)
                           : tr("The delay of this device was never measured. A cautious value of %1 ms is "
                                "assumed, based on what the "
                                "device states.")
                                 .arg(delay);
}

void ExperimenterPanel::takeEstimates(const session::LiveStudyNumbers& numbers,
                                      const psychophysics::Condition& condition) {
    m_points.resize(std::max(m_points.size(), numbers.estimates.size()));
    for (std::size_t i = 0; i < numbers.estimates.size(); ++i) {
        const psychophysics::ProcedureEstimate& estimate = numbers.estimates[i];
        if (!estimate.known || estimate.parameters.empty())
            continue;
        const psychophysics::NamedEstimate& first = estimate.parameters.front();
        const double weber = weberOf(first.name, first.mean, condition.scale);
        if (std::isfinite(weber))
            m_points[i].push_back({static_cast<double>(numbers.scored), kPercent * weber,
                                   kPercent * weberOf(first.name, first.low, condition.scale),
                                   kPercent * weberOf(first.name, first.high, condition.scale)});
    }
}

/// Plots the marks so far. It shows no interval, because an interval from one person would describe nobody.
void ExperimenterPanel::drawApex(const psychophysics::ApexSummary& apex) {
    delete m_plot;
    m_plot = nullptr;
    if (apex.trials == 0) {
        m_estimate->setText(tr("The bias will appear here after the first scored trials."));
        return;
    }
    const auto mm = [this](double value) { return study_words::number(value, m_locale, 2); };
    m_estimate->setText(
        tr("Bias so far: %1 mm to the right, %2 mm away from you. Mean error %3 mm per axis.")
            .arg(mm(apex.axes[0].bias_mm), mm(apex.axes[1].bias_mm), mm(apex.meanAbsolute_mm)));
    m_plot = session_report::apexMarksPlot(apex, {tr("marks")}, plotThemeOf(m_theme, m_locale)).release();
    m_plot->setObjectName(QStringLiteral("experimenter.plot"));
    m_plot->setMinimumHeight(m_theme.px(240));
    m_plotHolder->addWidget(m_plot);
}

void ExperimenterPanel::draw(const psychophysics::Condition&) {
    delete m_plot;
    m_plot = nullptr;
    if (m_points.empty() || m_points.front().empty()) {
        m_estimate->setText(tr("The estimate will appear here after the first scored trials."));
        return;
    }
    const Point& last = m_points.front().back();
    const QString interval =
        study_words::intervalPercent(last.low / kPercent, last.high / kPercent, m_locale);
    const QString weber = study_words::percent(last.weber / kPercent, m_locale);
    m_estimate->setText(interval.isEmpty() ? tr("Weber fraction %1").arg(weber)
                                           : tr("Weber fraction %1 (95 %: %2)").arg(weber, interval));
    m_plot = new report::PlotView(plotThemeOf(m_theme, m_locale));
    m_plot->setObjectName(QStringLiteral("experimenter.plot"));
    m_plot->setMinimumHeight(m_theme.px(200));
    m_plot->setXAxis({tr("Trial"), {}, {}});
    m_plot->setXWholeNumbers();
    m_plot->setYAxis({tr("Weber fraction (%)"), 0.0, {}});
    m_plot->setLegendShown(m_points.size() > 1);
    constexpr report::PlotStyle kStyles[] = {report::PlotStyle::solidA, report::PlotStyle::dashedB,
                                             report::PlotStyle::dottedC, report::PlotStyle::dashDotD};
    for (std::size_t i = 0; i < m_points.size(); ++i) {
        std::vector<double> trial, mean, low, high;
        for (const Point& point : m_points[i]) {
            trial.push_back(point.trial);
            mean.push_back(point.weber);
            if (std::isfinite(point.low) && std::isfinite(point.high)) {
                low.push_back(point.low);
                high.push_back(point.high);
            }
        }
        m_plot->addLine(tr("procedure %1").arg(i + 1), trial, mean, kStyles[i % 4]);
        if (i == 0 && low.size() == trial.size()) {
            m_plot->addLine(tr("95 %"), trial, low, report::PlotStyle::dashDotD);
            m_plot->addLine({}, trial, high, report::PlotStyle::dashDotD);
        }
    }
    m_plotHolder->addWidget(m_plot);
}

} // namespace chiron::desktop
