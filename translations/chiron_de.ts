<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AboutDialog</name>
    <message>
        <source>About Chiron</source>
        <translation>Über Chiron</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Training for the sense of touch in minimally invasive surgery. Named after the centaur who taught Asclepius medicine; his name comes from cheir, hand.</source>
        <translation>Training für den Tastsinn in der minimalinvasiven Chirurgie. Benannt nach dem Kentauren, der Asklepios die Heilkunst lehrte; sein Name kommt von cheir, Hand.</translation>
    </message>
    <message>
        <source>Free software under the GNU General Public License, version 3 or later. Not a medical device.</source>
        <translation>Freie Software unter der GNU General Public License, Version 3 oder neuer. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Build: %1</source>
        <translation>Programmstand: %1</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>AccountForm</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>AccountWords</name>
    <message>
        <source>Too many wrong attempts. This account is locked for a moment; nothing is lost.</source>
        <translation>Zu viele falsche Versuche. Dieses Konto ist kurz gesperrt; es geht nichts verloren.</translation>
    </message>
    <message>
        <source>This account is disabled. What was recorded is kept; an administrator can enable the account again.</source>
        <translation>Dieses Konto ist deaktiviert. Aufgezeichnetes bleibt erhalten; die Administration kann das Konto wieder aktivieren.</translation>
    </message>
    <message>
        <source>Trainee</source>
        <translation>Lernende Person</translation>
    </message>
    <message>
        <source>Trainer</source>
        <translation>Ausbilder/in</translation>
    </message>
    <message>
        <source>Researcher</source>
        <translation>Forschende Person</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administration</translation>
    </message>
    <message>
        <source>Wrong name or password. Passwords are case-sensitive; check Caps Lock.</source>
        <translation>Name oder Passwort ist falsch. Groß- und Kleinschreibung wird unterschieden; prüfen Sie die Feststelltaste.</translation>
    </message>
    <message>
        <source>Wrong name or recovery code. The code has five groups of five letters and digits.</source>
        <translation>Name oder Wiederherstellungscode ist falsch. Der Code besteht aus fünf Gruppen mit je fünf Buchstaben und Ziffern.</translation>
    </message>
    <message numerus="yes">
        <source>Try again in %n second(s)</source>
        <translation>
            <numerusform>Neuer Versuch in %n Sekunde</numerusform>
            <numerusform>Neuer Versuch in %n Sekunden</numerusform>
        </translation>
    </message>
    <message>
        <source>Wrong password. Passwords are case-sensitive.</source>
        <translation>Falsches Passwort. Groß- und Kleinschreibung wird unterschieden.</translation>
    </message>
    <message>
        <source>Wrong name or password; check Caps Lock. Ask an administrator; your login name may have changed.</source>
        <translation>Name oder Passwort ist falsch; prüfen Sie die Feststelltaste. Fragen Sie die Administration; Ihr Anmeldename wurde vielleicht geändert.</translation>
    </message>
</context>
<context>
    <name>Advice</name>
    <message>
        <source>in trial %1</source>
        <translation>in Durchgang %1</translation>
    </message>
    <message>
        <source>in trial %1, %2 after it began</source>
        <translation>in Durchgang %1, %2 nach dessen Beginn</translation>
    </message>
    <message>
        <source>%1 after the start</source>
        <translation>%1 nach dem Start</translation>
    </message>
    <message>
        <source>at a depth of %1, %2</source>
        <translation>in %1 Tiefe, %2</translation>
    </message>
    <message>
        <source>It was worst %1: %2.</source>
        <translation>Am schlechtesten war es %1: %2.</translation>
    </message>
    <message>
        <source>It was worst %1.</source>
        <translation>Am schlechtesten war es %1.</translation>
    </message>
</context>
<context>
    <name>AnswerNote</name>
    <message>
        <source>Marked</source>
        <translation>Markiert</translation>
    </message>
    <message>
        <source>%1 mm from the top: not on the sphere</source>
        <translation>%1 mm vom höchsten Punkt: nicht auf der Kugel</translation>
    </message>
    <message>
        <source>%1 mm from the top</source>
        <translation>%1 mm vom höchsten Punkt</translation>
    </message>
    <message>
        <source>Time is up</source>
        <translation>Die Zeit ist um</translation>
    </message>
    <message>
        <source>This trial can no longer be completed</source>
        <translation>Dieser Durchgang kann nicht mehr abgeschlossen werden</translation>
    </message>
    <message>
        <source>Trial completed</source>
        <translation>Durchgang abgeschlossen</translation>
    </message>
    <message>
        <source>Right: there was no lump</source>
        <translation>Richtig: Es war kein Knoten da</translation>
    </message>
    <message>
        <source>There was no lump</source>
        <translation>Es war kein Knoten da</translation>
    </message>
    <message>
        <source>%1 of %2 lumps found</source>
        <translation>%1 von %2 Knoten gefunden</translation>
    </message>
    <message>
        <source>The lump was missed</source>
        <translation>Der Knoten wurde übersehen</translation>
    </message>
    <message>
        <source>Lump found, %1 mm off</source>
        <translation>Knoten gefunden, %1 mm daneben</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message numerus="yes">
        <source>%n false alarm(s)</source>
        <translation>
            <numerusform>%n Fehlalarm</numerusform>
            <numerusform>%n Fehlalarme</numerusform>
        </translation>
    </message>
    <message>
        <source>Too much: the tissue was damaged</source>
        <translation>Zu viel: Das Gewebe wurde beschädigt</translation>
    </message>
    <message>
        <source>It slipped: hold it a little more firmly</source>
        <translation>Abgerutscht: Halten Sie etwas fester</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Not counted: mark while you touch the sphere</source>
        <translation>Zählt nicht: Markieren Sie, während Sie die Kugel berühren</translation>
    </message>
    <message>
        <source>Too hard: the tissue gave way. Draw back until you are out of it</source>
        <translation>Zu fest: Das Gewebe hat nachgegeben. Ziehen Sie zurück, bis Sie wieder draußen sind</translation>
    </message>
    <message>
        <source>The tissue gave way</source>
        <translation>Das Gewebe hat nachgegeben</translation>
    </message>
    <message>
        <source>The tissue gave way: this trial can no longer be completed</source>
        <translation>Das Gewebe hat nachgegeben: Dieser Durchgang kann nicht mehr abgeschlossen werden</translation>
    </message>
    <message>
        <source>The tube tore: this trial can no longer be completed. Stretch it less far, and pull more gently</source>
        <translation>Der Schlauch ist gerissen: Dieser Durchgang kann nicht mehr abgeschlossen werden. Dehnen Sie ihn weniger weit und ziehen Sie sanfter</translation>
    </message>
    <message>
        <source>The tube tore: this trial can no longer be completed</source>
        <translation>Der Schlauch ist gerissen: Dieser Durchgang kann nicht mehr abgeschlossen werden</translation>
    </message>
    <message>
        <source>Too hard: the tissue gave way. Draw back until you are out of it, or open the jaws if they squeezed it</source>
        <translation>Zu fest: Das Gewebe hat nachgegeben. Ziehen Sie zurück, bis Sie wieder draußen sind, oder öffnen Sie die Branchen, wenn sie es gequetscht haben</translation>
    </message>
    <message>
        <source>The object came off the tool</source>
        <translation>Das Objekt hat sich vom Instrument gelöst</translation>
    </message>
    <message>
        <source>%1 mm from the middle of the ring</source>
        <translation>%1 mm von der Mitte des Rings</translation>
    </message>
</context>
<context>
    <name>AskedSitting</name>
    <message>
        <source>The study %1 could not be opened.</source>
        <translation>Die Studie %1 konnte nicht geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>CheckRecord</name>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
</context>
<context>
    <name>CommandWords</name>
    <message>
        <source>start page, dashboard, begin, what next, news</source>
        <translation>Startseite, anfangen, Neuigkeiten, was nun</translation>
    </message>
    <message>
        <source>experiment, research, trial, participants, questionnaire</source>
        <translation>Experiment, Versuch, Forschung, Teilnehmende, Fragebogen</translation>
    </message>
    <message>
        <source>analysis, statistics, export</source>
        <translation>Auswertung, Statistik, exportieren</translation>
    </message>
    <message>
        <source>group, class, course, cohort, overview, results, trainees, students, learners, passed, due, who has trained</source>
        <translation>Gruppe, Klasse, Kurs, Kohorte, Überblick, Übersicht, Ergebnisse, Lernende, Studierende, bestanden, fällig, wer hat trainiert</translation>
    </message>
    <message>
        <source>users, accounts, group, class, roster, trainees, students, names, passwords, roles, add a user</source>
        <translation>Benutzer, Konten, Gruppe, Klasse, Namensliste, Lernende, Studierende, Namen, Passwörter, Rollen, Konto anlegen</translation>
    </message>
    <message>
        <source>backup, back up, copy, restore, disk, space, database, verify, save</source>
        <translation>Sicherung, Backup, sichern, Kopie, Wiederherstellen, Festplatte, Speicherplatz, Datenbank, prüfen</translation>
    </message>
    <message>
        <source>device, haptic, hardware, calibration, check, timing, computer, test</source>
        <translation>Gerät, haptisch, Hardware, Kalibrierung, prüfen, Zeitverhalten, Rechner, Test</translation>
    </message>
    <message>
        <source>progress, scores, marks, grades, curve, history, overview, review, export my data</source>
        <translation>Fortschritt, Wertungen, Noten, Lernkurve, Verlauf, Übersicht, Rückblick, meine Daten exportieren</translation>
    </message>
    <message>
        <source>options, preferences, language, theme, dark mode, text size, sound, volume</source>
        <translation>Optionen, Sprache, Farben, dunkel, Schriftgröße, Ton, Lautstärke</translation>
    </message>
    <message>
        <source>assess, feedback, look at, mark, grade, inbox, to do</source>
        <translation>Begutachtung, begutachten, bewerten, Rückmeldung, Feedback, benoten, Posteingang, zu tun</translation>
    </message>
    <message>
        <source>feedback, notes, remarks, messages, answers, replies, review</source>
        <translation>Rückmeldung, Feedback, Notizen, Anmerkungen, Nachrichten, Antworten, Begutachtung</translation>
    </message>
    <message>
        <source>switch user, logout, log off, sign out, change user, leave</source>
        <translation>Benutzer wechseln, ausloggen, Abmeldung, Logout, verlassen</translation>
    </message>
    <message>
        <source>password, profile, name, recovery code</source>
        <translation>Passwort, Profil, Name, Wiederherstellungscode</translation>
    </message>
    <message>
        <source>quit, exit, end the program, shut down</source>
        <translation>beenden, schließen, Programm verlassen</translation>
    </message>
    <message>
        <source>manual, guide, how do I, what is this</source>
        <translation>Handbuch, Anleitung, wie geht das, was ist das</translation>
    </message>
    <message>
        <source>keys, hotkeys</source>
        <translation>Tasten, Tastenkürzel</translation>
    </message>
    <message>
        <source>pause, away, screen lock</source>
        <translation>Pause, abwesend, Bildschirmsperre</translation>
    </message>
    <message>
        <source>train, practise, practice, task, lesson, level, choose an exercise, curriculum</source>
        <translation>trainieren, üben, Training, Aufgabe, Lektion, Stufe, Übung wählen, Lehrplan</translation>
    </message>
    <message>
        <source>recordings, attempts, history, list, playback, debrief</source>
        <translation>Aufzeichnungen, Versuche, Verlauf, Liste, Wiedergabe, Auswertung</translation>
    </message>
</context>
<context>
    <name>Commands</name>
    <message>
        <source>Go to: %1</source>
        <translation>Gehe zu: %1</translation>
    </message>
    <message>
        <source>Colours: light</source>
        <translation>Farben: hell</translation>
    </message>
    <message>
        <source>Colours: dark</source>
        <translation>Farben: dunkel</translation>
    </message>
    <message>
        <source>Colours: high contrast</source>
        <translation>Farben: hoher Kontrast</translation>
    </message>
    <message>
        <source>Larger text and controls</source>
        <translation>Text und Bedienelemente größer</translation>
    </message>
    <message>
        <source>Smaller text and controls</source>
        <translation>Text und Bedienelemente kleiner</translation>
    </message>
    <message>
        <source>Language: %1</source>
        <translation>Sprache: %1</translation>
    </message>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Help for this screen</source>
        <translation>Hilfe zu dieser Ansicht</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>Close Chiron</source>
        <translation>Chiron beenden</translation>
    </message>
    <message>
        <source>Screens</source>
        <translation>Bereiche</translation>
    </message>
    <message>
        <source>Program</source>
        <translation>Programm</translation>
    </message>
    <message>
        <source>About Chiron</source>
        <translation>Über Chiron</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Mein Konto</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>Sessions to review</source>
        <translation>Zu begutachtende Sitzungen</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
</context>
<context>
    <name>ControlGuide</name>
    <message>
        <source>Advance</source>
        <translation>Vorschieben</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>Move the mouse, or use the arrow keys.</source>
        <translation>Bewegen Sie die Maus oder nehmen Sie die Pfeiltasten.</translation>
    </message>
    <message>
        <source>Shift sideways</source>
        <translation>Seitlich verschieben</translation>
    </message>
    <message>
        <source>Move the mouse with the right button or Shift held.</source>
        <translation>Bewegen Sie die Maus mit gedrückter rechter Taste oder Umschalttaste.</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Lower</source>
        <translation>Senken</translation>
    </message>
    <message>
        <source>Close the jaw</source>
        <translation>Branchen schließen</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation>Fund markieren</translation>
    </message>
    <message>
        <source>Click, or press Enter. When nothing is left to report, press D.</source>
        <translation>Klicken Sie oder drücken Sie Enter. Ist nichts mehr zu melden, drücken Sie D.</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Click, or press Enter, while you touch the place.</source>
        <translation>Klicken Sie oder drücken Sie Enter, während Sie die Stelle berühren.</translation>
    </message>
    <message>
        <source>Roll the wheel away from you, or hold W. To withdraw, roll it towards you, or hold S.</source>
        <translation>Drehen Sie das Rad von sich weg oder halten Sie W. Zum Zurückziehen drehen Sie es zu sich hin oder halten Sie S.</translation>
    </message>
    <message>
        <source>Roll the wheel towards you, or hold Page Down. To raise, roll it away from you, or hold Page Up.</source>
        <translation>Drehen Sie das Rad zu sich hin oder halten Sie Bild ab. Zum Anheben drehen Sie es von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>Take the handle and move it: the tool moves with it.</source>
        <translation>Nehmen Sie den Griff und bewegen Sie ihn: Das Instrument bewegt sich mit.</translation>
    </message>
    <message>
        <source>Push the handle in. To withdraw, pull it out.</source>
        <translation>Schieben Sie den Griff hinein. Zum Zurückziehen ziehen Sie ihn heraus.</translation>
    </message>
    <message>
        <source>Turn and tilt the handle.</source>
        <translation>Drehen und neigen Sie den Griff.</translation>
    </message>
    <message>
        <source>Move the handle sideways.</source>
        <translation>Bewegen Sie den Griff seitwärts.</translation>
    </message>
    <message>
        <source>Lower the handle. To raise the instrument, raise the handle.</source>
        <translation>Senken Sie den Griff. Zum Anheben des Instruments heben Sie ihn an.</translation>
    </message>
    <message>
        <source>Close the grip of the handle. To open the jaw, open the grip.</source>
        <translation>Schließen Sie den Griff. Zum Öffnen der Branchen öffnen Sie ihn.</translation>
    </message>
    <message>
        <source>Lower the handle until the tip makes contact. To raise the tip, raise the handle.</source>
        <translation>Senken Sie den Griff, bis die Spitze aufsetzt. Zum Anheben der Spitze heben Sie ihn an.</translation>
    </message>
    <message>
        <source>Press the button of the handle, or Enter, while you touch the place.</source>
        <translation>Drücken Sie den Knopf am Griff oder Enter, während Sie die Stelle berühren.</translation>
    </message>
    <message>
        <source>Change the instrument</source>
        <translation>Instrument wechseln</translation>
    </message>
    <message>
        <source>You move one instrument at a time. Press 1 for the right one, 2 for the left one.</source>
        <translation>Sie bewegen jeweils ein Instrument. Drücken Sie 1 für das rechte, 2 für das linke.</translation>
    </message>
    <message>
        <source>You move one instrument at a time. Press its number, 1 to %1.</source>
        <translation>Sie bewegen jeweils ein Instrument. Drücken Sie seine Nummer, 1 bis %1.</translation>
    </message>
    <message>
        <source>Take the handle and move it: the finger moves with it.</source>
        <translation>Nehmen Sie den Griff und bewegen Sie ihn: Der Finger bewegt sich mit.</translation>
    </message>
    <message>
        <source>Push the handle down. To raise the finger, raise the handle.</source>
        <translation>Drücken Sie den Griff nach unten. Zum Anheben des Fingers heben Sie ihn an.</translation>
    </message>
    <message>
        <source>Press the button of the handle, or Enter. When nothing is left to report, press D.</source>
        <translation>Drücken Sie den Knopf am Griff oder Enter. Ist nichts mehr zu melden, drücken Sie D.</translation>
    </message>
    <message>
        <source>Change hands</source>
        <translation>Hand wechseln</translation>
    </message>
    <message>
        <source>You move one hand at a time. Press H for the other one.</source>
        <translation>Sie bewegen jeweils eine Hand. Drücken Sie H für die andere.</translation>
    </message>
    <message>
        <source>Hold the left button, or G. When you let go, the jaw stays as it is. To open it, hold Shift and the left button, or H.</source>
        <translation>Halten Sie die linke Taste oder G. Wenn Sie loslassen, bleiben die Branchen, wie sie sind. Zum Öffnen halten Sie die Umschalttaste und die linke Taste oder H.</translation>
    </message>
</context>
<context>
    <name>DesignFaults</name>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 cannot be rendered. Choose a reference of %2.</source>
        <translation>%1 kann nicht dargestellt werden. Wählen Sie eine Referenz von %2.</translation>
    </message>
    <message>
        <source>An object would have %1, but only %2 can be rendered. Choose smaller differences or another reference.</source>
        <translation>Ein Objekt hätte %1, dargestellt werden kann aber nur %2. Wählen Sie kleinere Unterschiede oder eine andere Referenz.</translation>
    </message>
    <message>
        <source>This task compares with objects above the reference only: every difference must be above 0 %.</source>
        <translation>Diese Aufgabe vergleicht nur mit Objekten über der Referenz: Jeder Unterschied muss über 0 % liegen.</translation>
    </message>
    <message>
        <source>This is empty. Write something.</source>
        <translation>Dieses Feld ist leer. Schreiben Sie etwas hinein.</translation>
    </message>
    <message>
        <source>Use only lower-case letters, digits and _, and begin with a letter.</source>
        <translation>Nur Kleinbuchstaben, Ziffern und _ verwenden und mit einem Buchstaben beginnen.</translation>
    </message>
    <message>
        <source>A level lies outside the table of differences. Choose one within it, or change the table.</source>
        <translation>Eine Stufe liegt außerhalb der Tabelle der Unterschiede. Wählen Sie eine innerhalb, oder ändern Sie die Tabelle.</translation>
    </message>
    <message>
        <source>Choose a value from %1 to %2.</source>
        <translation>Wählen Sie einen Wert von %1 bis %2.</translation>
    </message>
    <message>
        <source>Found: %1. Expected: %2.</source>
        <translation>Gefunden: %1. Erwartet: %2.</translation>
    </message>
    <message>
        <source>At least one participant is needed.</source>
        <translation>Mindestens eine Person muss teilnehmen.</translation>
    </message>
    <message>
        <source>Another condition has the same name. Tables and figures could not tell them apart.</source>
        <translation>Eine andere Bedingung hat denselben Namen. In Tabellen und Abbildungen wären sie nicht zu unterscheiden.</translation>
    </message>
    <message>
        <source>The lightest object weighs only %1 N, so lifting it would not count as touching. Choose a smaller force.</source>
        <translation>Das leichteste Objekt wiegt nur %1 N; es anzuheben würde deshalb nicht als Berührung zählen. Wählen Sie eine kleinere Kraft.</translation>
    </message>
    <message>
        <source>A trial with more than %1 N does not count, so this force has to be smaller.</source>
        <translation>Ein Durchgang mit mehr als %1 N zählt nicht, deshalb muss diese Kraft kleiner sein.</translation>
    </message>
    <message>
        <source>The maximum has to be above the minimum.</source>
        <translation>Das Maximum muss über dem Minimum liegen.</translation>
    </message>
    <message>
        <source>Choose a value of at most %1.</source>
        <translation>Wählen Sie einen Wert von höchstens %1.</translation>
    </message>
    <message>
        <source>A difference is listed twice. Remove one of them.</source>
        <translation>Ein Unterschied kommt zweimal vor. Lassen Sie einen davon weg.</translation>
    </message>
    <message>
        <source>This is already used. Choose something else.</source>
        <translation>Das gibt es schon einmal. Wählen Sie etwas anderes.</translation>
    </message>
    <message>
        <source>Enter %1 to %2 choices, one per line.</source>
        <translation>Geben Sie %1 bis %2 Antworten ein, eine je Zeile.</translation>
    </message>
</context>
<context>
    <name>Drivers</name>
    <message>
        <source>Mouse and keyboard</source>
        <translation>Maus und Tastatur</translation>
    </message>
    <message>
        <source>Ready. Moves the tool with a pointer or with keys.</source>
        <translation>Bereit. Bewegt das Instrument mit Zeiger oder Tasten.</translation>
    </message>
    <message>
        <source>Recorded trace</source>
        <translation>Aufgezeichnete Bewegung</translation>
    </message>
    <message>
        <source>Ready. Plays a trace file as if a hand moved the device.</source>
        <translation>Bereit. Spielt eine Bewegungsdatei ab, als würde eine Hand das Gerät bewegen.</translation>
    </message>
    <message>
        <source>Simulated gimbal</source>
        <translation>Simulierter Gimbal</translation>
    </message>
    <message>
        <source>Simulated five-bar mechanism</source>
        <translation>Simuliertes Fünfgelenk</translation>
    </message>
    <message>
        <source>Simulated arm with fingertip platform</source>
        <translation>Simulierter Arm mit Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>Simulated mechanism with a scripted hand</source>
        <translation>Simulierter Mechanismus mit programmierter Hand</translation>
    </message>
    <message>
        <source>Ready. Nothing needs to be connected.</source>
        <translation>Bereit. Es muss nichts angeschlossen werden.</translation>
    </message>
    <message>
        <source>Exactly</source>
        <translation>Exakt</translation>
    </message>
    <message>
        <source>By the published formulas (error up to 27 %)</source>
        <translation>Nach den veröffentlichten Formeln (Fehler bis 27 %)</translation>
    </message>
    <message>
        <source>How the gimbal renders force</source>
        <translation>Wie der Gimbal Kraft ausgibt</translation>
    </message>
    <message>
        <source>Haptic device (USB, network or serial line)</source>
        <translation>Haptisches Gerät (USB, Netzwerk oder serielle Leitung)</translation>
    </message>
    <message>
        <source>Its forces are felt. Plug it in by USB, or give its address on the command line (see chiron-cli train --help). Tested against an emulation; it never met hardware.</source>
        <translation>Seine Kräfte sind zu spüren. Schließen Sie es über USB an, oder geben Sie seine Adresse auf der Befehlszeile an (siehe chiron-cli train --help). Mit einer Nachbildung geprüft; an echter Hardware wurde es noch nie erprobt.</translation>
    </message>
</context>
<context>
    <name>ErrorWords</name>
    <message>
        <source>%1
Details: %2</source>
        <translation>%1
Einzelheiten: %2</translation>
    </message>
    <message>
        <source>Your account does not permit this. If you need it, ask an administrator.</source>
        <translation>Ihr Konto erlaubt das nicht. Wenn Sie diese Berechtigung brauchen, fragen Sie die Administration.</translation>
    </message>
    <message>
        <source>It no longer exists or was never created. Nothing was changed.</source>
        <translation>Es existiert nicht mehr oder wurde nie angelegt. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>It could not be saved. What was recorded before is kept; check the free space and try again.</source>
        <translation>Das Speichern ist fehlgeschlagen. Was bisher aufgezeichnet wurde, bleibt erhalten; prüfen Sie den freien Speicherplatz und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Another program is writing to this database. Close the database there, then try again.</source>
        <translation>Ein anderes Programm schreibt in diese Datenbank. Schließen Sie sie dort und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The device did not respond correctly. Check its cable and power, then try again.</source>
        <translation>Das Gerät hat nicht richtig geantwortet. Prüfen Sie Kabel und Stromversorgung und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>The operation was stopped before it finished. Nothing was changed.</source>
        <translation>Der Vorgang wurde vorzeitig abgebrochen. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The check found errors.</source>
        <translation>Die Prüfung hat Fehler gefunden.</translation>
    </message>
    <message>
        <source>The input is not valid. Nothing was changed.</source>
        <translation>Die Angaben sind ungültig. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>A file that the site needs is missing. Put it back, then try again. Nothing was changed.</source>
        <translation>Eine Datei, die der Standort braucht, fehlt. Legen Sie sie zurück und versuchen Sie es noch einmal. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>It could not be read. Check that the drive is connected and that you may read the file, then try again. Nothing was changed.</source>
        <translation>Das Lesen ist fehlgeschlagen. Prüfen Sie, ob das Laufwerk angeschlossen ist und ob Sie die Datei lesen dürfen, und versuchen Sie es noch einmal. Nichts wurde geändert.</translation>
    </message>
    <message>
        <source>The stored data are not valid. Nothing was changed.</source>
        <translation>Die gespeicherten Daten sind ungültig. Nichts wurde geändert.</translation>
    </message>
</context>
<context>
    <name>ExercisePart</name>
    <message>
        <source>The answers, seen from above</source>
        <translation>Die Antworten, von oben gesehen</translation>
    </message>
    <message>
        <source>How the endoscope followed the urethra</source>
        <translation>Wie das Endoskop der Harnröhre folgte</translation>
    </message>
    <message>
        <source>How the tube was held and stretched</source>
        <translation>Wie der Schlauch gehalten und gedehnt wurde</translation>
    </message>
    <message>
        <source>How each object was held and set down</source>
        <translation>Wie jedes Objekt gehalten und abgelegt wurde</translation>
    </message>
    <message>
        <source>What was searched and what was found</source>
        <translation>Was abgetastet und was gefunden wurde</translation>
    </message>
    <message>
        <source>What was compared</source>
        <translation>Was verglichen wurde</translation>
    </message>
    <message>
        <source>There is no answer to show. The session is kept and listed.</source>
        <translation>Es gibt keine Antwort, die gezeigt werden kann. Die Sitzung bleibt erhalten und steht in der Liste.</translation>
    </message>
    <message>
        <source>There is nothing of the procedure to show. The session is kept and listed.</source>
        <translation>Vom Eingriff gibt es nichts, was gezeigt werden kann. Die Sitzung bleibt erhalten und steht in der Liste.</translation>
    </message>
    <message>
        <source>There is no tension to show. The session is kept and listed.</source>
        <translation>Es gibt keine Spannung, die gezeigt werden kann. Die Sitzung bleibt erhalten und steht in der Liste.</translation>
    </message>
    <message>
        <source>There is no object to show. The session is kept and listed.</source>
        <translation>Es gibt kein Objekt, das gezeigt werden kann. Die Sitzung bleibt erhalten und steht in der Liste.</translation>
    </message>
    <message>
        <source>There is no search to show. The session is kept and listed.</source>
        <translation>Es gibt keine Suche, die gezeigt werden kann. Die Sitzung bleibt erhalten und steht in der Liste.</translation>
    </message>
    <message>
        <source>What was compared and answered is shown with its study.</source>
        <translation>Was verglichen und geantwortet wurde, steht bei der Studie.</translation>
    </message>
    <message>
        <source>Result of each trial</source>
        <translation>Ergebnis jedes Durchgangs</translation>
    </message>
    <message>
        <source>%1 of %2 landmarks of the bladder were seen.</source>
        <translation>%1 von %2 Landmarken der Blase wurden gesehen.</translation>
    </message>
</context>
<context>
    <name>ExitBackup</name>
    <message>
        <source>Making today&apos;s backup</source>
        <translation>Die heutige Sicherung wird erstellt</translation>
    </message>
    <message>
        <source>Chiron closes by itself when the backup is made and checked.</source>
        <translation>Chiron wird von selbst beendet, sobald die Sicherung erstellt und geprüft ist.</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Close without a backup</source>
        <translation>Ohne Sicherung beenden</translation>
    </message>
</context>
<context>
    <name>FeltWords</name>
    <message>
        <source>%1: force felt</source>
        <translation>%1: Kraft gefühlt</translation>
    </message>
    <message>
        <source>%1: force shown, not felt</source>
        <translation>%1: Kraft gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>This level shows no measurements: rely on what you feel. Everything is recorded and appears in the results.</source>
        <translation>Diese Stufe zeigt keine Messwerte: Arbeiten Sie nach Gefühl. Alles wird aufgezeichnet und erscheint im Ergebnis.</translation>
    </message>
    <message>
        <source>This level shows no measurements: rely on the scene. Everything is recorded and appears in the results.</source>
        <translation>Diese Stufe zeigt keine Messwerte: Richten Sie sich nach der Szene. Alles wird aufgezeichnet und erscheint im Ergebnis.</translation>
    </message>
    <message>
        <source>You feel the objects through the device.</source>
        <translation>Sie fühlen die Objekte durch das Gerät.</translation>
    </message>
    <message>
        <source>This device renders no force: the force is shown beside the scene.</source>
        <translation>Dieses Gerät gibt keine Kraft aus: Die Kraft wird neben der Szene gezeigt.</translation>
    </message>
    <message>
        <source>Space pauses. Esc stops force at once, and R brings it back slowly; Esc again asks whether to stop.</source>
        <translation>Die Leertaste pausiert. Esc nimmt die Kraft sofort weg, R bringt sie langsam zurück; ein zweites Esc fragt, ob Sie die Sitzung beenden möchten.</translation>
    </message>
    <message>
        <source>Space pauses. Esc stops the trial at once, and R goes on; Esc again asks whether to stop the session.</source>
        <translation>Die Leertaste pausiert. Esc hält den Durchgang sofort an, R setzt ihn fort; ein zweites Esc fragt, ob Sie die Sitzung beenden möchten.</translation>
    </message>
    <message>
        <source>Esc stops force at once; pressed again, it asks whether to stop the session. T frees the pointer.</source>
        <translation>Esc nimmt die Kraft sofort weg; noch einmal gedrückt, fragt es, ob die Sitzung beendet werden soll. T gibt den Mauszeiger frei.</translation>
    </message>
    <message>
        <source>Esc stops the trial at once; pressed again, it asks whether to stop the session. T frees the pointer.</source>
        <translation>Esc hält den Durchgang sofort an; noch einmal gedrückt, fragt es, ob die Sitzung beendet werden soll. T gibt den Mauszeiger frei.</translation>
    </message>
    <message>
        <source>Force is stopped</source>
        <translation>Kraft ist gestoppt</translation>
    </message>
    <message>
        <source>The trial is stopped</source>
        <translation>Der Durchgang ist angehalten</translation>
    </message>
    <message>
        <source>Stop force</source>
        <translation>Kraft stoppen</translation>
    </message>
    <message>
        <source>Stop the trial</source>
        <translation>Durchgang anhalten</translation>
    </message>
    <message>
        <source>Re-arm force</source>
        <translation>Kraft freigeben</translation>
    </message>
    <message>
        <source>Go on after a stop</source>
        <translation>Nach dem Anhalten fortfahren</translation>
    </message>
</context>
<context>
    <name>ForceWords</name>
    <message>
        <source>Force is stopped</source>
        <translation>Kraft ist gestoppt</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Press Re-arm (or R) to go on, or End session.</source>
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten. Drücken Sie „Freigeben“ (oder R), um weiterzumachen, oder „Sitzung beenden“.</translation>
    </message>
    <message>
        <source>The safety supervisor switched the force off.</source>
        <translation>Die Sicherheitsüberwachung hat die Kraft abgeschaltet.</translation>
    </message>
    <message>
        <source>The tool moved faster than is safe, so force was switched off.</source>
        <translation>Das Instrument bewegte sich schneller, als sicher ist; deshalb wurde die Kraft abgeschaltet.</translation>
    </message>
    <message>
        <source>The device&apos;s data came too late, so force was switched off.</source>
        <translation>Die Daten des Geräts kamen zu spät; deshalb wurde die Kraft abgeschaltet.</translation>
    </message>
    <message>
        <source>The device sent impossible positions, so force was switched off.</source>
        <translation>Das Gerät meldete unmögliche Positionen; deshalb wurde die Kraft abgeschaltet.</translation>
    </message>
    <message>
        <source>The device reports a fault, so force was switched off.</source>
        <translation>Das Gerät meldet einen Fehler; deshalb wurde die Kraft abgeschaltet.</translation>
    </message>
    <message>
        <source>The calculated force was invalid (not a number), so force was switched off. Please report this.</source>
        <translation>Die berechnete Kraft war ungültig (keine Zahl); deshalb wurde die Kraft abgeschaltet. Bitte melden Sie das.</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Hold the tool safely, then press Re-arm (or R).</source>
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten. Halten Sie das Instrument sicher und drücken Sie dann „Freigeben“ (oder R).</translation>
    </message>
    <message>
        <source>Waiting for the device</source>
        <translation>Warten auf das Gerät</translation>
    </message>
    <message>
        <source>The device has not sent a valid position yet. Check that it is switched on.</source>
        <translation>Das Gerät hat noch keine gültige Position gesendet. Prüfen Sie, ob es eingeschaltet ist.</translation>
    </message>
    <message>
        <source>Hold still</source>
        <translation>Bitte stillhalten</translation>
    </message>
    <message>
        <source>Hold the tool still for half a second; force then rises slowly.</source>
        <translation>Halten Sie das Instrument eine halbe Sekunde still; die Kraft steigt dann langsam an.</translation>
    </message>
    <message>
        <source>Force is on hold</source>
        <translation>Kraft ist vorübergehend aus</translation>
    </message>
    <message>
        <source>The window did not respond for a moment. Force comes back by itself.</source>
        <translation>Das Fenster hat kurz nicht reagiert. Die Kraft kommt von selbst zurück.</translation>
    </message>
    <message>
        <source>Force is not on yet</source>
        <translation>Kraft ist noch nicht an</translation>
    </message>
    <message>
        <source>Move the tool until it touches nothing, or hold it still and press Resume here.</source>
        <translation>Bewegen Sie das Instrument, bis es nichts mehr berührt, oder halten Sie es still und drücken Sie „Hier fortsetzen“.</translation>
    </message>
    <message>
        <source>You are watching</source>
        <translation>Sie sehen zu</translation>
    </message>
    <message>
        <source>Force is shown, not felt.</source>
        <translation>Die Kraft wird gezeigt, nicht gefühlt.</translation>
    </message>
    <message>
        <source>No movement</source>
        <translation>Keine Bewegung</translation>
    </message>
    <message>
        <source>Nothing has moved for two seconds. Move the mouse over the scene or press an arrow key.</source>
        <translation>Seit zwei Sekunden bewegt sich nichts. Bewegen Sie die Maus über der Szene oder drücken Sie eine Pfeiltaste.</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>This device renders no force. The tool stays at the surface and moves more slowly the harder you press.</source>
        <translation>Dieses Gerät gibt keine Kraft aus. Das Instrument bleibt an der Oberfläche und bewegt sich umso langsamer, je fester Sie drücken.</translation>
    </message>
    <message>
        <source>Getting ready</source>
        <translation>Vorbereitung</translation>
    </message>
    <message>
        <source>The first trial begins as soon as the scene is drawn.</source>
        <translation>Der erste Durchgang beginnt, sobald die Szene zu sehen ist.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The clock is stopped. Press Resume or Space to go on.</source>
        <translation>Die Uhr steht. Drücken Sie „Weiter“ oder die Leertaste, um fortzufahren.</translation>
    </message>
    <message>
        <source>Force is rising</source>
        <translation>Kraft steigt an</translation>
    </message>
    <message>
        <source>It rises slowly (now %1 %). The clock starts once it has reached full strength.</source>
        <translation>Sie steigt langsam an (jetzt %1 %). Die Uhr startet, sobald die volle Stärke erreicht ist.</translation>
    </message>
    <message>
        <source>Force is on</source>
        <translation>Kraft ist an</translation>
    </message>
    <message>
        <source>Esc stops it at once.</source>
        <translation>Esc stoppt sie sofort.</translation>
    </message>
    <message>
        <source>The device&apos;s data arrive late. Force comes back when they arrive on time again.</source>
        <translation>Die Daten des Geräts kommen verspätet an. Die Kraft kommt zurück, sobald die Daten wieder rechtzeitig eintreffen.</translation>
    </message>
    <message>
        <source>The operator&apos;s force waits until the tool is free.</source>
        <translation>Die Kraft der programmierten Hand wartet, bis das Instrument frei ist.</translation>
    </message>
    <message>
        <source>The operator&apos;s force rises slowly (%1 %).</source>
        <translation>Die Kraft der programmierten Hand steigt langsam an (%1 %).</translation>
    </message>
    <message>
        <source>The operator&apos;s force is on hold for a moment and comes back by itself.</source>
        <translation>Die Kraft der programmierten Hand ist kurz aus und kommt von selbst zurück.</translation>
    </message>
    <message>
        <source>This device renders no force. The endoscope moves more slowly the harder you press.</source>
        <translation>Dieses Gerät gibt keine Kraft aus. Das Endoskop bewegt sich umso langsamer, je fester Sie drücken.</translation>
    </message>
    <message>
        <source>The procedure begins as soon as the scene is drawn.</source>
        <translation>Der Eingriff beginnt, sobald die Szene zu sehen ist.</translation>
    </message>
    <message>
        <source>This device renders no force. An instrument moves more slowly the harder something pulls or presses.</source>
        <translation>Dieses Gerät gibt keine Kraft aus. Ein Instrument bewegt sich umso langsamer, je stärker etwas zieht oder drückt.</translation>
    </message>
</context>
<context>
    <name>FreezeChecks</name>
    <message>
        <source>Entries</source>
        <translation>Eingaben</translation>
    </message>
    <message>
        <source>All entries are complete and fit together.</source>
        <translation>Alle Eingaben sind vollständig und passen zueinander.</translation>
    </message>
    <message numerus="yes">
        <source>%n entr(y/ies) must be corrected. The first: %1</source>
        <translation>
            <numerusform>%n Eingabe muss berichtigt werden. Sie lautet: %1</numerusform>
            <numerusform>%n Eingaben müssen berichtigt werden. Die erste: %1</numerusform>
        </translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Write what is to be found out and what you expect. It cannot be added later.</source>
        <translation>Schreiben Sie, was herausgefunden werden soll und was Sie erwarten. Später lässt es sich nicht mehr ergänzen.</translation>
    </message>
    <message>
        <source>Ethics</source>
        <translation>Ethik</translation>
    </message>
    <message>
        <source>Name the approval, or say why none is needed.</source>
        <translation>Nennen Sie das Votum, oder sagen Sie, warum keines nötig ist.</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Write what participants agree to.</source>
        <translation>Schreiben Sie, worin die Teilnehmenden einwilligen.</translation>
    </message>
    <message>
        <source>The text is very short. Check that it says what is recorded, for how long, and that stopping has no disadvantage.</source>
        <translation>Der Text ist sehr kurz. Prüfen Sie, ob er sagt, was wie lange aufgezeichnet bleibt und dass ein Abbruch keine Nachteile hat.</translation>
    </message>
    <message>
        <source>There is a text; participants read it before their first trial.</source>
        <translation>Ein Text liegt vor; die Teilnehmenden lesen ihn vor dem ersten Durchgang.</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Plan at least one participant.</source>
        <translation>Planen Sie mindestens eine Person ein.</translation>
    </message>
    <message>
        <source>%1 are planned. With a multiple of %2 every order of conditions comes equally often.</source>
        <translation>%1 sind geplant. Bei einem Vielfachen von %2 kommt jede Reihenfolge der Bedingungen gleich oft vor.</translation>
    </message>
    <message>
        <source>%1 are planned.</source>
        <translation>%1 sind geplant.</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>There are no practice trials. The first trials that count are then the participant&apos;s first ever.</source>
        <translation>Es gibt keine Übungsdurchgänge. Die ersten gewerteten Durchgänge sind dann die allerersten der Person.</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>About %1 minutes for each participant, as simulated.</source>
        <translation>In der Simulation etwa %1 Minuten je Person.</translation>
    </message>
    <message>
        <source>Attention wanes after an hour: plan fewer trials or several sessions.</source>
        <translation>Nach einer Stunde lässt die Aufmerksamkeit nach: Planen Sie weniger Durchgänge oder mehrere Sitzungen.</translation>
    </message>
    <message>
        <source>Precision</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>This kind of study estimates no threshold, so there is none to simulate. A pilot shows how much answers vary.</source>
        <translation>Diese Art von Studie schätzt keine Schwelle, daher wird keine simuliert. Ein Probelauf zeigt, wie stark die Antworten streuen.</translation>
    </message>
    <message>
        <source>The threshold of one run varies by a factor of %1.</source>
        <translation>Die Schwelle eines Laufs streut um den Faktor %1.</translation>
    </message>
    <message>
        <source>Pilot</source>
        <translation>Probelauf</translation>
    </message>
    <message numerus="yes">
        <source>Tried %n time(s).</source>
        <translation>
            <numerusform>%n-mal ausprobiert.</numerusform>
            <numerusform>%n-mal ausprobiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nobody has tried this design yet. Try it yourself first: a few minutes show what is unclear.</source>
        <translation>Noch niemand hat diesen Entwurf ausprobiert. Probieren Sie ihn zuerst selbst: Wenige Minuten zeigen, was unklar ist.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) before each condition.</source>
        <translation>
            <numerusform>%n Durchgang vor jeder Bedingung.</numerusform>
            <numerusform>%n Durchgänge vor jeder Bedingung.</numerusform>
        </translation>
    </message>
    <message>
        <source>Texts</source>
        <translation>Texte</translation>
    </message>
    <message>
        <source>Nothing in the aim, the instructions or the titles contradicts the settings.</source>
        <translation>Nichts in Ziel, Anleitung und Titeln widerspricht den Einstellungen.</translation>
    </message>
    <message>
        <source>Smallest force</source>
        <translation>Kleinste Kraft</translation>
    </message>
    <message>
        <source>An object counts as touched from %1 N on.</source>
        <translation>Ein Objekt gilt ab %1 N als berührt.</translation>
    </message>
    <message>
        <source>Any graze counts as touching, so participants can answer without having felt anything. %1 N is usual.</source>
        <translation>Schon eine flüchtige Berührung zählt, sodass Teilnehmende antworten können, ohne etwas gefühlt zu haben. Üblich sind %1 N.</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Maskierungsgeräusch</translation>
    </message>
    <message>
        <source>It is switched off. Participants may hear the device, and its sound may tell them which object is which.</source>
        <translation>Es ist ausgeschaltet. Teilnehmende hören vielleicht das Gerät und könnten die Objekte am Geräusch unterscheiden.</translation>
    </message>
    <message>
        <source>It is played during the trials.</source>
        <translation>Es wird während der Durchgänge abgespielt.</translation>
    </message>
    <message>
        <source>This machine has no sound output, so participants would hear the device. Connect headphones or loudspeakers, or run the study on another machine.</source>
        <translation>Dieser Rechner hat keine Tonausgabe, sodass Teilnehmende das Gerät hören würden. Schließen Sie Kopfhörer oder Lautsprecher an, oder führen Sie die Studie an einem anderen Rechner durch.</translation>
    </message>
    <message>
        <source>The aim is written down.</source>
        <translation>Das Ziel ist formuliert.</translation>
    </message>
    <message>
        <source>One participant says nothing about others. Plan more, unless this is a case study.</source>
        <translation>Eine einzige Person sagt nichts über andere. Planen Sie mehr ein, es sei denn, dies ist eine Fallstudie.</translation>
    </message>
    <message>
        <source>Simulated observers are still running through the study …</source>
        <translation>Simulierte Beobachter durchlaufen die Studie noch …</translation>
    </message>
    <message>
        <source>Usable values</source>
        <translation>Brauchbare Werte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>The device of this station renders force.</source>
        <translation>Das Gerät dieses Arbeitsplatzes gibt Kraft aus.</translation>
    </message>
    <message>
        <source>More trials make it more precise; the page “Expected precision” shows how many.</source>
        <translation>Mehr Durchgänge machen es genauer; die Seite „Erwartete Genauigkeit“ zeigt, wie viele.</translation>
    </message>
    <message>
        <source>Not possible yet. Correct first: %1. “Show” beside the red line leads there.</source>
        <translation>Noch nicht möglich. Berichtigen Sie zuerst: %1. „Zeigen“ neben der roten Zeile führt dorthin.</translation>
    </message>
    <message>
        <source>Please wait a moment: simulated observers are still running through the study.</source>
        <translation>Bitte warten Sie einen Moment: Simulierte Beobachter durchlaufen die Studie noch.</translation>
    </message>
    <message>
        <source>Tick the box above first: it confirms what is marked as worth a look.</source>
        <translation>Setzen Sie zuerst das Häkchen oben: Es bestätigt, was als beachtenswert markiert ist.</translation>
    </message>
    <message>
        <source>An object counts as explored once it is lifted off the table.</source>
        <translation>Ein Objekt gilt als erkundet, sobald es vom Tisch gehoben ist.</translation>
    </message>
    <message>
        <source>For each participant: %1.</source>
        <translation>Je Person: %1.</translation>
    </message>
    <message>
        <source>With %1 participants, a comparison of two conditions finds a difference with 80 % power if the Weber fraction of one is at least %2 times that of the other.</source>
        <translation>Mit %1 Teilnehmenden weist ein Vergleich zweier Bedingungen einen Unterschied mit 80 % Teststärke nach, wenn der Weber-Bruch der einen mindestens das %2-Fache des anderen ist.</translation>
    </message>
    <message>
        <source>With so few participants, a comparison of two conditions would often fail to show even a Weber fraction that is ten times the other.</source>
        <translation>Mit so wenigen Teilnehmenden würde ein Vergleich zweier Bedingungen oft sogar einen Weber-Bruch übersehen, der das Zehnfache des anderen ist.</translation>
    </message>
</context>
<context>
    <name>GateWords</name>
    <message>
        <source>%1 % of the radius</source>
        <translation>%1 % des Radius</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: von %2 bis %3</translation>
    </message>
    <message>
        <source>%1: at least %2</source>
        <translation>%1: mindestens %2</translation>
    </message>
    <message>
        <source>%1: at most %2</source>
        <translation>%1: höchstens %2</translation>
    </message>
    <message>
        <source>%1: none</source>
        <translation>%1: keine</translation>
    </message>
    <message>
        <source>%1: at most %2 N, with %3 % more for the time it takes to react</source>
        <translation>%1: höchstens %2 N, mit %3 % Zugabe für die Reaktionszeit</translation>
    </message>
    <message>
        <source>Force limit: %1 N</source>
        <translation>Kraftgrenze: %1 N</translation>
    </message>
    <message>
        <source>Squeeze: %1 N at most</source>
        <translation>Quetschkraft: höchstens %1 N</translation>
    </message>
    <message>
        <source>Pull on the fold: %1 N at most</source>
        <translation>Zug an der Falte: höchstens %1 N</translation>
    </message>
    <message>
        <source>At the end: %1 mm from the middle of the ring at most, on average</source>
        <translation>Am Ende: im Mittel höchstens %1 mm von der Ringmitte entfernt</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1, in every trial</source>
        <translation>%1, in jedem Durchgang</translation>
    </message>
    <message>
        <source>Force across the canal: %1 N at most; pressing harder is a trauma event</source>
        <translation>Kraft quer zum Kanal: höchstens %1 N; stärkerer Druck ist ein Verletzungsereignis</translation>
    </message>
</context>
<context>
    <name>GraspNote</name>
    <message>
        <source>Nothing was grasped</source>
        <translation>Nichts gefasst</translation>
    </message>
    <message>
        <source>Nothing was grasped: the fold still lies over the tube. Retract it first.</source>
        <translation>Nichts gefasst: Die Falte liegt noch über dem Schlauch. Ziehen Sie sie zuerst zurück.</translation>
    </message>
    <message>
        <source>Nothing was grasped. Open the jaws and try again.</source>
        <translation>Nichts gefasst. Öffnen Sie die Branchen und versuchen Sie es noch einmal.</translation>
    </message>
    <message>
        <source>Nothing was grasped: the edge of the fold was %1 mm away. Open the jaws and move closer to it.</source>
        <translation>Nichts gefasst: Der Rand der Falte war %1 mm entfernt. Öffnen Sie die Branchen und gehen Sie näher heran.</translation>
    </message>
    <message>
        <source>Nothing was grasped: the object was %1 mm away. Open the jaws and move closer to it.</source>
        <translation>Nichts gefasst: Das Objekt war %1 mm entfernt. Öffnen Sie die Branchen und gehen Sie näher heran.</translation>
    </message>
    <message>
        <source>Nothing was grasped: the place to grip the tube was %1 mm away. Open the jaws and move closer to it.</source>
        <translation>Nichts gefasst: Die Stelle, an der sich der Schlauch fassen lässt, war %1 mm entfernt. Öffnen Sie die Branchen und gehen Sie näher heran.</translation>
    </message>
    <message>
        <source>Nothing is grasped: the jaws are closed. Open them wide, then close them here.</source>
        <translation>Nichts gefasst: Die Branchen sind geschlossen. Öffnen Sie sie weit und schließen Sie sie dann hier.</translation>
    </message>
</context>
<context>
    <name>GraspWords</name>
    <message>
        <source>Take hold of both ends of the tube, one with each instrument</source>
        <translation>Beide Enden des Schlauchs fassen, mit jedem Instrument eines</translation>
    </message>
    <message>
        <source>Take hold of the end of the tube with the right instrument</source>
        <translation>Das Ende des Schlauchs mit dem rechten Instrument fassen</translation>
    </message>
    <message>
        <source>Take hold of the end of the tube</source>
        <translation>Das Ende des Schlauchs fassen</translation>
    </message>
    <message>
        <source>At the mark: hold it there</source>
        <translation>An der Marke: dort halten</translation>
    </message>
    <message>
        <source>At the target: hold it there</source>
        <translation>Am Ziel: dort halten</translation>
    </message>
    <message>
        <source>In the band: keep the tension there</source>
        <translation>Im Bereich: die Spannung dort halten</translation>
    </message>
    <message>
        <source>The tube is torn: this trial is over</source>
        <translation>Der Schlauch ist gerissen: Dieser Durchgang ist zu Ende</translation>
    </message>
    <message>
        <source>Stretch the tube to the mark, and no farther</source>
        <translation>Den Schlauch bis zur Marke dehnen, nicht weiter</translation>
    </message>
    <message>
        <source>Pull until the tension is in its band</source>
        <translation>Ziehen, bis die Spannung in ihrem Bereich ist</translation>
    </message>
    <message>
        <source>Take the tube over with the left instrument, then let go with the right one</source>
        <translation>Den Schlauch mit dem linken Instrument übernehmen, dann mit dem rechten loslassen</translation>
    </message>
    <message>
        <source>Lift the end of the tube</source>
        <translation>Das Ende des Schlauchs anheben</translation>
    </message>
    <message>
        <source>Bring the end of the tube to the target</source>
        <translation>Das Ende des Schlauchs zum Ziel bringen</translation>
    </message>
    <message>
        <source>Let go of the end of the tube</source>
        <translation>Das Ende des Schlauchs loslassen</translation>
    </message>
    <message>
        <source>Done: the next tube follows</source>
        <translation>Fertig: Der nächste Schlauch folgt</translation>
    </message>
    <message>
        <source>Wait for the tube</source>
        <translation>Auf den Schlauch warten</translation>
    </message>
    <message>
        <source>Lift one object after the other and find the heaviest</source>
        <translation>Ein Objekt nach dem anderen anheben und das schwerste finden</translation>
    </message>
    <message>
        <source>Grasp the object gently</source>
        <translation>Das Objekt behutsam fassen</translation>
    </message>
    <message>
        <source>Lift it up</source>
        <translation>Anheben</translation>
    </message>
    <message>
        <source>Done: the next one follows</source>
        <translation>Fertig: Das nächste folgt</translation>
    </message>
    <message>
        <source>Wait for the object</source>
        <translation>Auf das Objekt warten</translation>
    </message>
    <message>
        <source>Instrument</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>Right instrument</source>
        <translation>Rechtes Instrument</translation>
    </message>
    <message>
        <source>Left instrument</source>
        <translation>Linkes Instrument</translation>
    </message>
    <message>
        <source>Instrument %1</source>
        <translation>Instrument %1</translation>
    </message>
    <message>
        <source>Holding: object %1 of %2</source>
        <translation>Gehalten: Objekt %1 von %2</translation>
    </message>
    <message>
        <source>Holding: the object</source>
        <translation>Gehalten: das Objekt</translation>
    </message>
    <message>
        <source>Holding: the tube at two points</source>
        <translation>Gehalten: der Schlauch an zwei Stellen</translation>
    </message>
    <message>
        <source>Holding: the tube</source>
        <translation>Gehalten: der Schlauch</translation>
    </message>
    <message>
        <source>Holding: nothing</source>
        <translation>Gehalten: nichts</translation>
    </message>
    <message>
        <source>Retract the fold of tissue with the third instrument until the pull is in the band</source>
        <translation>Die Gewebefalte mit dem dritten Instrument zurückziehen, bis der Zug im Zielbereich liegt</translation>
    </message>
    <message>
        <source>Holding: the fold</source>
        <translation>Gehalten: die Falte</translation>
    </message>
    <message>
        <source>Is it the heaviest? Bring it over the ring; otherwise set it down</source>
        <translation>Ist es das schwerste? Über den Ring bringen; sonst ablegen</translation>
    </message>
    <message>
        <source>Bring it over the ring</source>
        <translation>Über den Ring bringen</translation>
    </message>
    <message>
        <source>Set it down inside the ring and let go</source>
        <translation>Im Ring ablegen und loslassen</translation>
    </message>
    <message>
        <source>In the ring: let it lie still</source>
        <translation>Im Ring: liegen lassen</translation>
    </message>
    <message>
        <source>Set it down in the middle of the ring, at most %1 mm off, and let go</source>
        <translation>In der Mitte des Rings ablegen, höchstens %1 mm daneben, und loslassen</translation>
    </message>
    <message>
        <source>Holding: the fold, and the tube at two points</source>
        <translation>Gehalten: die Falte und der Schlauch an zwei Stellen</translation>
    </message>
    <message>
        <source>Holding: the fold, and the tube at one point</source>
        <translation>Gehalten: die Falte und der Schlauch an einer Stelle</translation>
    </message>
</context>
<context>
    <name>HelpDialogs</name>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Help: %1</source>
        <translation>Hilfe: %1</translation>
    </message>
    <message>
        <source>Keys on this screen</source>
        <translation>Tasten in dieser Ansicht</translation>
    </message>
</context>
<context>
    <name>KeyNames</name>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Page Up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
</context>
<context>
    <name>LearningCurve</name>
    <message>
        <source>%1 over the attempts</source>
        <translation>%1 über die Versuche</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>benchmark, felt (%1)</source>
        <translation>Referenz, gefühlt (%1)</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>No completed attempt yet</source>
        <translation>Noch kein abgeschlossener Versuch</translation>
    </message>
</context>
<context>
    <name>LevelFacts</name>
    <message>
        <source>Tissue: normal</source>
        <translation>Gewebe: normal</translation>
    </message>
    <message>
        <source>Tissue: tight urethra</source>
        <translation>Gewebe: enge Harnröhre</translation>
    </message>
    <message>
        <source>Tissue: with a stricture, a narrow and stiff ring</source>
        <translation>Gewebe: mit einer Striktur, einem engen und steifen Ring</translation>
    </message>
    <message>
        <source>Tissue: %1</source>
        <translation>Gewebe: %1</translation>
    </message>
    <message>
        <source>Depth of field: on, fixed</source>
        <translation>Schärfentiefe: an, fest eingestellt</translation>
    </message>
    <message>
        <source>Depth of field: off, fixed</source>
        <translation>Schärfentiefe: aus, fest eingestellt</translation>
    </message>
    <message>
        <source>Depth of field: on, can be switched off</source>
        <translation>Schärfentiefe: an, kann ausgeschaltet werden</translation>
    </message>
    <message>
        <source>Depth of field: off, can be switched on</source>
        <translation>Schärfentiefe: aus, kann eingeschaltet werden</translation>
    </message>
    <message>
        <source>Distance: %1 mm in, then back out</source>
        <translation>Weg: %1 mm hinein, dann wieder hinaus</translation>
    </message>
    <message>
        <source>Distance: %1 mm in</source>
        <translation>Weg: %1 mm hinein</translation>
    </message>
    <message>
        <source>Help: the path is marked in the picture, and a second picture shows it from outside</source>
        <translation>Hilfe: Der Weg ist im Bild markiert, und ein zweites Bild zeigt ihn von außen</translation>
    </message>
    <message>
        <source>Help: the path is marked in the picture</source>
        <translation>Hilfe: Der Weg ist im Bild markiert</translation>
    </message>
    <message>
        <source>Help: a second picture shows the endoscope from outside</source>
        <translation>Hilfe: Ein zweites Bild zeigt das Endoskop von außen</translation>
    </message>
    <message>
        <source>Help: none, only the endoscope&apos;s picture</source>
        <translation>Hilfe: keine, nur das Bild des Endoskops</translation>
    </message>
    <message>
        <source>Landmarks of the bladder to inspect: %1</source>
        <translation>Zu inspizierende Landmarken der Blase: %1</translation>
    </message>
    <message>
        <source>Goal: a tension between %1 and %2 N, held within ±%3 N for %4 s</source>
        <translation>Ziel: eine Spannung zwischen %1 und %2 N, %4 s lang auf ±%3 N genau gehalten</translation>
    </message>
    <message>
        <source>Goal: stretch the tube to %1 times its length and hold it for %2 s</source>
        <translation>Ziel: den Schlauch auf das %1-Fache seiner Länge dehnen und %2 s lang halten</translation>
    </message>
    <message>
        <source>Goal: hand over the end of the tube and hold it in the target for %1 s</source>
        <translation>Ziel: das Ende des Schlauchs übergeben und %1 s lang im Ziel halten</translation>
    </message>
    <message>
        <source>Instruments: two, one in each hand</source>
        <translation>Instrumente: zwei, in jeder Hand eines</translation>
    </message>
    <message>
        <source>Instruments: one</source>
        <translation>Instrumente: eines</translation>
    </message>
    <message>
        <source>Tube: %1 mm long, gets stiffer as it stretches, tears at %2 times its length</source>
        <translation>Schlauch: %1 mm lang, umso steifer, je weiter gedehnt, reißt beim %2-Fachen seiner Länge</translation>
    </message>
    <message>
        <source>Tube: %1 mm long, tears at %2 times its length</source>
        <translation>Schlauch: %1 mm lang, reißt beim %2-Fachen seiner Länge</translation>
    </message>
    <message>
        <source>Hands: two, two fingers each</source>
        <translation>Hände: zwei, je zwei Finger</translation>
    </message>
    <message>
        <source>Hands: two, one finger each</source>
        <translation>Hände: zwei, je ein Finger</translation>
    </message>
    <message>
        <source>Hands: one, two fingers side by side</source>
        <translation>Hände: eine, zwei Finger nebeneinander</translation>
    </message>
    <message>
        <source>Hands: one, one finger</source>
        <translation>Hände: eine, ein Finger</translation>
    </message>
    <message>
        <source>Lumps per trial: %1</source>
        <translation>Knoten je Durchgang: %1</translation>
    </message>
    <message>
        <source>Lumps per trial: one or none</source>
        <translation>Knoten je Durchgang: einer oder keiner</translation>
    </message>
    <message>
        <source>Lumps per trial: 0 to %1</source>
        <translation>Knoten je Durchgang: 0 bis %1</translation>
    </message>
    <message>
        <source>Lumps per trial: %1 to %2</source>
        <translation>Knoten je Durchgang: %1 bis %2</translation>
    </message>
    <message>
        <source>where it is</source>
        <translation>wo er ist</translation>
    </message>
    <message>
        <source>how large</source>
        <translation>wie groß</translation>
    </message>
    <message>
        <source>how hard</source>
        <translation>wie hart</translation>
    </message>
    <message>
        <source>how sure you are</source>
        <translation>wie sicher Sie sind</translation>
    </message>
    <message>
        <source>To report for each finding: %1</source>
        <translation>Zu jedem Fund anzugeben: %1</translation>
    </message>
    <message>
        <source>Press with %1 to %2 N</source>
        <translation>Mit %1 bis %2 N drücken</translation>
    </message>
    <message>
        <source>Instruments: three, one in each hand and one that holds tissue back</source>
        <translation>Instrumente: drei, eines in jeder Hand und eines, das Gewebe zurückhält</translation>
    </message>
    <message>
        <source>Over the tube: a fold of tissue, to be held back with %1 to %2 N</source>
        <translation>Über dem Schlauch: eine Gewebefalte, die mit %1 bis %2 N zurückzuhalten ist</translation>
    </message>
    <message>
        <source>Devices with a base are mounted as this level specifies; your settings below override it</source>
        <translation>Geräte mit Basis sind so aufgestellt, wie diese Stufe es vorgibt; was Sie unten einstellen, hat Vorrang</translation>
    </message>
    <message>
        <source>Goal: put the heaviest of %1 identical-looking objects inside the ring</source>
        <translation>Ziel: das schwerste von %1 gleich aussehenden Objekten in den Ring legen</translation>
    </message>
    <message>
        <source>Goal: lift the object by %1 mm and put it inside the ring</source>
        <translation>Ziel: das Objekt um %1 mm anheben und in den Ring legen</translation>
    </message>
    <message>
        <source>Surface: a soft organ that deforms</source>
        <translation>Unterlage: ein weiches Organ, das sich verformt</translation>
    </message>
    <message>
        <source>Trials: %1; each ends after %2 s at the latest</source>
        <translation>Durchgänge: %1; jeder endet spätestens nach %2 s</translation>
    </message>
    <message>
        <source>The trial ends after %1 s at the latest</source>
        <translation>Der Durchgang endet spätestens nach %1 s</translation>
    </message>
</context>
<context>
    <name>LoginSlips</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Standort</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>At your first login, choose your name in the list, enter this password and then choose one of your own. After that, this slip is of no use: destroy it.</source>
        <translation>Wählen Sie bei der ersten Anmeldung Ihren Namen in der Liste, geben Sie dieses Passwort ein und legen Sie dann ein eigenes fest. Danach wird dieser Zettel nicht mehr gebraucht: Vernichten Sie ihn.</translation>
    </message>
    <message>
        <source>Login slips</source>
        <translation>Anmeldezettel</translation>
    </message>
    <message>
        <source>Cut along the dashed lines and hand each slip to its person.</source>
        <translation>Entlang der gestrichelten Linien schneiden und jeder Person ihren Zettel geben.</translation>
    </message>
</context>
<context>
    <name>Metrics</name>
    <message>
        <source>Procedure completed</source>
        <translation>Eingriff abgeschlossen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>From the first movement or touch of each trial to its end, added up; pauses do not count.</source>
        <translation>Von der ersten Bewegung oder Berührung jedes Durchgangs bis zu seinem Ende, zusammengezählt; Pausen zählen nicht.</translation>
    </message>
    <message>
        <source>Path length</source>
        <translation>Weglänge</translation>
    </message>
    <message>
        <source>How far the tip of the tool travelled in all trials together.</source>
        <translation>Welchen Weg die Instrumentenspitze in allen Durchgängen zusammen zurücklegte.</translation>
    </message>
    <message>
        <source>Path inefficiency</source>
        <translation>Umweg</translation>
    </message>
    <message>
        <source>How much longer the path was than the shortest one: the straight line or, where the route bends, the route itself; the mean over the trials.</source>
        <translation>Wie viel länger der Weg war als der kürzeste: die Gerade oder, wo der Weg gebogen ist, dieser Weg selbst; Mittelwert über die Durchgänge.</translation>
    </message>
    <message>
        <source>Smoothness (SPARC)</source>
        <translation>Bewegungsfluss (SPARC)</translation>
    </message>
    <message>
        <source>How even the speed of each movement was, calculated from its spectrum. Closer to zero is smoother.</source>
        <translation>Wie gleichmäßig die Geschwindigkeit jeder Bewegung war, berechnet aus ihrem Spektrum. Näher an null ist flüssiger.</translation>
    </message>
    <message>
        <source>Smoothness (LDLJ)</source>
        <translation>Bewegungsfluss (LDLJ)</translation>
    </message>
    <message>
        <source>How free of jerks each movement was. Closer to zero is smoother.</source>
        <translation>Wie ruckfrei jede Bewegung war. Näher an null ist flüssiger.</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>The largest force on the tissue at any moment.</source>
        <translation>Die größte Kraft auf das Gewebe zu irgendeinem Zeitpunkt.</translation>
    </message>
    <message>
        <source>Mean force in contact</source>
        <translation>Mittlere Kraft bei Kontakt</translation>
    </message>
    <message>
        <source>The mean force on the tissue while the tool touched it.</source>
        <translation>Die mittlere Kraft auf das Gewebe, solange das Instrument es berührte.</translation>
    </message>
    <message>
        <source>Force, root mean square</source>
        <translation>Kraft, quadratisches Mittel</translation>
    </message>
    <message>
        <source>The root mean square of the force on the tissue: high forces weigh more than in the mean.</source>
        <translation>Das quadratische Mittel der Kraft auf das Gewebe: Hohe Kräfte zählen mehr als im Mittelwert.</translation>
    </message>
    <message>
        <source>Force, 95th percentile</source>
        <translation>Kraft, 95. Perzentil</translation>
    </message>
    <message>
        <source>The force on the tissue was below this for 95 % of the time.</source>
        <translation>Die Kraft auf das Gewebe lag 95 % der Zeit unter diesem Wert.</translation>
    </message>
    <message>
        <source>Peak force rate</source>
        <translation>Größte Kraftänderung</translation>
    </message>
    <message>
        <source>The fastest rise or fall of the force on the tissue.</source>
        <translation>Der schnellste Anstieg oder Abfall der Kraft auf das Gewebe.</translation>
    </message>
    <message>
        <source>Impulse over the limit</source>
        <translation>Kraftstoß über der Grenze</translation>
    </message>
    <message>
        <source>Force times time while the force was over the limit of this level.</source>
        <translation>Kraft mal Zeit, solange die Kraft über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Time over the force limit</source>
        <translation>Zeit über der Kraftgrenze</translation>
    </message>
    <message>
        <source>How long the force on the tissue was over the limit of this level.</source>
        <translation>Wie lange die Kraft auf das Gewebe über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Apex error, mean</source>
        <translation>Scheitelfehler, Mittelwert</translation>
    </message>
    <message>
        <source>How far the marks lay from the highest point, in % of the radius; the mean over both axes and all trials, misses included.</source>
        <translation>Wie weit die Markierungen vom höchsten Punkt entfernt lagen, in % des Radius; Mittelwert über beide Achsen und alle Durchgänge, Fehlversuche eingeschlossen.</translation>
    </message>
    <message>
        <source>Apex error, standard deviation</source>
        <translation>Scheitelfehler, Standardabweichung</translation>
    </message>
    <message>
        <source>How much the error differed from mark to mark.</source>
        <translation>Wie sehr sich der Fehler von Markierung zu Markierung unterschied.</translation>
    </message>
    <message>
        <source>Apex bias, left to right</source>
        <translation>Scheitelversatz, links-rechts</translation>
    </message>
    <message>
        <source>Whether the marks lay to one side: the mean error to the right (positive) or left (negative).</source>
        <translation>Ob die Markierungen zu einer Seite lagen: der mittlere Fehler nach rechts (positiv) oder links (negativ).</translation>
    </message>
    <message>
        <source>Apex bias, front to back</source>
        <translation>Scheitelversatz, vorn-hinten</translation>
    </message>
    <message>
        <source>Whether the marks lay to one side: the mean error away from (positive) or towards (negative) the person.</source>
        <translation>Ob die Markierungen zu einer Seite lagen: der mittlere Fehler von der Person weg (positiv) oder zu ihr hin (negativ).</translation>
    </message>
    <message>
        <source>Misses</source>
        <translation>Fehlversuche</translation>
    </message>
    <message>
        <source>Trials marked without touching, marked beside the sphere, or not marked in time. Their errors count all the same.</source>
        <translation>Durchgänge, die ohne Berührung, neben der Kugel oder nicht rechtzeitig markiert wurden. Ihre Fehler zählen trotzdem.</translation>
    </message>
    <message>
        <source>the recording has no forces</source>
        <translation>die Aufzeichnung enthält keine Kräfte</translation>
    </message>
    <message>
        <source>no trials</source>
        <translation>keine Durchgänge</translation>
    </message>
    <message>
        <source>start and end are less than 5 mm apart</source>
        <translation>Anfang und Ende liegen weniger als 5 mm auseinander</translation>
    </message>
    <message>
        <source>fewer than two samples</source>
        <translation>weniger als zwei Messpunkte</translation>
    </message>
    <message>
        <source>fewer than two positions</source>
        <translation>weniger als zwei Positionen</translation>
    </message>
    <message>
        <source>no contact</source>
        <translation>kein Kontakt</translation>
    </message>
    <message>
        <source>no samples</source>
        <translation>keine Messpunkte</translation>
    </message>
    <message>
        <source>needs two trials or more</source>
        <translation>braucht mindestens zwei Durchgänge</translation>
    </message>
    <message>
        <source>neither movement nor contact</source>
        <translation>weder Bewegung noch Kontakt</translation>
    </message>
    <message>
        <source>no sub-movement of at least 100 ms</source>
        <translation>keine Teilbewegung von mindestens 100 ms</translation>
    </message>
    <message>
        <source>no movement</source>
        <translation>keine Bewegung</translation>
    </message>
    <message>
        <source>speed has no spectrum up to 10 Hz</source>
        <translation>die Geschwindigkeit hat kein Spektrum bis 10 Hz</translation>
    </message>
    <message>
        <source>fewer than three speed samples</source>
        <translation>weniger als drei Messpunkte der Geschwindigkeit</translation>
    </message>
    <message>
        <source>no jerk: speed changes evenly</source>
        <translation>kein Ruck: die Geschwindigkeit ändert sich gleichmäßig</translation>
    </message>
    <message>
        <source>Off-centre distance, root mean square</source>
        <translation>Auslenkung von der Mitte, quadratisches Mittel</translation>
    </message>
    <message>
        <source>How far the tip was from the middle of the urethra, on the way in and out: large distances weigh more than in the mean.</source>
        <translation>Wie weit die Spitze auf dem Weg hinein und hinaus von der Mitte der Harnröhre entfernt war: Große Abstände zählen mehr als im Mittelwert.</translation>
    </message>
    <message>
        <source>Largest off-centre distance</source>
        <translation>Größte Auslenkung von der Mitte</translation>
    </message>
    <message>
        <source>The largest distance of the tip from the middle of the urethra.</source>
        <translation>Der größte Abstand der Spitze von der Mitte der Harnröhre.</translation>
    </message>
    <message>
        <source>Alignment, root mean square</source>
        <translation>Ausrichtung, quadratisches Mittel</translation>
    </message>
    <message>
        <source>Alignment at the bend</source>
        <translation>Ausrichtung an der Biegung</translation>
    </message>
    <message>
        <source>Alignment in the bend</source>
        <translation>Ausrichtung in der Biegung</translation>
    </message>
    <message>
        <source>Trauma events</source>
        <translation>Verletzungsereignisse</translation>
    </message>
    <message>
        <source>Trauma time</source>
        <translation>Verletzungszeit</translation>
    </message>
    <message>
        <source>How long these events lasted in total.</source>
        <translation>Wie lange diese Ereignisse insgesamt dauerten.</translation>
    </message>
    <message>
        <source>Trauma impulse</source>
        <translation>Verletzungsimpuls</translation>
    </message>
    <message>
        <source>Sideways force times time while that force was over the limit of this level.</source>
        <translation>Seitenkraft mal Zeit, solange diese Kraft über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Largest sideways force</source>
        <translation>Größte Seitenkraft</translation>
    </message>
    <message>
        <source>The largest force with which the endoscope pressed sideways on the wall at any moment.</source>
        <translation>Die größte Kraft, mit der das Endoskop in irgendeinem Augenblick seitlich gegen die Wand drückte.</translation>
    </message>
    <message>
        <source>Advance while turning</source>
        <translation>Vorschub beim Drehen</translation>
    </message>
    <message>
        <source>How far the endoscope was pushed on in the bend while it was being turned: stop, turn, and only then go on.</source>
        <translation>Wie weit das Endoskop in der Biegung vorgeschoben wurde, während es gedreht wurde: anhalten, drehen und erst dann weiter vorschieben.</translation>
    </message>
    <message>
        <source>Largest torque</source>
        <translation>Größtes Drehmoment</translation>
    </message>
    <message>
        <source>The largest torque between endoscope and tissue at any moment.</source>
        <translation>Das größte Drehmoment zwischen Endoskop und Gewebe zu irgendeinem Zeitpunkt.</translation>
    </message>
    <message>
        <source>Torque, root mean square</source>
        <translation>Drehmoment, quadratisches Mittel</translation>
    </message>
    <message>
        <source>The root mean square of the torque between endoscope and tissue.</source>
        <translation>Das quadratische Mittel des Drehmoments zwischen Endoskop und Gewebe.</translation>
    </message>
    <message>
        <source>Reversals</source>
        <translation>Rückwärtsbewegungen</translation>
    </message>
    <message>
        <source>How often the tip went back by 1 mm or more on the way in.</source>
        <translation>Wie oft die Spitze auf dem Weg hinein um 1 mm oder mehr zurückging.</translation>
    </message>
    <message>
        <source>Landmarks seen</source>
        <translation>Gesehene Landmarken</translation>
    </message>
    <message>
        <source>The landmarks of the bladder that were inspected, in % of those that the level asks for.</source>
        <translation>Die inspizierten Landmarken der Blase, in % derer, die die Stufe verlangt.</translation>
    </message>
    <message>
        <source>Tip travel during inspection</source>
        <translation>Weg der Spitze bei der Inspektion</translation>
    </message>
    <message>
        <source>How far the tip travelled while the bladder was inspected: turning the endoscope shows as much and does less harm.</source>
        <translation>Wie weit sich die Spitze bewegte, während die Blase inspiziert wurde: Das Endoskop zu drehen zeigt ebenso viel und schadet weniger.</translation>
    </message>
    <message>
        <source>Insertion depth</source>
        <translation>Einführtiefe</translation>
    </message>
    <message>
        <source>How deep the tip went, counted up to the goal of this level.</source>
        <translation>Wie tief die Spitze kam, höchstens bis zum Ziel dieser Stufe gerechnet.</translation>
    </message>
    <message>
        <source>the recording has no insertion data</source>
        <translation>die Aufzeichnung enthält keine Daten zum Einführen</translation>
    </message>
    <message>
        <source>the recording has no torques</source>
        <translation>die Aufzeichnung enthält keine Drehmomente</translation>
    </message>
    <message>
        <source>the tip was never in the urethra</source>
        <translation>die Spitze war nie in der Harnröhre</translation>
    </message>
    <message>
        <source>the tip was never at the bend</source>
        <translation>die Spitze war nie an der Biegung</translation>
    </message>
    <message>
        <source>the level has no landmarks</source>
        <translation>die Stufe hat keine Landmarken</translation>
    </message>
    <message>
        <source>the inspection was not reached</source>
        <translation>die Inspektion wurde nicht erreicht</translation>
    </message>
    <message>
        <source>published, 5 subjects × 10</source>
        <translation>veröffentlicht, 5 Personen × 10</translation>
    </message>
    <message>
        <source>% of R</source>
        <translation>% des Radius</translation>
    </message>
    <message>
        <source>How many of the trials were completed in time, with everything that the level asks for, in %.</source>
        <translation>Wie viele der Durchgänge rechtzeitig abgeschlossen wurden, mit allem, was die Stufe verlangt, in %.</translation>
    </message>
    <message>
        <source>Tension error, root mean square</source>
        <translation>Spannungsfehler, quadratisches Mittel</translation>
    </message>
    <message>
        <source>How far the tension of the tube was from its target while it was held: large differences weigh more than in the mean.</source>
        <translation>Wie weit die Spannung des Schlauchs während des Haltens von ihrem Ziel abwich: Große Abweichungen zählen mehr als im Mittel.</translation>
    </message>
    <message>
        <source>Tension error, standard deviation</source>
        <translation>Spannungsfehler, Standardabweichung</translation>
    </message>
    <message>
        <source>How unsteady the tension of the tube was while it was held, whether on target or not.</source>
        <translation>Wie unruhig die Spannung des Schlauchs während des Haltens war, ob im Ziel oder daneben.</translation>
    </message>
    <message>
        <source>Time in the band</source>
        <translation>Zeit im Bereich</translation>
    </message>
    <message>
        <source>How long the tension, or the length at the mark, stayed in its band during the hold; the mean over all trials.</source>
        <translation>Wie lange die Spannung, oder die Länge an der Marke, während des Haltens im Zielbereich lag; Mittel über alle Durchgänge.</translation>
    </message>
    <message>
        <source>Critical errors</source>
        <translation>Kritische Fehler</translation>
    </message>
    <message>
        <source>How often the tissue gave way because it was pushed or turned too hard, or was pressed sideways too hard or for too long.</source>
        <translation>Wie oft das Gewebe nachgab, weil zu stark gedrückt oder verdreht wurde, oder zu stark oder zu lange zur Seite gedrückt wurde.</translation>
    </message>
    <message>
        <source>Over-stretches</source>
        <translation>Überdehnungen</translation>
    </message>
    <message>
        <source>How often the tube was stretched beyond the limit of this level.</source>
        <translation>Wie oft der Schlauch über die Grenze dieser Stufe hinaus gedehnt wurde.</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallengelassen</translation>
    </message>
    <message>
        <source>How often the tissue was let go of before the task was done.</source>
        <translation>Wie oft das Gewebe losgelassen wurde, bevor die Aufgabe erfüllt war.</translation>
    </message>
    <message>
        <source>Largest squeeze</source>
        <translation>Größte Quetschkraft</translation>
    </message>
    <message>
        <source>The largest force with which the jaws squeezed what they held.</source>
        <translation>Die größte Kraft, mit der die Branchen zusammendrückten, was sie hielten.</translation>
    </message>
    <message>
        <source>Time squeezing too hard</source>
        <translation>Zeit mit zu hoher Quetschkraft</translation>
    </message>
    <message>
        <source>How long the squeeze was over the limit of this level.</source>
        <translation>Wie lange die Quetschkraft über der Grenze dieser Stufe lag.</translation>
    </message>
    <message>
        <source>Placement error</source>
        <translation>Ablagefehler</translation>
    </message>
    <message>
        <source>How far from the middle of the target the object lay at the end of each trial; the mean over the trials.</source>
        <translation>Wie weit das Objekt am Ende jedes Durchgangs von der Zielmitte lag; Mittel über die Durchgänge.</translation>
    </message>
    <message>
        <source>Heaviest found</source>
        <translation>Schwerstes gefunden</translation>
    </message>
    <message>
        <source>How often the heaviest object was put into the target, in % of the trials.</source>
        <translation>Wie oft das schwerste Objekt ins Ziel gelegt wurde, in % der Durchgänge.</translation>
    </message>
    <message>
        <source>the recording has no procedure</source>
        <translation>die Aufzeichnung enthält keinen Eingriff</translation>
    </message>
    <message>
        <source>the recording has no squeeze</source>
        <translation>die Aufzeichnung enthält keine Quetschkraft</translation>
    </message>
    <message>
        <source>the recording has no squeeze limit</source>
        <translation>die Aufzeichnung enthält keine Grenze der Quetschkraft</translation>
    </message>
    <message>
        <source>the recording has neither objects nor a target</source>
        <translation>die Aufzeichnung enthält weder Objekte noch Ziel</translation>
    </message>
    <message>
        <source>the level asks for no weighing</source>
        <translation>die Stufe verlangt kein Wiegen</translation>
    </message>
    <message>
        <source>the recording has no tube data</source>
        <translation>die Aufzeichnung enthält keine Schlauchdaten</translation>
    </message>
    <message>
        <source>the task has no such target</source>
        <translation>die Aufgabe hat kein solches Ziel</translation>
    </message>
    <message>
        <source>the tension was never held</source>
        <translation>die Spannung wurde nie gehalten</translation>
    </message>
    <message>
        <source>Lumps found</source>
        <translation>Gefundene Knoten</translation>
    </message>
    <message>
        <source>Lumps with a finding close enough to count. A lump that was pressed harder than the limit does not count.</source>
        <translation>Knoten, in deren Nähe ein Fund gemeldet wurde. Ein Knoten, auf den stärker als bis zur Grenze gedrückt wurde, zählt nicht.</translation>
    </message>
    <message>
        <source>Lumps missed</source>
        <translation>Übersehene Knoten</translation>
    </message>
    <message>
        <source>Lumps with no finding close enough to count.</source>
        <translation>Knoten, in deren Nähe kein Fund gemeldet wurde.</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Fehlalarme</translation>
    </message>
    <message>
        <source>Findings where there was no lump; a second finding of the same lump counts too.</source>
        <translation>Funde an Stellen ohne Knoten; auch ein zweiter Fund desselben Knotens zählt.</translation>
    </message>
    <message>
        <source>Sensitivity (d′)</source>
        <translation>Trennschärfe (d′)</translation>
    </message>
    <message>
        <source>How well places with a lump were told apart from places without, whatever the tendency to say yes or no. 0 is chance.</source>
        <translation>Wie gut Stellen mit und ohne Knoten unterschieden wurden, unabhängig von der Neigung zu Ja oder Nein. 0 ist Zufall.</translation>
    </message>
    <message>
        <source>Criterion (c)</source>
        <translation>Kriterium (c)</translation>
    </message>
    <message>
        <source>The tendency when in doubt: to report a lump (negative) or not to report one (positive).</source>
        <translation>Ob im Zweifel eher ein Knoten gemeldet wird (negativ) oder eher nicht (positiv).</translation>
    </message>
    <message>
        <source>Area under the ROC curve</source>
        <translation>Fläche unter der ROC-Kurve</translation>
    </message>
    <message>
        <source>How well confidence tells places with a lump from places without: 0.5 is chance, 1 is perfect.</source>
        <translation>Wie gut die Sicherheit Stellen mit und ohne Knoten unterscheidet: 0,5 ist Zufall, 1 ist perfekt.</translation>
    </message>
    <message>
        <source>Localisation error</source>
        <translation>Lagefehler</translation>
    </message>
    <message>
        <source>How far, on the surface, each finding was from the lump that it found; the mean over all lumps found.</source>
        <translation>Wie weit jeder Fund auf der Oberfläche von seinem Knoten entfernt lag; Mittel über alle gefundenen Knoten.</translation>
    </message>
    <message>
        <source>Size error</source>
        <translation>Größenfehler</translation>
    </message>
    <message>
        <source>How far the stated radius was from the true one; the mean over all lumps found with a stated size.</source>
        <translation>Wie weit der angegebene Radius vom wahren abwich; Mittel über alle gefundenen Knoten mit angegebener Größe.</translation>
    </message>
    <message>
        <source>Sensitivity, lower bound</source>
        <translation>Trennschärfe, Untergrenze</translation>
    </message>
    <message>
        <source>Sensitivity, upper bound</source>
        <translation>Trennschärfe, Obergrenze</translation>
    </message>
    <message>
        <source>The upper end of the 95 % interval of the sensitivity.</source>
        <translation>Das obere Ende des 95-%-Intervalls der Trennschärfe.</translation>
    </message>
    <message>
        <source>Prediction error at 30 Hz</source>
        <translation>Vorhersagefehler bei 30 Hz</translation>
    </message>
    <message>
        <source>How far the predicted soft surface under the tool was from the result of the slow model; this rates the simulation, not you.</source>
        <translation>Wie weit die vorhergesagte weiche Oberfläche unter dem Instrument vom Ergebnis des langsamen Modells abwich; das bewertet die Simulation, nicht Sie.</translation>
    </message>
    <message>
        <source>Error without prediction</source>
        <translation>Fehler ohne Vorhersage</translation>
    </message>
    <message>
        <source>The same error if the last update had been kept instead: the difference shows what the prediction is worth.</source>
        <translation>Derselbe Fehler, wenn stattdessen der letzte Stand gehalten worden wäre: Der Unterschied zeigt, was die Vorhersage bringt.</translation>
    </message>
    <message>
        <source>no trial was finished</source>
        <translation>kein Durchgang wurde beendet</translation>
    </message>
    <message>
        <source>the trial was not finished</source>
        <translation>der Durchgang wurde nicht beendet</translation>
    </message>
    <message>
        <source>there is no chance level for a single trial</source>
        <translation>für einen einzelnen Durchgang gibt es kein Zufallsniveau</translation>
    </message>
    <message>
        <source>no two lumps of different hardness were found and rated</source>
        <translation>es wurden keine zwei verschieden harten Knoten gefunden und bewertet</translation>
    </message>
    <message>
        <source>fewer than two lumps were found and given a hardness</source>
        <translation>zu weniger als zwei gefundenen Knoten wurde die Härte angegeben</translation>
    </message>
    <message>
        <source>there were fewer than two lumps</source>
        <translation>es gab weniger als zwei Knoten</translation>
    </message>
    <message>
        <source>nothing was touched, so nothing was predicted</source>
        <translation>es wurde nichts berührt, also auch nichts vorhergesagt</translation>
    </message>
    <message>
        <source>the recording has no prediction</source>
        <translation>die Aufzeichnung enthält keine Vorhersage</translation>
    </message>
    <message>
        <source>Heaviest found by chance</source>
        <translation>Schwerstes durch Raten gefunden</translation>
    </message>
    <message>
        <source>Localisation error by chance</source>
        <translation>Lagefehler durch Raten</translation>
    </message>
    <message>
        <source>How far findings would be from a lump if they hit it at random. A localisation error that is not smaller shows no skill.</source>
        <translation>Wie weit Funde von einem Knoten entfernt wären, wenn sie ihn zufällig träfen. Ein Lagefehler, der nicht kleiner ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Hardness order by chance</source>
        <translation>Reihenfolge der Härte durch Raten</translation>
    </message>
    <message>
        <source>The hardness order of somebody who assigns the same hardness ratings to the lumps at random. A share that is not larger shows no skill.</source>
        <translation>Die Reihenfolge der Härte von jemandem, der dieselben Härteangaben zufällig auf die Knoten verteilt. Ein Anteil, der nicht größer ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>Apex error by chance</source>
        <translation>Scheitelfehler durch Raten</translation>
    </message>
    <message>
        <source>Size error by chance</source>
        <translation>Größenfehler durch Raten</translation>
    </message>
    <message>
        <source>Hardness order</source>
        <translation>Reihenfolge der Härte</translation>
    </message>
    <message>
        <source>How often the harder of two lumps found in a trial was also rated harder, in % of all such pairs. Guessing gives 50 % or less.</source>
        <translation>Bei wie vielen Paaren gefundener Knoten eines Durchgangs der härtere auch härter genannt wurde, in %. Durch Raten sind es höchstens 50 %.</translation>
    </message>
    <message>
        <source>Area covered</source>
        <translation>Abgetastete Fläche</translation>
    </message>
    <message>
        <source>How much of the search area was pressed hard enough to find something; the mean over the trials.</source>
        <translation>Anteil des Suchfelds, der fest genug gedrückt wurde, um etwas zu finden; Mittel über die Durchgänge.</translation>
    </message>
    <message>
        <source>Time in the force band</source>
        <translation>Zeit im Kraftbereich</translation>
    </message>
    <message>
        <source>During how much of the pressing time the force was neither too low nor too high.</source>
        <translation>In welchem Teil der Druckzeit die Kraft weder zu gering noch zu groß war.</translation>
    </message>
    <message>
        <source>Time pressing</source>
        <translation>Druckzeit</translation>
    </message>
    <message>
        <source>How long a finger pressed the tissue, in all trials together.</source>
        <translation>Wie lange ein Finger auf das Gewebe drückte, in allen Durchgängen zusammen.</translation>
    </message>
    <message>
        <source>Time searching</source>
        <translation>Suchzeit</translation>
    </message>
    <message>
        <source>How long the trials took until the search was reported as done; pauses do not count.</source>
        <translation>Wie lange die Durchgänge bis zur Fertigmeldung dauerten; Pausen zählen nicht.</translation>
    </message>
    <message>
        <source>the recording has neither lumps nor a search area</source>
        <translation>die Aufzeichnung enthält weder Knoten noch Suchfeld</translation>
    </message>
    <message>
        <source>the recording has no reports</source>
        <translation>die Aufzeichnung enthält keine Meldungen</translation>
    </message>
    <message>
        <source>reports are missing from the recording</source>
        <translation>in der Aufzeichnung fehlen Meldungen</translation>
    </message>
    <message>
        <source>there was no lump</source>
        <translation>es gab keinen Knoten</translation>
    </message>
    <message>
        <source>no lump was found</source>
        <translation>es wurde kein Knoten gefunden</translation>
    </message>
    <message>
        <source>no finding has a confidence rating</source>
        <translation>zu keinem Fund wurde die Sicherheit angegeben</translation>
    </message>
    <message>
        <source>the level asks for no size</source>
        <translation>die Stufe fragt nicht nach der Größe</translation>
    </message>
    <message>
        <source>the level asks for no hardness</source>
        <translation>die Stufe fragt nicht nach der Härte</translation>
    </message>
    <message>
        <source>in no trial were two lumps found and given a hardness</source>
        <translation>in keinem Durchgang wurde zu zwei gefundenen Knoten die Härte angegeben</translation>
    </message>
    <message>
        <source>the lumps that were found are equally hard</source>
        <translation>die gefundenen Knoten sind gleich hart</translation>
    </message>
    <message>
        <source>the recording has no coverage data</source>
        <translation>die Aufzeichnung enthält keine abgetastete Fläche</translation>
    </message>
    <message>
        <source>the recording has no force band</source>
        <translation>die Aufzeichnung enthält keinen Kraftbereich</translation>
    </message>
    <message>
        <source>nothing was pressed</source>
        <translation>es wurde nichts gedrückt</translation>
    </message>
    <message>
        <source>only %1 regions with a lump and %2 without: %3 of each are needed</source>
        <translation>nur %1 Felder mit Knoten und %2 ohne: je %3 sind nötig</translation>
    </message>
    <message>
        <source>Retraction in the band</source>
        <translation>Zug der Falte im Zielbereich</translation>
    </message>
    <message>
        <source>How much of the time the pull on the fold of tissue was in its band, once the fold was held back, in %; the mean over all trials.</source>
        <translation>Anteil der Zeit, in der der Zug an der Gewebefalte im Zielbereich lag, sobald sie zurückgehalten wurde, in %; Mittel über alle Durchgänge.</translation>
    </message>
    <message>
        <source>Largest retraction</source>
        <translation>Größter Zug an der Falte</translation>
    </message>
    <message>
        <source>The largest pull on the fold of tissue at any moment.</source>
        <translation>Der größte Zug an der Gewebefalte zu irgendeinem Zeitpunkt.</translation>
    </message>
    <message>
        <source>no position to score</source>
        <translation>keine Position, die gewertet werden könnte</translation>
    </message>
    <message>
        <source>the true position of the apex is not known</source>
        <translation>die wahre Lage des Scheitels ist nicht bekannt</translation>
    </message>
    <message>
        <source>Apex error</source>
        <translation>Scheitelfehler</translation>
    </message>
    <message>
        <source>How far the mark lay from the highest point, in % of the radius, averaged over left–right and front–back.</source>
        <translation>Wie weit die Markierung vom höchsten Punkt entfernt war, in % des Radius, gemittelt über die Richtungen links–rechts und vorn–hinten.</translation>
    </message>
    <message>
        <source>Largest misalignment</source>
        <translation>Größte Fehlausrichtung</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the direction of the urethra where its tip was; large angles weigh more. In the picture: when the two are in line, the wall near the tip is equally wide all round, and a guide ring, where there is one, is drawn double. In a bend the urethra then continues beside the middle of the picture.</source>
        <translation>Der Winkel zwischen Endoskop und Richtung der Harnröhre am Ort der Spitze; große Winkel zählen mehr. Im Bild: Liegen beide in einer Linie, ist die Wand nahe der Spitze rundum gleich breit, und ein Führungsring, falls vorhanden, erscheint doppelt. In einer Biegung führt die Harnröhre dann neben der Bildmitte weiter.</translation>
    </message>
    <message>
        <source>How often somebody who perceives nothing would choose the heaviest object. A share that is not larger shows no skill.</source>
        <translation>Wie oft jemand, der nichts wahrnimmt, das schwerste Objekt wählen würde. Ein Anteil, der nicht größer ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>The lower end of the 95 % interval of the sensitivity. Below 0 the session does not show that any lump was perceived.</source>
        <translation>Das untere Ende des 95-%-Intervalls der Trennschärfe. Unter 0 zeigt die Sitzung nicht, dass ein Knoten wahrgenommen wurde.</translation>
    </message>
    <message>
        <source>The size error of somebody who perceives nothing and always states the middle size. A size error that is not smaller shows no skill.</source>
        <translation>Der Größenfehler von jemandem, der nichts wahrnimmt und immer die mittlere Größe angibt. Ein Größenfehler, der nicht kleiner ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>The apex error of somebody who perceives nothing and always marks the same, best possible place. An error that is not smaller shows no skill.</source>
        <translation>Der Scheitelfehler von jemandem, der nichts wahrnimmt und immer dieselbe, bestmögliche Stelle markiert. Ein Fehler, der nicht kleiner ist, zeigt kein Können.</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the urethra at its tip, on the way in, within 10 mm of the bend, where the endoscope has to be turned. When the two are in line, the wall near the tip is equally wide all round.</source>
        <translation>Der Winkel zwischen Endoskop und Harnröhre am Ort der Spitze, beim Einführen, bis 10 mm vor und nach der Biegung, wo das Endoskop gedreht werden muss. Liegen beide in einer Linie, ist die Wand nahe der Spitze rundum gleich breit.</translation>
    </message>
    <message>
        <source>The angle between the endoscope and the urethra at its tip, on the way in, from the bend to 30 mm past it, where the urethra is curved most. When the two are in line, the wall near the tip is equally wide all round.</source>
        <translation>Der Winkel zwischen Endoskop und Harnröhre am Ort der Spitze, beim Einführen, von der Biegung bis 30 mm dahinter, wo die Harnröhre am stärksten gebogen ist. Liegen beide in einer Linie, ist die Wand nahe der Spitze rundum gleich breit.</translation>
    </message>
    <message>
        <source>none of the lumps found was given a size</source>
        <translation>zu keinem gefundenen Knoten wurde die Größe angegeben</translation>
    </message>
    <message>
        <source>How often the endoscope pressed sideways on the wall over the limit of this level for 20 ms or longer. Each time is a trauma event: it may injure the wall.</source>
        <translation>Wie oft das Endoskop 20 ms oder länger seitlich stärker gegen die Wand drückte, als die Grenze dieser Stufe erlaubt. Jedes Mal ist ein Verletzungsereignis: Es kann die Wand verletzen.</translation>
    </message>
    <message>
        <source>All landmarks are seen</source>
        <translation>Alle Landmarken sind gesehen</translation>
    </message>
    <message>
        <source>The procedure is completed</source>
        <translation>Der Eingriff ist abgeschlossen</translation>
    </message>
</context>
<context>
    <name>MomentWords</name>
    <message>
        <source>%1 before the start</source>
        <translation>%1 vor dem Beginn</translation>
    </message>
    <message>
        <source>Trial %1, %2</source>
        <translation>Durchgang %1, %2</translation>
    </message>
</context>
<context>
    <name>PaletteSearch</name>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Session %1: %2, level %3, %4, %5</source>
        <translation>Sitzung %1: %2, Stufe %3, %4, %5</translation>
    </message>
</context>
<context>
    <name>PalpationFindings</name>
    <message>
        <source>stated size %1, true size %2</source>
        <translation>angegebene Größe %1, wahre Größe %2</translation>
    </message>
    <message>
        <source>stated hardness %1, true hardness %2</source>
        <translation>angegebene Härte %1, wahre Härte %2</translation>
    </message>
    <message>
        <source>confidence: %1</source>
        <translation>Sicherheit: %1</translation>
    </message>
    <message>
        <source>Lump %1 (%2, %3 mm deep): missed</source>
        <translation>Knoten %1 (%2, %3 mm tief): übersehen</translation>
    </message>
    <message>
        <source>Lump %1: found, finding %2, %3 mm from its centre</source>
        <translation>Knoten %1: gefunden, Fund %2, %3 mm von der Mitte entfernt</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>There was no lump, and none was reported.</source>
        <translation>Es gab keinen Knoten, und keiner wurde gemeldet.</translation>
    </message>
    <message>
        <source>There was no lump.</source>
        <translation>Es gab keinen Knoten.</translation>
    </message>
    <message>
        <source>Lumps found: %1 of %2.</source>
        <translation>Gefundene Knoten: %1 von %2.</translation>
    </message>
    <message>
        <source>Findings where there was no lump: %1.</source>
        <translation>Funde an Stellen ohne Knoten: %1.</translation>
    </message>
    <message>
        <source>Searched: %1 %.</source>
        <translation>Abgetastet: %1 %.</translation>
    </message>
    <message>
        <source>Time was up before the search was reported as done.</source>
        <translation>Die Zeit war um, bevor die Suche als beendet gemeldet wurde.</translation>
    </message>
    <message>
        <source>Finding %1: no lump there; the nearest was %2 mm away</source>
        <translation>Fund %1: dort war kein Knoten; der nächste lag %2 mm entfernt</translation>
    </message>
    <message>
        <source>Finding %1: no lump there</source>
        <translation>Fund %1: dort war kein Knoten</translation>
    </message>
</context>
<context>
    <name>PalpationWords</name>
    <message>
        <source>size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>soft</source>
        <translation>weich</translation>
    </message>
    <message>
        <source>rather soft</source>
        <translation>eher weich</translation>
    </message>
    <message>
        <source>medium</source>
        <translation>mittel</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>fest</translation>
    </message>
    <message>
        <source>stony hard</source>
        <translation>steinhart</translation>
    </message>
    <message>
        <source>not given</source>
        <translation>nicht angegeben</translation>
    </message>
    <message>
        <source>a guess</source>
        <translation>geraten</translation>
    </message>
    <message>
        <source>unsure</source>
        <translation>unsicher</translation>
    </message>
    <message>
        <source>fairly sure</source>
        <translation>ziemlich sicher</translation>
    </message>
    <message>
        <source>sure</source>
        <translation>sicher</translation>
    </message>
    <message>
        <source>certain</source>
        <translation>ganz sicher</translation>
    </message>
    <message>
        <source>%1 mm across</source>
        <translation>%1 mm Durchmesser</translation>
    </message>
    <message>
        <source>size not given</source>
        <translation>Größe nicht angegeben</translation>
    </message>
    <message>
        <source>hardness not given</source>
        <translation>Härte nicht angegeben</translation>
    </message>
    <message>
        <source>confidence not given</source>
        <translation>Sicherheit nicht angegeben</translation>
    </message>
    <message>
        <source>Finding %1</source>
        <translation>Fund %1</translation>
    </message>
    <message>
        <source>Finding %1: %2</source>
        <translation>Fund %1: %2</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Middle finger</source>
        <translation>Mittelfinger</translation>
    </message>
    <message>
        <source>Index finger</source>
        <translation>Zeigefinger</translation>
    </message>
    <message>
        <source>Right middle finger</source>
        <translation>Rechter Mittelfinger</translation>
    </message>
    <message>
        <source>Right index finger</source>
        <translation>Rechter Zeigefinger</translation>
    </message>
    <message>
        <source>Left middle finger</source>
        <translation>Linker Mittelfinger</translation>
    </message>
    <message>
        <source>Left index finger</source>
        <translation>Linker Zeigefinger</translation>
    </message>
</context>
<context>
    <name>ParticipantFacts</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2, differences of %3 to %4</source>
        <translation>%1: %2, Unterschiede von %3 bis %4</translation>
    </message>
    <message>
        <source>Mark the highest point.</source>
        <translation>Markieren Sie den höchsten Punkt.</translation>
    </message>
    <message>
        <source>as many as the answers need</source>
        <translation>so viele, wie die Antworten erfordern</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message numerus="yes">
        <source>%1, and %n for practice</source>
        <translation>
            <numerusform>%1 und %n zur Übung</numerusform>
            <numerusform>%1 und %n zur Übung</numerusform>
        </translation>
    </message>
    <message>
        <source>as long as the answers take</source>
        <translation>so lange, wie die Antworten dauern</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>after every %1 trials, at least %2 s</source>
        <translation>nach je %1 Durchgängen, mindestens %2 s</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>%1 s per trial</source>
        <translation>%1 s je Durchgang</translation>
    </message>
    <message>
        <source>%1 s to explore, then %2 s to answer</source>
        <translation>%1 s zum Erkunden, dann %2 s zum Antworten</translation>
    </message>
    <message>
        <source>%1 s to explore, no limit to answer</source>
        <translation>%1 s zum Erkunden, unbegrenzt zum Antworten</translation>
    </message>
    <message>
        <source>after each trial</source>
        <translation>nach jedem Durchgang</translation>
    </message>
    <message>
        <source>in practice only</source>
        <translation>nur in der Übung</translation>
    </message>
    <message>
        <source>%1 before, %2 after</source>
        <translation>%1 vorher, %2 nachher</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Asked</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>Breaks</source>
        <translation>Pausen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Rückmeldung</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>%1 before, %2 after each condition, %3 after</source>
        <translation>%1 vorher, %2 nach jeder Bedingung, %3 nachher</translation>
    </message>
    <message>
        <source>%1 in each condition, %2 in all</source>
        <translation>%1 in jeder Bedingung, %2 insgesamt</translation>
    </message>
    <message>
        <source>%1 in all (by condition: %2)</source>
        <translation>%1 insgesamt (je Bedingung: %2)</translation>
    </message>
    <message>
        <source>instructions, controls, a free minute, practice (%1), then the trials that count</source>
        <translation>Anleitung, Bedienung, eine freie Minute, Übung (%1), dann die Durchgänge, die zählen</translation>
    </message>
    <message>
        <source>instructions, controls, a free minute, then the trials that count</source>
        <translation>Anleitung, Bedienung, eine freie Minute, dann die Durchgänge, die zählen</translation>
    </message>
    <message>
        <source>Sequence in each condition</source>
        <translation>Ablauf in jeder Bedingung</translation>
    </message>
    <message>
        <source>about %1 min for all trials, if each takes %2 s</source>
        <translation>etwa %1 min für alle Durchgänge, wenn jeder %2 s dauert</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
</context>
<context>
    <name>ParticipantProgress</name>
    <message>
        <source>interrupted, %1</source>
        <translation>unterbrochen, %1</translation>
    </message>
    <message>
        <source>interrupted at trial %1 of at most %2</source>
        <translation>unterbrochen bei Durchgang %1 von höchstens %2</translation>
    </message>
    <message>
        <source>interrupted at trial %1</source>
        <translation>unterbrochen bei Durchgang %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>interrupted</source>
        <translation>unterbrochen</translation>
    </message>
    <message>
        <source>broken off when the participant withdrew</source>
        <translation>abgebrochen, als die Person ihre Teilnahme zurückzog</translation>
    </message>
    <message>
        <source>not begun, and the study is closed</source>
        <translation>nicht begonnen, und die Studie ist geschlossen</translation>
    </message>
    <message>
        <source>not begun yet</source>
        <translation>noch nicht begonnen</translation>
    </message>
    <message>
        <source>This participant is simulated: its runs are made on the command line.</source>
        <translation>Diese Person ist simuliert: Ihre Läufe entstehen auf der Befehlszeile.</translation>
    </message>
    <message>
        <source>Bring the study back from the archive before this participant goes on.</source>
        <translation>Holen Sie die Studie aus dem Archiv zurück, bevor diese Person weitermacht.</translation>
    </message>
    <message>
        <source>Record the consent. Then the first condition can begin.</source>
        <translation>Halten Sie die Einwilligung fest. Dann kann die erste Bedingung beginnen.</translation>
    </message>
    <message>
        <source>Press Run and resume “%1” at the trial where it stopped. If this participant does not come back, withdraw them: what they did is kept.</source>
        <translation>Drücken Sie „Durchführen“ und setzen Sie „%1“ bei dem Durchgang fort, bei dem unterbrochen wurde. Kommt diese Person nicht wieder, ziehen Sie ihre Teilnahme zurück: Was sie getan hat, bleibt erhalten.</translation>
    </message>
    <message>
        <source>“%1” can no longer be started, because the study is closed. The conditions that are done count.</source>
        <translation>„%1“ kann nicht mehr beginnen, weil die Studie geschlossen ist. Die erledigten Bedingungen zählen.</translation>
    </message>
    <message>
        <source>Press Run and begin “%1”.</source>
        <translation>Drücken Sie „Durchführen“ und beginnen Sie „%1“.</translation>
    </message>
    <message>
        <source>Every condition is done. The questionnaire “%1” is not answered yet.</source>
        <translation>Alle Bedingungen sind erledigt. Der Fragebogen „%1“ ist noch nicht beantwortet.</translation>
    </message>
    <message>
        <source>Nothing is left to do: this participant has done everything.</source>
        <translation>Es ist nichts mehr zu tun: Diese Person hat alles erledigt.</translation>
    </message>
    <message>
        <source>Nothing is left to do: this participant has withdrawn. If somebody else is to take their place, enrol that person.</source>
        <translation>Es ist nichts mehr zu tun: Diese Person nimmt nicht mehr teil. Soll jemand anderes ihren Platz einnehmen, nehmen Sie jemanden auf.</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>%1, one interrupted</source>
        <translation>%1, eine unterbrochen</translation>
    </message>
    <message>
        <source>%1, one broken off</source>
        <translation>%1, eine abgebrochen</translation>
    </message>
    <message>
        <source>not begun before the participant withdrew</source>
        <translation>nicht begonnen, bevor die Person ihre Teilnahme zurückzog</translation>
    </message>
    <message>
        <source>%1, with questions to answer</source>
        <translation>%1, Fragen noch zu beantworten</translation>
    </message>
    <message>
        <source>The questionnaire “%1” is not answered yet.</source>
        <translation>Der Fragebogen „%1“ ist noch nicht beantwortet.</translation>
    </message>
</context>
<context>
    <name>ParticipantSentences</name>
    <message>
        <source>In each trial you explore three objects and put them in order.</source>
        <translation>In jedem Durchgang erkunden Sie drei Objekte und bringen sie in eine Reihenfolge.</translation>
    </message>
    <message>
        <source>In each trial you explore two objects and choose one of two answers.</source>
        <translation>In jedem Durchgang erkunden Sie zwei Objekte und wählen eine von zwei Antworten.</translation>
    </message>
    <message>
        <source>In each trial you explore three objects and choose one of three answers.</source>
        <translation>In jedem Durchgang erkunden Sie drei Objekte und wählen eine von drei Antworten.</translation>
    </message>
    <message>
        <source>In each trial you explore one object and give it a number.</source>
        <translation>In jedem Durchgang erkunden Sie ein Objekt und geben ihm eine Zahl.</translation>
    </message>
    <message numerus="yes">
        <source>The study has %n part(s).</source>
        <translation>
            <numerusform>Die Studie hat %n Teil.</numerusform>
            <numerusform>Die Studie hat %n Teile.</numerusform>
        </translation>
    </message>
    <message>
        <source>What you do differs from part to part:</source>
        <translation>Was Sie tun, ist von Teil zu Teil verschieden:</translation>
    </message>
    <message>
        <source>Touch every object before you answer.</source>
        <translation>Berühren Sie jedes Objekt, bevor Sie antworten.</translation>
    </message>
    <message>
        <source>How many trials there are depends on your answers.</source>
        <translation>Wie viele Durchgänge es gibt, hängt von Ihren Antworten ab.</translation>
    </message>
    <message numerus="yes">
        <source>Each part has %n trial(s).</source>
        <translation>
            <numerusform>Jeder Teil hat %n Durchgang.</numerusform>
            <numerusform>Jeder Teil hat %n Durchgänge.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part has at most %n trial(s).</source>
        <translation>
            <numerusform>Jeder Teil hat höchstens %n Durchgang.</numerusform>
            <numerusform>Jeder Teil hat höchstens %n Durchgänge.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are %n trial(s).</source>
        <translation>
            <numerusform>Es gibt %n Durchgang.</numerusform>
            <numerusform>Es gibt %n Durchgänge.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>There are at most %n trial(s).</source>
        <translation>
            <numerusform>Es gibt höchstens %n Durchgang.</numerusform>
            <numerusform>Es gibt höchstens %n Durchgänge.</numerusform>
        </translation>
    </message>
    <message>
        <source>You may take as long as you like over each trial.</source>
        <translation>Für jeden Durchgang haben Sie so viel Zeit, wie Sie möchten.</translation>
    </message>
    <message>
        <source>You have %1 seconds for each trial.</source>
        <translation>Für jeden Durchgang haben Sie %1 Sekunden.</translation>
    </message>
    <message>
        <source>You have %1 seconds to explore in each trial.</source>
        <translation>In jedem Durchgang haben Sie %1 Sekunden zum Erkunden.</translation>
    </message>
    <message>
        <source>Then the objects go away, and you have another %1 seconds to answer.</source>
        <translation>Dann verschwinden die Objekte, und Sie haben weitere %1 Sekunden zum Antworten.</translation>
    </message>
    <message>
        <source>Then the objects go away, and you may take as long as you like to answer.</source>
        <translation>Dann verschwinden die Objekte, und Sie haben zum Antworten so viel Zeit, wie Sie möchten.</translation>
    </message>
    <message>
        <source>After each trial you are told whether your answer was right.</source>
        <translation>Nach jedem Durchgang erfahren Sie, ob Ihre Antwort richtig war.</translation>
    </message>
    <message>
        <source>You are not told whether your answers are right.</source>
        <translation>Sie erfahren nicht, ob Ihre Antworten richtig sind.</translation>
    </message>
    <message>
        <source>After each trial you are told how far your mark is from the highest point.</source>
        <translation>Nach jedem Durchgang erfahren Sie, wie weit Ihre Markierung vom höchsten Punkt entfernt ist.</translation>
    </message>
    <message>
        <source>You are not told how far your marks are from the highest point.</source>
        <translation>Sie erfahren nicht, wie weit Ihre Markierungen vom höchsten Punkt entfernt sind.</translation>
    </message>
    <message>
        <source>No breaks are planned; you may pause whenever you want.</source>
        <translation>Pausen sind nicht geplant; Sie dürfen jederzeit unterbrechen.</translation>
    </message>
    <message numerus="yes">
        <source>After every %n trial(s) there is a break</source>
        <translation>
            <numerusform>Nach je %n Durchgang gibt es eine Pause</numerusform>
            <numerusform>Nach je %n Durchgängen gibt es eine Pause</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of at least %2 seconds; you may also pause whenever you want.</source>
        <translation>%1 von mindestens %2 Sekunden; Sie dürfen auch sonst jederzeit unterbrechen.</translation>
    </message>
    <message>
        <source>%1; you may also pause whenever you want.</source>
        <translation>%1; Sie dürfen auch sonst jederzeit unterbrechen.</translation>
    </message>
    <message numerus="yes">
        <source>Before the trials you answer %n question(s).</source>
        <translation>
            <numerusform>Vor den Durchgängen beantworten Sie %n Frage.</numerusform>
            <numerusform>Vor den Durchgängen beantworten Sie %n Fragen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After the trials you answer %n question(s).</source>
        <translation>
            <numerusform>Nach den Durchgängen beantworten Sie %n Frage.</numerusform>
            <numerusform>Nach den Durchgängen beantworten Sie %n Fragen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Each part begins with %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Jeder Teil beginnt mit %n Übungsdurchgang, der nicht zählt.</numerusform>
            <numerusform>Jeder Teil beginnt mit %n Übungsdurchgängen, die nicht zählen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After each part you answer %n question(s) about it.</source>
        <translation>
            <numerusform>Nach jedem Teil beantworten Sie %n Frage dazu.</numerusform>
            <numerusform>Nach jedem Teil beantworten Sie %n Fragen dazu.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>After the trials you answer %n question(s) about them.</source>
        <translation>
            <numerusform>Nach den Durchgängen beantworten Sie %n Frage dazu.</numerusform>
            <numerusform>Nach den Durchgängen beantworten Sie %n Fragen dazu.</numerusform>
        </translation>
    </message>
    <message>
        <source>Touch every object before you answer; a graze is not enough, and the screen says when more force is needed.</source>
        <translation>Berühren Sie jedes Objekt, bevor Sie antworten; eine flüchtige Berührung genügt nicht, und der Bildschirm zeigt an, wenn mehr Kraft nötig ist.</translation>
    </message>
    <message>
        <source>In each trial you search for the highest point of an object with the tip and mark it.</source>
        <translation>In jedem Durchgang suchen Sie mit der Spitze den höchsten Punkt eines Objekts und markieren ihn.</translation>
    </message>
    <message>
        <source>In each trial you explore three objects and put them in order; you may mark those that seem the same as equal.</source>
        <translation>In jedem Durchgang erkunden Sie drei Objekte und bringen sie in eine Reihenfolge; was Ihnen gleich vorkommt, dürfen Sie als gleich angeben.</translation>
    </message>
    <message>
        <source>In each trial you change one object until it seems like the other, and confirm.</source>
        <translation>In jedem Durchgang verändern Sie ein Objekt, bis es Ihnen wie das andere vorkommt, und bestätigen.</translation>
    </message>
    <message>
        <source>In each trial you explore one object and compare it with the reference, which the experimenter shows you before the trials; you answer yes or no.</source>
        <translation>In jedem Durchgang erkunden Sie ein Objekt und vergleichen es mit der Referenz, die Ihnen die Versuchsleitung vor den Durchgängen zeigt; Sie antworten mit Ja oder Nein.</translation>
    </message>
    <message>
        <source>Where you search for the highest point, the trial ends after these %1 seconds.</source>
        <translation>Wo Sie den höchsten Punkt suchen, endet der Durchgang nach diesen %1 Sekunden.</translation>
    </message>
    <message>
        <source>Only in practice are you told whether your answer was right.</source>
        <translation>Nur in der Übung erfahren Sie, ob Ihre Antwort richtig war.</translation>
    </message>
    <message>
        <source>Only in practice are you told how far your mark is from the highest point.</source>
        <translation>Nur in der Übung erfahren Sie, wie weit Ihre Markierung vom höchsten Punkt entfernt ist.</translation>
    </message>
    <message numerus="yes">
        <source>First come %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Am Anfang steht %n Übungsdurchgang, der nicht zählt.</numerusform>
            <numerusform>Am Anfang stehen %n Übungsdurchgänge, die nicht zählen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Pull gently and move calmly: a trial in which you pull with more than %1, or move faster than %2 per second on average, is repeated.</source>
        <translation>Ziehen Sie sanft und bewegen Sie sich ruhig: Ein Durchgang, in dem Sie mit mehr als %1 ziehen oder sich im Mittel schneller als %2 pro Sekunde bewegen, wird wiederholt.</translation>
    </message>
    <message>
        <source>Press gently and move calmly: a trial in which you press with more than %1, or move faster than %2 per second on average, is repeated.</source>
        <translation>Drücken Sie sanft und bewegen Sie sich ruhig: Ein Durchgang, in dem Sie mit mehr als %1 drücken oder sich im Mittel schneller als %2 pro Sekunde bewegen, wird wiederholt.</translation>
    </message>
    <message>
        <source>Before that you have a free minute to try the controls, which does not count either.</source>
        <translation>Davor haben Sie eine freie Minute, um die Bedienung auszuprobieren; auch sie zählt nicht.</translation>
    </message>
    <message>
        <source>Before the trials you have a free minute to try the controls, which does not count.</source>
        <translation>Vor den Durchgängen haben Sie eine freie Minute, um die Bedienung auszuprobieren; sie zählt nicht.</translation>
    </message>
    <message>
        <source>Move calmly and put objects down gently: a trial in which you press one onto the table with more than %1, or move faster than %2 per second on average, is repeated.</source>
        <translation>Bewegen Sie sich ruhig und setzen Sie Objekte sanft ab: Ein Durchgang, in dem Sie eines mit mehr als %1 auf den Tisch drücken oder sich im Mittel schneller als %2 pro Sekunde bewegen, wird wiederholt.</translation>
    </message>
    <message>
        <source>The device pushes back against your hand. You can let go at any time, and the Esc key switches its force off at once.</source>
        <translation>Das Gerät drückt gegen Ihre Hand. Sie können jederzeit loslassen, und die Esc-Taste schaltet seine Kraft sofort ab.</translation>
    </message>
    <message>
        <source>The device of this station renders no force: you see how objects respond, and nothing pushes against your hand.</source>
        <translation>Das Gerät an diesem Arbeitsplatz gibt keine Kraft wieder: Sie sehen, wie Objekte nachgeben, und nichts drückt gegen Ihre Hand.</translation>
    </message>
    <message>
        <source>Lift every object before you answer.</source>
        <translation>Heben Sie jedes Objekt an, bevor Sie antworten.</translation>
    </message>
    <message>
        <source>Pull every object before you answer; the screen says when more force is needed.</source>
        <translation>Ziehen Sie an jedem Objekt, bevor Sie antworten; der Bildschirm zeigt an, wenn mehr Kraft nötig ist.</translation>
    </message>
    <message>
        <source>Pull every object before you answer.</source>
        <translation>Ziehen Sie an jedem Objekt, bevor Sie antworten.</translation>
    </message>
    <message>
        <source>Explore every object before you answer; the screen says when more force is needed.</source>
        <translation>Erkunden Sie jedes Objekt, bevor Sie antworten; der Bildschirm zeigt an, wenn mehr Kraft nötig ist.</translation>
    </message>
    <message>
        <source>Explore every object before you answer.</source>
        <translation>Erkunden Sie jedes Objekt, bevor Sie antworten.</translation>
    </message>
    <message>
        <source>The device pushes back against your hand, with at most %1. You can let go at any time, and the Esc key switches its force off at once.</source>
        <translation>Das Gerät drückt gegen Ihre Hand, mit höchstens %1. Sie können jederzeit loslassen, und die Esc-Taste schaltet seine Kraft sofort ab.</translation>
    </message>
</context>
<context>
    <name>PeopleNames</name>
    <message>
        <source>Scripted hand</source>
        <translation>Programmierte Hand</translation>
    </message>
</context>
<context>
    <name>PlanWords</name>
    <message>
        <source>All of %1 simulated runs gave a usable value.</source>
        <translation>Alle %1 simulierten Läufe ergaben einen brauchbaren Wert.</translation>
    </message>
    <message>
        <source>With about %1 trials or more, fewer than 1 run in 20 gives no usable value.</source>
        <translation>Ab etwa %1 Durchgängen bleibt weniger als 1 Lauf von 20 ohne brauchbaren Wert.</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no usable value; such runs are left out of group values.</source>
        <translation>
            <numerusform>%n von %1 simulierten Läufen ergab keinen brauchbaren Wert; solche Läufe zählen nicht in Gruppenwerten.</numerusform>
            <numerusform>%n von %1 simulierten Läufen ergaben keinen brauchbaren Wert; solche Läufe zählen nicht in Gruppenwerten.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>PlatformCheck</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Noise, hysteresis and creep of the force sensors</source>
        <translation>Rauschen, Hysterese und Kriechen der Kraftsensoren</translation>
    </message>
    <message>
        <source>Resolution of the converter</source>
        <translation>Auflösung des Wandlers</translation>
    </message>
    <message>
        <source>Delay of the force sensors</source>
        <translation>Verzögerung der Kraftsensoren</translation>
    </message>
    <message>
        <source>Friction of the drives</source>
        <translation>Reibung der Antriebe</translation>
    </message>
    <message>
        <source>Backlash of the gears</source>
        <translation>Spiel der Getriebe</translation>
    </message>
    <message>
        <source>16 bits</source>
        <translation>16 Bit</translation>
    </message>
    <message>
        <source>%1 times as coarse</source>
        <translation>%1-mal so grob</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>× %1</source>
        <translation>× %1</translation>
    </message>
    <message>
        <source>This is the simulated platform, with hardware as imperfect as real parts are: force noise of %1 mN and %2 bits of the converter, hysteresis of %3 %, a delay of %4 ms from sensor to controller, gear friction of %5 N per drive, backlash of %6 µm, an orientation sensor with %7° bias and %8° noise.</source>
        <translation>Dies ist die simulierte Plattform, so unvollkommen wie echte Bauteile: %1 mN Rauschen der Kraft und %2 Bit des Wandlers, %3 % Hysterese, %4 ms Verzögerung vom Sensor zum Regler, %5 N Getriebereibung je Antrieb, %6 µm Spiel, ein Lagesensor mit %7° Versatz und %8° Rauschen.</translation>
    </message>
    <message>
        <source>Friction, identified by moving the drives: %1 N, plus %2 N·s/m with speed.</source>
        <translation>Reibung, durch Bewegen der Antriebe bestimmt: %1 N, dazu %2 N·s/m mit der Geschwindigkeit.</translation>
    </message>
    <message>
        <source>A step of force is felt after %1 ms. With the damping of drives and fingertip alone, a wall is stable up to %2 N/mm.</source>
        <translation>Ein Kraftsprung ist nach %1 ms zu spüren. Allein mit der Dämpfung von Antrieben und Fingerkuppe ist eine Wand bis %2 N/mm stabil.</translation>
    </message>
    <message>
        <source>Noise and offset of the orientation sensor</source>
        <translation>Rauschen und Versatz des Lagesensors</translation>
    </message>
    <message>
        <source>A simulation: the simulated platform stays within its bounds on %1 of %2 simulated fingers. At worst, the force on the fingertip is off by %3 (root mean square), the orientation by %4, a step overshoots by %5 % of the force, and the fingertip gets at most %6 (%7). A real platform has to be measured separately.</source>
        <translation>Eine Simulation: Die simulierte Plattform hält ihre Grenzen an %1 von %2 simulierten Fingern ein. Im schlechtesten Fall weicht die Kraft an der Fingerkuppe um %3 ab (quadratisches Mittel), die Neigung um %4, ein Sprung schwingt um %5 % der Kraft über, und die Fingerkuppe bekommt höchstens %6 (%7). Eine echte Plattform muss gesondert gemessen werden.</translation>
    </message>
    <message>
        <source>bounds: %1, %2, %3 %, %4</source>
        <translation>Grenzen: %1, %2, %3 %, %4</translation>
    </message>
    <message>
        <source>Half as stiff</source>
        <translation>Halb so steif</translation>
    </message>
    <message>
        <source>Twice as stiff</source>
        <translation>Doppelt so steif</translation>
    </message>
    <message>
        <source>Thick</source>
        <translation>Dick</translation>
    </message>
    <message>
        <source>Thin</source>
        <translation>Dünn</translation>
    </message>
    <message>
        <source>Its force relaxes by 40 %</source>
        <translation>Die Kraft lässt um 40 % nach</translation>
    </message>
    <message>
        <source>Half as stiff, thick, relaxing</source>
        <translation>Halb so steif, dick, nachlassend</translation>
    </message>
    <message>
        <source>Twice as stiff, thin, relaxing</source>
        <translation>Doppelt so steif, dünn, nachlassend</translation>
    </message>
    <message>
        <source>The assumed finger</source>
        <translation>Der angenommene Finger</translation>
    </message>
    <message>
        <source>On other fingers: the true force on the fingertip</source>
        <translation>An anderen Fingern: die wahre Kraft an der Fingerkuppe</translation>
    </message>
    <message>
        <source>Simulated finger</source>
        <translation>Simulierter Finger</translation>
    </message>
    <message>
        <source>Gain, phase</source>
        <translation>Verstärkung, Phase</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>Max. at 1 N</source>
        <translation>Max. bei 1 N</translation>
    </message>
    <message>
        <source>Max. at 4 N</source>
        <translation>Max. bei 4 N</translation>
    </message>
    <message>
        <source>Within its bounds</source>
        <translation>In den Grenzen</translation>
    </message>
    <message>
        <source>%1, %2°</source>
        <translation>%1, %2°</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Compared with the published figures</source>
        <translation>Vergleich mit den veröffentlichten Werten</translation>
    </message>
    <message>
        <source>Figure</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>By its own sensors</source>
        <translation>Nach den eigenen Sensoren</translation>
    </message>
    <message>
        <source>True value</source>
        <translation>Wahrer Wert</translation>
    </message>
    <message>
        <source>Published (P3)</source>
        <translation>Veröffentlicht (P3)</translation>
    </message>
    <message>
        <source>Force, cycle %1: root mean square error</source>
        <translation>Kraft, Periode %1: quadratisches Mittel des Fehlers</translation>
    </message>
    <message>
        <source>Force, mean of the cycles</source>
        <translation>Kraft, Mittel der Perioden</translation>
    </message>
    <message>
        <source>Orientation, mean error of %1 poses</source>
        <translation>Neigung, mittlerer Fehler aus %1 Stellungen</translation>
    </message>
    <message>
        <source>Orientation, standard deviation</source>
        <translation>Neigung, Standardabweichung</translation>
    </message>
    <message>
        <source>Force error</source>
        <translation>Kraftfehler</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>When one part gets worse</source>
        <translation>Wenn ein Bauteil schlechter wird</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>Wie viel</translation>
    </message>
    <message>
        <source>Orientation error</source>
        <translation>Fehler der Neigung</translation>
    </message>
</context>
<context>
    <name>PlatformPlots</name>
    <message>
        <source>Force over three cycles</source>
        <translation>Kraft über drei Perioden</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>on the fingertip</source>
        <translation>an der Fingerkuppe</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Soll</translation>
    </message>
    <message>
        <source>Orientations, measured against target</source>
        <translation>Neigungen, gemessen über Soll</translation>
    </message>
    <message>
        <source>Target (°)</source>
        <translation>Soll (°)</translation>
    </message>
    <message>
        <source>Measured (°)</source>
        <translation>Gemessen (°)</translation>
    </message>
    <message>
        <source>ideal</source>
        <translation>ideal</translation>
    </message>
    <message>
        <source>pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Distribution of the orientation errors</source>
        <translation>Verteilung der Neigungsfehler</translation>
    </message>
    <message>
        <source>Error (°)</source>
        <translation>Fehler (°)</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>Stellungen</translation>
    </message>
    <message>
        <source>poses</source>
        <translation>Stellungen</translation>
    </message>
</context>
<context>
    <name>PlaybackMarks</name>
    <message>
        <source>Force on hold: the tool moved too fast</source>
        <translation>Kraft vorübergehend aus: Instrument zu schnell</translation>
    </message>
    <message>
        <source>The device sent an invalid sample</source>
        <translation>Das Gerät sendete einen ungültigen Messpunkt</translation>
    </message>
    <message>
        <source>Fault: the device sent too many invalid samples</source>
        <translation>Störung: zu viele ungültige Messpunkte vom Gerät</translation>
    </message>
    <message>
        <source>Force on hold: samples from the device came late</source>
        <translation>Kraft vorübergehend aus: Messpunkte des Geräts kamen verspätet</translation>
    </message>
    <message>
        <source>Fault: the device stopped sending data</source>
        <translation>Störung: Das Gerät sendete keine Daten mehr</translation>
    </message>
    <message>
        <source>Force on hold: the window did not respond</source>
        <translation>Kraft vorübergehend aus: Das Fenster reagierte nicht</translation>
    </message>
    <message>
        <source>Force damped to keep it stable</source>
        <translation>Kraft gedämpft, damit sie stabil bleibt</translation>
    </message>
    <message>
        <source>Fault: reported by the device</source>
        <translation>Störung: vom Gerät gemeldet</translation>
    </message>
    <message>
        <source>The force supervisor stepped in</source>
        <translation>Die Sicherheitsüberwachung griff ein</translation>
    </message>
    <message>
        <source>Trial %1 begins</source>
        <translation>Durchgang %1 beginnt</translation>
    </message>
    <message>
        <source>Marked the highest point</source>
        <translation>Höchsten Punkt markiert</translation>
    </message>
    <message>
        <source>Time was up without a mark</source>
        <translation>Zeit ohne Markierung abgelaufen</translation>
    </message>
    <message>
        <source>The trace ended without a mark</source>
        <translation>Aufzeichnung endete ohne Markierung</translation>
    </message>
    <message>
        <source>In contact for %1</source>
        <translation>%1 lang in Kontakt</translation>
    </message>
    <message>
        <source>Paused for %1</source>
        <translation>%1 lang Pause</translation>
    </message>
    <message>
        <source>Force re-armed</source>
        <translation>Kraft wieder freigegeben</translation>
    </message>
    <message>
        <source>The person ended the session</source>
        <translation>Die Person beendete die Sitzung</translation>
    </message>
    <message>
        <source>The insertion begins</source>
        <translation>Das Einführen beginnt</translation>
    </message>
    <message>
        <source>The inspection begins</source>
        <translation>Die Inspektion beginnt</translation>
    </message>
    <message>
        <source>The withdrawal begins</source>
        <translation>Der Rückzug beginnt</translation>
    </message>
    <message>
        <source>Step: take hold</source>
        <translation>Schritt: greifen</translation>
    </message>
    <message>
        <source>Step: stretch</source>
        <translation>Schritt: dehnen</translation>
    </message>
    <message>
        <source>Step: hold still</source>
        <translation>Schritt: ruhig halten</translation>
    </message>
    <message>
        <source>Step: hand over</source>
        <translation>Schritt: übergeben</translation>
    </message>
    <message>
        <source>Step: lift</source>
        <translation>Schritt: anheben</translation>
    </message>
    <message>
        <source>Step: carry to the target</source>
        <translation>Schritt: zum Ziel bringen</translation>
    </message>
    <message>
        <source>Step: set down</source>
        <translation>Schritt: ablegen</translation>
    </message>
    <message>
        <source>Step: hold the tissue back</source>
        <translation>Schritt: Gewebe zurückhalten</translation>
    </message>
    <message>
        <source>The next stage begins</source>
        <translation>Die nächste Phase beginnt</translation>
    </message>
    <message>
        <source>Landmarks seen: %1</source>
        <translation>Gesehene Landmarken: %1</translation>
    </message>
    <message>
        <source>A landmark was seen</source>
        <translation>Eine Landmarke wurde gesehen</translation>
    </message>
    <message>
        <source>Moved back by %1</source>
        <translation>Um %1 zurückgegangen</translation>
    </message>
    <message>
        <source>Off-centre for %1, up to %2</source>
        <translation>Auslenkung von der Mittellinie: %1 lang, bis zu %2</translation>
    </message>
    <message>
        <source>Torque over its limit for %1, up to %2</source>
        <translation>Drehmoment %1 lang über seiner Grenze, mit bis zu %2</translation>
    </message>
    <message>
        <source>Took hold</source>
        <translation>Gefasst</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Losgelassen</translation>
    </message>
    <message>
        <source>Slipped out or dropped</source>
        <translation>Entglitten oder fallen gelassen</translation>
    </message>
    <message>
        <source>Critical error: %1</source>
        <translation>Kritischer Fehler: %1</translation>
    </message>
    <message>
        <source>The tissue gave way at %1</source>
        <translation>Das Gewebe gab bei %1 nach</translation>
    </message>
    <message>
        <source>Finding %1 marked</source>
        <translation>Fund %1 markiert</translation>
    </message>
    <message>
        <source>Finding %1 taken back</source>
        <translation>Fund %1 zurückgenommen</translation>
    </message>
    <message>
        <source>The trial was completed</source>
        <translation>Der Durchgang wurde abgeschlossen</translation>
    </message>
    <message>
        <source>The trial could no longer be completed</source>
        <translation>Der Durchgang ließ sich nicht mehr abschließen</translation>
    </message>
    <message>
        <source>The tissue was damaged</source>
        <translation>Das Gewebe wurde geschädigt</translation>
    </message>
    <message>
        <source>Ended</source>
        <translation>Beendet</translation>
    </message>
    <message>
        <source>The procedure was completed</source>
        <translation>Der Eingriff wurde abgeschlossen</translation>
    </message>
    <message>
        <source>Time was up before the end of the procedure</source>
        <translation>Die Zeit lief vor dem Ende des Eingriffs ab</translation>
    </message>
    <message>
        <source>The procedure could no longer be completed</source>
        <translation>Der Eingriff ließ sich nicht mehr abschließen</translation>
    </message>
    <message>
        <source>The tube was held as asked</source>
        <translation>Der Schlauch wurde wie verlangt gehalten</translation>
    </message>
    <message>
        <source>Time was up before the tube was held as asked</source>
        <translation>Die Zeit war um, bevor der Schlauch wie verlangt gehalten wurde</translation>
    </message>
    <message>
        <source>The tube tore: the trial could no longer be completed</source>
        <translation>Der Schlauch riss: Der Durchgang ließ sich nicht mehr abschließen</translation>
    </message>
    <message>
        <source>The tube was stretched too far</source>
        <translation>Der Schlauch wurde zu weit gedehnt</translation>
    </message>
    <message>
        <source>An object was set down in the target</source>
        <translation>Ein Objekt wurde im Ziel abgelegt</translation>
    </message>
    <message>
        <source>Time was up before an object was set down in the target</source>
        <translation>Die Zeit war um, bevor ein Objekt im Ziel abgelegt wurde</translation>
    </message>
    <message>
        <source>The object was squeezed too hard</source>
        <translation>Das Objekt wurde zu fest zusammengedrückt</translation>
    </message>
    <message>
        <source>The search was reported as done</source>
        <translation>Die Suche wurde als beendet gemeldet</translation>
    </message>
    <message>
        <source>Time was up before the search was reported as done</source>
        <translation>Die Zeit war um, bevor die Suche als beendet gemeldet wurde</translation>
    </message>
    <message>
        <source>The search could no longer be completed</source>
        <translation>Die Suche ließ sich nicht mehr abschließen</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>The comparison was completed</source>
        <translation>Der Vergleich wurde abgeschlossen</translation>
    </message>
    <message>
        <source>Time was up without an answer</source>
        <translation>Die Zeit lief ohne Antwort ab</translation>
    </message>
    <message>
        <source>The comparison could no longer be completed</source>
        <translation>Der Vergleich ließ sich nicht mehr abschließen</translation>
    </message>
    <message>
        <source>The object was damaged</source>
        <translation>Das Objekt wurde beschädigt</translation>
    </message>
    <message>
        <source>The person stopped the force for %1</source>
        <translation>Die Person stoppte die Kraft, %1 lang</translation>
    </message>
    <message>
        <source>The person stopped the force</source>
        <translation>Die Person stoppte die Kraft</translation>
    </message>
    <message>
        <source>For %1, less force was felt than the tissue exerted (up to %2)</source>
        <translation>%1 lang war weniger Kraft zu fühlen, als das Gewebe ausübte (bis zu %2)</translation>
    </message>
    <message>
        <source>Miss: the wrong place was marked</source>
        <translation>Fehlversuch: falsche Stelle markiert</translation>
    </message>
    <message>
        <source>Finding %1 marked where there was no lump</source>
        <translation>Fund %1 markiert, wo kein Knoten war</translation>
    </message>
    <message>
        <source>A lump was missed</source>
        <translation>Ein Knoten wurde übersehen</translation>
    </message>
    <message>
        <source>The tissue gave way at a torque of %1</source>
        <translation>Das Gewebe gab bei einem Drehmoment von %1 nach</translation>
    </message>
    <message>
        <source>The object came off the tool at %1</source>
        <translation>Das Objekt löste sich bei %1 vom Instrument</translation>
    </message>
    <message>
        <source>Trauma event: pressed sideways on the wall for %1, up to %2</source>
        <translation>Verletzungsereignis: %1 lang seitlich gegen die Wand gedrückt, mit bis zu %2</translation>
    </message>
    <message>
        <source>Over the force limit for %1, up to %2</source>
        <translation>%1 lang über der Kraftgrenze, mit bis zu %2</translation>
    </message>
</context>
<context>
    <name>Procedures</name>
    <message>
        <source>Trials per level</source>
        <translation>Durchgänge je Stufe</translation>
    </message>
    <message>
        <source>In random order</source>
        <translation>In zufälliger Reihenfolge</translation>
    </message>
    <message>
        <source>Levels</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>What is presented. Levels must lie within the table of differences.</source>
        <translation>Was dargeboten wird. Stufen müssen in der Tabelle der Unterschiede liegen.</translation>
    </message>
    <message>
        <source>Constant stimuli</source>
        <translation>Konstante Reize</translation>
    </message>
    <message>
        <source>Presents every difference equally often, in random order. Measures the whole curve, but needs many trials.</source>
        <translation>Bietet jeden Unterschied gleich oft dar, in zufälliger Reihenfolge. Misst die ganze Kurve, braucht aber viele Durchgänge.</translation>
    </message>
    <message>
        <source>Presentations per level</source>
        <translation>Darbietungen je Stufe</translation>
    </message>
    <message>
        <source>Right answers to go on</source>
        <translation>Richtige Antworten zum Weitergehen</translation>
    </message>
    <message>
        <source>With fewer right answers at a level the run ends there.</source>
        <translation>Bei weniger richtigen Antworten auf einer Stufe endet der Lauf dort.</translation>
    </message>
    <message>
        <source>What is presented, from the largest to the smallest difference.</source>
        <translation>Was dargeboten wird, vom größten zum kleinsten Unterschied.</translation>
    </message>
    <message>
        <source>Descending ranking (legacy)</source>
        <translation>Absteigende Rangfolge (alt)</translation>
    </message>
    <message>
        <source>The difference shrinks until an answer is wrong. The resulting JND is 1.5 to 3 times too large; for replications only.</source>
        <translation>Der Unterschied wird kleiner, bis eine Antwort falsch ist. Die so bestimmte JND ist 1,5- bis 3-mal zu groß; nur für Replikationen früherer Arbeiten.</translation>
    </message>
    <message>
        <source>Maximum trials</source>
        <translation>Höchstzahl Durchgänge</translation>
    </message>
    <message>
        <source>Reversals until stop</source>
        <translation>Umkehrungen bis zum Ende</translation>
    </message>
    <message>
        <source>Minimum trials</source>
        <translation>Mindestzahl Durchgänge</translation>
    </message>
    <message>
        <source>The run ends once the threshold is known within this difference (one standard deviation).</source>
        <translation>Der Lauf endet, sobald die Schwelle auf diesen Unterschied genau bekannt ist (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>The run ends once the threshold is known within this factor (one standard deviation). Usually × 1.15.</source>
        <translation>Der Lauf endet, sobald die Schwelle auf diesen Faktor bekannt ist (eine Standardabweichung). Meist × 1,15.</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>First difference</source>
        <translation>Erster Unterschied</translation>
    </message>
    <message>
        <source>Where the run begins: large enough to be felt by everybody.</source>
        <translation>Wo der Lauf beginnt: so groß, dass ihn jeder spürt.</translation>
    </message>
    <message>
        <source>First step</source>
        <translation>Erster Schritt</translation>
    </message>
    <message>
        <source>How far the difference changes at first.</source>
        <translation>Wie stark sich der Unterschied anfangs ändert.</translation>
    </message>
    <message>
        <source>Smallest step</source>
        <translation>Kleinster Schritt</translation>
    </message>
    <message>
        <source>The run ends when a step would be as small as this.</source>
        <translation>Der Lauf endet, wenn ein Schritt so klein würde.</translation>
    </message>
    <message>
        <source>Largest step</source>
        <translation>Größter Schritt</translation>
    </message>
    <message>
        <source>Steps never grow beyond this.</source>
        <translation>Größer werden die Schritte nie.</translation>
    </message>
    <message>
        <source>PEST</source>
        <translation>PEST</translation>
    </message>
    <message>
        <source>A sequential test halves and doubles the steps. For replications only.</source>
        <translation>Ein sequenzieller Test halbiert und verdoppelt die Schritte. Nur für Replikationen früherer Arbeiten.</translation>
    </message>
    <message>
        <source>Expected threshold</source>
        <translation>Erwartete Schwelle</translation>
    </message>
    <message>
        <source>Where the threshold is expected before the first answer.</source>
        <translation>Wo die Schwelle vor der ersten Antwort erwartet wird.</translation>
    </message>
    <message>
        <source>How far off the expectation may be (one standard deviation).</source>
        <translation>Wie weit die Erwartung danebenliegen kann (eine Standardabweichung).</translation>
    </message>
    <message>
        <source>How far off the expectation may be (one standard deviation). Usually × 3.</source>
        <translation>Wie weit die Erwartung danebenliegen kann (eine Standardabweichung). Meist × 3.</translation>
    </message>
    <message>
        <source>Slope β</source>
        <translation>Steigung β</translation>
    </message>
    <message>
        <source>Lapses</source>
        <translation>Lapses</translation>
    </message>
    <message>
        <source>Right by guessing</source>
        <translation>Durch Raten richtig</translation>
    </message>
    <message>
        <source>Quantile</source>
        <translation>Quantil</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Place trials at</source>
        <translation>Durchgänge liegen bei</translation>
    </message>
    <message>
        <source>QUEST</source>
        <translation>QUEST</translation>
    </message>
    <message>
        <source>Bayesian; places each trial where the threshold probably is.</source>
        <translation>Bayes-Verfahren; legt jeden Durchgang dorthin, wo die Schwelle wahrscheinlich liegt.</translation>
    </message>
    <message>
        <source>Weibull</source>
        <translation>Weibull</translation>
    </message>
    <message>
        <source>Normal (probit)</source>
        <translation>Normal (Probit)</translation>
    </message>
    <message>
        <source>Normal, lapses on both sides</source>
        <translation>Normal, Lapses auf beiden Seiten</translation>
    </message>
    <message>
        <source>Logistic (logit)</source>
        <translation>Logistisch (Logit)</translation>
    </message>
    <message>
        <source>Gumbel</source>
        <translation>Gumbel</translation>
    </message>
    <message>
        <source>Gumbel, mirrored</source>
        <translation>Gumbel, gespiegelt</translation>
    </message>
    <message>
        <source>Hyperbolic secant</source>
        <translation>Sekans hyperbolicus</translation>
    </message>
    <message>
        <source>Psychometric function</source>
        <translation>Psychometrische Funktion</translation>
    </message>
    <message>
        <source>Same difference in a row</source>
        <translation>Gleicher Unterschied in Folge</translation>
    </message>
    <message>
        <source>Catch trials</source>
        <translation>Kontrolldurchgänge</translation>
    </message>
    <message>
        <source>Values of this parameter that are considered possible.</source>
        <translation>Werte dieses Parameters, die als möglich gelten.</translation>
    </message>
    <message>
        <source>QUEST+</source>
        <translation>QUEST+</translation>
    </message>
    <message>
        <source>Bayesian; chooses the trial that tells most about threshold, slope and lapse rate.</source>
        <translation>Bayes-Verfahren; wählt den Durchgang, der am meisten über Schwelle, Steigung und Lapse-Rate verrät.</translation>
    </message>
    <message>
        <source>Shares of careless answers that are considered possible.</source>
        <translation>Anteile unachtsamer Antworten, die als möglich gelten.</translation>
    </message>
    <message>
        <source>Ties (in σ)</source>
        <translation>Gleichstände (in σ)</translation>
    </message>
    <message>
        <source>Just noticeable difference</source>
        <translation>Unterschiedsschwelle</translation>
    </message>
    <message>
        <source>QUEST+ for rankings</source>
        <translation>QUEST+ für Rangfolgen</translation>
    </message>
    <message>
        <source>QUEST+ with an observer model for rankings of three. Needs the fewest trials; the default.</source>
        <translation>QUEST+ mit einem Beobachtermodell für Rangfolgen von dreien. Braucht die wenigsten Durchgänge; die Voreinstellung.</translation>
    </message>
    <message>
        <source>Where the run begins: large enough to be felt by everybody. It must lie in the table of differences.</source>
        <translation>Wo der Lauf beginnt: so groß, dass ihn jeder spürt. Er muss in der Tabelle der Unterschiede liegen.</translation>
    </message>
    <message>
        <source>Right answers for a step down</source>
        <translation>Richtige Antworten bis zum Schritt nach unten</translation>
    </message>
    <message>
        <source>Wrong answers for a step up</source>
        <translation>Falsche Antworten bis zum Schritt nach oben</translation>
    </message>
    <message>
        <source>Step down as a share of a step up</source>
        <translation>Schritt nach unten als Anteil des Schritts nach oben</translation>
    </message>
    <message>
        <source>Steps down are usually smaller than steps up, so that the run converges: 73.93 % for three right answers (García-Pérez 1998).</source>
        <translation>Schritte nach unten sind meist kleiner als Schritte nach oben, damit der Lauf konvergiert: 73,93 % bei drei richtigen Antworten (García-Pérez 1998).</translation>
    </message>
    <message>
        <source>as listed</source>
        <translation>wie aufgeführt</translation>
    </message>
    <message>
        <source>Reversals averaged</source>
        <translation>Gemittelte Umkehrungen</translation>
    </message>
    <message>
        <source>Steps up</source>
        <translation>Schritte nach oben</translation>
    </message>
    <message>
        <source>Steps down</source>
        <translation>Schritte nach unten</translation>
    </message>
    <message>
        <source>One up, one down at first</source>
        <translation>Anfangs einer auf, einer ab</translation>
    </message>
    <message>
        <source>After each step, right and wrong answers are counted from zero.</source>
        <translation>Nach jedem Schritt werden richtige und falsche Antworten wieder von null gezählt.</translation>
    </message>
    <message>
        <source>New step size at the reversal</source>
        <translation>Neue Schrittweite bei der Umkehrung</translation>
    </message>
    <message>
        <source>The step that makes the reversal already has the new size.</source>
        <translation>Schon der Schritt, der die Umkehrung bildet, hat die neue Weite.</translation>
    </message>
    <message>
        <source>Stay within the table</source>
        <translation>In der Tabelle bleiben</translation>
    </message>
    <message>
        <source>The run never asks for differences beyond the smallest and largest.</source>
        <translation>Der Lauf verlangt nie Unterschiede jenseits des kleinsten und des größten.</translation>
    </message>
    <message>
        <source>Staircase (up–down)</source>
        <translation>Treppenverfahren (auf–ab)</translation>
    </message>
    <message>
        <source>Gets harder after right answers and easier after wrong ones. Robust and easy to explain.</source>
        <translation>Wird nach richtigen Antworten schwerer und nach falschen leichter. Robust und leicht zu erklären.</translation>
    </message>
    <message>
        <source>How often each level is presented.</source>
        <translation>Wie oft jede Stufe dargeboten wird.</translation>
    </message>
    <message>
        <source>Levels come in random order, each once in every block; otherwise in the order of the table.</source>
        <translation>Die Stufen kommen in zufälliger Reihenfolge, in jedem Block jede einmal; sonst in der Reihenfolge der Tabelle.</translation>
    </message>
    <message>
        <source>How often each level is presented before the run goes on or ends.</source>
        <translation>Wie oft jede Stufe dargeboten wird, bevor der Lauf weitergeht oder endet.</translation>
    </message>
    <message>
        <source>The run ends once the direction has changed this many times; 0: only the number of trials ends it.</source>
        <translation>Der Lauf endet, sobald die Richtung so oft gewechselt hat; 0: nur die Zahl der Durchgänge beendet ihn.</translation>
    </message>
    <message>
        <source>Stop at this precision</source>
        <translation>Ende bei dieser Genauigkeit</translation>
    </message>
    <message>
        <source>Target share of right answers</source>
        <translation>Angestrebter Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>The run looks for the difference at which this share of the answers is right.</source>
        <translation>Der Lauf sucht den Unterschied, bei dem dieser Anteil der Antworten richtig ist.</translation>
    </message>
    <message>
        <source>Tolerated deviation</source>
        <translation>Erlaubte Abweichung</translation>
    </message>
    <message>
        <source>The threshold is the difference at which this share of the answers is right.</source>
        <translation>Die Schwelle ist der Unterschied, bei dem dieser Anteil der Antworten richtig ist.</translation>
    </message>
    <message>
        <source>Where on the posterior distribution the next trial is placed; the quantile is the most efficient.</source>
        <translation>An welchem Punkt der A-posteriori-Verteilung der nächste Durchgang liegt; das Quantil ist am wirksamsten.</translation>
    </message>
    <message>
        <source>Change of the function</source>
        <translation>Änderung der Funktion</translation>
    </message>
    <message>
        <source>How many of the last reversals are averaged for the staircase&apos;s own estimate; the fit uses all trials.</source>
        <translation>Aus wie vielen der letzten Umkehrungen die Treppe ihre eigene Schätzung mittelt; die Anpassung nutzt alle Durchgänge.</translation>
    </message>
    <message>
        <source>Start counting again after each step</source>
        <translation>Nach jedem Schritt neu zählen</translation>
    </message>
    <message>
        <source>The run ends after this number of trials at the latest; 0: no limit. With fewer than 20 trials, runs are marked as short, and many give no usable value.</source>
        <translation>Der Lauf endet spätestens nach dieser Zahl von Durchgängen; 0: unbegrenzt. Läufe mit weniger als 20 Durchgängen werden als kurz gekennzeichnet, und viele ergeben keinen brauchbaren Wert.</translation>
    </message>
    <message>
        <source>The run does not end earlier, however sure the estimate is; 0: no minimum. It matters only where the run stops at a set precision.</source>
        <translation>Der Lauf endet nicht früher, so sicher die Schätzung auch ist; 0: kein Mindestwert. Das ist nur von Bedeutung, wenn der Lauf bei einer festgelegten Genauigkeit endet.</translation>
    </message>
    <message>
        <source>Uncertainty of the expectation</source>
        <translation>Unsicherheit der Erwartung</translation>
    </message>
    <message>
        <source>How steeply the share of right answers grows with the difference; it is assumed, not measured.</source>
        <translation>Wie steil der Anteil richtiger Antworten mit dem Unterschied zunimmt; das wird angenommen, nicht gemessen.</translation>
    </message>
    <message>
        <source>Share of answers that are wrong although the difference is felt.</source>
        <translation>Anteil der Antworten, die falsch sind, obwohl der Unterschied gespürt wird.</translation>
    </message>
    <message>
        <source>Share of answers that are right although nothing is felt: 50 % with two alternatives.</source>
        <translation>Anteil der Antworten, die richtig sind, obwohl nichts gespürt wird: 50 % bei zwei Alternativen.</translation>
    </message>
    <message>
        <source>How the share of right answers is assumed to grow with the difference.</source>
        <translation>Annahme darüber, wie der Anteil richtiger Antworten mit dem Unterschied zunimmt.</translation>
    </message>
    <message>
        <source>The same difference is presented at most this many times in a row; 0: no limit.</source>
        <translation>Derselbe Unterschied kommt höchstens so oft hintereinander vor; 0: unbegrenzt.</translation>
    </message>
    <message>
        <source>Share of trials with the largest difference, which show whether a participant pays attention.</source>
        <translation>Anteil der Durchgänge mit dem größten Unterschied; sie zeigen, ob jemand aufmerksam ist.</translation>
    </message>
    <message>
        <source>Values of the limit that are considered possible: two objects are called equal when the difference felt is below it. In standard deviations of what is felt.</source>
        <translation>Werte der Grenze, die als möglich gelten: Zwei Objekte werden gleich genannt, wenn ihr gespürter Unterschied darunter liegt. In Standardabweichungen des Gespürten.</translation>
    </message>
    <message>
        <source>The just noticeable difference is assumed to lie between these two values.</source>
        <translation>Es wird angenommen, dass die Unterschiedsschwelle zwischen diesen beiden Werten liegt.</translation>
    </message>
    <message>
        <source>After this many right answers in a row the next trial is harder; with 3 the run converges at about 80 % right answers.</source>
        <translation>Nach so vielen richtigen Antworten hintereinander wird der nächste Durchgang schwerer; mit 3 konvergiert der Lauf bei etwa 80 % richtigen Antworten.</translation>
    </message>
    <message>
        <source>After this many wrong answers in a row the next trial is easier.</source>
        <translation>Nach so vielen falschen Antworten hintereinander wird der nächste Durchgang leichter.</translation>
    </message>
    <message>
        <source>The first step is used until the first reversal, then the next one after each reversal; the last one stays in use.</source>
        <translation>Der erste gilt bis zur ersten Umkehrung, nach jeder Umkehrung der nächste; der letzte gilt weiter.</translation>
    </message>
    <message>
        <source>Until the first reversal a single right answer makes the next trial harder, so that the run gets near the threshold sooner.</source>
        <translation>Bis zur ersten Umkehrung macht schon eine richtige Antwort den nächsten Durchgang schwerer, sodass der Lauf schneller in die Nähe der Schwelle kommt.</translation>
    </message>
    <message>
        <source>A level ends once the number of right answers differs from the expected one by more than this. Larger values take longer and make the decision more reliable.</source>
        <translation>Eine Stufe endet, sobald die Zahl richtiger Antworten um mehr als diesen Wert von der erwarteten abweicht. Größere Werte dauern länger und machen die Entscheidung zuverlässiger.</translation>
    </message>
    <message>
        <source>In the same order as the steps up. Without an entry, the steps down are as large as the steps up.</source>
        <translation>In derselben Reihenfolge wie die Schritte nach oben. Ohne Eintrag sind die Schritte nach unten so groß wie die nach oben.</translation>
    </message>
</context>
<context>
    <name>QDialogButtonBox</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateityp:</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>Ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Auswählen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 ist schon vorhanden.
Möchten Sie die Datei ersetzen?</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert am</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Retry</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>Anwenden</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>Results</name>
    <message>
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Ergebnisse von %1</translation>
    </message>
</context>
<context>
    <name>RocWords</name>
    <message>
        <source>Area under the curve: %1, where 0.5 is chance and 1 is perfect. Sessions: %2 (%3). Places with a lump: %4, without: %5.</source>
        <translation>Fläche unter der Kurve: %1; 0,5 bedeutet Zufall, 1 perfekt. Sitzungen: %2 (%3). Stellen mit Knoten: %4, ohne: %5.</translation>
    </message>
    <message>
        <source>force felt</source>
        <translation>Kraft gefühlt</translation>
    </message>
    <message>
        <source>force shown</source>
        <translation>Kraft gezeigt</translation>
    </message>
    <message>
        <source>Hits against false alarms, from certain to a guess</source>
        <translation>Treffer gegen Fehlalarme, von ganz sicher bis geraten</translation>
    </message>
    <message>
        <source>False alarm rate</source>
        <translation>Fehlalarmrate</translation>
    </message>
    <message>
        <source>Hit rate</source>
        <translation>Trefferrate</translation>
    </message>
    <message>
        <source>chance</source>
        <translation>Zufall</translation>
    </message>
    <message>
        <source>you</source>
        <translation>Sie</translation>
    </message>
</context>
<context>
    <name>RosterTemplate</name>
    <message>
        <source>Full name</source>
        <translation>Vollständiger Name</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Role</source>
        <translation>Rolle</translation>
    </message>
    <message>
        <source>Example: Anna Miller</source>
        <translation>Beispiel: Anna Müller</translation>
    </message>
    <message>
        <source>Example: Peter Brown</source>
        <translation>Beispiel: Peter Braun</translation>
    </message>
</context>
<context>
    <name>RosterWords</name>
    <message>
        <source>a quotation mark is opened here and never closed</source>
        <translation>hier beginnt ein Anführungszeichen, das nie geschlossen wird</translation>
    </message>
    <message>
        <source>too many lines, %1 at most</source>
        <translation>zu viele Zeilen, höchstens %1</translation>
    </message>
    <message>
        <source>the password needs at least %1 characters, %2 of them different, and must not be the name</source>
        <translation>das Passwort braucht mindestens %1 Zeichen, davon %2 verschiedene, und darf nicht der Name sein</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is already in line %2</source>
        <translation>„%1“ steht schon in Zeile %2</translation>
    </message>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>semicolons</source>
        <translation>Semikolons</translation>
    </message>
    <message>
        <source>commas</source>
        <translation>Kommas</translation>
    </message>
    <message>
        <source>tabs</source>
        <translation>Tabulatoren</translation>
    </message>
    <message>
        <source>Nothing to change</source>
        <translation>Nichts zu ändern</translation>
    </message>
    <message>
        <source>%1 → %2</source>
        <translation>%1 → %2</translation>
    </message>
    <message>
        <source>Read as %1, separated by %2.</source>
        <translation>Gelesen als %1, getrennt durch %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n people would be added. Each must choose a password of their own at the first login.</source>
        <translation>
            <numerusform>%n Person würde hinzugefügt. Sie muss bei der ersten Anmeldung ein eigenes Passwort wählen.</numerusform>
            <numerusform>%n Personen würden hinzugefügt. Jede muss bei der ersten Anmeldung ein eigenes Passwort wählen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people would be updated; their passwords remain valid.</source>
        <translation>
            <numerusform>%n Person würde aktualisiert; ihr Passwort bleibt gültig.</numerusform>
            <numerusform>%n Personen würden aktualisiert; ihre Passwörter bleiben gültig.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people have an account already and would be left as they are.</source>
        <translation>
            <numerusform>%n Person hat schon ein Konto und bliebe unverändert.</numerusform>
            <numerusform>%n Personen haben schon ein Konto und blieben unverändert.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n passwords would be made. They are shown once, right after the import, to be printed as slips.</source>
        <translation>
            <numerusform>%n Passwort würde erzeugt. Es wird nur einmal gezeigt, gleich nach dem Import, damit Sie es als Zettel drucken können.</numerusform>
            <numerusform>%n Passwörter würden erzeugt. Sie werden nur einmal gezeigt, gleich nach dem Import, damit Sie sie als Zettel drucken können.</numerusform>
        </translation>
    </message>
    <message>
        <source>Columns that are not imported: %1.</source>
        <translation>Spalten, die nicht importiert werden: %1.</translation>
    </message>
    <message>
        <source>People in the list</source>
        <translation>Personen in der Liste</translation>
    </message>
    <message>
        <source>Line</source>
        <translation>Zeile</translation>
    </message>
    <message>
        <source>What happens</source>
        <translation>Was geschieht</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Vollständiger Name</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>This is an Excel workbook (.xlsx). Open it in Excel, choose File &gt; Save As and the file type “CSV UTF-8 (comma delimited)”, then choose the new file here.</source>
        <translation>Dies ist eine Excel-Arbeitsmappe (.xlsx). Öffnen Sie sie in Excel, wählen Sie Datei &gt; Speichern unter und den Dateityp „CSV UTF-8 (durch Trennzeichen getrennt)“, dann wählen Sie hier die neue Datei.</translation>
    </message>
    <message>
        <source>This is an old Excel workbook (.xls). Open it in Excel, choose File &gt; Save As and the file type “CSV UTF-8 (comma delimited)”, then choose the new file here.</source>
        <translation>Dies ist eine alte Excel-Arbeitsmappe (.xls). Öffnen Sie sie in Excel, wählen Sie Datei &gt; Speichern unter und den Dateityp „CSV UTF-8 (durch Trennzeichen getrennt)“, dann wählen Sie hier die neue Datei.</translation>
    </message>
    <message>
        <source>This is a LibreOffice spreadsheet (.ods). Open it in LibreOffice, choose File &gt; Save As and the file type “Text CSV”, then choose the new file here.</source>
        <translation>Dies ist eine LibreOffice-Tabelle (.ods). Öffnen Sie sie in LibreOffice, wählen Sie Datei &gt; Speichern unter und den Dateityp „Text CSV“, dann wählen Sie hier die neue Datei.</translation>
    </message>
    <message>
        <source>This is a PDF, which has no columns to read. Ask for the list as a table, save it as CSV, then choose that file here.</source>
        <translation>Dies ist eine PDF-Datei; sie hat keine lesbaren Spalten. Lassen Sie sich die Liste als Tabelle geben, speichern Sie sie als CSV und wählen Sie dann hier diese Datei.</translation>
    </message>
    <message>
        <source>This is a ZIP archive. Unpack it and choose the CSV file in it.</source>
        <translation>Dies ist ein ZIP-Archiv. Entpacken Sie es und wählen Sie die CSV-Datei darin.</translation>
    </message>
    <message>
        <source>some letters cannot be read; save the list as “CSV UTF-8” once more</source>
        <translation>einige Buchstaben sind nicht lesbar; speichern Sie die Liste noch einmal als „CSV UTF-8“</translation>
    </message>
    <message>
        <source>a line with headings and at least one person are needed</source>
        <translation>nötig sind eine Zeile mit Überschriften und mindestens eine Person</translation>
    </message>
    <message>
        <source>headings are needed here, such as login name, full name and role; &quot;%1&quot; is none of them. “Save a template …” makes a file that has them</source>
        <translation>hier sind Überschriften nötig wie Anmeldename, Vollständiger Name und Rolle; „%1“ ist keine davon. „Vorlage speichern …“ erzeugt eine Datei, die sie hat</translation>
    </message>
    <message>
        <source>the column &quot;%1&quot; holds what another column holds already</source>
        <translation>die Spalte „%1“ enthält, was schon eine andere Spalte enthält</translation>
    </message>
    <message>
        <source>no column holds the roles; give one the heading “Role”</source>
        <translation>keine Spalte enthält die Rollen; geben Sie einer die Überschrift „Rolle“</translation>
    </message>
    <message>
        <source>no column holds the login name; give one the heading “Login name”</source>
        <translation>keine Spalte enthält den Anmeldenamen; geben Sie einer die Überschrift „Anmeldename“</translation>
    </message>
    <message>
        <source>has %1 fields, and there are %2 headings; put a value that holds the separator into quotation marks</source>
        <translation>hat %1 Felder, Überschriften gibt es aber %2; setzen Sie einen Wert, der das Trennzeichen enthält, in Anführungszeichen</translation>
    </message>
    <message>
        <source>a login name is needed</source>
        <translation>ein Anmeldename ist nötig</translation>
    </message>
    <message>
        <source>&quot;%1&quot; cannot be used; use at most %2 characters and no commas</source>
        <translation>„%1“ ist nicht möglich; erlaubt sind höchstens %2 Zeichen und keine Kommas</translation>
    </message>
    <message>
        <source>the full name is too long; use at most %1 characters</source>
        <translation>der vollständige Name ist zu lang; erlaubt sind höchstens %1 Zeichen</translation>
    </message>
    <message>
        <source>Line %1, column “%2”: %3</source>
        <translation>Zeile %1, Spalte „%2“: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n people would no longer be administrators.</source>
        <translation>
            <numerusform>%n Person hätte keine Administrationsrechte mehr.</numerusform>
            <numerusform>%n Personen hätten keine Administrationsrechte mehr.</numerusform>
        </translation>
    </message>
    <message>
        <source>Line %1: the login name %2 belongs to %3 today; it used to be that of %4. Check who is meant.</source>
        <translation>Zeile %1: Der Anmeldename %2 gehört heute %3; früher war er der von %4. Prüfen Sie, wer gemeint ist.</translation>
    </message>
    <message>
        <source>Line %1: several people had the login name %2 before and nobody has it today, so nobody is changed. Write today&apos;s login name in the list.</source>
        <translation>Zeile %1: Mehrere Personen hatten früher den Anmeldenamen %2, heute hat ihn niemand; deshalb wird niemand geändert. Schreiben Sie den heutigen Anmeldenamen in die Liste.</translation>
    </message>
    <message>
        <source>Line %1: this is the same person as in line %2, under another login name. Only line %2 counts.</source>
        <translation>Zeile %1: Das ist dieselbe Person wie in Zeile %2, unter einem anderen Anmeldenamen. Nur Zeile %2 zählt.</translation>
    </message>
    <message>
        <source>%1, known as %2 today</source>
        <translation>%1, heute bekannt als %2</translation>
    </message>
    <message numerus="yes">
        <source>%n people are listed under an earlier login name and are recognised by it.</source>
        <translation>
            <numerusform>%n Person steht unter einem früheren Anmeldenamen in der Liste und wird an ihm erkannt.</numerusform>
            <numerusform>%n Personen stehen unter einem früheren Anmeldenamen in der Liste und werden an ihm erkannt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>It is not certain who is meant in %n more lines. Point at the login name in the table to read why.</source>
        <translation>
            <numerusform>In %n weiteren Zeile ist nicht sicher, wer gemeint ist. Zeigen Sie in der Tabelle auf den Anmeldenamen, um den Grund zu lesen.</numerusform>
            <numerusform>In %n weiteren Zeilen ist nicht sicher, wer gemeint ist. Zeigen Sie in der Tabelle auf den Anmeldenamen, um den Grund zu lesen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The list has the earlier full name %1; today&apos;s name stays.</source>
        <translation>Die Liste hat den früheren vollständigen Namen %1; der heutige bleibt.</translation>
    </message>
    <message>
        <source>%1 would be called %2.</source>
        <translation>%1 hieße dann %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n people are listed under an earlier full name and keep today&apos;s name. To give somebody an earlier name back, edit the person.</source>
        <translation>
            <numerusform>%n Person steht unter einem früheren vollständigen Namen in der Liste und behält den heutigen. Um ihr einen früheren Namen wiederzugeben, bearbeiten Sie die Person.</numerusform>
            <numerusform>%n Personen stehen unter einem früheren vollständigen Namen in der Liste und behalten den heutigen. Um jemandem einen früheren Namen wiederzugeben, bearbeiten Sie die Person.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to import: everybody on the list is already here.</source>
        <translation>Nichts zu importieren: Alle auf der Liste sind schon da.</translation>
    </message>
    <message>
        <source>Would be added</source>
        <translation>Würde hinzugefügt</translation>
    </message>
    <message>
        <source>Would be left as it is</source>
        <translation>Bliebe unverändert</translation>
    </message>
    <message>
        <source>Would be updated</source>
        <translation>Würde aktualisiert</translation>
    </message>
    <message>
        <source>Cannot be imported yet</source>
        <translation>Kann noch nicht importiert werden</translation>
    </message>
    <message numerus="yes">
        <source>%n more people would get a different full name; the table shows them.</source>
        <translation>
            <numerusform>%n weitere Person bekäme einen anderen vollständigen Namen; die Tabelle zeigt ihn.</numerusform>
            <numerusform>%n weitere Personen bekämen einen anderen vollständigen Namen; die Tabelle zeigt sie.</numerusform>
        </translation>
    </message>
    <message>
        <source>this is not a text file; a CSV file is needed</source>
        <translation>das ist keine Textdatei; nötig ist eine CSV-Datei</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a role; write trainee, trainer, researcher or administrator, separated by semicolons</source>
        <translation>„%1“ ist keine Rolle; schreiben Sie Lernende Person, Ausbilder/in, Forschende Person oder Administration, durch Semikolon getrennt</translation>
    </message>
</context>
<context>
    <name>Screens</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Datensicherung</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Questionnaire</source>
        <translation>Fragebogen</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Restore a backup</source>
        <translation>Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Mein Konto</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
</context>
<context>
    <name>SessionWords</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>Unvollständig</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>Gestört</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Does not count</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>Familiarisation</source>
        <translation>Eingewöhnung</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gefühlt</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min %2 s</source>
        <translation>%1 min %2 s</translation>
    </message>
    <message>
        <source>just now</source>
        <translation>gerade eben</translation>
    </message>
    <message numerus="yes">
        <source>%n minute(s) ago</source>
        <translation>
            <numerusform>vor %n Minute</numerusform>
            <numerusform>vor %n Minuten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hour(s) ago</source>
        <translation>
            <numerusform>vor %n Stunde</numerusform>
            <numerusform>vor %n Stunden</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n day(s) ago</source>
        <translation>
            <numerusform>vor %n Tag</numerusform>
            <numerusform>vor %n Tagen</numerusform>
        </translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Own hand</source>
        <translation>Eigene Hand</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Angezeigt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Reviewed</source>
        <translation>Begutachtet</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, Stufe %2</translation>
    </message>
    <message>
        <source>Attempt %1 at level %2</source>
        <translation>Versuch %1 auf Stufe %2</translation>
    </message>
    <message>
        <source>%1, attempt %2 at level %3</source>
        <translation>%1, Versuch %2 auf Stufe %3</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Zu begutachten</translation>
    </message>
</context>
<context>
    <name>Sessions</name>
    <message>
        <source>Running</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>Incomplete</source>
        <translation>Unvollständig</translation>
    </message>
    <message>
        <source>Faulted</source>
        <translation>Gestört</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Not passed</source>
        <translation>Nicht bestanden</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gefühlt</translation>
    </message>
    <message>
        <source>Shown, not felt</source>
        <translation>Gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Force felt</source>
        <translation>Kraft gefühlt</translation>
    </message>
    <message>
        <source>Force shown, not felt</source>
        <translation>Kraft gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>%1 (scripted)</source>
        <translation>%1 (programmiert)</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>Level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>Not counted</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>Force rendered to a scripted hand</source>
        <translation>Kraft an eine programmierte Hand ausgegeben</translation>
    </message>
</context>
<context>
    <name>SiteMaker</name>
    <message>
        <source>A study with simulated participants</source>
        <translation>Eine Studie mit simulierten Teilnehmenden</translation>
    </message>
    <message>
        <source>%1, level %2, by a scripted operator</source>
        <translation>%1, Stufe %2, von einer programmierten Hand</translation>
    </message>
    <message>
        <source>%1, level %2, by %3</source>
        <translation>%1, Stufe %2, von %3</translation>
    </message>
    <message>
        <source>%1, level %2, by %3, attempt %4 of %5</source>
        <translation>%1, Stufe %2, von %3, Versuch %4 von %5</translation>
    </message>
</context>
<context>
    <name>SittingSentences</name>
    <message>
        <source>During the trials you hear a steady noise.</source>
        <translation>Während der Durchgänge hören Sie ein gleichmäßiges Rauschen.</translation>
    </message>
</context>
<context>
    <name>SoundLoader</name>
    <message>
        <source>Sound is switched off on this station. Everything that can be heard is also shown.</source>
        <translation>Der Ton ist an diesem Arbeitsplatz ausgeschaltet. Alles Hörbare wird auch angezeigt.</translation>
    </message>
    <message>
        <source>The sound module of Chiron is not installed. Everything that can be heard is also shown.</source>
        <translation>Das Tonmodul von Chiron ist nicht installiert. Alles Hörbare wird auch angezeigt.</translation>
    </message>
    <message>
        <source>The sound module belongs to another version of Chiron. Everything that can be heard is also shown.</source>
        <translation>Das Tonmodul gehört zu einer anderen Version von Chiron. Alles Hörbare wird auch angezeigt.</translation>
    </message>
    <message>
        <source>This station has no sound output. Everything that can be heard is also shown.</source>
        <translation>Dieser Arbeitsplatz hat keine Tonausgabe. Alles Hörbare wird auch angezeigt.</translation>
    </message>
</context>
<context>
    <name>StageWords</name>
    <message>
        <source>Inspection: %1 of %2 landmarks seen. Hold still</source>
        <translation>Inspektion: %1 von %2 Landmarken gesehen. Stillhalten</translation>
    </message>
    <message>
        <source>Inspection: %1 of %2 landmarks seen</source>
        <translation>Inspektion: %1 von %2 Landmarken gesehen</translation>
    </message>
    <message>
        <source>Before the entrance</source>
        <translation>Vor der Öffnung</translation>
    </message>
    <message>
        <source>Insertion</source>
        <translation>Einführen</translation>
    </message>
    <message>
        <source>Inspection</source>
        <translation>Inspektion</translation>
    </message>
    <message>
        <source>Withdrawal</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Before the entrance: advance into the urethra</source>
        <translation>Vor der Öffnung: in die Harnröhre vorschieben</translation>
    </message>
    <message>
        <source>Insertion: %1 of %2 mm</source>
        <translation>Einführen: %1 von %2 mm</translation>
    </message>
    <message>
        <source>Insertion: on the way to the goal</source>
        <translation>Einführen: auf dem Weg zum Ziel</translation>
    </message>
    <message>
        <source>Withdrawal: bring the endoscope out, %1 mm more</source>
        <translation>Rückzug: das Endoskop herausführen, noch %1 mm</translation>
    </message>
    <message>
        <source>Withdrawal: bring the endoscope all the way out</source>
        <translation>Rückzug: das Endoskop ganz herausführen</translation>
    </message>
</context>
<context>
    <name>StationRecord</name>
    <message>
        <source>pass</source>
        <translation>bestanden</translation>
    </message>
    <message>
        <source>FAIL</source>
        <translation>NICHT BESTANDEN</translation>
    </message>
    <message>
        <source>Measured values and their limits</source>
        <translation>Messwerte und ihre Grenzen</translation>
    </message>
    <message>
        <source>Quantity</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>Limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Site</source>
        <translation>Standort</translation>
    </message>
    <message>
        <source>Checked by</source>
        <translation>Geprüft von</translation>
    </message>
    <message>
        <source>Date and time</source>
        <translation>Datum und Uhrzeit</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>Program build</source>
        <translation>Programmversion</translation>
    </message>
    <message>
        <source>Entry in the audit trail</source>
        <translation>Eintrag im Prüfprotokoll</translation>
    </message>
    <message>
        <source>not written</source>
        <translation>nicht geschrieben</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>Ticks more than 100 µs late, of %1</source>
        <translation>Mehr als 100 µs verspätete Takte, von %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>Ticks skipped</source>
        <translation>Ausgelassene Takte</translation>
    </message>
    <message>
        <source>Lateness, half of the ticks</source>
        <translation>Verspätung der Hälfte der Takte</translation>
    </message>
    <message>
        <source>Lateness, 99 of 100 ticks</source>
        <translation>Verspätung von 99 von 100 Takten</translation>
    </message>
    <message>
        <source>Lateness, the latest tick</source>
        <translation>Verspätung des spätesten Takts</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Real-time priority</source>
        <translation>Echtzeitpriorität</translation>
    </message>
    <message>
        <source>recommended</source>
        <translation>empfohlen</translation>
    </message>
    <message>
        <source>Memory locked</source>
        <translation>Arbeitsspeicher gesperrt</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message numerus="yes">
        <source>Measured values and their limits, the worst of %n finger(s)</source>
        <translation>
            <numerusform>Messwerte und ihre Grenzen, an %n Finger</numerusform>
            <numerusform>Messwerte und ihre Grenzen, der schlechteste von %n Fingern</numerusform>
        </translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>Force error by the platform&apos;s own sensors (root mean square)</source>
        <translation>Kraftfehler nach den eigenen Sensoren der Plattform (quadratisches Mittel)</translation>
    </message>
    <message>
        <source>Force error on the finger pad (root mean square)</source>
        <translation>Kraftfehler an der Fingerkuppe (quadratisches Mittel)</translation>
    </message>
    <message>
        <source>Orientation error by the platform&apos;s own sensor</source>
        <translation>Fehler der Ausrichtung nach dem eigenen Sensor der Plattform</translation>
    </message>
    <message>
        <source>Orientation error, true</source>
        <translation>Fehler der Ausrichtung, tatsächlich</translation>
    </message>
    <message>
        <source>Overshoot of a step of force</source>
        <translation>Überschwingen bei einem Kraftsprung</translation>
    </message>
    <message>
        <source>Largest force on the finger pad</source>
        <translation>Größte Kraft an der Fingerkuppe</translation>
    </message>
    <message>
        <source>Station check: timing of the force loop</source>
        <translation>Prüfung des Arbeitsplatzes: Zeitverhalten der Kraftregelung</translation>
    </message>
    <message>
        <source>Passed. %1</source>
        <translation>Bestanden. %1</translation>
    </message>
    <message>
        <source>Failed. %1</source>
        <translation>Nicht bestanden. %1</translation>
    </message>
    <message>
        <source>not reported by the device</source>
        <translation>vom Gerät nicht angegeben</translation>
    </message>
</context>
<context>
    <name>StationWords</name>
    <message>
        <source>Force is felt</source>
        <translation>Kraft wird gefühlt</translation>
    </message>
    <message>
        <source>Force is shown, not felt</source>
        <translation>Kraft wird gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>The force loop has real-time priority.</source>
        <translation>Die Kraftregelung läuft mit Echtzeitpriorität.</translation>
    </message>
    <message>
        <source>The force loop has no real-time priority: under load, touch may feel rough.</source>
        <translation>Die Kraftregelung läuft ohne Echtzeitpriorität: Unter Last kann sich die Berührung rau anfühlen.</translation>
    </message>
    <message>
        <source>To permit it, the administrator of this computer adds two lines to a file in /etc/security/limits.d, where &quot;group&quot; is the group of those who train: &quot;@group - rtprio 80&quot; and &quot;@group - memlock unlimited&quot;. It takes effect at the next login to the computer.</source>
        <translation>Um das zu erlauben, trägt die Systemadministration dieses Computers zwei Zeilen in eine Datei in /etc/security/limits.d ein; „group“ steht für die Gruppe derer, die trainieren: „@group - rtprio 80“ und „@group - memlock unlimited“. Das gilt ab der nächsten Anmeldung am Computer.</translation>
    </message>
    <message>
        <source>Memory is locked: nothing the loop needs can be swapped out.</source>
        <translation>Der Arbeitsspeicher ist gesperrt: Nichts, was die Regelung braucht, kann ausgelagert werden.</translation>
    </message>
    <message>
        <source>Memory is not locked: when it runs short, the loop may have to wait for the disk.</source>
        <translation>Der Arbeitsspeicher ist nicht gesperrt: Wird er knapp, muss die Regelung womöglich auf die Festplatte warten.</translation>
    </message>
    <message>
        <source>%1 ticks of 1 ms. Half of them started within %2 µs, 99 of 100 within %3 µs, the latest after %4 µs. %5 were more than 100 µs late, %6 were skipped.</source>
        <translation>%1 Takte von 1 ms. Die Hälfte begann innerhalb von %2 µs, 99 von 100 innerhalb von %3 µs, der späteste nach %4 µs. %5 kamen mehr als 100 µs zu spät, %6 fielen aus.</translation>
    </message>
    <message numerus="yes">
        <source>The loop does not run on time: %n tick(s) were skipped. Close other programs, or permit real-time priority.</source>
        <translation>
            <numerusform>Die Kraftregelung ist nicht pünktlich: %n Takt fiel aus. Schließen Sie andere Programme oder erlauben Sie Echtzeitpriorität.</numerusform>
            <numerusform>Die Kraftregelung ist nicht pünktlich: %n Takte fielen aus. Schließen Sie andere Programme oder erlauben Sie Echtzeitpriorität.</numerusform>
        </translation>
    </message>
    <message>
        <source>The loop runs on time: %1 % of the ticks were late (limit %2 %), and none was skipped.</source>
        <translation>Die Kraftregelung ist pünktlich: %1 % der Takte kamen zu spät (Grenze %2 %), und keiner fiel aus.</translation>
    </message>
    <message>
        <source>The loop does not run on time: %1 % of the ticks were late (limit %2 %). Close other programs, or permit real-time priority.</source>
        <translation>Die Kraftregelung ist nicht pünktlich: %1 % der Takte kamen zu spät (Grenze %2 %). Schließen Sie andere Programme oder erlauben Sie Echtzeitpriorität.</translation>
    </message>
</context>
<context>
    <name>StorageWords</name>
    <message>
        <source>The disk is full: only %1 is free. Sessions might not be saved. Free up space before anybody trains.</source>
        <translation>Die Festplatte ist voll: Nur noch %1 sind frei. Sitzungen werden womöglich nicht gespeichert. Schaffen Sie Platz, bevor jemand trainiert.</translation>
    </message>
    <message>
        <source>There is no room for the safety copy of a running session (%1 needed, %2 free in memory). Sessions cannot start. Close other programs.</source>
        <translation>Für die Sicherheitskopie einer laufenden Sitzung fehlt Platz (%1 nötig, %2 im Arbeitsspeicher frei). Sitzungen können nicht starten. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>The disk is getting full: %1 is free. Sessions can still be recorded. Free up space, or move backups to another disk.</source>
        <translation>Die Festplatte wird voll: %1 sind frei. Sitzungen können noch aufgezeichnet werden. Schaffen Sie Platz oder verschieben Sie Sicherungen auf eine andere Festplatte.</translation>
    </message>
    <message>
        <source>Memory for the safety copy of running sessions is running low: %1 is free.</source>
        <translation>Der Arbeitsspeicher für die Sicherheitskopie laufender Sitzungen wird knapp: %1 sind frei.</translation>
    </message>
    <message>
        <source>There is enough room: %1 is free.</source>
        <translation>Es ist genug Platz: %1 sind frei.</translation>
    </message>
    <message>
        <source>There is no backup yet. What is recorded exists only once.</source>
        <translation>Es gibt noch keine Sicherung. Aufgezeichnetes ist nur einmal vorhanden.</translation>
    </message>
    <message>
        <source>The last backup was made %1. Make a new one.</source>
        <translation>Letzte Sicherung: %1. Erstellen Sie eine neue.</translation>
    </message>
    <message>
        <source>The last backup was made %1.</source>
        <translation>Letzte Sicherung: %1.</translation>
    </message>
    <message>
        <source>The file is damaged</source>
        <translation>Die Datei ist beschädigt</translation>
    </message>
    <message>
        <source>A record was changed</source>
        <translation>Ein Datensatz wurde verändert</translation>
    </message>
    <message>
        <source>Recorded data was changed</source>
        <translation>Aufgezeichnete Daten wurden verändert</translation>
    </message>
    <message>
        <source>Something is missing</source>
        <translation>Etwas fehlt</translation>
    </message>
    <message>
        <source>It cannot be read</source>
        <translation>Nicht lesbar</translation>
    </message>
    <message>
        <source>A session was changed after it ended</source>
        <translation>Eine Sitzung wurde nach ihrem Ende verändert</translation>
    </message>
    <message>
        <source>The audit trail is not intact</source>
        <translation>Das Prüfprotokoll ist nicht intakt</translation>
    </message>
    <message>
        <source>A score does not match its recording</source>
        <translation>Eine Wertung passt nicht zu ihrer Aufzeichnung</translation>
    </message>
    <message>
        <source>Something is wrong</source>
        <translation>Etwas stimmt nicht</translation>
    </message>
    <message numerus="yes">
        <source>The check found %n error(s). Nothing was changed. Keep this database as it is and restore a backup that passes the check.</source>
        <translation>
            <numerusform>Die Prüfung fand %n Fehler. Es wurde nichts geändert. Lassen Sie diese Datenbank, wie sie ist, und stellen Sie eine Sicherung wieder her, die die Prüfung besteht.</numerusform>
            <numerusform>Die Prüfung fand %n Fehler. Es wurde nichts geändert. Lassen Sie diese Datenbank, wie sie ist, und stellen Sie eine Sicherung wieder her, die die Prüfung besteht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The check was stopped after %1 records. It had found no errors until then.</source>
        <translation>Die Prüfung wurde nach %1 Datensätzen abgebrochen. Bis dahin wurde kein Fehler gefunden.</translation>
    </message>
    <message>
        <source>No errors were found: %1 records, every recording, every score and the audit trail were checked.</source>
        <translation>Kein Fehler gefunden: %1 Datensätze, jede Aufzeichnung, jede Wertung und das Prüfprotokoll wurden geprüft.</translation>
    </message>
    <message>
        <source>Automatic backups are off. Only backups that you make yourself protect what is recorded.</source>
        <translation>Automatische Sicherungen sind ausgeschaltet. Nur Sicherungen, die Sie selbst erstellen, schützen das Aufgezeichnete.</translation>
    </message>
    <message>
        <source>The first automatic backup is made when nobody has used the program for a few minutes, or when it closes.</source>
        <translation>Die erste automatische Sicherung wird erstellt, sobald einige Minuten lang niemand das Programm benutzt hat oder wenn es beendet wird.</translation>
    </message>
    <message>
        <source>The latest automatic backup was made and checked on %1 (%2).</source>
        <translation>Die letzte automatische Sicherung wurde am %1 erstellt und geprüft (%2).</translation>
    </message>
    <message>
        <source>The backups are on the same disk as the site: if that disk fails, both are lost. Choose a folder on another disk, on a USB drive or on the network.</source>
        <translation>Die Sicherungen liegen auf derselben Festplatte wie der Standort: Fällt sie aus, ist beides verloren. Wählen Sie einen Ordner auf einer anderen Festplatte, einem USB-Laufwerk oder im Netzwerk.</translation>
    </message>
    <message>
        <source>An automatic backup failed %1. It will be tried again; in the meantime, make one yourself.
Details: %2</source>
        <translation>Eine automatische Sicherung ist fehlgeschlagen (%1). Es wird erneut versucht; erstellen Sie in der Zwischenzeit selbst eine.
Einzelheiten: %2</translation>
    </message>
</context>
<context>
    <name>StudyControls</name>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Move the mouse, or use the arrow keys.</source>
        <translation>Bewegen Sie die Maus oder nehmen Sie die Pfeiltasten.</translation>
    </message>
    <message>
        <source>Take the handle and move it over the objects.</source>
        <translation>Nehmen Sie den Griff und bewegen Sie ihn über die Objekte.</translation>
    </message>
    <message>
        <source>Take hold and pull</source>
        <translation>Greifen und ziehen</translation>
    </message>
    <message>
        <source>Press</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Click, or press Enter, while the tool is at the place.</source>
        <translation>Klicken Sie oder drücken Sie Enter, während das Instrument an der Stelle ist.</translation>
    </message>
    <message>
        <source>Press the button of the handle, or Enter, while the tip is at the place.</source>
        <translation>Drücken Sie den Knopf am Griff oder Enter, während die Spitze an der Stelle ist.</translation>
    </message>
    <message>
        <source>Press 1, 2 or 3 from least to most, then Enter. Backspace takes the last one back.</source>
        <translation>Drücken Sie 1, 2 oder 3 vom Geringsten zum Größten, dann Enter. Die Rücktaste nimmt die letzte Angabe zurück.</translation>
    </message>
    <message>
        <source>Press 1 for the same, 2 for different.</source>
        <translation>Drücken Sie 1 für gleich, 2 für verschieden.</translation>
    </message>
    <message>
        <source>Press Y for yes, N for no.</source>
        <translation>Drücken Sie Y für Ja, N für Nein.</translation>
    </message>
    <message>
        <source>Type a number, then press Enter.</source>
        <translation>Geben Sie eine Zahl ein und drücken Sie Enter.</translation>
    </message>
    <message>
        <source>Press the number of the object: 1, 2 or 3.</source>
        <translation>Drücken Sie die Nummer des Objekts: 1, 2 oder 3.</translation>
    </message>
    <message>
        <source>Press the number of the object, or the button of the handle while you touch it.</source>
        <translation>Drücken Sie die Nummer des Objekts oder den Knopf am Griff, während Sie es berühren.</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>%1 The answers can be clicked as well.</source>
        <translation>%1 Die Antworten können auch angeklickt werden.</translation>
    </message>
    <message>
        <source>Press the number of the object: 1 or 2.</source>
        <translation>Drücken Sie die Nummer des Objekts: 1 oder 2.</translation>
    </message>
    <message>
        <source>Press + and − until both seem the same, then Enter.</source>
        <translation>Drücken Sie + und −, bis Ihnen beide gleich vorkommen, dann Enter.</translation>
    </message>
    <message>
        <source>Press 1, 2 or 3 from least to most, with = before one that equals the last, then Enter. Backspace takes the last one back.</source>
        <translation>Drücken Sie 1, 2 oder 3 vom Geringsten zum Größten, mit = vor einem, das dem letzten gleicht, dann Enter. Die Rücktaste nimmt die letzte Angabe zurück.</translation>
    </message>
    <message>
        <source>To let go, lower the tool %1 mm below the ring, then raise it.</source>
        <translation>Zum Loslassen senken Sie das Instrument %1 mm unter den Ring, dann heben Sie es.</translation>
    </message>
    <message>
        <source>To raise the tool, roll the wheel away from you, or hold Page Up.</source>
        <translation>Um das Instrument zu heben, drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>Raise the handle to come off.</source>
        <translation>Heben Sie den Griff, um das Objekt zu verlassen.</translation>
    </message>
    <message>
        <source>Take hold and lift</source>
        <translation>Greifen und heben</translation>
    </message>
    <message>
        <source>To lift, roll the wheel away from you, or hold Page Up.</source>
        <translation>Zum Heben drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>To lift, raise the handle.</source>
        <translation>Zum Heben heben Sie den Griff.</translation>
    </message>
    <message>
        <source>Put down and let go</source>
        <translation>Absetzen und loslassen</translation>
    </message>
    <message>
        <source>To pull, roll the wheel away from you, or hold Page Up.</source>
        <translation>Zum Ziehen drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>To pull, raise the handle.</source>
        <translation>Zum Ziehen heben Sie den Griff.</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>Press lightly and stroke</source>
        <translation>Leicht drücken und streichen</translation>
    </message>
    <message>
        <source>Then move the mouse, or use the arrow keys.</source>
        <translation>Bewegen Sie dann die Maus oder nehmen Sie die Pfeiltasten.</translation>
    </message>
    <message>
        <source>Then move it to and fro.</source>
        <translation>Bewegen Sie sie dann hin und her.</translation>
    </message>
    <message>
        <source>Move the tool over a ring and lower it into the ring: roll the wheel towards you, or hold Page Down.</source>
        <translation>Bewegen Sie das Instrument über einen Ring und senken Sie es in den Ring: Drehen Sie das Rad zu sich hin oder halten Sie Bild ab.</translation>
    </message>
    <message>
        <source>Move the tip over a ring and lower it into the ring.</source>
        <translation>Bewegen Sie die Spitze über einen Ring und senken Sie sie in den Ring.</translation>
    </message>
    <message>
        <source>Move the tool over an object and lower it onto the object: roll the wheel towards you, or hold Page Down.</source>
        <translation>Bewegen Sie das Instrument über ein Objekt und senken Sie es auf das Objekt: Drehen Sie das Rad zu sich hin oder halten Sie Bild ab.</translation>
    </message>
    <message>
        <source>Move the tip over an object and push it gently into the object.</source>
        <translation>Bewegen Sie die Spitze über ein Objekt und drücken Sie sie sanft in das Objekt.</translation>
    </message>
    <message>
        <source>To let go, lower the tool below the dashed line (roll the wheel towards you, or hold Page Down), then raise it.</source>
        <translation>Zum Loslassen senken Sie das Instrument unter die gestrichelte Linie (Rad zu sich hin drehen oder Bild ab halten), dann heben Sie es.</translation>
    </message>
    <message>
        <source>To let go, lower the tip below the dashed line, then raise it.</source>
        <translation>Zum Loslassen senken Sie die Spitze unter die gestrichelte Linie, dann heben Sie sie.</translation>
    </message>
    <message>
        <source>Lift it off the table: roll the wheel away from you, or hold Page Up.</source>
        <translation>Heben Sie es vom Tisch: Drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>Lift it off the table.</source>
        <translation>Heben Sie es vom Tisch.</translation>
    </message>
    <message>
        <source>You are holding the object.</source>
        <translation>Sie halten das Objekt.</translation>
    </message>
    <message>
        <source>You are holding object %1.</source>
        <translation>Sie halten Objekt %1.</translation>
    </message>
    <message>
        <source>To put it down, lower it to the table: roll the wheel towards you, or hold Page Down.</source>
        <translation>Zum Absetzen senken Sie es auf den Tisch: Drehen Sie das Rad zu sich hin oder halten Sie Bild ab.</translation>
    </message>
    <message>
        <source>To put it down, lower it to the table.</source>
        <translation>Zum Absetzen senken Sie es auf den Tisch.</translation>
    </message>
    <message>
        <source>You are lifting the object.</source>
        <translation>Sie heben das Objekt.</translation>
    </message>
    <message>
        <source>You are lifting object %1.</source>
        <translation>Sie heben Objekt %1.</translation>
    </message>
    <message>
        <source>The object stands on the table, and you still hold it.</source>
        <translation>Das Objekt steht auf dem Tisch, und Sie halten es noch.</translation>
    </message>
    <message>
        <source>Object %1 stands on the table, and you still hold it.</source>
        <translation>Objekt %1 steht auf dem Tisch, und Sie halten es noch.</translation>
    </message>
    <message>
        <source>Now raise the tool: the object stays on the table.</source>
        <translation>Heben Sie jetzt das Instrument: Das Objekt bleibt auf dem Tisch.</translation>
    </message>
    <message>
        <source>Now raise the tool: object %1 stays on the table.</source>
        <translation>Heben Sie jetzt das Instrument: Objekt %1 bleibt auf dem Tisch.</translation>
    </message>
    <message>
        <source>Without a wheel, hold the right mouse button or Shift and move the mouse forward to raise the tool, back to lower it. %1 T frees the pointer, so that the answers can be clicked as well; a click in the scene takes it back and does not count as an answer.</source>
        <translation>Ohne Rad halten Sie die rechte Maustaste oder die Umschalttaste und bewegen die Maus nach vorn, um das Instrument zu heben, und zurück, um es zu senken. %1 T gibt den Zeiger frei, sodass die Antworten auch angeklickt werden können; ein Klick in die Szene holt ihn zurück und ist keine Antwort.</translation>
    </message>
    <message>
        <source>Lift the tool off.</source>
        <translation>Heben Sie das Instrument ab.</translation>
    </message>
    <message>
        <source>Raise the tool.</source>
        <translation>Heben Sie das Instrument.</translation>
    </message>
    <message>
        <source>Raise the handle.</source>
        <translation>Heben Sie den Griff.</translation>
    </message>
    <message>
        <source>To put the object down, roll the wheel towards you, or hold Page Down, until the object stands on the table, and at least %1 mm further. Then raise the tool: the object stays there.</source>
        <translation>Zum Absetzen drehen Sie das Rad zu sich hin oder halten Sie Bild ab, bis das Objekt auf dem Tisch steht, und noch mindestens %1 mm weiter. Heben Sie dann das Instrument: Das Objekt bleibt stehen.</translation>
    </message>
    <message>
        <source>To put the object down, lower it onto the table and press it down with at least %1 N. Then raise the handle: the object stays there.</source>
        <translation>Zum Absetzen senken Sie das Objekt auf den Tisch und drücken Sie es mit mindestens %1 N an. Heben Sie dann den Griff: Das Objekt bleibt stehen.</translation>
    </message>
    <message>
        <source>To let go, lower the tool at least %1 mm further, then raise it.</source>
        <translation>Zum Loslassen senken Sie das Instrument mindestens %1 mm weiter, dann heben Sie es.</translation>
    </message>
    <message>
        <source>To let go, press it onto the table with at least %1 N, then raise the handle.</source>
        <translation>Zum Loslassen drücken Sie es mit mindestens %1 N auf den Tisch, dann heben Sie den Griff.</translation>
    </message>
</context>
<context>
    <name>StudyData</name>
    <message>
        <source>Participant and condition</source>
        <translation>Teilnehmende Person und Bedingung</translation>
    </message>
</context>
<context>
    <name>StudyDevice</name>
    <message>
        <source>The device of this station renders no force: objects are shown, not felt. Such runs are left out of groups and comparisons unless you include them under Data.</source>
        <translation>Das Gerät dieses Arbeitsplatzes gibt keine Kraft aus: Objekte werden gezeigt, nicht gefühlt. Solche Läufe zählen nicht in Gruppen und Vergleichen, es sei denn, Sie beziehen sie unter „Daten“ ein.</translation>
    </message>
</context>
<context>
    <name>StudyReport</name>
    <message>
        <source>Study report</source>
        <translation>Studienbericht</translation>
    </message>
    <message>
        <source>DEMONSTRATION: invented people and results</source>
        <translation>DEMONSTRATION: erfundene Personen und Ergebnisse</translation>
    </message>
    <message numerus="yes">
        <source>SIMULATED: %n participant(s) are programs, not people</source>
        <translation>
            <numerusform>SIMULIERT: %n Teilnehmer ist ein Programm, keine Person</numerusform>
            <numerusform>SIMULIERT: %n Teilnehmer sind Programme, keine Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>BLINDED: conditions carry sealed codes until the study is unblinded</source>
        <translation>VERBLINDET: Bedingungen tragen versiegelte Codes, bis die Studie entblindet ist</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Frozen on</source>
        <translation>Eingefroren am</translation>
    </message>
    <message>
        <source>Participants, planned</source>
        <translation>Teilnehmende, geplant</translation>
    </message>
    <message>
        <source>Scored trials</source>
        <translation>Gewertete Durchgänge</translation>
    </message>
    <message>
        <source>Order of conditions</source>
        <translation>Reihenfolge der Bedingungen</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Participants blinded</source>
        <translation>Teilnehmende verblindet</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Experimenters blinded</source>
        <translation>Versuchsleitung verblindet</translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>entblindet</translation>
    </message>
    <message>
        <source>Frozen design (SHA-256)</source>
        <translation>Eingefrorener Entwurf (SHA-256)</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Nobody takes part yet.</source>
        <translation>Noch nimmt niemand teil.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Person or simulated</source>
        <translation>Person oder simuliert</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Conditions done</source>
        <translation>Bedingungen erledigt</translation>
    </message>
    <message>
        <source>Fidelity</source>
        <translation>Wiedergabetreue</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Gewertet</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Why repeated</source>
        <translation>Warum wiederholt</translation>
    </message>
    <message>
        <source>Choices reproduced</source>
        <translation>Auswahl reproduziert</translation>
    </message>
    <message>
        <source>A trial is repeated when the force is off by more than %1 N, the felt value by more than %2, more than %3 of the ticks are late, or the device is at its limit for more than %4 of the contact.</source>
        <translation>Ein Durchgang wird wiederholt, wenn die Kraft um mehr als %1 N oder der gefühlte Wert um mehr als %2 abweicht, mehr als %3 der Takte verspätet sind oder das Gerät während mehr als %4 des Kontakts an seiner Grenze ist.</translation>
    </message>
    <message>
        <source>Choices reproduced: when run again from its log, the procedure chose the same presentations.</source>
        <translation>Auswahl reproduziert: Beim erneuten Ablauf aus dem Protokoll wählte das Verfahren dieselben Darbietungen.</translation>
    </message>
    <message>
        <source>No answers</source>
        <translation>Keine Antworten</translation>
    </message>
    <message numerus="yes">
        <source>%n free text(s), in the exported tables</source>
        <translation>
            <numerusform>%n Freitext, in den exportierten Tabellen</numerusform>
            <numerusform>%n Freitexte, in den exportierten Tabellen</numerusform>
        </translation>
    </message>
    <message>
        <source>Median %1, interquartile range %2 to %3, n = %4</source>
        <translation>Median %1, Interquartilbereich %2 bis %3, n = %4</translation>
    </message>
    <message>
        <source>Question</source>
        <translation>Frage</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Difference from the reference (%)</source>
        <translation>Unterschied zur Referenz (%)</translation>
    </message>
    <message>
        <source>Proportion correct</source>
        <translation>Anteil richtiger Antworten</translation>
    </message>
    <message>
        <source>95 % band</source>
        <translation>95-%-Band</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>Anpassung</translation>
    </message>
    <message>
        <source>criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Nobody has done this condition yet.</source>
        <translation>Diese Bedingung hat noch niemand durchlaufen.</translation>
    </message>
    <message>
        <source>Weber fraction of the group</source>
        <translation>Weber-Bruch der Gruppe</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>95 % prediction interval</source>
        <translation>95-%-Vorhersageintervall</translation>
    </message>
    <message>
        <source>JND at the reference</source>
        <translation>JND an der Referenz</translation>
    </message>
    <message>
        <source>Point of subjective equality</source>
        <translation>Punkt subjektiver Gleichheit</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Exponent des Potenzgesetzes</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message>
        <source>group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Scheitel</translation>
    </message>
    <message>
        <source>Ranking of three</source>
        <translation>Rangfolge von dreien</translation>
    </message>
    <message>
        <source>Two alternatives (2AFC)</source>
        <translation>Zwei Alternativen (2AFC)</translation>
    </message>
    <message>
        <source>Three alternatives (3AFC)</source>
        <translation>Drei Alternativen (3AFC)</translation>
    </message>
    <message>
        <source>Odd one out of three</source>
        <translation>Eines von dreien ist anders</translation>
    </message>
    <message>
        <source>Same or different</source>
        <translation>Gleich oder verschieden</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja oder nein</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Wie aufgeführt</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Lateinisches Quadrat</translation>
    </message>
    <message>
        <source>Williams design</source>
        <translation>Williams-Plan</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Eingefroren</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archiviert</translation>
    </message>
    <message>
        <source>Consent missing</source>
        <translation>Einwilligung fehlt</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Nimmt teil</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Force not as commanded</source>
        <translation>Kraft weicht vom Sollwert ab</translation>
    </message>
    <message>
        <source>Felt value off</source>
        <translation>Gefühlter Wert weicht ab</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Device at its limit</source>
        <translation>Gerät an seiner Grenze</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Zu schnell bewegt</translation>
    </message>
    <message>
        <source>Pressed too hard</source>
        <translation>Zu fest gedrückt</translation>
    </message>
    <message>
        <source>Time was up</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>Not all touched</source>
        <translation>Nicht alle berührt</translation>
    </message>
    <message>
        <source>Discarded by the experimenter</source>
        <translation>Von der Versuchsleitung verworfen</translation>
    </message>
    <message>
        <source>No mark yet</source>
        <translation>Noch keine Markierung</translation>
    </message>
    <message>
        <source>Marks around the true apex</source>
        <translation>Markierungen um den wahren Scheitel</translation>
    </message>
    <message>
        <source>Error in x (% of radius)</source>
        <translation>Fehler in x (% des Radius)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Fehler in y (% des Radius)</translation>
    </message>
    <message>
        <source>radius R</source>
        <translation>Radius R</translation>
    </message>
    <message>
        <source>bias</source>
        <translation>Verschiebung</translation>
    </message>
    <message>
        <source>± 1 SD per axis</source>
        <translation>± 1 SD je Achse</translation>
    </message>
    <message>
        <source>Error in locating spheres</source>
        <translation>Fehler bei der Lokalisation der Kugeln</translation>
    </message>
    <message>
        <source>Absolute error (% of radius)</source>
        <translation>Absoluter Fehler (% des Radius)</translation>
    </message>
    <message>
        <source>mean over both axes ± SD</source>
        <translation>Mittel beider Achsen ± SD</translation>
    </message>
    <message>
        <source>published: %1 %</source>
        <translation>veröffentlicht: %1 %</translation>
    </message>
    <message>
        <source>%1 of R</source>
        <translation>%1 von R</translation>
    </message>
    <message>
        <source>%1 mm, %2</source>
        <translation>%1 mm, %2</translation>
    </message>
    <message>
        <source>Bias in x</source>
        <translation>Verschiebung in x</translation>
    </message>
    <message>
        <source>Bias in y</source>
        <translation>Verschiebung in y</translation>
    </message>
    <message>
        <source>Marks, participants</source>
        <translation>Markierungen, Teilnehmende</translation>
    </message>
    <message>
        <source>SD in x</source>
        <translation>SD in x</translation>
    </message>
    <message>
        <source>SD in y</source>
        <translation>SD in y</translation>
    </message>
    <message>
        <source>Mean absolute error ± SD</source>
        <translation>Mittlerer absoluter Fehler ± SD</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>There is no mark to summarise.</source>
        <translation>Es gibt keine Markierung.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) have no mark and are left out.</source>
        <translation>
            <numerusform>%n Durchgang ohne Markierung ist ausgelassen.</numerusform>
            <numerusform>%n Durchgänge ohne Markierung sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With only %n participant(s), differences between people are very uncertain.</source>
        <translation>
            <numerusform>Nur %n Person: Über Unterschiede zwischen Personen ist kaum etwas bekannt.</numerusform>
            <numerusform>Nur %n Personen: Über Unterschiede zwischen Personen ist kaum etwas bekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Some participants have fewer than 10 marks.</source>
        <translation>Manche Personen haben weniger als 10 Markierungen.</translation>
    </message>
    <message>
        <source>Errors in x lean to one side: the absolute error is not only scatter.</source>
        <translation>Fehler in x liegen überwiegend auf einer Seite: Der absolute Fehler ist nicht nur Streuung.</translation>
    </message>
    <message>
        <source>Errors in y lean to one side: the absolute error is not only scatter.</source>
        <translation>Fehler in y liegen überwiegend auf einer Seite: Der absolute Fehler ist nicht nur Streuung.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) lie off the sphere.</source>
        <translation>
            <numerusform>%n Markierung liegt neben der Kugel.</numerusform>
            <numerusform>%n Markierungen liegen neben der Kugel.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) were set without touching anything.</source>
        <translation>
            <numerusform>%n Markierung wurde ohne Berührung gesetzt.</numerusform>
            <numerusform>%n Markierungen wurden ohne Berührung gesetzt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) who withdrew are left out.</source>
        <translation>
            <numerusform>%n Person, die ihre Teilnahme zurückgezogen hat, zählt nicht mit.</numerusform>
            <numerusform>%n Personen, die ihre Teilnahme zurückgezogen haben, zählen nicht mit.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n simulated participant(s) are left out: the group contains only people.</source>
        <translation>
            <numerusform>%n simulierte Person ist ausgelassen: Die Gruppe besteht nur aus Menschen.</numerusform>
            <numerusform>%n simulierte Personen sind ausgelassen: Die Gruppe besteht nur aus Menschen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 (p &lt; %2)</source>
        <translation>%1 (p &lt; %2)</translation>
    </message>
    <message>
        <source>%1 (p = %2)</source>
        <translation>%1 (p = %2)</translation>
    </message>
    <message>
        <source>reference</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>D more</source>
        <translation>D mehr</translation>
    </message>
    <message>
        <source>2D more</source>
        <translation>2D mehr</translation>
    </message>
    <message>
        <source>Not estimable</source>
        <translation>Nicht schätzbar</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>Schätzung mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Rankings</source>
        <translation>Rangfolgen</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Richtig</translation>
    </message>
    <message>
        <source>Kendall&apos;s τ</source>
        <translation>Kendalls τ</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>Kendalls W</translation>
    </message>
    <message>
        <source>Page&apos;s L</source>
        <translation>Pages L</translation>
    </message>
    <message>
        <source>The worths cannot be estimated: one object was always, or never, ranked above the others.</source>
        <translation>Die Werte lassen sich nicht schätzen: Ein Objekt stand immer oder nie über den anderen.</translation>
    </message>
    <message>
        <source>Bradley-Terry</source>
        <translation>Bradley-Terry</translation>
    </message>
    <message>
        <source>ln worth</source>
        <translation>ln Wert</translation>
    </message>
    <message>
        <source>Plackett-Luce</source>
        <translation>Plackett-Luce</translation>
    </message>
    <message>
        <source>Thurstone</source>
        <translation>Thurstone</translation>
    </message>
    <message>
        <source>Scale (SD)</source>
        <translation>Skala (SD)</translation>
    </message>
    <message>
        <source>Worth of each object, from all rankings of the group: how much more often it was ranked above the others. The farther apart two objects are, the easier they are to tell apart. All differences D are pooled.</source>
        <translation>Wert jedes Objekts aus allen Rangfolgen der Gruppe: wie viel öfter es über den anderen stand. Je weiter zwei Objekte auseinanderliegen, desto leichter sind sie zu unterscheiden. Alle Unterschiede D sind zusammengefasst.</translation>
    </message>
    <message>
        <source>Sealed reason</source>
        <translation>Versiegelter Grund</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) could not be used: the difference or the answer is missing.</source>
        <translation>
            <numerusform>%n Durchgang ist nicht verwendbar: Unterschied oder Antwort fehlt.</numerusform>
            <numerusform>%n Durchgänge sind nicht verwendbar: Unterschied oder Antwort fehlt.</numerusform>
        </translation>
    </message>
    <message>
        <source>There is no scored trial yet, so there is no result.</source>
        <translation>Es gibt noch keinen gewerteten Durchgang und deshalb kein Ergebnis.</translation>
    </message>
    <message numerus="yes">
        <source>Only %n trial(s): the interval is wide and depends partly on prior assumptions.</source>
        <translation>
            <numerusform>Nur %n Durchgang: Das Intervall ist breit und beruht zum Teil auf Vorannahmen.</numerusform>
            <numerusform>Nur %n Durchgänge: Das Intervall ist breit und beruht zum Teil auf Vorannahmen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The objects never differed, so it is not known how well they are told apart.</source>
        <translation>Die Objekte unterschieden sich nie; wie gut sie unterschieden werden, ist deshalb nicht bekannt.</translation>
    </message>
    <message>
        <source>Only one difference was presented: lapses of attention cannot be distinguished from a high threshold.</source>
        <translation>Es wurde nur ein Unterschied dargeboten: Unaufmerksamkeit lässt sich nicht von einer hohen Schwelle unterscheiden.</translation>
    </message>
    <message>
        <source>A great many differences were presented; neighbouring ones were grouped.</source>
        <translation>Es wurden sehr viele Unterschiede dargeboten; benachbarte wurden zusammengefasst.</translation>
    </message>
    <message>
        <source>The same answer was given every time: it says nothing about what was felt.</source>
        <translation>Jedes Mal wurde dasselbe geantwortet: Das sagt nichts darüber, was gefühlt wurde.</translation>
    </message>
    <message>
        <source>The answers are no better than guessing: the threshold may be above the largest difference presented.</source>
        <translation>Die Antworten sind nicht besser als geraten: Die Schwelle liegt vielleicht über dem größten dargebotenen Unterschied.</translation>
    </message>
    <message>
        <source>More than a tenth of the answers look like guesses even where the difference was easy.</source>
        <translation>Mehr als ein Zehntel der Antworten sieht auch dort nach Raten aus, wo der Unterschied leicht war.</translation>
    </message>
    <message>
        <source>Answers jump from guessing to always right between two neighbouring differences: what lies between is not known.</source>
        <translation>Zwischen zwei benachbarten Unterschieden springen die Antworten von geraten auf immer richtig: Was dazwischen liegt, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Wrong answers name one position much more often than chance would explain.</source>
        <translation>Falsche Antworten nennen eine Position viel öfter, als durch Zufall zu erwarten ist.</translation>
    </message>
    <message>
        <source>The conditions differ in values that the analysis needs: there will be an estimate once the study is unblinded.</source>
        <translation>Die Bedingungen unterscheiden sich in Werten, die die Auswertung braucht: Eine Schätzung gibt es, sobald die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>A quick simulation without rendering: the observer knew the values.</source>
        <translation>Eine schnelle Simulation ohne Darstellung: Der Beobachter kannte die Werte.</translation>
    </message>
    <message>
        <source>The answers do not tell how small the threshold is: the value shown comes from prior assumptions.</source>
        <translation>Die Antworten sagen nicht, wie klein die Schwelle ist: Der gezeigte Wert beruht auf Vorannahmen.</translation>
    </message>
    <message>
        <source>The answers do not tell how large the threshold is: the value shown comes from prior assumptions.</source>
        <translation>Die Antworten sagen nicht, wie groß die Schwelle ist: Der gezeigte Wert beruht auf Vorannahmen.</translation>
    </message>
    <message>
        <source>The lower end of the interval comes from prior assumptions, not from the answers.</source>
        <translation>Das untere Ende des Intervalls beruht auf Vorannahmen, nicht auf den Antworten.</translation>
    </message>
    <message>
        <source>The upper end of the interval comes from prior assumptions, not from the answers.</source>
        <translation>Das obere Ende des Intervalls beruht auf Vorannahmen, nicht auf den Antworten.</translation>
    </message>
    <message>
        <source>The curve does not describe the answers well: attention or strategy may have changed.</source>
        <translation>Die Kurve beschreibt die Antworten schlecht: Aufmerksamkeit oder Vorgehen haben sich vielleicht geändert.</translation>
    </message>
    <message>
        <source>Another curve through the same answers puts the threshold elsewhere: treat the value with caution.</source>
        <translation>Eine andere Kurve durch dieselben Antworten ergibt eine andere Schwelle: Der Wert ist mit Vorsicht zu betrachten.</translation>
    </message>
    <message>
        <source>Answers do not get better as the difference grows, so there is no threshold to find.</source>
        <translation>Die Antworten werden mit wachsendem Unterschied nicht besser; eine Schwelle ist nicht zu finden.</translation>
    </message>
    <message>
        <source>Answers get worse as the difference grows: check that answers and differences match.</source>
        <translation>Die Antworten werden mit wachsendem Unterschied schlechter: Prüfen Sie, ob Antworten und Unterschiede richtig zugeordnet sind.</translation>
    </message>
    <message>
        <source>The condition has no reference above zero, so no value can be given in its unit.</source>
        <translation>Die Bedingung hat keinen Bezugswert über null; in ihrer Einheit lässt sich kein Wert angeben.</translation>
    </message>
    <message numerus="yes">
        <source>%n setting(s) are not above zero and are left out.</source>
        <translation>
            <numerusform>%n Einstellung liegt nicht über null und ist ausgelassen.</numerusform>
            <numerusform>%n Einstellungen liegen nicht über null und sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing has been set yet, so there is no result.</source>
        <translation>Es wurde noch nichts eingestellt; deshalb gibt es kein Ergebnis.</translation>
    </message>
    <message numerus="yes">
        <source>With only %n setting(s), the spread of the settings is very uncertain.</source>
        <translation>
            <numerusform>Nur %n Einstellung: Über die Streuung ist kaum etwas bekannt.</numerusform>
            <numerusform>Nur %n Einstellungen: Über die Streuung ist kaum etwas bekannt.</numerusform>
        </translation>
    </message>
    <message>
        <source>All settings are the same: the step of the adjustment may be too coarse.</source>
        <translation>Alle Einstellungen sind gleich: Die Schrittweite beim Einstellen ist vielleicht zu grob.</translation>
    </message>
    <message numerus="yes">
        <source>%n answer(s) are not numbers above zero and are left out.</source>
        <translation>
            <numerusform>%n Antwort ist keine Zahl über null und ist ausgelassen.</numerusform>
            <numerusform>%n Antworten sind keine Zahlen über null und sind ausgelassen.</numerusform>
        </translation>
    </message>
    <message>
        <source>No number has been given yet, so there is no result.</source>
        <translation>Es wurde noch keine Zahl genannt; deshalb gibt es kein Ergebnis.</translation>
    </message>
    <message numerus="yes">
        <source>With only %n answer(s), the result is very uncertain.</source>
        <translation>
            <numerusform>Nur %n Antwort: Das Ergebnis ist sehr unsicher.</numerusform>
            <numerusform>Nur %n Antworten: Das Ergebnis ist sehr unsicher.</numerusform>
        </translation>
    </message>
    <message>
        <source>Only one stimulus intensity was presented, so there is no exponent.</source>
        <translation>Es wurde nur eine Reizstärke dargeboten; deshalb gibt es keinen Exponenten.</translation>
    </message>
    <message numerus="yes">
        <source>With only %n participant(s) with an exponent, differences between people are very uncertain.</source>
        <translation>
            <numerusform>Nur %n Person mit Exponent: Über Unterschiede zwischen Personen ist kaum etwas bekannt.</numerusform>
            <numerusform>Nur %n Personen mit Exponent: Über Unterschiede zwischen Personen ist kaum etwas bekannt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out: their answers give no value.</source>
        <translation>
            <numerusform>%n Person ist ausgelassen: Ihre Antworten ergeben keinen Wert.</numerusform>
            <numerusform>%n Personen sind ausgelassen: Ihre Antworten ergeben keinen Wert.</numerusform>
        </translation>
    </message>
    <message>
        <source>No participant&apos;s answers give a value.</source>
        <translation>Bei keiner Person ergeben die Antworten einen Wert.</translation>
    </message>
    <message>
        <source>One participant is not a group: there is no interval.</source>
        <translation>Eine Person ist keine Gruppe: Es gibt kein Intervall.</translation>
    </message>
    <message>
        <source>The sphere has no radius above zero.</source>
        <translation>Die Kugel hat keinen Radius über null.</translation>
    </message>
    <message>
        <source>This condition cannot be simulated: it needs a procedure and differences.</source>
        <translation>Diese Bedingung lässt sich nicht simulieren: Sie braucht ein Verfahren und Unterschiede.</translation>
    </message>
    <message>
        <source>The largest difference is too small for this observer.</source>
        <translation>Der größte Unterschied ist für diesen Beobachter zu klein.</translation>
    </message>
    <message numerus="yes">
        <source>%n of %1 simulated run(s) gave no value.</source>
        <translation>
            <numerusform>%n von %1 simulierten Läufen ergab keinen Wert.</numerusform>
            <numerusform>%n von %1 simulierten Läufen ergaben keinen Wert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Estimated from all answers together, right and wrong</source>
        <translation>Geschätzt aus allen Antworten zusammen, richtigen wie falschen</translation>
    </message>
    <message>
        <source>Estimated from all orders given, taken together</source>
        <translation>Geschätzt aus allen genannten Reihenfolgen zusammen</translation>
    </message>
    <message>
        <source>Mean and spread of the settings</source>
        <translation>Mittelwert und Streuung der Einstellungen</translation>
    </message>
    <message>
        <source>Power law fitted to the numbers given</source>
        <translation>Potenzgesetz, an die genannten Zahlen angepasst</translation>
    </message>
    <message>
        <source>Errors of the marks</source>
        <translation>Fehler der Markierungen</translation>
    </message>
    <message>
        <source>Right: rankings with the whole order right (guessing gives 1 in 6, fewer with ties). τ: agreement with the true order (1 identical, 0 none). W: agreement among rankings (0 none, 1 complete). L: trend towards the true order. For a person, each ranking is one judgement; for the group, each person&apos;s mean ranks are one.</source>
        <translation>Richtig: Rangfolgen, deren ganze Ordnung stimmt (Raten ergibt 1 von 6, mit Gleichständen weniger). τ: Übereinstimmung mit der wahren Rangfolge (1 identisch, 0 keine). W: Übereinstimmung der Rangfolgen untereinander (0 keine, 1 völlig). L: Trend zur wahren Rangfolge. Bei einer Person ist jede Rangfolge ein Urteil, bei der Gruppe sind es die mittleren Ränge jeder Person.</translation>
    </message>
    <message>
        <source>Bradley-Terry, ties by Davidson</source>
        <translation>Bradley-Terry, Gleichstände nach Davidson</translation>
    </message>
    <message>
        <source>Ranking of three, with ties</source>
        <translation>Rangfolge von dreien, mit Gleichständen</translation>
    </message>
    <message>
        <source>People differ by more than the uncertainty of each: the group&apos;s figure says little about one person.</source>
        <translation>Die Personen unterscheiden sich um mehr als die Unsicherheit jeder einzelnen: Der Wert der Gruppe sagt wenig über eine einzelne Person.</translation>
    </message>
    <message>
        <source>data, with the number of trials</source>
        <translation>Daten, mit der Zahl der Durchgänge</translation>
    </message>
    <message>
        <source>fit: whole order right</source>
        <translation>Anpassung: ganze Reihenfolge richtig</translation>
    </message>
    <message>
        <source>same observer: pair in right order</source>
        <translation>dieselbe Person: Paar richtig geordnet</translation>
    </message>
    <message>
        <source>criterion for a pair</source>
        <translation>Kriterium für ein Paar</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gezeigt</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Over all conditions together. The number of trials is shown only for those who have done every condition.</source>
        <translation>Über alle Bedingungen zusammen. Die Zahl der Durchgänge steht nur bei denen, die jede Bedingung erledigt haben.</translation>
    </message>
    <message>
        <source>The result, the time and the number of trials stay sealed until the study is unblinded.</source>
        <translation>Ergebnis, Dauer und Zahl der Durchgänge bleiben versiegelt, bis die Studie entblindet ist.</translation>
    </message>
    <message numerus="yes">
        <source>Shown, not felt: %n trial(s) were done on a device that renders no force.</source>
        <translation>
            <numerusform>Gezeigt, nicht gefühlt: %n Durchgang lief auf einem Gerät, das keine Kraft ausgibt.</numerusform>
            <numerusform>Gezeigt, nicht gefühlt: %n Durchgänge liefen auf einem Gerät, das keine Kraft ausgibt.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are left out of the group: objects were shown to them, not felt.</source>
        <translation>
            <numerusform>%n teilnehmende Person zählt nicht zur Gruppe: Ihr wurden Objekte gezeigt, nicht fühlbar gemacht.</numerusform>
            <numerusform>%n Teilnehmende zählen nicht zur Gruppe: Ihnen wurden Objekte gezeigt, nicht fühlbar gemacht.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
    <message>
        <source>p</source>
        <translation>p</translation>
    </message>
    <message>
        <source>p, adjusted</source>
        <translation>p, adjustiert</translation>
    </message>
    <message>
        <source>p, separate thresholds</source>
        <translation>p, getrennte Schwellen</translation>
    </message>
    <message>
        <source>%1 over %2</source>
        <translation>%1 zu %2</translation>
    </message>
    <message>
        <source>Conditions compared</source>
        <translation>Bedingungen im Vergleich</translation>
    </message>
    <message>
        <source>Conditions are compared once the study is unblinded: looking at the difference while data come in would invalidate the test.</source>
        <translation>Bedingungen werden verglichen, sobald die Studie entblindet ist: Wer den Unterschied schon während der Datenerhebung ansieht, macht den Test ungültig.</translation>
    </message>
    <message>
        <source>The answers narrowed the prior to %1 of its width. Near 0 % the answers decide the result; near 100 % the prior does.</source>
        <translation>Die Antworten haben die A-priori-Verteilung auf %1 ihrer Breite eingeengt. Nahe 0 % entscheiden die Antworten über das Ergebnis, nahe 100 % die A-priori-Verteilung.</translation>
    </message>
    <message>
        <source>Each answer decided what came next, so one person&apos;s trials are not independent: they have no interval and no p.</source>
        <translation>Jede Antwort hat bestimmt, was als Nächstes kam; die Durchgänge einer Person sind deshalb nicht unabhängig: Sie haben kein Intervall und kein p.</translation>
    </message>
    <message>
        <source>95 % interval for W of the group, from its participants: %1</source>
        <translation>95-%-Intervall für W der Gruppe, berechnet über ihre Teilnehmenden: %1</translation>
    </message>
    <message>
        <source>How much of the result comes from the prior: near 0 % the answers decide it, near 100 % the prior does.</source>
        <translation>Zu welchem Anteil das Ergebnis aus der A-priori-Verteilung stammt: Nahe 0 % entscheiden die Antworten, nahe 100 % die A-priori-Verteilung.</translation>
    </message>
    <message>
        <source>Prior influence</source>
        <translation>Anteil der A-priori-Verteilung</translation>
    </message>
    <message>
        <source>Share of the prior: %1</source>
        <translation>Anteil der A-priori-Verteilung: %1</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>The group value stays sealed until the study is unblinded.</source>
        <translation>Der Gruppenwert bleibt versiegelt, bis die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>There is no group value: nobody takes part.</source>
        <translation>Es gibt keinen Gruppenwert: Niemand nimmt teil.</translation>
    </message>
    <message>
        <source>The group value includes everybody who takes part.</source>
        <translation>Der Gruppenwert umfasst alle, die teilnehmen.</translation>
    </message>
    <message>
        <source>The group value includes %1 of %2 participants.</source>
        <translation>Der Gruppenwert umfasst %1 von %2 Teilnehmenden.</translation>
    </message>
    <message>
        <source>%1: this condition was not begun, and no run can be started any more because the study is closed.</source>
        <translation>%1: Diese Bedingung wurde nicht begonnen, und weil die Studie geschlossen ist, kann kein Lauf mehr beginnen.</translation>
    </message>
    <message>
        <source>%1: this condition has not been begun. Begin it under Run.</source>
        <translation>%1: Diese Bedingung ist noch nicht begonnen. Beginnen Sie sie unter „Durchführen“.</translation>
    </message>
    <message>
        <source>%1: no answer counts yet. Resume the run under Run.</source>
        <translation>%1: Noch zählt keine Antwort. Setzen Sie den Lauf unter „Durchführen“ fort.</translation>
    </message>
    <message>
        <source>%1: the answers give no value. The warnings of the run say why.</source>
        <translation>%1: Die Antworten ergeben keinen Wert. Die Warnungen des Laufs sagen, warum.</translation>
    </message>
    <message>
        <source>%1: objects were shown, not felt. Such runs are left out unless they are included on purpose.</source>
        <translation>%1: Objekte wurden gezeigt, nicht gefühlt. Solche Läufe zählen nicht, es sei denn, sie werden ausdrücklich einbezogen.</translation>
    </message>
    <message>
        <source>%1: simulated, and therefore left out of a group of people.</source>
        <translation>%1: simuliert und deshalb nicht in einer Gruppe von Menschen.</translation>
    </message>
    <message>
        <source>%1: withdrawn, and therefore left out.</source>
        <translation>%1: Teilnahme zurückgezogen, deshalb nicht einbezogen.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are not compared yet: “%3” has no group value.</source>
        <translation>„%1“ und „%2“ werden noch nicht verglichen: „%3“ hat keinen Gruppenwert.</translation>
    </message>
    <message>
        <source>in the group value</source>
        <translation>im Gruppenwert</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>not begun</source>
        <translation>nicht begonnen</translation>
    </message>
    <message>
        <source>no answer counts yet</source>
        <translation>noch zählt keine Antwort</translation>
    </message>
    <message>
        <source>every answer was right</source>
        <translation>jede Antwort war richtig</translation>
    </message>
    <message>
        <source>the answers give no value</source>
        <translation>die Antworten ergeben keinen Wert</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>simuliert</translation>
    </message>
    <message>
        <source>withdrawn</source>
        <translation>Teilnahme zurückgezogen</translation>
    </message>
    <message>
        <source>%1 is not in this comparison (“%2”: %3; “%4”: %5).</source>
        <translation>%1 ist nicht in diesem Vergleich („%2“: %3; „%4“: %5).</translation>
    </message>
    <message>
        <source>So far %1 of %2 planned participants are enrolled. Enrol the others on the study&apos;s page.</source>
        <translation>Bisher sind %1 von %2 geplanten Personen aufgenommen. Nehmen Sie die anderen auf der Seite der Studie auf.</translation>
    </message>
    <message>
        <source>%1: the group value includes a run that is not finished, so it may still change. Resume the run under Run.</source>
        <translation>%1: Der Gruppenwert enthält einen nicht beendeten Lauf und kann sich deshalb noch ändern. Setzen Sie den Lauf unter „Durchführen“ fort.</translation>
    </message>
    <message>
        <source>no: %1</source>
        <translation>nein: %1</translation>
    </message>
    <message>
        <source>“!” before a value: the run has warnings. Read them before you use the value.</source>
        <translation>„!“ vor einem Wert: Der Lauf hat Warnungen. Lesen Sie diese, bevor Sie den Wert verwenden.</translation>
    </message>
    <message>
        <source>! with warnings</source>
        <translation>! mit Warnungen</translation>
    </message>
    <message>
        <source>! not in the group value</source>
        <translation>! nicht im Gruppenwert</translation>
    </message>
    <message>
        <source>Answers about single conditions are shown once the study is unblinded.</source>
        <translation>Antworten zu einzelnen Bedingungen werden gezeigt, sobald die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>About the condition %1</source>
        <translation>Zur Bedingung %1</translation>
    </message>
    <message>
        <source>In the group value: %1.</source>
        <translation>Im Gruppenwert: %1.</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 wiederholt)</translation>
    </message>
    <message>
        <source>In the group, and warnings</source>
        <translation>In der Gruppe; Warnungen</translation>
    </message>
    <message>
        <source>“%1” and “%2” are not compared: their values cannot be set against each other.</source>
        <translation>„%1“ und „%2“ werden nicht verglichen: Ihre Werte lassen sich nicht gegeneinanderstellen.</translation>
    </message>
    <message>
        <source>“%1” and “%2” are not compared yet: only %3 has a value in both, and at least two participants are needed; nor are there two groups, since nobody has a value in “%4” alone.</source>
        <translation>„%1“ und „%2“ werden noch nicht verglichen: Nur %3 hat in beiden einen Wert, und mindestens zwei Personen sind nötig; auch zwei Gruppen gibt es nicht, denn niemand hat allein in „%4“ einen Wert.</translation>
    </message>
    <message>
        <source>“%1” and “%2” have a ratio, but no interval and no p: each of the two groups needs at least two people, and these have %3 and %4.</source>
        <translation>„%1“ und „%2“ haben ein Verhältnis, aber kein Intervall und kein p: Jede der beiden Gruppen braucht mindestens zwei Personen, und diese haben %3 und %4.</translation>
    </message>
    <message>
        <source>%1 is not in this comparison: it compares two separate groups, and %1 has a value in both “%2” and “%3”.</source>
        <translation>%1 ist nicht in diesem Vergleich: Verglichen werden zwei getrennte Gruppen, und %1 hat sowohl in „%2“ als auch in „%3“ einen Wert.</translation>
    </message>
    <message>
        <source>%1 in both</source>
        <translation>%1 in beiden</translation>
    </message>
    <message>
        <source>two groups: %1 and %2</source>
        <translation>zwei Gruppen: %1 und %2</translation>
    </message>
    <message>
        <source>Ratio of the Weber fractions; 1 means that both are alike. It comes from the people who have a value in both conditions if there are at least two of them, otherwise from two groups, each with a value in only one condition. Adjusted: for this number of comparisons (Holm).</source>
        <translation>Verhältnis der Weber-Brüche; 1 bedeutet, dass beide gleich sind. Es stammt von den Personen, die in beiden Bedingungen einen Wert haben, wenn es mindestens zwei sind, sonst aus zwei Gruppen, jede mit einem Wert in nur einer Bedingung. Adjustiert: für diese Zahl von Vergleichen (Holm).</translation>
    </message>
    <message>
        <source>Separate thresholds: whether one threshold for each condition describes these people&apos;s answers better than a common one. This p is given only where the same people answered in both and the differences did not depend on the answers: after adaptive runs a fitted slope is biased, and p would be too small.</source>
        <translation>Getrennte Schwellen: ob eine Schwelle je Bedingung die Antworten dieser Personen besser beschreibt als eine gemeinsame. Dieses p wird nur angegeben, wo dieselben Personen in beiden geantwortet haben und die Unterschiede nicht von den Antworten abhingen: Nach adaptiven Läufen ist die angepasste Steigung verzerrt, und p wäre zu klein.</translation>
    </message>
    <message numerus="yes">
        <source>%n mark(s) come from a simulated observer: nothing was rendered.</source>
        <translation>
            <numerusform>%n Markierung stammt von einem simulierten Beobachter: Es wurde nichts dargestellt.</numerusform>
            <numerusform>%n Markierungen stammen von einem simulierten Beobachter: Es wurde nichts dargestellt.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: every answer was right, so the threshold may lie far below the smallest difference presented.</source>
        <translation>%1: Jede Antwort war richtig; die Schwelle kann also weit unter dem kleinsten dargebotenen Unterschied liegen.</translation>
    </message>
    <message>
        <source>%1: the answers are no better than guessing, so the threshold may lie far above the largest difference presented. Check that the task was understood.</source>
        <translation>%1: Die Antworten sind nicht besser als geraten; die Schwelle kann also weit über dem größten dargebotenen Unterschied liegen. Prüfen Sie, ob die Aufgabe verstanden wurde.</translation>
    </message>
    <message>
        <source>%1: the answers do not rule out a threshold far above the largest difference presented.</source>
        <translation>%1: Die Antworten schließen eine Schwelle weit über dem größten dargebotenen Unterschied nicht aus.</translation>
    </message>
    <message>
        <source>%1: the answers give no value, and the run cannot be resumed because the study is closed.</source>
        <translation>%1: Die Antworten ergeben keinen Wert, und der Lauf kann nicht fortgesetzt werden, weil die Studie geschlossen ist.</translation>
    </message>
    <message>
        <source>%1: the answers give no value yet. The run is not finished: resume it under Run if the participant goes on.</source>
        <translation>%1: Die Antworten ergeben noch keinen Wert. Der Lauf ist nicht beendet: Setzen Sie ihn unter „Durchführen“ fort, wenn die Person weitermacht.</translation>
    </message>
    <message>
        <source>the answers give no value yet</source>
        <translation>die Antworten ergeben noch keinen Wert</translation>
    </message>
    <message>
        <source>A run counts if its answers rule out two things: a threshold far below the smallest difference presented (usually a tenth of it) and one far above the largest (usually ten times it). It does not matter whether the run is finished, or which other warnings it has. “Rule out” means that with such a threshold the answers are less than 15 % as likely as with the best one. Left out, from groups and comparisons alike, are runs whose answers do not rule out both or give no value, runs with objects shown and not felt (unless you include them), participants who have withdrawn, and simulated participants where there are people.</source>
        <translation>Ein Lauf zählt, wenn seine Antworten zweierlei ausschließen: eine Schwelle weit unter dem kleinsten dargebotenen Unterschied (meist ein Zehntel davon) und eine weit über dem größten (meist das Zehnfache). Andere Warnungen spielen keine Rolle, ebenso wenig, ob der Lauf beendet ist. „Ausschließen“ heißt: Mit einer solchen Schwelle sind die Antworten nicht einmal 15 % so wahrscheinlich wie mit der besten. In Gruppen und ebenso in Vergleichen zählen nicht: Läufe, deren Antworten nicht beides ausschließen oder keinen Wert ergeben, Läufe mit gezeigten, nicht gefühlten Objekten (es sei denn, Sie beziehen sie ein), Personen, die ihre Teilnahme zurückgezogen haben, und simulierte Teilnehmende, wo es Menschen gibt.</translation>
    </message>
    <message>
        <source>no value yet</source>
        <translation>noch kein Wert</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>adjusted p</source>
        <translation>adjustiertes p</translation>
    </message>
    <message>
        <source>%1 participants in both conditions</source>
        <translation>%1 Teilnehmenden in beiden Bedingungen</translation>
    </message>
    <message>
        <source>two groups of %1 and %2 participants</source>
        <translation>zwei Gruppen von %1 und %2 Teilnehmenden</translation>
    </message>
    <message>
        <source>Compared in both conditions: %1.</source>
        <translation>In beiden Bedingungen verglichen: %1.</translation>
    </message>
    <message>
        <source>The values show no difference between “%1” and “%2” (ratio %3, 95 % interval: %4; %5).</source>
        <translation>Zwischen „%1“ und „%2“ zeigt sich kein Unterschied (Verhältnis %3, 95-%-Intervall: %4; %5).</translation>
    </message>
    <message>
        <source>unbounded in practice (too few participants)</source>
        <translation>praktisch unbegrenzt (zu wenige Teilnehmende)</translation>
    </message>
    <message>
        <source>Every answer was right: the threshold may lie below the smallest difference presented, but how far below is not known.</source>
        <translation>Jede Antwort war richtig: Die Schwelle kann unter dem kleinsten dargebotenen Unterschied liegen; wie weit darunter, ist nicht bekannt.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>%1: the answers do not rule out a threshold far below the smallest difference presented.</source>
        <translation>%1: Die Antworten schließen eine Schwelle weit unter dem kleinsten dargebotenen Unterschied nicht aus.</translation>
    </message>
    <message>
        <source>%1: the answers do not rule out a threshold far below the smallest difference presented, nor one far above the largest.</source>
        <translation>%1: Die Antworten schließen weder eine Schwelle weit unter dem kleinsten dargebotenen Unterschied noch eine weit über dem größten aus.</translation>
    </message>
    <message>
        <source>The study&apos;s table has larger differences, which were not presented. To measure the threshold, copy the study and plan more trials or a larger first difference.</source>
        <translation>Die Tabelle der Studie hat größere Unterschiede, die nicht dargeboten wurden. Um die Schwelle zu messen, kopieren Sie die Studie und planen Sie mehr Durchgänge oder einen größeren ersten Unterschied.</translation>
    </message>
    <message>
        <source>The study&apos;s table has smaller differences, which were not presented. To measure the threshold, copy the study and plan more trials.</source>
        <translation>Die Tabelle der Studie hat kleinere Unterschiede, die nicht dargeboten wurden. Um die Schwelle zu messen, kopieren Sie die Studie und planen Sie mehr Durchgänge.</translation>
    </message>
    <message>
        <source>To measure the threshold, copy the study and plan larger differences.</source>
        <translation>Um die Schwelle zu messen, kopieren Sie die Studie und planen Sie größere Unterschiede.</translation>
    </message>
    <message>
        <source>To measure the threshold, copy the study and plan smaller differences.</source>
        <translation>Um die Schwelle zu messen, kopieren Sie die Studie und planen Sie kleinere Unterschiede.</translation>
    </message>
    <message>
        <source>Only one difference was presented. To measure the threshold, copy the study and plan several.</source>
        <translation>Es wurde nur ein Unterschied dargeboten. Um die Schwelle zu messen, kopieren Sie die Studie und planen Sie mehrere.</translation>
    </message>
    <message>
        <source>the threshold may be far above the largest difference</source>
        <translation>die Schwelle liegt vielleicht weit über dem größten Unterschied</translation>
    </message>
    <message>
        <source>the answers leave the threshold open</source>
        <translation>die Antworten lassen die Schwelle offen</translation>
    </message>
    <message>
        <source>With %1, even a tenfold difference remains possible.</source>
        <translation>Mit %1 bleibt sogar ein zehnfacher Unterschied möglich.</translation>
    </message>
    <message>
        <source>With %1, every ratio in this interval remains possible: it is not shown that the two are alike.</source>
        <translation>Mit %1 bleibt jedes Verhältnis in diesem Intervall möglich: Dass beide gleich sind, ist nicht gezeigt.</translation>
    </message>
    <message>
        <source>Two groups are compared: %2, with a value only in “%1”, and %4, with a value only in “%3”.</source>
        <translation>Verglichen werden zwei Gruppen: %2 mit einem Wert nur in „%1“ und %4 mit einem Wert nur in „%3“.</translation>
    </message>
    <message>
        <source>It is not known whether the Weber fractions of “%1” and “%2” differ: these values give no interval and no p.</source>
        <translation>Ob sich die Weber-Brüche von „%1“ und „%2“ unterscheiden, ist nicht bekannt: Diese Werte ergeben weder ein Intervall noch ein p.</translation>
    </message>
    <message>
        <source>The interval is that of this comparison alone: once p is adjusted for all comparisons, the difference is not significant.</source>
        <translation>Das Intervall gilt für diesen Vergleich allein: Ist p für alle Vergleiche adjustiert, ist der Unterschied nicht signifikant.</translation>
    </message>
    <message>
        <source>The Weber fraction of “%1” is %2 times that of “%3” (95 % interval: %4; %5).</source>
        <translation>Der Weber-Bruch von „%1“ ist %2-mal so groß wie der von „%3“ (95-%-Intervall: %4; %5).</translation>
    </message>
    <message>
        <source>unbounded in practice (participants are too few, or differ too much)</source>
        <translation>praktisch unbegrenzt (zu wenige oder zu unterschiedliche Teilnehmende)</translation>
    </message>
    <message>
        <source>There are too few answers to say whether they are better than guessing. More trials would show it.</source>
        <translation>Es sind zu wenige Antworten, um zu sagen, ob sie besser als geraten sind. Mehr Durchgänge würden es zeigen.</translation>
    </message>
    <message>
        <source>%1 of %2 participants (%3)</source>
        <translation>%1 von %2 Teilnehmenden (%3)</translation>
    </message>
    <message>
        <source>Test: paired t test on the log Weber fractions (df = %1; random effects with the Hartung–Knapp correction, which weights participants by the precision of their values).</source>
        <translation>Test: gepaarter t-Test der logarithmierten Weber-Brüche (df = %1; Zufallseffekte mit Hartung-Knapp-Korrektur, die Teilnehmende nach der Genauigkeit ihrer Werte gewichtet).</translation>
    </message>
    <message>
        <source>Test: Welch&apos;s t test on the log Weber fractions of two independent groups (random effects with the Hartung–Knapp correction in each).</source>
        <translation>Test: Welch-t-Test der logarithmierten Weber-Brüche zweier unabhängiger Gruppen (Zufallseffekte mit Hartung-Knapp-Korrektur in jeder).</translation>
    </message>
    <message>
        <source>“%1”: Weber fraction %2, of one participant.</source>
        <translation>„%1“: Weber-Bruch %2, von einer Person.</translation>
    </message>
    <message>
        <source>“%1”: Weber fraction %2 (95 % interval: %3), of %4 participants.</source>
        <translation>„%1“: Weber-Bruch %2 (95-%-Intervall: %3), von %4 Teilnehmenden.</translation>
    </message>
    <message>
        <source>There is no group value yet: no participant&apos;s run is included so far.</source>
        <translation>Es gibt noch keinen Gruppenwert: Bisher geht von niemandem ein Lauf ein.</translation>
    </message>
    <message>
        <source>Fewer than 20 answers rarely measure a threshold.</source>
        <translation>Weniger als 20 Antworten messen selten eine Schwelle.</translation>
    </message>
    <message>
        <source>There are too few answers to measure the threshold.</source>
        <translation>Um die Schwelle zu messen, sind es zu wenige Antworten.</translation>
    </message>
    <message>
        <source>Copy the study and plan more trials: its page “Expected precision” shows how many trials most runs need to give a value.</source>
        <translation>Kopieren Sie die Studie und planen Sie mehr Durchgänge: Ihre Seite „Erwartete Genauigkeit“ zeigt, mit wie vielen die meisten Läufe einen Wert ergeben.</translation>
    </message>
    <message>
        <source>So few participants cannot show how many are needed: the study&apos;s page “Expected precision” shows it for the planned trials.</source>
        <translation>Wie viele Teilnehmende nötig sind, lässt sich aus so wenigen nicht sagen: Die Seite „Erwartete Genauigkeit“ der Studie sagt es für die geplanten Durchgänge.</translation>
    </message>
    <message>
        <source>more than %1</source>
        <translation>mehr als %1</translation>
    </message>
    <message>
        <source>about %1</source>
        <translation>etwa %1</translation>
    </message>
    <message>
        <source>If other people vary as much as these do, %1 participants in both conditions are needed to find, with 80 % power, a Weber fraction that is %2 times the other.</source>
        <translation>Streuen andere wie diese, so braucht es %1 Personen in beiden Bedingungen, um mit 80 % Teststärke einen Weber-Bruch nachzuweisen, der das %2-Fache des anderen ist.</translation>
    </message>
    <message>
        <source>If other people vary as much as these do, %1 participants in each group are needed to find, with 80 % power, a Weber fraction that is %2 times the other.</source>
        <translation>Streuen andere wie diese, so braucht es %1 Personen in jeder Gruppe, um mit 80 % Teststärke einen Weber-Bruch nachzuweisen, der das %2-Fache des anderen ist.</translation>
    </message>
    <message>
        <source>All participants here are simulated.</source>
        <translation>Alle Teilnehmenden sind hier simuliert.</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) were simulated without rendering: the observers knew the values and felt nothing.</source>
        <translation>
            <numerusform>%n Person wurde ohne Darstellung simuliert: Sie kannte die Werte und fühlte nichts.</numerusform>
            <numerusform>%n Personen wurden ohne Darstellung simuliert: Sie kannten die Werte und fühlten nichts.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Objects were shown to %n participant(s), not felt. Such runs are included on purpose: each counts in the group if its answers give a value.</source>
        <translation>
            <numerusform>%n Person wurden die Objekte gezeigt, nicht spürbar gemacht. Solche Läufe sind absichtlich einbezogen: Jeder zählt in der Gruppe, wenn seine Antworten einen Wert ergeben.</numerusform>
            <numerusform>%n Personen wurden die Objekte gezeigt, nicht spürbar gemacht. Solche Läufe sind absichtlich einbezogen: Jeder zählt in der Gruppe, wenn seine Antworten einen Wert ergeben.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>StudyTitles</name>
    <message>
        <source>copy</source>
        <translation>Kopie</translation>
    </message>
</context>
<context>
    <name>StudyWords</name>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Steigung</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittelwert</translation>
    </message>
    <message>
        <source>Standard deviation</source>
        <translation>Standardabweichung</translation>
    </message>
    <message>
        <source>Lapse rate</source>
        <translation>Lapse-Rate</translation>
    </message>
    <message>
        <source>Guess rate</source>
        <translation>Ratewahrscheinlichkeit</translation>
    </message>
    <message>
        <source>limited by the device</source>
        <translation>vom Gerät begrenzt</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>Deformation</source>
        <translation>Verformung</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>Rauheit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Viscosity</source>
        <translation>Viskosität</translation>
    </message>
    <message>
        <source>Apex</source>
        <translation>Scheitel</translation>
    </message>
    <message>
        <source>Ranking of three</source>
        <translation>Rangfolge von dreien</translation>
    </message>
    <message>
        <source>Two alternatives (2AFC)</source>
        <translation>Zwei Alternativen (2AFC)</translation>
    </message>
    <message>
        <source>Three alternatives (3AFC)</source>
        <translation>Drei Alternativen (3AFC)</translation>
    </message>
    <message>
        <source>Odd one out of three</source>
        <translation>Eines von dreien ist anders</translation>
    </message>
    <message>
        <source>Same or different</source>
        <translation>Gleich oder verschieden</translation>
    </message>
    <message>
        <source>Yes or no</source>
        <translation>Ja oder nein</translation>
    </message>
    <message>
        <source>Adjustment</source>
        <translation>Einstellung</translation>
    </message>
    <message>
        <source>Magnitude estimation</source>
        <translation>Größenschätzung</translation>
    </message>
    <message>
        <source>Which of two objects has more of the attribute?</source>
        <translation>Bei welchem von zwei Objekten ist die Eigenschaft stärker?</translation>
    </message>
    <message>
        <source>Which of three objects has more of the attribute? Two are the reference.</source>
        <translation>Bei welchem von drei Objekten ist die Eigenschaft stärker? Zwei sind die Referenz.</translation>
    </message>
    <message>
        <source>Which of three objects is unlike the other two?</source>
        <translation>Welches von drei Objekten unterscheidet sich von den beiden anderen?</translation>
    </message>
    <message>
        <source>Are two objects the same or different?</source>
        <translation>Sind zwei Objekte gleich oder verschieden?</translation>
    </message>
    <message>
        <source>One object is adjusted until it feels like the other.</source>
        <translation>Ein Objekt wird verändert, bis es sich wie das andere anfühlt.</translation>
    </message>
    <message>
        <source>Each object is given a number.</source>
        <translation>Jedes Objekt bekommt eine Zahl.</translation>
    </message>
    <message>
        <source>heavier</source>
        <translation>schwerer</translation>
    </message>
    <message>
        <source>slower to spring back</source>
        <translation>langsamer beim Zurückfedern</translation>
    </message>
    <message>
        <source>rougher</source>
        <translation>rauer</translation>
    </message>
    <message>
        <source>stickier</source>
        <translation>griffiger</translation>
    </message>
    <message>
        <source>more viscous</source>
        <translation>zäher</translation>
    </message>
    <message>
        <source>higher</source>
        <translation>höher</translation>
    </message>
    <message>
        <source>Put the three in order: each one %1 than the one before.</source>
        <translation>Ordnen Sie die drei: jedes %1 als das vorige.</translation>
    </message>
    <message>
        <source>Which one is %1?</source>
        <translation>Welches ist %1?</translation>
    </message>
    <message>
        <source>Which of the three is %1?</source>
        <translation>Welches der drei ist %1?</translation>
    </message>
    <message>
        <source>Which one is unlike the other two?</source>
        <translation>Welches unterscheidet sich von den beiden anderen?</translation>
    </message>
    <message>
        <source>Are the two the same or different?</source>
        <translation>Sind die beiden gleich oder verschieden?</translation>
    </message>
    <message>
        <source>Is it %1 than the reference?</source>
        <translation>Ist es %1 als die Referenz?</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Wie aufgeführt</translation>
    </message>
    <message>
        <source>Random</source>
        <translation>Zufällig</translation>
    </message>
    <message>
        <source>Latin square</source>
        <translation>Lateinisches Quadrat</translation>
    </message>
    <message>
        <source>Williams design</source>
        <translation>Williams-Plan</translation>
    </message>
    <message>
        <source>Draft</source>
        <translation>Entwurf</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>Eingefroren</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Archived</source>
        <translation>Archiviert</translation>
    </message>
    <message>
        <source>Consent missing</source>
        <translation>Einwilligung fehlt</translation>
    </message>
    <message>
        <source>Takes part</source>
        <translation>Nimmt teil</translation>
    </message>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Withdrawn</source>
        <translation>Zurückgezogen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>Force not as commanded</source>
        <translation>Kraft weicht vom Sollwert ab</translation>
    </message>
    <message>
        <source>Felt value off</source>
        <translation>Gefühlter Wert weicht ab</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Device at its limit</source>
        <translation>Gerät an seiner Grenze</translation>
    </message>
    <message>
        <source>Moved too fast</source>
        <translation>Zu schnell bewegt</translation>
    </message>
    <message>
        <source>Pressed too hard</source>
        <translation>Zu fest gedrückt</translation>
    </message>
    <message>
        <source>Time was up</source>
        <translation>Zeit abgelaufen</translation>
    </message>
    <message>
        <source>Not all touched</source>
        <translation>Nicht alle berührt</translation>
    </message>
    <message>
        <source>Discarded by the experimenter</source>
        <translation>Von der Versuchsleitung verworfen</translation>
    </message>
    <message>
        <source>Text change</source>
        <translation>Textänderung</translation>
    </message>
    <message>
        <source>Sealed reason</source>
        <translation>Versiegelter Grund</translation>
    </message>
    <message>
        <source>Ranking of three, with ties</source>
        <translation>Rangfolge von dreien, mit Gleichständen</translation>
    </message>
    <message>
        <source>Taken back</source>
        <translation>Zurückgenommen</translation>
    </message>
    <message>
        <source>“%1” is not a number. Separate numbers by semicolons or line ends.</source>
        <translation>„%1“ ist keine Zahl. Trennen Sie Zahlen durch Strichpunkte oder Zeilenenden.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Ratios of differences</source>
        <translation>Verhältnisse der Unterschiede</translation>
    </message>
    <message>
        <source>stiffer</source>
        <translation>steifer</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Three objects that differ by equal ratios are put in order.</source>
        <translation>Drei Objekte, die sich um gleiche Verhältnisse unterscheiden, werden geordnet.</translation>
    </message>
    <message>
        <source>Three objects that differ by equal ratios are put in order; those that feel the same may be marked as equal.</source>
        <translation>Drei Objekte, die sich um gleiche Verhältnisse unterscheiden, werden geordnet; was sich gleich anfühlt, darf als gleich angegeben werden.</translation>
    </message>
    <message>
        <source>Put the three in order: each one %1 than the one before. You may mark those that seem the same as equal.</source>
        <translation>Ordnen Sie die drei: jedes %1 als das vorige. Was Ihnen gleich vorkommt, dürfen Sie als gleich angeben.</translation>
    </message>
    <message>
        <source>Give a number to what you perceive. Any positive number is allowed.</source>
        <translation>Ordnen Sie dem, was Sie wahrnehmen, eine Zahl zu. Jede positive Zahl ist erlaubt.</translation>
    </message>
    <message>
        <source>The design has been changed since then. Undo in the study takes back one step after another.</source>
        <translation>Der Entwurf wurde seither geändert. „Rückgängig“ in der Studie nimmt einen Schritt nach dem anderen zurück.</translation>
    </message>
    <message>
        <source>You have left the study since then, so this can no longer be undone.</source>
        <translation>Sie haben die Studie seither verlassen, deshalb lässt sich das nicht mehr rückgängig machen.</translation>
    </message>
    <message>
        <source>Does an object have more of the attribute than the reference? Trials present the object alone: show participants the reference before they begin.</source>
        <translation>Ist die Eigenschaft bei einem Objekt stärker als bei der Referenz? Durchgänge bieten nur das Objekt dar: Zeigen Sie den Teilnehmenden die Referenz, bevor sie beginnen.</translation>
    </message>
    <message>
        <source>Change object 2 until both seem the same.</source>
        <translation>Verändern Sie Objekt 2, bis Ihnen beide gleich vorkommen.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>softness, hardness, compliance, elasticity, spring</source>
        <translation>Weichheit, Härte, Nachgiebigkeit, Elastizität, Feder</translation>
    </message>
    <message>
        <source>weight, heaviness, lifting</source>
        <translation>Gewicht, Schwere, Heben</translation>
    </message>
    <message>
        <source>recovery, relaxation, softness</source>
        <translation>Rückstellung, Relaxation, Weichheit</translation>
    </message>
    <message>
        <source>texture, smoothness</source>
        <translation>Textur, Glätte</translation>
    </message>
    <message>
        <source>slipperiness, stickiness, sliding</source>
        <translation>Glätte, Klebrigkeit, Gleiten</translation>
    </message>
    <message>
        <source>damping, resistance</source>
        <translation>Dämpfung, Widerstand</translation>
    </message>
    <message>
        <source>localisation, position, highest point, shape</source>
        <translation>Lokalisation, Position, höchster Punkt, Form</translation>
    </message>
    <message>
        <source>ordering, sorting</source>
        <translation>Ordnen, Sortieren</translation>
    </message>
    <message>
        <source>2AFC, 2IFC, two-alternative forced choice, comparison, discrimination</source>
        <translation>2AFC, 2IFC, Zweifachwahl, Zwangswahl, Vergleich, Unterscheidung</translation>
    </message>
    <message>
        <source>3AFC, three-alternative forced choice, discrimination</source>
        <translation>3AFC, Dreifachwahl, Zwangswahl, Unterscheidung</translation>
    </message>
    <message>
        <source>oddity, triangle test, discrimination</source>
        <translation>Oddity, Dreieckstest, Unterscheidung</translation>
    </message>
    <message>
        <source>same-different, AX, discrimination</source>
        <translation>Gleich-verschieden, AX, Unterscheidung</translation>
    </message>
    <message>
        <source>yes-no, single stimulus</source>
        <translation>Ja-Nein, Einzelreiz</translation>
    </message>
    <message>
        <source>matching, point of subjective equality, PSE</source>
        <translation>Abgleich, Punkt subjektiver Gleichheit, PSE</translation>
    </message>
    <message>
        <source>scaling, rating, power law</source>
        <translation>Skalierung, Größenschätzung, Potenzgesetz</translation>
    </message>
    <message>
        <source>1 condition, one condition</source>
        <translation>1 Bedingung, eine Bedingung</translation>
    </message>
    <message>
        <source>two conditions, comparison of conditions</source>
        <translation>zwei Bedingungen, Vergleich von Bedingungen</translation>
    </message>
    <message>
        <source>three conditions, comparison of conditions</source>
        <translation>drei Bedingungen, Vergleich von Bedingungen</translation>
    </message>
    <message>
        <source>%1 conditions</source>
        <translation>%1 Bedingungen</translation>
    </message>
    <message>
        <source>1 attribute, one attribute</source>
        <translation>1 Merkmal, ein Merkmal</translation>
    </message>
    <message>
        <source>two attributes, comparison of attributes</source>
        <translation>zwei Merkmale, Vergleich von Merkmalen</translation>
    </message>
    <message>
        <source>three attributes, comparison of attributes</source>
        <translation>drei Merkmale, Vergleich von Merkmalen</translation>
    </message>
    <message>
        <source>%1 attributes</source>
        <translation>%1 Merkmale</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>%1 is unlike the others</source>
        <translation>%1 ist anders als die anderen</translation>
    </message>
    <message>
        <source>the same</source>
        <translation>gleich</translation>
    </message>
    <message>
        <source>different</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>both are the same</source>
        <translation>beide sind gleich</translation>
    </message>
</context>
<context>
    <name>TextClaims</name>
    <message>
        <source>the reference is %1</source>
        <translation>die Referenz ist %1</translation>
    </message>
    <message>
        <source>the criterion is not 75 %</source>
        <translation>das Kriterium ist nicht 75 %</translation>
    </message>
    <message>
        <source>the objects are shown</source>
        <translation>die Objekte werden gezeigt</translation>
    </message>
    <message>
        <source>the objects are not shown</source>
        <translation>die Objekte werden nicht gezeigt</translation>
    </message>
    <message>
        <source>the time to explore is limited</source>
        <translation>die Zeit zum Erkunden ist begrenzt</translation>
    </message>
    <message>
        <source>The text says “%1” (%2), but %3. Change one of them.</source>
        <translation>Im Text steht „%1“ (%2), aber %3. Ändern Sie eines von beiden.</translation>
    </message>
    <message>
        <source>the task has a different number of objects</source>
        <translation>die Aufgabe hat eine andere Zahl von Objekten</translation>
    </message>
    <message>
        <source>a different number of trials is set</source>
        <translation>eine andere Zahl von Durchgängen ist eingestellt</translation>
    </message>
    <message>
        <source>a different time is set</source>
        <translation>eine andere Zeit ist eingestellt</translation>
    </message>
</context>
<context>
    <name>TrainingWords</name>
    <message>
        <source>Expert</source>
        <translation>Erfahren</translation>
    </message>
    <message>
        <source>Intermediate</source>
        <translation>Fortgeschritten</translation>
    </message>
    <message>
        <source>Novice</source>
        <translation>Unerfahren</translation>
    </message>
    <message>
        <source>Hesitant (draws back)</source>
        <translation>Zögerlich (zieht zurück)</translation>
    </message>
    <message>
        <source>Unsafe (presses too hard)</source>
        <translation>Riskant (drückt zu fest)</translation>
    </message>
    <message>
        <source>Replayed file %1: force shown, not felt</source>
        <translation>Abgespielte Datei %1: Kraft gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>You are watching. Space: pause or continue. Esc: stop.</source>
        <translation>Sie sehen zu. Leertaste: Pause oder weiter. Esc: Stopp.</translation>
    </message>
    <message>
        <source>Advance and withdraw: wheel, W and S, or Page Up and Page Down. Turn: mouse or arrow keys. Move sideways: the same with the right button or Shift. Roll: Q and E. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Vorschieben und zurückziehen: Mausrad, W und S oder Bild auf und Bild ab. Drehen: Maus oder Pfeiltasten. Seitlich bewegen: ebenso mit rechter Taste oder Umschalt. Rollen um die eigene Achse: Q und E. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Mark: click or Enter. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, Ziehen mit der rechten Taste oder Bild ab und Bild auf. Markieren: Klick oder Enter. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 is the right one, 2 the left one. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, Ziehen mit der rechten Taste oder Bild ab und Bild auf. Branchen schließen: linke Taste oder G halten. Öffnen: dasselbe mit Umschalt, oder H. Instrument: 1 ist das rechte, 2 das linke. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Instrument: 1 to 4. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, Ziehen mit der rechten Taste oder Bild ab und Bild auf. Branchen schließen: linke Taste oder G halten. Öffnen: dasselbe mit Umschalt, oder H. Instrument: 1 bis 4. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Lower and raise: wheel, right button and drag, or Page Down and Page Up. Close the jaw: hold the left button or G. Open it: the same with Shift, or H. Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Senken und heben: Mausrad, Ziehen mit der rechten Taste oder Bild ab und Bild auf. Branchen schließen: linke Taste oder G halten. Öffnen: dasselbe mit Umschalt, oder H. Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>You move the right instrument (1)</source>
        <translation>Sie bewegen das rechte Instrument (1)</translation>
    </message>
    <message>
        <source>You move the left instrument (2)</source>
        <translation>Sie bewegen das linke Instrument (2)</translation>
    </message>
    <message>
        <source>You move instrument %1 of %2</source>
        <translation>Sie bewegen Instrument %1 von %2</translation>
    </message>
    <message>
        <source>Move: mouse or arrow keys. Press and lift: wheel, right button and drag, or Page Down and Page Up. Mark a finding: click or Enter.</source>
        <translation>Bewegen: Maus oder Pfeiltasten. Drücken und heben: Mausrad, Ziehen mit der rechten Taste oder Bild ab und Bild auf. Fund markieren: Klick oder Enter.</translation>
    </message>
    <message>
        <source>Rate the finding: 1 to 5, V for the other rating, + and − for the size.</source>
        <translation>Fund bewerten: 1 bis 5, V für die andere Bewertung, + und − für die Größe.</translation>
    </message>
    <message>
        <source>Next finding: N. Take it back: Delete. Nothing more to report: D.</source>
        <translation>Nächster Fund: N. Zurücknehmen: Entf. Nichts mehr zu melden: D.</translation>
    </message>
    <message>
        <source>Use the mouse in the panel: T. A click in the scene brings it back.</source>
        <translation>Maus im Bedienfeld benutzen: T. Ein Klick in die Szene bringt sie zurück.</translation>
    </message>
    <message>
        <source>Other hand: H.</source>
        <translation>Andere Hand: H.</translation>
    </message>
    <message>
        <source>Space: pause, frees the pointer. Esc: stop force. F5: start again.</source>
        <translation>Leertaste: Pause, gibt den Zeiger frei. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>You move the right hand (H for the left)</source>
        <translation>Sie bewegen die rechte Hand (H für die linke)</translation>
    </message>
    <message>
        <source>You move the left hand (H for the right)</source>
        <translation>Sie bewegen die linke Hand (H für die rechte)</translation>
    </message>
    <message>
        <source>Move: with the handle. Mark: button of the handle or Enter. Space: pause. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: mit dem Griff. Markieren: Knopf am Griff oder Enter. Leertaste: Pause. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move: with the handle. Space: pause. Esc: stop force. F5: start again.</source>
        <translation>Bewegen: mit dem Griff. Leertaste: Pause. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Move, press and lift: with the handle. Mark a finding: button of the handle or Enter.</source>
        <translation>Bewegen, drücken und heben: mit dem Griff. Fund markieren: Knopf am Griff oder Enter.</translation>
    </message>
    <message>
        <source>Squeeze tissue between the jaws: open the grip in the air, lower it, close it.</source>
        <translation>Gewebe zwischen den Branchen drücken: Griff in der Luft öffnen, absenken, schließen.</translation>
    </message>
    <message>
        <source>Space: pause. Esc: stop force. F5: start again.</source>
        <translation>Leertaste: Pause. Esc: Kraft stoppen. F5: neu beginnen.</translation>
    </message>
    <message>
        <source>Demonstration (%1). %2</source>
        <translation>Vorführung (%1). %2</translation>
    </message>
    <message>
        <source>Squeeze tissue between the jaws: open them in the air with O, lower them, close them with G. They stay as they are when you let go.</source>
        <translation>Gewebe zwischen den Branchen drücken: in der Luft mit O öffnen, absenken, mit G schließen. Sie bleiben, wie sie sind, wenn Sie loslassen.</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>Completed</source>
        <translation>Abgeschlossen</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message>
        <source>Every pass mark of this level was met.</source>
        <translation>Alle Bestehensgrenzen dieser Stufe wurden erreicht.</translation>
    </message>
    <message>
        <source>Not passed yet</source>
        <translation>Noch nicht bestanden</translation>
    </message>
    <message numerus="yes">
        <source>%n pass mark(s) of this level were not met:</source>
        <translation>
            <numerusform>%n Bestehensgrenze dieser Stufe wurde nicht erreicht:</numerusform>
            <numerusform>%n Bestehensgrenzen dieser Stufe wurden nicht erreicht:</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 trials were completed.</source>
        <translation>%1 von %2 Durchgängen wurden abgeschlossen.</translation>
    </message>
    <message>
        <source>Stopped before the end</source>
        <translation>Vor dem Ende abgebrochen</translation>
    </message>
    <message>
        <source>%1 What was recorded is kept and can be played back. The session does not count towards passing; try again when you are ready.</source>
        <translation>%1 Aufgezeichnetes bleibt erhalten und kann wiedergegeben werden. Die Sitzung zählt nicht für das Bestehen; versuchen Sie es erneut, wenn Sie so weit sind.</translation>
    </message>
    <message>
        <source>Interrupted</source>
        <translation>Unterbrochen</translation>
    </message>
    <message>
        <source>The program ended during this session. %1 Everything recorded up to then was saved and can be played back. The session does not count towards passing.</source>
        <translation>Das Programm endete während dieser Sitzung. %1 Alles bis dahin Aufgezeichnete wurde gespeichert und kann wiedergegeben werden. Die Sitzung zählt nicht fürs Bestehen.</translation>
    </message>
    <message>
        <source>Incomplete recording</source>
        <translation>Unvollständige Aufzeichnung</translation>
    </message>
    <message numerus="yes">
        <source>The computer could not keep up and %n sample(s) were lost. The rest is kept and can be played back. The session does not count towards passing; close other programs before the next attempt.</source>
        <translation>
            <numerusform>Der Computer kam nicht nach, und %n Messpunkt ging verloren. Der Rest bleibt erhalten und kann wiedergegeben werden. Die Sitzung zählt nicht für das Bestehen; schließen Sie vor dem nächsten Versuch andere Programme.</numerusform>
            <numerusform>Der Computer kam nicht nach, und %n Messpunkte gingen verloren. Der Rest bleibt erhalten und kann wiedergegeben werden. Die Sitzung zählt nicht für das Bestehen; schließen Sie vor dem nächsten Versuch andere Programme.</numerusform>
        </translation>
    </message>
    <message>
        <source>Ended by a fault</source>
        <translation>Durch eine Störung beendet</translation>
    </message>
    <message>
        <source>The device or the force supervisor stopped this session for safety. %1 What was recorded is kept. The session does not count towards passing; check the device before the next attempt.</source>
        <translation>Das Gerät oder die Sicherheitsüberwachung hat diese Sitzung aus Sicherheitsgründen gestoppt. %1 Aufgezeichnetes bleibt erhalten. Die Sitzung zählt nicht für das Bestehen; prüfen Sie das Gerät vor dem nächsten Versuch.</translation>
    </message>
    <message>
        <source>Still running</source>
        <translation>Läuft noch</translation>
    </message>
    <message>
        <source>This session has not ended yet. Its result will appear here when it ends.</source>
        <translation>Diese Sitzung ist noch nicht beendet. Das Ergebnis erscheint hier, sobald sie endet.</translation>
    </message>
    <message>
        <source>Voided</source>
        <translation>Ungültig</translation>
    </message>
    <message>
        <source>A trainer declared this session void. Recording and scores are kept but do not count.</source>
        <translation>Ein/e Ausbilder/in hat diese Sitzung für ungültig erklärt. Aufzeichnung und Wertungen bleiben erhalten, zählen aber nicht.</translation>
    </message>
    <message>
        <source>A trainer declared this session void: %1
Recording and scores are kept but do not count.</source>
        <translation>Ein/e Ausbilder/in hat diese Sitzung für ungültig erklärt: %1
Aufzeichnung und Wertungen bleiben erhalten, zählen aber nicht.</translation>
    </message>
    <message>
        <source>%1: no value (%2), but the pass mark is %3</source>
        <translation>%1: kein Wert (%2), doch die Bestehensgrenze ist %3</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too much)</source>
        <translation>%1: %2, doch die Bestehensgrenze ist %3 (%4 zu viel)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too many)</source>
        <translation>%1: %2, doch die Bestehensgrenze ist %3 (%4 zu viele)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too few)</source>
        <translation>%1: %2, doch die Bestehensgrenze ist %3 (%4 zu wenige)</translation>
    </message>
    <message>
        <source>%1: %2, but the pass mark is %3 (%4 too little)</source>
        <translation>%1: %2, doch die Bestehensgrenze ist %3 (%4 zu wenig)</translation>
    </message>
    <message>
        <source>Familiarisation is recorded but never counts. %1</source>
        <translation>Die Eingewöhnung wird aufgezeichnet, zählt aber nie. %1</translation>
    </message>
    <message>
        <source>The procedure was not completed.</source>
        <translation>Der Eingriff wurde nicht bis zum Ende durchgeführt.</translation>
    </message>
    <message>
        <source>%1 %2 → %3</source>
        <translation>%1 %2 → %3</translation>
    </message>
    <message>
        <source>Since your last attempt: %1</source>
        <translation>Seit Ihrem letzten Versuch: %1</translation>
    </message>
    <message>
        <source>%1 percentage points</source>
        <translation>%1 Prozentpunkte</translation>
    </message>
    <message>
        <source>The demonstration passed</source>
        <translation>Die Demonstration ist bestanden</translation>
    </message>
    <message>
        <source>The demonstration was stopped</source>
        <translation>Die Demonstration wurde beendet</translation>
    </message>
    <message>
        <source>%1 What was recorded can be played back.</source>
        <translation>%1 Was aufgezeichnet wurde, lässt sich wiedergeben.</translation>
    </message>
    <message>
        <source>This level has no pass mark. The values below are for comparison only.</source>
        <translation>Diese Stufe hat keine Bestehensgrenze. Die folgenden Werte dienen nur dem Vergleich.</translation>
    </message>
    <message>
        <source>Since the previous attempt: %1</source>
        <translation>Seit dem vorigen Versuch: %1</translation>
    </message>
</context>
<context>
    <name>WeightCheck</name>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>The heaviest object weighs %1 N. From %2 N on, which is 80 % of the largest force of a trial, participants are told to pull less hard, so merely holding this object would give it away. Allow at least %3 N, or choose lighter objects.</source>
        <translation>Das schwerste Objekt wiegt %1 N. Ab %2 N, das sind 80 % der größten Kraft eines Durchgangs, lesen die Teilnehmenden, dass sie weniger stark ziehen sollen. Schon daran wäre dieses Objekt zu erkennen. Lassen Sie mindestens %3 N zu, oder wählen Sie leichtere Objekte.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AccountScreen</name>
    <message>
        <source>Reading your account …</source>
        <translation>Ihr Konto wird gelesen …</translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Mein Konto</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Vollständiger Name (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Save the name</source>
        <translation>Namen speichern</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>As on this station</source>
        <translation>Wie an diesem Arbeitsplatz</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Current password</source>
        <translation>Jetziges Passwort</translation>
    </message>
    <message>
        <source>Change the password</source>
        <translation>Passwort ändern</translation>
    </message>
    <message>
        <source>Change my password</source>
        <translation>Mein Passwort ändern</translation>
    </message>
    <message>
        <source>Your account could not be read.</source>
        <translation>Ihr Konto konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Login name: %1. An administrator can change it.</source>
        <translation>Anmeldename: %1. Die Administration kann ihn ändern.</translation>
    </message>
    <message>
        <source>The full name is too long: use at most %1 characters.</source>
        <translation>Der vollständige Name ist zu lang: Erlaubt sind höchstens %1 Zeichen.</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert …</translation>
    </message>
    <message>
        <source>Your name is now %1.</source>
        <translation>Ihr Name ist jetzt %1.</translation>
    </message>
    <message>
        <source>Your name was not changed.
%1</source>
        <translation>Ihr Name wurde nicht geändert.
%1</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>This is the password that you have now. Choose another one.</source>
        <translation>Das ist Ihr jetziges Passwort. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>Your password has been changed. From your next login, only the new one is valid.</source>
        <translation>Ihr Passwort ist geändert. Ab der nächsten Anmeldung gilt nur noch das neue.</translation>
    </message>
    <message>
        <source>The current password is wrong. Nothing was changed. Passwords are case-sensitive; check Caps Lock.</source>
        <translation>Das jetzige Passwort ist falsch. Nichts wurde geändert. Groß- und Kleinschreibung wird unterschieden; prüfen Sie die Feststelltaste.</translation>
    </message>
    <message>
        <source>The password was not changed.
%1</source>
        <translation>Das Passwort wurde nicht geändert.
%1</translation>
    </message>
    <message>
        <source>Login name: %1. You can change it under People.</source>
        <translation>Anmeldename: %1. Sie können ihn unter „Personen“ ändern.</translation>
    </message>
    <message>
        <source>Recovery code</source>
        <translation>Wiederherstellungscode</translation>
    </message>
    <message>
        <source>With a recovery code you can set a new password yourself if you forget yours: at the login, choose &quot;Forgot your password?&quot;.</source>
        <translation>Mit einem Wiederherstellungscode können Sie selbst ein neues Passwort festlegen, falls Sie Ihres vergessen: Wählen Sie bei der Anmeldung „Passwort vergessen?“.</translation>
    </message>
    <message>
        <source>Make a recovery code …</source>
        <translation>Wiederherstellungscode erstellen …</translation>
    </message>
    <message>
        <source>The program could not read whether you have a recovery code.
%1</source>
        <translation>Das Programm konnte nicht lesen, ob Sie einen Wiederherstellungscode haben.
%1</translation>
    </message>
    <message>
        <source>You have one. If it is lost or somebody else may have seen it, make a new one; it replaces the present one.</source>
        <translation>Sie haben einen. Ist er verloren oder könnte ihn jemand anderes gesehen haben, erstellen Sie einen neuen; er ersetzt den jetzigen.</translation>
    </message>
    <message>
        <source>You have none yet. Without it, only another administrator can help you if you forget your password.</source>
        <translation>Sie haben noch keinen. Ohne ihn kann Ihnen, falls Sie Ihr Passwort vergessen, nur eine andere Person der Administration helfen.</translation>
    </message>
    <message>
        <source>Your own name, language and password.

The full name is what others see in lists and reports; your earlier names stay in the site&apos;s history. The login name can be changed by an administrator.

The language takes effect at once. It is used whenever you log in on this station, and changes nothing for others.

To change your password, first enter the one that you have now.

Administrators can make a recovery code for themselves here; with it they can set a new password if they forget theirs.</source>
        <translation>Ihr eigener Name, Ihre Sprache und Ihr Passwort.

Den vollständigen Namen sehen andere in Listen und Berichten; Ihre früheren Namen bleiben im Verlauf des Standorts. Den Anmeldenamen kann die Administration ändern.

Die Sprache gilt sofort. Sie gilt bei jeder Anmeldung an diesem Arbeitsplatz und ändert für andere nichts.

Um Ihr Passwort zu ändern, geben Sie zuerst das jetzige ein.

Wer zur Administration gehört, kann hier einen Wiederherstellungscode für sich erstellen und mit ihm ein neues Passwort festlegen, falls das alte vergessen ist.</translation>
    </message>
    <message>
        <source>It is used whenever you log in on this station, and changes nothing for others.</source>
        <translation>Sie gilt bei jeder Anmeldung an diesem Arbeitsplatz und ändert für andere nichts.</translation>
    </message>
    <message>
        <source>Others now see only your login name.</source>
        <translation>Andere sehen jetzt nur noch Ihren Anmeldenamen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AddPersonDialog</name>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Vollständiger Name (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>%1 was not added: somebody has this name already. Names that differ only in capital letters count as the same.</source>
        <translation>%1 wurde nicht hinzugefügt: Dieser Name ist schon vergeben. Namen, die sich nur in der Groß- und Kleinschreibung unterscheiden, gelten als gleich.</translation>
    </message>
    <message>
        <source>%1 was not added.
%2</source>
        <translation>%1 wurde nicht hinzugefügt.
%2</translation>
    </message>
    <message>
        <source>%1 was added.</source>
        <translation>%1 wurde hinzugefügt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AdministratorPage</name>
    <message>
        <source>Who looks after this site?</source>
        <translation>Wer betreut diesen Standort?</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Vollständiger Name (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Set up the site</source>
        <translation>Standort einrichten</translation>
    </message>
    <message>
        <source>This name cannot be used. Use at most %1 characters, no commas and no spaces at the ends. Some names are reserved for the program.</source>
        <translation>Dieser Name ist nicht möglich. Erlaubt sind höchstens %1 Zeichen, keine Kommas und keine Leerzeichen am Anfang oder Ende. Einige Namen sind für das Programm reserviert.</translation>
    </message>
    <message>
        <source>Creating the site …</source>
        <translation>Standort wird angelegt …</translation>
    </message>
    <message>
        <source>A short name without commas, such as &quot;ada&quot;.</source>
        <translation>Ein kurzer Name ohne Kommas, zum Beispiel „ada“.</translation>
    </message>
    <message>
        <source>Name of the site, such as the clinic&apos;s (may be left empty)</source>
        <translation>Name des Standorts, etwa der Klinik (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Shown at the login, on password slips and on reports. Administrators can change it in the settings.</source>
        <translation>Erscheint bei der Anmeldung, auf Passwortzetteln und auf Berichten. Die Administration kann ihn in den Einstellungen ändern.</translation>
    </message>
    <message>
        <source>The first person is an administrator, who adds people, makes backups, and may also train, design studies and run them.</source>
        <translation>Die erste Person übernimmt die Administration: Sie legt Personen an, erstellt Sicherungen und kann auch trainieren, Studien entwerfen und durchführen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AnswerPanel</name>
    <message>
        <source>here</source>
        <translation>hier</translation>
    </message>
    <message>
        <source>Same (1)</source>
        <translation>Gleich (1)</translation>
    </message>
    <message>
        <source>Different (2)</source>
        <translation>Verschieden (2)</translation>
    </message>
    <message>
        <source>No (N)</source>
        <translation>Nein (N)</translation>
    </message>
    <message>
        <source>Yes (Y)</source>
        <translation>Ja (Y)</translation>
    </message>
    <message>
        <source>Less (−)</source>
        <translation>Weniger (−)</translation>
    </message>
    <message>
        <source>More (+)</source>
        <translation>Mehr (+)</translation>
    </message>
    <message>
        <source>They are the same (Enter)</source>
        <translation>Sie sind gleich (Enter)</translation>
    </message>
    <message>
        <source>Your number</source>
        <translation>Ihre Zahl</translation>
    </message>
    <message>
        <source>Submit (Enter)</source>
        <translation>Abgeben (Enter)</translation>
    </message>
    <message>
        <source>Back (⌫)</source>
        <translation>Zurück (⌫)</translation>
    </message>
    <message>
        <source>Confirm (Enter)</source>
        <translation>Bestätigen (Enter)</translation>
    </message>
    <message>
        <source>least</source>
        <translation>am wenigsten</translation>
    </message>
    <message>
        <source>between</source>
        <translation>dazwischen</translation>
    </message>
    <message>
        <source>most</source>
        <translation>am meisten</translation>
    </message>
    <message>
        <source>Enter a number above zero.</source>
        <translation>Geben Sie eine Zahl über null ein.</translation>
    </message>
    <message>
        <source>Equal to the last (=)</source>
        <translation>Gleich wie das letzte (=)</translation>
    </message>
    <message>
        <source>the left one</source>
        <translation>das linke</translation>
    </message>
    <message>
        <source>the right one</source>
        <translation>das rechte</translation>
    </message>
    <message>
        <source>the middle one</source>
        <translation>das mittlere</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexPage</name>
    <message>
        <source>Nobody has done this condition yet. Each participant&apos;s marks will appear here after the first run.</source>
        <translation>Noch hat niemand diese Bedingung durchlaufen. Die Markierungen jeder Person erscheinen hier nach dem ersten Lauf.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>%1 mm (%2)</source>
        <translation>%1 mm (%2)</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>SD %1</source>
        <translation>SD %1</translation>
    </message>
    <message>
        <source>Bias in %1</source>
        <translation>Verschiebung in %1</translation>
    </message>
    <message>
        <source>Mean absolute error</source>
        <translation>Mittlerer absoluter Fehler</translation>
    </message>
    <message>
        <source>SD %1; published: %2</source>
        <translation>SD %1; veröffentlicht: %2</translation>
    </message>
    <message numerus="yes">
        <source>Per cent of the sphere&apos;s radius. %n mark(s)</source>
        <translation>
            <numerusform>Prozent des Kugelradius. %n Markierung</numerusform>
            <numerusform>Prozent des Kugelradius. %n Markierungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n trial(s) repeated</source>
        <translation>
            <numerusform>, %n Durchgang wiederholt</numerusform>
            <numerusform>, %n Durchgänge wiederholt</numerusform>
        </translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Bias in x</source>
        <translation>Verschiebung in x</translation>
    </message>
    <message>
        <source>Bias in y</source>
        <translation>Verschiebung in y</translation>
    </message>
    <message>
        <source>SD in x</source>
        <translation>SD in x</translation>
    </message>
    <message>
        <source>SD in y</source>
        <translation>SD in y</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 wiederholt)</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Mean error</source>
        <translation>Mittlerer Fehler</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ApexStage</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Where is the highest point?</source>
        <translation>Wo ist der höchste Punkt?</translation>
    </message>
    <message>
        <source>Here it is (Enter)</source>
        <translation>Hier ist er (Enter)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AttemptsTable</name>
    <message>
        <source>My attempts</source>
        <translation>Meine Versuche</translation>
    </message>
    <message>
        <source>When</source>
        <translation>Wann</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Level %1, familiarisation</source>
        <translation>Stufe %1, Eingewöhnung</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::AutomaticCard</name>
    <message>
        <source>Automatic backups</source>
        <translation>Automatische Sicherungen</translation>
    </message>
    <message>
        <source>Once a day, when nobody has used the program for a few minutes, or when it closes. A session or a study is never disturbed. Each backup is checked after it is made.</source>
        <translation>Einmal am Tag, wenn einige Minuten lang niemand das Programm benutzt hat oder wenn es beendet wird. Eine Sitzung oder Studie wird nie gestört. Jede Sicherung wird nach dem Erstellen geprüft.</translation>
    </message>
    <message>
        <source>Make a backup every day</source>
        <translation>Jeden Tag eine Sicherung erstellen</translation>
    </message>
    <message>
        <source>Automatic backups to keep</source>
        <translation>Automatische Sicherungen behalten</translation>
    </message>
    <message>
        <source>Older ones are removed. Backups that you made yourself are never removed.</source>
        <translation>Ältere werden entfernt. Sicherungen, die Sie selbst erstellt haben, werden nie entfernt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::BackupKeeper</name>
    <message>
        <source>Open storage</source>
        <translation>Datensicherung öffnen</translation>
    </message>
    <message>
        <source>The automatic backup was not made; it will be tried again.
%1</source>
        <translation>Die automatische Sicherung wurde nicht erstellt; es wird erneut versucht.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::BreakPanel</name>
    <message>
        <source>Break time</source>
        <translation>Pausendauer</translation>
    </message>
    <message>
        <source>Enter or Space: read on</source>
        <translation>Enter oder Leertaste: weiterlesen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CheckList</name>
    <message>
        <source>good</source>
        <translation>gut</translation>
    </message>
    <message>
        <source>worth a look</source>
        <translation>einen Blick wert</translation>
    </message>
    <message>
        <source>must be corrected</source>
        <translation>muss berichtigt werden</translation>
    </message>
    <message>
        <source>%1, %2: %3</source>
        <translation>%1, %2: %3</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>being calculated</source>
        <translation>wird berechnet</translation>
    </message>
    <message>
        <source>What is checked before freezing</source>
        <translation>Was vor dem Einfrieren geprüft wird</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CheckPage</name>
    <message>
        <source>Before you freeze</source>
        <translation>Vor dem Einfrieren</translation>
    </message>
    <message>
        <source>Pilot runs</source>
        <translation>Probeläufe</translation>
    </message>
    <message>
        <source>Somebody tries the design as it is now, with the real trials on this station. A pilot is kept apart: it is never analysed or exported with the study&apos;s data.</source>
        <translation>Jemand probiert den Entwurf, wie er jetzt ist, mit den echten Durchgängen an diesem Arbeitsplatz aus. Ein Probelauf bleibt getrennt: Er wird nie mit den Daten der Studie ausgewertet oder ausgegeben.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s) that count</source>
        <translation>
            <numerusform>%n gewerteter Durchgang</numerusform>
            <numerusform>%n gewertete Durchgänge</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n repeated</source>
        <translation>
            <numerusform>%n wiederholt</numerusform>
            <numerusform>%n wiederholt</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 s per trial</source>
        <translation>%1 s je Durchgang</translation>
    </message>
    <message>
        <source>Pilot run …</source>
        <translation>Probelauf …</translation>
    </message>
    <message>
        <source>Freeze</source>
        <translation>Einfrieren</translation>
    </message>
    <message>
        <source>Freezing is final: nobody can change the design afterwards, and every result can be traced to it. Participants can be enrolled from then on. To change something later, copy the study into a new one.</source>
        <translation>Einfrieren ist endgültig: Danach kann niemand den Entwurf ändern, und jedes Ergebnis lässt sich auf ihn zurückführen. Von da an können Teilnehmende aufgenommen werden. Um später etwas zu ändern, kopieren Sie die Studie in eine neue.</translation>
    </message>
    <message>
        <source>Freeze …</source>
        <translation>Einfrieren …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ChoiceTile</name>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommandPalette</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Command</source>
        <translation>Befehl</translation>
    </message>
    <message>
        <source>Commands found</source>
        <translation>Gefundene Befehle</translation>
    </message>
    <message>
        <source>%1   (%2)</source>
        <translation>%1   (%2)</translation>
    </message>
    <message>
        <source>Type what you want to do, or a name</source>
        <translation>Geben Sie ein, was Sie tun möchten, oder einen Namen</translation>
    </message>
    <message>
        <source>Nothing matches. Try fewer letters or another word.</source>
        <translation>Nichts gefunden. Versuchen Sie es mit weniger Buchstaben oder einem anderen Wort.</translation>
    </message>
    <message>
        <source>Commands</source>
        <translation>Befehle</translation>
    </message>
    <message>
        <source>Further commands</source>
        <translation>Weitere Befehle</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommentPanel</name>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>No comments yet.</source>
        <translation>Noch keine Kommentare.</translation>
    </message>
    <message>
        <source>New comment</source>
        <translation>Neuer Kommentar</translation>
    </message>
    <message>
        <source>What do you see here?</source>
        <translation>Was sehen Sie hier?</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Jemand anderes</translation>
    </message>
    <message>
        <source>%1 · %2 · %3</source>
        <translation>%1 · %2 · %3</translation>
    </message>
    <message>
        <source>Whole session · %1 · %2</source>
        <translation>Ganze Sitzung · %1 · %2</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(gelöscht)</translation>
    </message>
    <message>
        <source>Reviewed, nothing to add</source>
        <translation>Begutachtet, nichts hinzuzufügen</translation>
    </message>
    <message>
        <source>Reviewed. Nothing to add.</source>
        <translation>Begutachtet. Nichts hinzuzufügen.</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Do not reply</source>
        <translation>Nicht antworten</translation>
    </message>
    <message>
        <source>Reply to %1</source>
        <translation>%1 antworten</translation>
    </message>
    <message>
        <source>Comment here: %1</source>
        <translation>Hier kommentieren: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::CommentsScreen</name>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>All comments that you received or wrote, unread ones first, then the newest.

Each leads to its moment in the playback, or to the debrief where it is about the whole session. What is shown here counts as read.</source>
        <translation>Alle Kommentare, die Sie erhalten oder geschrieben haben, ungelesene zuerst, dann die neuesten.

Jeder führt zu seinem Moment in der Wiedergabe, oder zur Auswertung, wenn er die ganze Sitzung betrifft. Was hier steht, gilt als gelesen.</translation>
    </message>
    <message>
        <source>Reading the comments …</source>
        <translation>Die Kommentare werden gelesen …</translation>
    </message>
    <message>
        <source>The comments could not be read.</source>
        <translation>Die Kommentare konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>No comments yet</source>
        <translation>Noch keine Kommentare</translation>
    </message>
    <message>
        <source>Comments on your sessions, and your comments on other people&apos;s sessions, will appear here.</source>
        <translation>Was zu Ihren Sitzungen geschrieben wird und was Sie zu denen anderer schreiben, steht dann hier.</translation>
    </message>
    <message>
        <source>Which comments</source>
        <translation>Welche Kommentare</translation>
    </message>
    <message>
        <source>Received and written</source>
        <translation>Erhaltene und geschriebene</translation>
    </message>
    <message>
        <source>Received</source>
        <translation>Erhaltene</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschriebene</translation>
    </message>
    <message>
        <source>Show older comments</source>
        <translation>Ältere Kommentare zeigen</translation>
    </message>
    <message>
        <source>Nobody has commented on your sessions yet.</source>
        <translation>Zu Ihren Sitzungen hat noch niemand etwas geschrieben.</translation>
    </message>
    <message>
        <source>You have not written any yet.</source>
        <translation>Sie haben noch keine geschrieben.</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Jemand anderes</translation>
    </message>
    <message>
        <source>%1 on your session %2: %3 · %4</source>
        <translation>%1 zu Ihrer Sitzung %2: %3 · %4</translation>
    </message>
    <message>
        <source>%1 on session %2 of %3: %4 · %5</source>
        <translation>%1 zu Sitzung %2 von %3: %4 · %5</translation>
    </message>
    <message>
        <source>Unread</source>
        <translation>Ungelesen</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(gelöscht)</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Zusehen</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Auswertung öffnen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ComparisonPage</name>
    <message>
        <source>Conditions compared</source>
        <translation>Bedingungen im Vergleich</translation>
    </message>
    <message>
        <source>This study has only one condition, so there is nothing to compare it with.</source>
        <translation>Diese Studie hat nur eine Bedingung; es gibt nichts, womit sie zu vergleichen wäre.</translation>
    </message>
    <message>
        <source>Weber fractions are compared. The search for an apex has none: its groups tell errors in millimetres.</source>
        <translation>Verglichen werden Weber-Brüche. Die Suche nach einem Scheitel hat keine: Ihre Gruppen zeigen Fehler in Millimetern.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConditionQuestions</name>
    <message>
        <source>Please answer about the part that you have just finished, and about nothing else.</source>
        <translation>Bitte antworten Sie zu dem Teil, den Sie gerade abgeschlossen haben, und zu nichts anderem.</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>The answers were not stored. They are still on this page: press Submit again, and call the experimenter if that does not help.
%1</source>
        <translation>Die Antworten wurden nicht gespeichert. Sie stehen noch auf dieser Seite: Drücken Sie noch einmal „Abgeben“, und rufen Sie die Versuchsleitung, wenn das nicht hilft.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConditionsPage</name>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Add a condition</source>
        <translation>Bedingung hinzufügen</translation>
    </message>
    <message>
        <source>Remove a condition</source>
        <translation>Bedingung entfernen</translation>
    </message>
    <message>
        <source>What is compared</source>
        <translation>Was verglichen wird</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Id of a condition</source>
        <translation>Kennung einer Bedingung</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Task</source>
        <translation>Aufgabe</translation>
    </message>
    <message>
        <source>Criterion</source>
        <translation>Kriterium</translation>
    </message>
    <message>
        <source>Table of differences</source>
        <translation>Tabelle der Unterschiede</translation>
    </message>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Several procedures are interleaved at random.</source>
        <translation>Mehrere Verfahren werden zufällig gemischt.</translation>
    </message>
    <message>
        <source>Scale of the procedure</source>
        <translation>Skala des Verfahrens</translation>
    </message>
    <message>
        <source>Remove a procedure</source>
        <translation>Verfahren entfernen</translation>
    </message>
    <message>
        <source>Add a procedure</source>
        <translation>Verfahren hinzufügen</translation>
    </message>
    <message>
        <source>Sealed conditions</source>
        <translation>Versiegelte Bedingungen</translation>
    </message>
    <message>
        <source>The study is blind: until it is unblinded, its conditions are shown only by these codes and their differences are hidden. Only the study&apos;s author and administrators see the design.</source>
        <translation>Die Studie ist verblindet: Bis zur Entblindung erscheinen ihre Bedingungen nur unter diesen Codes, und ihre Unterschiede sind verborgen. Den Entwurf sehen nur die Administration und die Person, die ihn verfasst hat.</translation>
    </message>
    <message>
        <source>What the conditions have in common</source>
        <translation>Was die Bedingungen gemeinsam haben</translation>
    </message>
    <message>
        <source>Candidates</source>
        <translation>Kandidaten</translation>
    </message>
    <message>
        <source>Differences from the reference</source>
        <translation>Unterschiede zur Referenz</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>The procedure works on</source>
        <translation>Das Verfahren arbeitet mit</translation>
    </message>
    <message>
        <source>What is looked for</source>
        <translation>Was gesucht wird</translation>
    </message>
    <message>
        <source>What the condition is called in tables and figures. Participants never see it.</source>
        <translation>Wie die Bedingung in Tabellen und Abbildungen heißt. Teilnehmende sehen es nie.</translation>
    </message>
    <message>
        <source>Short name in exports</source>
        <translation>Kurzname in Ausgaben</translation>
    </message>
    <message>
        <source>Radius of the sphere</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>How large the sphere is whose highest point is looked for.</source>
        <translation>Wie groß die Kugel ist, deren höchster Punkt gesucht wird.</translation>
    </message>
    <message>
        <source>The object that the others are compared with.</source>
        <translation>Das Objekt, mit dem die anderen verglichen werden.</translation>
    </message>
    <message>
        <source>Threshold at</source>
        <translation>Schwelle bei</translation>
    </message>
    <message>
        <source>The differences from the reference that a procedure may choose from.</source>
        <translation>Die Unterschiede zur Referenz, aus denen ein Verfahren wählen kann.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Ratios suit thresholds: from 2 % to 4 % is as far as from 10 % to 20 %. Differences suit tables on both sides of the reference.</source>
        <translation>Verhältnisse passen zu Schwellen: Von 2 % bis 4 % ist es so weit wie von 10 % bis 20 %. Unterschiede passen zu Tabellen auf beiden Seiten der Referenz.</translation>
    </message>
    <message>
        <source>What is different for the participant</source>
        <translation>Was für die Teilnehmenden anders ist</translation>
    </message>
    <message>
        <source>What participants read before this condition</source>
        <translation>Text vor dieser Bedingung</translation>
    </message>
    <message>
        <source>What the settings do not say, such as &quot;Put on the glove.&quot; or &quot;Use your other hand.&quot; Leave it empty if nothing is different. Whoever reads it can tell this condition from the others.</source>
        <translation>Was die Einstellungen nicht sagen, zum Beispiel „Ziehen Sie den Handschuh an.“ oder „Nehmen Sie die andere Hand.“ Lassen Sie das Feld leer, wenn nichts anders ist. Wer den Text liest, kann diese Bedingung von den anderen unterscheiden.</translation>
    </message>
    <message>
        <source>The condition “%1” was removed.</source>
        <translation>Die Bedingung „%1“ wurde entfernt.</translation>
    </message>
    <message>
        <source>The last procedure of this condition was removed.</source>
        <translation>Das letzte Verfahren dieser Bedingung wurde entfernt.</translation>
    </message>
    <message>
        <source>Change of the attribute</source>
        <translation>Änderung der Eigenschaft</translation>
    </message>
    <message>
        <source>The only property in which the objects differ.</source>
        <translation>Die einzige Eigenschaft, in der sich die Objekte unterscheiden.</translation>
    </message>
    <message>
        <source>Lower-case letters, digits and _ only; each condition needs a different one. It follows the English title until somebody types a name.</source>
        <translation>Nur Kleinbuchstaben, Ziffern und _; jede Bedingung braucht einen anderen. Er folgt dem englischen Titel, bis jemand einen anderen eingibt.</translation>
    </message>
    <message>
        <source>Change of the task</source>
        <translation>Änderung der Aufgabe</translation>
    </message>
    <message>
        <source>The threshold is the difference at which this share of the answers is right.</source>
        <translation>Die Schwelle ist der Unterschied, bei dem dieser Anteil der Antworten richtig ist.</translation>
    </message>
    <message>
        <source>Interleave another procedure</source>
        <translation>Weiteres Verfahren einmischen</translation>
    </message>
    <message>
        <source>Remove the last procedure</source>
        <translation>Letztes Verfahren entfernen</translation>
    </message>
    <message>
        <source>Together they have at most %1 trials.</source>
        <translation>Zusammen haben sie höchstens %1 Durchgänge.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ConsentDialog</name>
    <message>
        <source>Consent of %1</source>
        <translation>Einwilligung von %1</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>I have read this and I agree</source>
        <translation>Ich habe dies gelesen und willige ein</translation>
    </message>
    <message>
        <source>Record the consent</source>
        <translation>Einwilligung festhalten</translation>
    </message>
    <message>
        <source>This study has no consent text.</source>
        <translation>Diese Studie hat keinen Einwilligungstext.</translation>
    </message>
    <message>
        <source>The consent was not recorded.
%1</source>
        <translation>Die Einwilligung wurde nicht festgehalten.
%1</translation>
    </message>
    <message>
        <source>The consent of %1 was recorded.</source>
        <translation>Die Einwilligung von %1 wurde festgehalten.</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>The time is recorded, and a checksum (SHA-256) that shows which text you have read. You may withdraw at any time.</source>
        <translation>Festgehalten werden der Zeitpunkt und eine Prüfsumme (SHA-256), die zeigt, welchen Text Sie gelesen haben. Sie können Ihre Teilnahme jederzeit beenden.</translation>
    </message>
    <message>
        <source>Once the participant agrees, tick the box first.</source>
        <translation>Setzen Sie zuerst das Häkchen, sobald die Person zustimmt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ControlBar</name>
    <message>
        <source>Stop force (Esc)</source>
        <translation>Kraft stoppen (Esc)</translation>
    </message>
    <message>
        <source>Resume here</source>
        <translation>Hier fortsetzen</translation>
    </message>
    <message>
        <source>End session …</source>
        <translation>Sitzung beenden …</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Resume (Space)</source>
        <translation>Weiter (Leertaste)</translation>
    </message>
    <message>
        <source>Re-arm (R)</source>
        <translation>Freigeben (R)</translation>
    </message>
    <message>
        <source>Start again …</source>
        <translation>Neu beginnen …</translation>
    </message>
    <message>
        <source>Start again from the beginning (F5). The attempt so far is kept and marked as stopped.</source>
        <translation>Von vorn neu beginnen (F5). Der bisherige Versuch bleibt als abgebrochen erhalten.</translation>
    </message>
    <message>
        <source>End the practice</source>
        <translation>Übung beenden</translation>
    </message>
    <message>
        <source>Go on to the trials that count. Their card is shown first.</source>
        <translation>Weiter zu den Durchgängen, die zählen. Zuerst kommt die Anleitung.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DebriefScreen</name>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · %4</source>
        <translation>%1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Force was shown, not felt: these scores form a separate series and are not compared with scores from felt force.</source>
        <translation>Die Kraft wurde gezeigt, nicht gefühlt: Diese Wertungen bilden eine eigene Reihe und werden nicht mit Wertungen aus gefühlter Kraft verglichen.</translation>
    </message>
    <message>
        <source>Next level</source>
        <translation>Nächste Stufe</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
    <message>
        <source>Watch the worst moment</source>
        <translation>Schlechtesten Moment ansehen</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Report (PDF)</source>
        <translation>Bericht (PDF)</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Open the playback</source>
        <translation>Wiedergabe öffnen</translation>
    </message>
    <message>
        <source>Write the report (PDF)</source>
        <translation>Bericht erstellen (PDF)</translation>
    </message>
    <message>
        <source>Reading the scores …</source>
        <translation>Wertungen werden gelesen …</translation>
    </message>
    <message>
        <source>This session could not be opened</source>
        <translation>Diese Sitzung konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>The recording was erased</source>
        <translation>Die Aufzeichnung wurde gelöscht</translation>
    </message>
    <message>
        <source>It was erased at the person&apos;s request. The scores above are kept; there is nothing to play back.</source>
        <translation>Sie wurde auf Wunsch der Person gelöscht. Die Wertungen oben bleiben erhalten; es gibt nichts wiederzugeben.</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Aufzeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>The recording could not be read. The scores above are as they were stored.</source>
        <translation>Die Aufzeichnung konnte nicht gelesen werden. Die Wertungen oben sind so, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>No trial was finished</source>
        <translation>Kein Durchgang wurde beendet</translation>
    </message>
    <message>
        <source>Chiron session %1.pdf</source>
        <translation>Chiron-Sitzung %1.pdf</translation>
    </message>
    <message>
        <source>Write the report</source>
        <translation>Bericht erstellen</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>Writing the report …</source>
        <translation>Bericht wird erstellt …</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Der Bericht wurde in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The report could not be written.</source>
        <translation>Der Bericht konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Findings and maps could not be read from the recording. The scores above are as they were stored.</source>
        <translation>Funde und Karten konnten aus der Aufzeichnung nicht gelesen werden. Die Wertungen oben sind so, wie sie gespeichert wurden.</translation>
    </message>
    <message>
        <source>Force of the tissue, and what was felt</source>
        <translation>Kraft des Gewebes und was davon gefühlt wurde</translation>
    </message>
    <message>
        <source>The session was not completed: these values are not compared with pass marks.</source>
        <translation>Die Sitzung wurde nicht abgeschlossen: Diese Werte werden an keiner Bestehensgrenze gemessen.</translation>
    </message>
    <message>
        <source>No trial was completed: there is no score.</source>
        <translation>Kein Durchgang wurde abgeschlossen: Es gibt keine Wertung.</translation>
    </message>
    <message>
        <source>Now you</source>
        <translation>Jetzt Sie</translation>
    </message>
    <message>
        <source>Watch an expert</source>
        <translation>Einem Experten zusehen</translation>
    </message>
    <message>
        <source>Worst moment: %1</source>
        <translation>Schlechtester Moment: %1</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>You</source>
        <translation>Sie</translation>
    </message>
    <message>
        <source>Somebody else</source>
        <translation>Jemand anderes</translation>
    </message>
    <message>
        <source>(erased)</source>
        <translation>(gelöscht)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>Looking for the worst moment …</source>
        <translation>Der schlechteste Moment wird gesucht …</translation>
    </message>
    <message>
        <source>The result of this session.

At the top: whether it passed, and if not, which pass mark was missed and by how much. Below, the most important numbers on their scale: the pointer is the value, the line the pass mark, the band what others reached.

&quot;Watch the worst moment&quot; opens the playback where it went wrong most. &quot;Report&quot; writes a printable PDF. The table holds every metric with what it means.</source>
        <translation>Das Ergebnis dieser Sitzung.

Oben: ob sie bestanden ist, und wenn nicht, welche Bestehensgrenze um wie viel verfehlt wurde. Darunter die wichtigsten Zahlen auf ihrer Skala: Der Zeiger ist der Wert, die Linie die Bestehensgrenze, der Bereich das, was andere erreicht haben.

„Schlechtesten Moment ansehen“ öffnet die Wiedergabe an der schlechtesten Stelle. „Bericht“ erstellt ein druckbares PDF. Die Tabelle enthält jede Messgröße und was sie bedeutet.</translation>
    </message>
    <message>
        <source>No moment stands out.</source>
        <translation>Kein Moment fällt besonders auf.</translation>
    </message>
    <message>
        <source>%1 in trial %2, %3 after it began</source>
        <translation>%1 in Durchgang %2, %3 nach dessen Beginn</translation>
    </message>
    <message>
        <source>%1, %2 after the start</source>
        <translation>%1, %2 nach dem Start</translation>
    </message>
    <message>
        <source>%1 (%2 in the recording)</source>
        <translation>%1 (%2 in der Aufzeichnung)</translation>
    </message>
    <message>
        <source>%1, attempt %2 at level %3: %4</source>
        <translation>%1, Versuch %2 auf Stufe %3: %4</translation>
    </message>
    <message>
        <source>What was decided about this session</source>
        <translation>Was zu dieser Sitzung entschieden wurde</translation>
    </message>
    <message>
        <source>somebody whose account is closed</source>
        <translation>jemand, dessen Konto geschlossen ist</translation>
    </message>
    <message>
        <source>Voided on %1 by %2: %3</source>
        <translation>Am %1 von %2 für ungültig erklärt: %3</translation>
    </message>
    <message>
        <source>Set to count again on %1 by %2: %3</source>
        <translation>Zählt wieder seit %1, entschieden von %2: %3</translation>
    </message>
    <message>
        <source>Start a session that counts</source>
        <translation>Sitzung starten, die zählt</translation>
    </message>
    <message>
        <source>%1 · %2: %3</source>
        <translation>%1 · %2: %3</translation>
    </message>
    <message>
        <source>Reply</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>Practise it on level %1</source>
        <translation>Auf Stufe %1 üben</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DeviceChooser</name>
    <message>
        <source>Ready. Force is shown, not felt.</source>
        <translation>Bereit. Kraft wird gezeigt, nicht gefühlt.</translation>
    </message>
    <message>
        <source>Demonstrate</source>
        <translation>Vorführen</translation>
    </message>
    <message>
        <source>Replay a file</source>
        <translation>Datei abspielen</translation>
    </message>
    <message>
        <source>A recorded movement (CSV) moves the tool.</source>
        <translation>Eine aufgezeichnete Bewegung (CSV) führt das Instrument.</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Programmierte Hand</translation>
    </message>
    <message>
        <source>The session is listed as simulated and does not count for anyone.</source>
        <translation>Die Sitzung wird als simuliert geführt und zählt für niemanden.</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>No file is chosen yet.</source>
        <translation>Noch keine Datei gewählt.</translation>
    </message>
    <message>
        <source>Choose a recorded movement</source>
        <translation>Aufgezeichnete Bewegung wählen</translation>
    </message>
    <message>
        <source>Traces (*.csv)</source>
        <translation>Bewegungsdateien (*.csv)</translation>
    </message>
    <message>
        <source>Reading the file …</source>
        <translation>Datei wird gelesen …</translation>
    </message>
    <message numerus="yes">
        <source>Ready: %n rows, %1 s.</source>
        <translation>
            <numerusform>Bereit: %n Zeile, %1 s.</numerusform>
            <numerusform>Bereit: %n Zeilen, %1 s.</numerusform>
        </translation>
    </message>
    <message>
        <source>This file cannot be played. Correct it or choose another.
%1</source>
        <translation>Diese Datei kann nicht abgespielt werden. Berichtigen Sie sie oder wählen Sie eine andere.
%1</translation>
    </message>
    <message>
        <source>There is no demonstration of this exercise on this station.</source>
        <translation>An diesem Arbeitsplatz gibt es für diese Übung keine Vorführung.</translation>
    </message>
    <message>
        <source>A recorded movement (CSV, with orientation) moves the endoscope.</source>
        <translation>Eine aufgezeichnete Bewegung (CSV, mit Orientierung) führt das Endoskop.</translation>
    </message>
    <message>
        <source>A recorded movement (CSV, with the jaw) moves the instruments.</source>
        <translation>Eine aufgezeichnete Bewegung (CSV, mit den Branchen) führt die Instrumente.</translation>
    </message>
    <message>
        <source>Ready. Watch a scripted operator. Device: %1.</source>
        <translation>Bereit. Eine programmierte Hand führt vor. Gerät: %1.</translation>
    </message>
    <message>
        <source>%1, serial number %2</source>
        <translation>%1, Seriennummer %2</translation>
    </message>
    <message numerus="yes">
        <source>Ready. Force is felt. %n device(s) connected.</source>
        <translation>
            <numerusform>Bereit. Kraft ist zu spüren. %n Gerät angeschlossen.</numerusform>
            <numerusform>Bereit. Kraft ist zu spüren. %n Geräte angeschlossen.</numerusform>
        </translation>
    </message>
    <message>
        <source>This level takes %1 devices. Connect %2 more, then open this screen again.</source>
        <translation>Diese Stufe braucht %1 Geräte. Schließen Sie noch %2 an, und öffnen Sie diese Ansicht dann erneut.</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Choose a different device for each instrument.</source>
        <translation>Wählen Sie für jedes Instrument ein anderes Gerät.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::DifferenceTable</name>
    <message>
        <source>Smallest</source>
        <translation>Kleinster</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Anzahl</translation>
    </message>
    <message>
        <source>On both sides of the reference</source>
        <translation>Auf beiden Seiten der Referenz</translation>
    </message>
    <message>
        <source>No candidates yet.</source>
        <translation>Noch keine Kandidaten.</translation>
    </message>
    <message>
        <source>%1 candidates, from %2 to %3 of the reference: %4 to %5.</source>
        <translation>%1 Kandidaten, von %2 bis %3 der Referenz: %4 bis %5.</translation>
    </message>
    <message>
        <source>Too small for anybody to feel.</source>
        <translation>Zu klein, als dass ihn jemand spürt.</translation>
    </message>
    <message>
        <source>Large enough for everybody to feel.</source>
        <translation>So groß, dass ihn jeder spürt.</translation>
    </message>
    <message>
        <source>Differences</source>
        <translation>Unterschiede</translation>
    </message>
    <message>
        <source>Change them one by one, or paste them from a table; numbers may have decimal points or commas.</source>
        <translation>Ändern Sie sie einzeln, oder fügen Sie sie aus einer Tabelle ein; Zahlen dürfen Dezimalpunkte oder -kommas haben.</translation>
    </message>
    <message>
        <source>%1 % less than the reference would be below zero.</source>
        <translation>%1 % weniger als die Referenz läge unter null.</translation>
    </message>
    <message>
        <source>How many differences there are to choose from. Each object is larger than the one before by the same factor.</source>
        <translation>Wie viele Unterschiede zur Wahl stehen. Jedes Objekt ist um denselben Faktor größer als das vorige.</translation>
    </message>
    <message>
        <source>How many differences there are to choose from. They are spaced geometrically: each is larger than the one before by about the same factor.</source>
        <translation>Wie viele Unterschiede zur Wahl stehen. Sie sind geometrisch gestuft: Jeder ist um etwa denselben Faktor größer als der vorige.</translation>
    </message>
    <message>
        <source>The smallest difference has to be below the largest. The table was not changed.</source>
        <translation>Der kleinste Unterschied muss unter dem größten liegen. Die Tabelle wurde nicht geändert.</translation>
    </message>
    <message>
        <source>Objects whose attribute is weaker than the reference&apos;s are presented as well.</source>
        <translation>Auch Objekte, bei denen die Eigenschaft schwächer ist als bei der Referenz, werden dargeboten.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EditPersonDialog</name>
    <message>
        <source>Edit %1</source>
        <translation>%1 bearbeiten</translation>
    </message>
    <message>
        <source>Full name (may be left empty)</source>
        <translation>Vollständiger Name (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>%1 was not changed.
%2</source>
        <translation>%1 wurde nicht geändert.
%2</translation>
    </message>
    <message>
        <source>Sessions recorded so far stay with this person and show the new name. The earlier names stay in the site&apos;s history. The password remains valid.</source>
        <translation>Bisher aufgezeichnete Sitzungen bleiben bei dieser Person und zeigen den neuen Namen. Die früheren Namen bleiben im Verlauf des Standorts. Das Passwort bleibt gültig.</translation>
    </message>
    <message>
        <source>From now on, only %1 can be used to log in.</source>
        <translation>Ab jetzt ist die Anmeldung nur noch mit %1 möglich.</translation>
    </message>
    <message>
        <source>A password slip that was handed out still shows the old login name.</source>
        <translation>Ein schon ausgegebener Passwortzettel zeigt noch den alten Anmeldenamen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EnrolDialog</name>
    <message>
        <source>Enrol a participant</source>
        <translation>Teilnehmende Person aufnehmen</translation>
    </message>
    <message>
        <source>%1 of %2 planned participants are enrolled.</source>
        <translation>%1 von %2 geplanten Personen sind aufgenommen.</translation>
    </message>
    <message>
        <source>Identity (name, number in your own list …)</source>
        <translation>Identität (Name, Nummer in Ihrer eigenen Liste …)</translation>
    </message>
    <message>
        <source>This is kept only in the key table, which only the study&apos;s author and administrators can open. Data and exports carry the code.</source>
        <translation>Das steht nur in der Schlüsseltabelle. Sie kann nur von der Administration und der Person geöffnet werden, die die Studie verfasst hat. Daten und Exporte enthalten den Code.</translation>
    </message>
    <message>
        <source>Enrol</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>The participant was not enrolled.
%1</source>
        <translation>Die Person wurde nicht aufgenommen.
%1</translation>
    </message>
    <message>
        <source>The participant&apos;s code is</source>
        <translation>Der Code der Person ist</translation>
    </message>
    <message>
        <source>Write it down for the participant, who needs it at every session. Consent comes next.</source>
        <translation>Schreiben Sie ihn für die Person auf: Sie braucht ihn bei jeder Sitzung. Als Nächstes kommt die Einwilligung.</translation>
    </message>
    <message>
        <source>Record the consent now</source>
        <translation>Einwilligung jetzt festhalten</translation>
    </message>
    <message>
        <source>Login name, if the participant has an account here (optional)</source>
        <translation>Anmeldename, falls die Person hier ein Konto hat (optional)</translation>
    </message>
    <message>
        <source>With the login name, an export or erasure of this person&apos;s data also covers what they do in this study. The name is kept only in the key table; no list and no export of the study shows it.</source>
        <translation>Mit dem Anmeldenamen erfasst ein Export oder eine Löschung der Daten dieser Person auch, was sie in dieser Studie tut. Der Name steht nur in der Schlüsseltabelle; keine Liste und kein Export der Studie zeigt ihn.</translation>
    </message>
    <message>
        <source>Nobody has an account with the login name “%1”. Nobody was enrolled. Correct the name, or leave the field empty.</source>
        <translation>Niemand hat ein Konto mit dem Anmeldenamen „%1“. Es wurde niemand aufgenommen. Korrigieren Sie den Namen, oder lassen Sie das Feld leer.</translation>
    </message>
    <message>
        <source>Enter an identity first, or a login name.</source>
        <translation>Geben Sie zuerst eine Identität oder einen Anmeldenamen ein.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EraseDialog</name>
    <message>
        <source>Erase %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>This cannot be undone. Disabling the account keeps everything and can be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen. Ein deaktiviertes Konto behält alles und lässt sich wieder aktivieren.</translation>
    </message>
    <message>
        <source>Overwritten: name, code, password, comments and reasons in free text.</source>
        <translation>Überschrieben werden: Name, Code, Passwort, Kommentare und Begründungen im Freitext.</translation>
    </message>
    <message>
        <source>Kept without a name: sessions, scores, and a note of when and why the person was erased. Earlier backups still contain the person until they are deleted; restoring one erases the person again.</source>
        <translation>Ohne Namen bleiben erhalten: Sitzungen, Wertungen und ein Vermerk, wann und warum gelöscht wurde. Ältere Sicherungen enthalten die Person, bis die Sicherungen gelöscht werden; beim Wiederherstellen wird die Person erneut gelöscht.</translation>
    </message>
    <message>
        <source>Consent is withdrawn: overwrite the recordings too</source>
        <translation>Einwilligung widerrufen: auch die Aufzeichnungen überschreiben</translation>
    </message>
    <message>
        <source>Type the login name to confirm: %1</source>
        <translation>Zur Bestätigung den Anmeldenamen eingeben: %1</translation>
    </message>
    <message>
        <source>%1 was erased. Sessions and scores are kept without a name.</source>
        <translation>%1 wurde gelöscht. Sitzungen und Wertungen bleiben ohne Namen erhalten.</translation>
    </message>
    <message>
        <source>%1 cannot be erased now. You cannot erase yourself, and no session may be running.</source>
        <translation>%1 kann jetzt nicht gelöscht werden. Sie können sich nicht selbst löschen, und es darf keine Sitzung laufen.</translation>
    </message>
    <message>
        <source>This erases an account, and the identity of the person in studies whose key table lists the account. A participant who is known only by a code is erased with &quot;Erase a participant&quot;.</source>
        <translation>Hier werden ein Konto und die Identität der Person in den Studien gelöscht, deren Schlüsseltabelle das Konto nennt. Wer nur unter einem Code bekannt ist, wird mit „Teilnehmer/in löschen“ gelöscht.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::EraseParticipantDialog</name>
    <message>
        <source>Erase a study participant</source>
        <translation>Studienteilnehmer/in löschen</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Participant who has withdrawn</source>
        <translation>Zurückgezogene Teilnahme</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read.
%1</source>
        <translation>Die Studien konnten nicht gelesen werden.
%1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Overwritten: who the participant was, the answers to questionnaires, comments on their sessions and, as the participant wished, the recordings. Kept under the code: runs and trials.</source>
        <translation>Überschrieben werden: die Identität der Person, ihre Antworten auf Fragebögen, Kommentare zu ihren Sitzungen und, wie von ihr gewünscht, die Aufzeichnungen. Unter dem Code bleiben Läufe und Durchgänge erhalten.</translation>
    </message>
    <message>
        <source>Overwritten: who the participant was, the answers to questionnaires and comments on their sessions. Kept under the code: runs, trials and recordings; the participant did not ask for the recordings to be erased.</source>
        <translation>Überschrieben werden: die Identität der Person, ihre Antworten auf Fragebögen und Kommentare zu ihren Sitzungen. Unter dem Code bleiben Läufe, Durchgänge und Aufzeichnungen erhalten; die Löschung der Aufzeichnungen wurde nicht gewünscht.</translation>
    </message>
    <message>
        <source>%1 was erased. Runs and trials are kept under the code.</source>
        <translation>%1 wurde gelöscht. Läufe und Durchgänge bleiben unter dem Code erhalten.</translation>
    </message>
    <message>
        <source>%1 cannot be erased now: no session of the participant may be running.</source>
        <translation>%1 kann jetzt nicht gelöscht werden: Es darf keine Sitzung dieser Person laufen.</translation>
    </message>
    <message>
        <source>This erases the identity behind the code in one study; if the same person has an account, it stays. To erase an account, choose the person in the list and press &quot;Erase&quot;.</source>
        <translation>Hier wird die Identität gelöscht, die in einer Studie hinter dem Code steht; hat dieselbe Person ein Konto, bleibt es bestehen. Um ein Konto zu löschen, wählen Sie die Person in der Liste und drücken Sie „Löschen“.</translation>
    </message>
    <message>
        <source>No participant who has withdrawn is waiting to be erased. Researchers withdraw a participant on the study&apos;s Run screen.</source>
        <translation>Es wartet niemand, der die Teilnahme zurückgezogen hat, auf die Löschung. Forschende ziehen eine Teilnahme im Bereich „Durchführen“ der Studie zurück.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ErasureDialog</name>
    <message>
        <source>Reason (kept)</source>
        <translation>Begründung (bleibt gespeichert)</translation>
    </message>
    <message>
        <source>Your own password</source>
        <translation>Ihr eigenes Passwort</translation>
    </message>
    <message>
        <source>Erase permanently</source>
        <translation>Endgültig löschen</translation>
    </message>
    <message>
        <source>The erasure of %1 is not complete: the file may still contain old copies. Press the button again to continue where it stopped.
%2</source>
        <translation>Die Löschung von %1 ist nicht vollständig: Die Datei kann noch alte Kopien enthalten. Drücken Sie die Schaltfläche erneut, um fortzufahren.
%2</translation>
    </message>
    <message>
        <source>%1 was not erased.
%2</source>
        <translation>%1 wurde nicht gelöscht.
%2</translation>
    </message>
    <message>
        <source>Nobody was erased.</source>
        <translation>Es wurde niemand gelöscht.</translation>
    </message>
    <message>
        <source>Nobody was erased.
%1</source>
        <translation>Es wurde niemand gelöscht.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseCard</name>
    <message>
        <source>Passed with shown force</source>
        <translation>Mit gezeigter Kraft bestanden</translation>
    </message>
    <message numerus="yes">
        <source>%n attempt(s), not passed yet</source>
        <translation>
            <numerusform>%n Versuch, noch nicht bestanden</numerusform>
            <numerusform>%n Versuche, noch nicht bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1 · next step</source>
        <translation>%1 · nächster Schritt</translation>
    </message>
    <message>
        <source>Passed with felt and with shown force</source>
        <translation>Mit gefühlter und mit gezeigter Kraft bestanden</translation>
    </message>
    <message>
        <source>Passed with felt force</source>
        <translation>Mit gefühlter Kraft bestanden</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExerciseSetupScreen</name>
    <message>
        <source>What is measured</source>
        <translation>Was gemessen wird</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Familiarisation: recorded, but not counted</source>
        <translation>Eingewöhnung (zählt nicht)</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Starten</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Here you see what an exercise asks for, what is measured and when it is passed.

Everything is already chosen: press &quot;Start&quot; (or Enter) to begin. Choose another level, or a device, if you want. &quot;Demonstrate&quot; lets you watch a scripted operator; its session does not count for anyone. A file with a recorded movement can be replayed through the same exercise.

&quot;Hand and workspace&quot; sets which hand you work with, how far the tool moves when your hand moves, and where the middle of the field lies. A familiarisation is recorded, but never counted.</source>
        <translation>Hier sehen Sie, was eine Übung verlangt, was gemessen wird und wann sie bestanden ist.

Alles ist schon gewählt: Drücken Sie „Starten“ (oder Enter), um zu beginnen. Wählen Sie auf Wunsch eine andere Stufe oder ein anderes Gerät. Bei „Vorführen“ sehen Sie einer programmierten Hand zu; deren Sitzung zählt für niemanden. Eine Datei mit einer aufgezeichneten Bewegung lässt sich in derselben Übung abspielen.

„Hand und Arbeitsraum“ legt fest, mit welcher Hand Sie arbeiten, wie weit sich das Instrument bei einer Handbewegung bewegt und wo die Mitte des Feldes liegt. Eine Eingewöhnung wird aufgezeichnet, zählt aber nie.</translation>
    </message>
    <message>
        <source>This exercise does not exist</source>
        <translation>Diese Übung gibt es nicht</translation>
    </message>
    <message>
        <source>The content on this station has no exercise of that name.</source>
        <translation>Der Inhalt an diesem Arbeitsplatz enthält keine Übung dieses Namens.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Your earlier results could not be read. You can still train.</source>
        <translation>Ihre früheren Ergebnisse konnten nicht gelesen werden. Sie können trotzdem trainieren.</translation>
    </message>
    <message>
        <source>This level has no pass mark.</source>
        <translation>Diese Stufe hat keine Bestehensgrenze.</translation>
    </message>
    <message>
        <source>Level %1. %2</source>
        <translation>Stufe %1. %2</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>Zusehen</translation>
    </message>
    <message>
        <source>Watch first</source>
        <translation>Erst zusehen</translation>
    </message>
    <message>
        <source>Watch a scripted expert at this level. Nothing is counted.</source>
        <translation>Sehen Sie auf dieser Stufe einem programmierten Experten zu. Nichts davon wird gewertet.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExercisesScreen</name>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>All exercises of this site and their levels.

Each level says whether you have passed it. Choose one to see what is measured and what counts as passed, choose a device, and start.</source>
        <translation>Alle Übungen dieses Standorts und ihre Stufen.

Jede Stufe zeigt, ob Sie sie bestanden haben. Wählen Sie eine, um zu sehen, was gemessen wird und was als bestanden gilt, wählen Sie ein Gerät und beginnen Sie.</translation>
    </message>
    <message>
        <source>Loading the exercises …</source>
        <translation>Übungen werden geladen …</translation>
    </message>
    <message>
        <source>The exercises could not be loaded.</source>
        <translation>Die Übungen konnten nicht geladen werden.</translation>
    </message>
    <message>
        <source>There are no exercises</source>
        <translation>Es gibt keine Übungen</translation>
    </message>
    <message>
        <source>The content folder of this site contains no exercises. Ask an administrator.</source>
        <translation>Der Inhaltsordner dieses Standorts enthält keine Übungen. Fragen Sie die Administration.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExperimenterGate</name>
    <message>
        <source>For the experimenter</source>
        <translation>Für die Versuchsleitung</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Passwort von %1</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ExperimenterPanel</name>
    <message>
        <source>Experimenter</source>
        <translation>Versuchsleitung</translation>
    </message>
    <message>
        <source>Discard this trial</source>
        <translation>Durchgang verwerfen</translation>
    </message>
    <message>
        <source>It does not count and is presented again.</source>
        <translation>Er zählt nicht und wird noch einmal dargeboten.</translation>
    </message>
    <message>
        <source>Pause (Space)</source>
        <translation>Pause (Leertaste)</translation>
    </message>
    <message>
        <source>Stop …</source>
        <translation>Beenden …</translation>
    </message>
    <message>
        <source>Condition %1 (sealed)</source>
        <translation>Bedingung %1 (versiegelt)</translation>
    </message>
    <message>
        <source>%1 of at most %2 trials</source>
        <translation>%1 von höchstens %2 Durchgängen</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s)</source>
        <translation>
            <numerusform>%n Durchgang</numerusform>
            <numerusform>%n Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>Practice, not scored. %1</source>
        <translation>Übung, zählt nicht. %1</translation>
    </message>
    <message>
        <source>%1, %2 repeated</source>
        <translation>%1, %2 wiederholt</translation>
    </message>
    <message>
        <source>Resume (Space)</source>
        <translation>Weiter (Leertaste)</translation>
    </message>
    <message>
        <source>The estimate stays sealed until the study is unblinded.</source>
        <translation>Die Schätzung bleibt versiegelt, bis die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>The fidelity of each trial will appear here.</source>
        <translation>Die Wiedergabetreue jedes Durchgangs erscheint hier.</translation>
    </message>
    <message>
        <source>Last trial: counted.</source>
        <translation>Letzter Durchgang: zählt.</translation>
    </message>
    <message>
        <source>Last trial: repeated. %1.</source>
        <translation>Letzter Durchgang: wird wiederholt. %1.</translation>
    </message>
    <message>
        <source>Peak force %1 N, mean speed %2 mm/s, %3 contacts, %4 s.</source>
        <translation>Spitzenkraft %1 N, mittlere Geschwindigkeit %2 mm/s, %3 Kontakte, %4 s.</translation>
    </message>
    <message>
        <source>Felt value off by %1, late ticks %2, device at its limit %3.</source>
        <translation>Abweichung des gefühlten Werts: %1; verspätete Takte: %2; Gerät an der Grenze: %3.</translation>
    </message>
    <message>
        <source>Force error %1 N.</source>
        <translation>Kraftfehler %1 N.</translation>
    </message>
    <message>
        <source>The device measures no force.</source>
        <translation>Das Gerät misst keine Kraft.</translation>
    </message>
    <message numerus="yes">
        <source>The device cannot render all differences: %n remain.</source>
        <translation>
            <numerusform>Das Gerät kann nicht alle Unterschiede wiedergeben: %n bleibt.</numerusform>
            <numerusform>Das Gerät kann nicht alle Unterschiede wiedergeben: %n bleiben.</numerusform>
        </translation>
    </message>
    <message>
        <source>The estimate will appear here after the first scored trials.</source>
        <translation>Die Schätzung erscheint hier nach den ersten gewerteten Durchgängen.</translation>
    </message>
    <message>
        <source>Weber fraction %1</source>
        <translation>Weber-Bruch %1</translation>
    </message>
    <message>
        <source>Weber fraction %1 (95 %: %2)</source>
        <translation>Weber-Bruch %1 (95 %: %2)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message>
        <source>procedure %1</source>
        <translation>Verfahren %1</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Force is shown, not felt, so rendering is not limited.</source>
        <translation>Die Kraft wird gezeigt, nicht gefühlt; die Darstellung ist nicht begrenzt.</translation>
    </message>
    <message>
        <source>Measured delay of the device: %1 ms.</source>
        <translation>Gemessene Verzögerung des Geräts: %1 ms.</translation>
    </message>
    <message>
        <source>The delay of this device was never measured. A cautious value of %1 ms is assumed, based on what the device states.</source>
        <translation>Die Verzögerung dieses Geräts wurde nie gemessen. Nach den Angaben des Geräts werden vorsichtshalber %1 ms angenommen.</translation>
    </message>
    <message>
        <source>Mean speed %1 mm/s, %2 contacts, %3 s, late ticks %4. Forces stay sealed: they would reveal the condition.</source>
        <translation>Mittlere Geschwindigkeit %1 mm/s, %2 Kontakte, %3 s, verspätete Takte %4. Kräfte bleiben versiegelt: Sie würden die Bedingung verraten.</translation>
    </message>
    <message>
        <source>It will not count</source>
        <translation>Zählt nicht</translation>
    </message>
    <message>
        <source>The bias will appear here after the first scored trials.</source>
        <translation>Die Verschiebung erscheint hier nach den ersten gewerteten Durchgängen.</translation>
    </message>
    <message>
        <source>Bias so far: %1 mm to the right, %2 mm away from you. Mean error %3 mm per axis.</source>
        <translation>Verschiebung bisher: %1 mm nach rechts, %2 mm nach hinten. Mittlerer Fehler %3 mm je Achse.</translation>
    </message>
    <message>
        <source>marks</source>
        <translation>Markierungen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FieldGrid</name>
    <message>
        <source>“%1” was not accepted: enter a number without a unit. The value is still %2.</source>
        <translation>„%1“ wurde nicht übernommen: Geben Sie eine Zahl ohne Einheit ein. Es bleibt bei %2.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: enter a value in %2. The value is still %3.</source>
        <translation>„%1“ wurde nicht übernommen: Geben Sie einen Wert in %2 ein. Es bleibt bei %3.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: it has more decimals than this field keeps. The value is still %2.</source>
        <translation>„%1“ wurde nicht übernommen: Hier werden weniger Nachkommastellen gespeichert. Es bleibt bei %2.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: choose a value from %2 to %3. The value is still %4.</source>
        <translation>„%1“ wurde nicht übernommen: Wählen Sie einen Wert von %2 bis %3. Es bleibt bei %4.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: enter a whole number from %2 to %3. The value is still %4.</source>
        <translation>„%1“ wurde nicht übernommen: Geben Sie eine ganze Zahl von %2 bis %3 ein. Es bleibt bei %4.</translation>
    </message>
    <message>
        <source>%1 to %2, usually %3.</source>
        <translation>%1 bis %2, meist %3.</translation>
    </message>
    <message>
        <source>A number is needed here. The value is still %1.</source>
        <translation>Hier wird eine Zahl gebraucht. Es bleibt bei %1.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: each number has to be from %2 to %3.</source>
        <translation>„%1“ wurde nicht übernommen: Jede Zahl muss von %2 bis %3 sein.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FindingsBox</name>
    <message>
        <source>Findings</source>
        <translation>Funde</translation>
    </message>
    <message>
        <source>Take back</source>
        <translation>Zurücknehmen</translation>
    </message>
    <message>
        <source>Take the selected finding back (Delete)</source>
        <translation>Gewählten Fund zurücknehmen (Entf)</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Nothing found: end the trial (D)</source>
        <translation>Nichts gefunden: Ende (D)</translation>
    </message>
    <message>
        <source>Nothing more to report (D)</source>
        <translation>Nichts mehr (D)</translation>
    </message>
    <message>
        <source>No finding is selected.</source>
        <translation>Kein Fund ist gewählt.</translation>
    </message>
    <message>
        <source>Still missing:
%1
Press again to end the trial without it.</source>
        <translation>Es fehlt noch:
%1
Drücken Sie erneut, um den Durchgang ohne diese Angaben zu beenden.</translation>
    </message>
    <message>
        <source>None yet. Press where the tissue is firmer, then mark the place (Enter).</source>
        <translation>Noch keine. Drücken Sie, wo das Gewebe fester ist, und markieren Sie die Stelle (Enter).</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FirstStartScreen</name>
    <message>
        <source>Welcome</source>
        <translation>Willkommen</translation>
    </message>
    <message>
        <source>Chiron is a training suite for the sense of touch in minimally invasive surgery.

&quot;Set up this site&quot; creates an empty site on this computer and its first administrator, who can add the others. It takes about a minute.

&quot;Open the demonstration site&quot; creates a separate site with invented people and scripted sessions, so that you can look around. It does not affect a site that you set up later. Until you set one up, this choice appears at every start.</source>
        <translation>Chiron trainiert den Tastsinn für die minimalinvasive Chirurgie.

„Standort einrichten“ legt auf diesem Computer einen leeren Standort und das erste Administrationskonto an, mit dem sich weitere Personen hinzufügen lassen. Das dauert etwa eine Minute.

„Demo-Standort öffnen“ legt zum Umsehen einen getrennten Standort mit erfundenen Personen und vorbereiteten Sitzungen an. Ein später eingerichteter Standort bleibt davon unberührt; bis dahin erscheint diese Auswahl bei jedem Start.</translation>
    </message>
    <message>
        <source>The recovery code is not shown again. Write it down and tick the box first.</source>
        <translation>Der Wiederherstellungscode wird nicht noch einmal gezeigt. Schreiben Sie ihn zuerst auf und setzen Sie das Häkchen.</translation>
    </message>
    <message>
        <source>Welcome to Chiron</source>
        <translation>Willkommen bei Chiron</translation>
    </message>
    <message>
        <source>Learn by touch: practise, see what your hand did, and know when you are ready.</source>
        <translation>Lernen durch Tasten: üben, sehen, was Ihre Hand getan hat, und wissen, wann Sie so weit sind.</translation>
    </message>
    <message>
        <source>Set up this site</source>
        <translation>Standort einrichten</translation>
    </message>
    <message>
        <source>Set up your own site</source>
        <translation>Eigenen Standort einrichten</translation>
    </message>
    <message>
        <source>You become its administrator. People, sessions and scores stay on this computer.</source>
        <translation>Sie übernehmen die Administration. Personen, Sitzungen und Wertungen bleiben auf diesem Computer.</translation>
    </message>
    <message>
        <source>Open the demonstration site</source>
        <translation>Demo-Standort öffnen</translation>
    </message>
    <message>
        <source>Look around first</source>
        <translation>Erst einmal umsehen</translation>
    </message>
    <message>
        <source>Invented people and scripted sessions at every level. Creating them takes about a minute, only once.</source>
        <translation>Erfundene Personen und vorbereitete Sitzungen auf jeder Stufe. Das Anlegen dauert einmalig etwa eine Minute.</translation>
    </message>
    <message>
        <source>The site was not created.
%1</source>
        <translation>Der Standort wurde nicht angelegt.
%1</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Opening the demonstration site …</source>
        <translation>Demo-Standort wird geöffnet …</translation>
    </message>
    <message>
        <source>Creating the demonstration site: people, and scripted sessions at every level …</source>
        <translation>Demo-Standort wird angelegt: Personen und vorbereitete Sitzungen auf jeder Stufe …</translation>
    </message>
    <message>
        <source>Creation of the demonstration site was stopped; what had been created was removed.</source>
        <translation>Das Anlegen des Demo-Standorts wurde abgebrochen; bereits Angelegtes wurde entfernt.</translation>
    </message>
    <message>
        <source>The demonstration site could not be opened.</source>
        <translation>Der Demo-Standort konnte nicht geöffnet werden.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ForceBar</name>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>%1 %2, over the limit</source>
        <translation>%1 %2, über der Grenze</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FormDialog</name>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Working …</source>
        <translation>Bitte warten …</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::FreezeDialog</name>
    <message>
        <source>Freeze %1</source>
        <translation>%1 einfrieren</translation>
    </message>
    <message>
        <source>From now on nobody can change the design. Participants can be enrolled, each condition gets a sealed code, and every export carries this SHA-256 of the design:</source>
        <translation>Von jetzt an kann niemand den Entwurf mehr ändern. Personen können aufgenommen werden, jede Bedingung bekommt einen versiegelten Code, und jeder Export trägt diesen SHA-256 des Entwurfs:</translation>
    </message>
    <message numerus="yes">
        <source>%n condition(s)</source>
        <translation>
            <numerusform>%n Bedingung</numerusform>
            <numerusform>%n Bedingungen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) planned</source>
        <translation>
            <numerusform>%n Person geplant</numerusform>
            <numerusform>%n Personen geplant</numerusform>
        </translation>
    </message>
    <message>
        <source>This cannot be undone. To change the study later, copy it into a new one.</source>
        <translation>Das lässt sich nicht rückgängig machen. Um die Studie später zu ändern, kopieren Sie sie in eine neue.</translation>
    </message>
    <message>
        <source>Freeze the design</source>
        <translation>Entwurf einfrieren</translation>
    </message>
    <message>
        <source>The study could not be frozen.
%1</source>
        <translation>Die Studie konnte nicht eingefroren werden.
%1</translation>
    </message>
    <message>
        <source>Frozen. Participants can be enrolled now.</source>
        <translation>Eingefroren. Jetzt können Personen aufgenommen werden.</translation>
    </message>
    <message>
        <source>I have seen the points that are worth a look and freeze the design anyway</source>
        <translation>Ich habe die Punkte gesehen, die einen Blick wert sind, und friere den Entwurf trotzdem ein</translation>
    </message>
    <message>
        <source>What is marked in red must be corrected first: after freezing, nobody can change it.</source>
        <translation>Was rot markiert ist, muss zuerst berichtigt werden: Nach dem Einfrieren kann es niemand mehr ändern.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GeneralPage</name>
    <message>
        <source>Planned participants</source>
        <translation>Geplante Teilnehmende</translation>
    </message>
    <message>
        <source>Number of participants</source>
        <translation>Zahl der Teilnehmenden</translation>
    </message>
    <message>
        <source>Source of the design</source>
        <translation>Quelle des Entwurfs</translation>
    </message>
    <message>
        <source>Where the design was published, with its DOI; empty for a design of your own.</source>
        <translation>Wo der Entwurf veröffentlicht wurde, mit DOI; leer bei einem eigenen Entwurf.</translation>
    </message>
    <message>
        <source>One or two sentences: what is to be found out, and what is expected. It is frozen with the study.</source>
        <translation>Ein oder zwei Sätze: was herausgefunden werden soll und was erwartet wird. Sie werden mit der Studie eingefroren.</translation>
    </message>
    <message>
        <source>For example: whether tubes of 60 N/m and 120 N/m have the same Weber fraction. We expect no difference.</source>
        <translation>Zum Beispiel: ob Schläuche mit 60 N/m und 120 N/m denselben Weber-Bruch haben. Wir erwarten keinen Unterschied.</translation>
    </message>
    <message>
        <source>Ethics approval</source>
        <translation>Ethikvotum</translation>
    </message>
    <message>
        <source>The committee with the number and date of its approval, or why none is needed. It is frozen with the study.</source>
        <translation>Die Kommission mit Nummer und Datum ihres Votums, oder warum keines nötig ist. Es wird mit der Studie eingefroren.</translation>
    </message>
    <message>
        <source>What participants agree to before their first trial. The text that was shown is stored with each consent.</source>
        <translation>Worin Teilnehmende vor dem ersten Durchgang einwilligen. Mit jeder Einwilligung wird der gezeigte Text gespeichert.</translation>
    </message>
    <message>
        <source>Title (required)</source>
        <translation>Titel (erforderlich)</translation>
    </message>
    <message>
        <source>Aim (required)</source>
        <translation>Ziel (erforderlich)</translation>
    </message>
    <message>
        <source>Ethics approval (required)</source>
        <translation>Ethikvotum (erforderlich)</translation>
    </message>
    <message>
        <source>Consent text (required)</source>
        <translation>Text der Einwilligung (erforderlich)</translation>
    </message>
    <message>
        <source>The study&apos;s name in lists, reports and exports.</source>
        <translation>Der Name der Studie in Listen, Berichten und Exporten.</translation>
    </message>
    <message>
        <source>Aim and ethics</source>
        <translation>Ziel und Ethik</translation>
    </message>
    <message>
        <source>How many people are to take part; the page “Expected precision” shows which difference this number can detect.</source>
        <translation>Wie viele Personen teilnehmen sollen; die Seite „Erwartete Genauigkeit“ zeigt, welchen Unterschied diese Anzahl nachweisen kann.</translation>
    </message>
    <message>
        <source>Consent and source</source>
        <translation>Einwilligung und Quelle</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GraspPanel</name>
    <message>
        <source>Holding time completed</source>
        <translation>Absolvierte Haltezeit</translation>
    </message>
    <message>
        <source>Holding time: %p %</source>
        <translation>Haltezeit: %p %</translation>
    </message>
    <message>
        <source>Tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>Squeeze</source>
        <translation>Quetschkraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Force, right</source>
        <translation>Kraft, rechts</translation>
    </message>
    <message>
        <source>Force, left</source>
        <translation>Kraft, links</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>away</source>
        <translation>weg</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>jaw (°)</source>
        <translation>Branchen (°)</translation>
    </message>
    <message>
        <source>%1, tip (mm)</source>
        <translation>%1, Spitze (mm)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
    <message>
        <source>Force, right (N)</source>
        <translation>Kraft, rechts (N)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>Stretched by %1 mm</source>
        <translation>Um %1 mm gedehnt</translation>
    </message>
    <message>
        <source>Pull of the load, downwards: %1 N</source>
        <translation>Zug der Last, nach unten: %1 N</translation>
    </message>
    <message>
        <source>Pull on the fold</source>
        <translation>Zug an der Falte</translation>
    </message>
    <message>
        <source>Force, instrument %1</source>
        <translation>Kraft, Instrument %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::GroupPage</name>
    <message>
        <source>Nobody has run this condition yet. Each participant&apos;s result appears here after their first run.</source>
        <translation>Diese Bedingung hat noch niemand durchlaufen. Das Ergebnis jeder Person erscheint hier nach ihrem ersten Lauf.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>prediction for a new participant: %1</source>
        <translation>Vorhersage für eine weitere Person: %1</translation>
    </message>
    <message>
        <source>JND %1</source>
        <translation>JND %1</translation>
    </message>
    <message>
        <source>Rankings entirely correct: %1 of %2 (%3; chance level 16.7 %)</source>
        <translation>Vollständig richtige Rangfolgen: %1 von %2 (%3; Zufallsniveau 16,7 %)</translation>
    </message>
    <message>
        <source>Weber fraction of each participant</source>
        <translation>Weber-Bruch jeder Person</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message>
        <source>Participant</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>No estimate yet</source>
        <translation>Noch keine Schätzung</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>JND</source>
        <translation>JND</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Lauf</translation>
    </message>
    <message>
        <source>Warnings</source>
        <translation>Warnungen</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>%1 (%2 repeated)</source>
        <translation>%1 (%2 wiederholt)</translation>
    </message>
    <message>
        <source>Rankings entirely correct: %1 of %2 (%3; chance level 16.7 % or less)</source>
        <translation>Vollständig richtige Rangfolgen: %1 von %2 (%3; Zufallsniveau höchstens 16,7 %)</translation>
    </message>
    <message>
        <source>Prior influence</source>
        <translation>Anteil der A-priori-Verteilung</translation>
    </message>
    <message>
        <source>Compare the conditions</source>
        <translation>Bedingungen vergleichen</translation>
    </message>
    <message>
        <source>Weber fraction (random effects)</source>
        <translation>Weber-Bruch (Zufallseffekte)</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Exponent des Potenzgesetzes</translation>
    </message>
    <message>
        <source>In the group</source>
        <translation>In der Gruppe</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HeaderBar</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 · familiarisation, not counted</source>
        <translation>%1 · Eingewöhnung, zählt nicht</translation>
    </message>
    <message>
        <source>Sound off</source>
        <translation>Ton aus</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>Sound on</source>
        <translation>Ton an</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HeadlineCard</name>
    <message>
        <source>No pass mark</source>
        <translation>Keine Bestehensgrenze</translation>
    </message>
    <message>
        <source>Pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Met: pass mark %1</source>
        <translation>Erreicht: Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Not met: pass mark %1</source>
        <translation>Nicht erreicht: Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>Benchmark %1 (%2)</source>
        <translation>Referenz %1 (%2)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::HomeScreen</name>
    <message>
        <source>Every level is passed</source>
        <translation>Alle Stufen bestanden</translation>
    </message>
    <message>
        <source>Continue where you left off</source>
        <translation>Weitermachen, wo Sie aufgehört haben</translation>
    </message>
    <message>
        <source>Your next step</source>
        <translation>Ihr nächster Schritt</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>My progress</source>
        <translation>Mein Fortschritt</translation>
    </message>
    <message>
        <source>Nothing recorded yet. Your first session appears here once it has ended.</source>
        <translation>Noch nichts aufgezeichnet. Ihre erste Sitzung erscheint hier, sobald sie beendet ist.</translation>
    </message>
    <message>
        <source>All my results</source>
        <translation>Alle meine Ergebnisse</translation>
    </message>
    <message>
        <source>Sessions to review</source>
        <translation>Zu begutachtende Sitzungen</translation>
    </message>
    <message>
        <source>Nobody has trained yet. Trainees&apos; sessions will appear here, interrupted ones first.</source>
        <translation>Noch niemand hat trainiert. Hier erscheinen die Sitzungen der Lernenden, abgebrochene zuerst.</translation>
    </message>
    <message>
        <source>All sessions</source>
        <translation>Alle Sitzungen</translation>
    </message>
    <message>
        <source>Recent training</source>
        <translation>Wer zuletzt trainiert hat</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in the last 7 days</source>
        <translation>
            <numerusform>%n Sitzung in den letzten 7 Tagen</numerusform>
            <numerusform>%n Sitzungen in den letzten 7 Tagen</numerusform>
        </translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Every recorded session, by code instead of by name: filter the list, play sessions back, save the list as a table.</source>
        <translation>Jede aufgezeichnete Sitzung, mit Code statt Namen: Liste filtern, Sitzungen wiedergeben, Liste als Tabelle speichern.</translation>
    </message>
    <message>
        <source>Open the data</source>
        <translation>Daten öffnen</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message numerus="yes">
        <source>%n account(s) can log in.</source>
        <translation>
            <numerusform>%n Person kann sich anmelden.</numerusform>
            <numerusform>%n Personen können sich anmelden.</numerusform>
        </translation>
    </message>
    <message>
        <source>Open people</source>
        <translation>Personen öffnen</translation>
    </message>
    <message>
        <source>Storage</source>
        <translation>Datensicherung</translation>
    </message>
    <message>
        <source>The database uses %1; %2 is free.</source>
        <translation>Die Datenbank belegt %1; %2 sind frei.</translation>
    </message>
    <message>
        <source>Open storage</source>
        <translation>Datensicherung öffnen</translation>
    </message>
    <message>
        <source>The last session ran with real-time priority.</source>
        <translation>Die letzte Sitzung lief mit Echtzeitpriorität.</translation>
    </message>
    <message>
        <source>The last session ran without real-time priority: forces may feel less smooth.</source>
        <translation>Die letzte Sitzung lief ohne Echtzeitpriorität: Kräfte fühlen sich womöglich weniger gleichmäßig an.</translation>
    </message>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Devices, timing of the force loop, free space for recordings.</source>
        <translation>Geräte, Takttreue der Kraftregelung, freier Platz für Aufzeichnungen.</translation>
    </message>
    <message>
        <source>Open the station check</source>
        <translation>Arbeitsplatzprüfung öffnen</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Start</translation>
    </message>
    <message>
        <source>Finding your next step …</source>
        <translation>Nächster Schritt wird gesucht …</translation>
    </message>
    <message>
        <source>The home screen could not be loaded.</source>
        <translation>Die Startansicht konnte nicht geladen werden.</translation>
    </message>
    <message>
        <source>Welcome, %1</source>
        <translation>Willkommen, %1</translation>
    </message>
    <message numerus="yes">
        <source>The program ended unexpectedly during session %1 (%2, %3). The session was saved as interrupted: %n sample(s) were kept and can be played back. The session does not count.</source>
        <translation>
            <numerusform>Das Programm wurde während Sitzung %1 (%2, %3) unerwartet beendet. Die Sitzung wurde als unterbrochen gespeichert: %n Messpunkt ist erhalten und kann wiedergegeben werden. Sie zählt nicht.</numerusform>
            <numerusform>Das Programm wurde während Sitzung %1 (%2, %3) unerwartet beendet. Die Sitzung wurde als unterbrochen gespeichert: %n Messpunkte sind erhalten und können wiedergegeben werden. Sie zählt nicht.</numerusform>
        </translation>
    </message>
    <message>
        <source>The program ended unexpectedly during session %1 (%2, %3). The session could not be fully recovered: %4</source>
        <translation>Das Programm wurde während Sitzung %1 (%2, %3) unerwartet beendet. Die Sitzung konnte nicht vollständig wiederhergestellt werden: %4</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansehen</translation>
    </message>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Design a study or begin with a template, try it with simulated observers, freeze it, enrol participants.</source>
        <translation>Eine Studie entwerfen oder mit einer Vorlage beginnen, mit simulierten Beobachtern erproben, einfrieren, Personen aufnehmen.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Studien öffnen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Guide a participant through a study by code, in the order set for them. Interrupted runs continue where they stopped.</source>
        <translation>Eine Person anhand ihres Codes und in der für sie festgelegten Reihenfolge durch eine Studie führen. Unterbrochene Läufe gehen dort weiter, wo sie aufgehört haben.</translation>
    </message>
    <message>
        <source>Run a study</source>
        <translation>Studie durchführen</translation>
    </message>
    <message>
        <source>Curves, thresholds and intervals of each person and the group, every trial with its fidelity, exports.</source>
        <translation>Kurven, Schwellen und Intervalle jeder Person und der Gruppe, jeder Durchgang mit seiner Wiedergabetreue, Exporte.</translation>
    </message>
    <message>
        <source>Training sessions</source>
        <translation>Trainingssitzungen</translation>
    </message>
    <message>
        <source>Open the sessions</source>
        <translation>Sitzungen öffnen</translation>
    </message>
    <message>
        <source>Choose another exercise</source>
        <translation>Andere Übung wählen</translation>
    </message>
    <message>
        <source>Well done. Choose any exercise to stay in practice.</source>
        <translation>Gut gemacht. Wählen Sie eine beliebige Übung, um in Übung zu bleiben.</translation>
    </message>
    <message>
        <source>Somebody</source>
        <translation>Jemand</translation>
    </message>
    <message>
        <source>%1 commented on your session %2 (%3, level %4).</source>
        <translation>%1 hat Ihre Sitzung %2 kommentiert (%3, Stufe %4).</translation>
    </message>
    <message>
        <source>Read</source>
        <translation>Lesen</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) withdrew from a study and asked for their recordings to be erased. Under People, choose &quot;Erase a participant&quot;.</source>
        <translation>
            <numerusform>%n Teilnahme an einer Studie wurde zurückgezogen, und die Aufzeichnungen sollen gelöscht werden. Wählen Sie unter Personen „Teilnehmer/in löschen“.</numerusform>
            <numerusform>%n Teilnahmen an Studien wurden zurückgezogen, und die Aufzeichnungen sollen gelöscht werden. Wählen Sie unter Personen „Teilnehmer/in löschen“.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1. %2. Opens the results.</source>
        <translation>%1. %2. Öffnet die Ergebnisse.</translation>
    </message>
    <message>
        <source>You are an administrator and have no recovery code yet. With one, you can set a new password yourself if you forget yours.</source>
        <translation>Sie gehören zur Administration und haben noch keinen Wiederherstellungscode. Mit ihm können Sie selbst ein neues Passwort festlegen, falls Sie Ihres vergessen.</translation>
    </message>
    <message>
        <source>Make one …</source>
        <translation>Erstellen …</translation>
    </message>
    <message>
        <source>Try an exercise yourself</source>
        <translation>Probieren Sie selbst eine Übung aus</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>It takes about a minute with mouse and keyboard, does not count, and ends with a debrief.</source>
        <translation>Das dauert mit Maus und Tastatur etwa eine Minute, zählt nicht und endet mit einer Auswertung.</translation>
    </message>
    <message>
        <source>Try it now</source>
        <translation>Jetzt ausprobieren</translation>
    </message>
    <message>
        <source>A few trials that do not count, with mouse and keyboard.</source>
        <translation>Ein paar Durchgänge mit Maus und Tastatur, die nicht zählen.</translation>
    </message>
    <message>
        <source>Your next step, depending on your role.

If you have not trained yet, you can try an exercise here in about a minute. Trainees continue with the next level at the press of a button, choose any level from the exercises, and see their latest results. Trainers see the sessions that need a review, interrupted or failed ones first, and who trained recently. Administrators see whether people, storage and station are in order.

The list on the left leads to all other screens; Ctrl+K finds any command by its name.</source>
        <translation>Ihr nächster Schritt, je nach Ihrer Rolle.

Wenn Sie noch nicht trainiert haben, können Sie hier in etwa einer Minute eine Übung ausprobieren. Lernende machen mit einer Schaltfläche bei der nächsten Stufe weiter, wählen eine beliebige Stufe aus den Übungen und sehen ihre letzten Ergebnisse. Ausbilderinnen und Ausbilder sehen die Sitzungen, die zu begutachten sind, abgebrochene oder nicht bestandene zuerst, und wer zuletzt trainiert hat. Die Administration sieht, ob Personen, Datensicherung und Arbeitsplatz in Ordnung sind.

Die Liste links führt zu allen anderen Ansichten; Strg+K findet jeden Befehl nach seinem Namen.</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) to review</source>
        <translation>
            <numerusform>%n Sitzung zu begutachten</numerusform>
            <numerusform>%n Sitzungen zu begutachten</numerusform>
        </translation>
    </message>
    <message>
        <source>List of sessions to review</source>
        <translation>Liste der zu begutachtenden Sitzungen</translation>
    </message>
    <message numerus="yes">
        <source>Comments: unread on %n session(s)</source>
        <translation>
            <numerusform>Kommentare: ungelesene zu %n Sitzung</numerusform>
            <numerusform>Kommentare: ungelesene zu %n Sitzungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Comments, received and written</source>
        <translation>Kommentare, erhaltene und geschriebene</translation>
    </message>
    <message>
        <source>%1 answered your comment on session %2 (%3, level %4).</source>
        <translation>%1 hat auf Ihren Kommentar zu Sitzung %2 geantwortet (%3, Stufe %4).</translation>
    </message>
    <message>
        <source>Progress of the group</source>
        <translation>Fortschritt der Gruppe</translation>
    </message>
    <message>
        <source>Everything is reviewed. A trainee&apos;s latest attempt at each level will appear here.</source>
        <translation>Alles ist begutachtet. Hier erscheint von jeder Stufe der neueste Versuch der Lernenden.</translation>
    </message>
    <message>
        <source>Last time: level %1 · %2 · %3</source>
        <translation>Letztes Mal: Stufe %1 · %2 · %3</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InfoPanel</name>
    <message>
        <source>Elapsed: %1</source>
        <translation>Verstrichen: %1</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>mN·m</source>
        <translation>mN·m</translation>
    </message>
    <message>
        <source>up</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message numerus="yes">
        <source>%n samples could not be recorded: this session will be incomplete.</source>
        <translation>
            <numerusform>%n Messpunkt konnte nicht aufgezeichnet werden: Diese Sitzung wird unvollständig.</numerusform>
            <numerusform>%n Messpunkte konnten nicht aufgezeichnet werden: Diese Sitzung wird unvollständig.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tip of the tool (mm)</source>
        <translation>Instrumentenspitze (mm)</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>away</source>
        <translation>weg</translation>
    </message>
    <message>
        <source>Recording complete; nothing is lost. %1 % of the force updates came late.</source>
        <translation>Aufzeichnung vollständig; nichts ging verloren. %1 % der Kraftwerte kamen verspätet.</translation>
    </message>
    <message>
        <source>Recording complete; every force update on time</source>
        <translation>Aufzeichnung vollständig; jeder Kraftwert pünktlich</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::InsertionPanel</name>
    <message>
        <source>Progress in this stage</source>
        <translation>Fortschritt in dieser Phase</translation>
    </message>
    <message>
        <source>Resistance along</source>
        <translation>Widerstand längs</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force across</source>
        <translation>Querkraft</translation>
    </message>
    <message>
        <source>Fx</source>
        <translation>Fx</translation>
    </message>
    <message>
        <source>Force along x, to the side</source>
        <translation>Kraft entlang x, zur Seite</translation>
    </message>
    <message>
        <source>Fy</source>
        <translation>Fy</translation>
    </message>
    <message>
        <source>Force along y, upwards</source>
        <translation>Kraft entlang y, nach oben</translation>
    </message>
    <message>
        <source>Fz</source>
        <translation>Fz</translation>
    </message>
    <message>
        <source>Force along z, into the patient</source>
        <translation>Kraft entlang z, in den Körper hinein</translation>
    </message>
    <message>
        <source>Tx</source>
        <translation>Tx</translation>
    </message>
    <message>
        <source>Torque about x</source>
        <translation>Drehmoment um x</translation>
    </message>
    <message>
        <source>mN·m</source>
        <translation>mN·m</translation>
    </message>
    <message>
        <source>Ty</source>
        <translation>Ty</translation>
    </message>
    <message>
        <source>Torque about y</source>
        <translation>Drehmoment um y</translation>
    </message>
    <message>
        <source>Tz</source>
        <translation>Tz</translation>
    </message>
    <message>
        <source>Torque about the endoscope&apos;s axis</source>
        <translation>Drehmoment um die Achse des Endoskops</translation>
    </message>
    <message>
        <source>Tip x (mm)</source>
        <translation>Spitze x (mm)</translation>
    </message>
    <message>
        <source>Tip y (mm)</source>
        <translation>Spitze y (mm)</translation>
    </message>
    <message>
        <source>Tip z (mm)</source>
        <translation>Spitze z (mm)</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Auslenkung (mm)</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ausrichtung (°)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Force across (N)</source>
        <translation>Querkraft (N)</translation>
    </message>
    <message>
        <source>Forces (N) and torques (mN·m) on the endoscope</source>
        <translation>Kräfte (N) und Drehmomente (mN·m) am Endoskop</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::KeyTableDialog</name>
    <message>
        <source>Who is who</source>
        <translation>Wer ist wer</translation>
    </message>
    <message>
        <source>Opening this table is recorded in the audit trail.</source>
        <translation>Das Öffnen dieser Tabelle wird im Prüfprotokoll vermerkt.</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Identity</source>
        <translation>Identität</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Reading the key table …</source>
        <translation>Schlüsseltabelle wird gelesen …</translation>
    </message>
    <message>
        <source>The key table could not be read</source>
        <translation>Die Schlüsseltabelle konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>The key table is empty</source>
        <translation>Die Schlüsseltabelle ist leer</translation>
    </message>
    <message>
        <source>Simulated participants have no key.</source>
        <translation>Simulierte Personen haben keinen Schlüssel.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LatenessChart</name>
    <message>
        <source>Lateness of the force loop</source>
        <translation>Verspätung der Kraftregelung</translation>
    </message>
    <message>
        <source>over %1 µs</source>
        <translation>über %1 µs</translation>
    </message>
    <message>
        <source>up to %1 µs</source>
        <translation>bis %1 µs</translation>
    </message>
    <message>
        <source>%1 %, late</source>
        <translation>%1 %, verspätet</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LeanDial</name>
    <message>
        <source>Tilt of the fingertip platform</source>
        <translation>Neigung der Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>%1°, at its limit</source>
        <translation>%1°, an der Grenze</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Neigung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LevelChooser</name>
    <message>
        <source>Level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>Noch nicht versucht</translation>
    </message>
    <message>
        <source>Passed</source>
        <translation>Bestanden</translation>
    </message>
    <message numerus="yes">
        <source>Tried %n times, not passed yet</source>
        <translation>
            <numerusform>%n-mal versucht, noch nicht bestanden</numerusform>
            <numerusform>%n-mal versucht, noch nicht bestanden</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 · recommended next</source>
        <translation>%1 · als Nächstes empfohlen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LevelsTable</name>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Differences from the reference in per cent</source>
        <translation>Unterschiede zur Referenz in Prozent</translation>
    </message>
    <message>
        <source>Paste numbers</source>
        <translation>Zahlen einfügen</translation>
    </message>
    <message>
        <source>Add a row</source>
        <translation>Zeile hinzufügen</translation>
    </message>
    <message>
        <source>Remove the row</source>
        <translation>Zeile entfernen</translation>
    </message>
    <message>
        <source>There are no numbers to paste. Copy them first.</source>
        <translation>Es gibt keine Zahlen zum Einfügen. Kopieren Sie sie zuerst.</translation>
    </message>
    <message>
        <source>Difference (%)</source>
        <translation>Unterschied (%)</translation>
    </message>
    <message>
        <source>A row is empty. Type a number into it, or remove the row.</source>
        <translation>Eine Zeile ist leer. Geben Sie eine Zahl ein, oder entfernen Sie die Zeile.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LivePlot</name>
    <message>
        <source>The last %1 seconds</source>
        <translation>Die letzten %1 Sekunden</translation>
    </message>
    <message>
        <source>-%1 s</source>
        <translation>-%1 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LockController</name>
    <message>
        <source>Locked - Chiron</source>
        <translation>Gesperrt - Chiron</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LockCover</name>
    <message>
        <source>Locked</source>
        <translation>Gesperrt</translation>
    </message>
    <message>
        <source>%1 is logged in. Everything keeps running and nothing is lost; only the screen is covered.</source>
        <translation>%1 ist angemeldet. Alles läuft weiter und bleibt erhalten; nur der Bildschirm ist verdeckt.</translation>
    </message>
    <message>
        <source>Password of %1</source>
        <translation>Passwort von %1</translation>
    </message>
    <message>
        <source>Unlock</source>
        <translation>Entsperren</translation>
    </message>
    <message>
        <source>Switch user</source>
        <translation>Person wechseln</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginForm</name>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>Forgot your password?</source>
        <translation>Passwort vergessen?</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginNameField</name>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Somebody has this login name already. Names that differ only in capital letters count as the same.</source>
        <translation>Diesen Anmeldenamen hat schon jemand. Namen, die sich nur in Großbuchstaben unterscheiden, gelten als gleich.</translation>
    </message>
    <message>
        <source>No commas.</source>
        <translation>Keine Kommas.</translation>
    </message>
    <message>
        <source>A login name is needed. No commas.</source>
        <translation>Ein Anmeldename ist nötig. Keine Kommas.</translation>
    </message>
    <message>
        <source>This name cannot be used. Use at most %1 characters, no commas and no spaces at the ends. Some names are reserved for the program.</source>
        <translation>Dieser Name ist nicht möglich. Erlaubt sind höchstens %1 Zeichen, keine Kommas und keine Leerzeichen am Anfang oder Ende. Einige Namen sind für das Programm reserviert.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::LoginScreen</name>
    <message>
        <source>Opening the site …</source>
        <translation>Standort wird geöffnet …</translation>
    </message>
    <message>
        <source>Log in</source>
        <translation>Anmelden</translation>
    </message>
    <message>
        <source>The site could not be opened.</source>
        <translation>Der Standort konnte nicht geöffnet werden.</translation>
    </message>
    <message>
        <source>The list of names could not be read.</source>
        <translation>Die Namensliste konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>This is a demonstration: choose anyone. The password for everyone is %1</source>
        <translation>Dies ist eine Demo: Wählen Sie eine beliebige Person. Das Passwort lautet für alle %1</translation>
    </message>
    <message>
        <source>This is the password that you were given. Choose another one.</source>
        <translation>Das ist das Passwort, das Sie erhalten haben. Wählen Sie ein anderes.</translation>
    </message>
    <message>
        <source>The password was not changed.
%1</source>
        <translation>Das Passwort wurde nicht geändert.
%1</translation>
    </message>
    <message>
        <source>Checking the site&apos;s file …</source>
        <translation>Die Datei des Standorts wird geprüft …</translation>
    </message>
    <message>
        <source>Type a few letters of your name, or choose it in the list, then enter your password.

After three wrong passwords the account is locked for a short time; the button counts down the seconds. No data are lost.

Forgot your password? An administrator can give you a new one. Administrators can use their recovery code.</source>
        <translation>Geben Sie einige Buchstaben Ihres Namens ein oder wählen Sie ihn in der Liste, danach Ihr Passwort.

Nach drei falschen Passwörtern ist das Konto kurz gesperrt; die Schaltfläche zählt die Sekunden herunter. Daten gehen dabei nicht verloren.

Passwort vergessen? Die Administration kann Ihnen ein neues geben. Die Administration selbst kann ihren Wiederherstellungscode verwenden.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MainWindow</name>
    <message>
        <source>Demonstration site: invented people and scripted sessions. Do not record real training here.</source>
        <translation>Demo-Standort: erfundene Personen und vorbereitete Sitzungen. Zeichnen Sie hier kein echtes Training auf.</translation>
    </message>
    <message>
        <source>%1 - Chiron</source>
        <translation>%1 - Chiron</translation>
    </message>
    <message>
        <source>F1: help with this screen · Ctrl+K: find a screen, command, person, session or study</source>
        <translation>F1: Hilfe zu dieser Seite · Strg+K: Seite, Befehl, Person, Sitzung oder Studie finden</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MarkList</name>
    <message>
        <source>Penalties only</source>
        <translation>Nur Abzüge</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>No events of this kind.</source>
        <translation>Keine Ereignisse dieser Art.</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1  %2</translation>
    </message>
    <message>
        <source>Include contacts</source>
        <translation>Auch Kontakte</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MessageBar</name>
    <message>
        <source>Close this message</source>
        <translation>Meldung schließen</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alles zeigen</translation>
    </message>
    <message>
        <source>The whole message</source>
        <translation>Die ganze Meldung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::MetricsTable</name>
    <message>
        <source>All metrics</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Met</source>
        <translation>Erreicht</translation>
    </message>
    <message>
        <source>Not met</source>
        <translation>Nicht erreicht</translation>
    </message>
    <message>
        <source>Benchmark, chance</source>
        <translation>Referenz, Zufall</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NameList</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type your name, or choose it below</source>
        <translation>Name eingeben oder unten auswählen</translation>
    </message>
    <message>
        <source>People who can log in</source>
        <translation>Personen, die sich anmelden können</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Nobody with this name can log in here. Ask an administrator; your login name may have changed.</source>
        <translation>Unter diesem Namen kann sich hier niemand anmelden. Fragen Sie die Administration; Ihr Anmeldename wurde vielleicht geändert.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NewPasswordPage</name>
    <message>
        <source>Choose a password of your own</source>
        <translation>Wählen Sie ein eigenes Passwort</translation>
    </message>
    <message>
        <source>Your current password was set by someone else. From your next login, only the new one is valid.</source>
        <translation>Ihr jetziges Passwort hat jemand anderes festgelegt. Ab der nächsten Anmeldung gilt nur noch das neue.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Save and log in</source>
        <translation>Speichern und anmelden</translation>
    </message>
    <message>
        <source>Saving …</source>
        <translation>Wird gespeichert …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::NewStudyDialog</name>
    <message>
        <source>New study</source>
        <translation>Neue Studie</translation>
    </message>
    <message>
        <source>Begin with</source>
        <translation>Beginnen mit</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>Titel</translation>
    </message>
    <message>
        <source>Key (in files and commands)</source>
        <translation>Kennung (in Dateien und Befehlen)</translation>
    </message>
    <message>
        <source>Lower-case letters, digits and _ only. It cannot be changed later.</source>
        <translation>Nur Kleinbuchstaben, Ziffern und _. Sie kann später nicht geändert werden.</translation>
    </message>
    <message>
        <source>Create draft</source>
        <translation>Entwurf anlegen</translation>
    </message>
    <message>
        <source>The templates could not be read.
%1</source>
        <translation>Die Vorlagen konnten nicht gelesen werden.
%1</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The study was not created. Its key may already be in use.
%1</source>
        <translation>Die Studie wurde nicht angelegt. Vielleicht ist ihre Kennung schon vergeben.
%1</translation>
    </message>
    <message>
        <source>Copy to a new study</source>
        <translation>In eine neue Studie kopieren</translation>
    </message>
    <message>
        <source>The copy is a draft with the whole design of “%1”, without its participants, data and ethics approval.</source>
        <translation>Die Kopie ist ein Entwurf mit allem, was „%1“ festlegt, ohne Teilnehmende, Daten und Ethikvotum.</translation>
    </message>
    <message>
        <source>Trials: %1</source>
        <translation>Durchgänge: %1</translation>
    </message>
    <message>
        <source>Duration: %1</source>
        <translation>Dauer: %1</translation>
    </message>
    <message>
        <source>After: %1</source>
        <translation>Nach: %1</translation>
    </message>
    <message>
        <source>Give the study a title.</source>
        <translation>Geben Sie der Studie einen Titel.</translation>
    </message>
    <message>
        <source>Give the study a key.</source>
        <translation>Geben Sie der Studie eine Kennung.</translation>
    </message>
    <message>
        <source>Use only lower-case letters, digits and _, and begin with a letter.</source>
        <translation>Nur Kleinbuchstaben, Ziffern und _ verwenden und mit einem Buchstaben beginnen.</translation>
    </message>
    <message>
        <source>Another study has this key. Choose another.</source>
        <translation>Eine andere Studie hat diese Kennung. Wählen Sie eine andere.</translation>
    </message>
    <message>
        <source>Each template is a complete design. Everything in it can be changed until the study is frozen.</source>
        <translation>Jede Vorlage ist ein vollständiger Entwurf. Alles darin lässt sich ändern, bis die Studie eingefroren ist.</translation>
    </message>
    <message>
        <source>Find a template</source>
        <translation>Vorlage suchen</translation>
    </message>
    <message>
        <source>No template matches “%1”. Try fewer or other words.</source>
        <translation>Keine Vorlage passt zu „%1“. Versuchen Sie es mit weniger oder anderen Wörtern.</translation>
    </message>
    <message>
        <source>Another study has this title, and the two could not be told apart in lists. Choose another title.</source>
        <translation>Eine andere Studie hat denselben Titel; in Listen wären beide nicht zu unterscheiden. Wählen Sie einen anderen Titel.</translation>
    </message>
    <message>
        <source>A simple study: %1</source>
        <translation>Eine einfache Studie: %1</translation>
    </message>
    <message>
        <source>One condition, stiffness. %1</source>
        <translation>Eine Bedingung, Steifigkeit. %1</translation>
    </message>
    <message>
        <source>For example: 2AFC, weight, two conditions, Watson</source>
        <translation>Zum Beispiel: 2AFC, Gewicht, zwei Bedingungen, Watson</translation>
    </message>
    <message>
        <source>Conditions: %1</source>
        <translation>Bedingungen: %1</translation>
    </message>
    <message>
        <source>The templates are being read.</source>
        <translation>Die Vorlagen werden gelesen.</translation>
    </message>
    <message>
        <source>Choose what to begin with first.</source>
        <translation>Wählen Sie zuerst, womit Sie beginnen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PaletteFinder</name>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Exercises</source>
        <translation>Übungen</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>Searching people, sessions and studies …</source>
        <translation>Personen, Sitzungen und Studien werden durchsucht …</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>On other screens</source>
        <translation>Auf anderen Seiten</translation>
    </message>
    <message numerus="yes">
        <source>%1 (%n more; type more letters)</source>
        <translation>
            <numerusform>%1 (%n weitere; geben Sie mehr Buchstaben ein)</numerusform>
            <numerusform>%1 (%n weitere; geben Sie mehr Buchstaben ein)</numerusform>
        </translation>
    </message>
    <message>
        <source>Not everything could be searched: %1</source>
        <translation>Nicht alles konnte durchsucht werden: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PalpationBox</name>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Durchgang %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PalpationPanel</name>
    <message>
        <source>%1: force</source>
        <translation>%1: Kraft</translation>
    </message>
    <message>
        <source>%1: squeeze of the jaw</source>
        <translation>%1: Quetschkraft der Branchen</translation>
    </message>
    <message>
        <source>Squeeze of the jaw</source>
        <translation>Quetschkraft der Branchen</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force map (M)</source>
        <translation>Kraftkarte (M)</translation>
    </message>
    <message>
        <source>On: the map shows how hard the tissue was pressed. Off: it shows where the tissue was searched.</source>
        <translation>An: Die Karte zeigt, wie fest gedrückt wurde. Aus: Sie zeigt, wo abgetastet wurde.</translation>
    </message>
    <message>
        <source>rendered force (N)</source>
        <translation>ausgegebene Kraft (N)</translation>
    </message>
    <message>
        <source>tilt (°)</source>
        <translation>Neigung (°)</translation>
    </message>
    <message>
        <source>depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Force, first finger (N)</source>
        <translation>Kraft, erster Finger (N)</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Tilt, first finger (°)</source>
        <translation>Neigung, erster Finger (°)</translation>
    </message>
    <message>
        <source>Tilt (°)</source>
        <translation>Neigung (°)</translation>
    </message>
    <message>
        <source>Searched: %1 %</source>
        <translation>Abgetastet: %1 %</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantCard</name>
    <message>
        <source>What a participant will meet</source>
        <translation>Was Teilnehmende erwartet</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantWindow</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ParticipantsPage</name>
    <message>
        <source>Participants can be enrolled once the design is frozen.</source>
        <translation>Personen können aufgenommen werden, sobald der Entwurf eingefroren ist.</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet. Each participant gets a random code; the identity is kept in a separate key table.</source>
        <translation>Noch ist niemand aufgenommen. Jede Person bekommt einen zufälligen Code; ihre Identität steht in einer getrennten Schlüsseltabelle.</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Enrolled</source>
        <translation>Aufgenommen</translation>
    </message>
    <message>
        <source>Consent</source>
        <translation>Einwilligung</translation>
    </message>
    <message>
        <source>Enrol …</source>
        <translation>Aufnehmen …</translation>
    </message>
    <message>
        <source>Consent …</source>
        <translation>Einwilligung …</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Withdraw …</source>
        <translation>Zurückziehen …</translation>
    </message>
    <message>
        <source>Who is who …</source>
        <translation>Wer ist wer …</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1 (simuliert)</translation>
    </message>
    <message>
        <source>Choose a participant in the list first.</source>
        <translation>Wählen Sie zuerst jemanden in der Liste.</translation>
    </message>
    <message>
        <source>This participant is simulated.</source>
        <translation>Diese Person ist simuliert.</translation>
    </message>
    <message>
        <source>This participant has withdrawn.</source>
        <translation>Diese Person nimmt nicht mehr teil.</translation>
    </message>
    <message>
        <source>This participant has done every run.</source>
        <translation>Diese Person hat alle Läufe erledigt.</translation>
    </message>
    <message>
        <source>Participants can be enrolled only while the study is frozen.</source>
        <translation>Personen können nur aufgenommen werden, solange die Studie eingefroren ist.</translation>
    </message>
    <message>
        <source>The consent is recorded already.</source>
        <translation>Die Einwilligung ist schon festgehalten.</translation>
    </message>
    <message>
        <source>Record the consent first.</source>
        <translation>Erfassen Sie zuerst die Einwilligung.</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>Es ist noch niemand aufgenommen.</translation>
    </message>
    <message>
        <source>%1. %2: %3.</source>
        <translation>%1. %2: %3.</translation>
    </message>
    <message>
        <source>Design row</source>
        <translation>Planzeile</translation>
    </message>
    <message>
        <source>The row of the order design (%1), counted from 1: it says in which order this participant does the conditions. Whoever is enrolled gets the next free row, and the row of somebody who withdraws becomes free again, so the rows need not follow the order of enrolment.</source>
        <translation>Die Zeile des Reihenfolgeplans (%1), von 1 an gezählt: Sie sagt, in welcher Reihenfolge diese Person die Bedingungen durchläuft. Wer aufgenommen wird, erhält die nächste freie Zeile, und die Zeile einer Person, die ihre Teilnahme zurückzieht, wird wieder frei. Die Zeilen müssen also nicht der Reihenfolge der Aufnahme folgen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PasswordChoice</name>
    <message>
        <source>Initial password</source>
        <translation>Anfangspasswort</translation>
    </message>
    <message>
        <source>Generate one (shown once)</source>
        <translation>Erzeugen (wird einmal gezeigt)</translation>
    </message>
    <message>
        <source>Type one</source>
        <translation>Selbst eingeben</translation>
    </message>
    <message>
        <source>It has to be changed at the next login, so that only its owner knows it.</source>
        <translation>Es muss bei der nächsten Anmeldung geändert werden, damit nur die Person selbst es kennt.</translation>
    </message>
    <message>
        <source>Hand this password to %1. It is shown only now and has to be changed at the next login.</source>
        <translation>Geben Sie dieses Passwort an %1 weiter. Es wird nur jetzt gezeigt und muss bei der nächsten Anmeldung geändert werden.</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PasswordFields</name>
    <message>
        <source>New password</source>
        <translation>Neues Passwort</translation>
    </message>
    <message>
        <source>Repeat the password</source>
        <translation>Passwort wiederholen</translation>
    </message>
    <message>
        <source>Show the password</source>
        <translation>Passwort anzeigen</translation>
    </message>
    <message>
        <source>Length: %1 characters or more</source>
        <translation>Länge: mindestens %1 Zeichen</translation>
    </message>
    <message>
        <source>Variety: %1 different characters or more</source>
        <translation>Vielfalt: mindestens %1 verschiedene Zeichen</translation>
    </message>
    <message>
        <source>Not the login name</source>
        <translation>Nicht der Anmeldename</translation>
    </message>
    <message>
        <source>Both fields are the same</source>
        <translation>Beide Felder stimmen überein</translation>
    </message>
    <message>
        <source>Done: %1</source>
        <translation>Erfüllt: %1</translation>
    </message>
    <message>
        <source>Still missing: %1</source>
        <translation>Fehlt noch: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PeopleModel</name>
    <message>
        <source>Disabled</source>
        <translation>Deaktiviert</translation>
    </message>
    <message>
        <source>Must change the password</source>
        <translation>Muss das Passwort ändern</translation>
    </message>
    <message>
        <source>Can log in</source>
        <translation>Kann sich anmelden</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Vollständiger Name</translation>
    </message>
    <message>
        <source>Roles</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Account</source>
        <translation>Konto</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PeopleScreen</name>
    <message>
        <source>Add a person</source>
        <translation>Person hinzufügen</translation>
    </message>
    <message>
        <source>Import roster</source>
        <translation>Liste importieren</translation>
    </message>
    <message>
        <source>Find a person</source>
        <translation>Person suchen</translation>
    </message>
    <message>
        <source>Choose a person in the list first.</source>
        <translation>Wählen Sie zuerst eine Person in der Liste.</translation>
    </message>
    <message>
        <source>Change roles</source>
        <translation>Rollen ändern</translation>
    </message>
    <message>
        <source>Reset password</source>
        <translation>Passwort zurücksetzen</translation>
    </message>
    <message>
        <source>Disable or enable</source>
        <translation>Deaktivieren oder aktivieren</translation>
    </message>
    <message>
        <source>Export all data</source>
        <translation>Alle Daten exportieren</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>%1 can log in again.</source>
        <translation>%1 kann sich wieder anmelden.</translation>
    </message>
    <message>
        <source>%1 can no longer log in. Recorded data are kept.</source>
        <translation>%1 kann sich nicht mehr anmelden. Aufgezeichnete Daten bleiben erhalten.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>%1 stays enabled: the site needs at least one administrator who can log in. Make another person an administrator first.</source>
        <translation>%1 bleibt aktiviert: Der Standort braucht mindestens eine Person mit der Rolle Administration, die sich anmelden kann. Geben Sie zuerst einer anderen Person diese Rolle.</translation>
    </message>
    <message>
        <source>The account of %1 was not changed.</source>
        <translation>Das Konto von %1 wurde nicht geändert.</translation>
    </message>
    <message>
        <source>Export all data about %1</source>
        <translation>Alle Daten über %1 exportieren</translation>
    </message>
    <message>
        <source>JSON (*.json)</source>
        <translation>JSON (*.json)</translation>
    </message>
    <message>
        <source>All data about %1 were exported to %2.</source>
        <translation>Alle Daten über %1 wurden nach %2 exportiert.</translation>
    </message>
    <message>
        <source>Nothing was exported about %1.</source>
        <translation>Über %1 wurde nichts exportiert.</translation>
    </message>
    <message>
        <source>Import people from a CSV file</source>
        <translation>Personen aus einer CSV-Datei importieren</translation>
    </message>
    <message>
        <source>CSV (*.csv);;All files (*)</source>
        <translation>CSV (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>%1 cannot be read, or is too large for a list of people. Nothing was changed.</source>
        <translation>%1 ist nicht lesbar oder zu groß für eine Personenliste. Es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>People</source>
        <translation>Personen</translation>
    </message>
    <message>
        <source>Reading the list of people …</source>
        <translation>Personenliste wird gelesen …</translation>
    </message>
    <message>
        <source>Disable</source>
        <translation>Deaktivieren</translation>
    </message>
    <message>
        <source>The list of people could not be read.</source>
        <translation>Die Personenliste konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Nobody is chosen</source>
        <translation>Niemand ausgewählt</translation>
    </message>
    <message>
        <source>Choose a person in the list to change or export something.</source>
        <translation>Wählen Sie eine Person in der Liste, um etwas zu ändern oder zu exportieren.</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Code %1: what researchers see in place of the name.</source>
        <translation>Code %1: Das sehen Forschende anstelle des Namens.</translation>
    </message>
    <message>
        <source>Enable</source>
        <translation>Aktivieren</translation>
    </message>
    <message>
        <source>Save a template for a roster</source>
        <translation>Vorlage für eine Liste speichern</translation>
    </message>
    <message>
        <source>Edit name and login name</source>
        <translation>Name und Anmeldename bearbeiten</translation>
    </message>
    <message>
        <source>roster</source>
        <translation>liste</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>The template was saved to %1. Replace the example lines, save the file as CSV, then import it here.</source>
        <translation>Die Vorlage wurde in %1 gespeichert. Ersetzen Sie die Beispielzeilen, speichern Sie die Datei als CSV und importieren Sie sie dann hier.</translation>
    </message>
    <message>
        <source>The template was not saved.</source>
        <translation>Die Vorlage wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>Save a template …</source>
        <translation>Vorlage speichern …</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>Until %1: %2</source>
        <translation>Bis %1: %2</translation>
    </message>
    <message>
        <source>Erase a study participant</source>
        <translation>Studienteilnehmer/in löschen</translation>
    </message>
    <message>
        <source>Everybody who has an account on this site.

Choose a person in the list, then an action below it. Changing roles and disabling take effect at once and can be undone. A person who gets a new password has to change it at the next login.

&quot;Edit&quot; changes a person&apos;s name or login name; the earlier ones stay in the history.

&quot;Import roster&quot; reads a CSV file as a spreadsheet saves it, with headings such as login name, full name and role (&quot;Save a template&quot; makes one), and first shows what will happen: either everything in the file is done, or nothing. Passwords are made for new people and can be printed as slips.

&quot;Export all data&quot; writes all data about a person to one file. &quot;Erase&quot; permanently removes a person&apos;s identity. &quot;Erase a participant&quot; does the same for somebody who has withdrawn from a study, even if they have no account.</source>
        <translation>Alle, die an diesem Standort ein Konto haben.

Wählen Sie eine Person in der Liste, dann darunter eine Aktion. Rollen ändern und Deaktivieren wirken sofort und lassen sich rückgängig machen. Ein neues Passwort muss die Person bei der nächsten Anmeldung ändern.

„Bearbeiten“ ändert den Namen oder Anmeldenamen einer Person; die früheren bleiben im Verlauf.

„Liste importieren“ liest eine CSV-Datei, wie eine Tabellenkalkulation sie speichert, mit Überschriften wie Anmeldename, Vollständiger Name und Rolle („Vorlage speichern“ erzeugt eine), und zeigt zuerst, was geschehen wird: Entweder wird alles in der Datei ausgeführt oder nichts. Für neue Personen werden Passwörter erzeugt, die sich als Zettel drucken lassen.

„Alle Daten exportieren“ schreibt alle Daten über eine Person in eine Datei. „Löschen“ entfernt die Identität einer Person endgültig. „Teilnehmer/in löschen“ tut dasselbe für jemanden, der die Teilnahme an einer Studie zurückgezogen hat, auch ohne Konto.</translation>
    </message>
    <message>
        <source>Erase a participant …</source>
        <translation>Teilnehmer/in löschen …</translation>
    </message>
    <message>
        <source>No name and no role matches &quot;%1&quot;.</source>
        <translation>Kein Name und keine Rolle passt zu „%1“.</translation>
    </message>
    <message>
        <source>Show everybody</source>
        <translation>Alle anzeigen</translation>
    </message>
    <message>
        <source>Import roster …</source>
        <translation>Liste importieren …</translation>
    </message>
    <message>
        <source>Permanently removes the identity of somebody who took part in a study, even if they have no account here.</source>
        <translation>Entfernt endgültig die Identität einer Person, die an einer Studie teilgenommen hat, auch wenn sie hier kein Konto hat.</translation>
    </message>
    <message>
        <source>Permanently removes the identity of the person who is chosen in the list.</source>
        <translation>Entfernt endgültig die Identität der Person, die in der Liste gewählt ist.</translation>
    </message>
    <message>
        <source>Nobody was found</source>
        <translation>Niemand gefunden</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PersonPage</name>
    <message>
        <source>There are no runs yet.</source>
        <translation>Es gibt noch keine Läufe.</translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>kein Intervall</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>Weber fraction</source>
        <translation>Weber-Bruch</translation>
    </message>
    <message>
        <source>JND at the reference</source>
        <translation>JND an der Referenz</translation>
    </message>
    <message>
        <source>Point of subjective equality</source>
        <translation>Punkt subjektiver Gleichheit</translation>
    </message>
    <message>
        <source>%1. %2. %3 scored trials, %4 repeated. %5</source>
        <translation>%1. %2. %3 gewertete Durchgänge, %4 wiederholt. %5</translation>
    </message>
    <message numerus="yes">
        <source>Replayed from its log, the procedure makes the same %n choice(s).</source>
        <translation>
            <numerusform>Beim Nachrechnen aus dem Protokoll trifft das Verfahren dieselbe %n Entscheidung.</numerusform>
            <numerusform>Beim Nachrechnen aus dem Protokoll trifft das Verfahren dieselben %n Entscheidungen.</numerusform>
        </translation>
    </message>
    <message>
        <source>Replayed from its log, the procedure makes different choices: only %1 of %2 match.</source>
        <translation>Beim Nachrechnen aus dem Protokoll entscheidet das Verfahren anders: Nur %1 von %2 stimmen überein.</translation>
    </message>
    <message>
        <source>Proportion correct by difference</source>
        <translation>Anteil richtiger Antworten nach Unterschied</translation>
    </message>
    <message>
        <source>This task has no psychometric curve</source>
        <translation>Diese Aufgabe hat keine psychometrische Kurve</translation>
    </message>
    <message>
        <source>Equality threshold (σ)</source>
        <translation>Gleichheitsschwelle (σ)</translation>
    </message>
    <message>
        <source>Exponent of the power law</source>
        <translation>Exponent des Potenzgesetzes</translation>
    </message>
    <message>
        <source>In the group value: %1.</source>
        <translation>Im Gruppenwert: %1.</translation>
    </message>
    <message>
        <source>The masking sound was not heard in %1 of %2 trials: the machine had no sound output.</source>
        <translation>Das Maskierungsgeräusch war in %1 von %2 Durchgängen nicht zu hören: Der Rechner hatte keine Tonausgabe.</translation>
    </message>
    <message>
        <source>Internal noise</source>
        <translation>Internes Rauschen</translation>
    </message>
    <message>
        <source>How much the same object feels different from one time to the next (one standard deviation).</source>
        <translation>Wie unterschiedlich sich ein und dasselbe Objekt von Mal zu Mal anfühlt (eine Standardabweichung).</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PilotDialog</name>
    <message>
        <source>Pilot run</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>The design is tried exactly as it is now. The run is marked as a pilot and never analysed with the study&apos;s data. Stop whenever you have seen enough.</source>
        <translation>Der Entwurf wird genau so ausprobiert, wie er jetzt ist. Der Lauf wird als Probelauf markiert und nie mit den Daten der Studie ausgewertet. Beenden Sie ihn, sobald Sie genug gesehen haben.</translation>
    </message>
    <message>
        <source>Condition</source>
        <translation>Bedingung</translation>
    </message>
    <message>
        <source>Who tries it (may be left empty)</source>
        <translation>Wer es ausprobiert (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Whoever tries it has read this and agrees</source>
        <translation>Wer es ausprobiert, hat dies gelesen und willigt ein</translation>
    </message>
    <message>
        <source>Begin the pilot</source>
        <translation>Probelauf beginnen</translation>
    </message>
    <message>
        <source>The pilot could not begin.
%1</source>
        <translation>Der Probelauf konnte nicht beginnen.
%1</translation>
    </message>
    <message>
        <source>Tick the box first: whoever tries it must agree.</source>
        <translation>Setzen Sie zuerst das Häkchen: Wer die Studie ausprobiert, muss zustimmen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlacesView</name>
    <message>
        <source>Objects to explore</source>
        <translation>Objekte zum Erkunden</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Limit: %1 N</source>
        <translation>Grenze: %1 N</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlatformCard</name>
    <message>
        <source>Fingertip platform</source>
        <translation>Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>Verification of the simulated platform: the published sine and orientations, force steps, and the maximum force on the finger pad, on eight simulated fingers.</source>
        <translation>Prüfung der simulierten Plattform: die veröffentlichte Sinusschwingung und Neigungen, Kraftsprünge und die größte Kraft an der Fingerkuppe, an acht simulierten Fingern.</translation>
    </message>
    <message>
        <source>Verify the platform</source>
        <translation>Plattform prüfen</translation>
    </message>
    <message>
        <source>Record (PDF) …</source>
        <translation>Protokoll (PDF) …</translation>
    </message>
    <message>
        <source>The verification was stopped before it finished.</source>
        <translation>Die Prüfung wurde vor dem Ende abgebrochen.</translation>
    </message>
    <message>
        <source>The verification could not be done: %1</source>
        <translation>Die Prüfung war nicht möglich: %1</translation>
    </message>
    <message>
        <source>Verification of the simulated fingertip platform</source>
        <translation>Prüfung der simulierten Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>A researcher or an administrator can run it here.</source>
        <translation>Forschende oder die Administration können sie hier ausführen.</translation>
    </message>
    <message>
        <source>Passed.</source>
        <translation>Bestanden.</translation>
    </message>
    <message>
        <source>Failed.</source>
        <translation>Nicht bestanden.</translation>
    </message>
    <message>
        <source>Serial number: %1</source>
        <translation>Seriennummer: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlaybackPlots</name>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Auslenkung (mm)</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ausrichtung (°)</translation>
    </message>
    <message>
        <source>Tension of the tube</source>
        <translation>Spannung des Schlauchs</translation>
    </message>
    <message>
        <source>Squeeze of the jaws</source>
        <translation>Quetschkraft der Branchen</translation>
    </message>
    <message>
        <source>band, from</source>
        <translation>Bereich, ab</translation>
    </message>
    <message>
        <source>band, to</source>
        <translation>Bereich, bis</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>Grenze</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>Quetschkraft</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Tension (N), dashed: target band</source>
        <translation>Spannung (N), gestrichelt: Zielbereich</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
    <message>
        <source>Energy supplied by the hand and stored in the object</source>
        <translation>Von der Hand zugeführte und im Objekt gespeicherte Energie</translation>
    </message>
    <message>
        <source>more stored than supplied</source>
        <translation>mehr gespeichert als zugeführt</translation>
    </message>
    <message>
        <source>supplied</source>
        <translation>zugeführt</translation>
    </message>
    <message>
        <source>stored</source>
        <translation>gespeichert</translation>
    </message>
    <message>
        <source>Energy (mJ)</source>
        <translation>Energie (mJ)</translation>
    </message>
    <message>
        <source>finger %1</source>
        <translation>Finger %1</translation>
    </message>
    <message>
        <source>finger</source>
        <translation>Finger</translation>
    </message>
    <message>
        <source>Tilt of the force</source>
        <translation>Neigung der Kraft</translation>
    </message>
    <message>
        <source>maximum tilt of the platform</source>
        <translation>größte Neigung der Plattform</translation>
    </message>
    <message>
        <source>Tilt (°), line: limit of the platform</source>
        <translation>Neigung (°), Linie: Grenze der Plattform</translation>
    </message>
    <message>
        <source>Depth of the fingers</source>
        <translation>Tiefe der Finger</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>Pull on the fold of tissue</source>
        <translation>Zug an der Gewebefalte</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Pull on the fold (N), dashed: target band</source>
        <translation>Zug an der Falte (N), gestrichelt: Zielbereich</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Tissue force (N)</source>
        <translation>Kraft am Gewebe (N)</translation>
    </message>
    <message>
        <source>Force felt (N)</source>
        <translation>Gefühlte Kraft (N)</translation>
    </message>
    <message>
        <source>Zoom in: show less time (+)</source>
        <translation>Vergrößern: weniger Zeit zeigen (+)</translation>
    </message>
    <message>
        <source>Zoom out: show more time (-)</source>
        <translation>Verkleinern: mehr Zeit zeigen (-)</translation>
    </message>
    <message>
        <source>Show the whole session (0)</source>
        <translation>Die ganze Sitzung zeigen (0)</translation>
    </message>
    <message>
        <source>Time in the recording (s)</source>
        <translation>Zeit in der Aufzeichnung (s)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PlaybackScreen</name>
    <message>
        <source>The sessions for comparison could not be loaded.</source>
        <translation>Die Vergleichssitzungen konnten nicht geladen werden.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>My first attempt, %1</source>
        <translation>Mein erster Versuch, %1</translation>
    </message>
    <message>
        <source>First attempt of %1, %2</source>
        <translation>Erster Versuch von %1, %2</translation>
    </message>
    <message>
        <source>My best attempt, %1</source>
        <translation>Mein bester Versuch, %1</translation>
    </message>
    <message>
        <source>Best attempt of %1, %2</source>
        <translation>Bester Versuch von %1, %2</translation>
    </message>
    <message>
        <source>No other completed session of this level</source>
        <translation>Keine andere abgeschlossene Sitzung dieser Stufe</translation>
    </message>
    <message>
        <source>The second session could not be read. This one is shown alone.</source>
        <translation>Die zweite Sitzung konnte nicht gelesen werden. Diese wird allein gezeigt.</translation>
    </message>
    <message>
        <source>Declared void: %1</source>
        <translation>Für ungültig erklärt: %1</translation>
    </message>
    <message>
        <source>%1, level %2: %3</source>
        <translation>%1, Stufe %2: %3</translation>
    </message>
    <message>
        <source>%1 · %2 · %3 · %4</source>
        <translation>%1 · %2 · %3 · %4</translation>
    </message>
    <message>
        <source>Debrief</source>
        <translation>Auswertung</translation>
    </message>
    <message>
        <source>Declare void …</source>
        <translation>Für ungültig erklären …</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Second session alongside</source>
        <translation>Zweite Sitzung daneben</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Playback</source>
        <translation>Wiedergabe</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Ein Bild vor</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>Nächstes Ereignis</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>Voriges Ereignis</translation>
    </message>
    <message>
        <source>To the beginning</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>To the end</source>
        <translation>Zum Ende</translation>
    </message>
    <message>
        <source>This recording is damaged and cannot be played back. Its scores are kept.</source>
        <translation>Diese Aufzeichnung ist beschädigt und kann nicht wiedergegeben werden. Ihre Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>This session could not be opened</source>
        <translation>Diese Sitzung konnte nicht geöffnet werden</translation>
    </message>
    <message>
        <source>Reading the recording …</source>
        <translation>Aufzeichnung wird gelesen …</translation>
    </message>
    <message>
        <source>The recording was erased</source>
        <translation>Die Aufzeichnung wurde gelöscht</translation>
    </message>
    <message>
        <source>It was erased at the person&apos;s request. The scores are kept.</source>
        <translation>Sie wurde auf Wunsch der Person gelöscht. Die Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Auswertung öffnen</translation>
    </message>
    <message>
        <source>Nothing was recorded</source>
        <translation>Nichts wurde aufgezeichnet</translation>
    </message>
    <message>
        <source>This session ended before its first sample. It is kept and listed.</source>
        <translation>Diese Sitzung endete vor ihrem ersten Messpunkt. Sie bleibt erhalten und steht in der Liste.</translation>
    </message>
    <message>
        <source>The scene at this moment</source>
        <translation>Die Szene in diesem Moment</translation>
    </message>
    <message>
        <source>Trial %1 · force %2 · speed %3</source>
        <translation>Durchgang %1 · Kraft %2 · Tempo %3</translation>
    </message>
    <message>
        <source>The comments could not be read.</source>
        <translation>Die Kommentare konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The comment was not saved. Its text is still here.</source>
        <translation>Der Kommentar wurde nicht gespeichert. Sein Text ist noch da.</translation>
    </message>
    <message>
        <source>second session</source>
        <translation>zweite Sitzung</translation>
    </message>
    <message>
        <source>Depth of field</source>
        <translation>Schärfentiefe</translation>
    </message>
    <message>
        <source>The picture is sharp at one distance only, as through a real endoscope</source>
        <translation>Das Bild ist nur in einer Entfernung scharf, wie durch ein echtes Endoskop</translation>
    </message>
    <message>
        <source>%1 · depth %2 · force %3 · speed %4</source>
        <translation>%1 · Tiefe %2 · Kraft %3 · Tempo %4</translation>
    </message>
    <message>
        <source>squeeze %1</source>
        <translation>Quetschkraft %1</translation>
    </message>
    <message>
        <source>tension %1</source>
        <translation>Spannung %1</translation>
    </message>
    <message>
        <source>Trial %1 · %2 · force %3 · speed %4</source>
        <translation>Durchgang %1 · %2 · Kraft %3 · Tempo %4</translation>
    </message>
    <message>
        <source>Show the lumps</source>
        <translation>Knoten zeigen</translation>
    </message>
    <message>
        <source>Where the lumps were, and how the findings were scored</source>
        <translation>Wo die Knoten waren und wie die Funde gewertet wurden</translation>
    </message>
    <message>
        <source>Map of the whole trial</source>
        <translation>Karte des ganzen Durchgangs</translation>
    </message>
    <message>
        <source>Off: the map up to this moment</source>
        <translation>Aus: die Karte bis zu diesem Augenblick</translation>
    </message>
    <message>
        <source>Force map</source>
        <translation>Kraftkarte</translation>
    </message>
    <message>
        <source>On: how hard the tissue was pressed. Off: where it was searched.</source>
        <translation>An: wie fest gedrückt wurde. Aus: wo abgetastet wurde.</translation>
    </message>
    <message>
        <source>Trial %1 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6</source>
        <translation>Durchgang %1 · Kraft %2 · Neigung %3° · Tiefe %4 · abgetastet %5 % · Funde %6</translation>
    </message>
    <message>
        <source>Findings and maps could not be read from the recording: %1</source>
        <translation>Funde und Karten ließen sich aus der Aufzeichnung nicht lesen: %1</translation>
    </message>
    <message>
        <source>Trial %1 · %7 · force %2 · tilt %3° · depth %4 · searched %5 % · findings %6</source>
        <translation>Durchgang %1 · %7 · Kraft %2 · Neigung %3° · Tiefe %4 · abgetastet %5 % · Funde %6</translation>
    </message>
    <message>
        <source>force stopped</source>
        <translation>Kraft gestoppt</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>%1 · %2 · depth %3 · force %4 · speed %5</source>
        <translation>%1 · %2 · Tiefe %3 · Kraft %4 · Tempo %5</translation>
    </message>
    <message>
        <source>Trial %1 · %2 · %3 · force %4 · speed %5</source>
        <translation>Durchgang %1 · %2 · %3 · Kraft %4 · Tempo %5</translation>
    </message>
    <message>
        <source>Comments (C)</source>
        <translation>Kommentare (C)</translation>
    </message>
    <message>
        <source>A session as it was recorded.

Space plays and pauses. The arrow keys move one frame forward or back, with Shift one second, with Ctrl to the next or previous event; Home and End jump to the beginning and the end. Clicking in a plot jumps to that time. Plus and minus zoom the plots, 0 shows the whole session.

C writes a comment at the moment shown.

Pauses are hatched, and skipped unless you switch that off. Triangles on the time bar are penalties, flags are answers, squares below it are comments.

Choose a second session to see it beside this one: each of its trials starts together with the trial here and is drawn in the same place.</source>
        <translation>Eine Sitzung, wie sie aufgezeichnet wurde.

Die Leertaste startet und hält an. Die Pfeiltasten gehen ein Bild vor oder zurück, mit Umschalt eine Sekunde, mit Strg zum nächsten oder vorigen Ereignis; Pos1 und Ende springen zum Anfang und zum Ende. Ein Klick in ein Diagramm springt zu diesem Zeitpunkt. Plus und Minus vergrößern und verkleinern die Diagramme, 0 zeigt die ganze Sitzung.

Mit C schreiben Sie einen Kommentar zum gezeigten Zeitpunkt.

Pausen sind schraffiert und werden übersprungen, solange Sie das nicht abschalten. Dreiecke auf der Zeitleiste sind Abzüge, Fahnen sind Antworten, Quadrate darunter sind Kommentare.

Wählen Sie eine zweite Sitzung, um sie neben dieser zu sehen: Jeder ihrer Durchgänge beginnt zusammen mit dem Durchgang hier und wird an derselben Stelle gezeichnet.</translation>
    </message>
    <message>
        <source>Write a comment at this moment</source>
        <translation>Einen Kommentar zu diesem Zeitpunkt schreiben</translation>
    </message>
    <message>
        <source>Zoom in on the plots</source>
        <translation>Diagramme vergrößern</translation>
    </message>
    <message>
        <source>Zoom out of the plots</source>
        <translation>Diagramme verkleinern</translation>
    </message>
    <message>
        <source>The whole session in the plots</source>
        <translation>Die ganze Sitzung in den Diagrammen</translation>
    </message>
    <message>
        <source>Session %1 was not voided; nothing was changed.</source>
        <translation>Sitzung %1 wurde nicht für ungültig erklärt; es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>Session %1 is voided. Its recording is kept; it no longer counts.</source>
        <translation>Sitzung %1 ist für ungültig erklärt. Ihre Aufzeichnung bleibt erhalten; sie zählt nicht mehr.</translation>
    </message>
    <message>
        <source>The comment is saved. %1 will see it on Home.</source>
        <translation>Der Kommentar ist gespeichert. %1 wird unter „Start“ darauf hingewiesen.</translation>
    </message>
    <message>
        <source>The comment is saved, and the session counts as reviewed. %1 will see it on Home.</source>
        <translation>Der Kommentar ist gespeichert, und die Sitzung gilt als begutachtet. %1 wird unter „Start“ darauf hingewiesen.</translation>
    </message>
    <message>
        <source>This session was void and counts again. The debrief says who decided it and why.</source>
        <translation>Diese Sitzung war ungültig und zählt wieder. Die Auswertung sagt, wer das entschieden hat und warum.</translation>
    </message>
    <message>
        <source>%1, attempt %2 at level %3: %4</source>
        <translation>%1, Versuch %2 auf Stufe %3: %4</translation>
    </message>
    <message>
        <source>Count it again …</source>
        <translation>Wieder zählen …</translation>
    </message>
    <message>
        <source>Session %1 counts again. Its history still shows that it was void.</source>
        <translation>Sitzung %1 zählt wieder. Dass sie ungültig war, bleibt vermerkt.</translation>
    </message>
    <message>
        <source>Session %1 is still void; nothing was changed.</source>
        <translation>Sitzung %1 ist weiterhin ungültig; es wurde nichts geändert.</translation>
    </message>
    <message>
        <source>A cross in the scene shows where tissue gave way, or where an object of a study came off the tool.</source>
        <translation>Ein Kreuz in der Szene zeigt, wo Gewebe nachgegeben oder sich ein Objekt einer Studie vom Instrument gelöst hat.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::PreviewPage</name>
    <message>
        <source>Their Weber fraction</source>
        <translation>Ihr Weber-Bruch</translation>
    </message>
    <message>
        <source>Lapse rate</source>
        <translation>Lapse-Rate</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>expected bias of the Weber fraction</source>
        <translation>erwartete Verzerrung des Weber-Bruchs</translation>
    </message>
    <message>
        <source>precision: SD of one run, as a factor</source>
        <translation>Genauigkeit: SD eines Laufs, als Faktor</translation>
    </message>
    <message>
        <source>95 % intervals that contain the true value</source>
        <translation>95-%-Intervalle, die den wahren Wert enthalten</translation>
    </message>
    <message>
        <source>How the estimate converges with more trials</source>
        <translation>Wie sich die Schätzung mit mehr Durchgängen stabilisiert</translation>
    </message>
    <message>
        <source>Trials of a run</source>
        <translation>Durchgänge eines Laufs</translation>
    </message>
    <message>
        <source>Weber fraction (%)</source>
        <translation>Weber-Bruch (%)</translation>
    </message>
    <message numerus="yes">
        <source>median of %n run(s)</source>
        <translation>
            <numerusform>%n Lauf</numerusform>
            <numerusform>Median von %n Läufen</numerusform>
        </translation>
    </message>
    <message>
        <source>middle 80 %</source>
        <translation>mittlere 80 %</translation>
    </message>
    <message>
        <source>true value</source>
        <translation>wahrer Wert</translation>
    </message>
    <message>
        <source>Equality threshold (σ)</source>
        <translation>Gleichheitsschwelle (σ)</translation>
    </message>
    <message>
        <source>Runs per condition</source>
        <translation>Läufe je Bedingung</translation>
    </message>
    <message>
        <source>±: one standard error of so few simulated runs; more runs make it smaller.</source>
        <translation>±: ein Standardfehler bei so wenigen simulierten Durchläufen; mehr Durchläufe machen ihn kleiner.</translation>
    </message>
    <message>
        <source>For comparing two conditions, the variation between people is assumed, not simulated. Changes take effect at once.</source>
        <translation>Für den Vergleich zweier Bedingungen wird die Streuung zwischen Personen angenommen, nicht simuliert. Änderungen wirken sofort.</translation>
    </message>
    <message>
        <source>Each participant does both conditions</source>
        <translation>Jede Person macht beide Bedingungen</translation>
    </message>
    <message>
        <source>Significance level, two-sided</source>
        <translation>Signifikanzniveau, zweiseitig</translation>
    </message>
    <message>
        <source>Desired power</source>
        <translation>Gewünschte Teststärke</translation>
    </message>
    <message>
        <source>none up to × 10</source>
        <translation>keines bis × 10</translation>
    </message>
    <message>
        <source>How well an apex is found is planned with the published spread of marks, %1 of the radius along each axis.</source>
        <translation>Wie gut ein Scheitel gefunden wird, wird mit der veröffentlichten Streuung der Markierungen geplant: %1 des Radius je Achse.</translation>
    </message>
    <message>
        <source>How many people are compared.</source>
        <translation>Wie viele Personen verglichen werden.</translation>
    </message>
    <message>
        <source>How often a difference may be found where there is none.</source>
        <translation>Wie oft ein Unterschied gefunden werden darf, wo keiner ist.</translation>
    </message>
    <message>
        <source>spread of one mark along an axis, as published</source>
        <translation>Streuung einer Markierung je Achse, wie veröffentlicht</translation>
    </message>
    <message>
        <source>standard error of one participant&apos;s bias</source>
        <translation>Standardfehler der Verschiebung einer Person</translation>
    </message>
    <message numerus="yes">
        <source>standard error of the bias of %n participant(s), if they do not differ</source>
        <translation>
            <numerusform>Standardfehler der Verschiebung von %n Person, falls sie sich nicht unterscheiden</numerusform>
            <numerusform>Standardfehler der Verschiebung von %n Personen, falls sie sich nicht unterscheiden</numerusform>
        </translation>
    </message>
    <message>
        <source>± one standard error</source>
        <translation>± ein Standardfehler</translation>
    </message>
    <message>
        <source>Paired: SD of the difference from person to person</source>
        <translation>Gepaart: SD des Unterschieds von Person zu Person</translation>
    </message>
    <message>
        <source>Two groups: SD between people</source>
        <translation>Zwei Gruppen: SD zwischen Personen</translation>
    </message>
    <message>
        <source>How much the difference varies between people: 12 % is a factor of 1.12.</source>
        <translation>Wie stark der Unterschied von Person zu Person streut: 12 % entsprechen dem Faktor 1,12.</translation>
    </message>
    <message>
        <source>How much people vary: 40 % is a factor of 1.4.</source>
        <translation>Wie stark sich Personen unterscheiden: 40 % entsprechen dem Faktor 1,4.</translation>
    </message>
    <message>
        <source>Share of their answers that is careless.</source>
        <translation>Anteil ihrer unachtsamen Antworten.</translation>
    </message>
    <message>
        <source>Simulated observers call smaller differences equal; in standard deviations of what they feel.</source>
        <translation>Kleinere Unterschiede nennen simulierte Beobachter gleich; in Standardabweichungen dessen, was sie spüren.</translation>
    </message>
    <message>
        <source>More runs take longer and give more precise figures.</source>
        <translation>Mehr Läufe dauern länger und ergeben genauere Zahlen.</translation>
    </message>
    <message>
        <source>Otherwise each person does one of them.</source>
        <translation>Sonst macht jede Person eine von beiden.</translation>
    </message>
    <message>
        <source>How often an existing difference should be found.</source>
        <translation>Wie oft ein vorhandener Unterschied gefunden werden soll.</translation>
    </message>
    <message>
        <source>The just noticeable difference of these observers, as a share of the reference.</source>
        <translation>Die Unterschiedsschwelle dieser Beobachter, als Anteil der Referenz.</translation>
    </message>
    <message>
        <source>Participants (with two groups: in each)</source>
        <translation>Personen (bei zwei Gruppen: je Gruppe)</translation>
    </message>
    <message>
        <source>While the study is blinded, its conditions and their expected precision are sealed. Only the study&apos;s author can estimate it.</source>
        <translation>Solange die Studie verblindet ist, sind ihre Bedingungen und deren erwartete Genauigkeit versiegelt. Nur die Person, die die Studie angelegt hat, kann die Genauigkeit schätzen.</translation>
    </message>
    <message>
        <source>The program calculates how precise the results will be: simulated observers, whose true values are known, run through the study without haptic rendering. They are no participants, and nothing of it is stored as data. To see the study as a participant does, use Pilot run under Check and freeze.</source>
        <translation>Das Programm berechnet, wie genau die Ergebnisse werden: Simulierte Beobachter, deren wahre Werte bekannt sind, durchlaufen die Studie ohne haptische Darstellung. Sie nehmen nicht teil, und nichts davon wird als Daten gespeichert. Um die Studie so zu sehen, wie Teilnehmende sie sehen, starten Sie einen Probelauf unter „Prüfen und einfrieren“.</translation>
    </message>
    <message>
        <source>Estimate the precision</source>
        <translation>Genauigkeit schätzen</translation>
    </message>
    <message>
        <source>Progress of the simulation</source>
        <translation>Fortschritt der Simulation</translation>
    </message>
    <message>
        <source>The precision could not be estimated. %1</source>
        <translation>Die Genauigkeit konnte nicht geschätzt werden. %1</translation>
    </message>
    <message>
        <source>trials of one run of this condition</source>
        <translation>Durchgänge eines Laufs dieser Bedingung</translation>
    </message>
    <message>
        <source>minutes of one run, breaks included</source>
        <translation>Minuten eines Laufs, Pausen eingeschlossen</translation>
    </message>
    <message>
        <source>smallest ratio of two conditions&apos; Weber fractions that is found with %1 power and %2 participants who do both conditions</source>
        <translation>kleinstes Verhältnis der Weber-Brüche zweier Bedingungen, das sich mit %1 Teststärke bei %2 Personen in beiden Bedingungen nachweisen lässt</translation>
    </message>
    <message>
        <source>smallest ratio of two conditions&apos; Weber fractions that is found with %1 power and two groups of %2 participants</source>
        <translation>kleinstes Verhältnis der Weber-Brüche zweier Bedingungen, das sich mit %1 Teststärke bei zwei Gruppen von je %2 Personen nachweisen lässt</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProcedureForm</name>
    <message>
        <source>Procedure</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Change of the procedure</source>
        <translation>Änderung des Verfahrens</translation>
    </message>
    <message>
        <source>Logarithmic steps of an imported design.</source>
        <translation>Logarithmische Schritte eines eingelesenen Entwurfs.</translation>
    </message>
    <message>
        <source>Factors of the difference, usually 1.26.</source>
        <translation>Faktoren des Unterschieds, meist 1,26.</translation>
    </message>
    <message>
        <source>In per cent of the reference.</source>
        <translation>In Prozent der Referenz.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>Schwelle</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>%1 (%)</source>
        <translation>%1 (%)</translation>
    </message>
    <message>
        <source>%1: from</source>
        <translation>%1: von</translation>
    </message>
    <message>
        <source>%1: to</source>
        <translation>%1: bis</translation>
    </message>
    <message>
        <source>%1: steps</source>
        <translation>%1: Schritte</translation>
    </message>
    <message>
        <source>More steps are finer, and take longer to compute.</source>
        <translation>Mehr Schritte sind feiner und brauchen mehr Rechenzeit.</translation>
    </message>
    <message>
        <source>Choice of the procedure</source>
        <translation>Wahl des Verfahrens</translation>
    </message>
    <message>
        <source>How many times each participant searches for the apex.</source>
        <translation>Wie oft jede Person den Scheitel sucht.</translation>
    </message>
    <message>
        <source>Possible shares of wrong answers to differences that are felt.</source>
        <translation>Mögliche Anteile falscher Antworten auf Unterschiede, die gespürt werden.</translation>
    </message>
    <message>
        <source>Share of answers that are right by guessing: 50 % with two alternatives.</source>
        <translation>Anteil der durch Raten richtigen Antworten: 50 % bei zwei Alternativen.</translation>
    </message>
    <message>
        <source>The largest value that is considered possible.</source>
        <translation>Der größte Wert, der als möglich gilt.</translation>
    </message>
    <message>
        <source>The largest value. The imported design spaces these values irregularly; after a change they are spaced regularly.</source>
        <translation>Der größte Wert. Der eingelesene Entwurf verteilt diese Werte unregelmäßig; nach einer Änderung sind sie regelmäßig verteilt.</translation>
    </message>
    <message>
        <source>The threshold is assumed to lie between these two values.</source>
        <translation>Es wird angenommen, dass die Schwelle zwischen diesen beiden Werten liegt.</translation>
    </message>
    <message>
        <source>The spread of the answers is assumed to lie between these two values.</source>
        <translation>Es wird angenommen, dass die Streuung der Antworten zwischen diesen beiden Werten liegt.</translation>
    </message>
    <message>
        <source>Slopes that are considered possible: how steeply the share of right answers grows with the difference. Usually 1.5 to 7.</source>
        <translation>Steigungen, die als möglich gelten: wie steil der Anteil richtiger Antworten mit dem Unterschied zunimmt. Meist 1,5 bis 7.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProgressScreen</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Names, with commas between them</source>
        <translation>Namen, mit Kommas dazwischen</translation>
    </message>
    <message>
        <source>Names: Ada, Nikos, …</source>
        <translation>Namen: Ada, Nikos, …</translation>
    </message>
    <message>
        <source>Which people</source>
        <translation>Welche Personen</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>With sessions to review</source>
        <translation>Mit zu begutachtenden Sitzungen</translation>
    </message>
    <message numerus="yes">
        <source>No session in the last %n day(s)</source>
        <translation>
            <numerusform>Seit %n Tag keine Sitzung</numerusform>
            <numerusform>Seit %n Tagen keine Sitzung</numerusform>
        </translation>
    </message>
    <message>
        <source>Not every level passed</source>
        <translation>Nicht alle Stufen bestanden</translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Filter löschen</translation>
    </message>
    <message>
        <source>Open the sessions</source>
        <translation>Sitzungen öffnen</translation>
    </message>
    <message>
        <source>Results of this person</source>
        <translation>Ergebnisse dieser Person</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Reading how far everybody is …</source>
        <translation>Der Stand aller Personen wird gelesen …</translation>
    </message>
    <message>
        <source>The progress of the group could not be read.</source>
        <translation>Der Fortschritt der Gruppe konnte nicht gelesen werden.</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 people</source>
        <translation>%1 von %2 Personen</translation>
    </message>
    <message>
        <source>There are no trainees yet</source>
        <translation>Es gibt noch keine Lernenden</translation>
    </message>
    <message>
        <source>As soon as an administrator has added trainees under People, they are listed here, even before they have trained.</source>
        <translation>Sobald die Administration unter „Personen“ Lernende hinzugefügt hat, stehen sie hier, auch wenn sie noch nicht trainiert haben.</translation>
    </message>
    <message>
        <source>Nobody matches these filters</source>
        <translation>Zu diesen Filtern passt niemand</translation>
    </message>
    <message numerus="yes">
        <source>%n person(s) in all.</source>
        <translation>
            <numerusform>Insgesamt %n Person.</numerusform>
            <numerusform>Insgesamt %n Personen.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 has no sessions yet.</source>
        <translation>%1 hat noch keine Sitzungen.</translation>
    </message>
    <message>
        <source>How far each person of the group is.

A row is a person. Under each exercise you see the lowest level that the person has not passed, or &quot;All passed&quot;; a cross marks a level that they have tried. &quot;Last session&quot; says when they trained last, and &quot;To review&quot; how many of their sessions await your review. The line below the table says more about the chosen cell: the standing at every level of an exercise, or, at the name, the step that the program offers next. Trainees whose accounts are disabled are left out.

The program keeps no lists of groups: type several names with commas between them to see only these people. The list beside it shows only those who have not trained for some time, or who have not passed everything.

Choose a cell with the arrow keys and press Enter to see the sessions of that person at that exercise.</source>
        <translation>Wie weit jede Person der Gruppe ist.

Eine Zeile ist eine Person. Unter jeder Übung steht die niedrigste Stufe, die die Person nicht bestanden hat, oder „Alle bestanden“; ein Kreuz kennzeichnet eine Stufe, die sie schon versucht hat. „Letzte Sitzung“ sagt, wann zuletzt trainiert wurde, und „Zu begutachten“, wie viele Sitzungen der Person auf Ihre Begutachtung warten. Die Zeile unter der Tabelle sagt mehr zur gewählten Zelle: den Stand auf jeder Stufe einer Übung oder, beim Namen, was das Programm als Nächstes anbietet. Lernende, deren Konto gesperrt ist, stehen nicht in der Liste.

Das Programm führt keine Gruppenlisten: Geben Sie mehrere Namen mit Kommas dazwischen ein, um nur diese Personen zu sehen. Mit der Auswahl daneben bleiben nur die Personen stehen, die länger nicht trainiert oder noch nicht alles bestanden haben.

Wählen Sie mit den Pfeiltasten eine Zelle und drücken Sie Enter, um die Sitzungen dieser Person in dieser Übung zu sehen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ProgressTable</name>
    <message>
        <source>Progress of the group</source>
        <translation>Fortschritt der Gruppe</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Last session</source>
        <translation>Letzte Sitzung</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Zu begutachten</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>Noch keine</translation>
    </message>
    <message>
        <source>All passed</source>
        <translation>Alle bestanden</translation>
    </message>
    <message>
        <source>Not begun</source>
        <translation>Nicht begonnen</translation>
    </message>
    <message numerus="yes">
        <source>Level %1, %n attempt(s)</source>
        <translation>
            <numerusform>Stufe %1, %n Versuch</numerusform>
            <numerusform>Stufe %1, %n Versuche</numerusform>
        </translation>
    </message>
    <message>
        <source>Level %1, not tried</source>
        <translation>Stufe %1, nicht versucht</translation>
    </message>
    <message>
        <source>%1, level %2</source>
        <translation>%1, Stufe %2</translation>
    </message>
    <message>
        <source>level %1: %2</source>
        <translation>Stufe %1: %2</translation>
    </message>
    <message>
        <source>%1, %2 – %3</source>
        <translation>%1, %2 – %3</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>every level is passed</source>
        <translation>alle Stufen sind bestanden</translation>
    </message>
    <message>
        <source>%1 – next step: %2</source>
        <translation>%1 – nächster Schritt: %2</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QualityBox</name>
    <message>
        <source>Results stay sealed until the study is unblinded: answers, times and even the number of trials could reveal which condition is which. This page shows how well the trials went, for each participant, across all conditions.</source>
        <translation>Ergebnisse bleiben versiegelt, bis die Studie entblindet ist: Antworten, Zeiten und sogar die Zahl der Durchgänge könnten verraten, welche Bedingung welche ist. Wie gut die Durchgänge liefen, steht hier für jede Person, über alle Bedingungen zusammen.</translation>
    </message>
    <message>
        <source>The number of trials is shown only for participants who have completed every condition.</source>
        <translation>Die Zahl der Durchgänge steht nur bei Personen, die alle Bedingungen abgeschlossen haben.</translation>
    </message>
    <message>
        <source>Quality of the trials</source>
        <translation>Qualität der Durchgänge</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Conditions done</source>
        <translation>Bedingungen erledigt</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Scored</source>
        <translation>Gewertet</translation>
    </message>
    <message>
        <source>Repeated</source>
        <translation>Wiederholt</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>gezeigt, nicht gefühlt</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireForm</name>
    <message>
        <source>%1 (optional)</source>
        <translation>%1 (freiwillig)</translation>
    </message>
    <message>
        <source>Please answer this question.</source>
        <translation>Bitte beantworten Sie diese Frage.</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>From %1 to %2</source>
        <translation>Von %1 bis %2</translation>
    </message>
    <message>
        <source>Not answered yet: move the slider, or press Space to leave it in the middle.</source>
        <translation>Noch nicht beantwortet: Bewegen Sie den Schieber, oder drücken Sie die Leertaste, um ihn in der Mitte zu lassen.</translation>
    </message>
    <message>
        <source>Step %1 of %2</source>
        <translation>Stufe %1 von %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireScreen</name>
    <message>
        <source>Questionnaire</source>
        <translation>Fragebogen</translation>
    </message>
    <message>
        <source>Reading the questions …</source>
        <translation>Fragen werden gelesen …</translation>
    </message>
    <message>
        <source>The questionnaire could not be read</source>
        <translation>Der Fragebogen konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Already answered</source>
        <translation>Schon beantwortet</translation>
    </message>
    <message>
        <source>Each participant answers a questionnaire once.</source>
        <translation>Jede Person beantwortet einen Fragebogen einmal.</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>This questionnaire does not exist</source>
        <translation>Diesen Fragebogen gibt es nicht</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>Submit</source>
        <translation>Abgeben</translation>
    </message>
    <message>
        <source>Thank you. The answers are stored.</source>
        <translation>Danke. Die Antworten sind gespeichert.</translation>
    </message>
    <message>
        <source>Leave without submitting?</source>
        <translation>Verlassen ohne abzugeben?</translation>
    </message>
    <message>
        <source>The answers on this page are not stored yet.</source>
        <translation>Die Antworten auf dieser Seite sind noch nicht gespeichert.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Each participant answers these questions once, or once about each condition.

Press Tab to move from question to question, the arrow keys to move along a scale, Space to choose. Required questions are marked if they are left unanswered. The answers are stored under the participant&apos;s code as soon as they are submitted.</source>
        <translation>Jede Person beantwortet diese Fragen einmal, oder einmal zu jeder Bedingung.

Mit Tab gelangen Sie von Frage zu Frage, mit den Pfeiltasten bewegen Sie sich auf einer Skala, mit der Leertaste wählen Sie. Pflichtfragen ohne Antwort werden gekennzeichnet. Die Antworten werden unter dem Code der Person gespeichert, sobald sie abgegeben werden.</translation>
    </message>
    <message>
        <source>Each participant answers it once about each condition.</source>
        <translation>Jede Person beantwortet ihn einmal zu jeder Bedingung.</translation>
    </message>
    <message>
        <source>The answers were not stored. They are still on this page: press Submit again, and call the experimenter if that does not help.
%1</source>
        <translation>Die Antworten wurden nicht gespeichert. Sie stehen noch auf dieser Seite: Drücken Sie noch einmal „Abgeben“, und rufen Sie die Versuchsleitung, wenn das nicht hilft.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnaireSummary</name>
    <message>
        <source>This study has no questionnaires.</source>
        <translation>Diese Studie hat keine Fragebögen.</translation>
    </message>
    <message>
        <source>Nobody has answered it yet.</source>
        <translation>Noch niemand hat ihn beantwortet.</translation>
    </message>
    <message numerus="yes">
        <source>Answered by %n participant(s)</source>
        <translation>
            <numerusform>Beantwortet von %n Person</numerusform>
            <numerusform>Beantwortet von %n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>No answers</source>
        <translation>Keine Antworten</translation>
    </message>
    <message>
        <source>Median %1, interquartile range %2 to %3</source>
        <translation>Median %1, Interquartilbereich %2 bis %3</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>Answers</source>
        <translation>Antworten</translation>
    </message>
    <message>
        <source>%1 … %2</source>
        <translation>%1 … %2</translation>
    </message>
    <message>
        <source>answers</source>
        <translation>Antworten</translation>
    </message>
    <message numerus="yes">
        <source>%1: median %2, from %3 to %4, of %n participant(s)</source>
        <translation>
            <numerusform>%1: Median %2, von %3 bis %4, von %n Person</numerusform>
            <numerusform>%1: Median %2, von %3 bis %4, von %n Personen</numerusform>
        </translation>
    </message>
    <message>
        <source>Usability score (0 to 100)</source>
        <translation>Wertung der Gebrauchstauglichkeit (0 bis 100)</translation>
    </message>
    <message>
        <source>Workload (0 to 100)</source>
        <translation>Beanspruchung (0 bis 100)</translation>
    </message>
    <message>
        <source>Laterality quotient (−100 left, 100 right)</source>
        <translation>Lateralitätsquotient (−100 links, 100 rechts)</translation>
    </message>
    <message>
        <source>Answers about single conditions are shown once the study is unblinded.</source>
        <translation>Antworten zu einzelnen Bedingungen werden gezeigt, sobald die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>About the condition %1</source>
        <translation>Zur Bedingung %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::QuestionnairesPage</name>
    <message>
        <source>Scale with labelled ends</source>
        <translation>Skala mit beschrifteten Enden</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>Choice</source>
        <translation>Auswahl</translation>
    </message>
    <message>
        <source>Free text</source>
        <translation>Freier Text</translation>
    </message>
    <message>
        <source>Add a questionnaire</source>
        <translation>Fragebogen hinzufügen</translation>
    </message>
    <message>
        <source>Title of the questionnaire</source>
        <translation>Titel des Fragebogens</translation>
    </message>
    <message>
        <source>Id</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Id of a questionnaire</source>
        <translation>Kennung eines Fragebogens</translation>
    </message>
    <message>
        <source>Answered</source>
        <translation>Beantwortet</translation>
    </message>
    <message>
        <source>before the runs</source>
        <translation>vor den Läufen</translation>
    </message>
    <message>
        <source>after the runs</source>
        <translation>nach den Läufen</translation>
    </message>
    <message>
        <source>When it is answered</source>
        <translation>Wann er beantwortet wird</translation>
    </message>
    <message>
        <source>Add a question</source>
        <translation>Frage hinzufügen</translation>
    </message>
    <message>
        <source>Remove the questionnaire</source>
        <translation>Fragebogen entfernen</translation>
    </message>
    <message>
        <source>Change of a question</source>
        <translation>Änderung einer Frage</translation>
    </message>
    <message>
        <source>Question %1</source>
        <translation>Frage %1</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Summarised under</source>
        <translation>Zusammengefasst unter</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Label at low end</source>
        <translation>Beschriftung unten</translation>
    </message>
    <message>
        <source>Label at high end</source>
        <translation>Beschriftung oben</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Choices, one per line</source>
        <translation>Antworten, eine je Zeile</translation>
    </message>
    <message>
        <source>Must be answered</source>
        <translation>Muss beantwortet werden</translation>
    </message>
    <message>
        <source>Remove question %1</source>
        <translation>Frage %1 entfernen</translation>
    </message>
    <message>
        <source>Add a published questionnaire …</source>
        <translation>Veröffentlichten Fragebogen hinzufügen …</translation>
    </message>
    <message>
        <source>Published questionnaires with their scores, and what is written down when a participant is enrolled</source>
        <translation>Veröffentlichte Fragebögen mit ihrer Auswertung und was bei der Aufnahme einer Person notiert wird</translation>
    </message>
    <message>
        <source>The published questionnaires could not be read.</source>
        <translation>Die veröffentlichten Fragebögen konnten nicht gelesen werden.</translation>
    </message>
    <message>
        <source>Add a published questionnaire</source>
        <translation>Veröffentlichten Fragebogen hinzufügen</translation>
    </message>
    <message>
        <source>when a participant is enrolled</source>
        <translation>bei der Aufnahme einer Person</translation>
    </message>
    <message>
        <source>No questionnaires. Each participant answers a questionnaire once, before or after the runs, or after each condition. The answers are stored with the data.</source>
        <translation>Keine Fragebögen. Jede Person beantwortet einen Fragebogen einmal, vor oder nach den Läufen, oder nach jeder Bedingung. Die Antworten werden bei den Daten gespeichert.</translation>
    </message>
    <message>
        <source>after each condition, about that condition</source>
        <translation>nach jeder Bedingung, zu dieser Bedingung</translation>
    </message>
    <message>
        <source>The questionnaire “%1” was removed.</source>
        <translation>Der Fragebogen „%1“ wurde entfernt.</translation>
    </message>
    <message>
        <source>Question %1 was removed.</source>
        <translation>Frage %1 wurde entfernt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RankingBox</name>
    <message>
        <source>reference</source>
        <translation>Bezug</translation>
    </message>
    <message>
        <source>D more</source>
        <translation>D mehr</translation>
    </message>
    <message>
        <source>2D more</source>
        <translation>2D mehr</translation>
    </message>
    <message>
        <source>p not known</source>
        <translation>p nicht bekannt</translation>
    </message>
    <message>
        <source>p &lt; %1</source>
        <translation>p &lt; %1</translation>
    </message>
    <message>
        <source>p = %1</source>
        <translation>p = %1</translation>
    </message>
    <message>
        <source>Rankings</source>
        <translation>Rangfolgen</translation>
    </message>
    <message>
        <source>There are no scored rankings yet. Agreement and worths appear here after the first one.</source>
        <translation>Noch ist keine Rangfolge gewertet. Übereinstimmung und Werte erscheinen hier nach der ersten.</translation>
    </message>
    <message numerus="yes">
        <source>%n ranking(s) of three objects; each is one judgement.</source>
        <translation>
            <numerusform>%n Rangfolge von drei Objekten; jede ist ein Urteil.</numerusform>
            <numerusform>%n Rangfolgen von drei Objekten; jede ist ein Urteil.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s); each one&apos;s mean ranks are one judgement.</source>
        <translation>
            <numerusform>%n Person; ihre mittleren Ränge sind ein Urteil.</numerusform>
            <numerusform>%n Personen; die mittleren Ränge jeder Person sind ein Urteil.</numerusform>
        </translation>
    </message>
    <message>
        <source>no interval</source>
        <translation>kein Intervall</translation>
    </message>
    <message>
        <source>95 %: %1</source>
        <translation>95 %: %1</translation>
    </message>
    <message>
        <source>Completely correct orders</source>
        <translation>Vollständig richtige Rangfolgen</translation>
    </message>
    <message>
        <source>%1 of %2; guessing gives 16.7 %.</source>
        <translation>%1 von %2; Raten ergibt 16,7 %.</translation>
    </message>
    <message>
        <source>Kendall&apos;s τ</source>
        <translation>Kendalls τ</translation>
    </message>
    <message>
        <source>Similarity to the true order: 1 = identical, 0 = unrelated, −1 = reversed.</source>
        <translation>Ähnlichkeit mit der wahren Rangfolge: 1 = gleich, 0 = kein Zusammenhang, −1 = umgekehrt.</translation>
    </message>
    <message>
        <source>Kendall&apos;s W</source>
        <translation>Kendalls W</translation>
    </message>
    <message>
        <source>How closely the rankings agree: 0 = not at all, 1 = completely.</source>
        <translation>Wie stark die Rangfolgen übereinstimmen: 0 = gar nicht, 1 = völlig.</translation>
    </message>
    <message>
        <source>How closely the participants agree: 0 = not at all, 1 = completely.</source>
        <translation>Wie stark die Personen übereinstimmen: 0 = gar nicht, 1 = völlig.</translation>
    </message>
    <message>
        <source>Page&apos;s L</source>
        <translation>Pages L</translation>
    </message>
    <message>
        <source>Trend towards the true order; guessing gives %1 on average.</source>
        <translation>Trend zur wahren Rangfolge; Raten ergibt im Mittel %1.</translation>
    </message>
    <message>
        <source>Worth of each object</source>
        <translation>Wert jedes Objekts</translation>
    </message>
    <message>
        <source>How much more often an object was ranked above the others, estimated by three models. The farther apart two values are, the easier the objects are to tell apart. All differences D of the run are pooled, and rankings are treated as independent of each other.</source>
        <translation>Wie viel öfter ein Objekt über den anderen stand, geschätzt nach drei Modellen. Je weiter die Werte auseinanderliegen, desto leichter sind die Objekte zu unterscheiden. Alle Unterschiede D des Laufs sind zusammengefasst, und die Rangfolgen gelten als unabhängig voneinander.</translation>
    </message>
    <message>
        <source>The worths cannot be estimated: an object was always, or never, ranked above the others. This happens when the difference is very clear.</source>
        <translation>Die Werte lassen sich nicht schätzen: Ein Objekt stand immer oder nie über den anderen. Das kommt vor, wenn der Unterschied sehr deutlich ist.</translation>
    </message>
    <message>
        <source>Bradley-Terry</source>
        <translation>Bradley-Terry</translation>
    </message>
    <message>
        <source>ln worth</source>
        <translation>ln Wert</translation>
    </message>
    <message>
        <source>Plackett-Luce</source>
        <translation>Plackett-Luce</translation>
    </message>
    <message>
        <source>Thurstone</source>
        <translation>Thurstone</translation>
    </message>
    <message>
        <source>Scale (SD of a difference)</source>
        <translation>Skala (SD einer Differenz)</translation>
    </message>
    <message>
        <source>Not estimable</source>
        <translation>Nicht schätzbar</translation>
    </message>
    <message>
        <source>estimate with its 95 % interval</source>
        <translation>Schätzung mit 95-%-Intervall</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Worth</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>95 % interval</source>
        <translation>95-%-Intervall</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>not estimable</source>
        <translation>nicht schätzbar</translation>
    </message>
    <message numerus="yes">
        <source>%n ranking(s) contained ties.</source>
        <translation>
            <numerusform>%n Rangfolge enthielt einen Gleichstand.</numerusform>
            <numerusform>%n Rangfolgen enthielten Gleichstände.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2; guessing gives 16.7 % or less.</source>
        <translation>%1 von %2; Raten ergibt 16,7 % oder weniger.</translation>
    </message>
    <message>
        <source>Bradley-Terry, ties by Davidson</source>
        <translation>Bradley-Terry, Gleichstände nach Davidson</translation>
    </message>
    <message>
        <source>Each answer decided what came next, so one person&apos;s trials are not independent: they have no interval and no p.</source>
        <translation>Jede Antwort hat bestimmt, was als Nächstes kam; die Durchgänge einer Person sind deshalb nicht unabhängig: Sie haben kein Intervall und kein p.</translation>
    </message>
    <message>
        <source>no p</source>
        <translation>kein p</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RatingRow</name>
    <message>
        <source>keys 1 to 5</source>
        <translation>Tasten 1 bis 5</translation>
    </message>
    <message>
        <source>%1: %2, %3 of 5</source>
        <translation>%1: %2, %3 von 5</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ReadyCard</name>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>To pass:
•  %1</source>
        <translation>Zum Bestehen:
•  %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Resume (Enter)</source>
        <translation>Weiter (Enter)</translation>
    </message>
    <message>
        <source>Go (Enter)</source>
        <translation>Los (Enter)</translation>
    </message>
    <message>
        <source>Practise for a minute</source>
        <translation>Eine Minute üben</translation>
    </message>
    <message>
        <source>Try the controls here for a minute. It is recorded as a familiarisation and does not count.</source>
        <translation>Probieren Sie hier eine Minute lang die Bedienung aus. Das wird als Eingewöhnung aufgezeichnet und zählt nicht.</translation>
    </message>
    <message>
        <source>More</source>
        <translation>Mehr</translation>
    </message>
    <message>
        <source>Help for this screen</source>
        <translation>Hilfe zu dieser Seite</translation>
    </message>
    <message>
        <source>In the scene:
•  %1</source>
        <translation>In der Szene:
•  %1</translation>
    </message>
    <message>
        <source>Practise for another minute</source>
        <translation>Noch eine Minute üben</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Watch first</source>
        <translation>Erst zusehen</translation>
    </message>
    <message>
        <source>Watch a scripted expert at this level. Nothing is counted.</source>
        <translation>Sehen Sie auf dieser Stufe einem programmierten Experten zu. Nichts davon wird gewertet.</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>Nicht jetzt</translation>
    </message>
    <message>
        <source>Arrow keys: read on</source>
        <translation>Pfeiltasten: weiterlesen</translation>
    </message>
    <message>
        <source>Space: read on</source>
        <translation>Leertaste: weiterlesen</translation>
    </message>
    <message>
        <source>Back to the scene (Enter)</source>
        <translation>Zurück zur Szene (Enter)</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryCodeDialog</name>
    <message>
        <source>Make a recovery code</source>
        <translation>Wiederherstellungscode erstellen</translation>
    </message>
    <message>
        <source>With a recovery code you can set a new password yourself if you forget yours. It is shown once, to be written down.</source>
        <translation>Mit einem Wiederherstellungscode können Sie selbst ein neues Passwort festlegen, falls Sie Ihres vergessen. Er wird einmal gezeigt, damit Sie ihn aufschreiben.</translation>
    </message>
    <message>
        <source>The recovery code that you have now will no longer be accepted.</source>
        <translation>Der Wiederherstellungscode, den Sie jetzt haben, wird dann nicht mehr angenommen.</translation>
    </message>
    <message>
        <source>Your own password</source>
        <translation>Ihr eigenes Passwort</translation>
    </message>
    <message>
        <source>Make the code</source>
        <translation>Code erstellen</translation>
    </message>
    <message>
        <source>No recovery code was made.
%1</source>
        <translation>Es wurde kein Wiederherstellungscode erstellt.
%1</translation>
    </message>
    <message>
        <source>The recovery code is not shown again. Write it down and tick the box first. If you close this window again, it is gone; you can then make a new one.</source>
        <translation>Der Wiederherstellungscode wird nicht noch einmal gezeigt. Schreiben Sie ihn zuerst auf und setzen Sie das Häkchen. Wenn Sie dieses Fenster noch einmal schließen, ist er verloren; Sie können dann einen neuen erstellen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryCodePanel</name>
    <message>
        <source>Your recovery code</source>
        <translation>Ihr Wiederherstellungscode</translation>
    </message>
    <message>
        <source>Recovery code: %1</source>
        <translation>Wiederherstellungscode: %1</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copied</source>
        <translation>Kopiert</translation>
    </message>
    <message>
        <source>Print</source>
        <translation>Drucken</translation>
    </message>
    <message>
        <source>I have written the code down</source>
        <translation>Ich habe den Code aufgeschrieben</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Chiron: recovery code of %1

%2

Keep it as safe as your keys.</source>
        <translation>Chiron: Wiederherstellungscode von %1

%2

Bewahren Sie ihn auf wie einen Schlüssel.</translation>
    </message>
    <message>
        <source>With this code you can set a new password if you forget yours. It is shown only now: the program keeps no readable copy. Without it, only another administrator can help you. Keep it as safe as your keys.</source>
        <translation>Mit diesem Code können Sie ein neues Passwort festlegen, falls Sie Ihres vergessen. Er wird nur jetzt gezeigt: Das Programm bewahrt keine lesbare Kopie auf. Ohne ihn kann Ihnen nur eine andere Person der Administration helfen. Bewahren Sie ihn auf wie einen Schlüssel.</translation>
    </message>
    <message>
        <source>Backups made before now still have the earlier code.</source>
        <translation>Bisherige Sicherungen enthalten noch den früheren Code.</translation>
    </message>
    <message>
        <source>Backups made before now have no recovery code of yours.</source>
        <translation>Bisherige Sicherungen enthalten keinen Wiederherstellungscode von Ihnen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RecoveryPage</name>
    <message>
        <source>Forgot your password?</source>
        <translation>Passwort vergessen?</translation>
    </message>
    <message>
        <source>Ask an administrator of this site. Under People, they can give you a new password with &quot;Reset password&quot;. Your sessions and scores are kept.</source>
        <translation>Wenden Sie sich an die Administration dieses Standorts: Sie kann Ihnen unter „Personen“ mit „Passwort zurücksetzen“ ein neues Passwort geben. Ihre Sitzungen und Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Recovery code</source>
        <translation>Wiederherstellungscode</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Passwort festlegen</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Administrators can use their recovery code. It was shown when the site was set up, or when they made one under My account.</source>
        <translation>Die Administration kann ihren Wiederherstellungscode verwenden. Er wurde beim Einrichten des Standorts gezeigt oder als er unter „Mein Konto“ erstellt wurde.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ResetPasswordDialog</name>
    <message>
        <source>New password for %1</source>
        <translation>Neues Passwort für %1</translation>
    </message>
    <message>
        <source>The current password stops working at once. Sessions and scores are kept.</source>
        <translation>Das bisherige Passwort gilt ab sofort nicht mehr. Sitzungen und Wertungen bleiben erhalten.</translation>
    </message>
    <message>
        <source>Set the password</source>
        <translation>Passwort festlegen</translation>
    </message>
    <message>
        <source>The password of %1 was not changed.
%2</source>
        <translation>Das Passwort von %1 wurde nicht geändert.
%2</translation>
    </message>
    <message>
        <source>%1 has a new password.</source>
        <translation>%1 hat ein neues Passwort.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RestoreDialog</name>
    <message>
        <source>Restore a backup</source>
        <translation>Sicherung wiederherstellen</translation>
    </message>
    <message>
        <source>Go back to the backup made %1?</source>
        <translation>Zurück zur Sicherung von %1?</translation>
    </message>
    <message>
        <source>Everything recorded after this backup is removed from view. The current database is kept as a copy; nothing is deleted. People who were erased stay erased. Everybody is logged out.</source>
        <translation>Alles, was nach dieser Sicherung aufgezeichnet wurde, ist nicht mehr zu sehen. Die jetzige Datenbank bleibt als Kopie erhalten; es wird nichts gelöscht. Gelöschte Personen bleiben gelöscht. Alle werden abgemeldet.</translation>
    </message>
    <message>
        <source>Administrator</source>
        <translation>Administration</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>The backup has a different administrator or password</source>
        <translation>In der Sicherung gilt ein anderes Administrationskonto oder Passwort</translation>
    </message>
    <message>
        <source>Keep the current database</source>
        <translation>Jetzige Datenbank behalten</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>The site becomes what it was when this backup was made. The damaged file is kept as a copy; nothing is deleted. People who were erased stay erased. An administrator of the backup has to agree.</source>
        <translation>Der Standort wird wieder so, wie er beim Erstellen dieser Sicherung war. Die beschädigte Datei bleibt als Kopie erhalten; es wird nichts gelöscht. Gelöschte Personen bleiben gelöscht. Jemand, der laut Sicherung zur Administration gehört, muss zustimmen.</translation>
    </message>
    <message>
        <source>The site becomes what it was when this backup was made. People who were erased stay erased. An administrator of the backup has to agree.</source>
        <translation>Der Standort wird wieder so, wie er beim Erstellen dieser Sicherung war. Gelöschte Personen bleiben gelöscht. Jemand, der laut Sicherung zur Administration gehört, muss zustimmen.</translation>
    </message>
    <message>
        <source>The damaged file has a different administrator or password</source>
        <translation>Die beschädigte Datei hat eine andere Administration oder ein anderes Passwort</translation>
    </message>
    <message>
        <source>Administrator in the damaged file</source>
        <translation>Administration in der beschädigten Datei</translation>
    </message>
    <message>
        <source>Password in the damaged file</source>
        <translation>Passwort in der beschädigten Datei</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>The backup has a different administrator or password. Enter those of the backup, too.</source>
        <translation>Die Sicherung hat eine andere Administration oder ein anderes Passwort. Geben Sie auch die der Sicherung ein.</translation>
    </message>
    <message>
        <source>The damaged file has a different administrator or password. Enter those, too.</source>
        <translation>Die beschädigte Datei hat eine andere Administration oder ein anderes Passwort. Geben Sie auch diese ein.</translation>
    </message>
    <message>
        <source>A backup keeps the login names and passwords of the day it was made. If yours have been changed since, enter the earlier ones.</source>
        <translation>Eine Sicherung enthält die Anmeldenamen und Passwörter des Tages, an dem sie erstellt wurde. Wurden Ihre seitdem geändert, geben Sie die früheren ein.</translation>
    </message>
    <message>
        <source>The damaged file still has the login names and passwords of its last day. Where they can be read, one of its administrators has to agree, so that nobody puts an old backup in its place without permission.</source>
        <translation>Die beschädigte Datei hat noch die Anmeldenamen und Passwörter ihres letzten Tages. Wo sie lesbar sind, muss jemand aus ihrer Administration zustimmen, damit niemand ungefragt eine alte Sicherung an ihre Stelle setzt.</translation>
    </message>
    <message>
        <source>Your login name when this backup was made</source>
        <translation>Ihr Anmeldename, als diese Sicherung erstellt wurde</translation>
    </message>
    <message>
        <source>Your password when this backup was made</source>
        <translation>Ihr Passwort, als diese Sicherung erstellt wurde</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RestoreScreen</name>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Looking for backups …</source>
        <translation>Sicherungen werden gesucht …</translation>
    </message>
    <message>
        <source>The site&apos;s file is missing</source>
        <translation>Die Datei des Standorts fehlt</translation>
    </message>
    <message>
        <source>The site&apos;s file is damaged</source>
        <translation>Die Datei des Standorts ist beschädigt</translation>
    </message>
    <message>
        <source>Everything of a site is in one file. If that is damaged or gone, a backup brings the site back as it was when the backup was made.

The list shows the backups in the places that this computer knows, newest first, and whether each can be used. Use &quot;Choose a file&quot; for one on another disk: it is a folder with the files manifest.json and chiron.db in it.

An administrator of the backup has to give the password. The damaged file is never deleted: it is kept beside the new one under another name.</source>
        <translation>Ein Standort liegt ganz in einer Datei. Ist sie beschädigt oder verschwunden, bringt eine Sicherung den Standort so zurück, wie er beim Erstellen der Sicherung war.

Die Liste zeigt die Sicherungen an den Orten, die dieser Computer kennt, die neueste zuerst, und ob jede verwendet werden kann. Mit „Datei wählen“ nehmen Sie eine von einer anderen Festplatte: Eine Sicherung ist ein Ordner mit den Dateien manifest.json und chiron.db.

Jemand, der laut Sicherung zur Administration gehört, muss das Passwort eingeben. Die beschädigte Datei wird nie gelöscht: Sie bleibt unter einem anderen Namen neben der neuen erhalten.</translation>
    </message>
    <message>
        <source>%1 is no longer there. If it was moved, or is on a disk that is not connected, put it back and try again. Otherwise restore a backup.</source>
        <translation>%1 ist nicht mehr da. Wurde die Datei verschoben oder liegt sie auf einer Festplatte, die nicht angeschlossen ist, legen Sie sie zurück und versuchen Sie es erneut. Sonst stellen Sie eine Sicherung wieder her.</translation>
    </message>
    <message>
        <source>%1 cannot be read as a site. Nothing was changed. Restore a backup to continue; the damaged file is kept as a copy.</source>
        <translation>%1 kann nicht als Standort gelesen werden. Es wurde nichts geändert. Stellen Sie eine Sicherung wieder her, um fortzufahren; die beschädigte Datei bleibt als Kopie erhalten.</translation>
    </message>
    <message>
        <source>Details: %1</source>
        <translation>Einzelheiten: %1</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Restore the selected backup …</source>
        <translation>Sicherung wiederherstellen …</translation>
    </message>
    <message>
        <source>Choose a file …</source>
        <translation>Datei wählen …</translation>
    </message>
    <message>
        <source>Try to open it again</source>
        <translation>Noch einmal öffnen</translation>
    </message>
    <message>
        <source>Set up a new site</source>
        <translation>Neuen Standort einrichten</translation>
    </message>
    <message>
        <source>Wait until the restore has finished.</source>
        <translation>Warten Sie, bis das Wiederherstellen beendet ist.</translation>
    </message>
    <message>
        <source>No backup was found</source>
        <translation>Keine Sicherung gefunden</translation>
    </message>
    <message>
        <source>There is none in %1. If you have one elsewhere, on a USB drive or on the network, choose it below.</source>
        <translation>In %1 gibt es keine. Wenn Sie anderswo eine haben, auf einem USB-Laufwerk oder im Netzwerk, wählen Sie sie unten.</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Being checked …</source>
        <translation>Wird geprüft …</translation>
    </message>
    <message>
        <source>Intact</source>
        <translation>Unversehrt</translation>
    </message>
    <message>
        <source>Cannot be used</source>
        <translation>Nicht verwendbar</translation>
    </message>
    <message>
        <source>No backup is selected.</source>
        <translation>Es ist keine Sicherung gewählt.</translation>
    </message>
    <message>
        <source>This backup cannot be used.</source>
        <translation>Diese Sicherung kann nicht verwendet werden.</translation>
    </message>
    <message>
        <source>A file of the backup</source>
        <translation>Eine Datei der Sicherung</translation>
    </message>
    <message>
        <source>Backups (manifest.json chiron.db)</source>
        <translation>Sicherungen (manifest.json chiron.db)</translation>
    </message>
    <message>
        <source>%1 is not a backup. A backup is a folder with the files manifest.json and chiron.db in it.</source>
        <translation>%1 ist keine Sicherung. Eine Sicherung ist ein Ordner mit den Dateien manifest.json und chiron.db.</translation>
    </message>
    <message>
        <source>Restoring the backup and checking it …</source>
        <translation>Die Sicherung wird wiederhergestellt und geprüft …</translation>
    </message>
    <message>
        <source>Nothing was restored: the name or the password is not that of an administrator, or too many wrong ones were given.
Details: %1</source>
        <translation>Es wurde nichts wiederhergestellt: Name oder Passwort gehören nicht zur Administration, oder es wurde zu oft falsch eingegeben.
Einzelheiten: %1</translation>
    </message>
    <message>
        <source>Nothing was restored.</source>
        <translation>Es wurde nichts wiederhergestellt.</translation>
    </message>
    <message>
        <source>Nothing was restored. The damaged file is unchanged.</source>
        <translation>Es wurde nichts wiederhergestellt. Die beschädigte Datei ist unverändert.</translation>
    </message>
    <message>
        <source>The backup was restored. Please log in.</source>
        <translation>Die Sicherung wurde wiederhergestellt. Bitte melden Sie sich an.</translation>
    </message>
    <message>
        <source>The backup was restored. The damaged file is kept as %1. Please log in.</source>
        <translation>Die Sicherung wurde wiederhergestellt. Die beschädigte Datei bleibt als %1 erhalten. Bitte melden Sie sich an.</translation>
    </message>
    <message>
        <source>%1 is still missing.</source>
        <translation>%1 fehlt noch immer.</translation>
    </message>
    <message>
        <source>The key of this site is missing, too: %1. Without it no backup can be checked or restored. Put it back from a copy of the site&apos;s folder, then try again.</source>
        <translation>Auch der Schlüssel dieses Standorts fehlt: %1. Ohne ihn kann keine Sicherung geprüft oder wiederhergestellt werden. Stellen Sie ihn aus einer Kopie des Standortordners wieder her und versuchen Sie es erneut.</translation>
    </message>
    <message>
        <source>This backup cannot be used.
Details: %1</source>
        <translation>Diese Sicherung kann nicht verwendet werden.
Einzelheiten: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::ResultsScreen</name>
    <message>
        <source>My results</source>
        <translation>Meine Ergebnisse</translation>
    </message>
    <message>
        <source>Export my data</source>
        <translation>Meine Daten exportieren</translation>
    </message>
    <message>
        <source>No results yet</source>
        <translation>Noch keine Ergebnisse</translation>
    </message>
    <message>
        <source>Your first session will be here, with its scores and its playback.</source>
        <translation>Hier erscheint Ihre erste Sitzung, mit Wertungen und Wiedergabe.</translation>
    </message>
    <message>
        <source>Choose an exercise</source>
        <translation>Übung wählen</translation>
    </message>
    <message>
        <source>Attempts</source>
        <translation>Versuche</translation>
    </message>
    <message>
        <source>Open the attempt</source>
        <translation>Versuch öffnen</translation>
    </message>
    <message>
        <source>Your data</source>
        <translation>Ihre Daten</translation>
    </message>
    <message>
        <source>A copy of everything that is held about you: your account, sessions, scores, comments and samples. It is yours to keep; nothing is removed here.</source>
        <translation>Eine Kopie von allem, was über Sie gespeichert ist: Konto, Sitzungen, Wertungen, Kommentare und Messpunkte. Sie gehört Ihnen; hier wird nichts entfernt.</translation>
    </message>
    <message>
        <source>Export my data …</source>
        <translation>Meine Daten exportieren …</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Choose a folder for your data</source>
        <translation>Ordner für Ihre Daten wählen</translation>
    </message>
    <message>
        <source>Writing your data …</source>
        <translation>Ihre Daten werden geschrieben …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Your data was written to %1.</source>
        <translation>Ihre Daten wurden in %1 geschrieben.</translation>
    </message>
    <message>
        <source>Your data could not be written completely.</source>
        <translation>Ihre Daten konnten nicht vollständig geschrieben werden.</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Ergebnisse von %1</translation>
    </message>
    <message>
        <source>The results could not be read</source>
        <translation>Die Ergebnisse konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>Reading the results …</source>
        <translation>Die Ergebnisse werden gelesen …</translation>
    </message>
    <message>
        <source>Nothing was recorded for this person.</source>
        <translation>Für diese Person wurde nichts aufgezeichnet.</translation>
    </message>
    <message>
        <source>All sessions of this person</source>
        <translation>Alle Sitzungen dieser Person</translation>
    </message>
    <message>
        <source>The results of one person.

Choose an exercise, a level and a metric. The curve has a point for each completed attempt; attempts with felt force and attempts with force shown only are never compared. Press Enter or double-click to open an attempt.</source>
        <translation>Die Ergebnisse einer Person.

Wählen Sie eine Übung, eine Stufe und eine Messgröße. Die Kurve hat einen Punkt für jeden abgeschlossenen Versuch; Versuche mit gefühlter und mit nur gezeigter Kraft werden nie verglichen. Mit Enter oder einem Doppelklick öffnen Sie einen Versuch.</translation>
    </message>
    <message>
        <source>All your sessions, and your progress.

Choose an exercise, a level and a metric. The curve has a point for each completed attempt. Attempts with felt force and attempts with force shown only have separate lines and are never compared. The horizontal line is the pass mark; the band shows what others reached.

Press Enter or double-click to open an attempt. &quot;Export my data&quot; writes everything that is stored about you to a folder of your choice.</source>
        <translation>Alle Ihre Sitzungen und wie Sie vorankommen.

Wählen Sie eine Übung, eine Stufe und eine Messgröße. Die Kurve hat einen Punkt für jeden abgeschlossenen Versuch; gefühlte und nur gezeigte Kraft haben eigene Linien und werden nie verglichen. Die waagerechte Linie ist die Bestehensgrenze; der Bereich zeigt, was andere erreicht haben.

Enter oder Doppelklick öffnet einen Versuch. „Meine Daten exportieren“ schreibt alles, was über Sie gespeichert ist, in einen Ordner Ihrer Wahl.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RocBox</name>
    <message>
        <source>Confidence and accuracy (ROC)</source>
        <translation>Sicherheit und Richtigkeit (ROC)</translation>
    </message>
    <message>
        <source>Reading the recordings …</source>
        <translation>Aufzeichnungen werden gelesen …</translation>
    </message>
    <message>
        <source>The recordings could not be read</source>
        <translation>Die Aufzeichnungen konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>Not enough answers yet</source>
        <translation>Noch nicht genug Antworten</translation>
    </message>
    <message>
        <source>A curve needs at least %1 places with a lump and as many without. So far: %2 with, %3 without.</source>
        <translation>Eine Kurve braucht mindestens %1 Stellen mit Knoten und ebenso viele ohne. Bisher: %2 mit, %3 ohne.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RoleChoice</name>
    <message>
        <source>Trains and sees their own results</source>
        <translation>Trainiert und sieht die eigenen Ergebnisse</translation>
    </message>
    <message>
        <source>Roles (at least one)</source>
        <translation>Rollen (mindestens eine)</translation>
    </message>
    <message>
        <source>Designs studies and runs them with participants; sees sessions by code, without names</source>
        <translation>Entwirft Studien und führt sie mit Teilnehmenden durch; sieht Sitzungen mit Code, ohne Namen</translation>
    </message>
    <message>
        <source>Manages people, storage and the station; may also design and run studies</source>
        <translation>Verwaltet Personen, Datensicherung und Arbeitsplatz; darf auch Studien entwerfen und durchführen</translation>
    </message>
    <message>
        <source>Sees everybody&apos;s sessions, and can comment on them and void them</source>
        <translation>Sieht die Sitzungen aller, kommentiert sie und erklärt sie für ungültig</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RolesDialog</name>
    <message>
        <source>Roles of %1</source>
        <translation>Rollen von %1</translation>
    </message>
    <message>
        <source>The change takes effect at once, even for people who are logged in.</source>
        <translation>Die Änderung gilt sofort, auch für Personen, die gerade angemeldet sind.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>The roles of %1 have been changed.</source>
        <translation>Die Rollen von %1 sind geändert.</translation>
    </message>
    <message>
        <source>%1 remains an administrator: a site needs at least one who can log in. Make another person an administrator first.</source>
        <translation>%1 behält diese Rolle: Ein Standort braucht mindestens eine Person in der Administration, die sich anmelden kann. Geben Sie die Rolle zuerst jemand anderem.</translation>
    </message>
    <message>
        <source>The roles of %1 were not changed.
%2</source>
        <translation>Die Rollen von %1 wurden nicht geändert.
%2</translation>
    </message>
    <message>
        <source>Your roles have been changed. The list on the left shows the screens that go with them.</source>
        <translation>Ihre Rollen sind geändert. Die Liste links zeigt die zugehörigen Ansichten.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RosterDialog</name>
    <message>
        <source>Import people</source>
        <translation>Personen importieren</translation>
    </message>
    <message>
        <source>From %1. Nothing is changed before you press Import.</source>
        <translation>Aus %1. Es ändert sich nichts, bevor Sie „Importieren“ drücken.</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>Importieren</translation>
    </message>
    <message>
        <source>Reading the list …</source>
        <translation>Liste wird gelesen …</translation>
    </message>
    <message>
        <source>The list could not be compared with the people on this site.</source>
        <translation>Die Liste konnte nicht mit den Personen dieses Standorts verglichen werden.</translation>
    </message>
    <message numerus="yes">
        <source>Import %n people</source>
        <translation>
            <numerusform>%n Person importieren</numerusform>
            <numerusform>%n Personen importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing can be imported yet: correct these lines in the file, then choose it again.</source>
        <translation>Es kann noch nichts importiert werden: Berichtigen Sie diese Zeilen in der Datei und wählen Sie die Datei erneut.</translation>
    </message>
    <message numerus="yes">
        <source>and %n more</source>
        <translation>
            <numerusform>und %n weitere</numerusform>
            <numerusform>und %n weitere</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were added.</source>
        <translation>
            <numerusform>%n Person wurde hinzugefügt.</numerusform>
            <numerusform>%n Personen wurden hinzugefügt.</numerusform>
        </translation>
    </message>
    <message>
        <source>People who have an account already</source>
        <translation>Personen, die schon ein Konto haben</translation>
    </message>
    <message>
        <source>Leave them as they are</source>
        <translation>Unverändert lassen</translation>
    </message>
    <message>
        <source>Update full name and roles</source>
        <translation>Namen und Rollen aktualisieren</translation>
    </message>
    <message>
        <source>Nothing can be imported from this file.</source>
        <translation>Aus dieser Datei kann nichts importiert werden.</translation>
    </message>
    <message>
        <source>Nothing was changed: the site needs at least one administrator who can log in, and the list would leave none.</source>
        <translation>Nichts wurde geändert: Der Standort braucht mindestens eine Person mit der Rolle Administration, die sich anmelden kann, und die Liste ließe keine übrig.</translation>
    </message>
    <message>
        <source>Nothing was changed.
%1</source>
        <translation>Nichts wurde geändert.
%1</translation>
    </message>
    <message numerus="yes">
        <source>Importing %n people …</source>
        <translation>
            <numerusform>%n Person wird importiert …</numerusform>
            <numerusform>%n Personen werden importiert …</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n people were updated.</source>
        <translation>
            <numerusform>%n Person wurde aktualisiert.</numerusform>
            <numerusform>%n Personen wurden aktualisiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>The slips have been neither printed nor saved. If you close this window again, the passwords are gone; you can then only set new ones, one by one.</source>
        <translation>Die Zettel wurden weder gedruckt noch gespeichert. Wenn Sie dieses Fenster noch einmal schließen, sind die Passwörter verloren; Sie können dann nur einzeln neue vergeben.</translation>
    </message>
    <message>
        <source>The list has words that are not roles here. Choose what each of them stands for, or correct the file.</source>
        <translation>Die Liste enthält Wörter, die hier keine Rollen sind. Wählen Sie, wofür jedes steht, oder berichtigen Sie die Datei.</translation>
    </message>
    <message>
        <source>No role is given</source>
        <translation>Keine Rolle ist angegeben</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>Role that %1 stands for</source>
        <translation>Rolle, für die %1 steht</translation>
    </message>
    <message>
        <source>Choose a role …</source>
        <translation>Rolle wählen …</translation>
    </message>
    <message>
        <source>Nothing can be imported yet: choose above what the words stand for, or correct these lines in the file and choose it again.</source>
        <translation>Es kann noch nichts importiert werden: Wählen Sie oben, wofür die Wörter stehen, oder berichtigen Sie diese Zeilen in der Datei und wählen Sie sie erneut.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RulesPage</name>
    <message>
        <source>Trials and breaks</source>
        <translation>Durchgänge und Pausen</translation>
    </message>
    <message>
        <source>Rules of a trial</source>
        <translation>Regeln eines Durchgangs</translation>
    </message>
    <message>
        <source>Time to explore</source>
        <translation>Zeit zum Erkunden</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>unbegrenzt</translation>
    </message>
    <message>
        <source>A trial without a mark ends after this time; 0: never.</source>
        <translation>Ein Durchgang ohne Markierung endet nach dieser Zeit; 0: nie.</translation>
    </message>
    <message>
        <source>The objects go away after this time; 0: never.</source>
        <translation>Nach dieser Zeit verschwinden die Objekte; 0: nie.</translation>
    </message>
    <message>
        <source>Time to answer</source>
        <translation>Zeit zum Antworten</translation>
    </message>
    <message>
        <source>Between trials</source>
        <translation>Zwischen Durchgängen</translation>
    </message>
    <message>
        <source>Time until the next objects come.</source>
        <translation>Zeit, bis die nächsten Objekte kommen.</translation>
    </message>
    <message>
        <source>Practice trials</source>
        <translation>Übungsdurchgänge</translation>
    </message>
    <message>
        <source>Participants rest before they go on; 0: never.</source>
        <translation>Teilnehmende ruhen sich aus, bevor es weitergeht; 0: nie.</translation>
    </message>
    <message>
        <source>Shortest break</source>
        <translation>Kürzeste Pause</translation>
    </message>
    <message>
        <source>Participants go on after this time at the earliest.</source>
        <translation>Frühestens nach dieser Zeit geht es weiter.</translation>
    </message>
    <message>
        <source>Feedback</source>
        <translation>Rückmeldung</translation>
    </message>
    <message>
        <source>Participants are told after each trial how well they did. This feedback changes what is measured.</source>
        <translation>Teilnehmende erfahren nach jedem Durchgang, wie gut sie waren. Das verändert, was gemessen wird.</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Maskierungsgeräusch</translation>
    </message>
    <message>
        <source>Show the objects</source>
        <translation>Objekte zeigen</translation>
    </message>
    <message>
        <source>Objects are drawn, all alike, so that only touch tells them apart.</source>
        <translation>Objekte werden gezeichnet, alle gleich, sodass nur der Tastsinn sie unterscheidet.</translation>
    </message>
    <message>
        <source>Every object must be touched</source>
        <translation>Jedes Objekt berühren</translation>
    </message>
    <message>
        <source>An answer is accepted only once each object has been touched.</source>
        <translation>Eine Antwort zählt erst, wenn jedes Objekt berührt wurde.</translation>
    </message>
    <message>
        <source>Instructions</source>
        <translation>Anleitung</translation>
    </message>
    <message>
        <source>Your own sentences</source>
        <translation>Ihre eigenen Sätze</translation>
    </message>
    <message>
        <source>What to do, and how to hold the instrument. Leave out time, trials, feedback and breaks: those sentences are made from the settings and always fit them.</source>
        <translation>Was zu tun ist und wie das Instrument zu halten ist. Lassen Sie Zeit, Durchgänge, Rückmeldung und Pausen weg: Diese Sätze entstehen aus den Einstellungen und passen immer zu ihnen.</translation>
    </message>
    <message>
        <source>These instructions were written before the program made sentences from the settings. Remove what those sentences now say.</source>
        <translation>Diese Anleitung entstand, bevor das Programm Sätze aus den Einstellungen bildete. Entfernen Sie, was diese Sätze jetzt sagen.</translation>
    </message>
    <message>
        <source>What participants read</source>
        <translation>Was Teilnehmende lesen</translation>
    </message>
    <message>
        <source>Order and blinding</source>
        <translation>Reihenfolge und Verblindung</translation>
    </message>
    <message>
        <source>Blinding</source>
        <translation>Verblindung</translation>
    </message>
    <message>
        <source>Order of conditions</source>
        <translation>Reihenfolge der Bedingungen</translation>
    </message>
    <message>
        <source>Blind participants</source>
        <translation>Teilnehmende verblinden</translation>
    </message>
    <message>
        <source>Participants see no values and no names of conditions.</source>
        <translation>Teilnehmende sehen weder Werte noch Namen von Bedingungen.</translation>
    </message>
    <message>
        <source>Blind experimenters</source>
        <translation>Versuchsleitung verblinden</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>Fidelity of a trial</source>
        <translation>Wiedergabetreue eines Durchgangs</translation>
    </message>
    <message>
        <source>A trial outside these limits is not scored and is presented again.</source>
        <translation>Ein Durchgang außerhalb dieser Grenzen zählt nicht und wird wiederholt.</translation>
    </message>
    <message>
        <source>Limits of fidelity</source>
        <translation>Grenzen der Wiedergabetreue</translation>
    </message>
    <message>
        <source>Force error</source>
        <translation>Kraftfehler</translation>
    </message>
    <message>
        <source>Error of the felt value</source>
        <translation>Fehler des gefühlten Werts</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Share of the force&apos;s updates that may come too late.</source>
        <translation>Anteil der Kraftaktualisierungen, die zu spät kommen dürfen.</translation>
    </message>
    <message>
        <source>Force at its limit</source>
        <translation>Kraft an der Grenze</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>How hard a participant may press.</source>
        <translation>Wie fest jemand drücken darf.</translation>
    </message>
    <message>
        <source>Mean speed</source>
        <translation>Mittlere Geschwindigkeit</translation>
    </message>
    <message>
        <source>How fast a participant may move, on average.</source>
        <translation>Wie schnell sich jemand im Mittel bewegen darf.</translation>
    </message>
    <message>
        <source>Repeats of one trial</source>
        <translation>Wiederholungen eines Durchgangs</translation>
    </message>
    <message>
        <source>Smallest force on an object</source>
        <translation>Kleinste Kraft auf ein Objekt</translation>
    </message>
    <message>
        <source>any touch</source>
        <translation>jede Berührung</translation>
    </message>
    <message>
        <source>A steady noise hides the sounds of the device. Participants are told of it where it is heard.</source>
        <translation>Ein gleichmäßiges Rauschen verdeckt die Geräusche des Geräts. Die Teilnehmenden erfahren davon, wo es zu hören ist.</translation>
    </message>
    <message>
        <source>“%1” was not accepted: enter a whole number from 0 to %2.</source>
        <translation>„%1“ wurde nicht übernommen: Geben Sie eine ganze Zahl von 0 bis %2 ein.</translation>
    </message>
    <message>
        <source>Trials between breaks</source>
        <translation>Durchgänge zwischen Pausen</translation>
    </message>
    <message>
        <source>A whole number from which all orders and random choices are drawn: the same number gives the same study again.</source>
        <translation>Eine ganze Zahl, aus der alle Reihenfolgen und Zufallsentscheidungen hervorgehen: Dieselbe Zahl ergibt dieselbe Studie noch einmal.</translation>
    </message>
    <message>
        <source>How far the rendered value may be from the requested one.</source>
        <translation>Wie weit der dargestellte Wert vom verlangten abweichen darf.</translation>
    </message>
    <message>
        <source>Share of the contact time during which the device may be at its force limit.</source>
        <translation>Anteil der Berührungszeit, in dem das Gerät an seiner Kraftgrenze sein darf.</translation>
    </message>
    <message>
        <source>After this many repeats the run pauses and asks the experimenter.</source>
        <translation>Nach so vielen Wiederholungen hält der Lauf an und fragt die Versuchsleitung.</translation>
    </message>
    <message>
        <source>Time to answer once the objects are gone. Without an answer the trial is repeated. 0: no limit.</source>
        <translation>Zeit zum Antworten, sobald die Objekte verschwunden sind. Ohne Antwort wird der Durchgang wiederholt. 0: unbegrenzt.</translation>
    </message>
    <message>
        <source>Trials before each condition, at the largest difference and with feedback. They are never scored.</source>
        <translation>Durchgänge vor jeder Bedingung, mit dem größten Unterschied und mit Rückmeldung. Sie werden nie gewertet.</translation>
    </message>
    <message>
        <source>An object counts as touched only once it was pressed, pulled or lifted with this force, so that nobody answers after barely touching it. 0: any touch counts.</source>
        <translation>Ein Objekt gilt erst als berührt, wenn es mit dieser Kraft gedrückt, gezogen oder gehoben wurde, damit niemand nach einer flüchtigen Berührung antwortet. 0: jede Berührung zählt.</translation>
    </message>
    <message>
        <source>In which order each participant does the conditions. A Williams design also balances which condition follows which.</source>
        <translation>In welcher Reihenfolge jede Person die Bedingungen durchläuft. Ein Williams-Plan gleicht auch aus, welche Bedingung auf welche folgt.</translation>
    </message>
    <message>
        <source>Until the study is unblinded, experimenters see sealed codes instead of the conditions.</source>
        <translation>Bis zur Entblindung der Studie sieht die Versuchsleitung versiegelte Codes statt der Bedingungen.</translation>
    </message>
    <message>
        <source>How far the measured force may be from the commanded one (root mean square).</source>
        <translation>Wie weit die gemessene Kraft vom Sollwert abweichen darf (quadratisches Mittel).</translation>
    </message>
    <message>
        <source>%1: as many trials as the answers need</source>
        <translation>%1: so viele Durchgänge, wie die Antworten verlangen</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n trial(s) that count</source>
        <translation>
            <numerusform>%1: %n Durchgang, der zählt</numerusform>
            <numerusform>%1: %n Durchgänge, die zählen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1: at most %n trial(s) that count</source>
        <translation>
            <numerusform>%1: höchstens %n Durchgang, der zählt</numerusform>
            <numerusform>%1: höchstens %n Durchgänge, die zählen</numerusform>
        </translation>
    </message>
    <message>
        <source>Number of trials</source>
        <translation>Anzahl der Durchgänge</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Ändern</translation>
    </message>
    <message>
        <source>Change: %1</source>
        <translation>Ändern: %1</translation>
    </message>
    <message>
        <source>The procedure of each condition sets this number, on the page Conditions. Practice and repeated trials are not included.</source>
        <translation>Das Verfahren jeder Bedingung legt diese Zahl fest, auf der Seite „Bedingungen“. Übungsdurchgänge und wiederholte Durchgänge sind nicht mitgezählt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::RunScreen</name>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Die Studien konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>No study can be run yet</source>
        <translation>Noch lässt sich keine Studie durchführen</translation>
    </message>
    <message>
        <source>A study can be run as soon as its design is frozen and participants are enrolled.</source>
        <translation>Eine Studie lässt sich durchführen, sobald ihr Entwurf eingefroren ist und Personen aufgenommen sind.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Studien öffnen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Participant, by code</source>
        <translation>Person, nach Code</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>Nobody is enrolled yet.</source>
        <translation>Noch ist niemand aufgenommen.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>answered</source>
        <translation>beantwortet</translation>
    </message>
    <message>
        <source>not answered yet</source>
        <translation>noch nicht beantwortet</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Beantworten</translation>
    </message>
    <message>
        <source>Answer %1</source>
        <translation>%1 beantworten</translation>
    </message>
    <message>
        <source>Begin %1</source>
        <translation>%1 beginnen</translation>
    </message>
    <message>
        <source>Resume here</source>
        <translation>Hier fortsetzen</translation>
    </message>
    <message>
        <source>Resume %1 where it was interrupted</source>
        <translation>%1 fortsetzen, wo unterbrochen wurde</translation>
    </message>
    <message>
        <source>Other interrupted runs</source>
        <translation>Weitere unterbrochene Läufe</translation>
    </message>
    <message>
        <source>Takes a participant through a study.

Choose the study and the participant&apos;s code. The conditions appear in the participant&apos;s own order; if the experimenter is blinded, they appear under sealed codes. The questionnaires before and after the runs are answered here, too, and those about a condition once it is done.

An interrupted run resumes at the trial where it stopped.</source>
        <translation>Führt eine Person durch eine Studie.

Wählen Sie die Studie und den Code der Person. Die Bedingungen erscheinen in der Reihenfolge dieser Person; ist die Versuchsleitung verblindet, stehen sie unter versiegelten Codes. Auch die Fragebögen davor und danach werden hier beantwortet, und die zu einer Bedingung, sobald sie abgeschlossen ist.

Ein unterbrochener Lauf geht bei dem Durchgang weiter, bei dem er aufhörte.</translation>
    </message>
    <message>
        <source>This study plays a masking sound, and this machine has no sound output: participants would hear the device. Connect headphones or loudspeakers and open this page again. You can also go on: each trial is then recorded as not masked.</source>
        <translation>Diese Studie spielt ein Maskierungsgeräusch, und dieser Rechner hat keine Tonausgabe: Die Teilnehmenden würden das Gerät hören. Schließen Sie Kopfhörer oder Lautsprecher an und öffnen Sie diese Seite erneut. Sie können auch weitermachen: Jeder Durchgang wird dann als nicht maskiert festgehalten.</translation>
    </message>
    <message>
        <source>%1, about condition %2</source>
        <translation>%1, zu Bedingung %2</translation>
    </message>
    <message>
        <source>Consent is missing. Nothing can start before it is recorded.</source>
        <translation>Die Einwilligung fehlt. Bevor sie festgehalten ist, kann nichts begonnen werden.</translation>
    </message>
    <message>
        <source>Record the consent …</source>
        <translation>Einwilligung festhalten …</translation>
    </message>
    <message>
        <source>Enrol the next participant …</source>
        <translation>Nächste Person aufnehmen …</translation>
    </message>
    <message>
        <source>Enrol somebody …</source>
        <translation>Jemanden aufnehmen …</translation>
    </message>
    <message>
        <source>Go on with %1</source>
        <translation>Weiter mit %1</translation>
    </message>
    <message>
        <source>%1 has nothing left to do.</source>
        <translation>Für %1 ist nichts mehr zu tun.</translation>
    </message>
    <message>
        <source>%1 comes next and is selected.</source>
        <translation>%1 ist als Nächstes an der Reihe und ausgewählt.</translation>
    </message>
    <message>
        <source>%1 has nothing left to do. %2 comes next.</source>
        <translation>Für %1 ist nichts mehr zu tun. Als Nächstes ist %2 an der Reihe.</translation>
    </message>
    <message>
        <source>Nobody who is enrolled has anything left to do. Enrol the next participant.</source>
        <translation>Für alle Aufgenommenen ist nichts mehr zu tun. Nehmen Sie die nächste Person auf.</translation>
    </message>
    <message>
        <source>Nobody who is enrolled has anything left to do.</source>
        <translation>Für alle Aufgenommenen ist nichts mehr zu tun.</translation>
    </message>
    <message>
        <source>Sequence in each condition: %1.</source>
        <translation>Ablauf in jeder Bedingung: %1.</translation>
    </message>
    <message>
        <source>If %1 does not come back, go on with somebody else. The trials that were done are kept, and count if they suffice for a value. The run can be resumed later. To take %1 out of the study, withdraw them on the study&apos;s page of participants.</source>
        <translation>Wenn %1 nicht zurückkommt, machen Sie mit jemand anderem weiter. Die Durchgänge bis dahin bleiben erhalten und zählen, wenn sie für einen Wert ausreichen. Der Lauf kann später fortgesetzt werden. Um %1 aus der Studie zu nehmen, ziehen Sie die Teilnahme auf der Seite „Teilnehmende“ der Studie zurück.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::Scrubber</name>
    <message>
        <source>Position in the recording</source>
        <translation>Position in der Aufzeichnung</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionFilterBar</name>
    <message>
        <source>Search in the list</source>
        <translation>In der Liste suchen</translation>
    </message>
    <message>
        <source>Search: person, exercise, number</source>
        <translation>Person, Übung, Nummer</translation>
    </message>
    <message>
        <source>Include archived</source>
        <translation>Auch archivierte</translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Filter löschen</translation>
    </message>
    <message>
        <source>Everybody</source>
        <translation>Alle Personen</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>All exercises</source>
        <translation>Alle Übungen</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>All levels</source>
        <translation>Alle Stufen</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation>Stufe %1</translation>
    </message>
    <message>
        <source>All states</source>
        <translation>Alle Zustände</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>All results</source>
        <translation>Alle Ergebnisse</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Any time</source>
        <translation>Alle Zeiten</translation>
    </message>
    <message>
        <source>When it was recorded</source>
        <translation>Zeitpunkt der Aufzeichnung</translation>
    </message>
    <message>
        <source>Today</source>
        <translation>Heute</translation>
    </message>
    <message>
        <source>Last 7 days</source>
        <translation>Letzte 7 Tage</translation>
    </message>
    <message>
        <source>Last 30 days</source>
        <translation>Letzte 30 Tage</translation>
    </message>
    <message>
        <source>Chosen days</source>
        <translation>Bestimmte Tage</translation>
    </message>
    <message>
        <source>From this day</source>
        <translation>Ab diesem Tag</translation>
    </message>
    <message>
        <source>To this day</source>
        <translation>Bis zu diesem Tag</translation>
    </message>
    <message>
        <source>Has comments</source>
        <translation>Mit Kommentaren</translation>
    </message>
    <message>
        <source>Reviewed or not</source>
        <translation>Begutachtet oder nicht</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Begutachtung</translation>
    </message>
    <message>
        <source>To review</source>
        <translation>Zu begutachten</translation>
    </message>
    <message>
        <source>Reviewed</source>
        <translation>Begutachtet</translation>
    </message>
    <message>
        <source>Force felt or only shown</source>
        <translation>Kraft gefühlt oder nur gezeigt</translation>
    </message>
    <message>
        <source>Force felt by the hand</source>
        <translation>Kraft mit der Hand gefühlt</translation>
    </message>
    <message>
        <source>Force only shown, not felt</source>
        <translation>Kraft nur gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Whether the device let the hand feel the force, or the screen only showed it, as with mouse and keyboard</source>
        <translation>Ob das Gerät die Hand die Kraft fühlen ließ oder der Bildschirm sie nur zeigte, wie mit Maus und Tastatur</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionLines</name>
    <message>
        <source>%1. %2. %3. Opens the debrief.</source>
        <translation>%1. %2. %3. Öffnet die Auswertung.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionTableModel</name>
    <message>
        <source>%1, archived</source>
        <translation>%1, archiviert</translation>
    </message>
    <message>
        <source>Started</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Exercise</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>sealed</source>
        <translation>versiegelt</translation>
    </message>
    <message>
        <source>The length of a session in a blinded study is shown once the study is unblinded.</source>
        <translation>Die Dauer einer Sitzung einer verblindeten Studie wird angezeigt, sobald die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>Length: %1.</source>
        <translation>Dauer: %1.</translation>
    </message>
    <message>
        <source>Pass marks met: %1.</source>
        <translation>Bestehensgrenzen erreicht: %1.</translation>
    </message>
    <message>
        <source>Session %1. %2</source>
        <translation>Sitzung %1. %2</translation>
    </message>
    <message>
        <source>Operator</source>
        <translation>Programmierte Hand</translation>
    </message>
    <message>
        <source>Score</source>
        <translation>Wertung</translation>
    </message>
    <message>
        <source>Comments</source>
        <translation>Kommentare</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>Begutachtung</translation>
    </message>
    <message>
        <source>Attempt</source>
        <translation>Versuch</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SessionsScreen</name>
    <message>
        <source>Search in the list</source>
        <translation>In der Liste suchen</translation>
    </message>
    <message>
        <source>Save the list …</source>
        <translation>Liste speichern …</translation>
    </message>
    <message>
        <source>Bring back from the archive</source>
        <translation>Aus dem Archiv holen</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivieren</translation>
    </message>
    <message>
        <source>Session %1 is still running. It can be opened as soon as it has ended.</source>
        <translation>Sitzung %1 läuft noch. Sie lässt sich öffnen, sobald sie beendet ist.</translation>
    </message>
    <message>
        <source>Session %1 was not voided.</source>
        <translation>Sitzung %1 wurde nicht für ungültig erklärt.</translation>
    </message>
    <message>
        <source>Session %1 is voided. Its recording is kept; it no longer counts.</source>
        <translation>Sitzung %1 ist für ungültig erklärt. Ihre Aufzeichnung bleibt erhalten; sie zählt nicht mehr.</translation>
    </message>
    <message>
        <source>Session %1 was not changed.</source>
        <translation>Sitzung %1 wurde nicht geändert.</translation>
    </message>
    <message>
        <source>Session %1 is archived: nothing was deleted.</source>
        <translation>Sitzung %1 ist archiviert: Es wurde nichts gelöscht.</translation>
    </message>
    <message>
        <source>Session %1 is back in the list.</source>
        <translation>Sitzung %1 ist wieder in der Liste.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>The session could not be read again.</source>
        <translation>Die Sitzung konnte nicht erneut gelesen werden.</translation>
    </message>
    <message>
        <source>Save the list</source>
        <translation>Liste speichern</translation>
    </message>
    <message>
        <source>Comma-separated values (*.csv)</source>
        <translation>Kommagetrennte Werte (*.csv)</translation>
    </message>
    <message>
        <source>The list is saved in %1.</source>
        <translation>Die Liste ist in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The list was not saved.</source>
        <translation>Die Liste wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>Sessions</source>
        <translation>Sitzungen</translation>
    </message>
    <message>
        <source>Open the debrief</source>
        <translation>Auswertung öffnen</translation>
    </message>
    <message>
        <source>Play back</source>
        <translation>Wiedergeben</translation>
    </message>
    <message>
        <source>Void …</source>
        <translation>Für ungültig erklären …</translation>
    </message>
    <message>
        <source>Loading the sessions …</source>
        <translation>Sitzungen werden geladen …</translation>
    </message>
    <message>
        <source>The sessions could not be loaded.</source>
        <translation>Die Sitzungen konnten nicht geladen werden.</translation>
    </message>
    <message>
        <source>Loading the older sessions …</source>
        <translation>Ältere Sitzungen werden geladen …</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s)</source>
        <translation>
            <numerusform>%n Sitzung</numerusform>
            <numerusform>%n Sitzungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 sessions</source>
        <translation>%1 von %2 Sitzungen</translation>
    </message>
    <message>
        <source>No session has been recorded yet</source>
        <translation>Noch keine Sitzung aufgezeichnet</translation>
    </message>
    <message>
        <source>As soon as somebody trains, the session is listed here.</source>
        <translation>Sobald jemand trainiert, erscheint die Sitzung hier.</translation>
    </message>
    <message>
        <source>No session matches these filters</source>
        <translation>Keine Sitzung passt zu diesen Filtern</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) in all.</source>
        <translation>
            <numerusform>%n Sitzung insgesamt.</numerusform>
            <numerusform>%n Sitzungen insgesamt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Clear the filters</source>
        <translation>Filter löschen</translation>
    </message>
    <message>
        <source>A session of a blinded study can be opened once the study is unblinded.</source>
        <translation>Eine Sitzung einer verblindeten Studie lässt sich öffnen, sobald die Studie entblindet ist.</translation>
    </message>
    <message>
        <source>Session %1 is still void.</source>
        <translation>Sitzung %1 ist weiterhin ungültig.</translation>
    </message>
    <message>
        <source>Session %1 counts again. Its history still shows that it was void.</source>
        <translation>Sitzung %1 zählt wieder. Dass sie ungültig war, bleibt vermerkt.</translation>
    </message>
    <message>
        <source>Results of this person</source>
        <translation>Ergebnisse dieser Person</translation>
    </message>
    <message>
        <source>Count it again …</source>
        <translation>Wieder zählen …</translation>
    </message>
    <message numerus="yes">
        <source>%n session(s) to review</source>
        <translation>
            <numerusform>%n Sitzung zu begutachten</numerusform>
            <numerusform>%n Sitzungen zu begutachten</numerusform>
        </translation>
    </message>
    <message>
        <source>The list is empty, so there is nothing to save.</source>
        <translation>Die Liste ist leer, es gibt also nichts zu speichern.</translation>
    </message>
    <message>
        <source>All sessions recorded at this site, newest first.

Type in the search field or choose from the lists beside it to narrow the list. What you choose stays for the rest of the day. A link from another screen, such as &quot;List of sessions to review&quot;, shows its own list and leaves your choice as it was. Click a column header to sort by it.

Press Enter or double-click to open the debrief of the selected session, Ctrl+P to play it back. &quot;Results of this person&quot; shows how this person develops at that session&apos;s exercise and level. &quot;Void&quot; asks for a reason and takes a session out of every count; the recording is kept, and &quot;Count it again&quot; takes the decision back. &quot;Archive&quot; takes it out of the usual lists and can be undone.</source>
        <translation>Alle Sitzungen dieses Standorts, die neuesten zuerst.

Tippen Sie in das Suchfeld oder wählen Sie aus den Listen daneben, um die Liste einzugrenzen. Ihre Auswahl bleibt für den Rest des Tages. Ein Verweis von einem anderen Bildschirm, etwa „Liste der zu begutachtenden Sitzungen“, zeigt seine eigene Liste und lässt Ihre Auswahl, wie sie war. Ein Klick auf einen Spaltenkopf sortiert danach.

Enter oder ein Doppelklick öffnet die Auswertung der gewählten Sitzung, Strg+P gibt sie wieder. „Ergebnisse dieser Person“ zeigt, wie sich die Person in dieser Übung und Stufe entwickelt. „Für ungültig erklären“ fragt nach einem Grund und nimmt eine Sitzung aus jeder Zählung; die Aufzeichnung bleibt erhalten, und „Wieder zählen“ nimmt die Entscheidung zurück. „Archivieren“ nimmt sie aus den üblichen Listen und kann rückgängig gemacht werden.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SettingsScreen</name>
    <message>
        <source>Settings</source>
        <translation>Einstellungen</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>High contrast</source>
        <translation>Hoher Kontrast</translation>
    </message>
    <message>
        <source>Colours</source>
        <translation>Farben</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Size of text and controls</source>
        <translation>Größe von Text und Bedienelementen</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>Play sounds while training</source>
        <translation>Töne beim Training</translation>
    </message>
    <message>
        <source>A click when contact begins</source>
        <translation>Ein Klick, wenn die Berührung beginnt</translation>
    </message>
    <message>
        <source>A tone that rises with force</source>
        <translation>Ein Ton, der mit der Kraft steigt</translation>
    </message>
    <message>
        <source>A warning over the limit</source>
        <translation>Eine Warnung über der Grenze</translation>
    </message>
    <message>
        <source>Everything that can be heard is also shown. The force behind it is recorded even when the sound is off.</source>
        <translation>Alles Hörbare wird auch angezeigt. Die Kraft dahinter wird auch bei ausgeschaltetem Ton aufgezeichnet.</translation>
    </message>
    <message>
        <source>How the program looks and sounds on this station.

Every choice takes effect at once and is remembered on this computer. Nothing here changes what is recorded or how it is scored.

Administrators also give the site its name here.</source>
        <translation>So sieht das Programm an diesem Arbeitsplatz aus, und so klingt es.

Jede Auswahl gilt sofort und bleibt auf diesem Computer gespeichert. Nichts davon ändert, was aufgezeichnet oder wie es gewertet wird.

Die Administration gibt hier auch dem Standort seinen Namen.</translation>
    </message>
    <message>
        <source>A brighter tone the more the force leans</source>
        <translation>Hellerer Ton bei schräger Kraft</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SideBar</name>
    <message>
        <source>Find a command</source>
        <translation>Befehl suchen</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Lock</source>
        <translation>Sperren</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message numerus="yes">
        <source>%1: %n session(s) with new comments</source>
        <translation>
            <numerusform>%1: %n Sitzung mit neuen Kommentaren</numerusform>
            <numerusform>%1: %n Sitzungen mit neuen Kommentaren</numerusform>
        </translation>
    </message>
    <message>
        <source>My account</source>
        <translation>Mein Konto</translation>
    </message>
    <message>
        <source>Log out</source>
        <translation>Abmelden</translation>
    </message>
    <message>
        <source>Back to the login screen, where somebody else can log in</source>
        <translation>Zurück zur Anmeldung, wo sich jemand anderes anmelden kann</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SidePanel</name>
    <message>
        <source>Ctrl+Page Down: read on</source>
        <translation>Strg+Bild ab: weiterlesen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SignedBar</name>
    <message>
        <source>%1 %2, over the limit</source>
        <translation>%1 %2, über der Grenze</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SiteBox</name>
    <message>
        <source>Site</source>
        <translation>Standort</translation>
    </message>
    <message>
        <source>Name of the site, such as the clinic&apos;s (may be left empty)</source>
        <translation>Name des Standorts, etwa der Klinik (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Everybody sees it at the login, on password slips and at the top of reports. Each change is recorded in the audit trail.</source>
        <translation>Alle sehen ihn bei der Anmeldung, auf Passwortzetteln und oben auf Berichten. Jede Änderung wird im Prüfprotokoll vermerkt.</translation>
    </message>
    <message>
        <source>Save the site&apos;s name</source>
        <translation>Namen des Standorts speichern</translation>
    </message>
    <message>
        <source>The site&apos;s name could not be read.
%1</source>
        <translation>Der Name des Standorts konnte nicht gelesen werden.
%1</translation>
    </message>
    <message>
        <source>The site has no name any more.</source>
        <translation>Der Standort hat keinen Namen mehr.</translation>
    </message>
    <message>
        <source>The site is now called %1.</source>
        <translation>Der Standort heißt jetzt %1.</translation>
    </message>
    <message>
        <source>The site&apos;s name was not changed.
%1</source>
        <translation>Der Name des Standorts wurde nicht geändert.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SizeRow</name>
    <message>
        <source>Size: one millimetre smaller</source>
        <translation>Größe: einen Millimeter kleiner</translation>
    </message>
    <message>
        <source>Size: one millimetre larger</source>
        <translation>Größe: einen Millimeter größer</translation>
    </message>
    <message>
        <source>Dashed: the pad of the finger. Keys + and −</source>
        <translation>Gestrichelt: die Fingerkuppe. Tasten + und −</translation>
    </message>
    <message>
        <source>Size: %1</source>
        <translation>Größe: %1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SlipsPanel</name>
    <message>
        <source>These passwords are shown only now. The program keeps no readable copy: print or save the slips before you close this window.</source>
        <translation>Diese Passwörter werden nur jetzt gezeigt. Das Programm behält keine lesbare Kopie: Drucken oder speichern Sie die Zettel, bevor Sie dieses Fenster schließen.</translation>
    </message>
    <message>
        <source>Name of the site on the slips (may be left empty)</source>
        <translation>Name des Standorts auf den Zetteln (darf leer bleiben)</translation>
    </message>
    <message>
        <source>Print the slips …</source>
        <translation>Zettel drucken …</translation>
    </message>
    <message>
        <source>Save as PDF …</source>
        <translation>Als PDF speichern …</translation>
    </message>
    <message>
        <source>New people and their passwords</source>
        <translation>Neue Personen und ihre Passwörter</translation>
    </message>
    <message>
        <source>Full name</source>
        <translation>Vollständiger Name</translation>
    </message>
    <message>
        <source>Login name</source>
        <translation>Anmeldename</translation>
    </message>
    <message>
        <source>Password</source>
        <translation>Passwort</translation>
    </message>
    <message>
        <source>Login slips</source>
        <translation>Anmeldezettel</translation>
    </message>
    <message>
        <source>The slips were sent to the printer. Check the paper before you close this window.</source>
        <translation>Die Zettel wurden an den Drucker gesendet. Prüfen Sie das Papier, bevor Sie dieses Fenster schließen.</translation>
    </message>
    <message>
        <source>The slips could not be printed. Choose another printer, or save them as PDF.</source>
        <translation>Die Zettel konnten nicht gedruckt werden. Wählen Sie einen anderen Drucker, oder speichern Sie sie als PDF.</translation>
    </message>
    <message>
        <source>Save the slips as PDF</source>
        <translation>Zettel als PDF speichern</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>login-slips</source>
        <translation>anmeldezettel</translation>
    </message>
    <message>
        <source>The slips were saved to %1, which only you can read. Delete the file once they are printed.</source>
        <translation>Die Zettel wurden in %1 gespeichert; nur Sie können diese Datei lesen. Löschen Sie sie, sobald die Zettel gedruckt sind.</translation>
    </message>
    <message>
        <source>The slips were not saved.
%1</source>
        <translation>Die Zettel wurden nicht gespeichert.
%1</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::SoundSign</name>
    <message>
        <source>Current sound</source>
        <translation>Aktueller Ton</translation>
    </message>
    <message>
        <source>Shows what can be heard: start of contact, pitch of the tone, warning</source>
        <translation>Zeigt, was zu hören ist: Beginn der Berührung, Höhe des Tons, Warnung</translation>
    </message>
    <message>
        <source>Warning: pressed too hard</source>
        <translation>Warnung: zu fest gedrückt</translation>
    </message>
    <message>
        <source>Contact</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>No tone</source>
        <translation>Kein Ton</translation>
    </message>
    <message>
        <source>Low tone</source>
        <translation>Tiefer Ton</translation>
    </message>
    <message>
        <source>Medium tone</source>
        <translation>Mittlerer Ton</translation>
    </message>
    <message>
        <source>High tone</source>
        <translation>Hoher Ton</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StatePanel</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Erneut versuchen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StationScreen</name>
    <message>
        <source>Station</source>
        <translation>Arbeitsplatz</translation>
    </message>
    <message>
        <source>Checking the station …</source>
        <translation>Arbeitsplatz wird geprüft …</translation>
    </message>
    <message>
        <source>The station could not be checked.</source>
        <translation>Der Arbeitsplatz konnte nicht geprüft werden.</translation>
    </message>
    <message>
        <source>Timing of the force loop</source>
        <translation>Zeitverhalten der Kraftregelung</translation>
    </message>
    <message>
        <source>Session %1, %2</source>
        <translation>Sitzung %1, %2</translation>
    </message>
    <message>
        <source>None of the latest sessions ran in real time, so it is not yet known how well this station keeps time.</source>
        <translation>Keine der letzten Sitzungen lief in Echtzeit; wie gut dieser Arbeitsplatz den Takt hält, ist deshalb noch nicht bekannt.</translation>
    </message>
    <message>
        <source>Self-test without a device</source>
        <translation>Selbsttest ohne Gerät</translation>
    </message>
    <message>
        <source>Run the self-test</source>
        <translation>Selbsttest starten</translation>
    </message>
    <message>
        <source>This session was recorded before the program stored how delays are distributed.</source>
        <translation>Als diese Sitzung aufgezeichnet wurde, speicherte das Programm die Verteilung der Verspätungen noch nicht.</translation>
    </message>
    <message>
        <source>The system said: %1</source>
        <translation>Das System meldete: %1</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Freier Platz</translation>
    </message>
    <message>
        <source>A running session keeps its last seconds in memory, so that a crash loses nothing. It needs %1 of the %2 that are free there.</source>
        <translation>Eine laufende Sitzung hält ihre letzten Sekunden im Arbeitsspeicher, damit bei einem Absturz nichts verloren geht. Sie braucht %1 von %2, die dort frei sind.</translation>
    </message>
    <message>
        <source>Testing the loop. Do not use the computer meanwhile.</source>
        <translation>Die Regelung wird geprüft. Benutzen Sie den Computer währenddessen nicht.</translation>
    </message>
    <message>
        <source>The self-test was stopped before it finished.</source>
        <translation>Der Selbsttest wurde vorzeitig abgebrochen.</translation>
    </message>
    <message>
        <source>Verifying the fingertip platform.</source>
        <translation>Die Fingerkuppen-Plattform wird geprüft.</translation>
    </message>
    <message>
        <source>Save the record</source>
        <translation>Protokoll speichern</translation>
    </message>
    <message>
        <source>Fingertip platform.pdf</source>
        <translation>Fingerkuppen-Plattform.pdf</translation>
    </message>
    <message>
        <source>PDF documents (*.pdf)</source>
        <translation>PDF-Dokumente (*.pdf)</translation>
    </message>
    <message>
        <source>The record was saved in %1.</source>
        <translation>Das Protokoll wurde in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The record could not be saved.</source>
        <translation>Das Protokoll konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Verify the fingertip platform</source>
        <translation>Fingerkuppen-Plattform prüfen</translation>
    </message>
    <message>
        <source>The check could not be written to the audit trail.</source>
        <translation>Die Prüfung konnte nicht in das Prüfprotokoll geschrieben werden.</translation>
    </message>
    <message>
        <source>Simulated fingertip platform</source>
        <translation>Simulierte Fingerkuppen-Plattform</translation>
    </message>
    <message>
        <source>None: the loop alone, without a device</source>
        <translation>Keines: die Kraftregelung allein, ohne Gerät</translation>
    </message>
    <message>
        <source>Shows whether this computer is fast and regular enough for haptic force.

Force is computed a thousand times per second. The charts show how late those thousand steps began: in the last session that ran in real time, and in a self-test of ten seconds without any device.

The fingertip platform is verified as in its publication: how closely it follows a force and an orientation. Each check is kept in the audit trail, and its record can be saved and filed: who, when, on which device and build, and each measured value beside its limit.

With real-time priority the loop stays on time whatever else the computer does. This screen shows whether the loop has that priority and how to permit it.</source>
        <translation>Zeigt, ob dieser Computer schnell und gleichmäßig genug für haptische Kraft ist.

Die Kraft wird tausendmal in der Sekunde berechnet. Die Diagramme zeigen, wie spät diese tausend Schritte begannen: in der letzten Sitzung, die in Echtzeit lief, und in einem Selbsttest von zehn Sekunden ohne Gerät.

Die Fingerkuppen-Plattform wird wie in ihrer Veröffentlichung geprüft: wie genau sie einer Kraft und einer Ausrichtung folgt. Jede Prüfung bleibt im Prüfprotokoll, und ihr Protokoll kann gespeichert und abgelegt werden: wer, wann, auf welchem Gerät und mit welcher Programmversion, und jeder Messwert neben seiner Grenze.

Mit Echtzeitpriorität bleibt die Kraftregelung pünktlich, was immer der Computer sonst tut. Diese Seite zeigt, ob sie diese Priorität hat und wie man sie erlaubt.</translation>
    </message>
    <message>
        <source>Record (PDF) …</source>
        <translation>Protokoll (PDF) …</translation>
    </message>
    <message>
        <source>Record of the self-test (PDF)</source>
        <translation>Protokoll des Selbsttests (PDF)</translation>
    </message>
    <message>
        <source>Station check.pdf</source>
        <translation>Arbeitsplatz.pdf</translation>
    </message>
    <message>
        <source>A researcher or an administrator can run it here.</source>
        <translation>Forschende oder die Administration können sie hier ausführen.</translation>
    </message>
    <message>
        <source>No maker&apos;s haptic device was connected to this version yet: the driver for devices connected by USB, network or serial line was tested against an emulation.</source>
        <translation>An diese Version war noch kein haptisches Gerät eines Herstellers angeschlossen: Der Treiber für Geräte an USB, Netzwerk oder serieller Leitung wurde mit einer Nachbildung geprüft.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StorageScreen</name>
    <message>
        <source>Storage</source>
        <translation>Datensicherung</translation>
    </message>
    <message>
        <source>Free space</source>
        <translation>Freier Platz</translation>
    </message>
    <message>
        <source>Database</source>
        <translation>Datenbank</translation>
    </message>
    <message>
        <source>Recordings in it</source>
        <translation>Aufzeichnungen darin</translation>
    </message>
    <message>
        <source>Free on this disk</source>
        <translation>Auf dieser Festplatte frei</translation>
    </message>
    <message>
        <source>Backups</source>
        <translation>Sicherungen</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>Erstellt</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Checked</source>
        <translation>Geprüft</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Back up now</source>
        <translation>Jetzt sichern</translation>
    </message>
    <message>
        <source>Check the selected backup</source>
        <translation>Gewählte Sicherung prüfen</translation>
    </message>
    <message>
        <source>Restore the selected backup …</source>
        <translation>Sicherung wiederherstellen …</translation>
    </message>
    <message>
        <source>Choose the folder …</source>
        <translation>Ordner wählen …</translation>
    </message>
    <message>
        <source>Verify</source>
        <translation>Prüfen</translation>
    </message>
    <message>
        <source>Reads every record, recomputes every score from its recording and checks the audit trail. It changes nothing.</source>
        <translation>Liest jeden Datensatz, berechnet jede Wertung aus ihrer Aufzeichnung neu und kontrolliert das Prüfprotokoll. Dabei wird nichts geändert.</translation>
    </message>
    <message>
        <source>Problems found</source>
        <translation>Gefundene Probleme</translation>
    </message>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Verify everything</source>
        <translation>Alles prüfen</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Exportieren</translation>
    </message>
    <message>
        <source>A backup and every table as text (JSON Lines, without passwords), for analysis elsewhere or to move all data to another program.</source>
        <translation>Eine Sicherung und jede Tabelle als Text (JSON Lines, ohne Passwörter), zur Auswertung anderswo oder um alle Daten in ein anderes Programm zu übernehmen.</translation>
    </message>
    <message>
        <source>Export the site …</source>
        <translation>Standort exportieren …</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message numerus="yes">
        <source>%1 from %n session(s)</source>
        <translation>
            <numerusform>%1 aus %n Sitzung</numerusform>
            <numerusform>%1 aus %n Sitzungen</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Kept in %1</source>
        <translation>Aufbewahrt in %1</translation>
    </message>
    <message>
        <source>When created</source>
        <translation>Bei der Erstellung</translation>
    </message>
    <message>
        <source>Just now: intact</source>
        <translation>Gerade eben: in Ordnung</translation>
    </message>
    <message>
        <source>Just now: damaged</source>
        <translation>Gerade eben: beschädigt</translation>
    </message>
    <message>
        <source>Wait until the restore has finished.</source>
        <translation>Warten Sie, bis das Wiederherstellen beendet ist.</translation>
    </message>
    <message>
        <source>The task that you started continues in the background.</source>
        <translation>Die gestartete Aufgabe läuft im Hintergrund weiter.</translation>
    </message>
    <message>
        <source>Checking the storage …</source>
        <translation>Daten und Sicherungen werden geprüft …</translation>
    </message>
    <message>
        <source>The storage could not be checked.</source>
        <translation>Daten und Sicherungen konnten nicht geprüft werden.</translation>
    </message>
    <message>
        <source>Folder for the export</source>
        <translation>Ordner für den Export</translation>
    </message>
    <message>
        <source>Folder for backups</source>
        <translation>Ordner für Sicherungen</translation>
    </message>
    <message>
        <source>The backup is made and checked: %1 in %2.</source>
        <translation>Die Sicherung ist erstellt und geprüft: %1 in %2.</translation>
    </message>
    <message>
        <source>The site is exported and checked: %1 in %2.</source>
        <translation>Der Standort ist exportiert und geprüft: %1 in %2.</translation>
    </message>
    <message>
        <source>The backup was stopped; nothing was saved.</source>
        <translation>Die Sicherung wurde abgebrochen; es wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>The export was stopped; nothing was saved.</source>
        <translation>Der Export wurde abgebrochen; es wurde nichts gespeichert.</translation>
    </message>
    <message>
        <source>The backup was not made.</source>
        <translation>Die Sicherung wurde nicht erstellt.</translation>
    </message>
    <message>
        <source>The site was not exported.</source>
        <translation>Der Standort wurde nicht exportiert.</translation>
    </message>
    <message>
        <source>Making a backup …</source>
        <translation>Sicherung wird erstellt …</translation>
    </message>
    <message>
        <source>Exporting the site …</source>
        <translation>Standort wird exportiert …</translation>
    </message>
    <message>
        <source>Verifying everything …</source>
        <translation>Alles wird geprüft …</translation>
    </message>
    <message>
        <source>Checking the backup …</source>
        <translation>Sicherung wird geprüft …</translation>
    </message>
    <message>
        <source>Restoring the backup. The current database is kept.</source>
        <translation>Die Sicherung wird wiederhergestellt. Die jetzige Datenbank bleibt erhalten.</translation>
    </message>
    <message>
        <source>Nothing was restored. The current database is unchanged.</source>
        <translation>Es wurde nichts wiederhergestellt. Die jetzige Datenbank ist unverändert.</translation>
    </message>
    <message>
        <source>The current database could not be opened again.</source>
        <translation>Die jetzige Datenbank konnte nicht wieder geöffnet werden.</translation>
    </message>
    <message>
        <source>The backup was restored. The previous database is kept as %1. Please log in again.</source>
        <translation>Die Sicherung wurde wiederhergestellt. Die bisherige Datenbank bleibt als %1 erhalten. Bitte melden Sie sich neu an.</translation>
    </message>
    <message>
        <source>Shows where all recorded data is kept and whether it is safe.

&quot;Back up now&quot; makes a copy while the program is running and checks it before it counts. Keep backups on another disk: choose the folder here.

&quot;Automatic backups&quot; makes one per day and keeps as many as you say; backups that you made yourself are never removed.

&quot;Verify&quot; reads everything again: each record, each recording, each score, the audit trail. It changes nothing and can be stopped.

&quot;Restore&quot; goes back to a backup. It asks an administrator for the password, keeps a copy of the current database, and logs everybody out.</source>
        <translation>Zeigt, wo alle aufgezeichneten Daten liegen und ob sie sicher sind.

„Jetzt sichern“ erstellt eine Kopie, während das Programm läuft, und prüft sie, bevor sie gilt. Bewahren Sie Sicherungen auf einer anderen Festplatte auf: Wählen Sie hier den Ordner.

„Automatische Sicherungen“ erstellt täglich eine und bewahrt so viele auf, wie Sie angeben; Sicherungen, die Sie selbst erstellt haben, werden nie entfernt.

„Prüfen“ liest alles noch einmal: jeden Datensatz, jede Aufzeichnung, jede Wertung, das Prüfprotokoll. Es ändert nichts und lässt sich abbrechen.

„Wiederherstellen“ kehrt zu einer Sicherung zurück. Es fragt die Administration nach dem Passwort, bewahrt die jetzige Datenbank auf und meldet alle ab.</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation>Automatisch</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>The plan for automatic backups was not saved.</source>
        <translation>Der Plan für automatische Sicherungen wurde nicht gespeichert.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudiesScreen</name>
    <message>
        <source>Import a study</source>
        <translation>Studie einlesen</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>The file could not be read.</source>
        <translation>Die Datei konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The study was not imported.</source>
        <translation>Die Studie wurde nicht eingelesen.</translation>
    </message>
    <message>
        <source>The study was not created.</source>
        <translation>Die Studie wurde nicht angelegt.</translation>
    </message>
    <message>
        <source>%1 was created as a draft.</source>
        <translation>%1 wurde als Entwurf angelegt.</translation>
    </message>
    <message>
        <source>%1 was not changed.</source>
        <translation>%1 wurde nicht geändert.</translation>
    </message>
    <message>
        <source>%1 is archived: nothing was deleted.</source>
        <translation>%1 ist archiviert: Es wurde nichts gelöscht.</translation>
    </message>
    <message>
        <source>%1 is back in the list.</source>
        <translation>%1 ist wieder in der Liste.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Close %1?</source>
        <translation>%1 schließen?</translation>
    </message>
    <message>
        <source>No more participants can be enrolled and no more runs started; open runs can still be finished. This cannot be undone.</source>
        <translation>Es können keine Personen mehr aufgenommen und keine Läufe mehr begonnen werden; offene lassen sich noch beenden. Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Keep it open</source>
        <translation>Offen lassen</translation>
    </message>
    <message>
        <source>Close the study</source>
        <translation>Studie schließen</translation>
    </message>
    <message>
        <source>The study was not closed.</source>
        <translation>Die Studie wurde nicht geschlossen.</translation>
    </message>
    <message>
        <source>Studies</source>
        <translation>Studien</translation>
    </message>
    <message>
        <source>New study …</source>
        <translation>Neue Studie …</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Einlesen …</translation>
    </message>
    <message>
        <source>Show archived</source>
        <translation>Archivierte zeigen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Stand</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Since</source>
        <translation>Seit</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Close …</source>
        <translation>Schließen …</translation>
    </message>
    <message>
        <source>Archive</source>
        <translation>Archivieren</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Die Studien konnten nicht gelesen werden</translation>
    </message>
    <message numerus="yes">
        <source>%n stud(y/ies)</source>
        <translation>
            <numerusform>%n Studie</numerusform>
            <numerusform>%n Studien</numerusform>
        </translation>
    </message>
    <message>
        <source>No studies yet</source>
        <translation>Noch keine Studien</translation>
    </message>
    <message>
        <source>Start from a template and change it: a ranking of three, a staircase or constant stimuli.</source>
        <translation>Beginnen Sie mit einer Vorlage und passen Sie sie an: Rangfolge von dreien, Treppenverfahren oder konstante Reize.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>%1 of %2 done</source>
        <translation>%1 von %2 fertig</translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>Open the study</source>
        <translation>Studie öffnen</translation>
    </message>
    <message>
        <source>Key</source>
        <translation>Kennung</translation>
    </message>
    <message>
        <source>Choose a study in the list first.</source>
        <translation>Wählen Sie zuerst eine Studie in der Liste.</translation>
    </message>
    <message>
        <source>The design is still a draft: freeze it first.</source>
        <translation>Der Entwurf ist noch nicht eingefroren: Frieren Sie ihn zuerst ein.</translation>
    </message>
    <message>
        <source>The study is archived: bring it back first.</source>
        <translation>Die Studie ist archiviert: Holen Sie sie zuerst zurück.</translation>
    </message>
    <message>
        <source>The study is closed already.</source>
        <translation>Die Studie ist bereits geschlossen.</translation>
    </message>
    <message>
        <source>The study could not be read.</source>
        <translation>Die Studie konnte nicht gelesen werden.</translation>
    </message>
    <message>
        <source>The study is blind. Only its author and administrators can copy it before it is unblinded.</source>
        <translation>Die Studie ist verblindet. Vor der Entblindung können sie nur ihre Autorin oder ihr Autor und die Administration kopieren.</translation>
    </message>
    <message>
        <source>Copy to new study …</source>
        <translation>In neue Studie kopieren …</translation>
    </message>
    <message>
        <source>All studies of this site. A draft is designed and tried out with simulated observers. Once it is frozen, its design can never be changed again: every export states its SHA-256, and participants are enrolled under random codes.

&quot;New study&quot; starts from a template or from scratch; &quot;Import&quot; reads a study from a JSON file. Press Enter or double-click to open a study. &quot;Run&quot; takes a participant through it, &quot;Data&quot; shows the results.

&quot;Close&quot; ends enrolment for good. &quot;Archive&quot; takes a study out of the list and can be undone.</source>
        <translation>Alle Studien dieses Standorts. Ein Entwurf wird gestaltet und mit simulierten Beobachtern erprobt. Ist er eingefroren, lässt er sich nie mehr ändern: Sein SHA-256 steht in jedem Export, und Personen werden unter zufälligen Codes aufgenommen.

„Neue Studie“ beginnt mit einer Vorlage oder ganz leer; „Einlesen“ liest eine Studie aus einer JSON-Datei. Enter oder Doppelklick öffnet eine Studie. „Durchführen“ führt eine Person hindurch, „Daten“ zeigt die Ergebnisse.

„Schließen“ beendet die Aufnahme endgültig. „Archivieren“ nimmt eine Studie aus der Liste und lässt sich rückgängig machen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyDataScreen</name>
    <message>
        <source>CSV …</source>
        <translation>CSV …</translation>
    </message>
    <message>
        <source>BIDS …</source>
        <translation>BIDS …</translation>
    </message>
    <message>
        <source>PDF …</source>
        <translation>PDF …</translation>
    </message>
    <message>
        <source>Unblind …</source>
        <translation>Entblinden …</translation>
    </message>
    <message>
        <source>Export as CSV</source>
        <translation>Als CSV exportieren</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>Als PDF speichern</translation>
    </message>
    <message>
        <source>Export as BIDS</source>
        <translation>Als BIDS exportieren</translation>
    </message>
    <message>
        <source>Choose a location for the folder</source>
        <translation>Speicherort für den Ordner wählen</translation>
    </message>
    <message>
        <source>Writing the tables …</source>
        <translation>Die Tabellen werden geschrieben …</translation>
    </message>
    <message>
        <source>The tables were written to %1.</source>
        <translation>Die Tabellen liegen jetzt in %1.</translation>
    </message>
    <message>
        <source>The tables could not be written.</source>
        <translation>Die Tabellen konnten nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Writing the BIDS dataset …</source>
        <translation>Der BIDS-Datensatz wird geschrieben …</translation>
    </message>
    <message>
        <source>The BIDS dataset was written to %1.</source>
        <translation>Der BIDS-Datensatz liegt jetzt in %1.</translation>
    </message>
    <message>
        <source>The BIDS dataset could not be written.</source>
        <translation>Der BIDS-Datensatz konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The report was written to %1.</source>
        <translation>Der Bericht wurde in %1 geschrieben.</translation>
    </message>
    <message>
        <source>The report could not be written.</source>
        <translation>Der Bericht konnte nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Reading the studies …</source>
        <translation>Studien werden gelesen …</translation>
    </message>
    <message>
        <source>The studies could not be read</source>
        <translation>Die Studien konnten nicht gelesen werden</translation>
    </message>
    <message>
        <source>No data yet</source>
        <translation>Noch keine Daten</translation>
    </message>
    <message>
        <source>Data appear here once participants have taken part in a frozen study.</source>
        <translation>Daten erscheinen hier, sobald Personen an einer eingefrorenen Studie teilgenommen haben.</translation>
    </message>
    <message>
        <source>Open the studies</source>
        <translation>Studien öffnen</translation>
    </message>
    <message>
        <source>Analysing the runs …</source>
        <translation>Läufe werden ausgewertet …</translation>
    </message>
    <message>
        <source>The study could not be analysed</source>
        <translation>Die Studie konnte nicht ausgewertet werden</translation>
    </message>
    <message>
        <source>Views of the data</source>
        <translation>Ansichten der Daten</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>Person</source>
        <translation>Person</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>SHA-256 %1</source>
        <translation>SHA-256 %1</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s)</source>
        <translation>
            <numerusform>%n Person</numerusform>
            <numerusform>%n Personen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n scored trial(s)</source>
        <translation>
            <numerusform>%n gewerteter Durchgang</numerusform>
            <numerusform>%n gewertete Durchgänge</numerusform>
        </translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>entblindet</translation>
    </message>
    <message>
        <source>blind: conditions shown by sealed codes</source>
        <translation>verblindet: Bedingungen unter versiegelten Codes</translation>
    </message>
    <message>
        <source>Groups include runs with force shown, not felt</source>
        <translation>Auch Läufe mit nur gezeigter Kraft einbeziehen</translation>
    </message>
    <message>
        <source>The results of a study.

&quot;Group&quot; shows each participant&apos;s Weber fraction with its interval for every condition, and any warnings. &quot;Person&quot; shows the curve of a run with its data. &quot;Trials&quot; lists every presentation with its fidelity and says why one did not count. &quot;Questions&quot; summarises the questionnaires. &quot;Comparison&quot; sets the conditions beside each other, and says who or what is missing where they cannot be compared.

You can export tables (CSV), a BIDS dataset or a PDF; each contains the design&apos;s SHA-256. While the experimenter is blind, conditions are shown by sealed codes, and of their runs you see only how well each participant&apos;s trials went. Unblinding asks for a reason, is recorded and cannot be undone.</source>
        <translation>Die Ergebnisse einer Studie.

„Gruppe“ zeigt den Weber-Bruch jeder Person mit seinem Intervall für jede Bedingung sowie Warnungen. „Person“ zeigt die Kurve eines Laufs mit ihren Daten. „Durchgänge“ führt jede Darbietung mit ihrer Wiedergabetreue auf und sagt, warum eine nicht zählt. „Fragen“ fasst die Fragebögen zusammen. „Vergleich“ stellt die Bedingungen nebeneinander und sagt, wer oder was fehlt, wo sie nicht verglichen werden können.

Exportieren können Sie Tabellen (CSV), einen BIDS-Datensatz oder ein PDF; in jedem steht der SHA-256 des Entwurfs. Solange die Versuchsleitung verblindet ist, stehen die Bedingungen unter versiegelten Codes, und von ihren Läufen sehen Sie nur, wie gut die Durchgänge jeder Person liefen. Das Entblinden verlangt einen Grund, wird festgehalten und lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>Comparison</source>
        <translation>Vergleich</translation>
    </message>
    <message>
        <source>The study is not on the screen yet, so nothing was exported. Try again once it is there.</source>
        <translation>Die Studie ist noch nicht auf dem Bildschirm, deshalb wurde nichts exportiert. Versuchen Sie es noch einmal, sobald sie da ist.</translation>
    </message>
    <message>
        <source>Nothing was exported: no place was chosen.</source>
        <translation>Es wurde nichts exportiert: Kein Ort wurde gewählt.</translation>
    </message>
    <message>
        <source>There are no scored trials yet.</source>
        <translation>Es gibt noch keine gewerteten Durchgänge.</translation>
    </message>
    <message>
        <source>It is an earlier export. You can replace it with the data as they are now, or keep it and write the new export beside it.</source>
        <translation>Es ist ein früherer Export. Sie können ihn durch die Daten ersetzen, wie sie jetzt sind, oder ihn behalten und den neuen Export daneben schreiben.</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Replace</source>
        <translation>Ersetzen</translation>
    </message>
    <message>
        <source>Write beside it</source>
        <translation>Daneben schreiben</translation>
    </message>
    <message>
        <source>Nothing was exported. %1 is as it was.</source>
        <translation>Es wurde nichts exportiert. %1 ist, wie es war.</translation>
    </message>
    <message>
        <source>It applies to every page here and to the PDF, and is remembered.</source>
        <translation>Es gilt für jede Seite hier und für das PDF und wird gemerkt.</translation>
    </message>
    <message>
        <source>The previous export is still being written. Try again once the message says where it was written.</source>
        <translation>Der vorige Export wird noch geschrieben. Versuchen Sie es noch einmal, sobald die Meldung sagt, wohin er geschrieben wurde.</translation>
    </message>
    <message>
        <source>%1 already exists.</source>
        <translation>%1 gibt es schon.</translation>
    </message>
    <message>
        <source>It is not an export of a study, so it is not replaced. You can write the export beside it.</source>
        <translation>Es ist kein Export einer Studie und wird deshalb nicht ersetzt. Sie können den Export daneben schreiben.</translation>
    </message>
    <message>
        <source>In no run of this study was force only shown, so this changes nothing here. The choice is remembered.</source>
        <translation>In keinem Lauf dieser Studie wurde die Kraft nur gezeigt, hier ändert es also nichts. Die Wahl wird gemerkt.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::StudyScreen</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Studie wird gelesen …</translation>
    </message>
    <message>
        <source>The study could not be read</source>
        <translation>Die Studie konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>Parts of the study</source>
        <translation>Teile der Studie</translation>
    </message>
    <message>
        <source>Conditions</source>
        <translation>Bedingungen</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>Questions</source>
        <translation>Fragen</translation>
    </message>
    <message>
        <source>Participants</source>
        <translation>Teilnehmende</translation>
    </message>
    <message>
        <source>Freeze …</source>
        <translation>Einfrieren …</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Import …</source>
        <translation>Einlesen …</translation>
    </message>
    <message>
        <source>Run</source>
        <translation>Durchführen</translation>
    </message>
    <message>
        <source>Data</source>
        <translation>Daten</translation>
    </message>
    <message>
        <source>Save as JSON …</source>
        <translation>Als JSON speichern …</translation>
    </message>
    <message>
        <source>Language of the texts</source>
        <translation>Sprache der Texte</translation>
    </message>
    <message>
        <source>The draft could not be saved.
%1</source>
        <translation>Der Entwurf konnte nicht gespeichert werden.
%1</translation>
    </message>
    <message>
        <source>key %1</source>
        <translation>Kennung %1</translation>
    </message>
    <message>
        <source>SHA-256 %1</source>
        <translation>SHA-256 %1</translation>
    </message>
    <message>
        <source>frozen %1</source>
        <translation>eingefroren %1</translation>
    </message>
    <message>
        <source>unblinded</source>
        <translation>entblindet</translation>
    </message>
    <message>
        <source>blind</source>
        <translation>verblindet</translation>
    </message>
    <message>
        <source>all changes saved</source>
        <translation>alles gespeichert</translation>
    </message>
    <message>
        <source>saving …</source>
        <translation>wird gespeichert …</translation>
    </message>
    <message>
        <source>not saved</source>
        <translation>nicht gespeichert</translation>
    </message>
    <message>
        <source>The draft could not be saved.</source>
        <translation>Der Entwurf konnte nicht gespeichert werden.</translation>
    </message>
    <message>
        <source>Leave without the last changes?</source>
        <translation>Ohne die letzten Änderungen verlassen?</translation>
    </message>
    <message>
        <source>The design still has errors, so the last changes were not saved. The last version without errors is saved.</source>
        <translation>Der Entwurf enthält noch Fehler, darum wurden die letzten Änderungen nicht gespeichert. Die letzte fehlerfreie Fassung ist gespeichert.</translation>
    </message>
    <message>
        <source>Stay</source>
        <translation>Bleiben</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Import a design from a file</source>
        <translation>Entwurf aus einer Datei einlesen</translation>
    </message>
    <message>
        <source>Studies (*.json)</source>
        <translation>Studien (*.json)</translation>
    </message>
    <message>
        <source>The file was not imported:
%1</source>
        <translation>Die Datei wurde nicht eingelesen:
%1</translation>
    </message>
    <message>
        <source>Import of a file</source>
        <translation>Einlesen einer Datei</translation>
    </message>
    <message>
        <source>Save the design</source>
        <translation>Entwurf speichern</translation>
    </message>
    <message>
        <source>The design was not saved.</source>
        <translation>Der Entwurf wurde nicht gespeichert.</translation>
    </message>
    <message>
        <source>The design was saved in %1.</source>
        <translation>Der Entwurf wurde in %1 gespeichert.</translation>
    </message>
    <message>
        <source>The design must be free of errors before it can be frozen.</source>
        <translation>Der Entwurf muss fehlerfrei sein, bevor er eingefroren werden kann.</translation>
    </message>
    <message>
        <source>The last changes are still being saved.</source>
        <translation>Die letzten Änderungen werden noch gespeichert.</translation>
    </message>
    <message>
        <source>Aim</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Check and freeze</source>
        <translation>Prüfen und einfrieren</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>Show the first</source>
        <translation>Erste zeigen</translation>
    </message>
    <message>
        <source>Copy to new study …</source>
        <translation>In neue Studie kopieren …</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Something here must be corrected.</source>
        <translation>Hier muss etwas berichtigt werden.</translation>
    </message>
    <message numerus="yes">
        <source>Not saved yet: %n entr(y/ies) must be corrected first. %1</source>
        <translation>
            <numerusform>Noch nicht gespeichert: %n Eingabe muss zuerst berichtigt werden. %1</numerusform>
            <numerusform>Noch nicht gespeichert: %n Eingaben müssen zuerst berichtigt werden. %1</numerusform>
        </translation>
    </message>
    <message>
        <source>The last changes are still being saved. Try again in a moment.</source>
        <translation>Die letzten Änderungen werden noch gespeichert. Versuchen Sie es gleich noch einmal.</translation>
    </message>
    <message>
        <source>One study. While it is a draft, you can change everything. Go through the pages with &quot;Next&quot; and &quot;Back&quot;, or jump to one by its name. Complete entries are saved at once, Ctrl+Z undoes a step, and a message under a field says what is wrong with it. Beside the pages you see what a participant will see.

&quot;Conditions&quot; defines what is compared, with which task and procedure. &quot;Expected precision&quot; runs the study with simulated observers and shows the expected precision, number of trials and time. &quot;Check and freeze&quot; says what is missing, lets somebody try the design as a pilot, and freezes it permanently under its SHA-256; participants can be enrolled from then on, under random codes, with their consent.</source>
        <translation>Eine Studie. Solange sie ein Entwurf ist, können Sie alles ändern. Gehen Sie die Seiten mit „Weiter“ und „Zurück“ durch, oder wählen Sie eine Seite über ihren Namen. Vollständige Eingaben werden sofort gespeichert, Strg+Z macht einen Schritt rückgängig, und was nicht stimmt, steht unter dem Feld. Neben den Seiten sehen Sie, was Teilnehmende sehen werden.

„Bedingungen“ legt fest, was mit welcher Aufgabe und welchem Verfahren verglichen wird. „Erwartete Genauigkeit“ lässt simulierte Beobachter die Studie durchlaufen und zeigt die erwartete Genauigkeit, die Zahl der Durchgänge und die Zeit. „Prüfen und einfrieren“ sagt, was fehlt, lässt jemanden den Entwurf als Probelauf ausprobieren und friert ihn endgültig unter seinem SHA-256 ein; von da an können Teilnehmende mit ihrer Einwilligung unter zufälligen Codes aufgenommen werden.</translation>
    </message>
    <message>
        <source>Expected precision</source>
        <translation>Erwartete Genauigkeit</translation>
    </message>
    <message>
        <source>Needed before it can be frozen: %1</source>
        <translation>Vor dem Einfrieren noch nötig: %1</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>Next: correct “%1”</source>
        <translation>Weiter: „%1“ berichtigen</translation>
    </message>
    <message>
        <source>The simulation was stopped because you left its page, and nothing of it was kept. Press “Estimate the precision” there to calculate it again.</source>
        <translation>Die Simulation wurde abgebrochen, weil Sie ihre Seite verlassen haben, und nichts davon wurde behalten. Drücken Sie dort „Genauigkeit schätzen“, um sie neu zu rechnen.</translation>
    </message>
    <message>
        <source>cannot be frozen before the entries marked in red are corrected</source>
        <translation>kann erst eingefroren werden, wenn die rot markierten Einträge berichtigt sind</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TargetBar</name>
    <message>
        <source>below the band</source>
        <translation>unter dem Bereich</translation>
    </message>
    <message>
        <source>in the band</source>
        <translation>im Bereich</translation>
    </message>
    <message>
        <source>above the band</source>
        <translation>über dem Bereich</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 %2, %3</source>
        <translation>%1 %2, %3</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TaskStrip</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stopping …</source>
        <translation>Wird beendet …</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrainingScreen</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Storing and scoring the session …</source>
        <translation>Sitzung wird gespeichert und gewertet …</translation>
    </message>
    <message>
        <source>The session could not be run</source>
        <translation>Die Sitzung konnte nicht durchgeführt werden</translation>
    </message>
    <message>
        <source>End the session now?</source>
        <translation>Sitzung jetzt beenden?</translation>
    </message>
    <message>
        <source>End the session</source>
        <translation>Sitzung beenden</translation>
    </message>
    <message>
        <source>A session is running. End it and leave?</source>
        <translation>Eine Sitzung läuft. Beenden und verlassen?</translation>
    </message>
    <message>
        <source>End and leave</source>
        <translation>Beenden und verlassen</translation>
    </message>
    <message>
        <source>Preparing the scene …</source>
        <translation>Szene wird vorbereitet …</translation>
    </message>
    <message>
        <source>What is recorded is kept. The session counts as stopped, not as completed.</source>
        <translation>Aufgezeichnetes bleibt erhalten. Die Sitzung gilt als abgebrochen, nicht als abgeschlossen.</translation>
    </message>
    <message>
        <source>Keep training</source>
        <translation>Weiter trainieren</translation>
    </message>
    <message>
        <source>Training</source>
        <translation>Training</translation>
    </message>
    <message>
        <source>Stop force</source>
        <translation>Kraft stoppen</translation>
    </message>
    <message>
        <source>Pause or go on</source>
        <translation>Pause oder weiter</translation>
    </message>
    <message>
        <source>Re-arm force</source>
        <translation>Kraft freigeben</translation>
    </message>
    <message>
        <source>Mark this place</source>
        <translation>Diese Stelle markieren</translation>
    </message>
    <message>
        <source>Sound on or off</source>
        <translation>Ton an oder aus</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>What is recorded so far is kept and counts as stopped, not as completed. A new attempt begins at once.</source>
        <translation>Bisher Aufgezeichnetes bleibt erhalten und gilt als abgebrochen, nicht als abgeschlossen. Ein neuer Versuch beginnt sofort.</translation>
    </message>
    <message>
        <source>Start again from the beginning?</source>
        <translation>Von vorn neu beginnen?</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Depth of field (F)</source>
        <translation>Schärfentiefe (F)</translation>
    </message>
    <message>
        <source>Depth of field: this level keeps it on</source>
        <translation>Schärfentiefe: auf dieser Stufe immer an</translation>
    </message>
    <message>
        <source>Depth of field: this level keeps it off</source>
        <translation>Schärfentiefe: auf dieser Stufe immer aus</translation>
    </message>
    <message>
        <source>The picture is sharp at one distance only, as through a real endoscope</source>
        <translation>Das Bild ist nur in einer Entfernung scharf, wie durch ein echtes Endoskop</translation>
    </message>
    <message>
        <source>When the procedure is done the debrief opens by itself.</source>
        <translation>Nach dem Eingriff öffnet sich die Auswertung von selbst.</translation>
    </message>
    <message>
        <source>After the last trial the debrief opens by itself.</source>
        <translation>Nach dem letzten Durchgang öffnet sich die Auswertung von selbst.</translation>
    </message>
    <message>
        <source>This is where you train. The scene is on the left, the measurements are on the right and the controls are below. Each level shows only what belongs to it; what is hidden is still recorded.

%1

&quot;Stop force&quot; switches the force off at once and stops the clock. &quot;Re-arm&quot; brings the force back slowly. &quot;Pause&quot; keeps everything as it is. &quot;Start again&quot; keeps the attempt so far as stopped and begins a new one from the start.

%2</source>
        <translation>Hier trainieren Sie. Links sehen Sie die Szene, rechts die Messwerte, unten die Bedienelemente. Jede Stufe zeigt nur, was zu ihr gehört; Verborgenes wird trotzdem aufgezeichnet.

%1

„Kraft stoppen“ schaltet die Kraft sofort ab und hält die Uhr an. „Freigeben“ bringt die Kraft langsam zurück. „Pause“ lässt alles, wie es ist. „Neu beginnen“ bewahrt den bisherigen Versuch als abgebrochen auf und beginnt einen neuen von vorn.

%2</translation>
    </message>
    <message>
        <source>Start again from the beginning</source>
        <translation>Von vorn neu beginnen</translation>
    </message>
    <message>
        <source>Depth of field on or off</source>
        <translation>Schärfentiefe an oder aus</translation>
    </message>
    <message>
        <source>Select the next finding</source>
        <translation>Nächsten Fund wählen</translation>
    </message>
    <message>
        <source>Take back the selected finding</source>
        <translation>Gewählten Fund zurücknehmen</translation>
    </message>
    <message>
        <source>Nothing more to report</source>
        <translation>Nichts mehr zu melden</translation>
    </message>
    <message>
        <source>Free the pointer to rate with the mouse</source>
        <translation>Zeiger freigeben, um mit der Maus zu bewerten</translation>
    </message>
    <message>
        <source>Map: searched area or force</source>
        <translation>Karte: abgetastete Fläche oder Kraft</translation>
    </message>
    <message>
        <source>Force is stopped</source>
        <translation>Kraft ist gestoppt</translation>
    </message>
    <message>
        <source>The clock is stopped. Press Re-arm or R to go on.</source>
        <translation>Die Uhr steht. Drücken Sie „Freigeben“ oder R, um fortzufahren.</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>The clock is stopped. Press Resume or Space to go on.</source>
        <translation>Die Uhr steht. Drücken Sie „Weiter“ oder die Leertaste, um fortzufahren.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Go or move the tool with a key.</source>
        <translation>
            <numerusform>%n Durchgang. Die Uhr läuft, sobald Sie „Los“ drücken oder das Instrument mit einer Taste bewegen.</numerusform>
            <numerusform>%n Durchgänge. Die Uhr läuft, sobald Sie „Los“ drücken oder das Instrument mit einer Taste bewegen.</numerusform>
        </translation>
    </message>
    <message>
        <source>All measurements (F4)</source>
        <translation>Alle Messwerte (F4)</translation>
    </message>
    <message>
        <source>Also shows single components, coordinates and further plots. Everything is recorded either way.</source>
        <translation>Zeigt auch einzelne Komponenten, Koordinaten und weitere Diagramme. Aufgezeichnet wird in jedem Fall alles.</translation>
    </message>
    <message>
        <source>All measurements, or those a trainee needs</source>
        <translation>Alle Messwerte oder die für Lernende nötigen</translation>
    </message>
    <message>
        <source>The practice is over. The familiarisation begins when you press Continue; it does not count either.</source>
        <translation>Die Übungszeit ist vorbei. Die Eingewöhnung beginnt, wenn Sie „Weiter“ drücken; auch sie zählt nicht.</translation>
    </message>
    <message>
        <source>The practice is over and does not count. The trials that count begin when you press Continue.</source>
        <translation>Die Übungszeit ist vorbei und zählt nicht. Die Durchgänge, die zählen, beginnen, wenn Sie „Weiter“ drücken.</translation>
    </message>
    <message>
        <source>Practice ends in %1 s</source>
        <translation>Die Übungszeit endet in %1 s</translation>
    </message>
    <message>
        <source>%1. %2.</source>
        <translation>%1. %2.</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Continue.</source>
        <translation>
            <numerusform>%n Durchgang. Die Uhr läuft, sobald Sie „Weiter“ drücken.</numerusform>
            <numerusform>%n Durchgänge. Die Uhr läuft, sobald Sie „Weiter“ drücken.</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 Nothing counts yet.</source>
        <translation>%1 Noch zählt nichts.</translation>
    </message>
    <message>
        <source>The mouse moves the instrument. Space pauses and frees it.</source>
        <translation>Die Maus bewegt das Instrument. Die Leertaste pausiert und gibt sie frei.</translation>
    </message>
    <message>
        <source>Space frees the mouse</source>
        <translation>Die Leertaste gibt die Maus frei</translation>
    </message>
    <message numerus="yes">
        <source>%n trial(s). The clock starts when you press Go.</source>
        <translation>
            <numerusform>%n Durchgang. Die Uhr läuft, sobald Sie „Los“ drücken.</numerusform>
            <numerusform>%n Durchgänge. Die Uhr läuft, sobald Sie „Los“ drücken.</numerusform>
        </translation>
    </message>
    <message>
        <source>Click in the scene to go on</source>
        <translation>Klicken Sie in die Szene, um weiterzuarbeiten</translation>
    </message>
    <message>
        <source>Scroll down in the panel</source>
        <translation>In der Leiste nach unten blättern</translation>
    </message>
    <message>
        <source>Scroll up in the panel</source>
        <translation>In der Leiste nach oben blättern</translation>
    </message>
    <message>
        <source>The practice is paused. Press Resume or Space to go on.</source>
        <translation>Die Übungszeit ist pausiert. Drücken Sie „Weiter“ oder die Leertaste, um fortzufahren.</translation>
    </message>
    <message>
        <source>The trial is paused and its clock is stopped. Press Resume or Space to go on.</source>
        <translation>Der Durchgang ist pausiert, und seine Uhr steht. Drücken Sie „Weiter“ oder die Leertaste, um fortzufahren.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TransportBar</name>
    <message>
        <source>To the beginning (Home)</source>
        <translation>Zum Anfang (Pos1)</translation>
    </message>
    <message>
        <source>One frame back (Left)</source>
        <translation>Ein Bild zurück (Links)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>One frame forward (Right)</source>
        <translation>Ein Bild vor (Rechts)</translation>
    </message>
    <message>
        <source>To the end (End)</source>
        <translation>Zum Ende (Ende)</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Skip pauses</source>
        <translation>Pausen überspringen</translation>
    </message>
    <message>
        <source>%1 of %2 in the recording, which begins before the first trial</source>
        <translation>%1 von %2 in der Aufzeichnung, die vor dem ersten Durchgang beginnt</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsPageOfRun</name>
    <message>
        <source>There are no runs yet.</source>
        <translation>Es gibt noch keine Läufe.</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Difference</source>
        <translation>Unterschied</translation>
    </message>
    <message>
        <source>Answer</source>
        <translation>Antwort</translation>
    </message>
    <message>
        <source>Counts</source>
        <translation>Zählt</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>given</source>
        <translation>gegeben</translation>
    </message>
    <message>
        <source>wrong</source>
        <translation>falsch</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>Übung</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Number of the presentation</source>
        <translation>Nummer der Darbietung</translation>
    </message>
    <message>
        <source>By how much the object exceeded the reference</source>
        <translation>Um wie viel das Objekt über der Referenz lag</translation>
    </message>
    <message>
        <source>Whether the trial counts, and if not, why</source>
        <translation>Ob der Durchgang zählt, und wenn nicht, warum</translation>
    </message>
    <message>
        <source>Time until the answer</source>
        <translation>Zeit bis zur Antwort</translation>
    </message>
    <message>
        <source>Peak force</source>
        <translation>Spitzenkraft</translation>
    </message>
    <message>
        <source>Mean speed of the tool</source>
        <translation>Mittlere Geschwindigkeit des Instruments</translation>
    </message>
    <message>
        <source>Share of late ticks</source>
        <translation>Anteil verspäteter Takte</translation>
    </message>
    <message>
        <source>How far the felt value was from the requested one</source>
        <translation>Wie weit der gefühlte Wert vom verlangten abwich</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Tempo (mm/s)</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Späte Takte</translation>
    </message>
    <message>
        <source>Deviation</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>What the participant answered</source>
        <translation>Was die Person antwortete</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::TrialsScreen</name>
    <message>
        <source>Study</source>
        <translation>Studie</translation>
    </message>
    <message>
        <source>Participant %1</source>
        <translation>Person %1</translation>
    </message>
    <message>
        <source>Reading the study …</source>
        <translation>Studie wird gelesen …</translation>
    </message>
    <message>
        <source>Before you begin</source>
        <translation>Bevor Sie beginnen</translation>
    </message>
    <message>
        <source>Participant %1 · practice</source>
        <translation>Person %1 · Übung</translation>
    </message>
    <message>
        <source>Correct.</source>
        <translation>Richtig.</translation>
    </message>
    <message>
        <source>Wrong.</source>
        <translation>Falsch.</translation>
    </message>
    <message>
        <source>The time to explore is over. Answer now.</source>
        <translation>Die Zeit zum Erkunden ist um. Antworten Sie jetzt.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Einen Moment …</translation>
    </message>
    <message>
        <source>Break</source>
        <translation>Pause</translation>
    </message>
    <message numerus="yes">
        <source>Rest your hand. You can continue in %n second(s).</source>
        <translation>
            <numerusform>Lassen Sie die Hand ruhen. In %n Sekunde geht es weiter.</numerusform>
            <numerusform>Lassen Sie die Hand ruhen. In %n Sekunden geht es weiter.</numerusform>
        </translation>
    </message>
    <message>
        <source>Continue when you are ready.</source>
        <translation>Machen Sie weiter, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>Continue</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop this session?</source>
        <translation>Diese Sitzung beenden?</translation>
    </message>
    <message>
        <source>This condition is completed.</source>
        <translation>Diese Bedingung ist abgeschlossen.</translation>
    </message>
    <message>
        <source>The session could not be run</source>
        <translation>Die Sitzung konnte nicht durchgeführt werden</translation>
    </message>
    <message>
        <source>Pause or go on</source>
        <translation>Pause oder weiter</translation>
    </message>
    <message>
        <source>Stop the session</source>
        <translation>Sitzung beenden</translation>
    </message>
    <message>
        <source>Progress of this part</source>
        <translation>Fortschritt dieses Teils</translation>
    </message>
    <message>
        <source>Time to explore</source>
        <translation>Zeit zum Erkunden</translation>
    </message>
    <message>
        <source>%1 mm from the highest point.</source>
        <translation>%1 mm vom höchsten Punkt entfernt.</translation>
    </message>
    <message>
        <source>Click or press Enter at the highest point.</source>
        <translation>Klicken Sie am höchsten Punkt oder drücken Sie dort Enter.</translation>
    </message>
    <message>
        <source>The sphere is too stiff for this device: the study asks for %1 N/m, but with its delay the device can render at most %2 N/m stably. Use a faster device, or plan a softer sphere in another study.</source>
        <translation>Die Kugel ist zu steif für dieses Gerät: Verlangt sind %1 N/m, bei seiner Verzögerung kann es aber höchstens %2 N/m stabil darstellen. Nehmen Sie ein schnelleres Gerät, oder planen Sie in einer anderen Studie eine weichere Kugel.</translation>
    </message>
    <message>
        <source>Not possible with this device</source>
        <translation>Mit diesem Gerät nicht möglich</translation>
    </message>
    <message>
        <source>Because of its delay, this device can render none of the differences in this condition. Use a faster or stronger device, or plan another reference in another study.</source>
        <translation>Wegen seiner Verzögerung kann dieses Gerät keinen der Unterschiede dieser Bedingung darstellen. Verwenden Sie ein schnelleres oder stärkeres Gerät, oder planen Sie in einer anderen Studie eine andere Referenz.</translation>
    </message>
    <message>
        <source>This run was started on a device that renders larger differences than this one. It can be continued only with such a device, so that all of its trials can be compared.</source>
        <translation>Dieser Lauf wurde mit einem Gerät begonnen, das größere Unterschiede darstellt als dieses. Er kann nur mit einem solchen Gerät fortgesetzt werden, damit alle seine Durchgänge vergleichbar sind.</translation>
    </message>
    <message>
        <source>This run was started with a different version of its procedure. A run is never continued with another version, so that all of its trials can be compared. The answers so far are kept; enrol another participant for this condition.</source>
        <translation>Dieser Lauf wurde mit einer anderen Fassung seines Verfahrens begonnen. Ein Lauf wird nie mit einer anderen Fassung fortgesetzt, damit alle Durchgänge vergleichbar bleiben. Die bisherigen Antworten bleiben erhalten; nehmen Sie für diese Bedingung jemand anderen auf.</translation>
    </message>
    <message>
        <source>This is how you explore and answer</source>
        <translation>So erkunden und antworten Sie</translation>
    </message>
    <message>
        <source>Where is the highest point?</source>
        <translation>Wo ist der höchste Punkt?</translation>
    </message>
    <message>
        <source>First comes a free minute to try the controls. Nothing counts in it, and you can end it at any time.</source>
        <translation>Zuerst kommt eine freie Minute, um die Bedienung auszuprobieren. Darin zählt nichts, und Sie können sie jederzeit beenden.</translation>
    </message>
    <message>
        <source>The trials go on where they were interrupted.</source>
        <translation>Die Durchgänge gehen dort weiter, wo sie unterbrochen wurden.</translation>
    </message>
    <message>
        <source>The session could not be run.</source>
        <translation>Die Sitzung konnte nicht durchgeführt werden.</translation>
    </message>
    <message>
        <source>Experimenter</source>
        <translation>Versuchsleitung</translation>
    </message>
    <message>
        <source>Go on with the study</source>
        <translation>Mit der Studie fortfahren</translation>
    </message>
    <message>
        <source>Masking sound</source>
        <translation>Maskierungsgeräusch</translation>
    </message>
    <message>
        <source>Whether it is on is stored with each trial</source>
        <translation>Ob es an ist, wird mit jedem Durchgang gespeichert</translation>
    </message>
    <message>
        <source>Experimenter …</source>
        <translation>Versuchsleitung …</translation>
    </message>
    <message>
        <source>Take back (⌫)</source>
        <translation>Zurücknehmen (⌫)</translation>
    </message>
    <message>
        <source>Next (Enter)</source>
        <translation>Weiter (Enter)</translation>
    </message>
    <message>
        <source>The participant&apos;s page is on the other screen.</source>
        <translation>Die Seite der Versuchsperson ist auf dem anderen Bildschirm.</translation>
    </message>
    <message>
        <source>The session is paused. Before you hand over, go back to the participant&apos;s page.</source>
        <translation>Die Sitzung ist pausiert. Gehen Sie zur Seite der Versuchsperson zurück, bevor Sie übergeben.</translation>
    </message>
    <message>
        <source>Please call the experimenter.</source>
        <translation>Bitte rufen Sie die Versuchsleitung.</translation>
    </message>
    <message>
        <source>Participant %1 · free minute</source>
        <translation>Versuchsperson %1 · freie Minute</translation>
    </message>
    <message numerus="yes">
        <source>Free minute: try the controls. Nothing counts yet. %n second(s) left.</source>
        <translation>
            <numerusform>Freie Minute: Probieren Sie die Bedienung aus. Noch zählt nichts. Noch %n Sekunde.</numerusform>
            <numerusform>Freie Minute: Probieren Sie die Bedienung aus. Noch zählt nichts. Noch %n Sekunden.</numerusform>
        </translation>
    </message>
    <message>
        <source>I am ready (Enter)</source>
        <translation>Ich bin bereit (Enter)</translation>
    </message>
    <message>
        <source>Touch the object first.</source>
        <translation>Berühren Sie zuerst das Objekt.</translation>
    </message>
    <message>
        <source>Touch first: %1.</source>
        <translation>Berühren Sie zuerst: %1.</translation>
    </message>
    <message>
        <source>Pilot run</source>
        <translation>Probelauf</translation>
    </message>
    <message>
        <source>The free minute is over</source>
        <translation>Die freie Minute ist vorbei</translation>
    </message>
    <message>
        <source>The masking sound is not heard: this machine has no sound output. Each trial is recorded as not masked. To mask, stop the session, connect headphones or loudspeakers, and resume the run.</source>
        <translation>Das Maskierungsgeräusch ist nicht zu hören: Dieser Rechner hat keine Tonausgabe. Jeder Durchgang wird als nicht maskiert festgehalten. Um zu maskieren, beenden Sie die Sitzung, schließen Sie Kopfhörer oder Lautsprecher an und setzen Sie den Lauf fort.</translation>
    </message>
    <message>
        <source>%1 The participant is now answering the questions about it.</source>
        <translation>%1 Die Person beantwortet jetzt die Fragen dazu.</translation>
    </message>
    <message numerus="yes">
        <source>The free minute ends in %n second(s). Then you say when the trials begin.</source>
        <translation>
            <numerusform>Die freie Minute endet in %n Sekunde. Dann sagen Sie, wann die Durchgänge beginnen.</numerusform>
            <numerusform>Die freie Minute endet in %n Sekunden. Dann sagen Sie, wann die Durchgänge beginnen.</numerusform>
        </translation>
    </message>
    <message>
        <source>What you tried does not count. Practice trials come next, and they do not count either; after them every answer counts. Press Continue when you are ready.</source>
        <translation>Was Sie ausprobiert haben, zählt nicht. Als Nächstes kommen Übungsdurchgänge, auch sie zählen nicht; danach zählt jede Antwort. Drücken Sie „Weiter“, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>You moved too fast. Move more slowly.</source>
        <translation>Sie haben sich zu schnell bewegt. Bewegen Sie sich langsamer.</translation>
    </message>
    <message>
        <source>You pulled too hard. Pull more gently.</source>
        <translation>Sie haben zu stark gezogen. Ziehen Sie sanfter.</translation>
    </message>
    <message>
        <source>You pressed too hard. Press more gently.</source>
        <translation>Sie haben zu stark gedrückt. Drücken Sie sanfter.</translation>
    </message>
    <message>
        <source>The next part</source>
        <translation>Der nächste Teil</translation>
    </message>
    <message>
        <source>Read the whole instruction again</source>
        <translation>Die ganze Anleitung noch einmal lesen</translation>
    </message>
    <message>
        <source>The pilot run is over</source>
        <translation>Der Probelauf ist vorbei</translation>
    </message>
    <message>
        <source>What was tried does not count as data of the study.</source>
        <translation>Was ausprobiert wurde, gehört nicht zu den Daten der Studie.</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Durchgang %1</translation>
    </message>
    <message>
        <source>Trial %1 of %2</source>
        <translation>Durchgang %1 von %2</translation>
    </message>
    <message>
        <source>Trial %1 of at most %2</source>
        <translation>Durchgang %1 von höchstens %2</translation>
    </message>
    <message>
        <source>Practice: nothing counts yet.</source>
        <translation>Übung: Noch zählt nichts.</translation>
    </message>
    <message>
        <source>Pull a little harder: at least %1 N.</source>
        <translation>Ziehen Sie etwas fester: mindestens %1 N.</translation>
    </message>
    <message>
        <source>Press a little harder: at least %1 N.</source>
        <translation>Drücken Sie etwas fester: mindestens %1 N.</translation>
    </message>
    <message>
        <source>Pull a little harder on %1: at least %2 N.</source>
        <translation>Ziehen Sie etwas fester an %1: mindestens %2 N.</translation>
    </message>
    <message>
        <source>Press a little harder on %1: at least %2 N.</source>
        <translation>Drücken Sie etwas fester auf %1: mindestens %2 N.</translation>
    </message>
    <message>
        <source>Practice is over</source>
        <translation>Die Übung ist vorbei</translation>
    </message>
    <message>
        <source>Continue (Enter)</source>
        <translation>Weiter (Enter)</translation>
    </message>
    <message>
        <source>Stop … (Esc twice)</source>
        <translation>Beenden … (Esc zweimal)</translation>
    </message>
    <message>
        <source>It comes again later.</source>
        <translation>Er kommt später noch einmal.</translation>
    </message>
    <message>
        <source>The same objects come again.</source>
        <translation>Dieselben Objekte kommen noch einmal.</translation>
    </message>
    <message>
        <source>No answer came in time.</source>
        <translation>Es kam keine Antwort rechtzeitig.</translation>
    </message>
    <message>
        <source>The last trial did not count. %1 %2</source>
        <translation>Der letzte Durchgang zählte nicht. %1 %2</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Press R to go on, or Esc to stop the session.</source>
        <translation>Die Uhr steht und alles Bisherige bleibt erhalten. Drücken Sie R, um weiterzumachen, oder Esc, um die Sitzung zu beenden.</translation>
    </message>
    <message>
        <source>Here a participant explores objects and answers.</source>
        <translation>Hier erkundet eine Versuchsperson Objekte und antwortet.</translation>
    </message>
    <message>
        <source>In practice, Backspace takes an answer back.</source>
        <translation>In der Übung nimmt die Rücktaste eine Antwort zurück.</translation>
    </message>
    <message>
        <source>F2 is for the experimenter.</source>
        <translation>F2 ist für die Versuchsleitung.</translation>
    </message>
    <message>
        <source>What was tried in a pilot run does not count as data of the study, and a stopped pilot run is not continued.</source>
        <translation>Was in einem Probelauf ausprobiert wurde, gehört nicht zu den Daten der Studie, und ein vorzeitig beendeter Probelauf wird nicht fortgesetzt.</translation>
    </message>
    <message>
        <source>Stop this pilot run?</source>
        <translation>Diesen Probelauf beenden?</translation>
    </message>
    <message>
        <source>The pilot run reached its end.</source>
        <translation>Der Probelauf ist bis zum Ende gelaufen.</translation>
    </message>
    <message>
        <source>The session ended by itself before all trials were done, and nothing more was presented. Check the device before you go on.</source>
        <translation>Die Sitzung endete von selbst, bevor alle Durchgänge erledigt waren, und es wurde nichts mehr dargeboten. Prüfen Sie das Gerät, bevor Sie weitermachen.</translation>
    </message>
    <message>
        <source>%1. From now on every answer counts.</source>
        <translation>%1. Ab jetzt zählt jede Antwort.</translation>
    </message>
    <message>
        <source>You let go of the object. Raise the tool.</source>
        <translation>Sie haben das Objekt losgelassen. Heben Sie das Instrument.</translation>
    </message>
    <message>
        <source>You let go of object %1. Raise the tool.</source>
        <translation>Sie haben Objekt %1 losgelassen. Heben Sie das Instrument.</translation>
    </message>
    <message>
        <source>Touch next: %1.</source>
        <translation>Berühren Sie als Nächstes: %1.</translation>
    </message>
    <message>
        <source>Find the highest point, and mark it.</source>
        <translation>Finden Sie den höchsten Punkt und markieren Sie ihn.</translation>
    </message>
    <message>
        <source>Find the sphere first.</source>
        <translation>Finden Sie zuerst die Kugel.</translation>
    </message>
    <message>
        <source>Move the tool with the device, or with the mouse; with the mouse, raise and lower it with the wheel or Page Up and Page Down. T frees the pointer, and a click in the scene captures it again and does not count as an answer. Answer with the buttons or with the keys shown on them, as soon as they are enabled.</source>
        <translation>Bewegen Sie das Instrument mit dem Gerät oder mit der Maus; mit der Maus heben und senken Sie es mit dem Rad oder mit Bild auf und Bild ab. T gibt den Zeiger frei, ein Klick in die Szene fängt ihn wieder ein und zählt nicht als Antwort. Antworten Sie mit den Schaltflächen oder mit den Tasten, die darauf stehen, sobald sie verfügbar sind.</translation>
    </message>
    <message>
        <source>What you do may differ from the previous part: the next page shows the question and how you answer it.</source>
        <translation>Was Sie tun, kann anders sein als im vorigen Teil: Die nächste Seite zeigt die Frage und wie Sie sie beantworten.</translation>
    </message>
    <message>
        <source>Apart from this, you explore and answer as in the previous part.</source>
        <translation>Sonst erkunden und antworten Sie wie im vorigen Teil.</translation>
    </message>
    <message>
        <source>You explore and answer as in the previous part, unless the experimenter tells you otherwise.</source>
        <translation>Sie erkunden und antworten wie im vorigen Teil, außer die Versuchsleitung sagt Ihnen etwas anderes.</translation>
    </message>
    <message>
        <source>The number of trials may differ.</source>
        <translation>Die Zahl der Durchgänge kann anders sein.</translation>
    </message>
    <message numerus="yes">
        <source>First come %n practice trial(s), which do not count.</source>
        <translation>
            <numerusform>Am Anfang steht %n Übungsdurchgang, der nicht zählt.</numerusform>
            <numerusform>Am Anfang stehen %n Übungsdurchgänge, die nicht zählen.</numerusform>
        </translation>
    </message>
    <message>
        <source>The answer was not accepted. Please answer again, and call the experimenter if this happens once more.</source>
        <translation>Die Antwort wurde nicht angenommen. Bitte antworten Sie noch einmal, und rufen Sie die Versuchsleitung, falls es wieder geschieht.</translation>
    </message>
    <message>
        <source>The participant&apos;s screen is no longer connected. The session is paused, and everything so far is kept. The participant&apos;s page is in this window now.</source>
        <translation>Der Bildschirm der Versuchsperson ist nicht mehr angeschlossen. Die Sitzung ist pausiert, und alles Bisherige ist gespeichert. Die Seite der Versuchsperson ist jetzt in diesem Fenster.</translation>
    </message>
    <message>
        <source>The experimenter discarded it.</source>
        <translation>Die Versuchsleitung hat ihn verworfen.</translation>
    </message>
    <message>
        <source>The device did not work accurately enough. This was not your fault.</source>
        <translation>Das Gerät arbeitete dabei nicht genau genug. Das lag nicht an Ihnen.</translation>
    </message>
    <message>
        <source>You will answer here once the trials begin.</source>
        <translation>Hier antworten Sie, sobald die Durchgänge beginnen.</translation>
    </message>
    <message>
        <source>Hold still for a moment, then you can go on.</source>
        <translation>Halten Sie einen Moment still, dann geht es weiter.</translation>
    </message>
    <message>
        <source>Please call the experimenter</source>
        <translation>Bitte rufen Sie die Versuchsleitung</translation>
    </message>
    <message>
        <source>Go on (R)</source>
        <translation>Weiter (R)</translation>
    </message>
    <message>
        <source>The clock is stopped and everything so far is kept. Press Continue to go on.</source>
        <translation>Die Uhr steht, und alles Bisherige bleibt erhalten. Drücken Sie „Weiter“, um weiterzumachen.</translation>
    </message>
    <message>
        <source>Back to the study</source>
        <translation>Zurück zur Studie</translation>
    </message>
    <message>
        <source>Back to the participant&apos;s conditions</source>
        <translation>Zurück zu den Bedingungen der Versuchsperson</translation>
    </message>
    <message>
        <source>Back to the participant&apos;s page (F2)</source>
        <translation>Zurück zur Seite der Versuchsperson (F2)</translation>
    </message>
    <message>
        <source>The participant&apos;s screen is no longer connected. The participant&apos;s page is in this window now.</source>
        <translation>Der Bildschirm der Versuchsperson ist nicht mehr angeschlossen. Die Seite der Versuchsperson ist jetzt in diesem Fenster.</translation>
    </message>
    <message>
        <source>The session is paused. Enter your password to see the experimenter&apos;s view.</source>
        <translation>Die Sitzung ist pausiert. Geben Sie Ihr Passwort ein, um die Ansicht der Versuchsleitung zu sehen.</translation>
    </message>
    <message>
        <source>The session is over. Enter your password to go on with the study.</source>
        <translation>Die Sitzung ist beendet. Geben Sie Ihr Passwort ein, um mit der Studie fortzufahren.</translation>
    </message>
    <message>
        <source>The session was stopped</source>
        <translation>Die Sitzung wurde vorzeitig beendet</translation>
    </message>
    <message>
        <source>This part is not finished; your answers so far are kept. Please call the experimenter, who decides when it goes on.</source>
        <translation>Dieser Teil ist nicht abgeschlossen; Ihre bisherigen Antworten sind gespeichert. Bitte rufen Sie die Versuchsleitung, die entscheidet, wann es weitergeht.</translation>
    </message>
    <message>
        <source>This part is finished</source>
        <translation>Dieser Teil ist abgeschlossen</translation>
    </message>
    <message numerus="yes">
        <source>Thank you. %n more part(s) follow. Please call the experimenter, who decides when the next one begins.</source>
        <translation>
            <numerusform>Vielen Dank. Es folgt noch %n Teil. Bitte rufen Sie die Versuchsleitung, die entscheidet, wann der nächste beginnt.</numerusform>
            <numerusform>Vielen Dank. Es folgen noch %n Teile. Bitte rufen Sie die Versuchsleitung, die entscheidet, wann der nächste beginnt.</numerusform>
        </translation>
    </message>
    <message>
        <source>All trials are finished</source>
        <translation>Alle Durchgänge sind abgeschlossen</translation>
    </message>
    <message>
        <source>Thank you. Only a few questions about the study are left. Please call the experimenter, who opens them.</source>
        <translation>Vielen Dank. Es folgen nur noch einige Fragen zur Studie. Bitte rufen Sie die Versuchsleitung, die sie öffnet.</translation>
    </message>
    <message>
        <source>Everything is finished</source>
        <translation>Alles ist abgeschlossen</translation>
    </message>
    <message>
        <source>Thank you. Nothing more is left for you to do in this study. Please call the experimenter.</source>
        <translation>Vielen Dank. In dieser Studie ist für Sie nichts mehr zu tun. Bitte rufen Sie die Versuchsleitung.</translation>
    </message>
    <message>
        <source>Practice: this answer does not count. Press Next to go on, or take it back if it was a slip.</source>
        <translation>Übung: Diese Antwort zählt nicht. Drücken Sie „Weiter“, oder nehmen Sie sie zurück, wenn sie ein Versehen war.</translation>
    </message>
    <message>
        <source>You are holding the object.</source>
        <translation>Sie halten das Objekt.</translation>
    </message>
    <message>
        <source>You are holding object %1.</source>
        <translation>Sie halten Objekt %1.</translation>
    </message>
    <message>
        <source>Pull less hard.</source>
        <translation>Ziehen Sie weniger stark.</translation>
    </message>
    <message>
        <source>Press less hard.</source>
        <translation>Drücken Sie weniger stark.</translation>
    </message>
    <message>
        <source>Pull less hard in this trial.</source>
        <translation>Ziehen Sie in diesem Durchgang weniger stark.</translation>
    </message>
    <message>
        <source>Press less hard in this trial.</source>
        <translation>Drücken Sie in diesem Durchgang weniger stark.</translation>
    </message>
    <message>
        <source>All answers given so far are kept. The run is not finished: it can be resumed later at the same trial, also on another day. If it is not resumed, the answers count in the results as far as they suffice for a value.</source>
        <translation>Alle bisherigen Antworten bleiben erhalten. Der Lauf ist nicht abgeschlossen: Er kann später am selben Durchgang fortgesetzt werden, auch an einem anderen Tag. Wird er nicht fortgesetzt, zählen die Antworten in den Ergebnissen, soweit sie für einen Wert ausreichen.</translation>
    </message>
    <message>
        <source>Go on with the trials</source>
        <translation>Mit den Durchgängen weitermachen</translation>
    </message>
    <message>
        <source>Stop the pilot run</source>
        <translation>Probelauf beenden</translation>
    </message>
    <message>
        <source>Stop, and keep the answers</source>
        <translation>Beenden und Antworten behalten</translation>
    </message>
    <message>
        <source>the mark</source>
        <translation>die Markierung</translation>
    </message>
    <message>
        <source>Take back: %1 (⌫)</source>
        <translation>Zurücknehmen: %1 (⌫)</translation>
    </message>
    <message>
        <source>Pull it up: roll the wheel away from you, or hold Page Up.</source>
        <translation>Ziehen Sie es hoch: Drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>Pull it up.</source>
        <translation>Ziehen Sie es hoch.</translation>
    </message>
    <message>
        <source>Press the object less hard onto the table.</source>
        <translation>Drücken Sie das Objekt weniger stark auf den Tisch.</translation>
    </message>
    <message>
        <source>Press the object less hard onto the table in this trial.</source>
        <translation>Drücken Sie das Objekt in diesem Durchgang weniger stark auf den Tisch.</translation>
    </message>
    <message>
        <source>You pressed an object too hard onto the table. Put it down more gently.</source>
        <translation>Sie haben ein Objekt zu stark auf den Tisch gedrückt. Setzen Sie es sanfter ab.</translation>
    </message>
    <message>
        <source>Raise the tool: roll the wheel away from you, or hold Page Up.</source>
        <translation>Heben Sie das Instrument: Drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>Raise the handle.</source>
        <translation>Heben Sie den Griff.</translation>
    </message>
    <message>
        <source>You are pressing the object.</source>
        <translation>Sie drücken auf das Objekt.</translation>
    </message>
    <message>
        <source>You are touching the object. Move the mouse to stroke it.</source>
        <translation>Sie berühren das Objekt. Bewegen Sie die Maus, um darüber zu streichen.</translation>
    </message>
    <message>
        <source>You are touching the object. Move the handle to stroke it.</source>
        <translation>Sie berühren das Objekt. Bewegen Sie den Griff, um darüber zu streichen.</translation>
    </message>
    <message>
        <source>Lift the object first.</source>
        <translation>Heben Sie zuerst das Objekt.</translation>
    </message>
    <message>
        <source>Lift first: %1.</source>
        <translation>Heben Sie zuerst: %1.</translation>
    </message>
    <message>
        <source>Lift next: %1.</source>
        <translation>Heben Sie als Nächstes: %1.</translation>
    </message>
    <message>
        <source>Pull the object first.</source>
        <translation>Ziehen Sie zuerst an dem Objekt.</translation>
    </message>
    <message>
        <source>Pull first: %1.</source>
        <translation>Ziehen Sie zuerst an: %1.</translation>
    </message>
    <message>
        <source>Pull next: %1.</source>
        <translation>Ziehen Sie als Nächstes an: %1.</translation>
    </message>
    <message>
        <source>You can answer now, or explore further.</source>
        <translation>Sie können jetzt antworten oder weiter erkunden.</translation>
    </message>
    <message>
        <source>You can answer now.</source>
        <translation>Sie können jetzt antworten.</translation>
    </message>
    <message>
        <source>You have not let go of an object yet, which you need for the next one.</source>
        <translation>Sie haben noch kein Objekt losgelassen; das brauchen Sie aber für das nächste.</translation>
    </message>
    <message>
        <source>Roll the wheel away from you, or hold Page Up.</source>
        <translation>Drehen Sie das Rad von sich weg oder halten Sie Bild auf.</translation>
    </message>
    <message>
        <source>Roll the wheel towards you, or hold Page Down.</source>
        <translation>Drehen Sie das Rad zu sich hin oder halten Sie Bild ab.</translation>
    </message>
    <message>
        <source>The pointer is free: click in the scene to move the tool with the mouse again.</source>
        <translation>Der Zeiger ist frei: Klicken Sie in die Szene, um das Instrument wieder mit der Maus zu bewegen.</translation>
    </message>
    <message>
        <source>%1 s left</source>
        <translation>noch %1 s</translation>
    </message>
    <message>
        <source>Lower the tool until the force rises: roll the wheel towards you, or hold Page Down.</source>
        <translation>Senken Sie das Instrument, bis die Kraft steigt: Drehen Sie das Rad zu sich hin oder halten Sie Bild ab.</translation>
    </message>
    <message>
        <source>Lower the tip until it meets the sphere.</source>
        <translation>Senken Sie die Spitze, bis sie die Kugel trifft.</translation>
    </message>
    <message>
        <source>The time ended while you were still holding an object: put it down and let go of it to lift the next one.</source>
        <translation>Die Zeit war um, während Sie noch ein Objekt hielten: Setzen Sie es ab und lassen Sie es los, um das nächste zu heben.</translation>
    </message>
    <message>
        <source>The time ended while you were still holding an object: let go of it to explore the next one.</source>
        <translation>Die Zeit war um, während Sie noch ein Objekt hielten: Lassen Sie es los, um das nächste zu erkunden.</translation>
    </message>
    <message>
        <source>The time ended before every object was lifted: one of them was held, but stayed on the table.</source>
        <translation>Die Zeit war um, bevor jedes Objekt gehoben war: Eines wurde gehalten, blieb aber auf dem Tisch.</translation>
    </message>
    <message>
        <source>The time ended before every object was lifted.</source>
        <translation>Die Zeit war um, bevor jedes Objekt gehoben war.</translation>
    </message>
    <message>
        <source>You did not pull every object hard enough in time: at least %1 N.</source>
        <translation>Sie haben nicht an jedem Objekt rechtzeitig fest genug gezogen: mindestens %1 N.</translation>
    </message>
    <message>
        <source>You did not press every object hard enough in time: at least %1 N.</source>
        <translation>Sie haben nicht auf jedes Objekt rechtzeitig fest genug gedrückt: mindestens %1 N.</translation>
    </message>
    <message>
        <source>The time ended before every object was pulled.</source>
        <translation>Die Zeit war um, bevor an jedem Objekt gezogen war.</translation>
    </message>
    <message>
        <source>The time ended before every object was touched.</source>
        <translation>Die Zeit war um, bevor jedes Objekt berührt war.</translation>
    </message>
    <message>
        <source>%1 This practice trial comes again.</source>
        <translation>%1 Dieser Übungsdurchgang kommt noch einmal.</translation>
    </message>
    <message>
        <source>The next objects are coming.</source>
        <translation>Die nächsten Objekte kommen.</translation>
    </message>
    <message>
        <source>These objects come again.</source>
        <translation>Diese Objekte kommen noch einmal.</translation>
    </message>
    <message>
        <source>The next sphere is coming.</source>
        <translation>Die nächste Kugel kommt.</translation>
    </message>
    <message>
        <source>Unlike in practice, the next trial comes by itself after each answer: there is no Next, and no answer can be taken back. Press Continue when you are ready.</source>
        <translation>Anders als beim Üben kommt nach jeder Antwort der nächste Durchgang von selbst: Es gibt kein „Weiter“ dazwischen, und keine Antwort lässt sich zurücknehmen. Drücken Sie „Weiter“, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>The next trial comes by itself after each answer, and no answer can be taken back. Press Continue when you are ready.</source>
        <translation>Nach jeder Antwort kommt der nächste Durchgang von selbst, und keine Antwort lässt sich zurücknehmen. Drücken Sie „Weiter“, wenn Sie bereit sind.</translation>
    </message>
    <message>
        <source>What you tried does not count. From now on every answer counts.</source>
        <translation>Was Sie ausprobiert haben, zählt nicht. Ab jetzt zählt jede Antwort.</translation>
    </message>
    <message>
        <source>Several trials in a row did not count. The last one: %1</source>
        <translation>Mehrere Durchgänge hintereinander zählten nicht. Der letzte: %1</translation>
    </message>
    <message>
        <source>Ask the experimenter to show how an object is explored and let go.</source>
        <translation>Bitten Sie die Versuchsleitung zu zeigen, wie man ein Objekt erkundet und loslässt.</translation>
    </message>
    <message>
        <source>Ask the experimenter to show how an object is explored.</source>
        <translation>Bitten Sie die Versuchsleitung zu zeigen, wie man ein Objekt erkundet.</translation>
    </message>
    <message>
        <source>The experimenter decides how to go on.</source>
        <translation>Die Versuchsleitung entscheidet, wie es weitergeht.</translation>
    </message>
    <message>
        <source>From now on every answer counts.</source>
        <translation>Ab jetzt zählt jede Antwort.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::UnblindDialog</name>
    <message>
        <source>Unblind this study?</source>
        <translation>Diese Studie entblinden?</translation>
    </message>
    <message numerus="yes">
        <source>%n participant(s) are still to come. Whoever conducts their runs will no longer be blind.</source>
        <translation>
            <numerusform>%n Person steht noch aus. Wer deren Läufe leitet, ist dann nicht mehr verblindet.</numerusform>
            <numerusform>%n Personen stehen noch aus. Wer deren Läufe leitet, ist dann nicht mehr verblindet.</numerusform>
        </translation>
    </message>
    <message>
        <source>Reason for unblinding</source>
        <translation>Grund für das Entblinden</translation>
    </message>
    <message>
        <source>Do not name anyone: the reason is stored permanently.</source>
        <translation>Bitte nennen Sie keine Namen: Der Grund bleibt dauerhaft gespeichert.</translation>
    </message>
    <message>
        <source>Unblind</source>
        <translation>Entblinden</translation>
    </message>
    <message>
        <source>The study was not unblinded.
%1</source>
        <translation>Die Studie wurde nicht entblindet.
%1</translation>
    </message>
    <message>
        <source>Everybody will then see the names of the conditions. It is recorded who unblinded the study, when and why. This cannot be undone.</source>
        <translation>Alle sehen dann die Namen der Bedingungen. Festgehalten wird, wer die Studie wann und warum entblindet hat. Das lässt sich nicht rückgängig machen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::VoidSessionDialog</name>
    <message>
        <source>Void a session</source>
        <translation>Sitzung für ungültig erklären</translation>
    </message>
    <message>
        <source>Void session %1 of %2?</source>
        <translation>Sitzung %1 von %2 für ungültig erklären?</translation>
    </message>
    <message>
        <source>For example: the device was not calibrated</source>
        <translation>Zum Beispiel: Das Gerät war nicht kalibriert</translation>
    </message>
    <message>
        <source>Keep it as it is</source>
        <translation>So lassen</translation>
    </message>
    <message>
        <source>Void the session</source>
        <translation>Für ungültig erklären</translation>
    </message>
    <message>
        <source>Reason (the trainee can read it)</source>
        <translation>Begründung (für die lernende Person lesbar)</translation>
    </message>
    <message>
        <source>Count a session again</source>
        <translation>Eine Sitzung wieder gelten lassen</translation>
    </message>
    <message>
        <source>Count session %1 of %2 again?</source>
        <translation>Soll Sitzung %1 von %2 wieder zählen?</translation>
    </message>
    <message>
        <source>The session counts as it did before it was voided: for passing its level and in results. Both decisions are kept with it, each with a name, a time and a reason.</source>
        <translation>Die Sitzung zählt wieder wie vor der Ungültigerklärung: für das Bestehen ihrer Stufe und in den Ergebnissen. Beide Entscheidungen bleiben bei ihr gespeichert, jede mit Namen, Zeit und Grund.</translation>
    </message>
    <message>
        <source>For example: another session was meant</source>
        <translation>Zum Beispiel: eine andere Sitzung war gemeint</translation>
    </message>
    <message>
        <source>Leave it void</source>
        <translation>Ungültig lassen</translation>
    </message>
    <message>
        <source>Count it again</source>
        <translation>Wieder zählen</translation>
    </message>
    <message>
        <source>Recording, scores and comments stay and can still be viewed. The session no longer counts for anything: neither for passing a level nor in anybody&apos;s results. Your name and the reason are stored with it. If it was a mistake, the session can be counted again, with a reason of its own.</source>
        <translation>Aufzeichnung, Wertungen und Kommentare bleiben erhalten und können weiter angesehen werden. Die Sitzung zählt für nichts mehr: weder für das Bestehen einer Stufe noch in den Ergebnissen. Ihr Name und der Grund werden mit ihr gespeichert. War es ein Versehen, kann man die Sitzung mit einem eigenen Grund wieder gelten lassen.</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::WithdrawDialog</name>
    <message>
        <source>Withdraw %1</source>
        <translation>Teilnahme von %1 zurückziehen</translation>
    </message>
    <message>
        <source>The participant wants the recordings erased</source>
        <translation>Die Person möchte, dass die Aufzeichnungen gelöscht werden</translation>
    </message>
    <message>
        <source>This cannot be undone.</source>
        <translation>Das lässt sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>The participant was not withdrawn.
%1</source>
        <translation>Die Teilnahme wurde nicht zurückgezogen.
%1</translation>
    </message>
    <message>
        <source>%1 no longer takes part.</source>
        <translation>%1 nimmt nicht mehr teil.</translation>
    </message>
    <message>
        <source>The request is recorded, and administrators are told of it. One of them then erases the recordings (People, Erase a participant).</source>
        <translation>Der Wunsch wird festgehalten und der Administration gemeldet, die dann die Aufzeichnungen löscht (Personen, Teilnehmer/in löschen).</translation>
    </message>
    <message>
        <source>Withdraw %1 only if they leave the study for good. If they merely stopped for today, do not withdraw them: an interrupted run is resumed under Run.</source>
        <translation>Ziehen Sie die Teilnahme von %1 nur zurück, wenn die Person die Studie endgültig verlässt. Hat sie nur für heute aufgehört, tun Sie es nicht: Ein unterbrochener Lauf wird unter „Durchführen“ fortgesetzt.</translation>
    </message>
    <message>
        <source>What is kept: everything that was recorded, under the code. Nothing is erased, unless the participant wants it (below).</source>
        <translation>Was erhalten bleibt: alles, was aufgezeichnet wurde, unter dem Code. Nichts wird gelöscht, es sei denn, die Person wünscht es (unten).</translation>
    </message>
    <message>
        <source>What no longer counts: this participant&apos;s answers, also those of finished runs. They are left out of group values and comparisons.</source>
        <translation>Was nicht mehr zählt: die Antworten dieser Person, auch die abgeschlossener Läufe. Sie gehen in Gruppenwerte und Vergleiche nicht ein.</translation>
    </message>
    <message>
        <source>What ends: an open run cannot be resumed, and no other can be started. The place in the order of conditions is free for the next participant.</source>
        <translation>Was endet: Ein offener Lauf kann nicht fortgesetzt und kein weiterer begonnen werden. Der Platz in der Reihenfolge der Bedingungen wird für die nächste Person frei.</translation>
    </message>
    <message>
        <source>Do not withdraw</source>
        <translation>Nicht zurückziehen</translation>
    </message>
</context>
<context>
    <name>chiron::desktop::WorkspaceBox</name>
    <message>
        <source>Hand and workspace</source>
        <translation>Hand und Arbeitsraum</translation>
    </message>
    <message>
        <source>Tool movement per hand movement</source>
        <translation>Bewegung des Instruments je Handbewegung</translation>
    </message>
    <message>
        <source>Shift to the right</source>
        <translation>Verschiebung nach rechts</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Shift away from you</source>
        <translation>Verschiebung von Ihnen weg</translation>
    </message>
    <message>
        <source>Shift up</source>
        <translation>Verschiebung nach oben</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>Rechte Hand</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Rotation of the device base to the left</source>
        <translation>Drehung der Gerätebasis nach links</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Tilt of the base away from you</source>
        <translation>Neigung der Basis von Ihnen weg</translation>
    </message>
    <message>
        <source>Tilt of the base to the right</source>
        <translation>Neigung der Basis nach rechts</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatCanvas</name>
    <message>
        <source>Operating field from above and from the side</source>
        <translation>Arbeitsfeld von oben und von der Seite</translation>
    </message>
    <message>
        <source>From above</source>
        <translation>Von oben</translation>
    </message>
    <message>
        <source>From the side</source>
        <translation>Von der Seite</translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation>x (mm)</translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation>y (mm)</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatComparison</name>
    <message>
        <source>Objects side by side and instrument, from above and from the side</source>
        <translation>Objekte nebeneinander und Instrument, von oben und von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatFingers</name>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatHandling</name>
    <message>
        <source>Objects, target and instrument, from above and from the side</source>
        <translation>Objekte, Ziel und Instrument, von oben und von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatPalpation</name>
    <message>
        <source>Contour lines every %1 mm</source>
        <translation>Höhenlinien alle %1 mm</translation>
    </message>
    <message>
        <source>Tissue, fingers and findings, from above and from the side</source>
        <translation>Gewebe, Finger und Funde, von oben und von der Seite</translation>
    </message>
    <message>
        <source>Lines: %1 mm</source>
        <translation>Linien: %1 mm</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatTube</name>
    <message>
        <source>Elastic tube and instruments, from above and from the side</source>
        <translation>Elastischer Schlauch und Instrumente, von oben und von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::FlatUrethra</name>
    <message>
        <source>The endoscope&apos;s picture, and the canal from the side</source>
        <translation>Das Bild des Endoskops und der Kanal von der Seite</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::ForceGauge</name>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::MapLegend</name>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Searched</source>
        <translation>Abgetastet</translation>
    </message>
    <message>
        <source>%1 – %2 N</source>
        <translation>%1 – %2 N</translation>
    </message>
    <message>
        <source>≥ %1 N</source>
        <translation>≥ %1 N</translation>
    </message>
    <message>
        <source>under %1 N</source>
        <translation>unter %1 N</translation>
    </message>
    <message>
        <source>over %1 N</source>
        <translation>über %1 N</translation>
    </message>
    <message>
        <source>%1 (band)</source>
        <translation>%1 (Band)</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>nicht berührt</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::NoticePainter</name>
    <message>
        <source>The endoscope&apos;s picture is off at this level.</source>
        <translation>Das Bild des Endoskops ist auf dieser Stufe ausgeschaltet.</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::Qt3DSceneView</name>
    <message>
        <source>Operating field in three dimensions</source>
        <translation>Arbeitsfeld in drei Dimensionen</translation>
    </message>
</context>
<context>
    <name>chiron::scene3d::SceneLoader</name>
    <message>
        <source>Shown in 2D: 3D is switched off on this station.</source>
        <translation>2D-Darstellung: 3D ist an diesem Arbeitsplatz ausgeschaltet.</translation>
    </message>
    <message>
        <source>Shown in 2D: OpenGL is not available here.</source>
        <translation>2D-Darstellung: OpenGL ist hier nicht verfügbar.</translation>
    </message>
    <message>
        <source>Shown in 2D: the 3D part of Chiron is not installed.</source>
        <translation>2D-Darstellung: Der 3D-Teil von Chiron ist nicht installiert.</translation>
    </message>
    <message>
        <source>Shown in 2D: the 3D part of Chiron could not be loaded (%1).</source>
        <translation>2D-Darstellung: Der 3D-Teil von Chiron konnte nicht geladen werden (%1).</translation>
    </message>
    <message>
        <source>Shown in 2D: the 3D part belongs to another version of Chiron. Reinstall Chiron to fix this.</source>
        <translation>2D-Darstellung: Der 3D-Teil gehört zu einer anderen Version von Chiron. Installieren Sie Chiron neu, um das zu beheben.</translation>
    </message>
    <message>
        <source>Shown in 2D: this exercise has no 3D scene.</source>
        <translation>2D-Darstellung: Diese Übung hat keine 3D-Szene.</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>no pass mark</source>
        <translation>keine Bestehensgrenze</translation>
    </message>
    <message>
        <source>pass mark %1</source>
        <translation>Bestehensgrenze %1</translation>
    </message>
    <message>
        <source>✓ met: %1</source>
        <translation>✓ erreicht: %1</translation>
    </message>
    <message>
        <source>✗ not met: %1</source>
        <translation>✗ nicht erreicht: %1</translation>
    </message>
    <message>
        <source>Benchmark %1</source>
        <translation>Referenz %1</translation>
    </message>
    <message>
        <source>Benchmark %1, %2</source>
        <translation>Referenz %1, %2</translation>
    </message>
    <message>
        <source>DEMONSTRATION: invented people and results, not for assessment</source>
        <translation>DEMO: erfundene Personen und Ergebnisse, nicht zur Beurteilung</translation>
    </message>
    <message>
        <source>SIMULATED OPERATOR: a scripted hand, not a person</source>
        <translation>SIMULIERTE HAND: vom Programm geführt, keine Person</translation>
    </message>
    <message>
        <source>Unnamed person</source>
        <translation>Person ohne Namen</translation>
    </message>
    <message>
        <source>%1 · level %2: %3</source>
        <translation>%1 · Stufe %2: %3</translation>
    </message>
    <message>
        <source>–  No pass mark is set for this level</source>
        <translation>–  Für diese Stufe ist keine Bestehensgrenze festgelegt</translation>
    </message>
    <message>
        <source>!  Does not count: %1</source>
        <translation>!  Zählt nicht: %1</translation>
    </message>
    <message>
        <source>its state is not known</source>
        <translation>ihr Zustand ist nicht bekannt</translation>
    </message>
    <message>
        <source>✓  Passed: every pass mark was met</source>
        <translation>✓  Bestanden: Jede Bestehensgrenze wurde erreicht</translation>
    </message>
    <message>
        <source>✗  Not passed</source>
        <translation>✗  Nicht bestanden</translation>
    </message>
    <message>
        <source>%1 has no value (%2), pass mark %3</source>
        <translation>%1 hat keinen Wert (%2), Bestehensgrenze %3</translation>
    </message>
    <message>
        <source>%1: %2, pass mark %3</source>
        <translation>%1: %2, Bestehensgrenze %3</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>Kraft</translation>
    </message>
    <message>
        <source>felt</source>
        <translation>gefühlt</translation>
    </message>
    <message>
        <source>shown, not felt</source>
        <translation>gezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>All metrics</source>
        <translation>Alle Messgrößen</translation>
    </message>
    <message>
        <source>not defined</source>
        <translation>nicht definiert</translation>
    </message>
    <message>
        <source>✓ met</source>
        <translation>✓ erreicht</translation>
    </message>
    <message>
        <source>✗ not met</source>
        <translation>✗ nicht erreicht</translation>
    </message>
    <message>
        <source>No metrics were computed</source>
        <translation>Es wurden keine Messgrößen berechnet</translation>
    </message>
    <message>
        <source>Metric</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>Pass mark</source>
        <translation>Bestehensgrenze</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Error in locating the apex</source>
        <translation>Scheitelfehler</translation>
    </message>
    <message>
        <source>The session over time</source>
        <translation>Die Sitzung im Zeitverlauf</translation>
    </message>
    <message>
        <source>Where these numbers come from</source>
        <translation>Woher diese Zahlen stammen</translation>
    </message>
    <message>
        <source>Recorded samples</source>
        <translation>Aufgezeichnete Messpunkte</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Verlorene Messpunkte</translation>
    </message>
    <message>
        <source>Stored bytes</source>
        <translation>Gespeicherte Bytes</translation>
    </message>
    <message>
        <source>Lateness: median, 99th percentile</source>
        <translation>Verspätung: Median, 99. Perzentil</translation>
    </message>
    <message>
        <source>ran as fast as the computer could</source>
        <translation>lief so schnell wie möglich</translation>
    </message>
    <message>
        <source>Maximum lateness</source>
        <translation>Größte Verspätung</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Programmstand</translation>
    </message>
    <message>
        <source>Content (SHA-256)</source>
        <translation>Inhalt (SHA-256)</translation>
    </message>
    <message>
        <source>Recording (BLAKE2b)</source>
        <translation>Aufzeichnung (BLAKE2b)</translation>
    </message>
    <message>
        <source>Score (BLAKE2b)</source>
        <translation>Wertung (BLAKE2b)</translation>
    </message>
    <message>
        <source>completed</source>
        <translation>abgeschlossen</translation>
    </message>
    <message>
        <source>stopped by the person</source>
        <translation>von der Person abgebrochen</translation>
    </message>
    <message>
        <source>interrupted: the program ended during the session</source>
        <translation>unterbrochen: Das Programm endete während der Sitzung</translation>
    </message>
    <message>
        <source>incomplete: samples were lost</source>
        <translation>unvollständig: Messpunkte gingen verloren</translation>
    </message>
    <message>
        <source>faulted: the device or supervisor stopped it</source>
        <translation>gestört: von Gerät oder Sicherheitsüberwachung gestoppt</translation>
    </message>
    <message>
        <source>voided by a trainer</source>
        <translation>durch Ausbilder/in für ungültig erklärt</translation>
    </message>
    <message>
        <source>Session report</source>
        <translation>Sitzungsbericht</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>Demonstration</source>
        <translation>Demo</translation>
    </message>
    <message>
        <source>no recording digest</source>
        <translation>keine Prüfsumme der Aufzeichnung</translation>
    </message>
    <message>
        <source>Time (s)</source>
        <translation>Zeit (s)</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>No samples were recorded</source>
        <translation>Es wurden keine Messpunkte aufgezeichnet</translation>
    </message>
    <message>
        <source>Position of the tool tip</source>
        <translation>Position der Instrumentenspitze</translation>
    </message>
    <message>
        <source>Position (mm)</source>
        <translation>Position (mm)</translation>
    </message>
    <message>
        <source>Force on the tool</source>
        <translation>Kraft am Instrument</translation>
    </message>
    <message>
        <source>Force (N)</source>
        <translation>Kraft (N)</translation>
    </message>
    <message>
        <source>over the limit</source>
        <translation>über der Grenze</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>gemessen</translation>
    </message>
    <message>
        <source>tissue (assessed)</source>
        <translation>Gewebe (gewertet)</translation>
    </message>
    <message>
        <source>limit %1</source>
        <translation>Grenze %1</translation>
    </message>
    <message>
        <source>Speed of the tool tip</source>
        <translation>Geschwindigkeit der Instrumentenspitze</translation>
    </message>
    <message>
        <source>Speed (mm/s)</source>
        <translation>Geschwindigkeit (mm/s)</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Where the marks lie on the sphere</source>
        <translation>Lage der Markierungen auf der Kugel</translation>
    </message>
    <message>
        <source>Error in x (% of radius)</source>
        <translation>Fehler in x (% des Radius)</translation>
    </message>
    <message>
        <source>Error in y (% of radius)</source>
        <translation>Fehler in y (% des Radius)</translation>
    </message>
    <message>
        <source>outline</source>
        <translation>Umriss</translation>
    </message>
    <message>
        <source>mark</source>
        <translation>Markierung</translation>
    </message>
    <message>
        <source>miss</source>
        <translation>Fehlversuch</translation>
    </message>
    <message>
        <source>no mark: time was up</source>
        <translation>keine Markierung: Zeit war um</translation>
    </message>
    <message>
        <source>No trial was marked</source>
        <translation>Kein Durchgang wurde markiert</translation>
    </message>
    <message>
        <source>Error in locating virtual spheres (%)</source>
        <translation>Fehler beim Lokalisieren virtueller Kugeln (%)</translation>
    </message>
    <message>
        <source>Trial</source>
        <translation>Durchgang</translation>
    </message>
    <message>
        <source>Error (% of radius)</source>
        <translation>Fehler (% des Radius)</translation>
    </message>
    <message>
        <source>session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>mean ± SD</source>
        <translation>Mittelwert ± SD</translation>
    </message>
    <message>
        <source>No sessions to compare</source>
        <translation>Keine Sitzungen zum Vergleichen</translation>
    </message>
    <message>
        <source>Off-centre and alignment over depth</source>
        <translation>Auslenkung und Ausrichtung über der Tiefe</translation>
    </message>
    <message>
        <source>Landmarks of the bladder seen</source>
        <translation>Gesehene Landmarken der Blase</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Distance from the middle of the canal</source>
        <translation>Auslenkung von der Mittellinie</translation>
    </message>
    <message>
        <source>Off-centre (mm)</source>
        <translation>Auslenkung (mm)</translation>
    </message>
    <message>
        <source>off-centre</source>
        <translation>Auslenkung</translation>
    </message>
    <message>
        <source>Angle between endoscope and canal</source>
        <translation>Winkel zwischen Endoskop und Kanal</translation>
    </message>
    <message>
        <source>Alignment (°)</source>
        <translation>Ausrichtung (°)</translation>
    </message>
    <message>
        <source>alignment</source>
        <translation>Ausrichtung</translation>
    </message>
    <message>
        <source>Depth (mm)</source>
        <translation>Tiefe (mm)</translation>
    </message>
    <message>
        <source>in</source>
        <translation>Einführen</translation>
    </message>
    <message>
        <source>out</source>
        <translation>Rückzug</translation>
    </message>
    <message>
        <source>bend</source>
        <translation>Biegung</translation>
    </message>
    <message>
        <source>bladder neck</source>
        <translation>Blasenhals</translation>
    </message>
    <message>
        <source>The endoscope did not enter</source>
        <translation>Das Endoskop wurde nicht eingeführt</translation>
    </message>
    <message>
        <source>Off-centre, largest in each millimetre</source>
        <translation>Auslenkung, größte je Millimeter</translation>
    </message>
    <message>
        <source>Alignment, largest in each millimetre</source>
        <translation>Ausrichtung, größter Winkel je Millimeter</translation>
    </message>
    <message>
        <source>Largest force at each place</source>
        <translation>Größte Kraft an jeder Stelle</translation>
    </message>
    <message>
        <source>Coverage: %1 % searched</source>
        <translation>Abdeckung: %1 % abgetastet</translation>
    </message>
    <message>
        <source>Lumps found: %1 of %2</source>
        <translation>Gefundene Knoten: %1 von %2</translation>
    </message>
    <message>
        <source>Findings reported: %1</source>
        <translation>Gemeldete Funde: %1</translation>
    </message>
    <message>
        <source>False alarms: %1</source>
        <translation>Fehlalarme: %1</translation>
    </message>
    <message>
        <source>not touched</source>
        <translation>nicht berührt</translation>
    </message>
    <message>
        <source>under %1 N: not searched</source>
        <translation>unter %1 N: nicht abgetastet</translation>
    </message>
    <message>
        <source>%1 N or more: searched</source>
        <translation>ab %1 N: abgetastet</translation>
    </message>
    <message>
        <source>%1 to %2 N: below the band</source>
        <translation>%1 bis %2 N: unter dem Bereich</translation>
    </message>
    <message>
        <source>%1 to %2 N: in the band</source>
        <translation>%1 bis %2 N: im Bereich</translation>
    </message>
    <message>
        <source>%1 to %2 N: above the band</source>
        <translation>%1 bis %2 N: über dem Bereich</translation>
    </message>
    <message>
        <source>over %1 N: too hard</source>
        <translation>über %1 N: zu fest</translation>
    </message>
    <message>
        <source>lump, found (to scale)</source>
        <translation>Knoten, gefunden (maßstäblich)</translation>
    </message>
    <message>
        <source>lump, missed (to scale)</source>
        <translation>Knoten, übersehen (maßstäblich)</translation>
    </message>
    <message>
        <source>finding</source>
        <translation>Fund</translation>
    </message>
    <message>
        <source>finding: hit</source>
        <translation>Fund: Treffer</translation>
    </message>
    <message>
        <source>finding: false alarm</source>
        <translation>Fund: Fehlalarm</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>near side</source>
        <translation>vordere Seite</translation>
    </message>
    <message>
        <source>✓ hit</source>
        <translation>✓ Treffer</translation>
    </message>
    <message>
        <source>✗ false alarm</source>
        <translation>✗ Fehlalarm</translation>
    </message>
    <message>
        <source>✗ missed lump</source>
        <translation>✗ übersehener Knoten</translation>
    </message>
    <message>
        <source>too few regions: %1 with a lump, %2 without</source>
        <translation>zu wenige Felder: %1 mit Knoten, %2 ohne</translation>
    </message>
    <message>
        <source>%1 (95 %: %2 to %3)</source>
        <translation>%1 (95 %: %2 bis %3)</translation>
    </message>
    <message>
        <source>What was found</source>
        <translation>Was gefunden wurde</translation>
    </message>
    <message>
        <source>Lumps found</source>
        <translation>Gefundene Knoten</translation>
    </message>
    <message>
        <source>False alarms</source>
        <translation>Fehlalarme</translation>
    </message>
    <message>
        <source>Regions: hits, false alarms</source>
        <translation>Felder: Treffer, Fehlalarme</translation>
    </message>
    <message>
        <source>%1 of %2, %3 of %4</source>
        <translation>%1 von %2, %3 von %4</translation>
    </message>
    <message>
        <source>Sensitivity d′</source>
        <translation>Trennschärfe d′</translation>
    </message>
    <message>
        <source>Criterion c</source>
        <translation>Kriterium c</translation>
    </message>
    <message>
        <source>Nothing was reported, and nothing was there</source>
        <translation>Nichts wurde gemeldet, und nichts war da</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>x, y (mm)</source>
        <translation>x, y (mm)</translation>
    </message>
    <message>
        <source>Radius (mm)</source>
        <translation>Radius (mm)</translation>
    </message>
    <message>
        <source>Hardness</source>
        <translation>Härte</translation>
    </message>
    <message>
        <source>Confidence</source>
        <translation>Sicherheit</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>Ausgang</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>Fehler (mm)</translation>
    </message>
    <message>
        <source>Trial %1, time ran out</source>
        <translation>Durchgang %1, Zeit abgelaufen</translation>
    </message>
    <message>
        <source>Trial %1</source>
        <translation>Durchgang %1</translation>
    </message>
    <message>
        <source>No trial was started</source>
        <translation>Es wurde kein Durchgang begonnen</translation>
    </message>
    <message>
        <source>✓ done</source>
        <translation>✓ fertig</translation>
    </message>
    <message>
        <source>✗ time was up</source>
        <translation>✗ Zeit war um</translation>
    </message>
    <message>
        <source>✗ torn</source>
        <translation>✗ gerissen</translation>
    </message>
    <message>
        <source>✗ no longer possible</source>
        <translation>✗ nicht mehr möglich</translation>
    </message>
    <message>
        <source>not finished</source>
        <translation>nicht beendet</translation>
    </message>
    <message>
        <source>Tension of the tube</source>
        <translation>Spannung des Schlauchs</translation>
    </message>
    <message>
        <source>Tension (N)</source>
        <translation>Spannung (N)</translation>
    </message>
    <message>
        <source>band, from</source>
        <translation>Bereich, ab</translation>
    </message>
    <message>
        <source>band, to</source>
        <translation>Bereich, bis</translation>
    </message>
    <message>
        <source>tension</source>
        <translation>Spannung</translation>
    </message>
    <message>
        <source>How far the tube was stretched</source>
        <translation>Wie weit der Schlauch gedehnt wurde</translation>
    </message>
    <message>
        <source>Stretch (mm)</source>
        <translation>Dehnung (mm)</translation>
    </message>
    <message>
        <source>mark, from</source>
        <translation>Marke, ab</translation>
    </message>
    <message>
        <source>mark, to</source>
        <translation>Marke, bis</translation>
    </message>
    <message>
        <source>over-stretched</source>
        <translation>überdehnt</translation>
    </message>
    <message>
        <source>stretch</source>
        <translation>Dehnung</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Tension error</source>
        <translation>Fehler der Spannung</translation>
    </message>
    <message>
        <source>In the band</source>
        <translation>Im Bereich</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>Over-stretches</source>
        <translation>Überdehnungen</translation>
    </message>
    <message>
        <source>Drops</source>
        <translation>Fallengelassen</translation>
    </message>
    <message>
        <source>Largest squeeze of each trial</source>
        <translation>Größte Quetschkraft jedes Durchgangs</translation>
    </message>
    <message>
        <source>Squeeze (N)</source>
        <translation>Quetschkraft (N)</translation>
    </message>
    <message>
        <source>squeeze</source>
        <translation>Quetschkraft</translation>
    </message>
    <message>
        <source>Where the objects lay at the end</source>
        <translation>Wo die Objekte am Ende lagen</translation>
    </message>
    <message>
        <source>Offset from target, x (mm)</source>
        <translation>Zielabstand in x (mm)</translation>
    </message>
    <message>
        <source>Offset from target, y (mm)</source>
        <translation>Zielabstand in y (mm)</translation>
    </message>
    <message>
        <source>target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>set down</source>
        <translation>abgelegt</translation>
    </message>
    <message>
        <source>not done</source>
        <translation>nicht fertig</translation>
    </message>
    <message>
        <source>Largest squeeze</source>
        <translation>Größte Quetschkraft</translation>
    </message>
    <message>
        <source>Squeezed too hard</source>
        <translation>Zu fest gequetscht</translation>
    </message>
    <message>
        <source>Target distance</source>
        <translation>Zielabstand</translation>
    </message>
    <message>
        <source>Chosen</source>
        <translation>Gewählt</translation>
    </message>
    <message>
        <source>never held</source>
        <translation>nie gehalten</translation>
    </message>
    <message>
        <source>✓ the heaviest</source>
        <translation>✓ das schwerste</translation>
    </message>
    <message>
        <source>✗ a lighter one</source>
        <translation>✗ ein leichteres</translation>
    </message>
    <message>
        <source>rendered to a scripted hand</source>
        <translation>an eine programmierte Hand ausgegeben</translation>
    </message>
    <message>
        <source>The session was not completed: these values are not compared with pass marks.</source>
        <translation>Die Sitzung wurde nicht abgeschlossen: Diese Werte werden an keiner Bestehensgrenze gemessen.</translation>
    </message>
    <message>
        <source>No trial was completed: there is no score.</source>
        <translation>Kein Durchgang wurde abgeschlossen: Es gibt keine Wertung.</translation>
    </message>
    <message>
        <source>Benchmark, chance</source>
        <translation>Referenz, Zufall</translation>
    </message>
    <message>
        <source>Tension and stretch</source>
        <translation>Spannung und Dehnung</translation>
    </message>
    <message>
        <source>Squeeze and place of each trial</source>
        <translation>Quetschkraft und Lage je Durchgang</translation>
    </message>
    <message>
        <source>Force of the tissue, and what was felt</source>
        <translation>Kraft des Gewebes und was davon gefühlt wurde</translation>
    </message>
    <message>
        <source>Ticks: all, late, skipped</source>
        <translation>Takte: alle, verspätet, ausgefallen</translation>
    </message>
    <message>
        <source>by chance %1</source>
        <translation>durch Zufall %1</translation>
    </message>
    <message>
        <source>The tissue force reached %1. None of it was felt: the force was only shown.</source>
        <translation>Die Gewebekraft erreichte %1. Gefühlt wurde davon nichts: Die Kraft wurde nur gezeigt.</translation>
    </message>
    <message>
        <source>The tissue force reached %1, and all of it was felt.</source>
        <translation>Die Gewebekraft erreichte %1 und wurde vollständig gefühlt.</translation>
    </message>
    <message>
        <source>The tissue force reached %1, but at most %2 of it was felt: the force was limited for %3, first after %4.</source>
        <translation>Die Gewebekraft erreichte %1, davon wurden höchstens %2 gefühlt: Die Kraft war %3 lang begrenzt, zum ersten Mal nach %4.</translation>
    </message>
    <message>
        <source>%1 of the samples lie deeper or farther out than the range in which the force law was checked. Their force is bounded and counts, but it is less certain than the rest.</source>
        <translation>%1 der Messpunkte liegen tiefer oder weiter außen als der Bereich, in dem das Kraftgesetz geprüft ist. Ihre Kraft ist begrenzt und zählt, ist aber weniger sicher als die übrige.</translation>
    </message>
    <message>
        <source>felt (commanded)</source>
        <translation>gefühlt (ausgegeben)</translation>
    </message>
    <message>
        <source>Nothing was touched.</source>
        <translation>Nichts wurde berührt.</translation>
    </message>
    <message>
        <source>Pull on the fold of tissue</source>
        <translation>Zug an der Gewebefalte</translation>
    </message>
    <message>
        <source>Pull (N)</source>
        <translation>Zug (N)</translation>
    </message>
    <message>
        <source>pull</source>
        <translation>Zug</translation>
    </message>
    <message>
        <source>Retraction in the band</source>
        <translation>Zug der Falte im Zielbereich</translation>
    </message>
    <message>
        <source>Critical errors</source>
        <translation>Kritische Fehler</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Instrument</translation>
    </message>
    <message>
        <source>What happened</source>
        <translation>Was geschah</translation>
    </message>
    <message>
        <source>critical error</source>
        <translation>kritischer Fehler</translation>
    </message>
    <message>
        <source>Position of the tool tips, x</source>
        <translation>Position der Instrumentenspitzen, x</translation>
    </message>
    <message>
        <source>Position of the tool tips, y</source>
        <translation>Position der Instrumentenspitzen, y</translation>
    </message>
    <message>
        <source>Position of the tool tips, z</source>
        <translation>Position der Instrumentenspitzen, z</translation>
    </message>
    <message>
        <source>Force of the tissue on each tool (assessed)</source>
        <translation>Kraft des Gewebes auf jedes Instrument (gewertet)</translation>
    </message>
    <message>
        <source>Force felt (commanded) on each tool</source>
        <translation>Gefühlte (ausgegebene) Kraft an jedem Instrument</translation>
    </message>
    <message>
        <source>Force measured on each tool</source>
        <translation>Gemessene Kraft an jedem Instrument</translation>
    </message>
    <message>
        <source>Speed of the tool tips</source>
        <translation>Geschwindigkeit der Instrumentenspitzen</translation>
    </message>
    <message>
        <source>No trial was finished</source>
        <translation>Kein Durchgang wurde beendet</translation>
    </message>
    <message>
        <source>Content without texts (SHA-256)</source>
        <translation>Inhalt ohne Texte (SHA-256)</translation>
    </message>
</context>
</TS>
