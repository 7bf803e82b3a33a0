// SPDX-License-Identifier: GPL-3.0-or-later
// Actions on the list of studies.
#include "catalogue/study_json.h"

#include "catalogue/whole_file.h"
#include "desktop/frame/file_folder.h"
#include "desktop/studies/new_study_dialog.h"
#include "desktop/studies/studies_screen.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/studies/study_words.h"

#include <QCheckBox>
#include <QFileDialog>
#include <QMessageBox>
#include <QPointer>
#include <QPushButton>

namespace chiron::desktop {

namespace {
constexpr qint64 kLargestStudy_bytes = 1 << 20;
}

void StudiesScreen::askNew() {
    auto* dialog = new NewStudyDialog(context(), this);
    connect(dialog, &NewStudyDialog::created, this, [this](qlonglong study) {
        context().navigator().go(QStringLiteral("study"), {{QStringLiteral("study"), study}});
    });
    dialog->open();
}

void StudiesScreen::askCopy() {
    const database::StudySummary* study = selected();
    if (!study)
        return;
    readStudies(
        context(), this, [id = study->id](database::StudyReader& reader) { return openStudy(reader, id); },
        [this](const core::Result<OpenStudy>& open) {
            if (!open) {
                context().messages().error(tr("The study could not be read."), open.error(), Tried::reading);
                return;
            }
            if (open->masked) { // its conditions would be codes
                context().messages().information(tr("The study is blind. Only its author and administrators "
                                                    "can copy it before it is unblinded."));
                return;
            }
            auto* dialog = new NewStudyDialog(context(), open->design, this);
            connect(dialog, &NewStudyDialog::created, this, [this](qlonglong copy) {
                context().navigator().go(QStringLiteral("study"), {{QStringLiteral("study"), copy}});
            });
            dialog->open();
        });
}

void StudiesScreen::askFile() {
    auto* dialog = new QFileDialog(this, tr("Import a study"), QString(), tr("Studies (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("studies"));
    connect(dialog, &QFileDialog::fileSelected, this, &StudiesScreen::importFile);
    dialog->open();
}

void StudiesScreen::importFile(const QString& file) {
    const auto text = catalogue::readWholeFile(file, kLargestStudy_bytes);
    if (!text) {
        context().messages().error(tr("The file could not be read."), text.error(), Tried::reading);
        return;
    }
    const auto design = catalogue::readStudy(*text, file.toStdString());
    if (!design) {
        context().messages().error(tr("The study was not imported."), design.error());
        return;
    }
    create(design->id, study_words::text(design->title, QStringLiteral("en")).toStdString(),
           catalogue::studyJson(*design).toStdString());
}

void StudiesScreen::create(const std::string& key, const std::string& title, const std::string& json) {
    writeStudies(
        context(), this,
        [=](database::StudyRepository& studies) { return studies.createStudy(key, title, json); },
        [this, title](const core::Result<database::StudyNumber>& study) {
            if (!study) {
                context().messages().error(tr("The study was not created."), study.error());
                return;
            }
            context().messages().done(tr("%1 was created as a draft.").arg(QString::fromStdString(title)));
            context().navigator().go(QStringLiteral("study"), {{QStringLiteral("study"), qlonglong(*study)}});
        });
}

void StudiesScreen::archive(const database::StudySummary& study, bool archived, bool canUndo) {
    AppContext& app = context();
    const QPointer<StudiesScreen> screen(this);
    writeStudies(
        app, &app,
        [id = study.id, archived](database::StudyRepository& studies) {
            return studies.setStudyArchived(id, archived);
        },
        [&app, screen, study, archived, canUndo](const core::Result<void>& done) {
            const QString title = QString::fromStdString(study.title);
            if (!done) {
                app.messages().error(StudiesScreen::tr("%1 was not changed.").arg(title), done.error());
                return;
            }
            const auto undo = [screen, study, archived] {
                if (screen)
                    screen->archive(study, !archived, false);
            };
            app.messages().tell({MessageKind::done,
                                 archived
                                     ? StudiesScreen::tr("%1 is archived: nothing was deleted.").arg(title)
                                     : StudiesScreen::tr("%1 is back in the list.").arg(title),
                                 canUndo ? StudiesScreen::tr("Undo") : QString(),
                                 canUndo ? std::function<void()>(undo) : nullptr});
            if (screen)
                screen->load();
        });
}

void StudiesScreen::close() {
    const database::StudySummary* study = selected();
    if (!study)
        return;
    auto* box = new QMessageBox(QMessageBox::Question, title(),
                                tr("Close %1?").arg(QString::fromStdString(study->title)),
                                QMessageBox::NoButton, window());
    box->setObjectName(QStringLiteral("studies.ask_close"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setInformativeText(tr("No more participants can be enrolled and no more runs started; open runs can "
                               "still be finished. This cannot be undone."));
    QPushButton* keep = box->addButton(tr("Keep it open"), QMessageBox::RejectRole);
    QPushButton* end = box->addButton(tr("Close the study"), QMessageBox::DestructiveRole);
    end->setObjectName(QStringLiteral("studies.ask_close.close"));
    box->setDefaultButton(keep);
    box->setEscapeButton(keep);
    connect(end, &QPushButton::clicked, this, [this, id = study->id] {
        writeStudies(
            context(), this, [id](database::StudyRepository& studies) { return studies.closeStudy(id); },
            [this](const core::Result<void>& done) {
                if (!done)
                    context().messages().error(tr("The study was not closed."), done.error());
                else
                    load();
            });
    });
    box->open();
}

} // namespace chiron::desktop
