// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/info_view.h"

#include "desktop/training/felt_words.h"
#include "desktop/widgets/kit.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr int kReadingsEvery_frames = 6; // ten times per second, so that digits can be read

/// The texts that every panel shares.
struct InfoTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::desktop::InfoPanel)
};

/// "Elapsed: 1:05"
QString elapsedText(std::int64_t second) {
    return InfoTexts::tr("Elapsed: %1")
        .arg(QStringLiteral("%1:%2").arg(second / 60).arg(second % 60, 2, 10, QLatin1Char('0')));
}

/// The late ticks as a share of all, because a share shows whether anybody can have felt them.
QString lateShare_percent(const haptics::DisplayState& state) {
    constexpr double kSmallest_percent = 0.01;
    const double ticks = static_cast<double>(std::max(state.tick, state.lateTicks));
    return QLocale().toString(
        std::max(kSmallest_percent, 100.0 * static_cast<double>(state.lateTicks) / ticks), 'f', 2);
}

} // namespace

InfoView::InfoView(const Theme& theme, const Room& room, QWidget* parent)
    : QFrame(parent), m_theme(theme), m_column(new QVBoxLayout(this)) {
    setProperty("kind", QStringLiteral("card"));
    const int edge = theme.px(room.edge_px);
    m_column->setContentsMargins(theme.px(12), edge, theme.px(12), edge);
    m_column->setSpacing(theme.px(room.gap_px));
}

void InfoView::addElapsed(QLabel* elapsed, Qt::Alignment alignment) {
    m_elapsed = elapsed;
    m_elapsed->setText(elapsedText(0));
    m_elapsed->setObjectName(QStringLiteral("training.elapsed"));
    m_column->addWidget(m_elapsed, 0, alignment);
}

void InfoView::addHead(QLabel* words) {
    m_elapsed = kit::line(m_theme, elapsedText(0), TextStyle::body);
    m_elapsed->setObjectName(QStringLiteral("training.elapsed"));
    auto* head = new QHBoxLayout;
    head->setSpacing(m_theme.px(8));
    head->addWidget(words, 1);
    head->addWidget(m_elapsed, 0, Qt::AlignTop);
    m_column->addLayout(head);
}

void InfoView::addFoot(const session::LevelCues& cues, bool measures) {
    if (!measures) {
        auto* none = kit::label(m_theme, felt_words::noMeasurements(cues.felt), TextStyle::body, "muted");
        none->setObjectName(QStringLiteral("training.no_cues"));
        m_column->addWidget(none);
    }
    if (!cues.plots)
        m_column->addStretch();
    m_loop = kit::label(m_theme, {}, TextStyle::small, "muted");
    m_loop->setObjectName(QStringLiteral("training.loop"));
    m_column->addWidget(m_loop);
    placeLoopLine();
}

void InfoView::show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples)
        m_worked_ms += sample.paused || sample.phase == core::TrialPhase::idle ? 0 : 1;
    showMoving(state, samples);
    if (m_frame++ % kReadingsEvery_frames != 0)
        return;
    showReadings(state);
    showLoop(state);
    m_elapsed->setText(elapsedText(m_worked_ms / 1000));
}

void InfoView::setDetailed(bool detailed) {
    m_detailed = detailed;
    for (QWidget* part : m_details)
        part->setVisible(detailed);
    placeLoopLine();
    giveUp(0);
}

void InfoView::giveUp(int parts) {
    for (std::size_t i = 0; i < m_spare.size(); ++i)
        m_spare[i]->setVisible(static_cast<int>(i) >= parts);
    updateGeometry(); // now: whoever asks measures the height at once
}

void InfoView::addDetail(QWidget* part) {
    part->setVisible(m_detailed);
    m_details.push_back(part);
}

QString InfoView::loopText(const haptics::DisplayState& state) {
    const auto count = [](std::uint64_t n) {
        return static_cast<int>(std::min<std::uint64_t>(n, 1'000'000'000));
    };
    if (state.droppedFrames > 0)
        return InfoTexts::tr("%n samples could not be recorded: this session will be incomplete.", nullptr,
                             count(state.droppedFrames));
    if (state.lateTicks > 0)
        return InfoTexts::tr("Recording complete; nothing is lost. %1 % of the force updates came late.")
            .arg(lateShare_percent(state));
    return InfoTexts::tr("Recording complete; every force update on time");
}

void InfoView::showLoop(const haptics::DisplayState& state) {
    m_loop->setText(loopText(state));
    if (m_lost == (state.droppedFrames > 0))
        return;
    m_lost = state.droppedFrames > 0;
    placeLoopLine();
}

void InfoView::placeLoopLine() {
    if (m_loop)
        m_loop->setVisible(m_detailed || m_lost);
}

} // namespace chiron::desktop
