// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/control_bar.h"

#include "desktop/widgets/kit.h"

#include <QHBoxLayout>

namespace chiron::desktop {

namespace {
// Above this scale four buttons side by side are wider than a small window in German.
constexpr double kStackedFrom = 1.5;
} // namespace

ControlBar::ControlBar(const Theme& theme, QWidget* parent) : QWidget(parent), m_theme(theme) {
    const bool stacked = theme.scale() > kStackedFrom;
    const int gap = theme.px(stacked ? 4 : 10);
    // The bar is high, so that the stop button is found without looking.
    setFixedHeight(stacked ? 2 * theme.controlHeight() + gap : theme.px(58));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme.px(10));
    m_stop = add(tr("Stop force (Esc)"), "danger", QStringLiteral("process-stop"),
                 QStringLiteral("training.stop"));
    // In Greek the larger text is wider than the button.
    m_stop->setFont(theme.font(stacked ? TextStyle::strong : TextStyle::title));
    row->addWidget(m_stop, 3);
    m_main = add({}, "primary", {}, QStringLiteral("training.main"));
    // Hidden it keeps its room, so that the stop button stays where it is.
    QSizePolicy room = m_main->sizePolicy();
    room.setRetainSizeWhenHidden(true);
    m_main->setSizePolicy(room);
    row->addWidget(m_main, 2);
    m_resumeHere =
        add(tr("Resume here"), "", QStringLiteral("go-jump"), QStringLiteral("training.resume_here"));
    row->addWidget(m_resumeHere, 2);
    m_again =
        add(tr("Start again …"), "", QStringLiteral("media-skip-backward"), QStringLiteral("training.again"));
    m_again->setToolTip(
        tr("Start again from the beginning (F5). The attempt so far is kept and marked as stopped."));
    m_end =
        add(tr("End session …"), "", QStringLiteral("media-playback-stop"), QStringLiteral("training.end"));
    auto* last = new QBoxLayout(stacked ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
    last->setSpacing(gap);
    last->addWidget(m_again, 1);
    last->addWidget(m_end, 1);
    row->addLayout(last, 2);
    connect(m_stop, &QPushButton::clicked, this, &ControlBar::stopAsked);
    connect(m_main, &QPushButton::clicked, this, [this] { emit mainAsked(m_is); });
    connect(m_resumeHere, &QPushButton::clicked, this, &ControlBar::resumeHereAsked);
    connect(m_again, &QPushButton::clicked, this, &ControlBar::startAgainAsked);
    connect(m_end, &QPushButton::clicked, this, &ControlBar::endAsked);
    m_resumeHere->hide();
    setMain(Main::pause);
    setRunning(false);
}

QPushButton* ControlBar::add(const QString& text, const char* kind, const QString& icon,
                             const QString& name) {
    auto* button = kit::button(m_theme, text, kind, icon);
    button->setObjectName(name);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding); // as high as the bar
    return button;
}

void ControlBar::setMain(Main main) {
    if (main == m_is)
        return;
    m_is = main;
    // Stopped force cannot be stopped again, and must not look as if it still flowed.
    m_stop->setEnabled(m_running && main != Main::rearm);
    QString text = tr("Pause (Space)");
    QString icon = QStringLiteral("media-playback-pause");
    if (main == Main::resume) {
        text = tr("Resume (Space)");
        icon = QStringLiteral("media-playback-start");
    } else if (main == Main::rearm) {
        text = tr("Re-arm (R)");
        icon = QStringLiteral("view-refresh");
    }
    m_main->setText(text);
    m_main->setIcon(m_theme.icon(icon, Colour::accentText));
    m_main->setIconSize(QSize(m_theme.px(20), m_theme.px(20)));
}

void ControlBar::setMainShown(bool shown) {
    m_main->setVisible(shown);
}

void ControlBar::setResumeHere(bool possible) {
    m_resumeHere->setVisible(possible);
}

void ControlBar::setPractice() {
    m_again->hide();
    m_end->setText(tr("End the practice"));
    m_end->setToolTip(tr("Go on to the trials that count. Their card is shown first."));
}

void ControlBar::setRunning(bool running) {
    m_running = running;
    for (QPushButton* button : {m_main, m_resumeHere, m_again, m_end})
        button->setEnabled(running);
    m_stop->setEnabled(running && m_is != Main::rearm);
}

} // namespace chiron::desktop
