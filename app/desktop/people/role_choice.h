// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/role.h"
#include "desktop/theme/theme.h"

#include <QWidget>
#include <map>

class QCheckBox;

namespace chiron::desktop {

/// Check boxes for the roles, each with a description of what it permits.
/// Thread: GUI.
class RoleChoice final : public QWidget {
    Q_OBJECT
public:
    /// Object names are "<prefix>.trainee", ...
    RoleChoice(const Theme& theme, const QString& prefix, const database::RoleSet& roles,
               QWidget* parent = nullptr);
    database::RoleSet roles() const;

signals:
    void changed();

private:
    std::map<database::Role, QCheckBox*> m_boxes;
};

} // namespace chiron::desktop
