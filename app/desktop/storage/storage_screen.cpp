// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/storage/storage_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_words.h"
#include "desktop/storage/automatic_card.h"
#include "desktop/storage/storage_words.h"
#include "desktop/storage/task_strip.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QTableWidget>
#include <algorithm>

namespace chiron::desktop {

namespace {

QTableWidget* makeTable(const Theme& theme, const QString& name, const QString& label,
                        const QStringList& heads) {
    auto* table = new QTableWidget(0, static_cast<int>(heads.size()));
    table->setObjectName(name);
    table->setAccessibleName(label);
    table->setHorizontalHeaderLabels(heads);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setShowGrid(false);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->setIconSize(QSize(theme.px(18), theme.px(18)));
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(theme.px(34));
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setStretchLastSection(true);
    table->setMinimumHeight(theme.px(34 * 5));
    return table;
}

void clear(QVBoxLayout& column) {
    while (QLayoutItem* item = column.takeAt(0)) {
        delete item->widget();
        delete item;
    }
}

} // namespace

StorageScreen::StorageScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_panel(new StatePanel(context.theme())),
      m_strip(new TaskStrip(context.theme())) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_panel, 1);
    column->addWidget(m_strip);
    m_panel->setContent(buildPage());
    showButtons();
}

QString StorageScreen::title() const {
    return tr("Storage");
}

QString StorageScreen::help() const {
    return tr("Shows where all recorded data is kept and whether it is safe.\n\n\"Back up now\" makes a copy "
              "while the program is running "
              "and checks it before it counts. Keep backups on another disk: choose the folder "
              "here.\n\n\"Automatic backups\" makes one per day and keeps as many as you say; backups "
              "that you made yourself are never removed.\n\n\"Verify\" reads everything again: "
              "each record, each recording, each score, the audit trail. It changes nothing and can be "
              "stopped.\n\n\"Restore\" goes back "
              "to a backup. It asks an administrator for the password, keeps a copy of the current database, "
              "and logs everybody out.");
}

QPushButton* StorageScreen::addButton(QLayout& row, const QString& name, const QString& text,
                                      const char* kind, const QString& icon, void (StorageScreen::*act)()) {
    auto* button = kit::button(context().theme(), text, kind, icon);
    button->setObjectName(QStringLiteral("storage.") + name);
    connect(button, &QPushButton::clicked, this, act);
    row.addWidget(button);
    return button;
}

QWidget* StorageScreen::buildPage() {
    auto* page = new ScrollPage(context().theme(), 1100);
    QVBoxLayout& column = *page->column();
    column.addWidget(kit::label(context().theme(), title(), TextStyle::heading));
    m_notices = new QVBoxLayout;
    m_notices->setSpacing(context().theme().px(8));
    column.addLayout(m_notices);
    addRoom(column);
    addBackups(column);
    addAutomatic(column);
    addVerify(column);
    addExport(column);
    column.addStretch();
    return page;
}

void StorageScreen::addRoom(QVBoxLayout& column) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Free space"), TextStyle::title));
    auto* form = new QFormLayout;
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setHorizontalSpacing(theme.px(24));
    const auto add = [&](const QString& text, const char* name) {
        auto* value = kit::label(theme, {}, TextStyle::strong);
        value->setObjectName(QStringLiteral("storage.") + QLatin1String(name));
        form->addRow(kit::label(theme, text, TextStyle::body, "muted"), value);
        return value;
    };
    m_database = add(tr("Database"), "database");
    m_recordings = add(tr("Recordings in it"), "recordings");
    m_free = add(tr("Free on this disk"), "free");
    box.layout->addLayout(form);
    column.addWidget(box.frame);
}

void StorageScreen::addBackups(QVBoxLayout& column) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Backups"), TextStyle::title));
    m_place = kit::label(theme, {}, TextStyle::body, "muted");
    m_place->setObjectName(QStringLiteral("storage.place"));
    box.layout->addWidget(m_place);
    m_backups = makeTable(theme, QStringLiteral("storage.backups"), tr("Backups"),
                          {tr("Made"), tr("Age"), tr("Size"), tr("Checked"), tr("Kind"), tr("Folder")});
    connect(m_backups, &QTableWidget::itemSelectionChanged, this, &StorageScreen::showButtons);
    box.layout->addWidget(m_backups);
    auto* row = new FlowLayout(theme.px(8));
    m_backUp = addButton(*row, QStringLiteral("back_up"), tr("Back up now"), "primary",
                         QStringLiteral("backup"), &StorageScreen::backUp);
    m_verifyBackup = addButton(*row, QStringLiteral("verify_backup"), tr("Check the selected backup"), "",
                               QStringLiteral("checkmark"), &StorageScreen::verifyBackup);
    m_restore = addButton(*row, QStringLiteral("restore"), tr("Restore the selected backup …"), "",
                          QStringLiteral("view-history"), &StorageScreen::askRestore);
    m_choose = addButton(*row, QStringLiteral("choose"), tr("Choose the folder …"), "quiet",
                         QStringLiteral("document-open-folder"), &StorageScreen::chooseFolder);
    box.layout->addLayout(row);
    column.addWidget(box.frame);
}

void StorageScreen::addAutomatic(QVBoxLayout& column) {
    m_automatic = new AutomaticCard(context().theme());
    connect(m_automatic, &AutomaticCard::planChosen, this, &StorageScreen::savePlan);
    column.addWidget(m_automatic);
}

void StorageScreen::addVerify(QVBoxLayout& column) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Verify"), TextStyle::title));
    box.layout->addWidget(kit::label(
        theme,
        tr("Reads every record, recomputes every score from its recording and checks the audit trail. "
           "It changes nothing."),
        TextStyle::body, "muted"));
    m_reportBox = new QVBoxLayout;
    box.layout->addLayout(m_reportBox);
    m_findings = makeTable(theme, QStringLiteral("storage.findings"), tr("Problems found"),
                           {tr("What"), tr("Where"), tr("Details")});
    m_findings->hide();
    box.layout->addWidget(m_findings);
    auto* row = new FlowLayout(theme.px(8));
    m_verifySite = addButton(*row, QStringLiteral("verify"), tr("Verify everything"), "",
                             QStringLiteral("checkmark"), &StorageScreen::verifySite);
    box.layout->addLayout(row);
    column.addWidget(box.frame);
}

void StorageScreen::addExport(QVBoxLayout& column) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Export"), TextStyle::title));
    box.layout->addWidget(kit::label(
        theme,
        tr("A backup and every table as text (JSON Lines, without passwords), for analysis elsewhere "
           "or to move all data to another program."),
        TextStyle::body, "muted"));
    auto* row = new FlowLayout(theme.px(8));
    m_export = addButton(*row, QStringLiteral("export"), tr("Export the site …"), "",
                         QStringLiteral("document-save"), &StorageScreen::exportSite);
    box.layout->addLayout(row);
    column.addWidget(box.frame);
}

void StorageScreen::show(StorageFacts facts) {
    m_facts = std::move(facts);
    const QLocale locale = context().locale();
    clear(*m_notices);
    const StorageNotice room = StorageWords::room(m_facts.room, locale);
    const std::string latest = m_facts.backups.empty() ? std::string() : m_facts.backups.front().createdUtc;
    const StorageNotice backup = StorageWords::backup(latest, QDateTime::currentDateTimeUtc(), locale);
    auto* roomNotice = kit::notice(context().theme(), room.kind, room.text);
    roomNotice->setObjectName(QStringLiteral("storage.room_notice"));
    auto* backupNotice = kit::notice(context().theme(), backup.kind, backup.text);
    backupNotice->setObjectName(QStringLiteral("storage.backup_notice"));
    m_notices->addWidget(roomNotice);
    m_notices->addWidget(backupNotice);
    m_database->setText(tr("%1 in %2")
                            .arg(SessionWords::bytes(m_facts.room.database_bytes, locale),
                                 kit::breakablePath(context().site().file())));
    m_recordings->setText(tr("%1 from %n session(s)", nullptr, m_facts.sessions)
                              .arg(SessionWords::bytes(m_facts.recordings_bytes, locale)));
    m_free->setText(tr("%1 of %2")
                        .arg(SessionWords::bytes(m_facts.room.diskFree_bytes, locale),
                             SessionWords::bytes(m_facts.room.disk_bytes, locale)));
    m_place->setText(tr("Kept in %1").arg(kit::breakablePath(folder())));
    m_automatic->present(m_facts.standing, m_facts.onTheSitesDisk, locale);
    showBackups();
    m_panel->showContent();
    showButtons();
}

void StorageScreen::showBackups() {
    const QLocale locale = context().locale();
    const Theme& theme = context().theme();
    m_backups->setRowCount(static_cast<int>(m_facts.backups.size()));
    int row = 0;
    for (const session::BackupEntry& backup : m_facts.backups) {
        const QDateTime made = SessionWords::timeOf(backup.createdUtc);
        const auto checked = m_checked.find(backup.folder);
        const bool known = checked != m_checked.end();
        const QString state = !known            ? tr("When created")
                              : checked->second ? tr("Just now: intact")
                                                : tr("Just now: damaged");
        auto* sign =
            new QTableWidgetItem(theme.icon(known && !checked->second ? QStringLiteral("dialog-error")
                                                                      : QStringLiteral("dialog-ok-apply"),
                                            known && !checked->second ? Colour::bad : Colour::good),
                                 state);
        m_backups->setItem(row, 0,
                           new QTableWidgetItem(locale.toString(made.toLocalTime(), QLocale::ShortFormat)));
        m_backups->setItem(
            row, 1, new QTableWidgetItem(SessionWords::ago(made, QDateTime::currentDateTimeUtc(), locale)));
        m_backups->setItem(row, 2, new QTableWidgetItem(SessionWords::bytes(backup.bytes, locale)));
        m_backups->setItem(row, 3, sign);
        m_backups->setItem(row, 4, new QTableWidgetItem(backup.automatic ? tr("Automatic") : tr("By hand")));
        m_backups->setItem(row, 5,
                           new QTableWidgetItem(QFileInfo(QString::fromStdString(backup.folder)).fileName()));
        ++row;
    }
    m_backups->setVisible(row > 0);
    m_backups->resizeColumnsToContents();
    if (row > 0 && m_backups->currentRow() < 0)
        m_backups->selectRow(0);
}

void StorageScreen::showReport(const database::VerifyReport& report) {
    clear(*m_reportBox);
    const StorageNotice notice = StorageWords::verified(report, context().locale());
    auto* frame = kit::notice(context().theme(), notice.kind, notice.text);
    frame->setObjectName(QStringLiteral("storage.report"));
    m_reportBox->addWidget(frame);
    constexpr std::size_t kMostShown = 500;
    const std::size_t shown = std::min(report.findings.size(), kMostShown);
    m_findings->setRowCount(static_cast<int>(shown));
    for (std::size_t i = 0; i < shown; ++i) {
        const database::Finding& finding = report.findings[i];
        const int row = static_cast<int>(i);
        const QString where = QString::fromStdString(finding.table + " " + finding.row).trimmed();
        m_findings->setItem(
            row, 0,
            new QTableWidgetItem(context().theme().icon(QStringLiteral("dialog-error"), Colour::bad),
                                 StorageWords::findingKind(finding.kind)));
        m_findings->setItem(row, 1, new QTableWidgetItem(where));
        m_findings->setItem(row, 2, new QTableWidgetItem(QString::fromStdString(finding.detail)));
    }
    m_findings->setVisible(shown > 0);
    m_findings->resizeColumnsToContents();
}

void StorageScreen::showButtons() {
    const bool idle = m_task == Task::none && !m_restoring;
    // Disabling a button would move the focus to its neighbour, which may be "Restore". Instead the focus is
    // parked here and goes back afterwards.
    for (QPushButton* button : {m_backUp, m_verifyBackup, m_restore, m_choose, m_verifySite, m_export})
        if (!idle && window()->focusWidget() == button) {
            m_hadFocus = button;
            setFocus(Qt::OtherFocusReason);
        }
    for (QPushButton* button : {m_backUp, m_choose, m_verifySite, m_export})
        button->setEnabled(idle);
    for (QPushButton* button : {m_verifyBackup, m_restore})
        button->setEnabled(idle && selected() != nullptr);
    if (idle && m_hadFocus && window()->focusWidget() == this)
        m_hadFocus->setFocus(Qt::OtherFocusReason);
    if (idle)
        m_hadFocus = nullptr;
}

} // namespace chiron::desktop
