// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/header_bar.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr int kNoTime = -2;
} // namespace

HeaderBar::HeaderBar(const Theme& theme, const QLocale& locale, const Titles& titles, QWidget* parent)
    : QFrame(parent), m_theme(theme), m_locale(locale), m_trials(titles.trials) {
    setProperty("kind", QStringLiteral("card"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(theme.px(14), theme.px(8), theme.px(14), theme.px(8));
    row->setSpacing(theme.px(16));
    auto* what = new QVBoxLayout;
    what->setSpacing(0);
    what->addWidget(kit::label(theme, tr("%1: %2").arg(titles.exercise, titles.level), TextStyle::strong));
    m_device = kit::label(theme,
                          titles.familiarisation ? tr("%1 · familiarisation, not counted").arg(titles.device)
                                                 : titles.device,
                          TextStyle::small, "muted");
    m_device->setObjectName(QStringLiteral("training.device"));
    what->addWidget(m_device);
    row->addLayout(what, 3);
    m_trial = kit::label(theme, {}, TextStyle::title);
    m_trial->setObjectName(QStringLiteral("training.trial"));
    row->addWidget(m_trial, 1);
    m_left = kit::label(theme, {}, TextStyle::title);
    m_left->setObjectName(QStringLiteral("training.left"));
    m_left->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    row->addWidget(m_left, 1);
    if (titles.sound) {
        m_mute = kit::iconButton(theme, QStringLiteral("audio-volume-high"), tr("Sound off"));
        m_mute->setObjectName(QStringLiteral("training.mute"));
        row->addWidget(m_mute);
        connect(m_mute, &QPushButton::clicked, this, &HeaderBar::muteAsked);
    }
}

void HeaderBar::show(const haptics::DisplayState& state) {
    if (m_trials > 1 && m_shownTrial != state.trial) { // a single trial needs no number
        m_shownTrial = state.trial;
        m_trial->setText(
            tr("Trial %1 of %2").arg(m_locale.toString(state.trial + 1), m_locale.toString(m_trials)));
    }
    const bool clock = state.phase == core::TrialPhase::ready || state.phase == core::TrialPhase::running;
    const int left_s = clock ? static_cast<int>(std::ceil(state.timeLeft_s)) : kNoTime;
    if (left_s == m_shownLeft_s)
        return;
    m_shownLeft_s = left_s;
    m_left->setText(left_s == kNoTime ? QString() : tr("%1 s left").arg(m_locale.toString(left_s)));
}

void HeaderBar::setCompact(bool compact) {
    if (compact == m_compact)
        return;
    m_compact = compact;
    m_device->setVisible(!compact);
    for (QLabel* label : {m_trial, m_left})
        label->setFont(m_theme.font(compact ? TextStyle::strong : TextStyle::title));
}

void HeaderBar::setMuted(bool muted) {
    if (!m_mute)
        return;
    const QString text = muted ? tr("Sound on") : tr("Sound off");
    m_mute->setIcon(m_theme.icon(
        muted ? QStringLiteral("audio-volume-muted") : QStringLiteral("audio-volume-high"), Colour::accent));
    m_mute->setAccessibleName(text);
    m_mute->setToolTip(text);
}

void HeaderBar::setSilent(const QString& why) {
    if (!m_mute)
        return;
    setMuted(true);
    m_mute->setEnabled(false);
    m_mute->setAccessibleName(why);
    m_mute->setToolTip(why);
}

} // namespace chiron::desktop
