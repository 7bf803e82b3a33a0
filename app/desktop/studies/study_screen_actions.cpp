// SPDX-License-Identifier: GPL-3.0-or-later
// Checking, storing, freezing, importing and exporting a design.
#include "catalogue/study_json.h"

#include "catalogue/whole_file.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/frame/file_folder.h"
#include "desktop/studies/freeze_dialog.h"
#include "desktop/studies/new_study_dialog.h"
#include "desktop/studies/pilot_dialog.h"
#include "desktop/studies/study_screen.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"

#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QSaveFile>
#include <QTabBar>

namespace chiron::desktop {

void StudyScreen::changed() {
    ++m_version;
    m_saved = false;
    m_check.start();
    showState();
}

void StudyScreen::check() {
    context().background().run(
        this,
        [design = m_draft.design(), key = m_open.summary.key](WorkToken&) {
            return catalogue::readStudy(catalogue::studyJson(design), key);
        },
        [this, version = m_version](const core::Result<psychophysics::StudyDesign>& read) {
            checked(version, read);
        });
}

void StudyScreen::checked(int version, const core::Result<psychophysics::StudyDesign>& read) {
    if (version != m_version)
        return; // the design has changed since
    take(read);
    if (m_good)
        save();
    showState();
    if (m_tab == checkTab && m_open.editable())
        showPage(); // its lines belong to the previous design
}

void StudyScreen::take(const core::Result<psychophysics::StudyDesign>& read) {
    m_good = read.has_value();
    m_wrong = m_good ? nameFaults(m_draft.design())
                     : designFaults(m_draft.design(), read.error(), context().locale());
    if (m_faults)
        m_faults->say("bad", m_good ? QString()
                                    : tr("Not saved yet: %n entr(y/ies) must be corrected first. %1", nullptr,
                                         static_cast<int>(m_wrong.size()))
                                          .arg(m_wrong.empty() ? QString() : m_wrong.front().words));
    showFaults();
}

/// Checks at once, without the worker, because the person wants to continue.
void StudyScreen::checkNow() {
    if (!m_saved && m_check.isActive())
        take(catalogue::readStudy(catalogue::studyJson(m_draft.design()), m_open.summary.key));
}

void StudyScreen::save() {
    if (m_saving || readOnly())
        return;
    m_saving = true;
    writeStudies(
        context(), this,
        [study = m_study, json = catalogue::studyJson(m_draft.design()).toStdString()](
            database::StudyRepository& studies) { return studies.saveDraft(study, json); },
        [this, version = m_version](const core::Result<void>& done) {
            m_saving = false;
            if (!done)
                m_faults->say("bad", tr("The draft could not be saved.\n%1").arg(inWords(done.error())));
            else if (version == m_version)
                m_saved = true;
            else
                m_check.start();
            showState();
        });
}

void StudyScreen::showState() {
    if (!m_state)
        return;
    const database::StudySummary& study = m_open.summary;
    QStringList words{study_words::state(study.state), tr("key %1").arg(QString::fromStdString(study.key))};
    if (!study.sha256.empty())
        words << tr("SHA-256 %1").arg(study_words::shortSha(study.sha256));
    if (!study.frozenUtc.empty())
        words << tr("frozen %1").arg(study_words::moment(study.frozenUtc, context().locale()));
    if (m_open.design.blindExperimenter && !m_open.editable())
        words << (study.unblinded ? tr("unblinded") : tr("blind"));
    if (!readOnly())
        words << (m_saved ? tr("all changes saved") : m_good ? tr("saving …") : tr("not saved"));
    if (!readOnly() && !m_good)
        words << tr("cannot be frozen before the entries marked in red are corrected");
    m_state->setText(words.join(QStringLiteral(" · ")));
    if (m_undo) {
        m_undo->setEnabled(m_draft.history().canUndo());
        m_redo->setEnabled(m_draft.history().canRedo());
        kit::allowUnless(*m_freeze, !m_good ? tr("The design must be free of errors before it can be frozen.")
                                    : !m_saved ? tr("The last changes are still being saved.")
                                               : QString());
    }
    showSteps();
}

bool StudyScreen::mayLeave() {
    const bool leaves = mayLeaveDesign();
    if (leaves)
        sayPreviewEnds();
    return leaves;
}

bool StudyScreen::mayLeaveDesign() {
    if (m_saved || readOnly() || !m_view)
        return true;
    const auto read = catalogue::readStudy(catalogue::studyJson(m_draft.design()), m_open.summary.key);
    if (read) { // a write is in progress and completes although this screen is destroyed
        writeStudies(
            context(), &context(),
            [study = m_study, json = catalogue::studyJson(*read).toStdString()](
                database::StudyRepository& studies) { return studies.saveDraft(study, json); },
            [&app = context()](const core::Result<void>& done) {
                if (!done)
                    app.messages().error(StudyScreen::tr("The draft could not be saved."), done.error());
            });
        return true;
    }
    QMessageBox box(QMessageBox::Question, title(), tr("Leave without the last changes?"),
                    QMessageBox::NoButton, window());
    box.setInformativeText(tr("The design still has errors, so the last changes were not saved. The last "
                              "version without errors is saved."));
    QPushButton* stay = box.addButton(tr("Stay"), QMessageBox::RejectRole);
    QPushButton* leave = box.addButton(tr("Leave"), QMessageBox::DestructiveRole);
    box.setDefaultButton(stay);
    box.exec();
    return box.clickedButton() == leave;
}

void StudyScreen::askFreeze() {
    if (!stored())
        return;
    auto* dialog = new FreezeDialog(context(), m_open.summary, m_draft.design(),
                                    {m_wrong, std::nullopt, pilotsTried(m_open)}, this);
    connect(dialog, &FreezeDialog::frozen, this, [this] { reloadTo(participantsTab); });
    connect(
        dialog, &FreezeDialog::goAsked, this,
        [this](const FreezeCheck& line) { goToField(line.tab, line.condition, line.field); },
        Qt::QueuedConnection);
    dialog->open();
}

/// Returns whether the design on the screen is stored; otherwise shows the reason.
bool StudyScreen::stored() {
    checkNow();
    if (!m_good)
        goToFirstFault();
    else if (!m_saved)
        context().messages().information(
            tr("The last changes are still being saved. Try again in a moment."));
    return m_good && m_saved;
}

void StudyScreen::askPilot() {
    if (!stored())
        return;
    auto* dialog = new PilotDialog(context(), m_draft.design(), m_study, this);
    dialog->open();
}

void StudyScreen::askCopy() {
    auto* dialog = new NewStudyDialog(context(), m_draft.design(), this);
    connect(dialog, &NewStudyDialog::created, this, [this](qlonglong copy) {
        context().navigator().go(QStringLiteral("study"), {{QStringLiteral("study"), copy}});
    });
    dialog->open();
}

void StudyScreen::reloadTo(int tab) {
    m_tab = tab;
    note();
    load();
}

void StudyScreen::askImport() {
    auto* dialog =
        new QFileDialog(this, tr("Import a design from a file"), QString(), tr("Studies (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("studies"));
    connect(dialog, &QFileDialog::fileSelected, this, &StudyScreen::importFile);
    dialog->open();
}

void StudyScreen::importFile(const QString& file) {
    constexpr qint64 kLargestStudy_bytes = 1 << 20;
    const auto design =
        catalogue::readWholeFile(file, kLargestStudy_bytes).and_then([&](const QByteArray& text) {
            return catalogue::readStudy(text, file.toStdString());
        });
    if (!design) {
        m_faults->say(
            "bad", tr("The file was not imported:\n%1").arg(QString::fromStdString(design.error().message)));
        return;
    }
    m_draft.change(
        tr("Import of a file"), {},
        [&](psychophysics::StudyDesign& now) {
            const std::string key = now.id; // the study keeps its key
            now = *design;
            now.id = key;
        },
        true);
}

void StudyScreen::askExport() {
    auto* dialog = new QFileDialog(this, tr("Save the design"), QString(), tr("Studies (*.json)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("json"));
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("studies"));
    dialog->selectFile(QString::fromStdString(m_open.summary.key) + QStringLiteral(".json"));
    connect(dialog, &QFileDialog::fileSelected, this, &StudyScreen::exportFile);
    dialog->open();
}

void StudyScreen::exportFile(const QString& name) {
    const QByteArray json = catalogue::studyJson(m_draft.design());
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(json) != json.size() || !file.commit()) {
        context().messages().error(
            tr("The design was not saved."),
            {core::ErrorCode::storage, (name + QStringLiteral(": ") + file.errorString()).toStdString()});
        return;
    }
    context().messages().done(tr("The design was saved in %1.").arg(name));
}

} // namespace chiron::desktop
