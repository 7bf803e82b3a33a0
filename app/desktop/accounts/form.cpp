// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/form.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/interface_language.h"
#include "desktop/widgets/kit.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QStyle>

namespace chiron::desktop::form {

QLineEdit* textField(const Theme& theme, QVBoxLayout* layout, const QString& label,
                     const QString& objectName) {
    auto* words = kit::label(theme, label, TextStyle::label);
    auto* field = new QLineEdit;
    field->setObjectName(objectName);
    field->setAccessibleName(label);
    field->setFont(theme.font(TextStyle::body));
    words->setBuddy(field);
    auto* pair = new QVBoxLayout;
    pair->setSpacing(theme.px(4));
    pair->addWidget(words);
    pair->addWidget(field);
    layout->addLayout(pair);
    return field;
}

QLineEdit* passwordField(const Theme& theme, QVBoxLayout* layout, const QString& label,
                         const QString& objectName) {
    auto* field = textField(theme, layout, label, objectName);
    field->setEchoMode(QLineEdit::Password);
    field->setInputMethodHints(Qt::ImhSensitiveData | Qt::ImhNoPredictiveText | Qt::ImhNoAutoUppercase);
    return field;
}

Foot addFoot(const Theme& theme, QVBoxLayout* layout, QPushButton* back, QPushButton* next) {
    // The notice needs no room of its own, because nothing stands below the buttons that could move.
    const Foot foot{new QWidget, new NoticeArea(theme, NoticeArea::Room::none)};
    auto* column = new QVBoxLayout(foot.widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    layout->addWidget(foot.widget);
    column->addWidget(foot.notice);
    auto* row = new QHBoxLayout;
    row->addWidget(back);
    row->addStretch();
    row->addWidget(next);
    column->addLayout(row);
    return foot;
}

void setKind(QWidget* widget, const char* kind) {
    if (widget->property("kind") == QLatin1String(kind))
        return;
    widget->setProperty("kind", QLatin1String(kind));
    widget->style()->unpolish(widget);
    widget->style()->polish(widget);
}

QComboBox* languageChoice(AppContext& context) {
    auto* choice = new QComboBox;
    choice->setObjectName(QStringLiteral("accounts.language"));
    choice->setAccessibleName(QCoreApplication::translate("AccountForm", "Language"));
    for (const auto& [id, name] : languageChoices())
        choice->addItem(name, id);
    choice->setCurrentIndex(choice->findData(context.language()));
    QObject::connect(
        choice, &QComboBox::activated, &context,
        [&context, choice] { context.setStationLanguage(choice->currentData().toString()); },
        Qt::QueuedConnection);
    return choice;
}

} // namespace chiron::desktop::form
