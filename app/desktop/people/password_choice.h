// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>
#include <string>

class QRadioButton;

namespace chiron::desktop {

class PasswordFields;

/// A password for somebody else: made by the program, or typed. Either must be changed at the next login. GUI thread.
class PasswordChoice final : public QWidget {
    Q_OBJECT
public:
    PasswordChoice(const Theme& theme, const QString& prefix, QWidget* parent = nullptr);

    void setLoginName(const QString& name);
    bool isGood() const;
    bool isGenerated() const;
    std::string password() const; ///< a fresh one at each call where it is generated

signals:
    void changed();

private:
    QRadioButton* m_generate;
    QRadioButton* m_type;
    PasswordFields* m_fields;
};

/// What is shown when somebody has got a password from an administrator: once, to hand it over.
QWidget* handedPassword(const Theme& theme, const QString& headline, const QString& loginName, const QString& password);

} // namespace chiron::desktop
