// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/upkeep.h"
#include "desktop/theme/theme.h"

#include <QDialog>
#include <functional>

class QCheckBox;
class QLineEdit;
class QPushButton;
class QVBoxLayout;

namespace chiron::session {
struct BackupEntry;
}

namespace chiron::desktop {

class AppContext;

/// Says what a restore does and asks an administrator for the password: of today's database, and of the backup where that was
/// made under another one. Where that database is damaged or gone, of the backup first.
class RestoreDialog final : public QDialog {
    Q_OBJECT
public:
    /// What the backup is put in the place of.
    enum class Replaces { working, damaged, missing };

    /// `when`: the backup's age in words.
    RestoreDialog(const Theme& theme, const QString& when, const QString& administrator, QWidget* parent, Replaces replaces = Replaces::working);

    /// Puts the names and passwords that were given into the request.
    void fill(database::RestoreRequest& request) const;

    /// Opens one over `parent` and hands the whole request to `restore` once it is confirmed.
    static void ask(AppContext& context, const session::BackupEntry& backup, Replaces replaces, QWidget* parent,
                    std::function<void(database::RestoreRequest)> restore);

private:
    QLineEdit* field(QVBoxLayout& column, const Theme& theme, const QString& name, const QString& label, bool secret);
    void check();
    void showOther(bool shown);

    const Replaces m_replaces;
    QLineEdit* m_name = nullptr;
    QLineEdit* m_password = nullptr;
    QCheckBox* m_other = nullptr;
    QWidget* m_otherBox = nullptr;
    QLineEdit* m_otherName = nullptr;
    QLineEdit* m_otherPassword = nullptr;
    QPushButton* m_confirm = nullptr;
};

} // namespace chiron::desktop
