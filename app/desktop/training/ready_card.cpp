// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/ready_card.h"

#include "desktop/training/mouse_pictogram.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QKeyEvent>
#include <QLabel>
#include <QScrollBar>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kTextWidth_px = 760;
constexpr int kControlWidth_px = 216;
constexpr int kControlGap_px = 12;

/// Wide enough for the text and for all movements side by side. This counts one gap more than there is, so
/// that they still fit after lengths were scaled and rounded.
int pageWidth_px(std::size_t controls) {
    return std::max(kTextWidth_px, static_cast<int>(controls) * (kControlWidth_px + kControlGap_px));
}

bool isEnter(int key) {
    return key == Qt::Key_Return || key == Qt::Key_Enter;
}
} // namespace

ReadyCard::ReadyCard(const Theme& theme, const ReadyFacts& facts, Kind kind, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_kind(kind), m_cameByItself(!facts.practised.isEmpty()) {
    setObjectName(QStringLiteral("training.ready"));
    if (m_cameByItself)
        setAccessibleName(facts.practised); // because the card itself has the focus
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    column->addWidget(buildText(facts), 1);
    column->addWidget(buildReadOn());
    column->addWidget(buildButtons(facts));
    installEventFilter(this);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->installEventFilter(this);
}

QWidget* ReadyCard::buildText(const ReadyFacts& facts) {
    m_page = new ScrollPage(m_theme, pageWidth_px(facts.controls.size()));
    m_page->setObjectName(QStringLiteral("training.ready.page"));
    QVBoxLayout& column = *m_page->column();
    column.setSpacing(m_theme.px(10));
    column.addWidget(
        kit::label(m_theme, tr("%1 · %2").arg(facts.exercise, facts.level), TextStyle::body, "muted"));
    if (!facts.practised.isEmpty()) {
        auto* over = kit::label(m_theme, facts.practised, TextStyle::strong);
        over->setObjectName(QStringLiteral("training.ready.practised"));
        column.addWidget(over);
    }
    auto* goal = kit::label(m_theme, facts.goal, TextStyle::title);
    goal->setObjectName(QStringLiteral("training.ready.goal"));
    column.addWidget(goal);
    column.addWidget(buildControls(facts.controls));
    const auto line = [&](const QString& text, const char* name, const char* kind = "") {
        auto* label = kit::label(m_theme, text, TextStyle::body, kind);
        label->setObjectName(QLatin1String(name));
        column.addWidget(label);
        return label;
    };
    line(facts.limit, "training.ready.limit");
    m_clock = line(facts.clock, "training.ready.clock");
    if (m_kind != Kind::brief) {
        if (!facts.gates.isEmpty())
            line(tr("To pass:\n•  %1").arg(facts.gates.join(QStringLiteral("\n•  "))),
                 "training.ready.gates");
        if (!facts.marks.isEmpty())
            line(tr("In the scene:\n•  %1").arg(facts.marks.join(QStringLiteral("\n•  "))),
                 "training.ready.marks");
        line(facts.keys, "training.ready.keys", "muted");
    }
    column.addStretch(1);
    return m_page;
}

QWidget* ReadyCard::buildControls(const std::vector<ControlHint>& controls) {
    auto* row = new QWidget;
    auto* flow = new FlowLayout(m_theme.px(kControlGap_px), row);
    std::vector<QFrame*> frames;
    int height_px = 0;
    for (const ControlHint& control : controls) {
        const kit::Box box = kit::box(m_theme);
        box.frame->setFixedWidth(m_theme.px(kControlWidth_px));
        box.frame->setAccessibleName(tr("%1: %2").arg(control.what, control.how));
        box.layout->addWidget(new MousePictogram(m_theme, control.picture), 0, Qt::AlignHCenter);
        box.layout->addWidget(kit::label(m_theme, control.what, TextStyle::strong));
        if (m_kind != Kind::brief)
            box.layout->addWidget(kit::label(m_theme, control.how, TextStyle::small));
        box.layout->addStretch();
        flow->addWidget(box.frame);
        frames.push_back(box.frame);
        height_px = std::max(height_px, box.layout->totalHeightForWidth(box.frame->width()));
    }
    for (QFrame* frame : frames)
        frame->setFixedHeight(height_px); // as high as the one with the longest text
    return row;
}

/// Says with which key a text is read that is longer than the window; hidden while all of it is visible.
QWidget* ReadyCard::buildReadOn() {
    auto* words = kit::label(m_theme, wasAskedFor() ? tr("Arrow keys: read on") : tr("Space: read on"),
                             TextStyle::small, "muted");
    words->setObjectName(QStringLiteral("training.ready.read_on"));
    words->hide();
    connect(m_page->verticalScrollBar(), &QScrollBar::rangeChanged, words,
            [words](int, int maximum) { words->setVisible(maximum > 0); });
    return words;
}

QWidget* ReadyCard::buildButtons(const ReadyFacts& facts) {
    auto* bar = new QWidget;
    auto* flow = new FlowLayout(m_theme.px(10), bar);
    const auto add = [&](const QString& text, const char* kind, const char* name) {
        auto* button = kit::button(m_theme, text, kind);
        button->setObjectName(QLatin1String(name));
        flow->addWidget(button);
        return button;
    };
    m_go = add(m_kind == Kind::paused ? tr("Resume (Enter)")
               : m_cameByItself       ? tr("Continue")
                                      : tr("Go (Enter)"),
               "primary", "training.ready.go");
    connect(m_go, &QPushButton::clicked, this, &ReadyCard::goAsked);
    if (m_kind != Kind::paused && facts.offersPractice) {
        auto* practice =
            add(facts.practised.isEmpty() ? tr("Practise for a minute") : tr("Practise for another minute"),
                "", "training.ready.practice");
        practice->setToolTip(tr(
            "Try the controls here for a minute. It is recorded as a familiarisation and does not count."));
        connect(practice, &QPushButton::clicked, this, &ReadyCard::practiceAsked);
    }
    if (m_kind == Kind::first && facts.offersDemonstration) {
        auto* watch = add(tr("Watch first"), "", "training.ready.watch");
        watch->setToolTip(tr("Watch a scripted expert at this level. Nothing is counted."));
        connect(watch, &QPushButton::clicked, this, &ReadyCard::watchAsked);
    }
    if (m_kind == Kind::brief)
        connect(add(tr("More"), "quiet", "training.ready.more"), &QPushButton::clicked, this,
                &ReadyCard::wholeAsked);
    else
        connect(add(tr("Help for this screen"), "quiet", "training.ready.help"), &QPushButton::clicked, this,
                &ReadyCard::helpAsked);
    if (m_kind != Kind::paused && facts.offersLeave)
        connect(add(tr("Not now"), "quiet", "training.ready.leave"), &QPushButton::clicked, this,
                &ReadyCard::leaveAsked);
    return bar;
}

bool ReadyCard::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::KeyPress && event->type() != QEvent::KeyRelease)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if (key.key() == Qt::Key_Space) { // Space pauses in the scene, and releasing it would press a button
        if (event->type() == QEvent::KeyPress)
            readOn(key.modifiers().testFlag(Qt::ShiftModifier));
        return true;
    }
    return event->type() == QEvent::KeyPress && pressed(key);
}

bool ReadyCard::pressed(const QKeyEvent& key) {
    auto* button = qobject_cast<QPushButton*>(focusWidget());
    const bool hasButton = button && button->hasFocus();
    const bool begins =
        isEnter(key.key()) || std::find(m_toolKeys.begin(), m_toolKeys.end(), key.key()) != m_toolKeys.end();
    if (scroll(key.key()))
        return true;
    if (!begins)
        return false;
    if (key.isAutoRepeat())
        return true; // held down since before the card appeared
    if (isEnter(key.key()) && hasButton)
        button->click(); // the focused button, as everywhere
    else if (!m_cameByItself && (isEnter(key.key()) || isRead()))
        emit goAsked();
    return true;
}

// Scrolls a card that is longer than the window. Only cards that were asked for use these keys; on the others
// they are a first movement.
bool ReadyCard::scroll(int key) {
    if (!wasAskedFor())
        return false;
    switch (key) {
    case Qt::Key_Up:
        return scrollBy(QAbstractSlider::SliderSingleStepSub);
    case Qt::Key_Down:
        return scrollBy(QAbstractSlider::SliderSingleStepAdd);
    case Qt::Key_PageUp:
        return readOn(true);
    case Qt::Key_PageDown:
        return readOn();
    default:
        return false;
    }
}

bool ReadyCard::readOn(bool back) {
    return scrollBy(back ? QAbstractSlider::SliderPageStepSub : QAbstractSlider::SliderPageStepAdd);
}

bool ReadyCard::scrollBy(QAbstractSlider::SliderAction step) {
    QScrollBar& bar = *m_page->verticalScrollBar();
    const int before = bar.value();
    bar.triggerAction(step);
    m_endSeen = m_endSeen || bar.value() >= bar.maximum();
    return bar.value() != before;
}

bool ReadyCard::isRead() const {
    const QScrollBar& bar = *m_page->verticalScrollBar();
    return !wasAskedFor() || m_endSeen || bar.value() >= bar.maximum();
}

void ReadyCard::setHeld(bool stopped, const QString& clock) {
    if (m_kind != Kind::paused)
        return;
    if (m_clock->text() != clock)
        m_clock->setText(clock);
    const QString go = stopped ? tr("Back to the scene (Enter)") : tr("Resume (Enter)");
    if (m_go->text() != go)
        m_go->setText(go);
}

void ReadyCard::takeFocus() {
    if (m_cameByItself)
        setFocus(Qt::OtherFocusReason);
    else
        m_go->setFocus(Qt::OtherFocusReason);
}

void ReadyCard::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    takeFocus();
}

} // namespace chiron::desktop
