// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/answer_panel.h"

#include "desktop/studies/study_words.h"
#include "desktop/study_run/large_texts.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"

#include <QDoubleValidator>
#include <QLineEdit>
#include <algorithm>

namespace chiron::desktop {

using psychophysics::Task;

QStringList AnswerPanel::placeNames(int places) {
    if (places == 1)
        return {tr("here")};
    QStringList names;
    for (int place = 1; place <= places; ++place)
        names << QString::number(place);
    return names;
}

AnswerPanel::AnswerPanel(const Theme& theme, Task task, psychophysics::Attribute attribute, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_task(task), m_attribute(attribute) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    auto* words = kit::label(theme, question(), TextStyle::title);
    words->setObjectName(QStringLiteral("answer.question"));
    words->setAlignment(Qt::AlignCenter);
    column->addWidget(words);
    m_why = kit::label(theme, QStringLiteral(" "), TextStyle::strong);
    m_why->setObjectName(QStringLiteral("answer.why"));
    m_why->setAlignment(Qt::AlignCenter);
    column->addWidget(m_why);
    m_row = new QWidget;
    auto* row = new FlowLayout(theme.px(12), m_row); // wraps at a large scale
    switch (task) {
    case Task::rank3:
    case Task::rank3Ties:
        buildRanking();
        break;
    case Task::sameDifferent:
        m_choices = {add(tr("Same (1)"), QStringLiteral("answer.0")),
                     add(tr("Different (2)"), QStringLiteral("answer.1"))};
        break;
    case Task::yesNo:
        m_choices = {add(tr("No (N)"), QStringLiteral("answer.0")),
                     add(tr("Yes (Y)"), QStringLiteral("answer.1"))};
        break;
    case Task::adjustment:
        connect(add(tr("Less (−)"), QStringLiteral("answer.less")), &QPushButton::clicked, this,
                [this] { key(Qt::Key_Minus); });
        connect(add(tr("More (+)"), QStringLiteral("answer.more")), &QPushButton::clicked, this,
                [this] { key(Qt::Key_Plus); });
        m_confirm = add(tr("They are the same (Enter)"), QStringLiteral("answer.confirm"), "primary");
        break;
    case Task::magnitude:
        m_number = new QLineEdit;
        m_number->setObjectName(QStringLiteral("answer.number"));
        m_number->setAccessibleName(tr("Your number"));
        m_number->setFont(theme.font(TextStyle::title));
        m_number->setMaximumWidth(theme.px(160));
        m_number->setValidator(new QDoubleValidator(0.0, 1e9, 6, m_number));
        row->addWidget(m_number);
        m_confirm = add(tr("Submit (Enter)"), QStringLiteral("answer.confirm"), "primary");
        connect(m_number, &QLineEdit::returnPressed, this, &AnswerPanel::confirm);
        connect(m_number, &QLineEdit::textEdited, this, &AnswerPanel::begun);
        break;
    case Task::twoAfc:
    case Task::threeAfc:
    case Task::oddity: {
        for (int i = 0; i < psychophysics::placesOf(task); ++i)
            m_choices.push_back(addPlace(i, psychophysics::placesOf(task)));
        break;
    }
    }
    if (!psychophysics::ranksThree(task))
        for (std::size_t i = 0; i < m_choices.size(); ++i)
            connect(m_choices[i], &QPushButton::clicked, this, [this, i] { choose(static_cast<int>(i)); });
    if (m_confirm)
        connect(m_confirm, &QPushButton::clicked, this, &AnswerPanel::confirm);
    auto* line = new QHBoxLayout;
    line->addStretch(1);
    line->addWidget(m_row, 1000);
    line->addStretch(1);
    column->addLayout(line);
    m_open = true;
    setOpen(false);
}

/// Centres the answers at the width of all of them, or of the available space. Their width is known only
/// after styling.
void AnswerPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    const QLayout& row = *m_row->layout();
    int width = 0;
    for (int i = 0; i < row.count(); ++i)
        width += row.itemAt(i)->sizeHint().width() + (i > 0 ? row.spacing() : 0);
    m_row->setMaximumWidth(width);
}

QString AnswerPanel::question() const {
    return study_words::question(m_task, m_attribute);
}

QPushButton* AnswerPanel::add(const QString& text, const QString& name, const char* kind) {
    auto* button = kit::button(m_theme, text, kind);
    button->setObjectName(name);
    // At a large scale the smaller font is large enough and needs fewer lines.
    button->setFont(m_theme.font(areTextsLarge(m_theme) ? TextStyle::strong : TextStyle::title));
    m_row->layout()->addWidget(button);
    return button;
}

/// The number is the object's name, its key and its label in the scene. The accessible description gives its
/// position for people who do not see the scene.
QPushButton* AnswerPanel::addPlace(int place, int places) {
    const QString where = place == 0            ? tr("the left one")
                          : place + 1 == places ? tr("the right one")
                                                : tr("the middle one");
    const QString number = QString::number(place + 1);
    auto* button = add(number, QStringLiteral("answer.%1").arg(place));
    button->setAccessibleName(tr("%1, %2").arg(number, where));
    button->setToolTip(where);
    return button;
}

void AnswerPanel::buildRanking() {
    for (int i = 0; i < 3; ++i) {
        auto* button = addPlace(i, 3);
        connect(button, &QPushButton::clicked, this, [this, i] { rank(i); });
        m_choices.push_back(button);
    }
    if (m_task == Task::rank3Ties) {
        m_equal = add(tr("Equal to the last (=)"), QStringLiteral("answer.equal"));
        m_equal->setCheckable(true);
        connect(m_equal, &QPushButton::toggled, this, [this](bool on) {
            m_nextEqual = on;
            showRanking();
        });
    }
    m_back = add(tr("Back (⌫)"), QStringLiteral("answer.back"), "quiet");
    connect(m_back, &QPushButton::clicked, this, &AnswerPanel::takeBack);
    m_confirm = add(tr("Confirm (Enter)"), QStringLiteral("answer.confirm"), "primary");
}

void AnswerPanel::setOpen(bool open, const QString& why) {
    if (open == m_open && why == m_whyText)
        return; // this is called every frame
    const bool opened = open && !m_open;
    m_open = open;
    m_whyText = why;
    m_why->setText(why.isEmpty() ? QStringLiteral(" ") : why); // keeps its height
    for (QPushButton* button : m_row->findChildren<QPushButton*>())
        button->setEnabled(open);
    if (m_number) {
        m_number->setEnabled(open);
        if (opened)
            m_number->setFocus(Qt::OtherFocusReason);
    }
    if (psychophysics::ranksThree(m_task))
        showRanking();
}

void AnswerPanel::clear() {
    m_order.clear();
    setNextEqual(false);
    if (m_number)
        m_number->clear();
    if (psychophysics::ranksThree(m_task))
        showRanking();
    emit marksChanged();
}

std::vector<int> AnswerPanel::keys() {
    return {Qt::Key_1,    Qt::Key_2,     Qt::Key_3,     Qt::Key_Y,        Qt::Key_N,
            Qt::Key_Plus, Qt::Key_Minus, Qt::Key_Equal, Qt::Key_Backspace};
}

bool AnswerPanel::key(int key) {
    if (!m_open)
        return false;
    if (m_task == Task::adjustment && (key == Qt::Key_Plus || key == Qt::Key_Equal || key == Qt::Key_Minus)) {
        emit adjusted(key == Qt::Key_Minus ? -1 : 1);
        return true;
    }
    if (m_task == Task::yesNo && (key == Qt::Key_Y || key == Qt::Key_N)) {
        choose(key == Qt::Key_Y ? 1 : 0);
        return true;
    }
    if (psychophysics::ranksThree(m_task) && key == Qt::Key_Backspace) {
        takeBack();
        return true;
    }
    if (m_task == Task::rank3Ties && key == Qt::Key_Equal) {
        m_equal->click();
        return true;
    }
    const int index = key - Qt::Key_1;
    if (m_task == Task::yesNo || index < 0 || index >= static_cast<int>(m_choices.size()))
        return false;
    psychophysics::ranksThree(m_task) ? rank(index) : choose(index);
    return true;
}

void AnswerPanel::enterKey() {
    if (m_confirm && m_confirm->isEnabled())
        confirm();
}

void AnswerPanel::choose(int index) {
    if (m_open)
        emit answered(index, std::nullopt);
}

void AnswerPanel::rank(int place) {
    if (!m_open || m_order.size() >= 3 || std::find(m_order.begin(), m_order.end(), place) != m_order.end())
        return;
    if (m_order.empty())
        emit begun();
    m_ranks[static_cast<std::size_t>(place)] =
        m_order.empty() ? std::int8_t{0}
                        : static_cast<std::int8_t>(m_ranks[static_cast<std::size_t>(m_order.back())] +
                                                   (m_nextEqual ? 0 : 1));
    m_order.push_back(place);
    setNextEqual(false);
    if (m_task == Task::rank3 && m_order.size() == 2) // the last rank follows
        rank(3 - m_order[0] - m_order[1]);
    showRanking();
    emit marksChanged();
}

void AnswerPanel::takeBack() {
    if (m_order.empty())
        return;
    if (m_nextEqual) {
        setNextEqual(false);
    } else {
        m_order.pop_back();
        if (m_task == Task::rank3 && m_order.size() == 2) // the rank that followed
            m_order.pop_back();
    }
    showRanking();
    emit marksChanged();
}

void AnswerPanel::setNextEqual(bool equal) {
    m_nextEqual = equal;
    if (m_equal)
        m_equal->setChecked(equal);
}

void AnswerPanel::showRanking() {
    for (std::size_t i = 0; i < m_choices.size(); ++i)
        m_choices[i]->setEnabled(m_open && std::find(m_order.begin(), m_order.end(), static_cast<int>(i)) ==
                                               m_order.end());
    m_confirm->setEnabled(m_open && m_order.size() == 3);
    m_back->setEnabled(m_open && !m_order.empty());
    if (m_equal)
        m_equal->setEnabled(m_open && !m_order.empty() && m_order.size() < 3);
}

QStringList AnswerPanel::marks() const {
    static const char* const kMarks[] = {QT_TR_NOOP("least"), QT_TR_NOOP("between"), QT_TR_NOOP("most")};
    QStringList marks;
    if (!psychophysics::ranksThree(m_task))
        return marks;
    const auto rankAt = [this](int place) { return m_ranks[static_cast<std::size_t>(place)]; };
    for (int place = 0; place < 3; ++place) {
        if (std::find(m_order.begin(), m_order.end(), place) == m_order.end()) {
            marks << QString();
            continue;
        }
        const auto alike = std::count_if(m_order.begin(), m_order.end(),
                                         [&](int other) { return rankAt(other) == rankAt(place); });
        marks << (m_task == Task::rank3
                      ? tr(kMarks[rankAt(place)])
                      : QString::number(rankAt(place) + 1) + (alike > 1 ? QStringLiteral(" =") : QString()));
    }
    return marks;
}

void AnswerPanel::confirm() {
    if (!m_open)
        return;
    if (psychophysics::ranksThree(m_task) && m_order.size() == 3) {
        emit answered(psychophysics::rankingOf(m_ranks), std::nullopt);
    } else if (m_task == Task::adjustment) {
        emit answered(0, std::nullopt);
    } else if (m_number) {
        bool good = false;
        const double value = m_number->locale().toDouble(m_number->text(), &good);
        if (good && value > 0.0)
            emit answered(0, value);
        else
            m_why->setText(tr("Enter a number above zero."));
    }
}

} // namespace chiron::desktop
