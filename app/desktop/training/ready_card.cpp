// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/ready_card.h"

#include "desktop/training/mouse_pictogram.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QKeyEvent>
#include <algorithm>

namespace chiron::desktop {

namespace {
constexpr int kPageWidth_px = 760;
constexpr double kControlWidth_px = 216; // three beside each other on a page of full width
} // namespace

ReadyCard::ReadyCard(const Theme& theme, const ReadyFacts& facts, Kind kind, QWidget* parent) : QWidget(parent), m_theme(theme), m_kind(kind) {
    setObjectName(QStringLiteral("training.ready"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    column->addWidget(buildText(facts), 1);
    column->addWidget(buildButtons(facts));
    installEventFilter(this);
    for (QPushButton* button : findChildren<QPushButton*>())
        button->installEventFilter(this);
}

QWidget* ReadyCard::buildText(const ReadyFacts& facts) {
    auto* page = new ScrollPage(m_theme, kPageWidth_px);
    page->setObjectName(QStringLiteral("training.ready.page"));
    QVBoxLayout& column = *page->column();
    column.setSpacing(m_theme.px(10));
    column.addWidget(kit::label(m_theme, tr("%1 · %2").arg(facts.exercise, facts.level), TextStyle::body, "muted"));
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
    };
    line(facts.limit, "training.ready.limit");
    line(facts.clock, "training.ready.clock");
    if (m_kind != Kind::brief) {
        if (!facts.gates.isEmpty())
            line(tr("To pass:\n•  %1").arg(facts.gates.join(QStringLiteral("\n•  "))), "training.ready.gates");
        if (!facts.marks.isEmpty())
            line(tr("In the scene:\n•  %1").arg(facts.marks.join(QStringLiteral("\n•  "))), "training.ready.marks");
        line(facts.keys, "training.ready.keys", "muted");
    }
    column.addStretch(1);
    return page;
}

QWidget* ReadyCard::buildControls(const std::vector<ControlHint>& controls) {
    auto* row = new QWidget;
    auto* flow = new FlowLayout(m_theme.px(12), row);
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
        frame->setFixedHeight(height_px); // as the one with the most words
    return row;
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
    m_go = add(m_kind == Kind::paused ? tr("Resume (Enter)") : facts.practised.isEmpty() ? tr("Go (Enter)") : tr("Continue (Enter)"), "primary", "training.ready.go");
    connect(m_go, &QPushButton::clicked, this, &ReadyCard::goAsked);
    if (m_kind != Kind::paused && facts.offersPractice) {
        auto* practice = add(facts.practised.isEmpty() ? tr("Practise for a minute") : tr("Practise for another minute"), "", "training.ready.practice");
        practice->setToolTip(tr("Try the controls here for a minute. It is recorded as a familiarisation and does not count."));
        connect(practice, &QPushButton::clicked, this, &ReadyCard::practiceAsked);
    }
    if (m_kind == Kind::brief)
        connect(add(tr("More"), "quiet", "training.ready.more"), &QPushButton::clicked, this, &ReadyCard::wholeAsked);
    else
        connect(add(tr("Help for this screen"), "quiet", "training.ready.help"), &QPushButton::clicked, this, &ReadyCard::helpAsked);
    return bar;
}

bool ReadyCard::eventFilter(QObject*, QEvent* event) {
    if (event->type() != QEvent::KeyPress)
        return false;
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const bool enter = key.key() == Qt::Key_Return || key.key() == Qt::Key_Enter;
    auto* button = qobject_cast<QPushButton*>(focusWidget());
    if (enter && button && button != m_go && button->hasFocus()) {
        button->click(); // the button that has the focus, as everywhere
        return true;
    }
    if (!enter && std::find(m_toolKeys.begin(), m_toolKeys.end(), key.key()) == m_toolKeys.end())
        return false;
    emit goAsked();
    return true;
}

void ReadyCard::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_go->setFocus(Qt::OtherFocusReason);
}

} // namespace chiron::desktop
