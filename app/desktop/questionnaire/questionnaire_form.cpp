// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/questionnaire/questionnaire_form.h"

#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QButtonGroup>
#include <QDateTime>
#include <QDoubleValidator>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QShortcut>
#include <QSlider>
#include <algorithm>

namespace chiron::desktop {

using psychophysics::QuestionnaireItem;

namespace {
constexpr int kMostButtons = 11; // more of them are hard to distinguish, so a slider is used
}

QuestionnaireForm::QuestionnaireForm(const Theme& theme, const QLocale& locale,
                                     const psychophysics::Questionnaire& questionnaire,
                                     const QString& language, QWidget* parent)
    : QWidget(parent), m_theme(theme), m_locale(locale), m_questionnaire(questionnaire),
      m_language(language) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(14));
    for (const QuestionnaireItem& item : m_questionnaire.items)
        addItem(item);
}

void QuestionnaireForm::addItem(const QuestionnaireItem& item) {
    const kit::Box box = kit::box(m_theme);
    const QString words = study_words::text(item.text, m_language);
    box.layout->addWidget(
        kit::label(m_theme, item.required ? words : tr("%1 (optional)").arg(words), TextStyle::strong));
    Item added{
        &item, kit::label(m_theme, tr("Please answer this question."), TextStyle::small, "bad"), nullptr, {}};
    const QString name = QStringLiteral("questionnaire.%1").arg(QString::fromStdString(item.id));
    switch (item.kind) {
    case QuestionnaireItem::Kind::likert:
        item.scale > kMostButtons ? addSlider(*box.layout, added, name) : addLikert(*box.layout, added, name);
        break;
    case QuestionnaireItem::Kind::choice:
        addChoice(*box.layout, added, name);
        break;
    case QuestionnaireItem::Kind::number:
        addNumber(*box.layout, added, name);
        break;
    case QuestionnaireItem::Kind::text:
        addText(*box.layout, added, name);
        break;
    }
    added.missing->hide();
    box.layout->addWidget(added.missing);
    m_items.push_back(std::move(added));
    layout()->addWidget(box.frame);
}

/// The meanings of the two ends of a scale.
QLayout* QuestionnaireForm::ends(const Item& item) const {
    auto* row = new QHBoxLayout;
    row->addWidget(
        kit::label(m_theme, study_words::text(item.asked->low, m_language), TextStyle::body, "muted"), 1);
    auto* high =
        kit::label(m_theme, study_words::text(item.asked->high, m_language), TextStyle::body, "muted");
    high->setAlignment(Qt::AlignRight);
    row->addWidget(high, 1);
    return row;
}

void QuestionnaireForm::addLikert(QLayout& layout, Item& item, const QString& name) {
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(ends(item));
    auto* row = new QHBoxLayout;
    auto* group = new QButtonGroup(part);
    for (int step = 1; step <= item.asked->scale; ++step) {
        auto* button = new QRadioButton;
        button->setObjectName(QStringLiteral("%1.%2").arg(name).arg(step));
        button->setAccessibleName(tr("%1 of %2").arg(step).arg(item.asked->scale));
        button->setFocusPolicy(Qt::StrongFocus);
        group->addButton(button, step);
        if (step > 1)
            row->addStretch(1);
        row->addWidget(button);
        if (!item.first)
            item.first = button;
    }
    column->addLayout(row);
    layout.addWidget(part);
    connect(group, &QButtonGroup::idClicked, this, &QuestionnaireForm::changed);
    item.read = [group](database::QuestionnaireAnswer& answer) {
        if (group->checkedId() < 1)
            return false;
        answer.number = group->checkedId();
        return true;
    };
}

/// A scale of many steps. It counts as unanswered until it was moved or clicked, so that no answer comes from
/// the program.
void QuestionnaireForm::addSlider(QLayout& layout, Item& item, const QString& name) {
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(ends(item));
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setObjectName(name);
    slider->setAccessibleName(study_words::text(item.asked->text, m_language));
    slider->setRange(1, item.asked->scale);
    slider->setValue((item.asked->scale + 1) / 2);
    slider->setPageStep(1);
    slider->setTickPosition(QSlider::TicksBelow);
    slider->setTickInterval(1);
    slider->setFocusPolicy(Qt::StrongFocus);
    column->addWidget(slider);
    auto* state = kit::label(
        m_theme, tr("Not answered yet: move the slider, or press Space to leave it in the middle."),
        TextStyle::small, "muted");
    state->setObjectName(name + QStringLiteral(".state"));
    column->addWidget(state);
    layout.addWidget(part);
    const auto answer = [this, slider, state, scale = item.asked->scale] {
        slider->setProperty("answered", true);
        state->setText(tr("Step %1 of %2").arg(m_locale.toString(slider->value()), m_locale.toString(scale)));
        emit changed();
    };
    connect(slider, &QSlider::valueChanged, this, answer);
    connect(slider, &QSlider::sliderPressed, this, answer);
    auto* middle = new QShortcut(QKeySequence(Qt::Key_Space), slider);
    middle->setContext(Qt::WidgetShortcut);
    connect(middle, &QShortcut::activated, this, answer);
    item.first = slider;
    item.read = [slider](database::QuestionnaireAnswer& read) {
        if (!slider->property("answered").toBool())
            return false;
        read.number = slider->value();
        return true;
    };
}

void QuestionnaireForm::addChoice(QLayout& layout, Item& item, const QString& name) {
    auto* group = new QButtonGroup(this);
    for (std::size_t i = 0; i < item.asked->choices.size(); ++i) {
        auto* button = new QRadioButton(study_words::text(item.asked->choices[i], m_language));
        button->setObjectName(QStringLiteral("%1.%2").arg(name).arg(i));
        button->setFont(m_theme.font(TextStyle::body));
        button->setFocusPolicy(Qt::StrongFocus);
        group->addButton(button, static_cast<int>(i));
        layout.addWidget(button);
        if (!item.first)
            item.first = button;
    }
    connect(group, &QButtonGroup::idClicked, this, &QuestionnaireForm::changed);
    item.read = [group](database::QuestionnaireAnswer& answer) {
        if (group->checkedId() < 0)
            return false;
        answer.number = group->checkedId();
        return true;
    };
}

void QuestionnaireForm::addNumber(QLayout& layout, Item& item, const QString& name) {
    auto* field = new QLineEdit;
    field->setObjectName(name);
    field->setAccessibleName(study_words::text(item.asked->text, m_language));
    field->setMaximumWidth(m_theme.px(200));
    field->setLocale(m_locale);
    if (item.asked->highest > item.asked->lowest)
        layout.addWidget(kit::label(m_theme,
                                    tr("From %1 to %2")
                                        .arg(study_words::plainNumber(item.asked->lowest, m_locale),
                                             study_words::plainNumber(item.asked->highest, m_locale)),
                                    TextStyle::small, "muted"));
    layout.addWidget(field);
    item.first = field;
    connect(field, &QLineEdit::textChanged, this, &QuestionnaireForm::changed);
    item.read = [field, asked = item.asked, locale = m_locale](database::QuestionnaireAnswer& answer) {
        bool good = false;
        const double value = locale.toDouble(field->text().trimmed(), &good);
        const bool bounded = asked->highest > asked->lowest;
        if (!good || (bounded && (value < asked->lowest || value > asked->highest)))
            return false;
        answer.number = value;
        return true;
    };
}

void QuestionnaireForm::addText(QLayout& layout, Item& item, const QString& name) {
    auto* field = new QPlainTextEdit;
    field->setObjectName(name);
    field->setAccessibleName(study_words::text(item.asked->text, m_language));
    field->setTabChangesFocus(true);
    field->setFixedHeight(m_theme.px(96));
    layout.addWidget(field);
    item.first = field;
    connect(field, &QPlainTextEdit::textChanged, this, &QuestionnaireForm::changed);
    item.read = [field](database::QuestionnaireAnswer& answer) {
        answer.text = field->toPlainText().trimmed().toStdString();
        return !answer.text.empty();
    };
}

std::vector<database::QuestionnaireAnswer> QuestionnaireForm::answers(database::ParticipantNumber participant,
                                                                      database::StudyRunNumber run) const {
    std::vector<database::QuestionnaireAnswer> answers;
    for (const Item& item : m_items) {
        database::QuestionnaireAnswer answer;
        answer.participant = participant;
        answer.questionnaire = m_questionnaire.id;
        answer.item = item.asked->id;
        answer.run = run;
        answer.language = study_words::shownLanguage(item.asked->text, m_language);
        answer.utc = QDateTime::currentDateTimeUtc().toString(Qt::ISODateWithMs).toStdString();
        if (item.read(answer))
            answers.push_back(std::move(answer));
    }
    return answers;
}

int QuestionnaireForm::answered() const {
    return static_cast<int>(answers(0).size());
}

bool QuestionnaireForm::showMissing() {
    QWidget* first = nullptr;
    for (const Item& item : m_items) {
        database::QuestionnaireAnswer answer;
        const bool missing = item.asked->required && !item.read(answer);
        item.missing->setVisible(missing);
        if (missing && !first)
            first = item.first;
    }
    if (first)
        first->setFocus(Qt::OtherFocusReason);
    return first != nullptr;
}

} // namespace chiron::desktop
