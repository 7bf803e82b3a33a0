// SPDX-License-Identifier: GPL-3.0-or-later
// Unblinding and exports.
#include "desktop/study_data/replaced_folder.h"
#include "desktop/study_data/study_data_screen.h"
#include "desktop/study_data/unblind_dialog.h"

#include "database/repositories/site_repository.h"
#include "desktop/frame/file_folder.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"
#include "report/plot_theme.h"
#include "session/study/people_to_come.h"
#include "session/study_export.h"
#include "session_report/study_report.h"

#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPointer>
#include <QProgressDialog>
#include <QTimer>

namespace chiron::desktop {

QWidget* StudyDataScreen::toolRow() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const auto add = [&](const char* name, const QString& text, const char* icon, auto act) {
        auto* button = kit::button(theme, text, "", QLatin1String(icon));
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    add("data.csv", tr("CSV …"), "document-export-table",
        [this] { askFolder(&StudyDataScreen::exportCsvTo); });
    add("data.bids", tr("BIDS …"), "document-export", [this] { askFolder(&StudyDataScreen::exportBidsTo); });
    add("data.pdf", tr("PDF …"), "document-print", [this] { askPdf(); });
    const bool own =
        m_facts.study.summary.author == context().actor().personId() || context().has(database::Role::admin);
    if (m_facts.study.blind() && own)
        add("data.unblind", tr("Unblind …"), "object-unlocked", [this] { askUnblind(); });
    return bar;
}

std::vector<ScreenCommand> StudyDataScreen::commands() {
    return {{tr("Export as CSV"), {}, [this] { askFolder(&StudyDataScreen::exportCsvTo); }},
            {tr("Save as PDF"), QKeySequence(QKeySequence::Print), [this] { askPdf(); }},
            {tr("Export as BIDS"), {}, [this] { askFolder(&StudyDataScreen::exportBidsTo); }}};
}

void StudyDataScreen::askUnblind() {
    std::vector<database::Participant> people;
    for (const ParticipantRow& row : m_facts.study.participants)
        people.push_back(row.participant);
    auto* dialog = new UnblindDialog(
        context(), m_study, session::peopleToCome(m_facts.study.design, m_facts.study.summary, people),
        window());
    connect(dialog, &UnblindDialog::changed, this, &StudyDataScreen::load);
    dialog->open();
}

/// Returns whether an export can start now; otherwise says why not.
bool StudyDataScreen::mayExport() {
    if (m_panel->state() != StatePanel::State::content)
        context().messages().information(
            tr("The study is not on the screen yet, so nothing was exported. Try again once it is there."));
    else if (m_exporting)
        context().messages().information(tr("The previous export is still being written. Try again once the "
                                            "message says where it was written."));
    else
        return true;
    return false;
}

/// Says that nothing was exported when the dialog is closed.
void StudyDataScreen::tellIfCancelled(QFileDialog* dialog) {
    connect(dialog, &QDialog::rejected, this,
            [this] { context().messages().information(tr("Nothing was exported: no place was chosen.")); });
}

void StudyDataScreen::askFolder(void (StudyDataScreen::*then)(const QString&)) {
    if (!mayExport())
        return;
    auto* dialog = new QFileDialog(this, tr("Choose a location for the folder"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::Directory);
    dialog->setOption(QFileDialog::ShowDirsOnly);
    dialog->setObjectName(QStringLiteral("data.folder"));
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("study_tables"));
    connect(dialog, &QFileDialog::fileSelected, this, then);
    tellIfCancelled(dialog);
    dialog->open();
}

void StudyDataScreen::exportTo(
    const ExportWords& words,
    const std::function<core::Result<void>(database::Connection&, database::StudyReader&)>& write) {
    const QPointer<QProgressDialog> progress = new QProgressDialog(words.writing, QString(), 0, 0, this);
    progress->setWindowModality(Qt::WindowModal);
    progress->setMinimumDuration(500); // shorter work needs no window
    progress->setValue(0);
    m_exporting = true;
    context().background().run(
        &context(), // so that people who moved to another screen get the result as well
        [&database = context().site().database(), actor = context().actor(),
         write](WorkToken&) -> core::Result<void> {
            auto connection = database.openReader();
            CHIRON_TRY(connection);
            database::StudyReader reader(**connection, actor);
            return write(**connection, reader);
        },
        [&app = context(), screen = QPointer<StudyDataScreen>(this), progress,
         words](const core::Result<void>& done) {
            if (progress)
                progress->deleteLater();
            if (screen)
                screen->m_exporting = false;
            if (done)
                app.messages().done(words.written);
            else
                app.messages().error(words.failed, done.error());
        });
}

/// Mentions that there are no scored trials, because an empty export looks like a failed one.
QString StudyDataScreen::written(const QString& where) const {
    return m_facts.study.summary.trials > 0
               ? where
               : where + QLatin1Char(' ') + tr("There are no scored trials yet.");
}

void StudyDataScreen::chooseFolder(const QString& folder,
                                   const std::function<void(const QString&, bool)>& then) {
    if (!QFileInfo::exists(folder))
        return then(folder, false);
    const bool ours = QFileInfo::exists(QDir(folder).filePath(QStringLiteral("dataset_description.json")));
    auto* box = new QMessageBox(QMessageBox::Question, title(),
                                tr("%1 already exists.").arg(QDir::toNativeSeparators(folder)),
                                QMessageBox::NoButton, window());
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setObjectName(QStringLiteral("data.there"));
    box->setInformativeText(
        ours ? tr("It is an earlier export. You can replace it with the data as they are now, or keep it and "
                  "write the new export beside it.")
             : tr("It is not an export of a study, so it is not replaced. You can write the export beside "
                  "it."));
    QPushButton* cancel = box->addButton(tr("Cancel"), QMessageBox::RejectRole);
    cancel->setObjectName(QStringLiteral("data.there.cancel"));
    QPushButton* replace = ours ? box->addButton(tr("Replace"), QMessageBox::DestructiveRole) : nullptr;
    if (replace)
        replace->setObjectName(QStringLiteral("data.there.replace"));
    QPushButton* beside = box->addButton(tr("Write beside it"), QMessageBox::AcceptRole);
    beside->setObjectName(QStringLiteral("data.there.beside"));
    box->setDefaultButton(beside);
    box->setEscapeButton(cancel);
    connect(box, &QMessageBox::buttonClicked, this,
            [this, folder, then, replace, beside](const QAbstractButton* pressed) {
                if (pressed == beside)
                    then(freeFolder(folder), false);
                else if (replace && pressed == replace)
                    then(folder, true);
                else
                    context().messages().information(
                        tr("Nothing was exported. %1 is as it was.").arg(QDir::toNativeSeparators(folder)));
            });
    box->open();
}

void StudyDataScreen::exportCsvTo(const QString& parent) {
    chooseFolder(
        QDir(parent).filePath(QString::fromStdString(m_facts.study.summary.key) + QStringLiteral("-csv")),
        [this](const QString& folder, bool replaces) {
            const ExportWords words{tr("Writing the tables …"),
                                    written(tr("The tables were written to %1.").arg(folder)),
                                    tr("The tables could not be written.")};
            exportTo(words, [study = m_study, folder, replaces](database::Connection&,
                                                                database::StudyReader& reader) {
                return inPlaceOf(folder, replaces, [&] {
                    return session::exportStudyCsv(reader, study, folder.toStdString());
                });
            });
        });
}

void StudyDataScreen::exportBidsTo(const QString& parent) {
    chooseFolder(
        QDir(parent).filePath(QString::fromStdString(m_facts.study.summary.key) + QStringLiteral("-bids")),
        [this](const QString& folder, bool replaces) {
            const ExportWords words{tr("Writing the BIDS dataset …"),
                                    written(tr("The BIDS dataset was written to %1.").arg(folder)),
                                    tr("The BIDS dataset could not be written.")};
            exportTo(words, [study = m_study, folder, replaces, actor = context().actor()](
                                database::Connection& connection, database::StudyReader& reader) {
                return inPlaceOf(folder, replaces, [&] {
                    return session::exportStudyBids(reader, connection, actor, study, folder.toStdString());
                });
            });
        });
}

void StudyDataScreen::askPdf() {
    if (!mayExport())
        return;
    auto* dialog = new QFileDialog(this, tr("Save as PDF"), QString(), tr("PDF (*.pdf)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("pdf"));
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("study_reports"));
    dialog->selectFile(QString::fromStdString(m_facts.study.summary.key) + QStringLiteral(".pdf"));
    connect(dialog, &QFileDialog::fileSelected, this, &StudyDataScreen::exportPdfTo);
    tellIfCancelled(dialog);
    dialog->open();
}

void StudyDataScreen::exportPdfTo(const QString& file) {
    QApplication::setOverrideCursor(Qt::WaitCursor); // plots are drawn on the GUI thread
    auto connection = context().site().database().openReader();
    core::Result<void> done;
    if (connection) {
        database::StudyReader reader(**connection, context().actor());
        const auto site = database::SiteRepository(**connection, context().actor()).siteName();
        done = session_report::writeStudyReport(
            file, reader, m_study, report::lightTheme(context().locale()), context().language().toStdString(),
            {.withShown = m_withShown}, QString::fromStdString(site.value_or("")));
    } else {
        done = tl::unexpected(connection.error());
    }
    QApplication::restoreOverrideCursor();
    if (done)
        context().messages().done(tr("The report was written to %1.").arg(file));
    else
        context().messages().error(tr("The report could not be written."), done.error());
}

} // namespace chiron::desktop
