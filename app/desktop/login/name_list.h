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

/// Chooses who logs in: a field to type a name into, and below it the people whose names contain the typed
/// text.
/// Thread: GUI.
class NameList final : public QWidget {
    Q_OBJECT
public:
    explicit NameList(const Theme& theme, QWidget* parent = nullptr);

    void setNames(const std::vector<database::LoginName>& names);
    QString name() const; ///< the login name as typed or chosen
    void setName(const QString& name);
    void focusField();
    /// Hides the reason why the list is empty, until the name changes, because another message concerns that
    /// name.
    void hideExplanation();

signals:
    void chosen(const QString& name); ///< by click, Return or Enter; the password comes next
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
