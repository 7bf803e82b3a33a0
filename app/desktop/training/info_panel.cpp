// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/info_panel.h"

#include "desktop/training/felt_words.h"
#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/widgets/kit.h"

#include <QGridLayout>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {

constexpr int kNumbersEvery_frames = 6; // ten times per second, so that digits can be read
constexpr double kSpeedAxis_mm_per_s = 60.0;

template <class A> double norm3(const A& v, std::size_t at = 0) {
    return std::hypot(v[at], v[at + 1], v[at + 2]);
}

/// The late ticks as a share of all, because a share shows whether anybody can have felt them.
QString lateShare_percent(const haptics::DisplayState& state) {
    constexpr double kSmallest_percent = 0.01;
    const double ticks = static_cast<double>(std::max(state.tick, state.lateTicks));
    return QLocale().toString(
        std::max(kSmallest_percent, 100.0 * static_cast<double>(state.lateTicks) / ticks), 'f', 2);
}

} // namespace

InfoPanel::InfoPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues, Limits limits,
                     QWidget* parent)
    : InfoView(parent), m_theme(theme), m_locale(locale), m_cues(cues), m_limits(limits) {
    setProperty("kind", QStringLiteral("card"));
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(theme.px(12), theme.px(10), theme.px(12), theme.px(10));
    m_column->setSpacing(theme.px(8));
    m_elapsed = kit::label(theme, elapsedText(0), TextStyle::strong);
    m_elapsed->setObjectName(QStringLiteral("training.elapsed"));
    m_column->addWidget(m_elapsed);
    if (cues.bars)
        addBars();
    if (cues.numbers)
        addNumbers();
    if (cues.plots)
        addPlots();
    if (!cues.bars && !cues.numbers && !cues.plots) {
        auto* none = kit::label(theme, felt_words::noMeasurements(cues.felt), TextStyle::body, "muted");
        none->setObjectName(QStringLiteral("training.no_cues"));
        m_column->addWidget(none);
    }
    if (!cues.plots)
        m_column->addStretch();
    addLoopLine(theme, *m_column);
}

void InfoPanel::addBars() {
    m_force = new ForceBar(m_theme, m_locale, {tr("Force"), tr("N"), m_limits.force_N, 2}, m_cues.numbers);
    m_force->setObjectName(QStringLiteral("training.force_bar"));
    m_column->addWidget(m_force);
    m_torque = new ForceBar(m_theme, m_locale, {tr("Torque"), tr("mN·m"), m_limits.torque_Nm * 1e3, 0},
                            m_cues.numbers);
    m_torque->setObjectName(QStringLiteral("training.torque_bar"));
    m_column->addWidget(m_torque);
    addDetail(m_torque);
}

void InfoPanel::addNumbers() {
    auto* numbers = new QWidget;
    auto* column = new QVBoxLayout(numbers);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(kit::label(m_theme, tr("Tip of the tool (mm)"), TextStyle::label));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(m_theme.px(8));
    grid->setVerticalSpacing(0);
    m_tip[0] = addNumber(tr("right"), QStringLiteral("training.tip_x"), *grid, 0);
    m_tip[1] = addNumber(tr("away"), QStringLiteral("training.tip_y"), *grid, 1);
    m_tip[2] = addNumber(tr("up"), QStringLiteral("training.tip_z"), *grid, 2);
    column->addLayout(grid);
    m_column->addWidget(numbers);
    addDetail(numbers);
}

QLabel* InfoPanel::addNumber(const QString& name, const QString& objectName, QGridLayout& grid, int column) {
    grid.addWidget(kit::label(m_theme, name, TextStyle::small, "muted"), 0, column);
    auto* number = kit::line(m_theme, {}, TextStyle::mono);
    number->setObjectName(objectName);
    number->setAccessibleName(name);
    grid.addWidget(number, 1, column);
    grid.setColumnStretch(column, 1);
    return number;
}

void InfoPanel::addPlots() {
    m_forcePlot = new LivePlot(m_theme, m_locale, tr("Force (N)"), m_limits.force_N * 1.25, m_limits.force_N);
    m_forcePlot->setObjectName(QStringLiteral("training.force_plot"));
    m_column->addWidget(m_forcePlot, 1);
    if (m_cues.bars)
        addSpare(m_forcePlot);
    m_speedPlot = new LivePlot(m_theme, m_locale, tr("Speed (mm/s)"), kSpeedAxis_mm_per_s);
    m_speedPlot->setObjectName(QStringLiteral("training.speed_plot"));
    m_column->addWidget(m_speedPlot, 1);
    addDetail(m_speedPlot);
}

void InfoPanel::show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples)
        m_worked_ms += sample.paused || sample.phase == core::TrialPhase::idle ? 0 : 1;
    const haptics::ToolDisplay& tool = state.tool[0];
    if (m_force) {
        m_force->setValue(norm3(tool.tissue));
        m_torque->setValue(norm3(tool.tissue, 3) * 1e3);
    }
    if (m_forcePlot) {
        for (const session::LiveSample& sample : samples) {
            m_forcePlot->add(sample.t_s, static_cast<double>(sample.tissueNorm_N));
            m_speedPlot->add(sample.t_s, static_cast<double>(sample.speed_m_per_s) * 1e3);
        }
        m_forcePlot->update();
        m_speedPlot->update();
    }
    if (m_frame++ % kNumbersEvery_frames != 0)
        return;
    if (m_cues.numbers)
        showNumbers(tool);
    showLoop(state);
    const std::int64_t second = m_worked_ms / 1000;
    if (second != m_shownSecond) {
        m_shownSecond = second;
        m_elapsed->setText(elapsedText(second));
    }
}

void InfoPanel::showNumbers(const haptics::ToolDisplay& tool) {
    // Shows the position where the tip is drawn: at the surface, if the device cannot keep the hand there.
    const std::array<double, 3>& tip_m = tool.rendersForce ? tool.p_WT_m : tool.p_WProxy_m;
    for (std::size_t i = 0; i < m_tip.size(); ++i)
        // Adding 0 avoids a minus sign before 0.0.
        m_tip[i]->setText(m_locale.toString(std::round(tip_m[i] * 1e4) / 10.0 + 0.0, 'f', 1));
}

QString InfoPanel::elapsedText(std::int64_t second) {
    return tr("Elapsed: %1")
        .arg(QStringLiteral("%1:%2").arg(second / 60).arg(second % 60, 2, 10, QLatin1Char('0')));
}

QString InfoPanel::loopText(const haptics::DisplayState& state) {
    const auto count = [](std::uint64_t n) {
        return static_cast<int>(std::min<std::uint64_t>(n, 1'000'000'000));
    };
    if (state.droppedFrames > 0)
        return tr("%n samples could not be recorded: this session will be incomplete.", nullptr,
                  count(state.droppedFrames));
    if (state.lateTicks > 0)
        return tr("Recording complete; nothing is lost. %1 % of the force updates came late.")
            .arg(lateShare_percent(state));
    return tr("Recording complete; every force update on time");
}

} // namespace chiron::desktop
