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

/// Explains what a restore does and asks an administrator for the password of the current database, and also
/// for that of the backup if it differs. If the database is damaged or missing, it asks for that of the
/// backup first. The dialog stays open until the passwords are right, so that the selection is not lost.
class RestoreDialog final : public FormDialog {
    Q_OBJECT
public:
    /// The state of the database that the backup replaces.
    enum class Replaces { working, damaged, missing };

    /// `restore` receives the complete request once it is confirmed and its passwords are right. The dialog
    /// is closed by then.
    RestoreDialog(AppContext& context, const session::BackupEntry& backup, Replaces replaces, QWidget* parent,
                  std::function<void(database::RestoreRequest)> restore);

    /// The request as currently filled in.
    database::RestoreRequest request() const;

    /// Opens a dialog over `parent`.
    static void ask(AppContext& context, const session::BackupEntry& backup, Replaces replaces,
                    QWidget* parent, std::function<void(database::RestoreRequest)> restore);

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
    const QString m_administrator; ///< prefilled name
    std::function<void(database::RestoreRequest)> m_restore;
    Pair m_first;  ///< for the present database; if that cannot be read, for the backup
    Pair m_second; ///< for the other one, if the box is ticked
    QCheckBox* m_other = nullptr;
    QWidget* m_otherBox = nullptr;
    WaitCountdown* m_wait = nullptr;
};

} // namespace chiron::desktop
