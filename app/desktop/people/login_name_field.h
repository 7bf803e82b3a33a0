// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"

#include <QWidget>

class QLabel;
class QLineEdit;

namespace chiron::desktop {

/// A field for a login name, with the naming rule below it; the rule shows errors during typing.
/// Thread: GUI.
class LoginNameField final : public QWidget {
    Q_OBJECT
public:
    /// Object name of the field is "<prefix>.name".
    LoginNameField(const Theme& theme, const QString& prefix, QWidget* parent = nullptr);

    QString name() const;
    void setName(const QString& name);
    bool isGood() const { return m_good; }
    void showTaken(); ///< until the text changes
    void focusField();

signals:
    void changed();

private:
    void renew();
    void say(const char* kind, const QString& words);

    QLineEdit* m_field;
    QLabel* m_rule;
    bool m_good = false;
};

} // namespace chiron::desktop
