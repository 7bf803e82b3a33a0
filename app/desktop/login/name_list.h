// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/theme/theme.h"

#include <QWidget>
#include <vector>

class QLabel;
class QLineEdit;
class QListWidget;

namespace chiron::desktop {

/// Who may log in: a field to type a name in, and under it the people whose names go with what is typed. GUI thread.
class NameList final : public QWidget {
    Q_OBJECT
public:
    explicit NameList(const Theme& theme, QWidget* parent = nullptr);

    void setNames(const std::vector<database::LoginName>& names);
    QString name() const; ///< login name as typed or chosen
    void setName(const QString& name);
    void focusField();
    void hideExplanation(); ///< why the list is empty, until another name is typed: something else is said about it

signals:
    void chosen(const QString& name); ///< by click, Return or Enter: the password is next
    void nameChanged();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void filter();
    void takeOnlyMatch();

    QLineEdit* m_field;
    QListWidget* m_list;
    QLabel* m_none;
};

} // namespace chiron::desktop
