// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/upkeep/restore_rights.h"
#include "desktop/people/form_dialog.h"

#include <functional>
#include <optional>

class QCheckBox;
class QLabel;
class QLineEdit;

namespace chiron::session {
struct BackupEntry;
}

namespace chiron::desktop {

class FieldNote;
class WaitCountdown;

/// Says what a restore does and asks an administrator for the password: of today's database, and of the backup where that was
/// made under another one. Where that database is damaged or gone, of the backup first. Stays open until the passwords are right, so that
/// nothing of what was chosen is lost.
class RestoreDialog final : public FormDialog {
    Q_OBJECT
public:
    /// What the backup is put in the place of.
    enum class Replaces { working, damaged, missing };

    /// `restore` gets the whole request once it is confirmed and its passwords are right; the dialog is closed by then.
    RestoreDialog(AppContext& context, const session::BackupEntry& backup, Replaces replaces, QWidget* parent,
                  std::function<void(database::RestoreRequest)> restore);

    /// As it is filled in now.
    database::RestoreRequest request() const;

    /// Opens one over `parent`.
    static void ask(AppContext& context, const session::BackupEntry& backup, Replaces replaces, QWidget* parent,
                    std::function<void(database::RestoreRequest)> restore);

private:
    /// A name and its password.
    struct Pair {
        QLineEdit* name = nullptr;
        QLineEdit* password = nullptr;
        FieldNote* note = nullptr;
    };
    Pair addPair(QVBoxLayout& column, const QString& names, const QString& name, const QString& password);
    void addOther(QVBoxLayout& column);
    QLabel* explanation(const QString& objectName, const QString& words) const;
    void check();
    void submit() override;
    void answered(const std::optional<database::RestoreRefusal>& refusal);
    void refused(const database::RestoreRefusal& refusal);
    QString acceptText() const;

    const Replaces m_replaces;
    const std::string m_folder;
    const QString m_administrator; ///< whose name is filled in
    std::function<void(database::RestoreRequest)> m_restore;
    Pair m_first;  ///< of the database that stands here; where that cannot be read, of the backup
    Pair m_second; ///< of the other one, where the box is ticked
    QCheckBox* m_other = nullptr;
    QWidget* m_otherBox = nullptr;
    WaitCountdown* m_wait = nullptr;
};

} // namespace chiron::desktop
