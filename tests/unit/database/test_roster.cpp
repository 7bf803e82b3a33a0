// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "catalogue/language_words.h"
#include "core/languages.h"
#include "database/accounts/account_rules.h"
#include "database/accounts/csv_records.h"
#include "database/accounts/roster_words.h"
#include "database/accounts/table_text.h"
#include "database/query.h"
#include "database/repositories/audit_repository.h"

#include <QDirIterator>
#include <QRandomGenerator>
#include <algorithm>
#include <iconv.h>
#include <tuple>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

/// The text in one of the encodings that spreadsheets save, made by the system's converter.
std::string encoded(const std::string& text, const char* encoding) {
    const iconv_t conversion = iconv_open(encoding, "UTF-8");
    std::string copy = text;
    std::string out(4 * text.size() + 8, '\0');
    char* in = copy.data();
    char* to = out.data();
    std::size_t inLeft = copy.size();
    std::size_t left = out.size();
    if (iconv(conversion, &in, &inLeft, &to, &left) == static_cast<std::size_t>(-1))
        qFatal("the test's own text is not in %s", encoding);
    iconv_close(conversion);
    out.resize(out.size() - left);
    return out;
}

bool has(const Roster& roster, RosterFault fault, int line) {
    return std::any_of(roster.problems.begin(), roster.problems.end(),
                       [&](const RosterProblem& p) { return p.fault == fault && p.line == line; });
}

std::string wordsOf(const Roster& roster) {
    return roster.problems.empty() ? std::string() : rosterError(roster.problems).message;
}

} // namespace

/// Lists of people as spreadsheets save them, whole and broken, and what an import makes of them.
class TestRoster : public QObject {
    Q_OBJECT
private slots:
    void init();
    void germanExcelIsImportedWithoutAQuestion();
    void wordsThatAreNoRoleCanStandForOne();
    void everyEncodingIsTold_data();
    void everyEncodingIsTold();
    void delimitersAreFoundBesideQuotedOnes_data();
    void delimitersAreFoundBesideQuotedOnes();
    void everyLanguagesWordsAreRead_data();
    void everyLanguagesWordsAreRead();
    void headingsInThreeLanguages_data();
    void headingsInThreeLanguages();
    void rolesInThreeLanguages();
    void lineEndsAndEmptyRows();
    void otherFilesAreNamed_data();
    void otherFilesAreNamed();
    void faultsNameLineAndColumn();
    void badBytesNameTheirLine();
    void bytesTellTheirEncoding_data();
    void bytesTellTheirEncoding();
    void whoExistsIsSkippedOrUpdated();
    void anUpdateLeavesWhatTheListDoesNotSay();
    void rolesThatStayAreNotSetAgain();
    void whoWasRenamedIsKnownByTheOldName();
    void anOldListTurnsNoFullNameBack();
    void aNameOfTodayComesBeforeAnOldOne();
    void nothingIsHalfDone();
    void madePasswordsAreNowhereElse();
    void onlyAdministratorsImport();
    void tenThousandLines();
    void anyBytesAreReadOrRefused();

private:
    AccountService accounts() { return AccountService(*m->database); }
    Person personOf(const std::string& name) {
        return accounts().personByName(m_admin, name).value_or(Person{});
    }
    std::size_t people() { return accounts().listPeople(m_admin)->size(); }
    std::size_t audited() {
        return AuditRepository(**m->database->openReader(), m_admin).listAudit()->size();
    }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous();
};

void TestRoster::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    const auto admin = m->administrator();
    REQUIRE(admin);
    m_admin = *admin;
}

void TestRoster::germanExcelIsImportedWithoutAQuestion() {
    const std::string file = "Nachname;Vorname;Anmeldename;Rolle;Gruppe\r\n"
                             "M\xfcller;J\xf6rg;mueller;Lernende Person;2026\r\n"
                             "Gro\xdf;\xc4nne;gross;Ausbilder/in;2026\r\n"
                             "\"von der H\xf6he; genannt Hans\";Hans;hans;\"Trainer;Administration\";\r\n";
    const Roster roster = readRoster(file);
    QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
    QCOMPARE(roster.encoding, std::string("Windows-1252"));
    QCOMPARE(roster.delimiter, ';');
    QCOMPARE(roster.ignoredColumns, std::vector<std::string>{"Gruppe"});
    const auto done = accounts().importCsv(m_admin, file);
    REQUIRE(done);
    QCOMPARE(done->added.size(), std::size_t{3});
    QCOMPARE(personOf("mueller").displayName, std::string("Jörg Müller"));
    QVERIFY(personOf("mueller").roles == RoleSet{Role::trainee});
    QCOMPARE(personOf("gross").displayName, std::string("Änne Groß"));
    QVERIFY(personOf("gross").roles == RoleSet{Role::trainer});
    QCOMPARE(personOf("hans").displayName, std::string("Hans von der Höhe; genannt Hans"));
    QVERIFY((personOf("hans").roles == RoleSet{Role::trainer, Role::admin}));
    for (const ImportedPerson& person : done->added) {
        const auto actor = accounts().login(person.name, person.madePassword);
        REQUIRE(actor);
        QVERIFY(actor->mustChangePassword());
    }
}

/// However they are written, and only where they are no role by themselves.
void TestRoster::wordsThatAreNoRoleCanStandForOne() {
    const std::string file = "login name,role\numa,Famulant\nvic,\"trainer;FAMULANT\"\nwim,\nxia,trainee\n";
    const Roster asRead = readRoster(file);
    QCOMPARE(asRead.unknownRoles, (std::vector<std::string>{"Famulant", ""}));
    QCOMPARE(asRead.problems.size(), std::size_t{3});
    const RoleWords half{{"famulant", Role::trainee}};
    QCOMPARE(readRoster(file, half).problems.size(), std::size_t{1});
    QCOMPARE(accounts().importCsv(m_admin, file, RosterExisting::skip, {}, half).error().code,
             core::ErrorCode::badInput);
    const RoleWords whole{{"Famulant", Role::trainee}, {"", Role::researcher}, {"trainee", Role::admin}};
    const Roster roster = readRoster(file, whole);
    QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
    QCOMPARE(roster.unknownRoles, asRead.unknownRoles);
    QVERIFY(roster.rows[0].roles == RoleSet{Role::trainee});
    QVERIFY((roster.rows[1].roles == RoleSet{Role::trainer, Role::trainee}));
    QVERIFY(roster.rows[2].roles == RoleSet{Role::researcher});
    QVERIFY(roster.rows[3].roles == RoleSet{Role::trainee}); // a role stays what it is
    QVERIFY(accounts().previewCsv(m_admin, file, RosterExisting::skip, whole)->roster.problems.empty());
}

void TestRoster::everyEncodingIsTold_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("encoding");
    const std::string german =
        "Anmeldename;Name;Rolle\r\ngrosse;Jürgen Größe-Weiß;Lernende\r\nuwe;Uwe Öhm;Lernende\r\n";
    const std::string greek = "Όνομα χρήστη;Ονοματεπώνυμο;Ρόλος\r\ngrosse;Γιώργος "
                              "Παπαδόπουλος;εκπαιδευόμενος\r\nuwe;Άννα Ώρα;εκπαιδεύτρια\r\n";
    for (const auto& [language, text, name, codePage, told] :
         {std::tuple{"German", german, "Jürgen Größe-Weiß", "CP1252", "Windows-1252"},
          std::tuple{"Greek", greek, "Γιώργος Παπαδόπουλος", "CP1253", "Windows-1253"}}) {
        const auto row = [&](const char* title, const std::string& bytes, const char* encoding) {
            QTest::newRow((std::string(language) + ", " + title).c_str())
                << QByteArray::fromStdString(bytes) << QString::fromUtf8(name)
                << QString::fromLatin1(encoding);
        };
        row("UTF-8", text, "UTF-8");
        row("UTF-8 with mark", "\xef\xbb\xbf" + text, "UTF-8");
        row("UTF-16 LE", encoded(text, "UTF-16LE"), "UTF-16");
        row("UTF-16 LE with mark", "\xff\xfe" + encoded(text, "UTF-16LE"), "UTF-16");
        row("UTF-16 BE", encoded(text, "UTF-16BE"), "UTF-16");
        row("UTF-16 BE with mark", "\xfe\xff" + encoded(text, "UTF-16BE"), "UTF-16");
        row("code page", encoded(text, codePage), told);
    }
}

void TestRoster::everyEncodingIsTold() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, name);
    QFETCH(QString, encoding);
    const Roster roster = readRoster(bytes.toStdString());
    QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
    QCOMPARE(QString::fromStdString(roster.encoding), encoding);
    QCOMPARE(roster.rows.size(), std::size_t{2});
    QCOMPARE(QString::fromStdString(roster.rows[0].displayName), name);
    QCOMPARE(roster.rows[1].line, 3);
}

void TestRoster::delimitersAreFoundBesideQuotedOnes_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<char>("delimiter");
    QTest::newRow("comma") << "login name,full name,role\nanna,Anna,trainee\n" << ',';
    QTest::newRow("semicolon") << "login name;full name;role\nanna;Anna;trainee\n" << ';';
    QTest::newRow("tab") << "login name\tfull name\trole\nanna\tAnna\ttrainee\n" << '\t';
    QTest::newRow("commas in quotes")
        << "login name;\"name, first name\";role\nanna;\"Anna, A, B, C\";trainee\n"
        << ';';
    QTest::newRow("commas without quotes") << "login name;Name, Vorname;role\nanna;Anna, A, B, C;trainee\n"
                                           << ';';
    QTest::newRow("semicolons in quotes")
        << "login name,\"remark; 1; 2; 3; 4\",full name,role\nanna,\"a;b;c\",Anna,\"trainee;trainer\"\n"
        << ',';
    QTest::newRow("sep=;") << "sep=;\r\nlogin name;full name;role\r\nanna;Anna;trainee\r\n" << ';';
    QTest::newRow("sep=|") << "sep=|\nlogin name|full name|role\nanna|Anna|trainee\n" << '|';
    QTest::newRow("sep= quoted") << "\"sep=,\"\nlogin name,full name,role\nanna,Anna,trainee\n" << ',';
    QTest::newRow("sep= against the text") << "sep=\t\nlogin name\tfull;name\trole\nanna\tAnna\ttrainee\n"
                                           << '\t';
    QTest::newRow("sep= as a row of its table") << "sep=;;\nlogin name;full name;role\nanna;Anna;trainee\n"
                                                << ';';
    QTest::newRow("headings that nobody knows") << "login name,x;y;z,role\nanna,1,trainee\n" << ',';
}

void TestRoster::delimitersAreFoundBesideQuotedOnes() {
    QFETCH(QString, text);
    QFETCH(char, delimiter);
    const Roster roster = readRoster(text.toStdString());
    QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
    QCOMPARE(roster.delimiter, delimiter);
    QCOMPARE(roster.rows.size(), std::size_t{1});
    QCOMPARE(roster.rows[0].name, std::string("anna"));
    QCOMPARE(roster.rows[0].line, text.contains(QStringLiteral("sep=")) ? 3 : 2);
    QVERIFY(roster.rows[0].roles.contains(Role::trainee));
}

void TestRoster::everyLanguagesWordsAreRead_data() {
    QTest::addColumn<QString>("language");
    for (const std::string& language : core::languageIds())
        QTest::newRow(language.c_str()) << QString::fromStdString(language);
}

/// Each with its own meaning: a word that another language has for something else would be read as that.
void TestRoster::everyLanguagesWordsAreRead() {
    QFETCH(QString, language);
    const catalogue::LanguageWords::Roster words = catalogue::wordsOfLanguage(language.toStdString()).roster;
    using enum RosterColumn;
    int headings = 0;
    for (const auto& [key, column] : {std::pair{"login_name", loginName},
                                      {"display_name", displayName},
                                      {"given_name", givenName},
                                      {"family_name", familyName},
                                      {"roles", roles},
                                      {"password", password},
                                      {"group", group},
                                      {"some_name", loginName}}) // alone, a name is the login name
        for (const QString& heading : words.headings.at(QString::fromLatin1(key))) {
            QVERIFY2(rosterColumns({heading.toStdString()}) == std::vector{column}, qPrintable(heading));
            QVERIFY2(rosterColumns({heading.toUpper().toStdString()}) == std::vector{column},
                     qPrintable(heading));
            ++headings;
        }
    QVERIFY(headings > 10);
    QCOMPARE(words.roles.size(), kAllRoles.size());
    for (const Role role : kAllRoles)
        for (const QString& name : words.roles.at(QString::fromStdString(std::string(token(role)))))
            QVERIFY2(rolesOfCell(name.toStdString()) == std::optional(RoleSet{role}), qPrintable(name));
}

void TestRoster::headingsInThreeLanguages_data() {
    QTest::addColumn<QString>("headings");
    QTest::addColumn<QString>("line");
    const auto row = [](const char* headings, const char* line) {
        QTest::newRow(headings) << QString::fromUtf8(headings) << QString::fromUtf8(line);
    };
    row("name,display_name,roles,password", "anna,Anna Bell,trainer,a good long word");
    row("PASSWORD,Role,FULL NAME,Login-Name", "a good long word,trainer,Anna Bell,anna");
    row("Name,Username,Role,Initial password", "Anna Bell,anna,trainer,a good long word");
    row("Surname,First name,User,Roles,password", "Bell,Anna,anna,trainer,a good long word");
    row("name,surname,login,role,password", "Anna,Bell,anna,trainer,a good long word");
    row("Name,Vorname,Benutzername,Rolle,Kennwort", "Bell,Anna,anna,Ausbilderin,a good long word");
    row("VORNAME,NACHNAME,ANMELDENAME,ROLLE(N),PASSWORT", "Anna,Bell,anna,Ausbilder:in,a good long word");
    row("Anzeigename,Kennung,Rollen,Startpasswort", "Anna Bell,anna,Trainerin,a good long word");
    row("Όνομα,Επώνυμο,Όνομα χρήστη,Ρόλος,Κωδικός", "Anna,Bell,anna,εκπαιδεύτρια,a good long word");
    row("ΟΝΟΜΑΤΕΠΩΝΥΜΟ,ΟΝΟΜΑ ΧΡΗΣΤΗ,ΡΟΛΟΣ,ΣΥΝΘΗΜΑΤΙΚΟ", "Anna Bell,anna,ΕΚΠΑΙΔΕΥΤΗΣ,a good long word");
    row("ονομα,χρηστης,ιδιοτητα,αρχικος κωδικος", "Anna Bell,anna,εκπαιδευτής/-τρια,a good long word");
}

void TestRoster::headingsInThreeLanguages() {
    QFETCH(QString, headings);
    QFETCH(QString, line);
    const Roster roster = readRoster((headings + QLatin1Char('\n') + line).toStdString());
    QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
    const UserCsvRow& row = roster.rows.at(0);
    QCOMPARE(row.name, std::string("anna"));
    QCOMPARE(row.displayName, std::string("Anna Bell"));
    QVERIFY(row.roles == RoleSet{Role::trainer});
    QCOMPARE(row.password, std::string("a good long word"));
    QVERIFY(roster.ignoredColumns.empty());
}

void TestRoster::rolesInThreeLanguages() {
    const auto is = [](const char* words, RoleSet roles) {
        return rolesOfCell(words) == std::optional(roles);
    };
    QVERIFY(is("trainee;trainer", {Role::trainee, Role::trainer}));
    QVERIFY(is(" Trainer | ADMIN ", {Role::trainer, Role::admin}));
    QVERIFY(is("Forschende Person, Lernende", {Role::researcher, Role::trainee}));
    QVERIFY(is("Ερευνήτρια;διαχειριστής", {Role::researcher, Role::admin}));
    QVERIFY(is("Ausbilder/in;", {Role::trainer}));
    for (const char* trainee :
         {"Teilnehmer", "Teilnehmer/in", "Teilnehmer:in", "TEILNEHMENDE", "Studierende/r", "Kursteilnehmerin",
          "participant", "Student", "φοιτήτρια", "συμμετέχων"})
        QVERIFY2(is(trainee, {Role::trainee}), trainee);
    for (const char* trainer : {"Dozentin", "Kursleiter/in", "Instructor"})
        QVERIFY2(is(trainer, {Role::trainer}), trainer);
    for (const char* wrong : {"", " ", ";", "wizard", "trainee;wizard", "trainee trainer", "-"})
        QVERIFY2(!rolesOfCell(wrong), wrong);
}

void TestRoster::lineEndsAndEmptyRows() {
    const Roster roster = readRoster(";;;\r\n  login name ; full name ;role;\r\n anna ;  Anna\xc2\xa0  Bell "
                                     ";trainee\n;;;\rbert;\"Bert\r\nof the hill\";trainee;;;\r\n\n\r\n;;;");
    QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
    QCOMPARE(roster.rows.size(), std::size_t{2});
    QCOMPARE(roster.rows[0].line, 3);
    QCOMPARE(roster.rows[0].name, std::string("anna"));
    QCOMPARE(roster.rows[0].displayName, std::string("Anna Bell"));
    QCOMPARE(roster.rows[1].line, 5);
    QCOMPARE(roster.rows[1].displayName, std::string("Bert of the hill"));
    const Roster late = readRoster("\r\nlogin name;role\r\nanna;trainee\r\n"); // the first line is empty
    QVERIFY(late.problems.empty() && late.rows.size() == 1 && late.rows[0].line == 3);
    QCOMPARE(readRoster("login name\nanna\n").delimiter, ','); // nothing is separated
    const Roster plain = readRoster("login name,role\nanna");  // a cell at the end is left out
    QVERIFY(has(plain, RosterFault::roles, 2) && plain.rows.size() == 1);
    const Roster least = readRoster("login name,role\nanna,trainee");
    QVERIFY(least.problems.empty() && least.rows[0].displayName.empty() && least.rows[0].password.empty());
}

void TestRoster::otherFilesAreNamed_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<int>("fault");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* title, const QByteArray& bytes, RosterFault fault, const char* said) {
        QTest::newRow(title) << bytes << static_cast<int>(fault) << QString::fromLatin1(said);
    };
    const QByteArray zip("PK\x03\x04\x14\x00\x06\x00", 8);
    row("xlsx", zip + QByteArray(22, '\1') + "[Content_Types].xml", RosterFault::excelFile, "save it as CSV");
    row("xlsx, other order", zip + QByteArray(9000, '\1') + "xl/workbook.xml", RosterFault::excelFile,
        "save it as CSV");
    row("ods", zip + QByteArray(22, '\1') + "mimetypeapplication/vnd.oasis.opendocument.spreadsheet",
        RosterFault::openDocumentFile, "save it as CSV");
    row("xls", QByteArray("\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", 8) + QByteArray(500, '\0'),
        RosterFault::oldExcelFile, "save it as CSV");
    row("pdf", "%PDF-1.7\n1 0 obj", RosterFault::pdfFile, "expected a CSV file");
    row("zip", zip + QByteArray(22, '\1') + "people.csv", RosterFault::archiveFile,
        "expected the CSV file itself");
    row("empty zip", QByteArray("PK\x05\x06", 4) + QByteArray(18, '\0'), RosterFault::archiveFile,
        "expected the CSV file itself");
    row("zeros in a text",
        QByteArray("login name,role\nanna,trainee\nbe\0rt,trainee\nand many more characters that are none",
                   78),
        RosterFault::notText, "line 3");
    row("only zeros", QByteArray(64, '\0'), RosterFault::notText, "line 1");
    row("empty", "", RosterFault::nobody, "expected a header line");
    row("only a mark", "\xef\xbb\xbf", RosterFault::nobody, "expected a header line");
    row("only a heading", "login name;role\r\n", RosterFault::nobody, "at least one person");
    row("only sep=", "sep=;\r\n", RosterFault::nobody, "at least one person");
}

void TestRoster::otherFilesAreNamed() {
    QFETCH(QByteArray, bytes);
    QFETCH(int, fault);
    QFETCH(QString, said);
    const Roster roster = readRoster(bytes.toStdString());
    QCOMPARE(roster.problems.size(), std::size_t{1});
    QCOMPARE(static_cast<int>(roster.problems[0].fault), fault);
    QVERIFY2(roster.problems[0].words.find(said.toStdString()) != std::string::npos,
             roster.problems[0].words.c_str());
    QVERIFY(roster.rows.empty());
    QCOMPARE(accounts().importCsv(m_admin, bytes.toStdString()).error().code, core::ErrorCode::badInput);
    QCOMPARE(people(), std::size_t{1});
}

void TestRoster::faultsNameLineAndColumn() {
    const Roster roster = readRoster("Anmeldename;Name;Rolle;Kennwort;E-Mail\n"
                                     "anna;Anna;Zauberin;;a@b\n"
                                     ";Bert;Lernende;;\n"
                                     "carl,x;Carl;Lernende;;\n"
                                     "dora;Dora;Lernende;short;\n"
                                     "ANNA;Anna;Lernende;;\n"
                                     "emil;Emil;Lernende;;;;more\n"
                                     "simulated;Sim;Lernende;;\n"
                                     "frieda;" +
                                     std::string(201, 'x') + ";Lernende;;\n");
    const auto said = [&](RosterFault fault, int line, const char* column, const char* words) {
        return std::any_of(roster.problems.begin(), roster.problems.end(), [&](const RosterProblem& p) {
            return p.fault == fault && p.line == line && p.column == column &&
                   p.words.starts_with("line " + std::to_string(line) + ", " + column) &&
                   p.words.find(words) != std::string::npos;
        });
    };
    QVERIFY2(said(RosterFault::roles, 2, "Rolle", "\"Zauberin\": expected trainee"), wordsOf(roster).c_str());
    QVERIFY(said(RosterFault::name, 3, "Anmeldename", "1 to 64 characters"));
    QVERIFY(said(RosterFault::name, 4, "Anmeldename", "\"carl,x\": name not accepted"));
    QVERIFY(said(RosterFault::password, 5, "Kennwort", "at least 10 characters"));
    QVERIFY(said(RosterFault::nameTwice, 6, "Anmeldename", "given already in line 2"));
    QVERIFY(said(RosterFault::fieldCount, 7, "fields", "\"7\": expected 5"));
    QVERIFY(said(RosterFault::name, 8, "Anmeldename", "kept for the program"));
    QVERIFY(said(RosterFault::displayName, 9, "Name", "at most 200"));
    QCOMPARE(roster.problems.size(), std::size_t{8});
    QCOMPARE(roster.ignoredColumns, std::vector<std::string>{"E-Mail"});
    QVERIFY(wordsOf(roster).find("short") == std::string::npos); // a password is never repeated

    QVERIFY(has(readRoster("anna,trainee\nbert,trainee\n"), RosterFault::noHeadings, 1));
    QVERIFY(has(readRoster("full name;role\nAnna;trainee\n"), RosterFault::columnMissing, 1));
    QVERIFY(has(readRoster("Vorname;Nachname;Rolle\nA;B;Lernende\n"), RosterFault::columnMissing, 1));
    const Roster roles = readRoster(
        "name,display_name,rolse,password\na,A,admin,\n"); // a slip of the pen must not make anybody anything
    QVERIFY(has(roles, RosterFault::columnMissing, 1) && roles.problems.size() == 1 &&
            roles.problems[0].value == "role");
    const Roster twice = readRoster("login;user;role\na;b;trainee\n");
    QVERIFY(has(twice, RosterFault::columnTwice, 1) && twice.problems[0].value == "user");
    QVERIFY(
        has(readRoster("login;;role\nanna;what;trainee\n"), RosterFault::fieldCount, 2)); // under no heading
    const Roster open = readRoster("login;role\nanna;trainee\nbert;\"trainee\ncarl;trainee\n");
    QVERIFY(has(open, RosterFault::notClosed, 3) && open.rows.empty()); // where it is opened
}

void TestRoster::badBytesNameTheirLine() {
    const auto lineOf = [](const std::string& bytes) {
        const Roster roster = readRoster(bytes);
        return roster.problems.size() == 1 && roster.problems[0].fault == RosterFault::notReadable
                   ? roster.problems[0].line
                   : 0;
    };
    QCOMPARE(lineOf("login;name\na;Größe\nb;Weiß\nc;M\xc3"), 4);         // UTF-8, cut off within a letter
    QCOMPARE(lineOf("\xef\xbb\xbflogin;name\na;M\xfcller\n"), 2);        // says UTF-8 and is not
    QCOMPARE(lineOf("login;name\nb;Γιώργος\nc;\xed\xa0\x80 Άννα\n"), 3); // half of a pair
    QCOMPARE(lineOf("\xff\xfe" + encoded("login;name\na;b", "UTF-16LE") + "c"), 2); // half a character
    QCOMPARE(lineOf("login;name\na;b\nc;\x81\xff\n"), 3);                           // in neither code page
}

void TestRoster::bytesTellTheirEncoding_data() {
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<QString>("told");
    const auto row = [](const char* title, const QByteArray& bytes, const char* told) {
        QTest::newRow(title) << bytes << QString::fromLatin1(told);
    };
    // The first and the last character of each length in UTF-8, and what is next to them and none.
    row("first of two bytes", "a,\xc2\x80\n", "UTF-8");
    row("last of two bytes", "a,\xdf\xbf\n", "UTF-8");
    row("first of three bytes", "a,\xe0\xa0\x80\n", "UTF-8");
    row("last before the surrogates", "a,\xed\x9f\xbf\n", "UTF-8");
    row("last of three bytes", "a,\xef\xbf\xbf\n", "UTF-8");
    row("first of four bytes", "a,\xf0\x90\x80\x80\n", "UTF-8");
    row("last of four bytes", "a,\xf4\x8f\xbf\xbf\n", "UTF-8");
    row("a continuation alone", "a,5 \x80\n", "Windows-1252"); // the euro
    row("two bytes for one", "a,\xc1\xbf,b\n", "Windows-1252");
    row("three bytes for two", "a,\xe0\x9f\xbf\n", "Windows-1252");
    row("a surrogate", "a,\xed\xa0\x80\n", "Windows-1252");
    row("four bytes for three", "a,\xf0\x8f\xbf\xbf\n", "damaged"); // in no code page either
    row("beyond the last", "a,\xf4\x90\x80\x80\n", "damaged");
    row("no first byte", "a,\xf5\x80\x80\x80\n", "Windows-1252");
    // UTF-8 with faults in it, unless there are more of these than of other letters.
    row("as many right as wrong", "a,\xc3\xbc,\xff\n", "damaged");
    row("more wrong than right", "\xc3\xbc,J\xf6rg,M\xfcller\n", "Windows-1252");
    // Greek words are of Greek letters alone, accents stand within words.
    row("a Greek word of three letters", "a;\xb8\xf7\xf9\n", "Windows-1253");
    row("a word and an accent", "x\xb8\xf7\xf9;n\xe9\n", "Windows-1253");
    row("a word and two accents", "\xc4\xd6\xdc;Andr\xe9 Ren\xe9\n", "Windows-1252");
    row("an initial", "a;\xd6.\n", "Windows-1252");
    // UTF-16 without a mark: zero bytes are at least every tenth, and at least two.
    const std::string greek = "αβγδεζηθικλμνξοπ";
    row("enough zeros, LE", QByteArray::fromStdString(encoded(greek + ";\n;\n", "UTF-16LE")), "UTF-16");
    row("enough zeros, BE", QByteArray::fromStdString(encoded(greek + ";\n;\n", "UTF-16BE")), "UTF-16");
    row("too few zeros", QByteArray::fromStdString(encoded(greek + "ρ;\n;", "UTF-16LE")), "binary");
    row("two zeros", QByteArray("a\0\n\0", 4), "UTF-16");
    row("only a mark of UTF-16", "\xff\xfe", "UTF-16");
    row("the end of an old text", "a,b\n\x1a", "UTF-8");
}

void TestRoster::bytesTellTheirEncoding() {
    QFETCH(QByteArray, bytes);
    QFETCH(QString, told);
    const auto read = readTableText(bytes.toStdString());
    const QString got = read ? QString::fromStdString(read->encoding)
                        : read.error().kind == TextProblem::Kind::damaged ? QStringLiteral("damaged")
                        : read.error().kind == TextProblem::Kind::binary  ? QStringLiteral("binary")
                                                                          : QStringLiteral("another file");
    QCOMPARE(got, told);
}

void TestRoster::whoExistsIsSkippedOrUpdated() {
    REQUIRE(m->person(m_admin, "Bob", {Role::trainee}));
    REQUIRE(m->person(m_admin, "eve", {Role::trainer}));
    const std::string file = "login name;full name;role;password\nBOB;Robert;trainer;\neve;eve "
                             "display;trainer;another long word\nzoe;Zoe;trainee;\n";
    const auto kinds = [&](RosterExisting existing) {
        const auto plan = accounts().previewCsv(m_admin, file, existing);
        std::vector<RosterStep::Kind> list;
        for (const RosterStep& step : plan->steps)
            list.push_back(step.kind);
        return list;
    };
    using enum RosterStep::Kind;
    QVERIFY((kinds(RosterExisting::skip) == std::vector{skip, skip, add}));
    QVERIFY((kinds(RosterExisting::update) == std::vector{update, same, add}));
    const auto plan = accounts().previewCsv(m_admin, file, RosterExisting::update);
    QCOMPARE(plan->steps[0].name, std::string("Bob")); // stays as it is
    QCOMPARE(plan->steps[0].displayNameBefore, std::string("Bob display"));
    QCOMPARE(plan->steps[0].displayName, std::string("Robert"));
    QVERIFY(plan->steps[2].makesPassword && !plan->steps[0].makesPassword);
    QVERIFY(plan->roster.rows[1].password.empty());
    QCOMPARE(people(), std::size_t{3});

    const auto skipped = accounts().importCsv(m_admin, file);
    REQUIRE(skipped);
    QCOMPARE(skipped->added.size(), std::size_t{1});
    QCOMPARE(skipped->skipped, 2);
    QCOMPARE(personOf("bob").displayName, std::string("Bob display"));
    const auto updated = accounts().importCsv(m_admin, file, RosterExisting::update);
    REQUIRE(updated);
    QCOMPARE(updated->updated, 1);
    QCOMPARE(updated->skipped, 2); // Zoe is there by now
    QVERIFY(updated->added.empty());
    QCOMPARE(personOf("bob").displayName, std::string("Robert"));
    QVERIFY(personOf("bob").roles == RoleSet{Role::trainer});
    REQUIRE(accounts().login("bob", kPassword)); // passwords stay
    REQUIRE(accounts().login("eve", kPassword));
    QCOMPARE(accounts().earlierNames(m_admin, personOf("bob").id)->front().displayName,
             std::string("Bob display"));
}

void TestRoster::anUpdateLeavesWhatTheListDoesNotSay() {
    REQUIRE(m->person(m_admin, "eve", {Role::trainer}));
    REQUIRE(
        accounts().importCsv(m_admin, "login name;full name;role\neve;;trainer\n", RosterExisting::update));
    QCOMPARE(personOf("eve").displayName, std::string("eve display"));
    QVERIFY(personOf("eve").roles == RoleSet{Role::trainer});
}

void TestRoster::rolesThatStayAreNotSetAgain() {
    const auto bob = m->person(m_admin, "bob", {Role::trainee});
    const auto eve = m->person(m_admin, "eve", {Role::trainer});
    REQUIRE(bob);
    REQUIRE(eve);
    REQUIRE(accounts().importCsv(m_admin, "login name;full name;role\nbob;Robert;trainee\neve;Eva;trainee\n",
                                 RosterExisting::update));
    QVERIFY(personOf("bob").displayName == "Robert" && personOf("eve").displayName == "Eva");
    const auto audit = AuditRepository(**m->database->openReader(), m_admin).listAudit();
    REQUIRE(audit);
    std::vector<PersonId> changed;
    for (const AuditEntry& entry : *audit)
        if (entry.action == "setRoles")
            changed.push_back(entry.targetId);
    QCOMPARE(changed, std::vector<PersonId>{eve->personId()});
    QVERIFY(personOf("bob").roles == RoleSet{Role::trainee} &&
            personOf("eve").roles == RoleSet{Role::trainee});
}

void TestRoster::whoWasRenamedIsKnownByTheOldName() {
    const auto bob = m->person(m_admin, "bob", {Role::trainee});
    const auto eve = m->person(m_admin, "eve", {Role::trainee});
    REQUIRE(bob);
    REQUIRE(eve);
    REQUIRE(accounts().changeNames(m_admin, bob->personId(), "robert", "Robert"));
    REQUIRE(accounts().changeNames(m_admin, bob->personId(), "rob", "Robert"));
    REQUIRE(accounts().changeNames(m_admin, eve->personId(), "eve", "Eve E.")); // keeps the login name
    using enum RosterStep::Kind;
    const std::string file =
        "login name;full name;role\nBOB;Robert B.;trainer\neve;;trainee\nzoe;Zoe;trainee\n";
    const auto plan = accounts().previewCsv(m_admin, file, RosterExisting::update);
    REQUIRE(plan);
    QVERIFY(plan->steps[0].kind == update && plan->steps[0].person == bob->personId());
    QCOMPARE(plan->steps[0].name, std::string("rob"));
    QCOMPARE(plan->steps[0].earlierName, std::string("BOB"));
    QVERIFY(plan->steps[1].kind == same && plan->steps[1].earlierName.empty() &&
            plan->steps[1].doubt == RosterStep::Doubt::none);
    QVERIFY(plan->steps[2].kind == add);
    QVERIFY(accounts().previewCsv(m_admin, file)->steps[0].kind == skip);
    const auto done = accounts().importCsv(m_admin, file, RosterExisting::update);
    REQUIRE(done);
    QVERIFY(done->added.size() == 1 && done->updated == 1 && done->skipped == 1);
    QVERIFY(done->told.size() == 1 && done->told[0].earlierName == "BOB");
    QCOMPARE(personOf("rob").displayName, std::string("Robert B."));
    QVERIFY(personOf("rob").roles == RoleSet{Role::trainer});
    QCOMPARE(people(), std::size_t{4}); // ada, rob, eve, zoe
    // Whoever is erased is no longer known by any name.
    REQUIRE(accounts().erasePerson(m_admin, kPassword, bob->personId(), "wish", false));
    QVERIFY(accounts().previewCsv(m_admin, file)->steps[0].kind == add);
}

void TestRoster::anOldListTurnsNoFullNameBack() {
    const auto bob = m->person(m_admin, "bob", {Role::trainee});
    const auto eve = m->person(m_admin, "eve", {Role::trainee});
    REQUIRE(bob);
    REQUIRE(eve);
    REQUIRE(accounts().changeNames(m_admin, bob->personId(), "rob", "Robert"));
    REQUIRE(accounts().changeNames(m_admin, eve->personId(), "eve", "Eve E.")); // the full name alone
    using enum RosterStep::Kind;
    const std::string old = "login name;full name;role\nbob;bob display;trainer\neve;eve display;trainee\n";
    const auto plan = accounts().previewCsv(m_admin, old, RosterExisting::update);
    REQUIRE(plan);
    QVERIFY(plan->steps[0].kind == update && plan->steps[1].kind == same);
    QCOMPARE(plan->steps[0].displayName, std::string("Robert"));
    QCOMPARE(plan->steps[0].earlierDisplayName, std::string("bob display"));
    QCOMPARE(plan->steps[1].earlierDisplayName, std::string("eve display"));
    const auto done = accounts().importCsv(m_admin, old, RosterExisting::update);
    REQUIRE(done);
    QVERIFY(done->updated == 1 && done->skipped == 1 && done->told.size() == 2);
    QCOMPARE(personOf("rob").displayName, std::string("Robert"));
    QVERIFY(personOf("rob").roles == RoleSet{Role::trainer}); // what else the list says is done
    QCOMPARE(personOf("eve").displayName, std::string("Eve E."));
    // Another person's earlier name, and a name that is new, are taken.
    const std::string fresh = "login name;full name;role\nrob;eve display;trainer\neve;Eve F.;trainee\n";
    REQUIRE(accounts().importCsv(m_admin, fresh, RosterExisting::update));
    QCOMPARE(personOf("rob").displayName, std::string("eve display"));
    QCOMPARE(personOf("eve").displayName, std::string("Eve F."));
    // Where nobody is updated there is nothing to say about it.
    QVERIFY(accounts().previewCsv(m_admin, old, RosterExisting::skip)->steps[0].earlierDisplayName.empty());
}

void TestRoster::aNameOfTodayComesBeforeAnOldOne() {
    const auto first = m->person(m_admin, "anna", {Role::trainee});
    REQUIRE(first);
    REQUIRE(accounts().changeNames(m_admin, first->personId(), "anna1", "First Anna"));
    const auto second = m->person(m_admin, "anna", {Role::trainee});
    REQUIRE(second);
    using enum RosterStep::Kind;
    using Doubt = RosterStep::Doubt;
    // Today's holder is meant, and it is said that somebody else had the name.
    const auto named = accounts().previewCsv(m_admin, "login name;full name;role\nAnna;Anna A.;trainer\n",
                                             RosterExisting::update);
    REQUIRE(named);
    QVERIFY(named->steps[0].kind == update && named->steps[0].person == second->personId() &&
            named->steps[0].earlierName.empty());
    QVERIFY(named->steps[0].doubt == Doubt::nameOfAnother && named->steps[0].other == "anna1");
    // Both have had it, and nobody has it: nobody is changed, nobody is added.
    REQUIRE(accounts().changeNames(m_admin, second->personId(), "anna2", "Second Anna"));
    const std::string file = "login name;full name;role\nanna;Anna A.;trainer\n";
    const auto several = accounts().previewCsv(m_admin, file, RosterExisting::update);
    REQUIRE(several);
    QVERIFY(several->steps[0].kind == skip && several->steps[0].doubt == Doubt::severalHadIt &&
            !several->steps[0].makesPassword);
    const auto imported = accounts().importCsv(m_admin, file, RosterExisting::update);
    REQUIRE(imported);
    QVERIFY(imported->added.empty() && imported->updated == 0 && imported->skipped == 1 &&
            imported->told.size() == 1);
    // One person under two names: today's line counts, wherever it stands.
    REQUIRE(accounts().changeNames(m_admin, second->personId(), "berta", "Second Anna"));
    const auto twice = accounts().previewCsv(
        m_admin, "login name;full name;role\nanna2;Wrong;trainer\nberta;Right;trainer\n",
        RosterExisting::update);
    REQUIRE(twice);
    QVERIFY(twice->steps[0].kind == skip && twice->steps[0].doubt == Doubt::sameAsLine &&
            twice->steps[0].otherLine == 3);
    QCOMPARE(twice->steps[0].displayName, std::string("Second Anna"));
    QVERIFY(twice->steps[1].kind == update && twice->steps[1].displayName == "Right");
}

void TestRoster::nothingIsHalfDone() {
    REQUIRE(m->person(m_admin, "bob", {Role::trainee}));
    const std::size_t before = audited();
    // One wrong line among good ones.
    QCOMPARE(
        accounts().importCsv(m_admin, "login name;role\numa;trainee\nvic;wizard\nwim;trainee\n").error().code,
        core::ErrorCode::badInput);
    // The data layer refuses the last of the changes: no administrator would be left.
    const auto last = accounts().importCsv(
        m_admin, "login name;full name;role\numa;Uma;trainee\nbob;Robert;trainer\nada;Ada;trainee\n",
        RosterExisting::update);
    QCOMPARE(last.error().code, core::ErrorCode::wrongUse);
    // Stopped while passwords are made.
    const auto stopped =
        accounts().importCsv(m_admin, "login name;role\numa;trainee\nvic;trainee\nwim;trainee\n",
                             RosterExisting::skip, [](int done, int) { return done < 2; });
    QCOMPARE(stopped.error().code, core::ErrorCode::cancelled);
    // Somebody takes a name between the look and the writing.
    const auto raced = accounts().importCsv(
        m_admin, "login name;role\numa;trainee\nvic;trainee\n", RosterExisting::skip,
        [&](int done, int) { return done != 1 || m->person(m_admin, "vic", {Role::trainee}).has_value(); });
    QCOMPARE(raced.error().code, core::ErrorCode::badInput);
    QVERIFY(raced.error().message.find("vic") != std::string::npos);
    QCOMPARE(people(), std::size_t{3}); // ada, bob, and vic who came by himself
    QVERIFY(personOf("bob").displayName == "bob display" && personOf("bob").roles == RoleSet{Role::trainee});
    QCOMPARE(audited(), before + 2); // vic was added and logged in
}

void TestRoster::madePasswordsAreNowhereElse() {
    const auto done = accounts().importCsv(
        m_admin, "login name;role;password\numa;trainee\nvic;trainee;a good long word\n");
    REQUIRE(done);
    const std::string made = done->added[0].madePassword;
    QVERIFY(checkPassword("uma", made).has_value());
    QVERIFY(done->added[1].madePassword.empty()); // who made the list knows it
    REQUIRE(accounts().login("vic", "a good long word"));
    QVERIFY(accounts().login("uma", made)->mustChangePassword());
    m->database.reset();
    QDirIterator files(m->folder.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
    int looked = 0;
    while (files.hasNext()) {
        QFile file(files.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY2(!bytes.contains(made.c_str()) && !bytes.contains("a good long word"),
                 qPrintable(file.fileName()));
        looked += 1;
    }
    QVERIFY(looked >= 3);
}

void TestRoster::onlyAdministratorsImport() {
    for (const Role role : {Role::trainee, Role::trainer, Role::researcher}) {
        const auto other = m->person(m_admin, std::string(token(role)) + "-1", {role});
        REQUIRE(other);
        QCOMPARE(accounts().previewCsv(*other, "login name;role\numa;trainee\n").error().code,
                 core::ErrorCode::notAllowed);
        QCOMPARE(accounts().importCsv(*other, "login name;role\numa;trainee\n").error().code,
                 core::ErrorCode::notAllowed);
    }
    QCOMPARE(people(), std::size_t{4});
}

void TestRoster::tenThousandLines() {
    std::string text = "Anmeldename;Name;Rolle\r\n";
    for (int i = 1; i < 10000; ++i)
        text += "p" + std::to_string(i) + ";Größe " + std::to_string(i) + ";Lernende\r\n";
    for (const char* encoding : {"UTF-8", "UTF-16LE", "CP1252"}) {
        const Roster roster = readRoster(encoded(text, encoding));
        QVERIFY2(roster.problems.empty(), wordsOf(roster).c_str());
        QCOMPARE(roster.rows.size(), std::size_t{9999});
        QCOMPARE(roster.rows.back().displayName, std::string("Größe 9999"));
        QCOMPARE(roster.rows.back().line, 10000);
    }
    QVERIFY(has(readRoster(text + "one;too;many\r\n"), RosterFault::tooManyLines, 10001));
}

// Whatever comes, the reader ends, says something, and what it lets through can be stored.
void TestRoster::anyBytesAreReadOrRefused() {
    const std::string base = "Anmeldename;\"Name; ganz\";Rolle;Kennwort\r\nmueller;\"Jörg \"\"Jo\"\" "
                             "Müller\";Lernende;\r\numa;Ούμα Ώρα;εκπαιδευτής;a good long word\n";
    const std::string bits[] = {"\"",      ";",    ",",        "\t",
                                "\r",      "\n",   "\r\n",     std::string(1, '\0'),
                                "\xc3",    "\xe4", "\xff\xfe", "\xef\xbb\xbf",
                                "sep=;\n", "Ώ",    "\x1a",     "PK\x03\x04",
                                "%PDF",    "''",   "=1+1",     std::string(300, 'x')};
    for (quint32 seed = 1; seed <= 3000; ++seed) {
        QRandomGenerator random(seed);
        static constexpr const char* kEncodings[] = {"UTF-8", "UTF-16LE", "UTF-16BE", "CP1252//IGNORE",
                                                     "CP1253//IGNORE"};
        const char* encoding = kEncodings[seed % 5];
        std::string bytes = seed % 5 < 3 ? encoded(base, encoding) : base;
        for (int change = random.bounded(1, 6); change > 0; --change) {
            const auto at = static_cast<std::size_t>(random.bounded(static_cast<int>(bytes.size()) + 1));
            switch (random.bounded(4)) {
            case 0:
                bytes.insert(at, bits[random.bounded(static_cast<int>(std::size(bits)))]);
                break;
            case 1:
                bytes.resize(at); // cut off
                break;
            case 2:
                bytes.erase(at, static_cast<std::size_t>(random.bounded(8)));
                break;
            default:
                if (at < bytes.size())
                    bytes[at] = static_cast<char>(random.bounded(256));
            }
        }
        const Roster roster = readRoster(bytes);
        QVERIFY2(!roster.problems.empty() || !roster.rows.empty(), qPrintable(QString::number(seed)));
        for (const RosterProblem& problem : roster.problems)
            QVERIFY2(problem.line >= 1 && !problem.words.empty(), qPrintable(QString::number(seed)));
        if (!roster.problems.empty())
            continue;
        for (const UserCsvRow& row : roster.rows) {
            QVERIFY2(checkNames(row.name, row.displayName).has_value() && !row.roles.empty(),
                     qPrintable(QString::number(seed)));
            QVERIFY2(row.password.empty() || checkPassword(row.name, row.password).has_value(),
                     qPrintable(QString::number(seed)));
        }
    }
}

QTEST_GUILESS_MAIN(TestRoster)
#include "test_roster.moc"
