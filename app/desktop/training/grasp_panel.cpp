// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/grasp_panel.h"

#include "desktop/training/force_bar.h"
#include "desktop/training/live_plot.h"
#include "desktop/training/target_bar.h"
#include "desktop/widgets/kit.h"
#include "session_report/tool_words.h"

#include <QGridLayout>
#include <QProgressBar>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace chiron::desktop {

namespace {

constexpr double kSpeedAxis_mm_per_s = 60.0;
constexpr double kPlotHeight_px = 64; // minimum height; the plots grow with the window
constexpr double kDegrees = 180.0 / std::numbers::pi;

double largest(const std::array<double, core::kMaxTools>& values) {
    return *std::max_element(values.begin(), values.end());
}

} // namespace

GraspPanel::GraspPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues,
                       Grasping grasping, QWidget* parent)
    : InfoView(theme, {.edge_px = 8.0, .gap_px = 6.0}, parent), m_theme(theme), m_locale(locale),
      m_cues(cues), m_grasping(std::move(grasping)), m_tools(m_grasping.tools) {
    addTask();
    if (cues.bars)
        addBars();
    if (cues.numbers)
        addNumbers();
    if (cues.plots)
        addPlots();
    addFoot(cues, cues.bars || cues.numbers || cues.plots);
}

void GraspPanel::addTask() {
    m_held = kit::label(m_theme, m_grasping.held({}, m_locale), TextStyle::body, "muted");
    m_held->setObjectName(QStringLiteral("training.held"));
    addHead(m_held);
    m_step = kit::label(m_theme, m_grasping.step({}, m_locale), TextStyle::strong);
    m_step->setObjectName(QStringLiteral("training.step"));
    // The label reserves two lines, so that nothing below it moves.
    m_step->setMinimumHeight(2 * QFontMetrics(m_theme.font(TextStyle::strong)).lineSpacing());
    parts().addWidget(m_step);
    if (!m_cues.bars && !m_cues.numbers)
        return;
    m_dwell = new QProgressBar;
    m_dwell->setObjectName(QStringLiteral("training.dwell"));
    m_dwell->setAccessibleName(tr("Holding time completed"));
    m_dwell->setToolTip(tr("Holding time completed"));
    m_dwell->setFormat(tr("Holding time: %p %"));
    m_dwell->setRange(0, 100);
    parts().addWidget(m_dwell);
}

void GraspPanel::addBars() {
    const bool pulled = m_grasping.measured == Grasping::Measured::tension;
    m_target = new TargetBar(m_theme, m_locale,
                             {pulled ? tr("Tension") : tr("Squeeze"), tr("N"), m_grasping.measuredEnd_N, 2},
                             m_cues.numbers);
    m_target->setObjectName(pulled ? QStringLiteral("training.tension_bar")
                                   : QStringLiteral("training.squeeze_bar"));
    parts().addWidget(m_target);
    if (m_grasping.retractionEnd_N > 0.0) {
        m_retraction =
            new TargetBar(m_theme, m_locale, {tr("Pull on the fold"), tr("N"), m_grasping.retractionEnd_N, 2},
                          m_cues.numbers);
        m_retraction->setObjectName(QStringLiteral("training.retraction_bar"));
        m_retraction->setLimit(m_grasping.retractionLimit_N);
        parts().addWidget(m_retraction);
    }
    for (int i = 0; i < m_tools; ++i) {
        const QString name = m_tools == 1 ? tr("Force")
                             : i == 0     ? tr("Force, right")
                             : i == 1     ? tr("Force, left")
                                          : tr("Force, instrument %1").arg(i + 1);
        auto* bar =
            new ForceBar(m_theme, m_locale, {name, tr("N"), m_grasping.forceLimit_N, 2}, m_cues.numbers);
        bar->setObjectName(QStringLiteral("training.force_bar_%1").arg(i));
        parts().addWidget(bar);
        m_force.push_back(bar);
    }
}

void GraspPanel::addNumbers() {
    m_load = kit::label(m_theme, {}, TextStyle::body);
    m_load->setObjectName(QStringLiteral("training.load"));
    parts().addWidget(m_load);
    auto* tips = new QWidget;
    auto* grid = new QGridLayout(tips);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(m_theme.px(8));
    grid->setVerticalSpacing(0);
    const std::array<QString, 4> heads{tr("right"), tr("away"), tr("up"), tr("jaw (°)")};
    int row = 0;
    for (int i = 0; i < m_tools; ++i) {
        const QString tool = session_report::instrumentName(i, m_tools);
        grid->addWidget(kit::label(m_theme, tr("%1, tip (mm)").arg(tool), TextStyle::label), row++, 0, 1, 4);
        ToolRow cells;
        for (int c = 0; c < 4; ++c) {
            const auto k = static_cast<std::size_t>(c);
            if (i == 0)
                grid->addWidget(kit::label(m_theme, heads[k], TextStyle::small, "muted"), row, c);
            cells.number[k] = kit::line(m_theme, QStringLiteral("–"), TextStyle::mono);
            cells.number[k]->setObjectName(QStringLiteral("training.tool_%1_%2").arg(i).arg(c));
            cells.number[k]->setAccessibleName(tr("%1: %2").arg(tool, heads[k]));
            grid->addWidget(cells.number[k], row + (i == 0 ? 1 : 0), c);
            grid->setColumnStretch(c, 1);
        }
        row += i == 0 ? 2 : 1;
        m_rows.push_back(cells);
    }
    parts().addWidget(tips);
    addDetail(tips);
}

LivePlot* GraspPanel::plot(const char* name, const QString& title, double top, std::optional<double> limit) {
    auto* made = new LivePlot(m_theme, m_locale, title, top, limit);
    made->setObjectName(QLatin1String(name));
    made->setMinimumHeight(m_theme.px(kPlotHeight_px));
    parts().addWidget(made, 1);
    return made;
}

void GraspPanel::addPlots() {
    if (m_cues.bars) // tension and squeeze belong to this cue
        m_targetPlot = m_grasping.measured == Grasping::Measured::tension
                           ? plot("training.tension_plot", tr("Tension (N)"), m_grasping.measuredEnd_N)
                           : plot("training.squeeze_plot", tr("Squeeze (N)"), m_grasping.measuredEnd_N,
                                  m_grasping.measuredLimit_N);
    if (m_targetPlot)
        addSpare(m_targetPlot);
    if (m_tools > 1 && m_cues.bars)
        return; // both hands feel the same tension, so one readable plot suffices
    m_forcePlot = plot("training.force_plot", m_tools > 1 ? tr("Force, right (N)") : tr("Force (N)"),
                       m_grasping.forceLimit_N * 1.25, m_grasping.forceLimit_N);
    if (m_cues.bars)
        addSpare(m_forcePlot);
    else
        m_speedPlot = plot("training.speed_plot", tr("Speed (mm/s)"), kSpeedAxis_mm_per_s);
}

void GraspPanel::showMoving(const haptics::DisplayState& state,
                            std::span<const session::LiveSample> samples) {
    showBars(state);
    if (m_cues.plots)
        addSamples(state, samples);
}

void GraspPanel::showReadings(const haptics::DisplayState& state) {
    showWords(state);
    if (m_cues.numbers)
        showNumbers(state);
}

void GraspPanel::showBars(const haptics::DisplayState& state) {
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    if (m_target && m_grasping.measured == Grasping::Measured::tension) {
        m_target->setBand(cues.bandLow_N, cues.bandHigh_N);
        m_target->setValue(cues.tensionShown ? cues.tension_N : 0.0);
    } else if (m_target) {
        m_target->setLimit(cues.squeezeLimit_N);
        m_target->setValue(cues.squeezeShown ? largest(cues.squeeze_N) : 0.0);
    }
    if (m_retraction) {
        m_retraction->setBand(cues.retractionLow_N, cues.retractionHigh_N);
        m_retraction->setValue(cues.retractionShown ? cues.retraction_N : 0.0);
    }
    for (std::size_t i = 0; i < m_force.size(); ++i)
        m_force[i]->setValue(
            std::hypot(state.tool[i].tissue[0], state.tool[i].tissue[1], state.tool[i].tissue[2]));
}

void GraspPanel::showWords(const haptics::DisplayState& state) {
    const auto& cues = state.exercise.of<core::LaparoscopyCues>();
    m_step->setText(m_grasping.step(cues, m_locale));
    m_held->setText(m_grasping.held(cues, m_locale));
    if (m_dwell)
        m_dwell->setValue(qRound(100.0 * std::clamp(cues.dwell, 0.0, 1.0)));
}

void GraspPanel::showNumbers(const haptics::DisplayState& state) {
    // Adding 0 avoids a minus sign before 0.0.
    const auto text = [this](double value) {
        return m_locale.toString(std::round(value * 10.0) / 10.0 + 0.0, 'f', 1);
    };
    m_load->setText(m_grasping.load(state, m_locale));
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const haptics::ToolDisplay& tool = state.tool[i];
        // This is where the tip is drawn.
        const std::array<double, 3>& tip_m = tool.rendersForce ? tool.p_WT_m : tool.p_WProxy_m;
        for (std::size_t k = 0; k < 3; ++k)
            m_rows[i].number[k]->setText(text(tip_m[k] * 1e3));
        m_rows[i].number[3]->setText(m_locale.toString(qRound(tool.jaw_rad * kDegrees)));
    }
}

void GraspPanel::addSamples(const haptics::DisplayState& state,
                            std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        if (m_forcePlot)
            m_forcePlot->add(sample.t_s, static_cast<double>(sample.tissueNorm_N));
        if (m_speedPlot)
            m_speedPlot->add(sample.t_s, static_cast<double>(sample.speed_m_per_s) * 1e3);
    }
    const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
    if (m_targetPlot && !samples.empty() && (cues.tensionShown || cues.squeezeShown))
        m_targetPlot->add(samples.back().t_s, cues.tensionShown ? cues.tension_N : largest(cues.squeeze_N));
    if (m_targetPlot && m_grasping.measured == Grasping::Measured::tension)
        m_targetPlot->setBand(cues.bandLow_N, cues.bandHigh_N);
    for (LivePlot* plot : {m_targetPlot, m_forcePlot, m_speedPlot})
        if (plot)
            plot->update();
}

} // namespace chiron::desktop
