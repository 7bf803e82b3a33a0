// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/whole_file.h"
#include "database/accounts/account_service.h"
#include "database/repositories/privacy_repository.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/people/add_person_dialog.h"
#include "desktop/people/edit_person_dialog.h"
#include "desktop/people/erase_dialog.h"
#include "desktop/people/erase_participant_dialog.h"
#include "desktop/people/people_model.h"
#include "desktop/people/people_screen.h"
#include "desktop/people/reset_password_dialog.h"
#include "desktop/people/roles_dialog.h"
#include "desktop/people/roster_dialog.h"
#include "desktop/people/roster_template.h"
#include "session/person_json.h"

#include <QDir>
#include <QFileDialog>
#include <QJsonDocument>
#include <QLineEdit>
#include <QPointer>
#include <QSaveFile>

// Actions on people. For every action the data layer checks who asks.
namespace chiron::desktop {

namespace {

constexpr qint64 kLargestRoster_bytes = 4 << 20;

core::Result<void> writeExport(database::Database& database, const database::Actor& actor,
                               database::PersonId person, const QString& name) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    const auto everything = database::PrivacyRepository(**reader, actor).exportPerson(person);
    CHIRON_TRY(everything);
    const QByteArray json = QJsonDocument(session::personExportJson(*everything)).toJson();
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly) || !file.setPermissions(QFile::ReadOwner | QFile::WriteOwner) ||
        file.write(json) != json.size() || !file.commit())
        return core::fail(core::ErrorCode::storage,
                          name.toStdString() + ": " + file.errorString().toStdString());
    return {};
}

/// Opens a file dialog without blocking the program. `chosen` receives the file.
template <class Chosen>
void askFile(QWidget* owner, Settings& settings, const QString& purpose, const QString& title,
             QFileDialog::AcceptMode mode, const QString& suggestion, const QString& filter, Chosen chosen) {
    auto* dialog = new QFileDialog(owner, title);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(mode);
    dialog->setFileMode(mode == QFileDialog::AcceptSave ? QFileDialog::AnyFile : QFileDialog::ExistingFile);
    beginInLastFolder(settings, *dialog, purpose);
    dialog->setNameFilter(filter);
    if (mode == QFileDialog::AcceptSave)
        dialog->setDefaultSuffix(QFileInfo(suggestion).suffix());
    dialog->selectFile(suggestion);
    QObject::connect(dialog, &QFileDialog::fileSelected, owner, chosen);
    dialog->open();
}

} // namespace

std::vector<ScreenCommand> PeopleScreen::commands() {
    std::vector<ScreenCommand> list{
        {tr("Add a person"), QKeySequence(Qt::CTRL | Qt::Key_N), [this] { addPerson(); }},
        {tr("Import roster"), {}, [this] { askRoster(); }},
        {tr("Save a template for a roster"), {}, [this] { askTemplate(); }},
        {tr("Erase a study participant"), {}, [this] { eraseParticipant(); }},
        {tr("Find a person"), QKeySequence::Find, [this] { m_search->setFocus(); }}};
    const auto withPerson = [this, &list](const QString& text, void (PeopleScreen::*act)()) {
        list.push_back({text, {}, [this, act] {
                            if (chosen())
                                (this->*act)();
                            else
                                context().messages().information(tr("Choose a person in the list first."));
                        }});
    };
    withPerson(tr("Edit name and login name"), &PeopleScreen::editPerson);
    withPerson(tr("Change roles"), &PeopleScreen::editRoles);
    withPerson(tr("Reset password"), &PeopleScreen::resetPassword);
    withPerson(tr("Disable or enable"), &PeopleScreen::toggleEnabled);
    withPerson(tr("Export all data"), &PeopleScreen::askExport);
    withPerson(tr("Erase"), &PeopleScreen::erase);
    return list;
}

void PeopleScreen::open(FormDialog* dialog) {
    connect(dialog, &FormDialog::changed, this, &PeopleScreen::load);
    connect(dialog, &FormDialog::changed, &context(), &AppContext::renewRoles); // perhaps one's own
    dialog->open();
}

void PeopleScreen::addPerson() {
    open(new AddPersonDialog(context(), this));
}

void PeopleScreen::editPerson() {
    open(new EditPersonDialog(context(), *chosen(), this));
}

void PeopleScreen::editRoles() {
    open(new RolesDialog(context(), *chosen(), this));
}

void PeopleScreen::resetPassword() {
    open(new ResetPasswordDialog(context(), *chosen(), this));
}

void PeopleScreen::erase() {
    open(new EraseDialog(context(), *chosen(), this));
}

void PeopleScreen::eraseParticipant() {
    open(new EraseParticipantDialog(context(), this));
}

void PeopleScreen::toggleEnabled() {
    const database::Person person = *chosen();
    setEnabledOf(person, !person.enabled);
}

void PeopleScreen::setEnabledOf(const database::Person& person, bool enabled) {
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), id = person.id, enabled](WorkToken&) {
            return database::AccountService(*database).setEnabled(actor, id, enabled);
        },
        [this, person, enabled](core::Result<void> done) {
            const QString name = QString::fromStdString(person.name);
            if (done) {
                load();
                context().messages().tell(
                    {MessageKind::done,
                     enabled ? tr("%1 can log in again.").arg(name)
                             : tr("%1 can no longer log in. Recorded data are kept.").arg(name),
                     tr("Undo"), [self = QPointer<PeopleScreen>(this), person, enabled] {
                         if (self)
                             self->setEnabledOf(person, !enabled);
                     }});
            } else if (done.error().code == core::ErrorCode::wrongUse) {
                // This is the only rule that it can violate.
                context().messages().warning(tr("%1 stays enabled: the site needs at least one administrator "
                                                "who can log in. Make another "
                                                "person an administrator first.")
                                                 .arg(name));
            } else {
                context().messages().error(tr("The account of %1 was not changed.").arg(name), done.error());
            }
        });
}

void PeopleScreen::askExport() {
    const QString name = QString::fromStdString(chosen()->name);
    askFile(this, context().settings(), QStringLiteral("person_data"),
            tr("Export all data about %1").arg(name), QFileDialog::AcceptSave, name + QStringLiteral(".json"),
            tr("JSON (*.json)"), [this](const QString& file) { exportTo(file); });
}

void PeopleScreen::exportTo(const QString& file) {
    if (!chosen())
        return;
    database::Database* database = &context().site().database();
    const QString name = QString::fromStdString(chosen()->name);
    context().background().run(
        this,
        [database, actor = context().actor(), id = m_chosen, file](WorkToken&) {
            return writeExport(*database, actor, id, file);
        },
        [this, name, file](core::Result<void> done) {
            if (done)
                context().messages().done(
                    tr("All data about %1 were exported to %2.").arg(name, QDir::toNativeSeparators(file)));
            else
                context().messages().error(tr("Nothing was exported about %1.").arg(name), done.error());
        });
}

void PeopleScreen::askRoster() {
    askFile(this, context().settings(), QStringLiteral("rosters"), tr("Import people from a CSV file"),
            QFileDialog::AcceptOpen, {}, tr("CSV (*.csv);;All files (*)"),
            [this](const QString& file) { importRoster(file); });
}

void PeopleScreen::askTemplate() {
    askFile(this, context().settings(), QStringLiteral("rosters"), tr("Save a template for a roster"),
            QFileDialog::AcceptSave, tr("roster") + QStringLiteral(".csv"), tr("CSV (*.csv)"),
            [this](const QString& file) { saveTemplate(file); });
}

void PeopleScreen::saveTemplate(const QString& file) {
    const auto done = writeRosterTemplate(file, context().locale());
    if (done)
        context().messages().done(tr("The template was saved to %1. Replace the example lines, save the file "
                                     "as CSV, then import it here.")
                                      .arg(QDir::toNativeSeparators(file)));
    else
        context().messages().error(tr("The template was not saved."), done.error());
}

void PeopleScreen::importRoster(const QString& name) {
    const auto text = catalogue::readWholeFile(name, kLargestRoster_bytes);
    if (!text) {
        context().messages().warning(
            tr("%1 cannot be read, or is too large for a list of people. Nothing was changed.")
                .arg(QDir::toNativeSeparators(name)));
        return;
    }
    open(new RosterDialog(context(), QFileInfo(name).fileName(), text->toStdString(), this));
}

} // namespace chiron::desktop
