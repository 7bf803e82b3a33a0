// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>
#include <string>
#include <vector>

class QLabel;
class QLineEdit;

namespace chiron::desktop {

/// Two fields for a new password, with the password rules ticked off during typing. The rules belong to the
/// data layer (database/accounts/account_rules.h).
/// Thread: GUI.
class PasswordFields : public QWidget {
    Q_OBJECT
public:
    /// Object names are "<prefix>.password" and "<prefix>.repeat".
    PasswordFields(const Theme& theme, const QString& prefix, QWidget* parent = nullptr);

    void setLoginName(const QString& name); ///< the password must differ from this name
    bool isGood() const { return m_good; }
    std::string password() const;
    void focusFirst();
    void clear();

signals:
    void changed();
    void submitted(); ///< Return was pressed in the second field

private:
    enum Rule { longEnough, varied, notTheName, twice, ruleCount };
    struct Line {
        QLabel* sign = nullptr;
        QLabel* words = nullptr;
    };
    void addRule(const QString& text);
    void renew();

    const Theme& m_theme;
    QLineEdit* m_password;
    QLineEdit* m_repeat;
    QWidget* m_rules;
    std::vector<Line> m_lines;
    QString m_name;
    bool m_good = false;
};

} // namespace chiron::desktop
