// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/playback/transport_bar.h"

#include "desktop/plots/session_token_words.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <algorithm>
#include <array>

namespace chiron::desktop {

namespace {
constexpr std::array kSpeeds{0.1, 0.25, 0.5, 1.0, 2.0, 4.0};
}

TransportBar::TransportBar(const Theme& theme, const QLocale& locale, PlaybackClock& clock,
                           MomentWords moments, std::vector<std::pair<double, double>> pauses_s,
                           QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_clock(clock), m_moments(std::move(moments)) {
    auto* row = new FlowLayout(theme.px(4), this);
    buildButtons(*row);
    buildSpeed(*row);
    buildLeap(*row, std::move(pauses_s));
    // The last one, so that it is the first to move to a second line, and moves nothing when it changes.
    m_time = kit::line(theme, {}, TextStyle::mono);
    m_time->setObjectName(QStringLiteral("playback.time"));
    row->addWidget(m_time);
    connect(&clock, &PlaybackClock::playingChanged, this, &TransportBar::showPlaying);
    connect(&clock, &PlaybackClock::moved, this, &TransportBar::showTime);
    connect(&clock, &PlaybackClock::durationChanged, this, &TransportBar::showTime);
    showPlaying(clock.playing());
    showTime();
}

void TransportBar::buildButtons(QLayout& row) {
    const auto add = [&](const char* name, const char* icon, const QString& text, auto act) {
        QPushButton* button = kit::iconButton(m_theme, QLatin1String(icon), text);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row.addWidget(button);
        return button;
    };
    add("playback.begin", "media-skip-backward", tr("To the beginning (Home)"),
        [this] { m_clock.seek(0.0); });
    add("playback.back", "go-previous", tr("One frame back (Left)"), [this] { m_clock.step(-1); });
    m_play = kit::button(m_theme, tr("Play"), "primary", QStringLiteral("media-playback-start"));
    m_play->setObjectName(QStringLiteral("playback.play"));
    // This reserves the width of both texts, so that its neighbours do not move.
    for (const bool playing : {true, false}) {
        showPlaying(playing);
        m_play->setMinimumWidth(std::max(m_play->minimumWidth(), m_play->sizeHint().width()));
    }
    connect(m_play, &QPushButton::clicked, this, [this] { m_clock.toggle(); });
    row.addWidget(m_play);
    add("playback.on", "go-next", tr("One frame forward (Right)"), [this] { m_clock.step(1); });
    add("playback.end", "media-skip-forward", tr("To the end (End)"),
        [this] { m_clock.seek(m_clock.duration_s()); });
}

void TransportBar::buildSpeed(QLayout& row) {
    m_speed = new QComboBox;
    m_speed->setObjectName(QStringLiteral("playback.speed"));
    m_speed->setAccessibleName(tr("Speed"));
    m_speed->setToolTip(tr("Speed"));
    for (const double speed : kSpeeds) {
        m_speed->addItem(tr("%1×").arg(m_locale.toString(speed)), speed);
        if (speed == 1.0)
            m_speed->setCurrentIndex(m_speed->count() - 1);
    }
    connect(m_speed, &QComboBox::currentIndexChanged, this,
            [this] { m_clock.setSpeed(m_speed->currentData().toDouble()); });
    row.addWidget(m_speed);
}

void TransportBar::buildLeap(QLayout& row, std::vector<std::pair<double, double>> pauses_s) {
    if (pauses_s.empty())
        return;
    auto* leap = new QCheckBox(tr("Skip pauses"));
    leap->setObjectName(QStringLiteral("playback.skip_pauses"));
    leap->setChecked(true);
    row.addWidget(leap);
    const auto set = [this, pauses = std::move(pauses_s)](bool on) {
        m_clock.setLeapt(on ? pauses : std::vector<std::pair<double, double>>());
    };
    connect(leap, &QCheckBox::toggled, this, set);
    set(true);
}

void TransportBar::showPlaying(bool playing) {
    m_play->setText(playing ? tr("Pause") : tr("Play"));
    m_play->setIcon(m_theme.icon(playing ? QStringLiteral("media-playback-pause")
                                         : QStringLiteral("media-playback-start"),
                                 Colour::accentText));
}

void TransportBar::showTime() {
    m_time->setText(m_moments.at(m_clock.position_s()));
    // Keeps the room of its longest text, or it could move to the line above while playing.
    m_time->setMinimumWidth(std::max(m_time->minimumWidth(), m_time->sizeHint().width()));
    m_time->setToolTip(
        tr("%1 of %2 in the recording, which begins before the first trial")
            .arg(clockText(m_clock.position_s(), m_locale), clockText(m_clock.duration_s(), m_locale)));
}

} // namespace chiron::desktop
