// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/restore/restore_screen.h"

#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/sessions/session_words.h"
#include "desktop/storage/backup_place.h"
#include "desktop/storage/restore_dialog.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/logo.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHeaderView>
#include <QTableWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {

enum Column { kMade, kAge, kSize, kKind, kState, kWhere, kColumns };

const QString kMissing = QStringLiteral("missing");
const QString kDetail = QStringLiteral("detail");

/// The backups in several folders, newest first, without duplicates.
std::vector<session::BackupEntry> backupsIn(const std::vector<std::string>& places) {
    std::vector<session::BackupEntry> all;
    for (const std::string& place : places)
        for (session::BackupEntry& entry : session::listBackups(place))
            if (std::none_of(all.begin(), all.end(),
                             [&](const auto& other) { return other.folder == entry.folder; }))
                all.push_back(std::move(entry));
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.createdUtc > b.createdUtc; });
    return all;
}

} // namespace

Place RestoreScreen::placeFor(const database::FileState& file) {
    return {QStringLiteral("restore"),
            {{kMissing, file.health == database::FileHealth::missing},
             {kDetail, QString::fromStdString(file.detail)}}};
}

RestoreScreen::RestoreScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_page(new ScrollPage(context.theme(), 860)) {
    const Theme& theme = context.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_page);
    addHead(*m_page->column());
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Backups"), TextStyle::title));
    m_panel = new StatePanel(theme);
    m_panel->setObjectName(QStringLiteral("restore.panel"));
    m_panel->setContent(buildTable());
    m_panel->setMinimumHeight(theme.px(220));
    box.layout->addWidget(m_panel);
    m_reason = kit::label(theme, {}, TextStyle::body, "bad");
    m_reason->setObjectName(QStringLiteral("restore.reason"));
    m_reason->hide();
    box.layout->addWidget(m_reason);
    addActions(*box.layout);
    m_page->column()->addWidget(box.frame);
    m_page->column()->addStretch();
    m_page->column()->addWidget(form::languageChoice(context), 0, Qt::AlignHCenter);
    m_panel->showLoading(tr("Looking for backups …"));
    showButtons();
}

bool RestoreScreen::isMissing() const {
    return place().parameters.value(kMissing).toBool();
}

QString RestoreScreen::title() const {
    return isMissing() ? tr("The site's file is missing") : tr("The site's file is damaged");
}

QString RestoreScreen::help() const {
    return tr("Everything of a site is in one file. If that is damaged or gone, a backup brings the site "
              "back as it was when the backup was "
              "made.\n\nThe list shows the backups in the places that this computer knows, newest first, and "
              "whether each can be used. Use "
              "\"Choose a file\" for one on another disk: it is a folder with the files manifest.json and "
              "chiron.db in it.\n\nAn "
              "administrator of the backup has to give the password. The damaged file is never deleted: it "
              "is kept beside the new one under "
              "another name.");
}

void RestoreScreen::addHead(QVBoxLayout& column) {
    const Theme& theme = context().theme();
    column.addWidget(logo(theme, 56));
    auto* heading = kit::label(theme, title(), TextStyle::heading);
    heading->setObjectName(QStringLiteral("restore.title"));
    heading->setAlignment(Qt::AlignCenter);
    column.addWidget(heading);
    const QString file = kit::breakablePath(context().site().file());
    const QString words = isMissing() ? tr("%1 is no longer there. If it was moved, or is on a disk that is "
                                           "not connected, put it back and try again. "
                                           "Otherwise restore a backup.")
                                            .arg(file)
                                      : tr("%1 cannot be read as a site. Nothing was changed. Restore a "
                                           "backup to continue; the damaged file is kept as a copy.")
                                            .arg(file);
    auto* notice = kit::notice(theme, "bad", words);
    notice->setObjectName(QStringLiteral("restore.notice"));
    column.addWidget(notice);
    const QString key = QString::fromStdString(database::siteFolderFor(context().site().file().toStdString(),
                                                                       context().site().options())) +
                        QStringLiteral("/site.key");
    if (!QFileInfo::exists(key)) {
        auto* lost = kit::notice(theme, "warning",
                                 tr("The key of this site is missing, too: %1. Without it no backup can be "
                                    "checked or restored. Put it "
                                    "back from a copy of the site's folder, then try again.")
                                     .arg(kit::breakablePath(key)));
        lost->setObjectName(QStringLiteral("restore.key"));
        column.addWidget(lost);
    }
    if (const QString detail = place().parameters.value(kDetail).toString();
        !detail.isEmpty() && !isMissing()) {
        auto* found = kit::label(theme, tr("Details: %1").arg(detail), TextStyle::small, "muted");
        found->setObjectName(QStringLiteral("restore.detail"));
        column.addWidget(found);
    }
}

QWidget* RestoreScreen::buildTable() {
    const Theme& theme = context().theme();
    m_table = new QTableWidget(0, kColumns);
    m_table->setObjectName(QStringLiteral("restore.backups"));
    m_table->setAccessibleName(tr("Backups"));
    m_table->setHorizontalHeaderLabels(
        {tr("Made"), tr("Age"), tr("Size"), tr("Kind"), tr("State"), tr("Folder")});
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setShowGrid(false);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setIconSize(QSize(theme.px(18), theme.px(18)));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(theme.px(34));
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setHighlightSections(false);
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &RestoreScreen::showButtons);
    connect(m_table, &QTableWidget::activated, this, &RestoreScreen::askRestore);
    return m_table;
}

void RestoreScreen::addActions(QVBoxLayout& column) {
    auto* row = new FlowLayout(context().theme().px(8));
    const auto add = [&](const char* name, const QString& text, const char* look, const QString& icon,
                         void (RestoreScreen::*act)()) {
        auto* button = kit::button(context().theme(), text, look, icon);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    m_restore = add("restore.restore", tr("Restore the selected backup …"), "primary",
                    QStringLiteral("view-history"), &RestoreScreen::askRestore);
    m_choose = add("restore.choose", tr("Choose a file …"), "", QStringLiteral("document-open-folder"),
                   &RestoreScreen::chooseFile);
    m_again = add("restore.again", tr("Try to open it again"), "quiet", QStringLiteral("view-refresh"),
                  &RestoreScreen::openAgain);
    if (isMissing()) {
        m_anew =
            kit::button(context().theme(), tr("Set up a new site"), "quiet", QStringLiteral("list-add-user"));
        m_anew->setObjectName(QStringLiteral("restore.anew"));
        connect(m_anew, &QPushButton::clicked, this, [this] {
            context().navigator().replace({QStringLiteral("first_start"), {}});
        });
        row->addWidget(m_anew);
    }
    column.addLayout(row);
}

void RestoreScreen::enter() {
    find();
}

std::vector<ScreenCommand> RestoreScreen::commands() {
    std::vector<ScreenCommand> list;
    for (QPushButton* button : {m_restore, m_choose, m_again})
        list.push_back({button->text(), {}, [button] { button->click(); }});
    return list;
}

bool RestoreScreen::mayLeave() {
    if (m_restoring)
        context().messages().information(tr("Wait until the restore has finished."));
    return !m_restoring;
}

void RestoreScreen::find() {
    const std::vector<std::string> places{
        backupPlace(context()).toStdString(),
        session::defaultBackupFolder(context().site().file().toStdString())};
    context().background().run(
        this, [places](WorkToken&) { return backupsIn(places); },
        [this](std::vector<session::BackupEntry> backups) { show(std::move(backups)); });
}

void RestoreScreen::show(std::vector<session::BackupEntry> backups) {
    m_backups = std::move(backups);
    if (m_backups.empty()) {
        m_panel->showEmpty(tr("No backup was found"), tr("There is none in %1. If you have one elsewhere, on "
                                                         "a USB drive or on the network, choose it below.")
                                                          .arg(kit::breakablePath(backupPlace(context()))));
        m_choose->setFocus();
        showButtons();
        emit looked();
        return;
    }
    const QLocale locale = context().locale();
    m_table->setRowCount(static_cast<int>(m_backups.size()));
    for (std::size_t i = 0; i < m_backups.size(); ++i) {
        const session::BackupEntry& backup = m_backups[i];
        const int row = static_cast<int>(i);
        const QDateTime when = SessionWords::timeOf(backup.createdUtc);
        const auto cell = [&](Column column, const QString& text) {
            m_table->setItem(row, column, new QTableWidgetItem(text));
        };
        cell(kMade, locale.toString(when.toLocalTime(), QLocale::ShortFormat));
        cell(kAge, SessionWords::ago(when, QDateTime::currentDateTimeUtc(), locale));
        cell(kSize, SessionWords::bytes(backup.bytes, locale));
        cell(kKind, backup.automatic ? tr("Automatic") : tr("By hand"));
        cell(kWhere, QDir::toNativeSeparators(QString::fromStdString(backup.folder)));
        put(i, Look::waiting, {});
    }
    m_panel->showContent();
    fitColumns();
    m_table->selectRow(0);
    m_table->setFocus();
    lookAt(0);
}

void RestoreScreen::put(std::size_t row, Look look, const QString& why) {
    const Theme& theme = context().theme();
    m_looks[m_backups[row].folder] = look;
    m_why[m_backups[row].folder] = why;
    auto* item =
        look == Look::waiting ? new QTableWidgetItem(tr("Being checked …"))
        : look == Look::whole
            ? new QTableWidgetItem(theme.icon(QStringLiteral("dialog-ok-apply"), Colour::good), tr("Intact"))
            : new QTableWidgetItem(theme.icon(QStringLiteral("dialog-error"), Colour::bad),
                                   tr("Cannot be used"));
    item->setToolTip(why);
    m_table->setItem(static_cast<int>(row), kState, item);
    fitColumns();
    showButtons();
}

// The last column stretches if there is room; otherwise the table scrolls instead of cutting it off.
void RestoreScreen::fitColumns() {
    QHeaderView* header = m_table->horizontalHeader();
    header->setStretchLastSection(false);
    m_table->resizeColumnsToContents();
    header->setStretchLastSection(header->length() < m_table->viewport()->width());
}

void RestoreScreen::resizeEvent(QResizeEvent* event) {
    Screen::resizeEvent(event);
    fitColumns();
}

// Checks one after the other, newest first, because each check reads the whole backup.
void RestoreScreen::lookAt(std::size_t row) {
    if (row >= m_backups.size()) {
        emit looked();
        return;
    }
    if (m_looks[m_backups[row].folder] != Look::waiting)
        return lookAt(row + 1);
    context().background().run(
        this,
        [folder = m_backups[row].folder, file = context().site().file().toStdString(),
         options = context().site().options()](WorkToken&) {
            return session::looksWhole(folder, file, options);
        },
        [this, folder = m_backups[row].folder](const core::Result<void>& whole) {
            const auto found = std::find_if(m_backups.begin(), m_backups.end(),
                                            [&](const auto& each) { return each.folder == folder; });
            if (found == m_backups.end())
                return;
            const auto place_ = static_cast<std::size_t>(found - m_backups.begin());
            put(place_, whole ? Look::whole : Look::unusable,
                whole ? QString() : QString::fromStdString(whole.error().message));
            lookAt(place_ + 1);
        });
}

const session::BackupEntry* RestoreScreen::selected() const {
    const int row = m_table->currentRow();
    return row >= 0 && row < static_cast<int>(m_backups.size()) ? &m_backups[static_cast<std::size_t>(row)]
                                                                : nullptr;
}

void RestoreScreen::showButtons() {
    if (!m_restore)
        return; // still being built
    const session::BackupEntry* backup = selected();
    const bool usable = backup && m_looks[backup->folder] != Look::unusable;
    kit::allowUnless(*m_restore, !backup  ? tr("No backup is selected.")
                                 : usable ? QString()
                                          : tr("This backup cannot be used."));
    m_restore->setEnabled(m_restore->isEnabled() && !m_restoring);
    m_reason->setVisible(backup && !usable);
    if (backup && !usable)
        m_reason->setText(tr("This backup cannot be used.\nDetails: %1").arg(m_why[backup->folder]));
    for (QPushButton* button : {m_choose, m_again, m_anew})
        if (button)
            button->setEnabled(!m_restoring);
}

void RestoreScreen::chooseFile() {
    auto* dialog = new QFileDialog(this, tr("A file of the backup"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("Backups (manifest.json chiron.db)"));
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("restores"),
                      context().settings().backupFolder());
    connect(dialog, &QFileDialog::fileSelected, this, &RestoreScreen::takeFile);
    dialog->open();
}

void RestoreScreen::takeFile(const QString& file) {
    const QString folder = QFileInfo(file).absolutePath();
    context().background().run(
        this,
        [around = QFileInfo(folder).absolutePath().toStdString(), folder = folder.toStdString()](WorkToken&) {
            std::vector<session::BackupEntry> found = session::listBackups(around);
            std::erase_if(found, [&](const auto& entry) { return entry.folder != folder; });
            return found;
        },
        [this, folder](const std::vector<session::BackupEntry>& found) {
            if (found.empty()) {
                context().messages().warning(tr("%1 is not a backup. A backup is a folder with the files "
                                                "manifest.json and chiron.db in it.")
                                                 .arg(QDir::toNativeSeparators(folder)));
                return;
            }
            std::vector<session::BackupEntry> all = m_backups;
            std::erase_if(all, [&](const auto& entry) { return entry.folder == found.front().folder; });
            all.insert(all.begin(), found.front()); // first, because the person asked for it
            show(std::move(all));
        });
}

void RestoreScreen::askRestore() {
    const session::BackupEntry* backup = selected();
    if (!backup || !m_restore->isEnabled())
        return;
    RestoreDialog::ask(context(), *backup,
                       isMissing() ? RestoreDialog::Replaces::missing : RestoreDialog::Replaces::damaged,
                       this, [this](database::RestoreRequest request) { restore(std::move(request)); });
}

void RestoreScreen::restore(database::RestoreRequest request) {
    m_restoring = true;
    showButtons();
    m_panel->showLoading(tr("Restoring the backup and checking it …"));
    context().background().run(
        this,
        [request = std::move(request), options = context().site().options()](WorkToken&) {
            return database::Upkeep::restore(request, options);
        },
        [this](const core::Result<database::RestoreInfo>& result) { restored(result); });
}

void RestoreScreen::restored(const core::Result<database::RestoreInfo>& result) {
    m_restoring = false;
    AppContext& app = context();
    if (!result) {
        m_panel->showContent();
        showButtons();
        m_table->setFocus();
        if (result.error().code == core::ErrorCode::notAllowed)
            app.messages().tell({MessageKind::error,
                                 tr("Nothing was restored: the name or the password is not that of an "
                                    "administrator, or too many "
                                    "wrong ones were given.\nDetails: %1")
                                     .arg(QString::fromStdString(result.error().message)),
                                 {},
                                 {}});
        else
            app.messages().error(isMissing() ? tr("Nothing was restored.")
                                             : tr("Nothing was restored. The damaged file is unchanged."),
                                 result.error());
        return;
    }
    const QString kept = QString::fromStdString(result->keptOldFile);
    openAgain(); // this screen is destroyed by this
    app.messages().done(
        kept.isEmpty()
            ? tr("The backup was restored. Please log in.")
            : tr("The backup was restored. The damaged file is kept as %1. Please log in.").arg(kept));
}

void RestoreScreen::openAgain() {
    AppContext& app = context();
    if (!app.site().exists()) { // opening would create an empty site in its place
        app.messages().information(tr("%1 is still missing.").arg(app.site().file()));
        return;
    }
    app.navigator().replace({QStringLiteral("login"), {}});
    app.openSite();
}

} // namespace chiron::desktop
