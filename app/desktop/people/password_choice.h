// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>
#include <string>

class QRadioButton;

namespace chiron::desktop {

class PasswordFields;

/// Sets a password for another person, either generated or typed. It must be changed at the next login.
/// Thread: GUI.
class PasswordChoice final : public QWidget {
    Q_OBJECT
public:
    PasswordChoice(const Theme& theme, const QString& prefix, QWidget* parent = nullptr);

    void setLoginName(const QString& name);
    bool isGood() const;
    bool isGenerated() const;
    std::string password() const; ///< if generated, a new one at each call

signals:
    void changed();

private:
    QRadioButton* m_generate;
    QRadioButton* m_type;
    PasswordFields* m_fields;
};

/// Shows once the password that an administrator has set for somebody, so that it can be handed over.
QWidget* handedPassword(const Theme& theme, const QString& headline, const QString& loginName,
                        const QString& password);

} // namespace chiron::desktop
