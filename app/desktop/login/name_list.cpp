// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/login/name_list.h"

#include "desktop/accounts/form.h"
#include "desktop/widgets/kit.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>

namespace chiron::desktop {

namespace {
constexpr int kLoginName = Qt::UserRole;
constexpr int kMostRows_shown = 5;
} // namespace

NameList::NameList(const Theme& theme, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(8));
    m_field = form::textField(theme, column, tr("Name"), QStringLiteral("login.name"));
    m_field->setPlaceholderText(tr("Type your name, or choose it below"));
    m_field->installEventFilter(this);
    m_list = new QListWidget;
    m_list->setObjectName(QStringLiteral("login.people"));
    m_list->setAccessibleName(tr("People who can log in"));
    m_list->setFont(theme.font(TextStyle::body));
    m_list->setUniformItemSizes(true);
    m_list->setMinimumHeight(theme.px(36) * kMostRows_shown);
    column->addWidget(m_list);
    m_none = kit::label(
        theme,
        tr("Nobody with this name can log in here. Ask an administrator; your login name may have changed."),
        TextStyle::small, "muted");
    m_none->setObjectName(QStringLiteral("login.nobody"));
    m_none->hide();
    column->addWidget(m_none);
    connect(m_field, &QLineEdit::textEdited, this, &NameList::filter);
    connect(m_field, &QLineEdit::textChanged, this, &NameList::nameChanged);
    connect(m_field, &QLineEdit::returnPressed, this, &NameList::takeOnlyMatch);
    const auto take = [this](const QListWidgetItem* item) {
        m_field->setText(item->data(kLoginName).toString());
        emit chosen(name());
    };
    connect(m_list, &QListWidget::itemClicked, this, take);
    connect(m_list, &QListWidget::itemActivated, this, take);
    connect(m_list, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        // Typing letters in the list also finds hidden names.
        if (item && !item->isHidden() && m_list->hasFocus())
            m_field->setText(item->data(kLoginName).toString());
    });
}

void NameList::setNames(const std::vector<database::LoginName>& names) {
    m_list->clear();
    for (const database::LoginName& person : names) {
        const QString login = QString::fromStdString(person.name);
        const QString full = QString::fromStdString(person.displayName);
        auto* item =
            new QListWidgetItem(full.isEmpty() || full == login ? login : tr("%1 (%2)").arg(full, login));
        item->setData(kLoginName, login);
        m_list->addItem(item);
    }
    filter();
}

QString NameList::name() const {
    return m_field->text();
}

void NameList::setName(const QString& name) {
    m_field->setText(name);
    filter();
}

void NameList::focusField() {
    m_field->setFocus();
}

void NameList::hideExplanation() {
    m_none->hide();
}

void NameList::filter() {
    const QString typed = m_field->text().trimmed();
    int shown = 0;
    for (int i = 0; i < m_list->count(); ++i) {
        QListWidgetItem* item = m_list->item(i);
        const bool fits = item->text().contains(typed, Qt::CaseInsensitive);
        item->setHidden(!fits);
        shown += fits ? 1 : 0;
    }
    m_none->setVisible(shown == 0 && m_list->count() > 0);
}

void NameList::takeOnlyMatch() {
    QListWidgetItem* only = nullptr;
    int shown = 0;
    for (int i = 0; i < m_list->count(); ++i) {
        if (!m_list->item(i)->isHidden()) {
            only = m_list->item(i);
            ++shown;
        }
    }
    if (shown == 1)
        m_field->setText(only->data(kLoginName).toString());
    if (!name().isEmpty())
        emit chosen(name());
}

bool NameList::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_field && event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Down) {
        for (int i = 0; i < m_list->count(); ++i) {
            if (!m_list->item(i)->isHidden()) {
                m_list->setFocus();
                m_list->setCurrentRow(i);
                break;
            }
        }
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace chiron::desktop
